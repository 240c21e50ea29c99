//! A step, in the order of the pieces: forces, clusters; then, with contacts known, the motion.

use super::kernels::{Forces, Lag, Move};
use super::{BETA, Explicit, Grid, Own};
use crate::linalg::widest;
use std::ops::Range;

impl Grid {
    /// Room for the nodes that are read at some places: those of three elements each.
    pub(in crate::dynamics) fn reserve(&mut self, places: usize) {
        self.near.reserve(6 * places);
    }
}

impl<const DIM: usize> Explicit<DIM> {
    /// Nothing moves.
    pub(in crate::dynamics) fn still(&self) -> Grid {
        let zero = vec![0.0; self.nodes.len()];
        let across = || vec![zero.clone(); DIM - 1];
        let along = vec![0.0; self.masters.len()];
        Grid {
            y: across(),
            d: across(),
            x: [along.clone(), along.clone()],
            lagged: across(),
            w: across(),
            pull: along,
            thrust: zero,
            near: Vec::new(),
            watched: Vec::new(),
        }
    }

    /// Nodes that are read in every step, beside those of links, struts and springs.
    pub(in crate::dynamics) fn watch(&self, grid: &mut Grid, nodes: impl Iterator<Item = usize>) {
        let points = nodes.map(|node| self.points[node]);
        grid.watched = points.filter(|&p| self.in_cluster[p].is_none()).collect();
        grid.watched.sort_unstable();
        grid.watched.dedup();
    }

    /// Nodes that are read in the coming step.
    pub(in crate::dynamics) fn look_at(&self, grid: &mut Grid, nodes: impl Iterator<Item = usize>) {
        grid.near.clear();
        grid.near.extend(nodes.map(|node| self.points[node]));
    }

    /// Forces of wires on all points of an island, and those along on the masters.
    pub(super) fn wire_forces(&self, own: &Own, grid: &mut Grid) {
        let Range { start, end } = own.points;
        for across in 0..DIM - 1 {
            widest(Lag {
                lag: &self.lag[start..end],
                y: &grid.y[across][start..end],
                d: &grid.d[across][start..end],
                s: &mut grid.lagged[across][start..end],
            });
        }
        grid.pull[own.masters.clone()].fill(0.0);
        self.stretch(own, grid);
        for across in 0..DIM - 1 {
            widest(Forces {
                p: self,
                across,
                range: own.points.clone(),
                s: &grid.lagged[across],
                d: &grid.d[across],
                thrust: &grid.thrust,
                w: &mut grid.w[across],
            });
            for &(guest, owner) in &self.guests[own.guests.clone()] {
                let w = &mut grid.w[across];
                w[owner] += self.inverse[across][owner] * w[guest];
                w[guest] = 0.0;
            }
        }
    }

    /// H of each reach.
    fn stretch(&self, own: &Own, grid: &mut Grid) {
        let lagged = |m: usize, x: &[Vec<f64>; 2]| x[0][m] + self.masters[m][2] * x[1][m];
        for reach in &self.reaches[own.reaches.clone()] {
            let Range { start, end } = reach.segments;
            let [a, b] = self.along[start].masters;
            let mut longer = lagged(b, &grid.x) - lagged(a, &grid.x);
            for across in 0..DIM - 1 {
                longer += rise(&self.slope[across][start..end], &grid.lagged[across][start..=end]);
            }
            let thrust = reach.stiffness * longer;
            grid.thrust[start..end].fill(thrust);
            grid.pull[a] += thrust;
            grid.pull[b] -= thrust;
        }
    }

    /// Forces of links, struts and springs.
    pub(super) fn settle_clusters(&self, island: usize, grid: &mut Grid) {
        for number in self.own[island].clusters.clone() {
            self.settle_cluster(number, grid);
        }
    }

    #[inline(always)]
    fn settle_cluster(&self, number: usize, grid: &mut Grid) {
        let cluster = &self.clusters[number];
        let n = cluster.points.len() * DIM;
        let mut state = [[0.0; 2]; MOST];
        for (point, state) in cluster.points.iter().zip(state.chunks_mut(DIM)) {
            state.copy_from_slice(&self.at(grid, *point));
        }
        for row in 0..n {
            let (places, speeds) = (&cluster.of_place[row * n..][..n], &cluster.of_speed[row * n..][..n]);
            let mut force = 0.0;
            for ((k, c), [u, v]) in places.iter().zip(speeds).zip(&state[..n]) {
                force -= k * u + c * v;
            }
            self.add_force(grid, cluster.points[row / DIM], row % DIM, force);
        }
    }

