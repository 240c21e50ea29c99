//! Session: a line stepped from outside, one step for each call, with nothing allocated in it.
//!
//! Three kinds of session, one [step](crate::simulation::step), that of every run:
//!
//! * **forces given** — a real pantograph presses against the simulated wire and its force is
//!   measured. The force F of collector j, at the position x of the collector at the time of
//!   balance, is a load on the line,
//!
//!     A Δu = … + Σ F_j S(x_j)
//!
//!   and the output is the wire at the collector at the end of the step: height z, lateral position
//!   and the rate of the height that the collector follows, dz/dt = ż + V ∂z/∂x.
//! * **pantographs simulated** — the input is the force of each pantograph's
//!   [actuator](crate::pantograph::actuator), the outputs are contact forces and the motion of the
//!   pantographs.
//! * **strips given** — a program outside moves the strips of
//!   [external pantographs](crate::pantograph::external). The input of a step are their heights z₀
//!   at its end without contact and the compliance S of the step, the outputs are contact forces
//!   and the heights that they lead to.
//!
//! Inputs are measured when the step begins and act during the whole step. Outputs belong to the
//! end of the step, except contact forces, which belong to its time of balance.

pub mod alone;
pub mod any;
pub(crate) mod collectors;
pub(crate) mod compliance;
pub(crate) mod outputs;
pub mod prepared;
pub(crate) mod saved;
pub(crate) mod snapshot;
pub(crate) mod start;
pub(crate) mod strips;
pub(crate) mod subgrid_height;
pub(crate) mod watched;

pub use any::AnySession;
pub use collectors::Collector;
pub use compliance::Compliance;
pub use outputs::Outputs;
pub use prepared::{Drive, Prepared};

use crate::error::CoreError;
use crate::integrator::wire_model::WireModel;
use crate::linear::loads::Loads;
use crate::pantograph::actuator::Actuator;
use crate::pantograph::model::Pantograph;
use crate::session::collectors::{Collectors, check_end};
use crate::session::compliance::ComplianceWork;
use crate::session::snapshot::Snapshot;
use crate::session::subgrid_height::add_subgrid_heights;
use crate::session::watched::{WatchedNode, read_uplifts};
use crate::simulation::inputs::Inputs;
use crate::simulation::model::Model;
use crate::simulation::run::OBSERVE_EVERY;
use crate::simulation::state::State;
use crate::simulation::step::step;
use std::sync::Arc;

/// Start of a session.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SessionStart {
    /// Position along the track, m.
    pub position: f64,
    /// Speed, m/s.
    pub speed: f64,
    /// Coefficient of friction along the wire.
    pub friction: f64,
}

/// Line and pantographs of a session, owned by it; no step changes them.
#[derive(Debug)]
pub(crate) struct OwnedModel<const DIM: usize, const D: usize> {
    pub(crate) line: Arc<WireModel<DIM, D>>,
    /// Pantographs; none where forces are given.
    pub(crate) pantographs: Vec<Pantograph>,
    /// Distance of each pantograph behind the first, m.
    pub(crate) distances: Vec<f64>,
    /// Coefficient of friction along the wire.
    pub(crate) friction: f64,
}

impl<const DIM: usize, const D: usize> OwnedModel<DIM, D> {
    pub(crate) fn borrow(&self) -> Model<'_, DIM, D> {
        Model {
            wires: &self.line,
            pantographs: &self.pantographs,
            distances: &self.distances,
            friction: self.friction,
        }
    }
}

/// Line that is stepped from outside.
#[derive(Debug)]
pub struct Session<const DIM: usize, const D: usize> {
    pub(crate) model: OwnedModel<DIM, D>,
    pub(crate) collectors: Collectors<DIM>,
    /// Position along the track at the end of the last step, m.
    pub(crate) position: f64,
    /// Speed at the end of the last step, m/s.
    pub(crate) speed: f64,
    pub(crate) state: State<DIM, D>,
    pub(crate) outputs: Outputs,
    pub(crate) watched: Vec<WatchedNode<DIM>>,
    pub(crate) compliance: ComplianceWork<DIM>,
}

/// Inputs of a step with the loads of collectors, with its positions (m) and speed (m/s).
pub(crate) fn step_inputs<const DIM: usize>(
    collectors: &Collectors<DIM>,
    positions: [f64; 3],
    speed: f64,
) -> Inputs<'_> {
    Inputs {
        positions,
        speed,
        loads: Loads::new(&collectors.loads, &collectors.sizes),
        excitations: &[],
    }
}

impl<const DIM: usize, const D: usize> Session<DIM, D> {
    /// Takes a step that ends at `position` (m) with `speed` (m/s). `forces` in N act during the
    /// step: one for each collector where forces are given, else one for the actuator of each
    /// pantograph. Where strips are given, see [`Session::step_strips`].
    ///
    /// Nothing is allocated unless the step fails, or more links are slack than
    /// [`RESERVED_ROWS`](crate::session::start::RESERVED_ROWS) allows for. After a failure the
    /// session stands where it stood before.
    ///
    /// # Errors
    /// [`CoreError::Input`], or any [`CoreError`] that a step can raise.
    pub fn step(&mut self, forces: &[f64], position: f64, speed: f64) -> Result<(), CoreError> {
        if self.has_strips() {
            let reason = "where strips are given, heights and compliances move them";
            return Err(CoreError::invalid("forces", reason));
        }
        self.check_inputs(forces, position, speed)?;
        self.take_step(forces, position, speed)
    }

