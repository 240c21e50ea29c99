//! A line in a loop with the outside: a step for each call, nothing allocated in it.
//!
//! Two kinds of loop, one [step](crate::simulation::step), that of every run:
//!
//! * **forces given** — what presses against the wire is real, its force is measured. The force of
//!   collector j, F at the place of its wire at the time of balance, is a load on the line,
//!
//!     A Δu = … + Σ F_j S(x_j)
//!
//!   and what comes out is the wire at the collector at the end of the step: height z, lateral place
//!   and the rate of the height that the collector follows, dz/dt = ż + V ∂z/∂x.
//! * **riders simulated** — the force of each rider's [actuator](crate::pantograph::actuator) comes in, contact
//!   forces and the motion of the riders go out.
//!
//! What comes in is what was measured when the step begins; it acts during the whole step. What goes
//! out belongs to the end of the step, but for contact forces, which belong to its time of balance.

pub(crate) mod forces;
pub(crate) mod outputs;
pub(crate) mod start;
pub(crate) mod subgrid_height;

use crate::checkpoint::Checkpoint;
use crate::error::CoreError;
use crate::integrator::prepared::WireModel;
use crate::linear::loads::{Load, Loads};
use crate::pantograph::actuator::Actuator;
use crate::pantograph::system::Pantograph;
use crate::session::outputs::Outputs;
use crate::simulation::inputs::Inputs;
use crate::simulation::model::Model;
use crate::simulation::run::OBSERVE_EVERY;
use crate::simulation::state::State;
use crate::simulation::step::step;
use crate::slideline::point::SlidelinePoint;
use std::sync::Arc;

/// What presses against the wire with a force that is given.
#[derive(Debug, Clone, Copy)]
pub struct Collector {
    /// Distance behind the position of the loop, m.
    pub behind: f64,
    /// Reach to either side, m; infinite when every wire is in reach.
    pub half_width: f64,
}

/// How a loop begins.
#[derive(Debug, Clone, Copy)]
pub struct Begin {
    /// Position along the track, m.
    pub position: f64,
    /// Speed, m/s.
    pub speed: f64,
    /// Coefficient of friction along the wire.
    pub friction: f64,
}

/// Line and riders of a loop, which nothing changes.
#[derive(Debug)]
pub(crate) struct Fixed<const DIM: usize, const D: usize> {
    pub(crate) line: Arc<WireModel<DIM, D>>,
    /// None where forces are given.
    pub(crate) riders: Vec<Pantograph>,
    /// Distance of each rider behind the first, m.
    pub(crate) distances: Vec<f64>,
    /// Coefficient of friction along the wire.
    pub(crate) friction: f64,
}

impl<const DIM: usize, const D: usize> Fixed<DIM, D> {
    pub(crate) fn model(&self) -> Model<'_, DIM, D> {
        Model {
            line: &self.line,
            riders: &self.riders,
            distances: &self.distances,
            friction: self.friction,
        }
    }
}

/// A line that is stepped from outside.
#[derive(Debug)]
pub struct Session<const DIM: usize, const D: usize> {
    pub(crate) fixed: Fixed<DIM, D>,
    pub(crate) collectors: Vec<Collector>,
    /// Where the wire was found last at each collector.
    pub(crate) places: Vec<SlidelinePoint<DIM>>,
    /// Force of each collector on the line: shares of nodes, and the force in N.
    pub(crate) loads: Vec<Load>,
    pub(crate) sizes: Vec<f64>,
    /// Forces of the collectors in the last step, N.
    pub(crate) forces: Vec<f64>,
    /// Position along the track in m, and speed in m/s, of the last step.
    pub(crate) position: f64,
    pub(crate) speed: f64,
    pub(crate) state: State<DIM, D>,
    pub(crate) reading: Outputs,
}

/// Name of position and speed among the numbers of a state.
const PLACE: &str = "loop_position_speed";

pub(crate) fn refuse(array: &'static str, reason: &str) -> CoreError {
    let reason = reason.into();
    CoreError::Input { array, reason }
}

