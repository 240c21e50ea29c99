//! The line at rest under contact forces, for the start of a run.

use crate::constraint::contacts::Contacts;
use crate::error::CoreError;
use crate::integrator::updated_geometry::{UpdatedGeometry, move_slidelines};
use crate::integrator::wire_model::{Integrator, WireModel};
use crate::linear::static_response::{StaticSolver, StaticState};
use crate::slideline::Slideline;

/// Static solver of a line with the kinematics of its steps.
pub(crate) enum StaticLine<'a, const DIM: usize, const D: usize> {
    /// Linearised about the equilibrium without contact forces.
    Linear(Box<StaticSolver<'a, DIM, D>>),
    /// Geometry formed at every position, with slidelines at rest.
    Updated(&'a UpdatedGeometry<DIM, D>, &'a [Slideline<DIM>]),
}

impl<'a, const DIM: usize, const D: usize> StaticLine<'a, DIM, D> {
    /// # Errors
    /// [`CoreError::Singular`] when the line is loose.
    pub fn new(wires: &'a WireModel<DIM, D>) -> Result<Self, CoreError> {
        Ok(match &wires.integrator {
            Integrator::UpdatedGeometry(_, geometry) => Self::Updated(geometry, &wires.slidelines),
            _ => Self::Linear(Box::new(wires.static_solver()?)),
        })
    }

    /// Finds the static state of the line under forces (N) of the active contacts, the first
    /// pantograph at `position` (m). Slidelines and contacts follow it where it moves along the
    /// track.
    ///
    /// # Errors
    /// Those of the equilibrium.
    pub fn solve(
        &mut self,
        slidelines: &mut [Slideline<DIM>],
        contacts: &mut Contacts<DIM>,
        (position, forces): (f64, &[f64]),
    ) -> Result<StaticState<D>, CoreError> {
        match self {
            Self::Linear(solver) => {
                let points = contacts.active().map(|c| (c.point, c.compliance));
                solver.solve_with_compliance(&points.collect::<Vec<_>>(), forces)
            }
            Self::Updated(geometry, at_rest) => {
                let state = geometry.find_equilibrium(at_rest, contacts, position, forces)?;
                move_slidelines(slidelines, &state.u);
                contacts.relocate(slidelines, position);
                Ok(state)
            }
        }
    }
}
