//! The state of a run: what a step changes, and nothing else.

use crate::constraint::contacts::Contacts;
use crate::constraint::problem::ConstraintProblem;
use crate::error::CoreError;
use crate::integrator::WireState;
use crate::integrator::prepared::WireModel;
use crate::pantograph::system::PantographState;
use crate::simulation::model::Model;
use crate::simulation::recording::recorder::Recorder;

/// State between two steps. A copy of it goes on as the original does, bit for bit.
#[derive(Debug, Clone)]
pub struct State<const DIM: usize, const D: usize> {
    /// The line formed at its present position, with updated kinematics.
    pub(crate) present: Option<Box<WireModel<DIM, D>>>,
    pub(crate) motion: Motion<DIM, D>,
    /// Records of the run; `None` where nothing is recorded.
    pub(crate) recorder: Option<Recorder<DIM, D>>,
}

/// Motion of line and riders, and the forces between them.
#[derive(Debug, Clone)]
pub struct Motion<const DIM: usize, const D: usize> {
    /// Steps done.
    pub(crate) steps: usize,
    pub(crate) line: WireState<D>,
    pub(crate) riders: Vec<PantographState>,
    /// Displacements of the riders at the start, m.
    pub(crate) start_u: Vec<Vec<f64>>,
    pub(crate) contacts: Contacts<DIM>,
    pub(crate) unilateral: ConstraintProblem,
    /// Friction force along the wire at each contact, N.
    pub(crate) friction: Vec<f64>,
    /// Gap of each contact without contact forces, m.
    pub(crate) gaps: Vec<f64>,
    /// Height that strips count from, m.
    pub(crate) datum: f64,
    /// Whether islands that nothing has reached are left out of the steps: not where forces on nodes
    /// are given, nor with updated kinematics.
    pub(crate) may_sleep: bool,
}

impl<const DIM: usize, const D: usize> State<DIM, D> {
    /// Steps done.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.motion.steps
    }

    /// Force of each contact (strip on a lane) in the last step, N.
    #[must_use]
    pub fn contact_forces(&self) -> &[f64] {
        &self.motion.unilateral.force
    }

    /// Displacements of a rider, m.
    #[must_use]
    pub fn rider_displacement(&self, rider: usize) -> &[f64] {
        &self.motion.riders[rider].u
    }
}

impl<const DIM: usize, const D: usize> Motion<DIM, D> {
    /// Line at rest and undisturbed, riders as they stand, no force anywhere.
    pub(crate) fn at_rest(
        model: &Model<'_, DIM, D>,
        riders: Vec<PantographState>,
        mut contacts: Contacts<DIM>,
        may_sleep: bool,
    ) -> Self {
        let line = model.line;
        contacts.respond(&riders);
        let (count, links) = (contacts.all.len(), line.line.links.len());
        Self {
            steps: 0,
            line: line.at_rest(vec![[0.0; D]; line.line.nodes()]),
            start_u: riders.iter().map(|r| r.u.clone()).collect(),
            unilateral: ConstraintProblem::new(count, vec![0.0; links]),
            friction: vec![0.0; count],
            gaps: vec![0.0; count],
            datum: 0.0,
            may_sleep: may_sleep && line.may_sleep(),
            riders,
            contacts,
        }
    }

    /// Refuse a motion that is not finite.
    ///
    /// # Errors
    /// [`CoreError::NotFinite`].
    pub(crate) fn check_finite(&self) -> Result<(), CoreError> {
        let mut riders = self.riders.iter().flat_map(|r| &r.u);
        let finite = self.line.is_finite() && riders.all(|v| v.is_finite());
        if finite && self.unilateral.force.iter().all(|v| v.is_finite()) {
            return Ok(());
        }
        Err(CoreError::NotFinite {
            what: "the motion",
            step: self.steps,
        })
    }
}
