//! State of a run: all data that a step changes.

use crate::integrator::wire_model::WireModel;
use crate::simulation::motion::Motion;
use crate::simulation::recording::recorder::Recorder;

/// State between two steps. A copy of it continues as the original does, bit for bit.
#[derive(Debug, Clone)]
pub struct State<const DIM: usize, const D: usize> {
    /// Line formed at its current position, with updated kinematics.
    pub(crate) current_geometry: Option<Box<WireModel<DIM, D>>>,
    pub(crate) motion: Motion<DIM, D>,
    /// Records of the run; `None` where nothing is recorded.
    pub(crate) recorder: Option<Recorder<DIM, D>>,
}

impl<const DIM: usize, const D: usize> State<DIM, D> {
    /// Returns the number of steps done.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.motion.steps
    }

    /// Returns the force of each contact (strip on a slideline) in the last step, N.
    #[must_use]
    pub fn contact_forces(&self) -> &[f64] {
        &self.motion.problem.force
    }

    /// Returns the displacements of a pantograph, m.
    #[must_use]
    pub fn pantograph_displacement(&self, pantograph: usize) -> &[f64] {
        &self.motion.pantographs[pantograph].u
    }
}
