//! Static equilibrium of the chain model, by defect correction with the factor of K.
//!
//! It differs from that of the structure by small terms: points between masters follow. With K that
//! of the structure, which is factorised, and K′ that of the chain model, u ← u + K⁻¹ (f − K′ u)
//! reduces the difference by a factor of about ‖1 − K⁻¹K′‖ a round.

use crate::constraint::wires::Wires;
use crate::integrator::explicit::simd::packed::row_and_lane;
use crate::integrator::explicit::{ChainState, Explicit};
use crate::linalg::SymmetricBlocks;

/// Largest number of rounds; each gains two digits or more.
const ROUNDS: usize = 40;
/// Negligible residual, relative to the largest given force: rounding of K u.
const NEGLIGIBLE: f64 = 1e-13;

impl<const DIM: usize> Explicit<DIM> {
    /// Returns the state at rest in the displaced position `u`, m, of a structure, and that
    /// position in the chain model.
    pub(crate) fn at_rest<const D: usize>(
        &self,
        p: &Wires<DIM, D>,
        mut u: Vec<[f64; D]>,
    ) -> (ChainState, Vec<[f64; D]>) {
        let mut chain = self.zero_state();
        if u.iter().flatten().all(|u| *u == 0.0) {
            return (chain, u);
        }
        // A displaced line was found with this factor.
        let Ok(factor) = p.static_factors().map(|factors| &factors.linear) else {
            return (chain, u);
        };
        let line = &p.line;
        let given = product(&line.combine(0.0, 0.0, 1.0), &u);
        let largest_given = given.iter().flatten().fold(0.0_f64, |m, f| m.max(f.abs()));
        self.set_displacements(&u, &mut chain);
        let mut scratch = vec![[0.0; D]; u.len()];
        for _ in 0..ROUNDS {
            let (mut residual, largest_residual) = self.unbalanced_forces(&given, &mut chain);
            if largest_residual <= NEGLIGIBLE * largest_given {
                break;
            }
            line.mask(&mut residual);
            factor.solve(&mut residual, &mut scratch);
            let mut step = self.zero_state();
            self.set_displacements(&residual, &mut step);
            add_displacements(&mut chain, &step);
        }
        (0..self.islands.len()).for_each(|island| self.wire_forces(island, &mut chain));
        for (packed_index, node) in self.points_and_nodes() {
            u[node][0] = self.axial_positions[packed_index].read(&chain.x[0]);
            (0..DIM - 1).for_each(|c| u[node][c + 1] = position_at(&chain, c, packed_index));
        }
        (chain, u)
    }

    /// Iterates over the packed indices of points, with their nodes.
    pub(in crate::integrator::explicit) fn points_and_nodes(
        &self,
    ) -> impl Iterator<Item = (usize, usize)> {
        let all = self.nodes.iter().copied().enumerate();
        all.filter(|(_, node)| *node != usize::MAX)
    }

    /// Sets masters and points from the displacements of nodes, m.
    fn set_displacements<const D: usize>(&self, u: &[[f64; D]], chain: &mut ChainState) {
        for (packed_index, node) in self.points_and_nodes() {
            let (row, simd_lane) = row_and_lane(packed_index);
            (0..DIM - 1).for_each(|c| chain.moving[c][row].s[simd_lane] = u[node][c + 1]);
            let along = self.axial_positions[packed_index];
            if along.share == 0.0 {
                chain.x[0][along.masters[0]] = u[node][0];
            } else if along.share == 1.0 {
                chain.x[0][along.masters[1]] = u[node][0];
            }
        }
    }

    /// Returns the given forces that the chain does not balance, N, and the largest of them; those
    /// along the track on the nodes of masters.
    fn unbalanced_forces<const D: usize>(
        &self,
        given: &[[f64; D]],
        chain: &mut ChainState,
    ) -> (Vec<[f64; D]>, f64) {
        let mut residual = vec![[0.0; D]; given.len()];
        (0..self.islands.len()).for_each(|island| self.wire_forces(island, chain));
        let independent_points = || {
            self.points_and_nodes()
                .filter(|&(packed_index, node)| self.points[node] == packed_index)
        };
        let mut largest_residual: f64 = 0.0;
        for (packed_index, node) in independent_points() {
            let (row, simd_lane) = row_and_lane(packed_index);
            for c in 0..DIM - 1 {
                let inverse = self.transverse[c][row].inverse[simd_lane];
                if inverse > 0.0 {
                    residual[node][c + 1] +=
                        given[node][c + 1] + chain.moving[c][row].w[simd_lane] / inverse;
                }
            }
            self.axial_positions[packed_index].add(given[node][0], &mut chain.master_force);
        }
        self.add_stiff_forces(chain, &mut residual);
        for (packed_index, node) in independent_points() {
            let along = self.axial_positions[packed_index];
            let master = match along.share {
                0.0 => along.masters[0],
                1.0 => along.masters[1],
                _ => continue,
            };
            if self.masters.inverse[master] > 0.0 {
                residual[node][0] = chain.master_force[master];
            }
        }
        for f in residual.iter().flatten() {
            largest_residual = largest_residual.max(f.abs());
        }
        (residual, largest_residual)
    }

    /// Adds the forces −K u of stiff groups in the displaced position, N.
    fn add_stiff_forces<const D: usize>(&self, chain: &mut ChainState, residual: &mut [[f64; D]]) {
        for stiff_group in &self.stiff_groups {
            let n = stiff_group.size;
            let position_at = |row: usize| {
                let (packed_index, c) = (stiff_group.members[row / DIM].point, row % DIM);
                match c {
                    0 => self.axial_positions[packed_index].read(&chain.x[0]),
                    _ => position_at(chain, c - 1, packed_index),
                }
            };
            let place: Vec<f64> = (0..n).map(position_at).collect();
            for row in 0..n {
                let force: f64 = (0..n)
                    .map(|j| -stiff_group.stiffness[row * n + j] * place[j])
                    .sum();
                let (point, c) = (stiff_group.members[row / DIM].point, row % DIM);
                match c {
                    0 => self.axial_positions[point].add(force, &mut chain.master_force),
                    _ => residual[self.nodes[point]][c] += force,
                }
            }
        }
    }
}

/// Returns the transverse position of a point at rest, m.
fn position_at(chain: &ChainState, across: usize, packed_index: usize) -> f64 {
    let (row, simd_lane) = row_and_lane(packed_index);
    chain.moving[across][row].s[simd_lane]
}

fn add_displacements(chain: &mut ChainState, step: &ChainState) {
    let steps = step.moving.iter().flatten();
    for (row, increment) in chain.moving.iter_mut().flatten().zip(steps) {
        row.s
            .iter_mut()
            .zip(increment.s.iter())
            .for_each(|(s, increment)| *s += increment);
    }
    for (x, increment) in chain.x[0].iter_mut().zip(&step.x[0]) {
        *x += increment;
    }
}

/// Returns the product A x.
fn product<const D: usize>(a: &SymmetricBlocks<D>, x: &[[f64; D]]) -> Vec<[f64; D]> {
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
