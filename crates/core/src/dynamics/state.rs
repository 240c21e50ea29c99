//! The state of a run: what a step changes, and nothing else.

use super::contact::Unilateral;
use super::contacts::Contacts;
use super::integrator::WireState;
use super::model::Model;
use super::recorder::Recorder;
use super::rider::RiderState;
use super::stepper::Prepared;
use crate::error::CoreError;

/// State between two steps. A copy of it goes on as the original does, bit for bit.
#[derive(Debug, Clone)]
pub struct State<const DIM: usize, const D: usize> {
    /// The line formed at its present position, with updated kinematics.
    pub(super) present: Option<Box<Prepared<DIM, D>>>,
    pub(super) motion: Motion<DIM, D>,
    /// Records of the run; `None` where nothing is recorded.
    pub(super) recorder: Option<Recorder<DIM, D>>,
}

/// Motion of line and riders, and the forces between them.
#[derive(Debug, Clone)]
pub struct Motion<const DIM: usize, const D: usize> {
    /// Steps done.
    pub(super) steps: usize,
    pub(super) line: WireState<D>,
    pub(super) riders: Vec<RiderState>,
    /// Displacements of the riders at the start, m.
    pub(super) start_u: Vec<Vec<f64>>,
    pub(super) contacts: Contacts<DIM>,
    pub(super) unilateral: Unilateral,
    /// Friction force along the wire at each contact, N.
    pub(super) friction: Vec<f64>,
    /// Gap of each contact without contact forces, m.
    pub(super) gaps: Vec<f64>,
    /// Height that strips count from, m.
    pub(super) datum: f64,
    /// Whether islands that nothing has reached are left out of the steps: not where forces on nodes
    /// are given, nor with updated kinematics.
    pub(super) may_sleep: bool,
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
    pub(super) fn at_rest(
        model: &Model<'_, DIM, D>,
        riders: Vec<RiderState>,
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
            unilateral: Unilateral::new(count, vec![0.0; links]),
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
    pub(super) fn check_finite(&self) -> Result<(), CoreError> {
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
