//! A mechanical system that travels along the wire and presses against it.
//!
//!   m ü + c u̇ + k u = b p + g V(t)² + f(t) + a q − Σ e λ + Σ d σ
//!
//! f is what is [given](crate::pantograph::excitation) (the ground may move as well), q the force of its
//! [actuator](crate::pantograph::actuator), σ the forces of its
//! [stops](crate::pantograph::bump_stop) and of the [kinks](crate::pantograph::breakpoint) of springs and dampers given by
//! [tables](crate::pantograph::piecewise_force). `e` picks the height of a [strip](crate::pantograph::strip), `b` where the constant preload p acts, `g` the
//! forces proportional to the square of speed. Heights are measured from the height of the wire
//! where the run starts. The preload follows from the contact force asked for at the start, in
//! static equilibrium there; a spring between the first mass and the vehicle is thereby at rest
//! at the working height.

use crate::error::CoreError;
use crate::linalg::dense;
use crate::pantograph::actuator::{Actuator, ActuatorState};
use crate::pantograph::breakpoint::Breakpoint;
use crate::pantograph::bump_stop::{BumpStop, check_independent};
use crate::pantograph::equilibrium;
use crate::pantograph::excitation::{Excitation, ExcitationNow, ExcitationState};
use crate::pantograph::piecewise_force::{
    PiecewiseForce, PiecewiseForceState, add_slopes, check_steps,
};
use crate::pantograph::strip::{self, Strip};
use crate::scheme::Coefficients;

/// Description of a rider. Matrices are n × n, row by row; SI units.
#[derive(Debug, Clone)]
pub struct Pantograph {
    /// Mass matrix, kg.
    pub mass: Vec<f64>,
    /// Damping matrix, N·s/m.
    pub damping: Vec<f64>,
    /// Stiffness matrix, N/m.
    pub stiffness: Vec<f64>,
    /// What touches the wires, first in the direction of travel first.
    pub strips: Vec<Strip>,
    /// Direction of the preload.
    pub preload: Vec<f64>,
    /// Force per squared speed, N/(m/s)².
    pub lift: Vec<f64>,
    /// Contact force at the start, N, at the speed of the start: the sum over its contacts.
    pub start_force: f64,
    /// Forces and motion of the ground, given for the whole run.
    pub given: Excitation,
    /// One-sided stops.
    pub stops: Vec<BumpStop>,
    /// Springs and dampers with a table, beside those in the matrices.
    pub laws: Vec<PiecewiseForce>,
    /// A force decided on during the run.
    pub actuator: Option<Actuator>,
}

impl Pantograph {
    /// Number of degrees of freedom.
    #[must_use]
    pub fn size(&self) -> usize {
        self.preload.len()
    }

    /// Check sizes and numbers.
    ///
    /// # Errors
    /// [`CoreError::Input`].
    pub fn check(&self) -> Result<(), CoreError> {
        let n = self.size();
        let matrices = [&self.mass, &self.damping, &self.stiffness];
        let vectors = [&self.preload, &self.lift];
        let sized =
            matrices.iter().all(|m| m.len() == n * n) && vectors.iter().all(|v| v.len() == n);
        let finite = matrices
            .iter()
            .chain(&vectors)
            .all(|m| m.iter().all(|v| v.is_finite()));
        let extras = self.given.is_sound(n)
            && self.stops.iter().all(|s| s.is_sound(n))
            && self.laws.iter().all(|l| l.is_sound(n))
            && self.actuator.iter().all(|a| a.is_sound(n));
        if n == 0 || !sized || !finite || !extras || !self.start_force.is_finite() {
            let reason = "sizes disagree or a number is not finite".into();
            return Err(CoreError::Input {
                array: "riders",
                reason,
            });
        }
        strip::check(&self.strips, n)
    }

    /// Static equilibrium under a force λ on its first strip, which is at height `z`: displacements
    /// and preload from  k u − b p = g V² + f − e λ,  eᵀ u = z, with f as given for the start.
    ///
    /// # Errors
    /// [`CoreError::Input`] when the chain has no such equilibrium, [`CoreError::BeyondTable`].
    pub fn equilibrium(
        &self,
        force: f64,
        z: f64,
        speed: f64,
    ) -> Result<(Vec<f64>, f64), CoreError> {
        let e = &self.strips[0].vectors[0];
        let found = equilibrium::settle(self, &times(force, e), (e, z), speed)?;
        Ok((found.u, found.preload))
    }

    /// Forces on the coordinates at the start, but for preload and contact.
    pub(crate) fn at_start(&self, speed: f64) -> Vec<f64> {
        let given = self.given.at_start(&self.stiffness, self.size());
        let lift = self.lift.iter().zip(given);
        lift.map(|(g, given)| g * speed * speed + given).collect()
    }
}

/// State and prepared matrices of a rider during a run.
#[derive(Debug, Clone)]
pub struct PantographState {
    /// What it is.
    pub rider: Pantograph,
    inverse: Vec<f64>,
    /// Constant preload, N.
    pub preload: f64,
    /// Displacement, m.
    pub u: Vec<f64>,
    /// Velocity, m/s.
    pub v: Vec<f64>,
    /// Acceleration, m/s².
    pub a: Vec<f64>,
    /// Increment of the current step without contact force, then with it.
    pub delta: Vec<f64>,
    /// Its stops, then the kinks of its laws.
    pub(crate) kinks: Vec<Breakpoint>,
    pub(crate) laws: Vec<PiecewiseForceState>,
    pub(crate) actuator: ActuatorState,
    pub(crate) drive: ExcitationState,
    /// The increment without contact forces and kinks.
    free: Vec<f64>,
    rhs: Vec<f64>,
}

