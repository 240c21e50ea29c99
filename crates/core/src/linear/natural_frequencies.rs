//! Natural frequencies of a line at rest.

use crate::error::CoreError;
use crate::linalg::{BlockLdl, lanczos};
use crate::linear::model::LinearModel;
use crate::slideline::point::SlidelinePoint;

/// Largest number of natural frequencies computed at once: each one takes up to thirty vectors, and
/// time grows with the square of their number.
const MOST_FREQUENCIES: usize = 1000;

impl<const DIM: usize, const D: usize> LinearModel<DIM, D> {
    /// Returns the `count` lowest natural frequencies, Hz, ascending, each as often as its
    /// multiplicity. Links that are slack at rest are left out.
    ///
    /// # Errors
    /// [`CoreError::Singular`] when the line is loose.
    pub fn frequencies(&self, count: usize) -> Result<Vec<f64>, CoreError> {
        self.frequencies_while(count, &mut || true)
    }

    /// Returns the `count` lowest natural frequencies, Hz, and ends early when `go_on`, which is
    /// called now and then, returns `false`.
    ///
    /// # Errors
    /// As [`LinearModel::frequencies`]; [`CoreError::Input`] for more than a thousand;
    /// [`CoreError::Cancelled`].
    pub fn frequencies_while(
        &self,
        count: usize,
        go_on: &mut dyn FnMut() -> bool,
    ) -> Result<Vec<f64>, CoreError> {
        if count > MOST_FREQUENCIES {
            let reason = format!("{count} frequencies, at most {MOST_FREQUENCIES}");
            let array = "count";
            return Err(CoreError::Input { array, reason });
        }
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
        lanczos::lowest_frequencies(&factor, mass, nodes, free, count, below, go_on)
            .ok_or(CoreError::Cancelled { step: 0 })
    }

    /// Finds the modes that a vertical force of 1 N excites, shared alike by `points`: Lanczos'
    /// process that starts from the displacement under it. Links that are slack at rest are left
    /// out.
    ///
    /// # Errors
    /// [`CoreError::Singular`] when the line is loose.
    pub fn modes_moved(
        &self,
        points: &[SlidelinePoint<DIM>],
        steps: usize,
    ) -> Result<lanczos::Recurrence, CoreError> {
        let k = self.stiffness_at_rest();
        let factor = BlockLdl::new(&k.unwrap_or_else(|| self.combine(0.0, 0.0, 1.0)))?;
        let (mut start, mut scratch) = (self.zeros(), self.zeros());
        for point in points {
            point.add_force(1.0 / points.len() as f64, DIM - 1, &mut start);
        }
        self.mask(&mut start);
        factor.solve(&mut start, &mut scratch);
        let free = |i: usize, c: usize| self.free[i][c];
        Ok(lanczos::recurrence_from(
            &factor, &self.mass, free, start, steps,
        ))
    }

    fn zeros(&self) -> Vec<[f64; D]> {
        vec![[0.0; D]; self.nodes()]
    }
}
