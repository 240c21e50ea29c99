//! A step, in the order of the pieces: forces, clusters; then, with contacts known, the motion.

use super::kernels::{Forces, Lag, Move};
use super::settle::Settle;
use super::stretch::Stretch;
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
        widest(Stretch { p: self, own, grid });
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

    /// Forces of links, struts and springs; and the increments of their nodes, with `u` before the step.
    pub(super) fn settle_clusters<const D: usize>(
        &self,
        island: usize,
        grid: &mut Grid,
        (u, delta): (&[[f64; D]], &mut [[f64; D]]),
    ) {
        widest(Settle {
            p: self,
            island,
            grid,
            u,
            delta,
        });
    }

    /// Place and velocity at the end of the step, from predictor, its last increment and acceleration.
    #[inline(always)]
    pub(super) fn ahead(&self, [y, d, a]: [f64; 3]) -> [f64; 2] {
        let h = self.h;
        [y + BETA * h * h * a, self.per_step * d + 0.5 * h * a]
    }

    /// Increments of the other nodes that are read, with `u` before the step.
    pub(super) fn show<const D: usize>(
        &self,
        grid: &Grid,
        (u, delta): (&[[f64; D]], &mut [[f64; D]]),
    ) {
        for &point in grid.watched.iter().chain(&grid.near) {
            let (node, new) = (self.nodes[point], self.at(grid, point));
            for c in 0..DIM {
                delta[node][c] = new[c][0] - u[node][c];
            }
        }
    }

    /// Take the increments where others read them, and the velocities where contacts are.
    pub(super) fn take<const D: usize>(
        &self,
        grid: &Grid,
        awake: &[usize],
        delta: &[[f64; D]],
        (u, v): (&mut [[f64; D]], &mut [[f64; D]]),
    ) {
        let of = |&island: &usize| &self.clusters[self.own[island].clusters.clone()];
        for member in awake.iter().flat_map(of).flat_map(|c| &c.members) {
            let (u, delta) = (&mut u[member.node], &delta[member.node]);
            for c in 0..DIM {
                u[c] += delta[c];
            }
        }
        for &point in grid.watched.iter().chain(&grid.near) {
            let node = self.nodes[point];
            for (c, [place, speed]) in self.at(grid, point).into_iter().enumerate() {
                (u[node][c], v[node][c]) = (place, speed);
            }
        }
    }

    /// Place and velocity of a point at the end of the step, component by component.
    #[inline(always)]
    fn at(&self, grid: &Grid, point: usize) -> [[f64; 2]; DIM] {
        let along = &self.along[point];
        let mut found = [[0.0; 2]; DIM];
        found[0] = [
            along.read(&grid.x[0]),
            self.per_step * along.read(&grid.x[1]),
        ];
        for across in 0..DIM - 1 {
            let a = self.acceleration(across, point, &grid.w[across]);
            found[across + 1] = self.ahead([grid.y[across][point], grid.d[across][point], a]);
        }
        found
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

    /// Whether an island is at rest where it was without any force.
    pub(in crate::dynamics) fn lies(&self, island: usize, grid: &Grid) -> bool {
        let own = &self.own[island];
        let across = grid
            .y
            .iter()
            .chain(&grid.d)
            .flat_map(|list| &list[own.points.clone()]);
        let along = grid.x.iter().flat_map(|list| &list[own.masters.clone()]);
        across.chain(along).all(|v| *v == 0.0)
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
