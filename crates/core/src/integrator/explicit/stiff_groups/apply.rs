//! Forces of links, struts and springs, batch by batch.

use crate::integrator::explicit::simd::packed::{SIMD_LANES, TransverseMotion, simd_array};
use crate::integrator::explicit::stiff_groups::batches::{BatchPoints, PairBatch, StiffBatch};
use crate::integrator::explicit::stiff_groups::stiff_group::WIDEST;
use crate::integrator::explicit::{BETA, ChainState, IslandModel};
use crate::linalg::Kernel;

/// Kernel that adds the forces of the stiff groups of an island to the chain state, and sets the
/// increments of their nodes from `u` before the step. Nodes of chains have no slopes: `D`
/// directions.
pub(in crate::integrator::explicit) struct ApplyStiffForces<'a, const D: usize> {
    pub island: &'a IslandModel,
    pub chain: &'a mut ChainState,
    pub u: &'a [[f64; D]],
    pub delta: &'a mut [[f64; D]],
}

impl<const D: usize> Kernel for ApplyStiffForces<'_, D> {
    #[inline(always)]
    fn run(self) {
        let ChainState {
            moving,
            x,
            master_force,
            ..
        } = self.chain;
        let mut directions = moving.iter_mut();
        let mut direction = || directions.next().map_or(&mut [][..], |rows| &mut rows[..]);
        let mut forces = StiffForces {
            moving: [direction(), direction()],
            x: [&x[0], &x[1]],
            master_force,
            u: self.u,
            delta: self.delta,
        };
        for pairs in &self.island.batches.packed_pairs {
            forces.pairs::<SIMD_LANES, true>(pairs);
        }
        for pairs in &self.island.batches.pairs {
            forces.pairs::<SIMD_LANES, false>(pairs);
        }
        for batch in &self.island.batches.wide {
            forces.batch(batch);
        }
        for batch in &self.island.batches.single {
            forces.batch(batch);
        }
    }
}

