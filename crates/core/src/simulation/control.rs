//! Samples of a run for its controllers: measured values, and the force that is returned.

use crate::error::CoreError;
use crate::pantograph::actuator::{Controller, Sample};
use crate::simulation::model::Model;
use crate::simulation::motion::Motion;

impl<const DIM: usize, const D: usize> Motion<DIM, D> {
    /// Before a step: gets the forces of all actuators that are due for a sample, with the first
    /// pantograph at a position (m) and speed (m/s).
    ///
    /// # Errors
    /// [`CoreError::Control`].
    pub(crate) fn control(
        &mut self,
        model: &Model<'_, DIM, D>,
        (position, speed): (f64, f64),
        controller: Controller<'_>,
    ) -> Result<(), CoreError> {
        let step = self.steps;
        for j in 0..self.pantographs.len() {
            let Some(actuator) = self.pantographs[j].model.actuator.clone() else {
                continue;
            };
            let mut state = std::mem::take(&mut self.pantographs[j].actuator);
            let answered = state.update(&actuator, step, |number| {
                let sample = self.sample(model, (position, speed), (j, number));
                let answer = controller(j, &sample).and_then(|force| {
                    let finite = force.is_finite().then_some(force);
                    finite.ok_or_else(|| format!("the force is {force}"))
                });
                answer.map_err(|reason| CoreError::Control {
                    pantograph: j,
                    step,
                    time: sample.time,
                    position: sample.position,
                    reason,
                })
            });
            self.pantographs[j].actuator = state;
            answered?;
        }
        Ok(())
    }

    /// Returns the sum of the contact forces of a pantograph, N.
    fn pantograph_force(&self, j: usize) -> f64 {
        let forces = self.contacts.all.iter().zip(&self.problem.force);
        let forces_of_pantograph = forces.filter(|(contact, _)| contact.pantograph() == j);
        forces_of_pantograph.map(|(_, force)| force).sum()
    }

    fn sample(
        &self,
        model: &Model<'_, DIM, D>,
        (position, speed): (f64, f64),
        (j, number): (usize, usize),
    ) -> Sample {
        let pantograph = &self.pantographs[j];
        let displacements = pantograph.u.iter().zip(&self.start_u[j]);
        Sample {
            number,
            time: self.steps as f64 * model.wires.h,
            position: position - model.distances[j],
            speed,
            force: self.pantograph_force(j),
            displacements: displacements.map(|(u, start)| u - start).collect(),
            velocities: pantograph.v.clone(),
        }
    }
}
