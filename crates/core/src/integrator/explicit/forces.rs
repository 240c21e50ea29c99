//! Forces on single points, with what the clusters beside them answer at once.

use crate::constraint::columns::ComplianceColumns;
use crate::integrator::explicit::simd::rows::{LANES, place};
use crate::integrator::explicit::{BETA, Explicit, Grid};

impl<const DIM: usize> Explicit<DIM> {
    /// Add a force on a component of a node.
    pub(crate) fn push(&self, grid: &mut Grid, node: usize, component: usize, force: f64) {
        let slot = self.points[node];
        if component == 0 {
            self.along[slot].add(force, &mut grid.pull);
            return;
        }
        let across = component - 1;
        let inverse = |slot: usize| {
            let (row, lane) = place(slot);
            self.across[across][row].inverse[lane]
        };
        let (row, lane) = place(slot);
        let change = inverse(slot) * force;
        grid.moving[across][row].w[lane] += change;
        let near = &self.common[row - 1..=row + 1];
        let [before, behind, _] = [0, 1, 2].map(|k| near[k].filter[lane]);
        let [left, own, right] = [0, 1, 2].map(|k| near[k].second[lane]);
        // One column of the matrix of Explicit::acceleration.
        let felt = [
            left,
            -before - 2.0 * (left + own),
            before + behind + left + 4.0 * own + right,
            -behind - 2.0 * (own + right),
            right,
        ];
        for (k, felt) in felt.into_iter().enumerate() {
            let near = slot + LANES * k - 2 * LANES;
            let felt = f64::from(u8::from(k == 2)) + inverse(near) * felt;
            if let Some((number, place)) = self.in_cluster[near] {
                self.answer(grid, number, place * DIM + component, felt * change);
            }
        }
    }

    /// What a cluster answers to the acceleration of one of its points, times h².
    fn answer(&self, grid: &mut Grid, number: usize, column: usize, acceleration: f64) {
        let cluster = &self.clusters[number];
        let n = cluster.size;
        for row in 0..n {
            let force = -cluster.of_change[row * n + column] * acceleration;
            self.add_force(grid, cluster.members[row / DIM].point, row % DIM, force);
        }
    }

    /// Add a force on a point, without the answer of clusters.
    #[inline(always)]
    pub(in crate::integrator::explicit) fn add_force(
        &self,
        grid: &mut Grid,
        slot: usize,
        component: usize,
        force: f64,
    ) {
        match component.checked_sub(1) {
            None => self.along[slot].add(force, &mut grid.pull),
            Some(across) => {
                let (row, lane) = place(slot);
                let inverse = self.across[across][row].inverse[lane];
                grid.moving[across][row].w[lane] += inverse * force;
            }
        }
    }

    /// Increment of the coming step for unit loads: node, component, force. Keeps it as a column; `grid`
    /// is empty before and after.
    pub(crate) fn set_column<const D: usize>(
        &self,
        columns: &mut ComplianceColumns<D>,
        number: usize,
        load: impl Iterator<Item = (usize, usize, f64)>,
        grid: &mut Grid,
    ) {
        let mut moved = Vec::new();
        for (node, component, force) in load {
            self.push(grid, node, component, force);
            for near in self.around(self.points[node]) {
                moved.push(near);
                if let Some((number, _)) = self.in_cluster[near] {
                    let members = &self.clusters[number].members;
                    moved.extend(members.iter().flat_map(|m| self.around(m.point)));
                }
            }
        }
        let mut found = std::collections::BTreeMap::<usize, [f64; D]>::new();
        for &slot in &moved {
            let node = self.nodes[slot];
            if node == usize::MAX || self.points[node] != slot {
                continue;
            }
            let row = found.entry(node).or_insert([0.0; D]);
            for (across, rows) in grid.moving.iter().enumerate() {
                row[across + 1] = BETA * self.acceleration(across, slot, rows);
            }
        }
        for slot in moved {
            let (row, lane) = place(slot);
            grid.moving
                .iter_mut()
                .for_each(|rows| rows[row].w[lane] = 0.0);
            let [a, b] = self.along[slot].masters;
            (grid.pull[a], grid.pull[b]) = (0.0, 0.0);
        }
        columns.keep(number, &found);
    }
}
