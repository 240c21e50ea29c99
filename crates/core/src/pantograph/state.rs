//! State of a [`Pantograph`] during a run, and its part of a step.

use crate::error::CoreError;
use crate::linalg::dense;
use crate::linalg::small::{inner, matrix_vector};
use crate::pantograph::actuator::ActuatorState;
use crate::pantograph::breakpoint::{BalanceInstant, Branch, Breakpoint};
use crate::pantograph::bump_stop::check_independent;
use crate::pantograph::equilibrium;
use crate::pantograph::excitation::{ExcitationNow, ExcitationState};
use crate::pantograph::external::ExternalState;
use crate::pantograph::model::Pantograph;
use crate::pantograph::piecewise_force::{PiecewiseForceState, add_slopes, check_steps};
use crate::scheme::Coefficients;

/// State of a pantograph, and its matrices for a step length.
#[derive(Debug, Clone)]
pub struct PantographState {
    /// Description, with the steepest slopes of its tables in K and C.
    pub model: Pantograph,
    /// Inverse of the matrix A of the scheme.
    inverse: Vec<f64>,
    /// Constant preload p, N.
    pub preload: f64,
    /// Displacement, m.
    pub u: Vec<f64>,
    /// Velocity, m/s.
    pub v: Vec<f64>,
    /// Acceleration, m/s².
    pub a: Vec<f64>,
    /// Increment of the current step, m: without, later with constraint forces.
    pub delta: Vec<f64>,
    /// Breakpoints of the stops, then those of the piecewise linear forces.
    pub(crate) breakpoints: Vec<Breakpoint>,
    pub(crate) piecewise_forces: Vec<PiecewiseForceState>,
    pub(crate) actuator: ActuatorState,
    pub(crate) excitation: ExcitationState,
    pub(crate) external: ExternalState,
    /// Increment without contact forces and forces of breakpoints, m.
    predicted: Vec<f64>,
    rhs: Vec<f64>,
}

impl PantographState {
    /// State in equilibrium with the first strip at height `z`, m.
    ///
    /// # Errors
    /// [`CoreError::Input`] when there is no equilibrium or a mass is missing.
    pub fn new(model: Pantograph, c: &Coefficients, z: f64, speed: f64) -> Result<Self, CoreError> {
        model.check()?;
        let start = equilibrium::under_one_contact(&model, model.start_force, z, speed)?;
        Self::in_equilibrium(model, c, start)
    }

    /// State in equilibrium with known displacements `u`, m, and preload, N.
    ///
    /// # Errors
    /// [`CoreError::Input`] when a mass is missing, or stops or tables cannot be stepped.
    pub fn in_equilibrium(
        mut model: Pantograph,
        c: &Coefficients,
        (u, preload): (Vec<f64>, f64),
    ) -> Result<Self, CoreError> {
        let n = model.size();
        add_slopes(
            &model.piecewise_forces,
            &mut model.stiffness,
            &mut model.damping,
        );
        let a: Vec<f64> = (0..n * n)
            .map(|i| {
                c.mass * model.mass[i]
                    + c.damping * model.damping[i]
                    + c.stiffness * model.stiffness[i]
            })
            .collect();
        // The response of an external one is set before each step.
        let inverse = if model.is_external {
            Some(a.clone())
        } else {
            dense::inverse(&a, n)
        };
        let inverse = inverse.ok_or_else(|| {
            CoreError::invalid("pantographs", "a mass without inertia or stiffness")
        })?;
        let zero = vec![0.0; n];
        let excitation =
            ExcitationState::new(&model.excitation, &model.stiffness, &model.damping, n);
        check_steps(&model.piecewise_forces, &a, c)?;
        let base = (excitation.influence.as_slice(), excitation.displacement);
        let stops = model.stops.iter();
        let mut breakpoints: Vec<Breakpoint> =
            stops.map(|s| s.breakpoint(c, &inverse, base, &u)).collect();
        check_independent(&breakpoints)?;
        for (number, force) in model.piecewise_forces.iter().enumerate() {
            breakpoints.extend(force.breakpoints(number, c, &inverse, &excitation.influence));
        }
        let piecewise_forces = model
            .piecewise_forces
            .iter()
            .map(|force| PiecewiseForceState::new(force, &excitation.influence));
        Ok(Self {
            piecewise_forces: piecewise_forces.collect(),
            breakpoints,
            actuator: ActuatorState::default(),
            excitation,
            external: ExternalState::new(if model.is_external { n } else { 0 }),
            predicted: zero.clone(),
            inverse,
            preload,
            u,
            v: zero.clone(),
            a: zero.clone(),
            delta: zero.clone(),
            rhs: zero,
            model,
        })
    }

