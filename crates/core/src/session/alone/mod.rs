//! Pantograph by itself: its contact forces are given, step by step.
//!
//!   A Δu = b − Σ e λ + Σ ± d σ,   0 ≤ σ ⊥ s + σ/Δ ≥ 0
//!
//! with everything as on a line ([`model`](crate::pantograph::model),
//! [`breakpoint`](crate::pantograph::breakpoint)), but λ known. What presses against the strips
//! needs to know how they would yield in the step that comes:
//!
//!   z = z₀ − S λ,   S = eᵀA⁻¹e − eᵀA⁻¹ (± D) H⁻¹ Dᵀ A⁻¹e
//!
//! where D are the directions, and H the matrix, of the stops and breakpoints that are closed in
//! that step under contact forces that the asking program supposes. Without stops and tables this
//! is exact; with them as long as none opens or closes because the contact force is another one:
//! a program that asks again about the forces it has found is exact once they stay.

mod breakpoint_problem;
mod standing;
mod start;
mod strip_now;

pub use start::{AloneInputs, AloneStart};

use crate::checkpoint::{Archive, Checkpoint};
use crate::error::CoreError;
use crate::linalg::small::inner;
use crate::pantograph::breakpoint::Branch;
use crate::pantograph::excitation::ExcitationNow;
use crate::pantograph::model::Pantograph;
use crate::pantograph::state::PantographState;
use crate::scheme::{Coefficients, Scheme};
use crate::simulation::saved::resume::archive_pantograph;
use breakpoint_problem::BreakpointProblem;
use strip_now::StripNow;

/// Pantograph by itself.
#[derive(Debug, Clone)]
pub struct Alone {
    state: PantographState,
    coefficients: Coefficients,
    step_length: f64,
    start: AloneStart,
    strips: Vec<StripNow>,
    excitation: ExcitationNow,
    /// Lateral positions of the wires in the last step, m.
    laterals: Vec<f64>,
    problem: BreakpointProblem,
    /// Forces of the breakpoints and branches, while the step that comes is looked at.
    kept: (Vec<f64>, Vec<Branch>),
    steps: usize,
}

impl Alone {
    /// Pantograph at its start.
    ///
    /// # Errors
    /// [`CoreError::Input`] when sizes disagree or it cannot be stepped.
    pub fn new(
        model: Pantograph,
        (scheme, step_length): (Scheme, f64),
        start: AloneStart,
    ) -> Result<Self, CoreError> {
        model.check()?;
        scheme.check()?;
        let sized = start.displacements.len() == model.size()
            && start.forces.len() == model.strips.len()
            && start.laterals.len() == model.strips.len();
        if !sized || !start.is_finite() || !step_length.is_finite() || step_length <= 0.0 {
            let reason = "a start whose sizes disagree, or that is not finite";
            return Err(CoreError::invalid("pantographs", reason));
        }
        let coefficients = scheme.coefficients(step_length);
        let equilibrium = (start.displacements.clone(), start.preload);
        let state = PantographState::in_equilibrium(model, &coefficients, equilibrium)?;
        let strips = state.model.strips.iter().map(|s| StripNow::new(s, &state));
        let (breakpoints, tables) = (state.breakpoints.len(), state.piecewise_forces.len());
        let mut made = Self {
            strips: strips.collect(),
            excitation: ExcitationNow::zero(state.model.size()),
            laterals: start.laterals.clone(),
            problem: BreakpointProblem::with_room(breakpoints),
            kept: (Vec::with_capacity(breakpoints), Vec::with_capacity(tables)),
            state,
            coefficients,
            step_length,
            start,
            steps: 0,
        };
        made.move_wires_back();
        Ok(made)
    }

    /// Number of steps taken.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// Weight α_f of the start of a step in its balance.
    #[must_use]
    pub fn old_weight(&self) -> f64 {
        self.coefficients.old
    }

    /// Number of strips.
    #[must_use]
    pub fn strips(&self) -> usize {
        self.strips.len()
    }

    /// Height of a strip above the rail, m.
    #[must_use]
    pub fn height(&self, strip: usize) -> f64 {
        self.start.datum + inner(&self.strips[strip].vector, &self.state.u)
    }

