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
        let (p, n) = (self.p, cluster.members.len() * DIM);
        let Grid {
            y, d, x, w, pull, ..
        } = &mut *self.grid;
        let (mut place, mut speed) = ([0.0; N], [0.0; N]);
        let rows = place.chunks_exact_mut(DIM).zip(speed.chunks_exact_mut(DIM));
        for (m, (place, speed)) in cluster.members.iter().zip(rows) {
            (place[0], speed[0]) = (m.along.read(&x[0]), p.per_step * m.along.read(&x[1]));
            for across in 0..DIM - 1 {
                let a = m.acceleration(across, &w[across]);
                let ahead = p.ahead([y[across][m.point], d[across][m.point], a]);
                [place[across + 1], speed[across + 1]] = ahead;
            }
        }
        let (mut force, mut by_speed) = ([0.0; N], [0.0; N]);
        let (columns, _) = cluster.columns.as_chunks::<N>();
        let (columns, _) = columns.as_chunks::<2>();
        for (([of_place, of_speed], u), v) in columns.iter().zip(&place[..n]).zip(&speed[..n]) {
            for k in 0..N {
                force[k] += of_place[k] * u;
                by_speed[k] += of_speed[k] * v;
            }
        }
        for k in 0..N {
            force[k] += by_speed[k];
        }
        let squared = BETA * p.h * p.h;
        let rows = place.chunks_exact(DIM).zip(force.chunks_exact(DIM));
        for (m, (place, force)) in cluster.members.iter().zip(rows) {
            let (u, delta) = (&self.u[m.node], &mut self.delta[m.node]);
            delta[0] = place[0] - u[0];
            m.along.add(force[0], pull);
            for across in 0..DIM - 1 {
                let c = across + 1;
                delta[c] = place[c] + squared * m.response[across] * force[c] - u[c];
                w[across][m.point] += m.inverse[across] * force[c];
            }
        }
    }
}
