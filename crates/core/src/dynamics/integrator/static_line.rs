//! The line at rest under contact forces, for the start of a run.

use super::Integrator;
use super::updated_geometry::{UpdatedGeometry, follow};
use crate::dynamics::contacts::Contacts;
use crate::dynamics::path::Path;
use crate::dynamics::stepper::Prepared;
use crate::dynamics::still::{Still, StillState};
use crate::error::CoreError;

/// Static solver of a line, with the kinematics of its steps.
pub(in crate::dynamics) enum StaticLine<'a, const DIM: usize, const D: usize> {
    /// Linearised about the equilibrium without contact forces.
    Linear(Box<Still<'a, DIM, D>>),
    /// Formed at every position, with lanes at rest.
    Updated(&'a UpdatedGeometry<DIM, D>, &'a [Path<DIM>]),
}

impl<'a, const DIM: usize, const D: usize> StaticLine<'a, DIM, D> {
    /// # Errors
    /// [`CoreError::Singular`] when the line is loose.
    pub fn new(p: &'a Prepared<DIM, D>) -> Result<Self, CoreError> {
        Ok(match &p.integrator {
            Integrator::UpdatedGeometry(_, now) => Self::Updated(now, &p.lanes),
            _ => Self::Linear(Box::new(Still::of(p)?)),
        })
    }

    /// Line under forces (N) of the active contacts, the first rider at `position` (m). Lanes and
    /// contacts follow it where it moves along the track.
    ///
    /// # Errors
    /// Those of the equilibrium.
    pub fn press(
        &mut self,
        lanes: &mut [Path<DIM>],
        contacts: &mut Contacts<DIM>,
        (position, forces): (f64, &[f64]),
    ) -> Result<StillState<D>, CoreError> {
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
