//! Explicit steps in the place of those with a matrix.

use super::{Explicit, Grid};
use crate::dynamics::islands::Island;
use crate::dynamics::stepper::{LineState, Prepared};

impl<const DIM: usize, const D: usize> Prepared<DIM, D> {
    /// As [`Prepared::free_increment`].
    pub(in crate::dynamics) fn free_explicit(
        &self,
        steps: &Explicit<DIM>,
        state: &mut LineState<D>,
        load: impl FnOnce(&mut [[f64; D]]) -> bool,
    ) {
        let LineState {
            u,
            delta,
            work,
            links,
            awake,
            grid: Some(grid),
            ..
        } = state
        else {
            return;
        };
        // Work is empty before and after, as most steps leave it.
        if load(work) {
            // Forces of collectors are on a few nodes, those of wind on all.
            let loaded = work.iter_mut().enumerate();
            for (node, force) in loaded.filter(|(_, force)| **force != [0.0; D]) {
                for c in 0..DIM {
                    steps.add_force(grid, steps.points[node], c, force[c]);
                }
                *force = [0.0; D];
            }
        }
        for &(link, correction) in &self.table.corrected {
            let is_in = |island: &Island| island.links.contains(&link);
            if self.awake(awake).any(is_in) {
                for (node, c, force) in self.line.links[link].shares(correction) {
                    steps.add_force(grid, steps.points[node], c, force);
                }
            }
        }
        for &island in &*awake {
            steps.settle_clusters(island, grid, (u, delta));
        }
        steps.show(grid, (u, delta));
        self.begin_links(awake, links, delta);
    }

    /// Add a share of forces on nodes to what moves the grid, if there is one.
    pub(in crate::dynamics) fn push(
        &self,
        grid: &mut Option<Grid>,
        shares: impl Iterator<Item = (usize, usize, f64)>,
        factor: f64,
    ) {
        if let (Some(steps), Some(grid)) = (self.explicit_steps(), grid) {
            for (node, component, share) in shares {
                steps.push(grid, node, component, factor * share);
            }
        }
    }
}

impl<const DIM: usize> Explicit<DIM> {
    /// As [`Prepared::advance`].
    pub(in crate::dynamics) fn advance<const D: usize>(&self, state: &mut LineState<D>) {
        let LineState {
            u,
            v,
            delta,
            awake,
            grid: Some(grid),
            ..
        } = state
        else {
            return;
        };
        self.take(grid, awake, delta, (u, v));
        for &island in &*awake {
            self.go(island, grid);
        }
    }
}
