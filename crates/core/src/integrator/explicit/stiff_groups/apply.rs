//! Forces of links, struts and springs, group by group.

use crate::integrator::explicit::simd::rows::{LANES, Moving, lanes};
use crate::integrator::explicit::stiff_groups::batches::{Group, Pairs, Points};
use crate::integrator::explicit::stiff_groups::cluster::WIDEST;
use crate::integrator::explicit::{BETA, Grid, Own};
use crate::linalg::Kernel;

/// Adds the forces of the clusters of an island to the grid, and sets the increments of their nodes from
/// `u` before the step. Nodes of chains have no slopes: `D` directions.
pub(in crate::integrator::explicit) struct Settle<'a, const D: usize> {
    pub own: &'a Own,
    pub grid: &'a mut Grid,
    pub u: &'a [[f64; D]],
    pub delta: &'a mut [[f64; D]],
}

impl<const D: usize> Kernel for Settle<'_, D> {
    #[inline(always)]
    fn run(self) {
        let Grid {
            moving, x, pull, ..
        } = self.grid;
        let mut directions = moving.iter_mut();
        let mut direction = || directions.next().map_or(&mut [][..], |rows| &mut rows[..]);
        let mut on = On {
            moving: [direction(), direction()],
            x: [&x[0], &x[1]],
            pull,
            u: self.u,
            delta: self.delta,
        };
        for pairs in &self.own.groups.rows {
            on.pairs::<LANES, true>(pairs);
        }
        for pairs in &self.own.groups.pairs {
            on.pairs::<LANES, false>(pairs);
        }
        for group in &self.own.groups.wide {
            on.group(group);
        }
        for group in &self.own.groups.single {
            on.group(group);
        }
    }
}

