//! The static displacement of the chain as it is stepped, from that of the structure.
//!
//! Both are the same but for small terms: points between masters follow. With K that of the structure,
//! which is factorised, and K′ that of the steps, u ← u + K⁻¹ (f − K′ u) takes the difference away by a
//! factor of about ‖1 − K⁻¹K′‖ a round.

use crate::integrator::explicit::simd::rows::place;
use crate::integrator::explicit::{Explicit, Grid};
use crate::integrator::prepared::WireModel;
use crate::linalg::SymmetricBlocks;

/// Rounds; each takes two digits or more.
const ROUNDS: usize = 40;
/// Forces that count as none, as a share of the largest given one: rounding of K times u.
const ENOUGH: f64 = 1e-13;

impl<const DIM: usize> Explicit<DIM> {
    /// State at rest in the displaced position of a structure, `u`, and that position as the steps
    /// have it.
    pub(crate) fn at_rest<const D: usize>(
        &self,
        p: &WireModel<DIM, D>,
        mut u: Vec<[f64; D]>,
    ) -> (Grid, Vec<[f64; D]>) {
        let mut grid = self.still();
        if u.iter().flatten().all(|u| *u == 0.0) {
            return (grid, u);
        }
        // A line that is displaced was found with this factor.
        let Ok(factor) = p.still_factors().map(|factors| &factors.linear) else {
            return (grid, u);
        };
        let line = &p.line;
        let given = times(&line.combine(0.0, 0.0, 1.0), &u);
        let largest = given.iter().flatten().fold(0.0_f64, |m, f| m.max(f.abs()));
        self.read_from(&u, &mut grid);
        let mut scratch = vec![[0.0; D]; u.len()];
        for _ in 0..ROUNDS {
            let (mut off, worst) = self.unbalanced(&given, &mut grid);
            if worst <= ENOUGH * largest {
                break;
            }
            line.mask(&mut off);
            factor.solve(&mut off, &mut scratch);
            let mut step = self.still();
            self.read_from(&off, &mut step);
            add(&mut grid, &step);
        }
        (0..self.own.len()).for_each(|island| self.wire_forces(island, &mut grid));
        for (slot, node) in self.all() {
            u[node][0] = self.along[slot].read(&grid.x[0]);
            (0..DIM - 1).for_each(|c| u[node][c + 1] = at(&grid, c, slot));
        }
        (grid, u)
    }

    /// Slots of points, with their nodes.
    pub(in crate::integrator::explicit) fn all(&self) -> impl Iterator<Item = (usize, usize)> {
        let all = self.nodes.iter().copied().enumerate();
        all.filter(|(_, node)| *node != usize::MAX)
    }

    /// Masters and points from nodes.
    fn read_from<const D: usize>(&self, u: &[[f64; D]], grid: &mut Grid) {
        for (slot, node) in self.all() {
            let (row, lane) = place(slot);
            (0..DIM - 1).for_each(|c| grid.moving[c][row].s[lane] = u[node][c + 1]);
            let along = self.along[slot];
            if along.share == 0.0 {
                grid.x[0][along.masters[0]] = u[node][0];
            } else if along.share == 1.0 {
                grid.x[0][along.masters[1]] = u[node][0];
            }
        }
    }

    /// Given forces that the chain does not carry, on nodes; those along on the nodes of masters.
    fn unbalanced<const D: usize>(
        &self,
        given: &[[f64; D]],
        grid: &mut Grid,
    ) -> (Vec<[f64; D]>, f64) {
        let mut off = vec![[0.0; D]; given.len()];
        (0..self.own.len()).for_each(|island| self.wire_forces(island, grid));
        let owners = || self.all().filter(|&(slot, node)| self.points[node] == slot);
        let mut worst: f64 = 0.0;
        for (slot, node) in owners() {
            let (row, lane) = place(slot);
            for c in 0..DIM - 1 {
                let inverse = self.across[c][row].inverse[lane];
                if inverse > 0.0 {
                    off[node][c + 1] += given[node][c + 1] + grid.moving[c][row].w[lane] / inverse;
                }
            }
            self.along[slot].add(given[node][0], &mut grid.pull);
        }
        self.add_clusters(grid, &mut off);
        for (slot, node) in owners() {
            let along = self.along[slot];
            let master = match along.share {
                0.0 => along.masters[0],
                1.0 => along.masters[1],
                _ => continue,
            };
            if self.masters.inverse[master] > 0.0 {
                off[node][0] = grid.pull[master];
            }
        }
        for f in off.iter().flatten() {
            worst = worst.max(f.abs());
        }
        (off, worst)
    }

    /// Forces of clusters in the displaced position: −K u.
    fn add_clusters<const D: usize>(&self, grid: &mut Grid, off: &mut [[f64; D]]) {
        for cluster in &self.clusters {
            let n = cluster.size;
            let at = |row: usize| {
                let (slot, c) = (cluster.members[row / DIM].point, row % DIM);
                match c {
                    0 => self.along[slot].read(&grid.x[0]),
                    _ => at(grid, c - 1, slot),
                }
            };
            let place: Vec<f64> = (0..n).map(at).collect();
            for row in 0..n {
                let force: f64 = (0..n)
                    .map(|j| -cluster.stiffness[row * n + j] * place[j])
                    .sum();
                let (point, c) = (cluster.members[row / DIM].point, row % DIM);
                match c {
                    0 => self.along[point].add(force, &mut grid.pull),
                    _ => off[self.nodes[point]][c] += force,
                }
            }
        }
    }
}

/// A place across, at rest.
fn at(grid: &Grid, across: usize, slot: usize) -> f64 {
    let (row, lane) = place(slot);
    grid.moving[across][row].s[lane]
}

fn add(grid: &mut Grid, step: &Grid) {
    let steps = step.moving.iter().flatten();
    for (row, more) in grid.moving.iter_mut().flatten().zip(steps) {
        row.s
            .iter_mut()
            .zip(more.s.iter())
            .for_each(|(s, more)| *s += more);
    }
    for (x, more) in grid.x[0].iter_mut().zip(&step.x[0]) {
        *x += more;
    }
}

/// A x
fn times<const D: usize>(a: &SymmetricBlocks<D>, x: &[[f64; D]]) -> Vec<[f64; D]> {
    let mut y = vec![[0.0; D]; x.len()];
    for i in 0..a.rows() {
        for k in a.row_start[i]..a.row_start[i + 1] {
            let (j, block) = (a.columns[k], &a.blocks[k]);
            for p in 0..D {
                for q in 0..D {
                    y[i][p] += block[p][q] * x[j][q];
                    if i != j {
                        y[j][q] += block[p][q] * x[i][p];
                    }
                }
            }
        }
    }
    y
}