    /// Velocity of a strip, m/s.
    #[must_use]
    pub fn velocity(&self, strip: usize) -> f64 {
        inner(&self.strips[strip].vector, &self.state.v)
    }

    /// Displacement of a coordinate since the start, m, and its velocity, m/s.
    #[must_use]
    pub fn coordinate(&self, index: usize) -> [f64; 2] {
        let moved = self.state.u[index] - self.start.displacements[index];
        [moved, self.state.v[index]]
    }

    /// Takes a step.
    ///
    /// # Errors
    /// [`CoreError::Input`] for numbers that are not finite, [`CoreError::Lcp`],
    /// [`CoreError::SlackSet`], [`CoreError::NotFinite`]; the state is then that before the step.
    pub fn step(&mut self, inputs: &AloneInputs<'_>) -> Result<(), CoreError> {
        self.check_inputs(inputs)?;
        self.keep_breakpoints();
        self.predict(inputs);
        if let Err(error) = self.solve(inputs.forces) {
            self.restore_breakpoints();
            self.move_wires_back();
            return Err(error);
        }
        if !self.state.delta.iter().all(|v| v.is_finite()) {
            self.restore_breakpoints();
            self.move_wires_back();
            let (what, step) = ("the motion", self.steps);
            return Err(CoreError::NotFinite { what, step });
        }
        self.state.commit(&self.coefficients);
        self.state.record_ranges(&self.coefficients);
        self.laterals.copy_from_slice(inputs.laterals);
        self.steps += 1;
        Ok(())
    }

    /// Looks at the step that comes: heights z₀ of the strips at its end without contact forces, m,
    /// and compliance S between them, m/N, row by row, about the contact forces of `inputs`.
    ///
    /// # Errors
    /// As [`Alone::step`].
    pub fn look_ahead(
        &mut self,
        inputs: &AloneInputs<'_>,
        heights: &mut [f64],
        compliance: &mut [f64],
    ) -> Result<(), CoreError> {
        self.check_inputs(inputs)?;
        self.keep_breakpoints();
        self.predict(inputs);
        let found = self.solve(inputs.forces);
        if found.is_ok() {
            self.yield_of_strips(inputs.forces, heights, compliance);
        }
        self.restore_breakpoints();
        self.move_wires_back();
        found
    }

    /// Saves the state between two steps.
    ///
    /// # Errors
    /// None for a state that steps have left.
    pub fn save(&mut self) -> Result<Checkpoint, CoreError> {
        let mut archive = Archive::saving();
        self.archive(&mut archive)?;
        Ok(archive.checkpoint(self.steps))
    }

    /// Restores a saved state.
    ///
    /// # Errors
    /// [`CoreError::Input`] for a state of another pantograph; the present one is then kept.
    pub fn restore(&mut self, saved: &Checkpoint) -> Result<(), CoreError> {
        let mut restored = self.clone();
        let mut archive = Archive::restoring(saved);
        restored.archive(&mut archive)?;
        archive.finish()?;
        restored.steps = saved.step;
        restored.move_wires_back();
        // A clone has no room to spare.
        restored.problem = std::mem::take(&mut self.problem);
        restored.kept = std::mem::take(&mut self.kept);
        *self = restored;
        Ok(())
    }

    fn archive(&mut self, archive: &mut Archive<'_>) -> Result<(), CoreError> {
        let start = &mut self.start.displacements;
        archive_pantograph(&mut self.state, start, archive, "alone")?;
        archive.numbers("alone_laterals", self.laterals.iter_mut())
    }

    fn check_inputs(&self, inputs: &AloneInputs<'_>) -> Result<(), CoreError> {
        let count = self.strips.len();
        let numbers = [
            inputs.actuator,
            inputs.speed,
            inputs.base[0],
            inputs.base[1],
        ];
        let mut all = inputs.forces.iter().chain(inputs.laterals).chain(&numbers);
        let is_sized = inputs.forces.len() == count && inputs.laterals.len() == count;
        if !is_sized || !all.all(|v| v.is_finite()) {
            let reason = "not one for each strip, or not finite";
            return Err(CoreError::invalid("forces", reason));
        }
        if self.state.model.actuator.is_none() && inputs.actuator != 0.0 {
            let reason = "a force for a pantograph without actuator";
            return Err(CoreError::invalid("forces", reason));
        }
        Ok(())
    }

