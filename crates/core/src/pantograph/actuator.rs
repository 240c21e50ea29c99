//! A force on a rider that someone else decides on, sample by sample.
//!
//! At the start of every n-th step the outside is asked for a force, with the state of the rider there. It
//! acts from `delay` steps later on, and until the next one does: within a step it is constant, so its
//! work is force times increment, exactly. Before the first one acts there is none.

use crate::error::CoreError;
use std::collections::VecDeque;

/// Most steps of delay: more than any run has, and still a number of a step when added to one.
const LONGEST_DELAY: usize = u32::MAX as usize;

/// Where a controlled force acts and when it is asked for.
#[derive(Debug, Clone)]
pub struct Actuator {
    /// Where it acts: force = direction · value.
    pub direction: Vec<f64>,
    /// Steps from one sample to the next.
    pub every: usize,
    /// Steps from a sample until its force acts.
    pub delay: usize,
}

impl Actuator {
    pub(crate) fn is_sound(&self, n: usize) -> bool {
        let finite = self.direction.iter().all(|v| v.is_finite());
        self.direction.len() == n && finite && self.every > 0 && self.delay <= LONGEST_DELAY
    }
}

/// What is measured at a sample, at the start of a step.
#[derive(Debug, Clone)]
pub struct Sample {
    /// Number of the sample, from 0.
    pub number: usize,
    /// Time, s.
    pub time: f64,
    /// Position of the rider along the track, m.
    pub position: f64,
    /// Speed along the track, m/s.
    pub speed: f64,
    /// Contact force of the step before (of the start, in the first), N.
    pub force: f64,
    /// Displacements of the rider since the start, m.
    pub displacements: Vec<f64>,
    /// Velocities of the rider, m/s.
    pub velocities: Vec<f64>,
}

/// Asked for the force of a rider, by its number; answers with a reason when there is none.
pub type Ask<'a> = &'a mut dyn FnMut(usize, &Sample) -> Result<f64, String>;

/// An actuator during a run.
#[derive(Debug, Clone, Default)]
pub(crate) struct ActuatorState {
    /// Forces that were asked for and do not act yet, with the step from which they do.
    pub(crate) waiting: VecDeque<(usize, f64)>,
    /// Force that acts, N.
    pub(crate) force: f64,
}

impl ActuatorState {
    /// Before a step: take a new force when a sample is due, and put on what has become due.
    ///
    /// # Errors
    /// What `ask` says, or [`CoreError::Control`] when the force is not finite.
    pub(crate) fn begin(
        &mut self,
        actuator: &Actuator,
        step: usize,
        ask: impl FnOnce(usize) -> Result<f64, CoreError>,
    ) -> Result<(), CoreError> {
        if step.is_multiple_of(actuator.every) {
            let force = ask(step / actuator.every)?;
            self.waiting.push_back((step + actuator.delay, force));
        }
        while let Some(&(due, force)) = self.waiting.front()
            && due <= step
        {
            self.force = force;
            self.waiting.pop_front();
        }
        Ok(())
    }
}
