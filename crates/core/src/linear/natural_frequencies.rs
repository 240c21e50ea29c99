//! Natural frequencies of a line at rest.

use crate::error::CoreError;
use crate::linalg::{BlockLdl, lanczos};
use crate::linear::model::LinearModel;
use crate::slideline::point::SlidelinePoint;

/// Most natural frequencies that are looked for at once: each takes up to thirty vectors, and time
/// grows with the square of their number.
const MOST_FREQUENCIES: usize = 1000;

impl<const DIM: usize, const D: usize> LinearModel<DIM, D> {
    /// The `count` lowest natural frequencies in Hz, ascending, each as often as it occurs. Links
    /// that are slack at rest take no part.
    ///
    /// # Errors
    /// [`CoreError::Singular`] when the line is loose.
    pub fn frequencies(&self, count: usize) -> Result<Vec<f64>, CoreError> {
        self.frequencies_while(count, &mut || true)
    }

    /// The same, given up when `go_on`, which is asked now and then, says no.
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

    /// The modes that a vertical force of 1 N moves, shared alike by `places`: Lanczos' process begun
    /// with the displacement under it. Links that are slack at rest take no part.
    ///
    /// # Errors
    /// [`CoreError::Singular`] when the line is loose.
    pub fn modes_moved(
        &self,
        places: &[SlidelinePoint<DIM>],
        steps: usize,
    ) -> Result<lanczos::Recurrence, CoreError> {
        let k = self.stiffness_at_rest();
        let factor = BlockLdl::new(&k.unwrap_or_else(|| self.combine(0.0, 0.0, 1.0)))?;
        let (mut start, mut scratch) = (self.zeros(), self.zeros());
        for place in places {
            place.add_force(1.0 / places.len() as f64, DIM - 1, &mut start);
        }
        self.mask(&mut start);
        factor.solve(&mut start, &mut scratch);
        let free = |i: usize, c: usize| self.free[i][c];
        Ok(lanczos::begun_with(&factor, &self.mass, free, start, steps))
    }

    fn zeros(&self) -> Vec<[f64; D]> {
        vec![[0.0; D]; self.nodes()]
    }
}
