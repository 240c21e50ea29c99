//! A step, in the order of the pieces: clusters; then, with contacts known, the motion, and the forces of wires
//! for the next one.

use super::rows::{LANES, Moving, Wide, place};
use super::settle::Settle;
use super::sweep::{Stand, Sweep};
use super::{BETA, Block, Explicit, Grid, Own};
use crate::linalg::widest;

/// Take what is of points beyond cuts from where they are at home.
#[inline(always)]
fn copy<const N: usize>(
    copies: &[[u32; 2]],
    grid: &mut Grid,
    of: impl Fn(&mut Moving) -> [&mut Wide; N],
) {
    for rows in &mut grid.moving {
        let rows = &mut rows[..];
        for both in copies {
            let [(to, lane), (from, its)] = both.map(|slot| place(slot as usize));
            let home = of(&mut rows[from]).map(|wide| wide[its]);
            for (wide, home) in of(&mut rows[to]).into_iter().zip(home) {
                wide[lane] = home;
            }
        }
    }
}

/// h² times an acceleration, from w of the point and of two on both sides of it, and the numbers of the segments and points
/// near it.
#[inline(always)]
pub(super) fn accelerated(w: [f64; 5], filter: [f64; 2], second: [f64; 3], inverse: f64) -> f64 {
    let by: [f64; 4] = std::array::from_fn(|k| w[k + 1] - w[k]);
    let turn: [f64; 3] = std::array::from_fn(|k| second[k] * (by[k + 1] - by[k]));
    let left = filter[0] * by[1] - (turn[1] - turn[0]);
    let right = filter[1] * by[2] - (turn[2] - turn[1]);
    w[2] - inverse * (right - left)
}

impl Grid {
    /// Room for the nodes that are read at some places: those of five elements each.
    pub(in crate::dynamics) fn reserve(&mut self, places: usize) {
        self.near.reserve(10 * places);
    }
}

/// Number of a step after all others: that of nodes whose motion every step finds.
const ALWAYS: u64 = u64::MAX;

impl<const DIM: usize> Explicit<DIM> {
    /// Number of the last step that finds the motion of each node, at the start: linked ones are found always.
    fn linked_nodes(&self) -> Vec<u64> {
        let mut found = vec![0; self.points.len()];
        let linked = self.own.iter().flat_map(|own| &own.linked);
        linked.for_each(|&node| found[node] = ALWAYS);
        found
    }

    /// Nothing moves.
    pub(in crate::dynamics) fn still(&self) -> Grid {
        let along = vec![0.0; self.masters.lag.len()];
        Grid {
            moving: vec![vec![Moving::default(); self.common.len()]; DIM - 1],
            more: vec![Wide::default(); self.common.len()],
            x: [along.clone(), along.clone()],
            lagged: along.clone(),
            pull: along,
            thrust: vec![0.0; self.reaches.len() + 1],
            near: Vec::new(),
            watched: Vec::new(),
            steps: 0,
            found: self.linked_nodes(),
            sound: Wide::default(),
        }
    }

    /// Nodes that are read in every step, beside those of links, struts and springs.
    pub(in crate::dynamics) fn watch(&self, grid: &mut Grid, nodes: impl Iterator<Item = usize>) {
        let points = nodes.map(|node| self.points[node]);
        grid.watched = points.filter(|&p| self.in_cluster[p].is_none()).collect();
        grid.watched.sort_unstable();
        grid.watched.dedup();
        for &point in &grid.watched {
            grid.found[self.nodes[point]] = ALWAYS;
        }
    }

    /// Nodes that are read in the coming step.
    pub(in crate::dynamics) fn look_at(&self, grid: &mut Grid, nodes: impl Iterator<Item = usize>) {
        grid.near.clear();
        for node in nodes {
            grid.near.push(self.points[node]);
            grid.found[node] = grid.found[node].max(grid.steps + 1);
        }
    }

    /// Forces of wires on the points of an island where they are, and those along on the masters. Every step
    /// leaves them.
    pub(in crate::dynamics) fn wire_forces(&self, island: usize, grid: &mut Grid) {
        let own = &self.own[island];
        widest(Stand(Sweep { p: self, own, grid }));
        self.lean(own, grid);
        self.hand_over(own, grid);
    }

    /// Forces of links, struts and springs; and the increments of their nodes, with `u` before the step.
    pub(super) fn settle_clusters<const D: usize>(
        &self,
        island: usize,
        grid: &mut Grid,
        (u, delta): (&[[f64; D]], &mut [[f64; D]]),
    ) {
        let own = &self.own[island];
        copy(&own.read, grid, |row| [&mut row.w]);
        widest(Settle {
            own,
            grid,
            u,
            delta,
        });
    }

    /// s of the points beyond cuts, as their strands have it; and d, as strands may be longer than others, which
    /// moves what is in the same rows.
    #[inline(always)]
    pub(super) fn copy_places(&self, own: &Block, grid: &mut Grid) {
        copy(&own.copies, grid, |row| [&mut row.s, &mut row.d]);
    }

