//! Steps of a session with given strips.

use crate::error::CoreError;
use crate::pantograph::model::Pantograph;
use crate::session::Session;

impl<const DIM: usize, const D: usize> Session<DIM, D> {
    /// Takes a step that ends at `position` (m) with `speed` (m/s), where strips are given.
    /// `heights` are those of all coordinates of all pantographs at the end of the step if nothing
    /// presses during it, above the rail, m; `compliance` has the matrix of each pantograph, m/N,
    /// row by row, one after the other. Zeros hold the strips at their heights.
    ///
    /// Allocations and failures as in [`Session::step`].
    ///
    /// # Errors
    /// [`CoreError::Input`], or any [`CoreError`] that a step can raise.
    pub fn step_strips(
        &mut self,
        heights: &[f64],
        compliance: &[f64],
        position: f64,
        speed: f64,
    ) -> Result<(), CoreError> {
        if !position.is_finite() || !speed.is_finite() {
            return Err(CoreError::invalid("position", "not finite"));
        }
        let sizes = self.model.pantographs.iter().map(Pantograph::size);
        let counts = [heights.len(), compliance.len()];
        let expected = sizes.fold([0, 0], |[n, squares], size| {
            [n + size, squares + size * size]
        });
        if !self.has_strips() || counts != expected {
            let reason = format!("{counts:?} heights and compliances, expected {expected:?}");
            return Err(CoreError::invalid("strips", reason));
        }
        let (mut heights, mut compliance) = (heights, compliance);
        for number in 0..self.model.pantographs.len() {
            let size = self.model.pantographs[number].size();
            let (own, others) = heights.split_at(size);
            let (matrix, other_matrices) = compliance.split_at(size * size);
            let set = self.state.motion.set_external(number, own, matrix);
            set.map_err(|reason| {
                CoreError::invalid("strips", format!("pantograph {number}: {reason}"))
            })?;
            (heights, compliance) = (others, other_matrices);
        }
        self.take_step(&[], position, speed)
    }

    /// Returns whether strips are given.
    pub(crate) fn has_strips(&self) -> bool {
        self.model.pantographs.iter().any(|p| p.is_external)
    }
}
