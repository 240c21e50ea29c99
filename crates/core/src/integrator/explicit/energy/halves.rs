//! Places half a step after the last one, node by node.

use crate::integrator::explicit::simd::rows::place;
use crate::integrator::explicit::{Explicit, Grid};

impl<const DIM: usize> Explicit<DIM> {
    /// z of a node before the step that has been found, and how far it moves in it: see above.
    pub(crate) fn halves(&self, grid: &Grid, node: usize) -> [[f64; 2]; DIM] {
        let slot = self.points[node];
        let ((row, lane), [a, b]) = (place(slot), self.along[slot].masters);
        let mut found = [[0.0; 2]; DIM];
        let of = |m: usize| {
            let (x, d) = (grid.x[0][m], grid.x[1][m]);
            let more = self.masters.inverse[m] * grid.pull[m] - self.masters.damping[m] * d;
            [x - 0.5 * d, d + 0.5 * more]
        };
        let (first, second, share) = (of(a), of(b), self.along[slot].share);
        found[0] = [0, 1].map(|k| (1.0 - share) * first[k] + share * second[k]);
        for (across, rows) in grid.moving.iter().enumerate() {
            let a = self.acceleration(across, slot, rows);
            let (s, d) = (rows[row].s[lane], rows[row].d[lane]);
            let z = s - (self.damped[row].lag[lane] + 0.5) * d;
            found[across + 1] = [z, d + 0.5 * a];
        }
        found
    }
}