    /// Read the nodes that others need: displacement `u` before the step, increment `delta`.
    pub(super) fn show<const D: usize>(
        &self,
        grid: &Grid,
        awake: &[usize],
        u: &[[f64; D]],
        delta: &mut [[f64; D]],
    ) {
        for point in self.read(grid, awake) {
            let node = self.nodes[point];
            let new = self.at(grid, point);
            for c in 0..DIM {
                delta[node][c] = new[c][0] - u[node][c];
            }
        }
    }

    /// Put place and velocity at the end of the step where others read them.
    pub(super) fn take<const D: usize>(
        &self,
        grid: &Grid,
        awake: &[usize],
        u: &mut [[f64; D]],
        v: &mut [[f64; D]],
    ) {
        for point in self.read(grid, awake) {
            let node = self.nodes[point];
            for (c, [place, speed]) in self.at(grid, point).into_iter().enumerate() {
                (u[node][c], v[node][c]) = (place, speed);
            }
        }
    }

    /// Place and velocity of a point at the end of the step, component by component.
    #[inline(always)]
    fn at(&self, grid: &Grid, point: usize) -> [[f64; 2]; DIM] {
        let (along, squared) = (&self.along[point], BETA * self.h * self.h);
        let mut found = [[0.0; 2]; DIM];
        found[0] = [along.read(&grid.x[0]), along.read(&grid.x[1]) / self.h];
        for across in 0..DIM - 1 {
            let a = self.acceleration(across, point, &grid.w[across]);
            let (y, d) = (grid.y[across][point], grid.d[across][point]);
            found[across + 1] = [y + squared * a, d / self.h + 0.5 * self.h * a];
        }
        found
    }

    fn read<'a>(&'a self, grid: &'a Grid, awake: &'a [usize]) -> impl Iterator<Item = usize> + 'a {
        let clusters = awake.iter().flat_map(|&island| &self.clusters[self.own[island].clusters.clone()]);
        let linked = clusters.flat_map(|c| &c.points);
        linked.chain(&grid.watched).chain(&grid.near).copied()
    }

    /// Take the step on one island.
    pub(super) fn go(&self, island: usize, grid: &mut Grid) {
        let own = &self.own[island];
        for across in 0..DIM - 1 {
            widest(Move {
                p: self,
                across,
                range: own.points.clone(),
                w: &grid.w[across],
                d: &mut grid.d[across],
                y: &mut grid.y[across],
            });
            for &(guest, owner) in &self.guests[own.guests.clone()] {
                grid.y[across][guest] = grid.y[across][owner];
                grid.d[across][guest] = grid.d[across][owner];
            }
        }
        let [x, d] = &mut grid.x;
        for m in own.masters.clone() {
            let [inverse, damping, _] = self.masters[m];
            d[m] += self.h * self.h * (inverse * grid.pull[m] - damping * d[m]);
            x[m] += d[m];
        }
    }

    /// Put an island back to rest.
    pub(in crate::dynamics) fn lay(&self, island: usize, grid: &mut Grid) {
        let own = &self.own[island];
        for list in grid.y.iter_mut().chain(&mut grid.d).chain(&mut grid.w) {
            list[own.points.clone()].fill(0.0);
        }
        for list in grid.x.iter_mut().chain([&mut grid.pull]) {
            list[own.masters.clone()].fill(0.0);
        }
    }
}

/// Most components of a cluster.
pub(super) const MOST: usize = 48;

/// Σ tan φⱼ (sⱼ₊₁ − sⱼ)
#[inline(always)]
fn rise(slope: &[f64], s: &[f64]) -> f64 {
    let mut sums = [0.0; 4];
    let ends = s[1..].chunks(4).zip(s[..slope.len()].chunks(4));
    for (slope, (next, s)) in slope.chunks(4).zip(ends) {
        for k in 0..slope.len() {
            sums[k] += slope[k] * (next[k] - s[k]);
        }
    }
    sums.iter().sum()
}
