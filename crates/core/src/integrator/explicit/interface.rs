//! Explicit steps behind the interface of integrators.

use crate::integrator::explicit::Explicit;
use crate::integrator::prepared::WireModel;
use crate::integrator::{Stepping, WireState};
use crate::simulation::sleep::Island;

impl<const DIM: usize> Explicit<DIM> {
    /// As [`WireModel::predict`].
    pub(crate) fn predict<const D: usize>(
        &self,
        p: &WireModel<DIM, D>,
        state: &mut WireState<D>,
        load: impl FnOnce(&mut [[f64; D]]) -> bool,
    ) {
        let WireState {
            u,
            delta,
            work,
            awake,
            stepping: Stepping::Explicit(grid),
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
                    self.add_force(grid, self.points[node], c, force[c]);
                }
                *force = [0.0; D];
            }
        }
        for &(link, correction) in &p.table.corrected {
            let is_in = |island: &Island| island.links.contains(&link);
            if p.awake(awake).any(is_in) {
                for (node, c, force) in p.line.links[link].shares(correction) {
                    self.add_force(grid, self.points[node], c, force);
                }
            }
        }
        for &island in &*awake {
            self.settle_clusters(island, grid, (u, delta));
        }
        self.show(grid, (u, delta));
    }

    /// As [`WireModel::commit`].
    pub(crate) fn commit<const D: usize>(&self, state: &mut WireState<D>) {
        let WireState {
            u,
            v,
            delta,
            awake,
            stepping: Stepping::Explicit(grid),
            ..
        } = state
        else {
            return;
        };
        self.take(grid, awake, delta, (u, v));
        for &island in &*awake {
            self.go(island, grid);
        }
        grid.steps += 1;
    }
}
