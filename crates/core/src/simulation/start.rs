//! State at the start of a run.

use crate::constraint::contacts::Contacts;
use crate::error::CoreError;
use crate::pantograph::equilibrium::PantographEquilibrium;
use crate::pantograph::model::Pantograph;
use crate::pantograph::state::PantographState;
use crate::simulation::initial_equilibrium::InitialEquilibrium;
use crate::simulation::model::Model;
use crate::simulation::motion::Motion;
use crate::simulation::state::State;

impl<const DIM: usize, const D: usize> State<DIM, D> {
    /// Returns the static equilibrium of line and pantographs, the first of them at a position (m),
    /// with the speed at the start (m/s). Nothing sleeps yet, and nothing is recorded. `may_sleep`:
    /// whether islands that no pantograph has reached may be left out of steps, which loads on
    /// nodes forbid.
    ///
    /// # Errors
    /// [`CoreError::Input`], [`CoreError::OffWire`], or any error of the equilibrium.
    pub fn in_equilibrium(
        model: &Model<'_, DIM, D>,
        (position, speed): (f64, f64),
        may_sleep: bool,
    ) -> Result<Self, CoreError> {
        let (wires, pantographs) = (model.wires, model.pantographs);
        pantographs.iter().try_for_each(Pantograph::check)?;
        let mut start = InitialEquilibrium::new(model, position, speed)?;
        let wires_at_rest = start.find_equilibrium()?;
        let pantograph_state = |(j, pantograph): (usize, &Pantograph)| {
            let PantographEquilibrium { u, preload, .. } =
                start.pantograph_equilibrium(j, &wires_at_rest)?;
            PantographState::in_equilibrium(pantograph.clone(), &wires.coefficients, (u, preload))
        };
        let states = pantographs.iter().enumerate().map(pantograph_state);
        let states = states.collect::<Result<Vec<_>, _>>()?;
        let mut motion = Motion::at_rest(model, states, start.contacts, may_sleep);
        for (&i, force) in motion.contacts.active.iter().zip(start.forces) {
            motion.problem.force[i] = force;
        }
        motion.problem.correction = wires_at_rest.correction;
        motion.datum = start.datum;
        motion.wires = wires.at_rest(wires_at_rest.u);
        Ok(Self {
            current_geometry: wires.current_geometry(&start.slidelines),
            motion,
            recorder: None,
        })
    }

    /// Returns a state without motion and forces, into which a saved one is restored.
    ///
    /// # Errors
    /// [`CoreError::Input`].
    pub(crate) fn blank(model: &Model<'_, DIM, D>, may_sleep: bool) -> Result<Self, CoreError> {
        let (wires, pantographs) = (model.wires, model.pantographs);
        pantographs.iter().try_for_each(Pantograph::check)?;
        let pantograph_state = |pantograph: &Pantograph| {
            let nowhere = (vec![0.0; pantograph.size()], 0.0);
            PantographState::in_equilibrium(pantograph.clone(), &wires.coefficients, nowhere)
        };
        let states = pantographs
            .iter()
            .map(pantograph_state)
            .collect::<Result<Vec<_>, _>>()?;
        let contacts = Contacts::unplaced(pantographs, model.distances, wires.slidelines.len());
        // With updated kinematics the first step forms the geometry again.
        Ok(Self {
            current_geometry: wires.current_geometry(&wires.slidelines),
            motion: Motion::at_rest(model, states, contacts, may_sleep),
            recorder: None,
        })
    }
}
