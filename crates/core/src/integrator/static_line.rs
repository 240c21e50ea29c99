//! The line at rest under contact forces, for the start of a run.

use crate::constraint::contacts::Contacts;
use crate::error::CoreError;
use crate::integrator::Integrator;
use crate::integrator::prepared::WireModel;
use crate::integrator::updated_geometry::{UpdatedGeometry, follow};
use crate::linear::static_response::{StaticSolver, StaticState};
use crate::slideline::Slideline;

/// Static solver of a line, with the kinematics of its steps.
pub(crate) enum StaticLine<'a, const DIM: usize, const D: usize> {
    /// Linearised about the equilibrium without contact forces.
    Linear(Box<StaticSolver<'a, DIM, D>>),
    /// Formed at every position, with lanes at rest.
    Updated(&'a UpdatedGeometry<DIM, D>, &'a [Slideline<DIM>]),
}

impl<'a, const DIM: usize, const D: usize> StaticLine<'a, DIM, D> {
    /// # Errors
    /// [`CoreError::Singular`] when the line is loose.
    pub fn new(p: &'a WireModel<DIM, D>) -> Result<Self, CoreError> {
        Ok(match &p.integrator {
            Integrator::UpdatedGeometry(_, now) => Self::Updated(now, &p.lanes),
            _ => Self::Linear(Box::new(StaticSolver::of(p)?)),
        })
    }

    /// Line under forces (N) of the active contacts, the first rider at `position` (m). Lanes and
    /// contacts follow it where it moves along the track.
    ///
    /// # Errors
    /// Those of the equilibrium.
    pub fn press(
        &mut self,
        lanes: &mut [Slideline<DIM>],
        contacts: &mut Contacts<DIM>,
        (position, forces): (f64, &[f64]),
    ) -> Result<StaticState<D>, CoreError> {
        match self {
            Self::Linear(still) => {
                let places = contacts.active().map(|c| (c.place, c.yields));
                still.press(&places.collect::<Vec<_>>(), forces)
            }
            Self::Updated(now, at_rest) => {
                let found = now.equilibrium(at_rest, contacts, position, forces)?;
                follow(lanes, &found.u);
                contacts.follow(lanes, position);
                Ok(found)
            }
        }
    }
}
