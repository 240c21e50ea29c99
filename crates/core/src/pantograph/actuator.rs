//! Actuator: a force on a pantograph that a controller outside decides on, sample by sample.
//!
//! At the start of every n-th step the controller is called with the state of the pantograph there.
//! Its force acts from `delay` steps later on, until the next one does: within a step it is
//! constant, so its work is force times increment, exactly. Before the first force acts there is
//! none.

use crate::error::CoreError;
use std::collections::VecDeque;

/// Largest delay, steps: more than any run has; added to the number of a step it does not overflow.
const LONGEST_DELAY: usize = u32::MAX as usize;

/// Actuator of a pantograph: where its force acts and when it is sampled.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Actuator {
    /// Direction: force on the coordinates = direction · value.
    pub direction: Vec<f64>,
    /// Steps from one sample to the next.
    pub every: usize,
    /// Steps from a sample until its force acts.
    pub delay: usize,
}

impl Actuator {
    /// Tells whether sizes and numbers fit a pantograph of `n` coordinates.
    pub(crate) fn is_valid(&self, n: usize) -> bool {
        let finite = self.direction.iter().all(|v| v.is_finite());
        self.direction.len() == n && finite && self.every > 0 && self.delay <= LONGEST_DELAY
    }
}

/// Measurements of a sample, at the start of a step.
#[derive(Debug, Clone)]
pub struct Sample {
    /// Number of the sample, from 0.
    pub number: usize,
    /// Time, s.
    pub time: f64,
    /// Position of the pantograph along the track, m.
    pub position: f64,
    /// Speed along the track, m/s.
    pub speed: f64,
    /// Contact force of the step before (of the start, in the first), N.
    pub force: f64,
    /// Displacements of the pantograph since the start, m.
    pub displacements: Vec<f64>,
    /// Velocities of the pantograph, m/s.
    pub velocities: Vec<f64>,
}

/// Callback for the force of a pantograph, given by its number; a reason when there is none.
pub type Controller<'a> = &'a mut dyn FnMut(usize, &Sample) -> Result<f64, String>;

/// Actuator during a run.
#[derive(Debug, Clone, Default)]
pub(crate) struct ActuatorState {
    /// Forces sampled that do not act yet, with the step from which they do.
    pub(crate) pending: VecDeque<(usize, f64)>,
    /// Force acting, N.
    pub(crate) force: f64,
}

impl ActuatorState {
    /// Updates the force before a step: samples when a sample is due, and applies the force that
    /// has become due.
    ///
    /// # Errors
    /// Errors of `sample`, or [`CoreError::Control`] when the force is not finite.
    pub(crate) fn update(
        &mut self,
        actuator: &Actuator,
        step: usize,
        sample: impl FnOnce(usize) -> Result<f64, CoreError>,
    ) -> Result<(), CoreError> {
        if step.is_multiple_of(actuator.every) {
            let force = sample(step / actuator.every)?;
            self.pending.push_back((step + actuator.delay, force));
        }
        while let Some(&(due, force)) = self.pending.front()
            && due <= step
        {
            self.force = force;
            self.pending.pop_front();
        }
        Ok(())
    }
}
