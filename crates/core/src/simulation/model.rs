//! The model of a run, which nothing changes: a line ready for steps, and the riders on it.

use crate::integrator::prepared::WireModel;
use crate::pantograph::system::Pantograph;

/// Line and riders of a run, borrowed. Steps read it and write to a [`State`](crate::simulation::state::State).
#[derive(Debug, Clone, Copy)]
pub struct Model<'a, const DIM: usize, const D: usize> {
    /// Line ready for steps.
    pub line: &'a WireModel<DIM, D>,
    /// Riders as they were given.
    pub riders: &'a [Pantograph],
    /// Distance of each rider behind the first, m.
    pub distances: &'a [f64],
    /// Coefficient of friction along the wire.
    pub friction: f64,
}

impl<'a, const DIM: usize, const D: usize> Model<'a, DIM, D> {
    /// Model with the line where it is: with updated kinematics the state owns one, formed at its
    /// present position.
    pub(crate) fn at(self, present: Option<&'a WireModel<DIM, D>>) -> Self {
        Self {
            line: present.unwrap_or(self.line),
            ..self
        }
    }
}
