//! The model of a run, which nothing changes: a line ready for steps, and the riders on it.

use super::rider::Rider;
use super::stepper::Prepared;

/// Line and riders of a run, borrowed. Steps read it and write to a [`State`](super::state::State).
#[derive(Debug, Clone, Copy)]
pub struct Model<'a, const DIM: usize, const D: usize> {
    /// Line ready for steps.
    pub line: &'a Prepared<DIM, D>,
    /// Riders as they were given.
    pub riders: &'a [Rider],
    /// Distance of each rider behind the first, m.
    pub distances: &'a [f64],
    /// Coefficient of friction along the wire.
    pub friction: f64,
}

impl<'a, const DIM: usize, const D: usize> Model<'a, DIM, D> {
    /// Model with the line where it is: with updated kinematics the state owns one, formed at its
    /// present position.
    pub(super) fn at(self, present: Option<&'a Prepared<DIM, D>>) -> Self {
        Self {
            line: present.unwrap_or(self.line),
            ..self
        }
    }
}