    /// The same of w, of all blocks.
    pub(super) fn copy_forces(&self, own: &Own, grid: &mut Grid) {
        for block in &own.blocks {
            copy(&block.copies, grid, |row| [&mut row.w]);
        }
    }

    /// The point and the two on both sides of it, where they are at home.
    #[inline(always)]
    pub(super) fn around(&self, slot: usize) -> [usize; 5] {
        std::array::from_fn(|k| self.home[slot + LANES * k - 2 * LANES])
    }

    /// Rises up to the points behind cuts, which are copies there.
    #[inline(always)]
    pub(super) fn rise_to_tails(&self, own: &Block, grid: &mut Grid) {
        for cut in &own.cuts {
            let (row, lane) = place(cut.tail);
            let mut rise = grid.moving[0][row - 1].w[lane];
            for (across, rows) in self.across.iter().zip(&grid.moving) {
                let by = rows[row].s[lane] - rows[row - 1].s[lane];
                rise += across[row - 1].slope[lane] * by;
            }
            grid.moving[0][row].w[lane] = rise;
        }
    }

    /// h² times the acceleration of a point across, from w.
    #[inline(always)]
    pub(super) fn acceleration(&self, across: usize, slot: usize, rows: &[Moving]) -> f64 {
        let (row, lane) = place(slot);
        let around = self.around(slot);
        let w: [f64; 5] = std::array::from_fn(|k| {
            let (row, lane) = place(around[k]);
            rows[row].w[lane]
        });
        let near = &self.common[row - 1..=row + 1];
        let filter = std::array::from_fn(|k| near[k].filter[lane]);
        let second = std::array::from_fn(|k| near[k].second[lane]);
        accelerated(w, filter, second, self.across[across][row].inverse[lane])
    }

    /// Increments of the other nodes that are read, with `u` before the step.
    pub(super) fn show<const D: usize>(
        &self,
        grid: &Grid,
        (u, delta): (&[[f64; D]], &mut [[f64; D]]),
    ) {
        for &slot in grid.watched.iter().chain(&grid.near) {
            let (node, new) = (self.nodes[slot], self.at(grid, slot));
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
        // Loop by loop: an iterator over all of them is asked twice for each node.
        for &island in awake {
            for &node in &self.own[island].linked {
                let (u, delta) = (&mut u[node], &delta[node]);
                for c in 0..DIM {
                    u[c] += delta[c];
                }
            }
        }
        for &slot in grid.watched.iter().chain(&grid.near) {
            let node = self.nodes[slot];
            for (c, [place, speed]) in self.at(grid, slot).into_iter().enumerate() {
                (u[node][c], v[node][c]) = (place, speed);
            }
        }
    }

    /// Place and velocity of a point at the end of the step, component by component.
    #[inline(always)]
    fn at(&self, grid: &Grid, slot: usize) -> [[f64; 2]; DIM] {
        let (along, (row, lane)) = (&self.along[slot], place(slot));
        let mut found = [[0.0; 2]; DIM];
        found[0] = [
            along.read(&grid.x[0]),
            self.per_step * along.read(&grid.x[1]),
        ];
        for (across, rows) in grid.moving.iter().enumerate() {
            let a = self.acceleration(across, slot, rows);
            let (s, d) = (rows[row].s[lane], rows[row].d[lane]);
            let y = s - self.damped[row].lag[lane] * d;
            found[across + 1] = [y + BETA * a, self.per_step * (d + 0.5 * a)];
        }
        found
    }

    /// Take the step on one island, and find the forces of its wires for the next one.
    pub(super) fn go(&self, island: usize, grid: &mut Grid) {
        let own = &self.own[island];
        self.take_along(own, grid);
        self.copy_forces(own, grid);
        widest(Sweep { p: self, own, grid });
        self.lean(own, grid);
        self.hand_over(own, grid);
    }

    /// Whether an island is at rest where it was without any force.
    pub(in crate::dynamics) fn lies(&self, island: usize, grid: &Grid) -> bool {
        let own = &self.own[island];
        let rows = grid.moving.iter().flat_map(|all| &all[own.rows.clone()]);
        let across = rows.flat_map(|row| row.s.iter().chain(row.d.iter()));
        let along = grid.x.iter().flat_map(|list| &list[own.masters.clone()]);
        across.chain(along).all(|v| *v == 0.0)
    }

    /// Put an island back to rest.
    pub(in crate::dynamics) fn lay(&self, island: usize, grid: &mut Grid) {
        let own = &self.own[island];
        for rows in &mut grid.moving {
            rows[own.rows.clone()].fill(Moving::default());
        }
        grid.more[own.rows.clone()].fill(Wide::default());
        for list in grid.x.iter_mut().chain([&mut grid.pull]) {
            list[own.masters.clone()].fill(0.0);
        }
    }
}
