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
use super::loads::Load;
use super::path::Path;
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

    /// Step length, s.
    #[must_use]
    pub fn step_length(&self) -> f64 {
        self.p.h
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

    /// Put on the forces of the step.
    fn push(&mut self, forces: &[f64]) -> Result<(), CoreError> {
        let Some(parts) = &mut self.parts else {
            return Err(lost());
        };
        for (rider, force) in parts.riders.iter_mut().zip(forces) {
            rider.actuator.force = *force;
        }
        parts.check_end(&self.p.lanes, self.travel.positions[STEP + 1])?;
        let old = self.p.coefficients.old;
        let x = &self.travel.positions;
        let balance = (1.0 - old) * x[STEP + 1] + old * x[STEP];
        for (number, collector) in self.collectors.iter().enumerate() {
            let (lane, near) = (&self.p.lanes[0], self.places[number].element);
            let along = balance - collector.behind;
            let place = locate(lane, along, near, number)?;
            // The step must not carry it off the wire either.
            locate(lane, x[STEP + 1] - collector.behind, place.element, number)?;
            let lateral = place.lateral + aside::<DIM, D>(&place, &parts.state.u);
            if lateral.abs() > collector.half_width {
                return Err(CoreError::OutOfReach {
                    rider: number,
                    position: along,
                    lateral,
                    half_width: collector.half_width,
                    step: STEP,
                });
            }
            let load = &mut self.travel.loads[number];
            press::<DIM, D>(load, &place, self.travel.friction, forces[number]);
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

/// The wire at a collector, by its number.
pub(super) fn locate<const DIM: usize>(
    lane: &Path<DIM>,
    position: f64,
    near: usize,
    number: usize,
) -> Result<Place<DIM>, CoreError> {
    lane.locate(position, near).ok_or(CoreError::OffWire {
        rider: number,
        position,
        step: STEP,
    })
}

/// Displacement of the wire to the side, m.
pub(super) fn aside<const DIM: usize, const D: usize>(place: &Place<DIM>, u: &[[f64; D]]) -> f64 {
    if DIM < 3 {
        0.0
    } else {
        place.displacement(u, 1)
    }
}

/// Let a load be a force F upwards at a place, with the friction μ F along.
fn press<const DIM: usize, const D: usize>(
    load: &mut Load,
    place: &Place<DIM>,
    friction: f64,
    force: f64,
) {
    load.sizes.fill(force);
    let up = place.shares::<D>(DIM - 1);
    let along = place
        .shares::<D>(0)
        .map(|(n, c, share)| (n, c, friction * share));
    for (part, new) in load.pattern.iter_mut().zip(up.chain(along)) {
        *part = new;
    }
}

/// Whether an actuator is one of a loop: asked in every step, without delay.
pub(super) fn is_direct(actuator: &Actuator) -> bool {
    actuator.every == 1 && actuator.delay == 0
}