    /// Takes a step with checked inputs.
    pub(crate) fn take_step(
        &mut self,
        forces: &[f64],
        position: f64,
        speed: f64,
    ) -> Result<(), CoreError> {
        let positions = self.positions(position);
        self.set_forces(forces, positions)?;
        let speed_at_balance = self.at_balance(self.speed, speed);
        let inputs = step_inputs(&self.collectors, positions, speed_at_balance);
        let number = self.steps();
        step(&self.model.borrow(), &inputs, &mut self.state)?;
        if number.is_multiple_of(OBSERVE_EVERY) {
            self.state.motion.check_finite()?;
        }
        (self.position, self.speed) = (position, speed);
        self.read_outputs()
    }

    /// Value at the time of balance from those at the start and the end of the step.
    pub(crate) fn at_balance(&self, before: f64, after: f64) -> f64 {
        let old = self.model.line.coefficients.old;
        (1.0 - old) * after + old * before
    }

    /// Positions at the start of a step that ends at `position`, at its time of balance, and at its
    /// end, m.
    pub(crate) fn positions(&self, position: f64) -> [f64; 3] {
        let balance = self.at_balance(self.position, position);
        [self.position, balance, position]
    }

    /// Weight α_f of the start of a step in its balance: inputs and contact forces belong to the
    /// time (1 − α_f) h after the start.
    #[must_use]
    pub fn old_weight(&self) -> f64 {
        self.model.line.coefficients.old
    }

    /// Step length, s.
    #[must_use]
    pub fn step_length(&self) -> f64 {
        self.model.line.h
    }

    /// Flexibility 1/k_c of a contact, m/N.
    #[must_use]
    pub fn contact_flexibility(&self) -> f64 {
        self.model.line.contact_flexibility
    }

    /// Outputs of the last step, or of the start.
    #[must_use]
    pub fn outputs(&self) -> &Outputs {
        &self.outputs
    }

    /// Number of steps taken.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.state.motion.steps
    }

    /// Number of nodes of the line.
    #[must_use]
    pub fn nodes(&self) -> usize {
        self.model.line.line.nodes()
    }

    /// Displacements of all nodes from the static shape, m, node by node.
    #[must_use]
    pub fn displacements(&self) -> Vec<f64> {
        let (line, wires) = (&self.model.line, &self.state.motion.wires);
        (0..self.nodes())
            .flat_map(|node| line.displacement_between_steps(wires, node))
            .collect()
    }

    /// Position along the track in m, and speed in m/s.
    #[must_use]
    pub fn position_and_speed(&self) -> (f64, f64) {
        (self.position, self.speed)
    }

    /// Number of forces that a step needs; zero where strips are given.
    #[must_use]
    pub fn inputs(&self) -> usize {
        if self.has_strips() {
            return 0;
        }
        self.collectors.all.len().max(self.model.pantographs.len())
    }

    fn check_inputs(&self, forces: &[f64], position: f64, speed: f64) -> Result<(), CoreError> {
        if forces.len() != self.inputs() {
            let reason = "not one for each collector or pantograph";
            return Err(CoreError::invalid("forces", reason));
        }
        if !forces.iter().all(|force| force.is_finite()) {
            return Err(CoreError::invalid("forces", "not finite"));
        }
        if !position.is_finite() || !speed.is_finite() {
            return Err(CoreError::invalid("position", "not finite"));
        }
        let without_actuator = |(pantograph, force): (&Pantograph, &f64)| {
            pantograph.actuator.is_none() && *force != 0.0
        };
        let mut pairs = self.model.pantographs.iter().zip(forces);
        if pairs.any(without_actuator) {
            let reason = "a force for a pantograph without actuator";
            return Err(CoreError::invalid("forces", reason));
        }
        Ok(())
    }

    /// Sets the forces of the step, N: of actuators, and of collectors on the wire. Positions of
    /// the session, m: at the start of the step, at the time of balance, and at the end.
    pub(crate) fn set_forces(
        &mut self,
        forces: &[f64],
        [_, balance, end]: [f64; 3],
    ) -> Result<(), CoreError> {
        let (model, motion) = (self.model.borrow(), &mut self.state.motion);
        check_end(model.wires, motion, end)?;
        for (pantograph, force) in motion.pantographs.iter_mut().zip(forces) {
            pantograph.actuator.force = *force;
        }
        self.collectors
            .apply_forces(&model, motion, forces, [balance, end])
    }

    /// Reads the outputs from the present state.
    pub(crate) fn read_outputs(&mut self) -> Result<(), CoreError> {
        let (line, motion) = (&*self.model.line, &self.state.motion);
        self.collectors
            .locate(&line.slidelines[0], self.position, motion.steps)?;
        let snapshot = Snapshot {
            line,
            motion,
            collectors: &self.collectors,
            position: self.position,
            speed: self.speed,
        };
        self.outputs.read_mesh(&snapshot)?;
        add_subgrid_heights(&mut self.outputs, &snapshot);
        let Outputs { force, uplift, .. } = &mut self.outputs;
        read_uplifts(&self.watched, &snapshot, force, uplift);
        Ok(())
    }
}

/// Tells whether an actuator is one of a session: sampled in every step, without delay.
pub(crate) fn is_direct(actuator: &Actuator) -> bool {
    actuator.every == 1 && actuator.delay == 0
}
