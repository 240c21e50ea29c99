//! Model of a run, which is constant: a line ready for steps, and the pantographs on it.

use crate::integrator::wire_model::WireModel;
use crate::pantograph::model::Pantograph;

/// Line and pantographs of a run, borrowed. Steps read it and write to a
/// [`State`](crate::simulation::state::State).
#[derive(Debug, Clone, Copy)]
pub struct Model<'a, const DIM: usize, const D: usize> {
    /// Line ready for steps.
    pub wires: &'a WireModel<DIM, D>,
    /// Pantographs of the run.
    pub pantographs: &'a [Pantograph],
    /// Distance of each pantograph behind the first, m.
    pub distances: &'a [f64],
    /// Coefficient of friction along the wire.
    pub friction: f64,
}

impl<'a, const DIM: usize, const D: usize> Model<'a, DIM, D> {
    /// Returns the model with the line at its current position: with updated kinematics the state
    /// owns one that is formed there.
    pub(crate) fn with_geometry(self, current_geometry: Option<&'a WireModel<DIM, D>>) -> Self {
        Self {
            wires: current_geometry.unwrap_or(self.wires),
            ..self
        }
    }
}