impl PantographState {
    /// Prepare a rider that stands in equilibrium with its first strip at height `z`.
    ///
    /// # Errors
    /// [`CoreError::Input`] when there is no equilibrium or a mass is missing.
    pub fn new(rider: Pantograph, c: &Coefficients, z: f64, speed: f64) -> Result<Self, CoreError> {
        rider.check()?;
        let stand = rider.equilibrium(rider.start_force, z, speed)?;
        Self::standing(rider, c, stand)
    }

    /// Prepare a rider that stands in equilibrium with the given displacements and preload.
    ///
    /// # Errors
    /// [`CoreError::Input`] when a mass is missing, or stops or tables cannot be stepped.
    pub fn standing(
        mut rider: Pantograph,
        c: &Coefficients,
        (u, preload): (Vec<f64>, f64),
    ) -> Result<Self, CoreError> {
        let n = rider.size();
        add_slopes(&rider.laws, &mut rider.stiffness, &mut rider.damping);
        let a: Vec<f64> = (0..n * n)
            .map(|i| {
                c.mass * rider.mass[i]
                    + c.damping * rider.damping[i]
                    + c.stiffness * rider.stiffness[i]
            })
            .collect();
        let inverse = dense::inverse(&a, n).ok_or_else(|| CoreError::Input {
            array: "riders",
            reason: "a mass without inertia or stiffness".into(),
        })?;
        let zero = vec![0.0; n];
        let drive = ExcitationState::new(&rider.given, &rider.stiffness, &rider.damping, n);
        check_steps(&rider.laws, &a, c)?;
        let ground = (drive.carried.as_slice(), drive.now);
        let stops = rider.stops.iter();
        let mut kinks: Vec<Breakpoint> = stops.map(|s| s.kink(c, &inverse, ground, &u)).collect();
        check_independent(&kinks)?;
        for (number, law) in rider.laws.iter().enumerate() {
            kinks.extend(law.kinks(number, c, &inverse, &drive.carried));
        }
        let laws = rider
            .laws
            .iter()
            .map(|l| PiecewiseForceState::new(l, &drive.carried));
        Ok(Self {
            laws: laws.collect(),
            kinks,
            actuator: ActuatorState::default(),
            drive,
            free: zero.clone(),
            inverse,
            preload,
            u,
            v: zero.clone(),
            a: zero.clone(),
            delta: zero.clone(),
            rhs: zero,
            rider,
        })
    }

    /// A⁻¹ e, the response of the increment to a unit pull along `e`.
    #[must_use]
    pub fn response(&self, e: &[f64]) -> Vec<f64> {
        multiply(&self.inverse, e)
    }

    /// Increment Δu without contact force, for the speed at the time of balance.
    pub fn free_increment(&mut self, c: &Coefficients, speed: f64) {
        let n = self.rider.size();
        let r = &self.rider;
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
        self.drive.add_to(&mut self.rhs);
        for law in self.laws.iter().filter(|l| l.intercept != 0.0) {
            let pulled = self.rhs.iter_mut().zip(&law.gauge.direction);
            pulled.for_each(|(f, g)| *f -= law.intercept * g);
        }
        let mut rhs = std::mem::take(&mut self.rhs);
        if let Some((direction, force)) = self.controlled() {
            let pushed = rhs.iter_mut().zip(direction);
            pushed.for_each(|(f, d)| *f += force * d);
        }
        self.rhs = rhs;
        for i in 0..n {
            self.delta[i] = (0..n).map(|j| self.inverse[i * n + j] * self.rhs[j]).sum();
        }
        self.free.copy_from_slice(&self.delta);
        self.open_kinks(c);
    }

    /// The controlled force with its direction, when there is one that is not zero.
    pub(crate) fn controlled(&self) -> Option<(&[f64], f64)> {
        let actuator = self.rider.actuator.as_ref()?;
        let force = self.actuator.force;
        (force != 0.0).then_some((&actuator.direction, force))
    }

    /// Take the excitation of a step. Call before [`PantographState::free_increment`].
    pub fn begin(&mut self, now: &ExcitationNow) {
        self.drive.begin(now);
    }

    /// Add the response to a contact force λ, which pushes the strip down; `column` is A⁻¹ e.
    pub fn add_contact(&mut self, force: f64, column: &[f64]) {
        for (d, c) in self.delta.iter_mut().zip(column) {
            *d -= force * c;
        }
    }

    /// Forget what was added since [`PantographState::free_increment`].
    pub fn take_back(&mut self) {
        self.delta.copy_from_slice(&self.free);
    }

    /// Take the step.
    pub fn advance(&mut self, c: &Coefficients) {
        for i in 0..self.u.len() {
            let (v, a) = c.advance(self.delta[i], self.v[i], self.a[i]);
            self.u[i] += self.delta[i];
            self.v[i] = v;
            self.a[i] = a;
        }
        self.drive.now = self.drive.end;
    }
}

/// Scalar product.
#[must_use]
pub fn inner(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(a, b)| a * b).sum()
}

/// A multiple of a vector.
#[must_use]
pub fn times(factor: f64, x: &[f64]) -> Vec<f64> {
    x.iter().map(|x| x * factor).collect()
}

/// Product of a square matrix and a vector.
#[must_use]
pub fn multiply(a: &[f64], x: &[f64]) -> Vec<f64> {
    let n = x.len();
    (0..n)
        .map(|i| (0..n).map(|j| a[i * n + j] * x[j]).sum())
        .collect()
}
