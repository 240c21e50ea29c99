//! Forces on single points, with what the clusters beside them answer at once.

use super::{BETA, Explicit, Grid};
use crate::dynamics::columns::Columns;

impl<const DIM: usize> Explicit<DIM> {
    /// Acceleration of a point across, from w.
    #[inline(always)]
    pub(super) fn acceleration(&self, across: usize, point: usize, w: &[f64]) -> f64 {
        let (filter, w) = (&self.filter[point - 1..=point], &w[point - 1..=point + 1]);
        let (left, right) = (filter[0] * (w[1] - w[0]), filter[1] * (w[2] - w[1]));
        w[1] - self.inverse[across][point] * (right - left)
    }

    /// Add a force on a component of a node.
    pub(in crate::dynamics) fn push(
        &self,
        grid: &mut Grid,
        node: usize,
        component: usize,
        force: f64,
    ) {
        let point = self.points[node];
        if component == 0 {
            self.along[point].add(force, &mut grid.pull);
            return;
        }
        let across = component - 1;
        let change = self.inverse[across][point] * force;
        grid.w[across][point] += change;
        for neighbour in [point - 1, point, point + 1] {
            let Some((number, place)) = self.in_cluster[neighbour] else {
                continue;
            };
            // One column of the matrix of Explicit::acceleration.
            let inverse = self.inverse[across][neighbour];
            let felt = if neighbour == point {
                1.0 + inverse * (self.filter[point] + self.filter[point - 1])
            } else {
                -inverse * self.filter[point.min(neighbour)]
            };
            self.answer(grid, number, place * DIM + component, felt * change);
        }
    }

    /// What a cluster answers to the acceleration of one of its points.
    fn answer(&self, grid: &mut Grid, number: usize, column: usize, acceleration: f64) {
        let cluster = &self.clusters[number];
        let n = cluster.members.len() * DIM;
        for row in 0..n {
            let force = -cluster.of_change[row * n + column] * acceleration;
            self.add_force(grid, cluster.members[row / DIM].point, row % DIM, force);
        }
    }

    /// Add a force on a point, without the answer of clusters.
    #[inline(always)]
    pub(super) fn add_force(&self, grid: &mut Grid, point: usize, component: usize, force: f64) {
        match component.checked_sub(1) {
            None => self.along[point].add(force, &mut grid.pull),
            Some(across) => grid.w[across][point] += self.inverse[across][point] * force,
        }
    }

    /// Increment of the coming step for unit loads: node, component, force. Keeps it as a column; `grid`
    /// is empty before and after.
    pub(in crate::dynamics) fn set_column<const D: usize>(
        &self,
        columns: &mut Columns<D>,
        number: usize,
        load: impl Iterator<Item = (usize, usize, f64)>,
        grid: &mut Grid,
    ) {
        let mut moved = Vec::new();
        for (node, component, force) in load {
            self.push(grid, node, component, force);
            let point = self.points[node];
            for near in [point - 1, point, point + 1] {
                moved.push(near);
                if let Some((number, _)) = self.in_cluster[near] {
                    for member in &self.clusters[number].members {
                        moved.extend(member.point - 1..=member.point + 1);
                    }
                }
            }
        }
        let mut found = std::collections::BTreeMap::<usize, [f64; D]>::new();
        let squared = BETA * self.h * self.h;
        for &point in &moved {
            let node = self.nodes[point];
            if node == usize::MAX || self.points[node] != point {
                continue;
            }
            let row = found.entry(node).or_insert([0.0; D]);
            for across in 0..DIM - 1 {
                row[across + 1] = squared * self.acceleration(across, point, &grid.w[across]);
            }
        }
        for point in moved {
            grid.w.iter_mut().for_each(|w| w[point] = 0.0);
            let [a, b] = self.along[point].masters;
            (grid.pull[a], grid.pull[b]) = (0.0, 0.0);
        }
        columns.keep(number, &found);
    }
}
