//! Natural frequencies of a line at rest.

use super::line::Line;
use crate::error::CoreError;
use crate::linalg::{BlockLdl, lanczos};

impl<const DIM: usize, const D: usize> Line<DIM, D> {
    /// The `count` lowest natural frequencies in Hz, ascending, each as often as it occurs. Links
    /// that are slack at rest take no part.
    ///
    /// # Errors
    /// [`CoreError::Singular`] when the line is loose.
    pub fn frequencies(&self, count: usize) -> Result<Vec<f64>, CoreError> {
        let all = || self.combine(0.0, 0.0, 1.0);
        let k = self.stiffness_at_rest().unwrap_or_else(all);
        let below = |square: f64| {
            let mut shifted = k.clone();
            self.mass.add_to(-square, &mut shifted);
            shifted.keep_free(&self.free);
            let factor = BlockLdl::new(&shifted).ok()?;
            Some(factor.negative_pivots())
        };
        let (factor, free) = (BlockLdl::new(&k)?, |i: usize, c: usize| self.free[i][c]);
        let (mass, nodes) = (&self.mass, self.nodes());
        Ok(lanczos::lowest_frequencies(
            &factor, mass, nodes, free, count, below,
        ))
    }
}