    /// Response A⁻¹ e of the increment to a unit force along `e`, m/N.
    #[must_use]
    pub fn response(&self, e: &[f64]) -> Vec<f64> {
        matrix_vector(&self.inverse, e)
    }

    /// Writes the response A⁻¹ e into `out`, m/N.
    pub(crate) fn write_response(&self, e: &[f64], out: &mut [f64]) {
        for (out, row) in out.iter_mut().zip(self.inverse.chunks_exact(e.len())) {
            *out = inner(row, e);
        }
    }

    /// Sets the inverse of A, m/N, row by row.
    pub(crate) fn set_response(&mut self, inverse: &[f64]) {
        self.inverse.copy_from_slice(inverse);
    }

    /// Sets the excitation of a step. Precedes [`PantographState::predict`].
    pub fn set_excitation(&mut self, now: &ExcitationNow) {
        self.excitation.set(now);
    }

    /// Finds the increment Δu without contact forces and forces of breakpoints, with the speed at
    /// the time of balance, m/s.
    pub fn predict(&mut self, c: &Coefficients, speed: f64) {
        if self.model.is_external {
            let free = self.external.free.iter().zip(&self.u);
            for (delta, (free, u)) in self.delta.iter_mut().zip(free) {
                *delta = free - u;
            }
            self.predicted.copy_from_slice(&self.delta);
            return;
        }
        let n = self.model.size();
        let r = &self.model;
        for i in 0..n {
            let mut f = r.preload[i] * self.preload + r.lift[i] * speed * speed;
            for j in 0..n {
                let am = c.acceleration_from_v * self.v[j] + c.acceleration_from_a * self.a[j];
                let vf = c.velocity_from_v * self.v[j] + c.velocity_from_a * self.a[j];
                let k = i * n + j;
                f -= r.mass[k] * am + r.damping[k] * vf + r.stiffness[k] * self.u[j];
            }
            self.rhs[i] = f;
        }
        self.excitation.add_to(&mut self.rhs);
        for force in self.piecewise_forces.iter().filter(|f| f.intercept != 0.0) {
            let coordinates = self.rhs.iter_mut().zip(&force.coordinate.direction);
            coordinates.for_each(|(f, g)| *f -= force.intercept * g);
        }
        let mut rhs = std::mem::take(&mut self.rhs);
        if let Some((direction, force)) = self.actuator_force() {
            let coordinates = rhs.iter_mut().zip(direction);
            coordinates.for_each(|(f, d)| *f += force * d);
        }
        self.rhs = rhs;
        for i in 0..n {
            self.delta[i] = (0..n).map(|j| self.inverse[i * n + j] * self.rhs[j]).sum();
        }
        self.predicted.copy_from_slice(&self.delta);
        self.update_openings(c);
    }

    /// Direction and force of the actuator, N, when that is not zero.
    pub(crate) fn actuator_force(&self) -> Option<(&[f64], f64)> {
        let actuator = self.model.actuator.as_ref()?;
        let force = self.actuator.force;
        (force != 0.0).then_some((&actuator.direction, force))
    }

    /// Adds the response to a contact force λ, N, which pushes the strip down; `column` is A⁻¹ e.
    pub fn apply_contact_force(&mut self, force: f64, column: &[f64]) {
        for (d, c) in self.delta.iter_mut().zip(column) {
            *d -= force * c;
        }
    }

    /// Adds the response to the forces of the active breakpoints.
    pub fn apply_breakpoint_forces(&mut self) {
        for breakpoint in self.breakpoints.iter().filter(|b| b.active) {
            for (d, c) in self.delta.iter_mut().zip(&breakpoint.column) {
                *d += breakpoint.signed_force() * c;
            }
        }
    }