/// Data that stiff groups read and write. Slices, not `Vec`s: without them the compiler must assume
/// aliasing and reload the pointers in the loop.
struct StiffForces<'a, const D: usize> {
    moving: [&'a mut [TransverseMotion]; 2],
    x: [&'a [f64]; 2],
    master_force: &'a mut [f64],
    u: &'a [[f64; D]],
    delta: &'a mut [[f64; D]],
}

impl<const D: usize> StiffForces<'_, D> {
    /// Applies pairs, whose forces act on both points. `PACKED` ones are read and written as
    /// vectors.
    #[inline(always)]
    fn pairs<const L: usize, const PACKED: bool>(&mut self, pairs: &PairBatch<L>) {
        let [first, second] = &pairs.points;
        let (mut position, mut force) = ([[[0.0; L]; D]; 2], [[0.0; L]; D]);
        let mut columns = pairs.columns.chunks_exact(2 * D);
        for c in 0..D {
            let ((a, before), (b, behind)) = (
                self.predict::<L, PACKED>(first, c),
                self.predict::<L, PACKED>(second, c),
            );
            (position[0][c], position[1][c]) = (a, b);
            let (u, v): ([f64; L], [f64; L]) = (
                simd_array(|l| b[l] - a[l]),
                simd_array(|l| behind[l] - before[l]),
            );
            let Some(column) = columns.next() else {
                return;
            };
            let (position_columns, velocity_columns) = column.split_at(D);
            for i in 0..D {
                force[i] = simd_array(|l| {
                    let velocity_columns = velocity_columns[i][l].mul_add(v[l], force[i][l]);
                    position_columns[i][l].mul_add(u[l], velocity_columns)
                });
            }
        }
        self.add_to_point::<L, PACKED>(second, &mut position[1], &force);
        for f in &mut force {
            *f = simd_array(|l| -f[l]);
        }
        self.add_to_point::<L, PACKED>(first, &mut position[0], &force);
    }

    /// Returns position and h times velocity of points at the end of the step, m, without the
    /// forces of their groups.
    #[inline(always)]
    fn predict<const L: usize, const PACKED: bool>(
        &self,
        point: &BatchPoints<L>,
        component: usize,
    ) -> ([f64; L], [f64; L]) {
        match component.checked_sub(1) {
            None => self.axial_motion::<L, PACKED>(point),
            Some(across) => predict_transverse::<L, PACKED>(point, across, self.moving[across]),
        }
    }

    /// Applies a batch, with the number of points known to the compiler for common sizes.
    #[inline(always)]
    fn batch<const L: usize>(&mut self, batch: &StiffBatch<L>) {
        let points = &batch.points[..];
        if let Ok(points) = <&[BatchPoints<L>; 1]>::try_from(points) {
            self.apply_batch::<L, D>(points, &batch.columns);
        } else if let Ok(points) = <&[BatchPoints<L>; 2]>::try_from(points) {
            self.apply_batch::<L, 6>(points, &batch.columns);
        } else {
            self.apply_batch::<L, WIDEST>(points, &batch.columns);
        }
    }

    /// Applies groups of at most `N` components.
    #[inline(always)]
    fn apply_batch<const L: usize, const N: usize>(
        &mut self,
        points: &[BatchPoints<L>],
        columns: &[[f64; L]],
    ) {
        let size = points.len() * D;
        let (mut position, mut force) = ([[0.0; L]; N], [[0.0; L]; N]);
        let mut columns = columns.chunks_exact(2 * size);
        for (k, point) in points.iter().enumerate() {
            for c in 0..D {
                let (u, v) = self.predict::<L, false>(point, c);
                position[k * D + c] = u;
                let Some(column) = columns.next() else {
                    return;
                };
                let (position_columns, velocity_columns) = column.split_at(size);
                for i in 0..size {
                    for l in 0..L {
                        let velocity_columns = velocity_columns[i][l].mul_add(v[l], force[i][l]);
                        force[i][l] = position_columns[i][l].mul_add(u[l], velocity_columns);
                    }
                }
            }
        }
        for (k, point) in points.iter().enumerate() {
            self.add_to_point::<L, false>(point, &mut position[k * D..][..D], &force[k * D..][..D]);
        }
    }

    /// Returns position and increment along the track, m.
    #[inline(always)]
    fn axial_motion<const L: usize, const PACKED: bool>(
        &self,
        point: &BatchPoints<L>,
    ) -> ([f64; L], [f64; L]) {
        let [x, d] = self.x;
        let x = &x[..d.len()];
        let (mut from, mut to) = ([[0.0; L]; 2], [[0.0; L]; 2]);
        if PACKED {
            let [a, b] = point.masters.map(|masters| masters[0] as usize);
            let read = |list: &[f64], first: usize| -> [f64; L] {
                let list = &list[first..][..L];
                simd_array(|l| list[l])
            };
            (from, to) = ([read(x, a), read(d, a)], [read(x, b), read(d, b)]);
        } else {
            for l in 0..L {
                let (a, b) = (point.masters[0][l] as usize, point.masters[1][l] as usize);
                (from[0][l], from[1][l]) = (x[a], d[a]);
                (to[0][l], to[1][l]) = (x[b], d[b]);
            }
        }
        let share = &point.share;
        let between =
            |k: usize| simd_array(|l| share[l].mul_add(to[k][l] - from[k][l], from[k][l]));
        (between(0), between(1))
    }

    /// Adds the forces on a point, and sets its increments.
    #[inline(always)]
    fn add_to_point<const L: usize, const PACKED: bool>(
        &mut self,
        point: &BatchPoints<L>,
        position: &mut [[f64; L]],
        force: &[[f64; L]],
    ) {
        let second: [f64; L] = simd_array(|l| point.share[l] * force[0][l]);
        let first: [f64; L] = simd_array(|l| (1.0 - point.share[l]) * force[0][l]);
        if PACKED {
            for (masters, force) in point.masters.iter().zip([first, second]) {
                let master_force = &mut self.master_force[masters[0] as usize..][..L];
                (0..L).for_each(|l| master_force[l] += force[l]);
            }
        } else {
            for l in 0..L {
                self.master_force[point.masters[0][l] as usize] += first[l];
                self.master_force[point.masters[1][l] as usize] += second[l];
            }
        }
        for c in 1..D {
            let (force, position) = (&force[c], &mut position[c]);
            let (inverse, response) = (&point.inverse[c - 1], &point.response[c - 1]);
            let moved: [f64; L] = simd_array(|l| inverse[l] * force[l]);
            *position = simd_array(|l| position[l] + BETA * response[l] * force[l]);
            let rows = &mut *self.moving[c - 1];
            if PACKED {
                let w = &mut rows[point.row[0] as usize].w;
                for l in 0..L {
                    w[l % SIMD_LANES] += moved[l];
                }
            } else {
                for l in 0..L {
                    rows[point.row[l] as usize].w[point.simd_lane[l] as usize % SIMD_LANES] +=
                        moved[l];
                }
            }
        }
        for l in 0..L {
            let node = point.node[l] as usize;
            let (u, delta) = (&self.u[node], &mut self.delta[node]);
            for c in 0..D {
                delta[c] = position[c][l] - u[c];
            }
        }
    }
}

