//! Samples of a run: what is measured, and the force that is answered.

use super::actuator::{Ask, Sample};
use super::model::Model;
use super::state::Motion;
use crate::error::CoreError;

impl<const DIM: usize, const D: usize> Motion<DIM, D> {
    /// Before a step: ask for the forces of all actuators that are due for a sample, with the first
    /// rider at a position (m) and speed (m/s).
    ///
    /// # Errors
    /// [`CoreError::Control`].
    pub(super) fn control(
        &mut self,
        model: &Model<'_, DIM, D>,
        (position, speed): (f64, f64),
        ask: Ask<'_>,
    ) -> Result<(), CoreError> {
        let step = self.steps;
        for j in 0..self.riders.len() {
            let Some(actuator) = self.riders[j].rider.actuator.clone() else {
                continue;
            };
            let mut state = std::mem::take(&mut self.riders[j].actuator);
            let answered = state.begin(&actuator, step, |number| {
                let sample = self.sample(model, (position, speed), (j, number));
                let answer = ask(j, &sample).and_then(|force| {
                    let finite = force.is_finite().then_some(force);
                    finite.ok_or_else(|| format!("the force is {force}"))
                });
                answer.map_err(|reason| CoreError::Control {
                    rider: j,
                    step,
                    time: sample.time,
                    position: sample.position,
                    reason,
                })
            });
            self.riders[j].actuator = state;
            answered?;
        }
        Ok(())
    }

    /// Sum over the contacts of a rider, N.
    fn rider_force(&self, j: usize) -> f64 {
        let forces = self.contacts.all.iter().zip(&self.unilateral.force);
        let own = forces.filter(|(contact, _)| contact.rider() == j);
        own.map(|(_, force)| force).sum()
    }

    fn sample(
        &self,
        model: &Model<'_, DIM, D>,
        (position, speed): (f64, f64),
        (j, number): (usize, usize),
    ) -> Sample {
        let rider = &self.riders[j];
        let moved = rider.u.iter().zip(&self.start_u[j]);
        Sample {
            number,
            time: self.steps as f64 * model.line.h,
            position: position - model.distances[j],
            speed,
            force: self.rider_force(j),
            displacements: moved.map(|(u, start)| u - start).collect(),
            velocities: rider.v.clone(),
        }
    }
}
