//! Positions half-way between two steps, node by node.

use crate::integrator::explicit::simd::packed::row_and_lane;
use crate::integrator::explicit::{ChainState, Explicit};

impl<const DIM: usize> Explicit<DIM> {
    /// Returns z of a node before the coming step, and its increment in it, m: see
    /// [`energy`](super).
    pub(crate) fn half_step_motion(&self, chain: &ChainState, node: usize) -> [[f64; 2]; DIM] {
        let packed_index = self.points[node];
        let ((row, simd_lane), [a, b]) = (
            row_and_lane(packed_index),
            self.axial_positions[packed_index].masters,
        );
        let mut motion = [[0.0; 2]; DIM];
        let of_master = |m: usize| {
            let (x, d) = (chain.x[0][m], chain.x[1][m]);
            let change =
                self.masters.inverse[m] * chain.master_force[m] - self.masters.damping[m] * d;
            [x - 0.5 * d, d + 0.5 * change]
        };
        let (first, second, share) = (
            of_master(a),
            of_master(b),
            self.axial_positions[packed_index].share,
        );
        motion[0] = [0, 1].map(|k| (1.0 - share) * first[k] + share * second[k]);
        for (direction, rows) in chain.moving.iter().enumerate() {
            let a = self.acceleration(direction, packed_index, rows);
            let (s, d) = (rows[row].s[simd_lane], rows[row].d[simd_lane]);
            let z = s - (self.damping[row].lag[simd_lane] + 0.5) * d;
            motion[direction + 1] = [z, d + 0.5 * a];
        }
        motion
    }
}