/// Motion of points, and w of their stencils.
struct Stencil<const L: usize> {
    s: [f64; L],
    d: [f64; L],
    w: [[f64; L]; 5],
}

impl<const L: usize> Stencil<L> {
    #[inline(always)]
    fn read<const PACKED: bool>(point: &BatchPoints<L>, rows: &[TransverseMotion]) -> Self {
        let (mut s, mut d, mut w) = ([0.0; L], [0.0; L], [[0.0; L]; 5]);
        if PACKED {
            let near = &rows[point.row[0] as usize - 2..][..5];
            s = simd_array(|l| near[2].s[l % SIMD_LANES]);
            d = simd_array(|l| near[2].d[l % SIMD_LANES]);
            for k in 0..5 {
                w[k] = simd_array(|l| near[k].w[l % SIMD_LANES]);
            }
        } else {
            for l in 0..L {
                let (row, simd_lane) = (
                    point.row[l] as usize,
                    point.simd_lane[l] as usize % SIMD_LANES,
                );
                let near = &rows[row - 2..][..5];
                (s[l], d[l]) = (near[2].s[simd_lane], near[2].d[simd_lane]);
                for k in 0..5 {
                    w[k][l] = near[k].w[simd_lane];
                }
            }
        }
        Self { s, d, w }
    }
}

/// Returns transverse position and h times velocity at the end of the step, m, without the forces
/// of the group.
#[inline(always)]
fn predict_transverse<const L: usize, const PACKED: bool>(
    point: &BatchPoints<L>,
    across: usize,
    rows: &[TransverseMotion],
) -> ([f64; L], [f64; L]) {
    let Stencil { s, d, w } = Stencil::read::<PACKED>(point, rows);
    let ([before, behind], [r0, r1, r2]) = (&point.filter[across], &point.second[across]);
    let a: [f64; L] = simd_array(|l| {
        let (b0, b1) = (w[1][l] - w[0][l], w[2][l] - w[1][l]);
        let (b2, b3) = (w[3][l] - w[2][l], w[4][l] - w[3][l]);
        let (t0, t1, t2) = (r0[l] * (b1 - b0), r1[l] * (b2 - b1), r2[l] * (b3 - b2));
        let left = before[l].mul_add(b1, t0 - t1);
        let right = behind[l].mul_add(b2, t1 - t2);
        w[2][l] - (right - left)
    });
    let y: [f64; L] = simd_array(|l| d[l].mul_add(-point.lag[l], s[l]));
    (
        simd_array(|l| a[l].mul_add(BETA, y[l])),
        simd_array(|l| a[l].mul_add(0.5, d[l])),
    )
}