/// What clusters read and write. Slices: a list that is written to might be another one for all the compiler
/// knows, and be looked up anew.
struct On<'a, const D: usize> {
    moving: [&'a mut [Moving]; 2],
    x: [&'a [f64]; 2],
    pull: &'a mut [f64],
    u: &'a [[f64; D]],
    delta: &'a mut [[f64; D]],
}

impl<const D: usize> On<'_, D> {
    /// Pairs: what is between two points pulls at both. In a `ROW` they are read and written side by side.
    #[inline(always)]
    fn pairs<const L: usize, const ROW: bool>(&mut self, pairs: &Pairs<L>) {
        let [first, second] = &pairs.points;
        let (mut at, mut force) = ([[[0.0; L]; D]; 2], [[0.0; L]; D]);
        let mut columns = pairs.columns.chunks_exact(2 * D);
        for c in 0..D {
            let ((a, before), (b, behind)) = (
                self.free::<L, ROW>(first, c),
                self.free::<L, ROW>(second, c),
            );
            (at[0][c], at[1][c]) = (a, b);
            let (u, v): ([f64; L], [f64; L]) =
                (lanes(|l| b[l] - a[l]), lanes(|l| behind[l] - before[l]));
            let Some(column) = columns.next() else {
                return;
            };
            let (of_place, of_speed) = column.split_at(D);
            for i in 0..D {
                force[i] = lanes(|l| {
                    let of_speed = of_speed[i][l].mul_add(v[l], force[i][l]);
                    of_place[i][l].mul_add(u[l], of_speed)
                });
            }
        }
        self.put::<L, ROW>(second, &mut at[1], &force);
        for f in &mut force {
            *f = lanes(|l| -f[l]);
        }
        self.put::<L, ROW>(first, &mut at[0], &force);
    }

    /// Place and h times velocity of points at the end of the step, without the forces of their clusters.
    #[inline(always)]
    fn free<const L: usize, const ROW: bool>(
        &self,
        point: &Points<L>,
        component: usize,
    ) -> ([f64; L], [f64; L]) {
        match component.checked_sub(1) {
            None => self.along::<L, ROW>(point),
            Some(across) => ahead::<L, ROW>(point, across, self.moving[across]),
        }
    }

    /// With its number of points known to the compiler for those that are many.
    #[inline(always)]
    fn group<const L: usize>(&mut self, group: &Group<L>) {
        let points = &group.points[..];
        if let Ok(points) = <&[Points<L>; 1]>::try_from(points) {
            self.settle::<L, D>(points, &group.columns);
        } else if let Ok(points) = <&[Points<L>; 2]>::try_from(points) {
            self.settle::<L, 6>(points, &group.columns);
        } else {
            self.settle::<L, WIDEST>(points, &group.columns);
        }
    }

    /// Clusters of no more than `N` components.
    #[inline(always)]
    fn settle<const L: usize, const N: usize>(
        &mut self,
        points: &[Points<L>],
        columns: &[[f64; L]],
    ) {
        let size = points.len() * D;
        let (mut at, mut force) = ([[0.0; L]; N], [[0.0; L]; N]);
        let mut columns = columns.chunks_exact(2 * size);
        for (k, point) in points.iter().enumerate() {
            for c in 0..D {
                let (u, v) = self.free::<L, false>(point, c);
                at[k * D + c] = u;
                let Some(column) = columns.next() else {
                    return;
                };
                let (of_place, of_speed) = column.split_at(size);
                for i in 0..size {
                    for l in 0..L {
                        let of_speed = of_speed[i][l].mul_add(v[l], force[i][l]);
                        force[i][l] = of_place[i][l].mul_add(u[l], of_speed);
                    }
                }
            }
        }
        for (k, point) in points.iter().enumerate() {
            self.put::<L, false>(point, &mut at[k * D..][..D], &force[k * D..][..D]);
        }
    }

    /// Place and increment along the wire.
    #[inline(always)]
    fn along<const L: usize, const ROW: bool>(&self, point: &Points<L>) -> ([f64; L], [f64; L]) {
        let [x, d] = self.x;
        let x = &x[..d.len()];
        let (mut from, mut to) = ([[0.0; L]; 2], [[0.0; L]; 2]);
        if ROW {
            let [a, b] = point.masters.map(|of| of[0] as usize);
            let read = |list: &[f64], first: usize| -> [f64; L] {
                let list = &list[first..][..L];
                lanes(|l| list[l])
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
        let between = |k: usize| lanes(|l| share[l].mul_add(to[k][l] - from[k][l], from[k][l]));
        (between(0), between(1))
    }

    /// Take the forces on a point, and its increments.
    #[inline(always)]
    fn put<const L: usize, const ROW: bool>(
        &mut self,
        point: &Points<L>,
        at: &mut [[f64; L]],
        force: &[[f64; L]],
    ) {
        let second: [f64; L] = lanes(|l| point.share[l] * force[0][l]);
        let first: [f64; L] = lanes(|l| (1.0 - point.share[l]) * force[0][l]);
        if ROW {
            for (of, force) in point.masters.iter().zip([first, second]) {
                let pull = &mut self.pull[of[0] as usize..][..L];
                (0..L).for_each(|l| pull[l] += force[l]);
            }
        } else {
            for l in 0..L {
                self.pull[point.masters[0][l] as usize] += first[l];
                self.pull[point.masters[1][l] as usize] += second[l];
            }
        }
        for c in 1..D {
            let (force, at) = (&force[c], &mut at[c]);
            let (inverse, response) = (&point.inverse[c - 1], &point.response[c - 1]);
            let moved: [f64; L] = lanes(|l| inverse[l] * force[l]);
            *at = lanes(|l| at[l] + BETA * response[l] * force[l]);
            let rows = &mut *self.moving[c - 1];
            if ROW {
                let w = &mut rows[point.row[0] as usize].w;
                for l in 0..L {
                    w[l % LANES] += moved[l];
                }
            } else {
                for l in 0..L {
                    rows[point.row[l] as usize].w[point.lane[l] as usize % LANES] += moved[l];
                }
            }
        }
        for l in 0..L {
            let node = point.node[l] as usize;
            let (u, delta) = (&self.u[node], &mut self.delta[node]);
            for c in 0..D {
                delta[c] = at[c][l] - u[c];
            }
        }
    }
}

/// What moves at points, and w of the two points on both sides.
struct Beside<const L: usize> {
    s: [f64; L],
    d: [f64; L],
    w: [[f64; L]; 5],
}

impl<const L: usize> Beside<L> {
    #[inline(always)]
    fn of<const ROW: bool>(point: &Points<L>, rows: &[Moving]) -> Self {
        let (mut s, mut d, mut w) = ([0.0; L], [0.0; L], [[0.0; L]; 5]);
        if ROW {
            let near = &rows[point.row[0] as usize - 2..][..5];
            s = lanes(|l| near[2].s[l % LANES]);
            d = lanes(|l| near[2].d[l % LANES]);
            for k in 0..5 {
                w[k] = lanes(|l| near[k].w[l % LANES]);
            }
        } else {
            for l in 0..L {
                let (row, lane) = (point.row[l] as usize, point.lane[l] as usize % LANES);
                let near = &rows[row - 2..][..5];
                (s[l], d[l]) = (near[2].s[lane], near[2].d[lane]);
                for k in 0..5 {
                    w[k][l] = near[k].w[lane];
                }
            }
        }
        Self { s, d, w }
    }
}

/// Place and h times velocity across at the end of the step, without the forces of the cluster.
#[inline(always)]
fn ahead<const L: usize, const ROW: bool>(
    point: &Points<L>,
    across: usize,
    rows: &[Moving],
) -> ([f64; L], [f64; L]) {
    let Beside { s, d, w } = Beside::of::<ROW>(point, rows);
    let ([before, behind], [r0, r1, r2]) = (&point.filter[across], &point.second[across]);
    let a: [f64; L] = lanes(|l| {
        let (b0, b1) = (w[1][l] - w[0][l], w[2][l] - w[1][l]);
        let (b2, b3) = (w[3][l] - w[2][l], w[4][l] - w[3][l]);
        let (t0, t1, t2) = (r0[l] * (b1 - b0), r1[l] * (b2 - b1), r2[l] * (b3 - b2));
        let left = before[l].mul_add(b1, t0 - t1);
        let right = behind[l].mul_add(b2, t1 - t2);
        w[2][l] - (right - left)
    });
    let y: [f64; L] = lanes(|l| d[l].mul_add(-point.lag[l], s[l]));
    (
        lanes(|l| a[l].mul_add(BETA, y[l])),
        lanes(|l| a[l].mul_add(0.5, d[l])),
    )
}
