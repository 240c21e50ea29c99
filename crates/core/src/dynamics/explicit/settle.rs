//! Forces of links, struts and springs, cluster by cluster.

use super::cluster::{Cluster, WIDEST};
use super::{BETA, Explicit, Grid};
use crate::linalg::Kernel;

/// Adds the forces of the clusters of an island to the grid, and sets the increments of their nodes from
/// `u` before the step.
pub(super) struct Settle<'a, const DIM: usize, const D: usize> {
    pub p: &'a Explicit<DIM>,
    pub island: usize,
    pub grid: &'a mut Grid,
    pub u: &'a [[f64; D]],
    pub delta: &'a mut [[f64; D]],
}

impl<const DIM: usize, const D: usize> Kernel for Settle<'_, DIM, D> {
    #[inline(always)]
    fn run(mut self) {
        let p = self.p;
        for cluster in &p.clusters[p.own[self.island].clusters.clone()] {
            match cluster.width {
                4 => self.settle::<4>(cluster),
                8 => self.settle::<8>(cluster),
                _ => self.settle::<WIDEST>(cluster),
            }
        }
    }
}

impl<const DIM: usize, const D: usize> Settle<'_, DIM, D> {
    /// A cluster whose columns have `N` numbers.
    #[inline(always)]
    fn settle<const N: usize>(&mut self, cluster: &Cluster) {
        let p = self.p;
        let Grid {
            y, d, x, w, pull, ..
        } = &mut *self.grid;
        // The first and the last direction across: the only one, or both.
        let last = DIM - 2;
        let (y, d) = ([&y[0][..], &y[last][..]], [&d[0][..], &d[last][..]]);
        let (mut place, mut force, mut by_speed) = ([0.0; N], [0.0; N], [0.0; N]);
        let mut row = 0;
        let (columns, _) = cluster.columns.as_chunks::<N>();
        for m in &cluster.members {
            for c in 0..DIM {
                let [u, v] = if c == 0 {
                    [m.along.read(&x[0]), p.per_step * m.along.read(&x[1])]
                } else {
                    let a = m.acceleration(c - 1, &w[c - 1]);
                    p.ahead([y[c - 1][m.point], d[c - 1][m.point], a])
                };
                let (of_place, of_speed) = (&columns[2 * row], &columns[2 * row + 1]);
                for k in 0..N {
                    force[k] += of_place[k] * u;
                    by_speed[k] += of_speed[k] * v;
                }
                place[row] = u;
                row += 1;
            }
        }
        for k in 0..N {
            force[k] += by_speed[k];
        }
        let squared = BETA * p.h * p.h;
        let mut row = 0;
        for m in &cluster.members {
            let (u, delta) = (&self.u[m.node], &mut self.delta[m.node]);
            for c in 0..DIM {
                if c == 0 {
                    delta[0] = place[row] - u[0];
                    m.along.add(force[row], pull);
                } else {
                    let felt = squared * m.response[c - 1] * force[row];
                    delta[c] = place[row] + felt - u[c];
                    w[c - 1][m.point] += m.inverse[c - 1] * force[row];
                }
                row += 1;
            }
        }
    }
}
