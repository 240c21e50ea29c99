//! Motion of line and pantographs between two steps, and the forces between them.

use crate::constraint::contacts::Contacts;
use crate::constraint::problem::ConstraintProblem;
use crate::error::CoreError;
use crate::integrator::state::WireState;
use crate::pantograph::state::PantographState;
use crate::simulation::model::Model;

/// Motion of line and pantographs, and the forces between them.
#[derive(Debug, Clone)]
pub struct Motion<const DIM: usize, const D: usize> {
    /// Number of steps done.
    pub(crate) steps: usize,
    pub(crate) wires: WireState<D>,
    pub(crate) pantographs: Vec<PantographState>,
    /// Displacements of the pantographs at the start, m.
    pub(crate) start_u: Vec<Vec<f64>>,
    pub(crate) contacts: Contacts<DIM>,
    pub(crate) problem: ConstraintProblem,
    /// Friction force along the wire at each contact, N.
    pub(crate) friction: Vec<f64>,
    /// Gap of each contact without contact forces, m.
    pub(crate) gaps: Vec<f64>,
    /// Datum of the heights of strips, m.
    pub(crate) datum: f64,
    /// True when islands that nothing has reached are left out of the steps: not with prescribed
    /// forces on nodes, nor with updated kinematics.
    pub(crate) may_sleep: bool,
}

impl<const DIM: usize, const D: usize> Motion<DIM, D> {
    /// Returns the undisturbed line at rest with pantographs at rest, without forces.
    pub(crate) fn at_rest(
        model: &Model<'_, DIM, D>,
        pantographs: Vec<PantographState>,
        mut contacts: Contacts<DIM>,
        may_sleep: bool,
    ) -> Self {
        let wires = model.wires;
        contacts.compute_columns(&pantographs);
        let (count, links) = (contacts.all.len(), wires.line.links.len());
        Self {
            steps: 0,
            wires: wires.at_rest(vec![[0.0; D]; wires.line.nodes()]),
            start_u: pantographs.iter().map(|r| r.u.clone()).collect(),
            problem: ConstraintProblem::new(count, vec![0.0; links]),
            friction: vec![0.0; count],
            gaps: vec![0.0; count],
            datum: 0.0,
            may_sleep: may_sleep && wires.may_sleep(),
            pantographs,
            contacts,
        }
    }

    /// Refuses a motion that is not finite.
    ///
    /// # Errors
    /// [`CoreError::NotFinite`].
    pub(crate) fn check_finite(&self) -> Result<(), CoreError> {
        let mut pantographs = self.pantographs.iter().flat_map(|r| &r.u);
        let finite = self.wires.is_finite() && pantographs.all(|v| v.is_finite());
        if finite && self.problem.force.iter().all(|v| v.is_finite()) {
            return Ok(());
        }
        Err(CoreError::NotFinite {
            what: "the motion",
            step: self.steps,
        })
    }
}