    /// Restores the increment that [`PantographState::predict`] found.
    pub fn reset_to_prediction(&mut self) {
        self.delta.copy_from_slice(&self.predicted);
    }

    /// Commits the increment: the state at the end of the step.
    pub fn commit(&mut self, c: &Coefficients) {
        for i in 0..self.u.len() {
            let (v, a) = c.advance(self.delta[i], self.v[i], self.a[i]);
            self.u[i] += self.delta[i];
            self.v[i] = v;
            self.a[i] = a;
        }
        self.excitation.displacement = self.excitation.end_displacement;
    }

    /// Breakpoints in the complementarity problem of the step.
    pub(crate) fn active_breakpoints(&self) -> impl Iterator<Item = &Breakpoint> {
        self.breakpoints.iter().filter(|b| b.active)
    }

    /// Largest force of a stop, N.
    pub(crate) fn largest_stop_force(&self) -> f64 {
        let stops = self.breakpoints.iter().filter(|b| b.branch_of.is_none());
        stops.fold(0.0, |largest, stop| f64::max(largest, stop.force))
    }

    /// Updates the openings s of all breakpoints at the time of balance for the predicted
    /// increment.
    fn update_openings(&mut self, c: &Coefficients) {
        let Self {
            u,
            v,
            a,
            delta,
            breakpoints,
            excitation,
            ..
        } = self;
        let instant = BalanceInstant {
            u,
            v,
            a,
            base: excitation.displacement,
            balance: excitation.balance,
        };
        for b in breakpoints {
            b.predicted_opening = b.coordinate.at_balance(b.threshold, c, &instant, delta);
        }
    }

    fn balance_instant(&self) -> BalanceInstant<'_> {
        BalanceInstant {
            u: &self.u,
            v: &self.v,
            a: &self.a,
            base: self.excitation.displacement,
            balance: self.excitation.balance,
        }
    }

    /// Coordinates q of the piecewise linear forces at the time of balance, with the completed
    /// increment, m or m/s.
    fn force_coordinates(&self, c: &Coefficients) -> impl Iterator<Item = f64> {
        let instant = self.balance_instant();
        let forces = self.piecewise_forces.iter();
        forces.map(move |f| f.coordinate_at_balance(c, &instant, &self.delta))
    }

    /// Switches the first piecewise linear force whose coordinate lies on its other branch; returns
    /// whether there was one.
    pub(crate) fn switch_branch(&mut self, c: &Coefficients) -> bool {
        let coordinates = self.force_coordinates(c).zip(&self.piecewise_forces);
        let is_wrong = |(_, (q, force)): &(usize, (f64, &PiecewiseForceState))| {
            force.branch_at(*q) != force.branch
        };
        let Some((number, (q, force))) = coordinates.enumerate().find(is_wrong) else {
            return false;
        };
        let branch = force.branch_at(q);
        self.set_branch(number, branch);
        for b in &mut self.breakpoints {
            if b.branch_of.is_some_and(|(force, _)| force == number) {
                b.force = 0.0;
            }
        }
        true
    }

    /// Sets the branch of piecewise linear force `number`, whose breakpoints become the active
    /// ones.
    pub(crate) fn set_branch(&mut self, number: usize, branch: Branch) {
        self.piecewise_forces[number].branch = branch;
        for b in &mut self.breakpoints {
            if let Some((_, of_breakpoint)) = b.branch_of.filter(|(force, _)| *force == number) {
                b.active = of_breakpoint == branch;
            }
        }
    }

    /// Records the range of the coordinates of the piecewise linear forces.
    pub(crate) fn record_ranges(&mut self, c: &Coefficients) {
        let instant = BalanceInstant {
            u: &self.u,
            v: &self.v,
            a: &self.a,
            base: self.excitation.displacement,
            balance: self.excitation.balance,
        };
        for force in &mut self.piecewise_forces {
            let q = force.coordinate_at_balance(c, &instant, &self.delta);
            force.range = [force.range[0].min(q), force.range[1].max(q)];
        }
    }

    /// Smallest and largest coordinate of each piecewise linear force so far, m or m/s.
    pub(crate) fn coordinate_ranges(&self) -> impl Iterator<Item = f64> {
        self.piecewise_forces.iter().flat_map(|force| force.range)
    }
}
