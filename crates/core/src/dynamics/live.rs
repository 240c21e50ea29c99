//! A line in a loop with the outside: a step for each call, nothing allocated in it.
//!
//! Two kinds of loop, one step ([`Run::step`](super::run), that of every run):
//!
//! * **forces given** — what presses against the wire is real, its force is measured. The force of
//!   collector j, F at the place of its wire at the time of balance, is a load on the line,
//!
//!     A Δu = … + Σ F_j S(x_j)
//!
//!   and what comes out is the wire at the collector at the end of the step: height z, lateral place
//!   and the rate of the height that the collector follows, dz/dt = ż + V ∂z/∂x.
//! * **riders simulated** — the force of each rider's [actuator](super::actuator) comes in, contact
//!   forces and the motion of the riders go out.
//!
//! What comes in is what was measured when the step begins; it acts during the whole step. What goes
//! out belongs to the end of the step, but for contact forces, which belong to its time of balance.

use super::actuator::Actuator;
use super::live_parts::Parts;
use super::live_reading::Reading;
use super::place::Place;
use super::record::RecordPlan;
use super::rider::Rider;
use super::run::{OBSERVE_EVERY, Travel};
use super::stepper::Prepared;
use crate::error::CoreError;
use std::sync::Arc;

/// Number of every step in the [`Travel`] of a loop, which holds the start, and both ends of the
/// present step. It is not 0, the only one that a record with no end to its intervals would take.
pub(super) const STEP: usize = 1;

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

/// A line that is stepped from outside.
#[derive(Debug)]
pub struct Live<const DIM: usize, const D: usize> {
    pub(super) p: Arc<Prepared<DIM, D>>,
    /// None where forces are given.
    pub(super) riders: Vec<Rider>,
    pub(super) collectors: Vec<Collector>,
    /// Where the wire was found last at each collector.
    pub(super) places: Vec<Place<DIM>>,
    pub(super) travel: Travel,
    pub(super) plan: RecordPlan,
    /// Missing only while a step is taken.
    pub(super) parts: Option<Parts<DIM, D>>,
    pub(super) steps: usize,
    pub(super) reading: Reading,
}

pub(super) fn refuse(array: &'static str, reason: &str) -> CoreError {
    let reason = reason.into();
    CoreError::Input { array, reason }
}

pub(super) fn lost() -> CoreError {
    refuse("loop", "the state was lost in a step that did not return")
}

impl<const DIM: usize, const D: usize> Live<DIM, D> {
    /// Take a step that ends at `position` (m) with `speed` (m/s). `forces` in N act during the
    /// step: one for each collector where forces are given, else one for the actuator of each rider.
    ///
    /// Nothing is allocated unless the step fails, or more links are slack than
    /// [`ROOM`](super::live_start::ROOM) allows for. After a failure the loop stands where it stood before.
    ///
    /// # Errors
    /// [`CoreError::Input`], or any [`CoreError`] that a step can raise.
    pub fn step(&mut self, forces: &[f64], position: f64, speed: f64) -> Result<(), CoreError> {
        self.check(forces, position, speed)?;
        (
            self.travel.positions[STEP + 1],
            self.travel.speeds[STEP + 1],
        ) = (position, speed);
        let taken = self.push(forces).and_then(|()| self.take());
        taken.map_err(|error| error.of_step(self.steps, self.p.h))?;
        (self.travel.positions[STEP], self.travel.speeds[STEP]) = (position, speed);
        self.steps += 1;
        self.read()
    }

    /// What the last step, or the start, has left.
    #[must_use]
    pub fn reading(&self) -> &Reading {
        &self.reading
    }

    /// Steps taken.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// Nodes of the line.
    #[must_use]
    pub fn nodes(&self) -> usize {
        self.p.line.nodes()
    }

    /// Position along the track in m, and speed in m/s.
    #[must_use]
    pub fn place(&self) -> (f64, f64) {
        (self.travel.positions[STEP], self.travel.speeds[STEP])
    }

    /// Number of forces that a step takes.
    #[must_use]
    pub fn inputs(&self) -> usize {
        self.collectors.len().max(self.riders.len())
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
        let unheard = |(rider, force): (&Rider, &f64)| rider.actuator.is_none() && *force != 0.0;
        if self.riders.iter().zip(forces).any(unheard) {
            return Err(refuse("forces", "a force for a rider without actuator"));
        }
        Ok(())
    }

    /// The step itself.
    fn take(&mut self) -> Result<(), CoreError> {
        let parts = self.parts.take().ok_or_else(lost)?;
        let mut run = parts.run(&self.p, &self.travel, &self.plan, &self.riders);
        let mut taken = run.step(STEP, None);
        if taken.is_ok() && self.steps.is_multiple_of(OBSERVE_EVERY) {
            taken = run.check_finite(STEP);
        }
        self.parts = Some(Parts::of(run));
        taken
    }
}

/// Whether an actuator is one of a loop: asked in every step, without delay.
pub(super) fn is_direct(actuator: &Actuator) -> bool {
    actuator.every == 1 && actuator.delay == 0
}