impl<const DIM: usize, const D: usize> Session<DIM, D> {
    /// Take a step that ends at `position` (m) with `speed` (m/s). `forces` in N act during the
    /// step: one for each collector where forces are given, else one for the actuator of each rider.
    ///
    /// Nothing is allocated unless the step fails, or more links are slack than
    /// [`ROOM`](crate::session::start::ROOM) allows for. After a failure the loop stands where it stood before.
    ///
    /// # Errors
    /// [`CoreError::Input`], or any [`CoreError`] that a step can raise.
    pub fn step(&mut self, forces: &[f64], position: f64, speed: f64) -> Result<(), CoreError> {
        self.check(forces, position, speed)?;
        let old = self.fixed.line.coefficients.old;
        let between = |before: f64, after: f64| (1.0 - old) * after + old * before;
        let positions = [self.position, between(self.position, position), position];
        self.push(forces, positions)?;
        let inputs = Inputs {
            positions,
            speed: between(self.speed, speed),
            loads: Loads::new(&self.loads, &self.sizes),
            given: &[],
        };
        let number = self.steps();
        step(&self.fixed.model(), &inputs, &mut self.state)?;
        if number.is_multiple_of(OBSERVE_EVERY) {
            self.state.motion.check_finite()?;
        }
        (self.position, self.speed) = (position, speed);
        self.read()
    }

    /// What the last step, or the start, has left.
    #[must_use]
    pub fn reading(&self) -> &Outputs {
        &self.reading
    }

    /// Steps taken.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.state.motion.steps
    }

    /// Nodes of the line.
    #[must_use]
    pub fn nodes(&self) -> usize {
        self.fixed.line.line.nodes()
    }

    /// Position along the track in m, and speed in m/s.
    #[must_use]
    pub fn place(&self) -> (f64, f64) {
        (self.position, self.speed)
    }

    /// Number of forces that a step takes.
    #[must_use]
    pub fn inputs(&self) -> usize {
        self.collectors.len().max(self.fixed.riders.len())
    }

    fn check(&self, forces: &[f64], position: f64, speed: f64) -> Result<(), CoreError> {
        if forces.len() != self.inputs() {
            return Err(refuse("forces", "not one for each collector or rider"));
        }
        if !forces.iter().all(|force| force.is_finite()) {
            return Err(refuse("forces", "not finite"));
        }
        if !position.is_finite() || !speed.is_finite() {
            return Err(refuse("position", "not finite"));
        }
        let unheard =
            |(rider, force): (&Pantograph, &f64)| rider.actuator.is_none() && *force != 0.0;
        if self.fixed.riders.iter().zip(forces).any(unheard) {
            return Err(refuse("forces", "a force for a rider without actuator"));
        }
        Ok(())
    }

    /// The state between two steps.
    ///
    /// # Errors
    /// None of a state that steps have left.
    pub fn take_down(&mut self) -> Result<Checkpoint, CoreError> {
        let mut saved = self.state.take_down(&self.fixed.model())?;
        saved
            .numbers
            .insert(PLACE.into(), vec![self.position, self.speed]);
        Ok(saved)
    }

    /// Go on from a state of this loop, or of another on the same line with as many riders.
    ///
    /// # Errors
    /// [`CoreError::Input`] for a state of another loop; the present one is then kept.
    pub fn put_back(&mut self, saved: &Checkpoint) -> Result<(), CoreError> {
        let mut rest = saved.clone();
        let place = rest.numbers.remove(PLACE).unwrap_or_default();
        let [position, speed] = place[..] else {
            return Err(refuse("state", "it is not of a loop"));
        };
        let mut state = self.state.clone();
        state.put_back(&self.fixed.model(), &rest)?;
        let before = (self.position, self.speed);
        (self.position, self.speed) = (position, speed);
        let before_state = std::mem::replace(&mut self.state, state);
        let done = self.read();
        if done.is_err() {
            (self.position, self.speed) = before;
            self.state = before_state;
            self.read()?;
        }
        done
    }
}

/// Whether an actuator is one of a loop: asked in every step, without delay.
pub(crate) fn is_direct(actuator: &Actuator) -> bool {
    actuator.every == 1 && actuator.delay == 0
}
