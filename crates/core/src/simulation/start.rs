//! The state at the start of a run.

use crate::constraint::contacts::Contacts;
use crate::error::CoreError;
use crate::pantograph::equilibrium::Rest;
use crate::pantograph::system::{Pantograph, PantographState};
use crate::simulation::initial_equilibrium::Start;
use crate::simulation::model::Model;
use crate::simulation::state::{Motion, State};

impl<const DIM: usize, const D: usize> State<DIM, D> {
    /// Static equilibrium of the line and the riders, the first of them at a position (m), with the
    /// speed at the start (m/s). Nothing sleeps yet, and nothing is recorded. `may_sleep`: whether
    /// islands that no rider has reached may be left out of steps, which loads on nodes forbid.
    ///
    /// # Errors
    /// [`CoreError::Input`], [`CoreError::OffWire`], or any error of the equilibrium.
    pub fn standing(
        model: &Model<'_, DIM, D>,
        (position, speed): (f64, f64),
        may_sleep: bool,
    ) -> Result<Self, CoreError> {
        let (line, riders) = (model.line, model.riders);
        riders.iter().try_for_each(Pantograph::check)?;
        let mut start = Start::new(model, position, speed)?;
        let found = start.settle()?;
        let stand = |(j, rider): (usize, &Pantograph)| {
            let Rest { u, preload, .. } = start.stand(j, &found)?;
            PantographState::standing(rider.clone(), &line.coefficients, (u, preload))
        };
        let states = riders.iter().enumerate().map(stand);
        let states = states.collect::<Result<Vec<_>, _>>()?;
        let mut motion = Motion::at_rest(model, states, start.contacts, may_sleep);
        for (&i, force) in motion.contacts.active.iter().zip(start.forces) {
            motion.unilateral.force[i] = force;
        }
        motion.unilateral.correction = found.correction;
        motion.datum = start.datum;
        motion.line = line.at_rest(found.u);
        Ok(Self {
            present: line.present(&start.lanes),
            motion,
            recorder: None,
        })
    }

    /// A state into which a saved one is to be put back: nothing moves or presses.
    ///
    /// # Errors
    /// [`CoreError::Input`].
    pub(crate) fn blank(model: &Model<'_, DIM, D>, may_sleep: bool) -> Result<Self, CoreError> {
        let (line, riders) = (model.line, model.riders);
        riders.iter().try_for_each(Pantograph::check)?;
        let stand = |rider: &Pantograph| {
            let nowhere = (vec![0.0; rider.size()], 0.0);
            PantographState::standing(rider.clone(), &line.coefficients, nowhere)
        };
        let states = riders.iter().map(stand).collect::<Result<Vec<_>, _>>()?;
        let contacts = Contacts::blank(riders, model.distances, line.lanes.len());
        // With updated kinematics the first step forms everything that moves anew.
        Ok(Self {
            present: line.present(&line.lanes),
            motion: Motion::at_rest(model, states, contacts, may_sleep),
            recorder: None,
        })
    }
}