    /// Moves the wires on the strips back to where they were in the last step.
    fn move_wires_back(&mut self) {
        move_wires(&mut self.strips, &self.state, &self.laterals);
    }

    /// Finds the increment without contact forces and forces of breakpoints.
    fn predict(&mut self, inputs: &AloneInputs<'_>) {
        move_wires(&mut self.strips, &self.state, inputs.laterals);
        let old = self.coefficients.old;
        let [end, rate] = inputs.base;
        let balance = (1.0 - old) * end + old * self.state.excitation.displacement;
        self.excitation.base = Some([end, balance, rate]);
        self.state.set_excitation(&self.excitation);
        self.state.actuator.force = inputs.actuator;
        self.state.predict(&self.coefficients, inputs.speed);
    }

    /// Completes the increment with contact forces and the forces of breakpoints.
    fn solve(&mut self, forces: &[f64]) -> Result<(), CoreError> {
        let tables = self.state.piecewise_forces.len() as u32;
        // Every combination of branches occurs once at most.
        for _ in 0..1_usize.checked_shl(tables).unwrap_or(usize::MAX) {
            self.state.reset_to_prediction();
            for (strip, force) in self.strips.iter().zip(forces) {
                self.state.apply_contact_force(*force, &strip.column);
            }
            self.solve_breakpoints(forces)?;
            self.state.apply_breakpoint_forces();
            if !self.state.switch_branch(&self.coefficients) {
                return Ok(());
            }
        }
        let time = (self.steps + 1) as f64 * self.step_length;
        let step = self.steps;
        Err(CoreError::SlackSet { step, time })
    }

    fn solve_breakpoints(&mut self, forces: &[f64]) -> Result<(), CoreError> {
        let (problem, all) = (&mut self.problem, &mut self.state.breakpoints);
        let solved = problem.solve(all, &self.strips, forces);
        solved.map_err(|failure| CoreError::Lcp {
            step: self.steps,
            time: (self.steps + 1) as f64 * self.step_length,
            contacts: Vec::new(),
            links: Vec::new(),
            stops: vec![self.problem.active()],
            failure: Box::new(failure),
        })
    }

    /// Finds heights and compliance of the strips about the solution that stands in the increment.
    fn yield_of_strips(&mut self, forces: &[f64], heights: &mut [f64], compliance: &mut [f64]) {
        let (count, all) = (self.strips.len(), &self.state.breakpoints);
        self.problem.keep_closed(all);
        for (j, source) in self.strips.iter().enumerate() {
            self.problem.load(all, &source.column);
            for (i, target) in self.strips.iter().enumerate() {
                let held = self.problem.held(all, &target.vector);
                compliance[i * count + j] = inner(&target.vector, &source.column) - held;
            }
        }
        for (i, strip) in self.strips.iter().enumerate() {
            let moved =
                inner(&strip.vector, &self.state.u) + inner(&strip.vector, &self.state.delta);
            let row = &compliance[i * count..(i + 1) * count];
            heights[i] = self.start.datum + moved + inner(row, forces);
        }
    }

    /// Keeps what the solution of a step changes before it is taken.
    fn keep_breakpoints(&mut self) {
        let (forces, branches) = &mut self.kept;
        forces.clear();
        forces.extend(self.state.breakpoints.iter().map(|b| b.force));
        branches.clear();
        branches.extend(self.state.piecewise_forces.iter().map(|f| f.branch));
    }

    fn restore_breakpoints(&mut self) {
        let (forces, branches) = &self.kept;
        for (number, branch) in branches.iter().enumerate() {
            self.state.set_branch(number, *branch);
        }
        for (b, force) in self.state.breakpoints.iter_mut().zip(forces) {
            b.force = *force;
        }
    }
}

/// Moves the wires on the strips to lateral positions, m.
fn move_wires(strips: &mut [StripNow], state: &PantographState, laterals: &[f64]) {
    let strips = strips.iter_mut().zip(&state.model.strips);
    for ((now, strip), lateral) in strips.zip(laterals) {
        now.move_wire(strip, *lateral);
    }
}
