//! Explicit steps as an integrator.

use crate::constraint::wires::Wires;
use crate::integrator::explicit::Explicit;
use crate::integrator::state::{Stepping, WireState};
use crate::linear::island::Island;

impl<const DIM: usize> Explicit<DIM> {
    /// Predicts the increment without constraint forces: see
    /// [`WireModel::predict`](crate::integrator::wire_model::WireModel::predict).
    pub(crate) fn predict<const D: usize>(
        &self,
        p: &Wires<DIM, D>,
        state: &mut WireState<D>,
        load: impl FnOnce(&mut [[f64; D]]) -> bool,
    ) {
        let WireState {
            u,
            delta,
            work,
            awake,
            stepping: Stepping::Explicit(chain),
            ..
        } = state
        else {
            return;
        };
        // The vector is empty before and after, as in most steps.
        if load(work) {
            // Pantographs put forces on a few nodes, wind on all of them.
            let loaded = work.iter_mut().enumerate();
            for (node, force) in loaded.filter(|(_, force)| **force != [0.0; D]) {
                for c in 0..DIM {
                    self.add_point_force(chain, self.points[node], c, force[c]);
                }
                *force = [0.0; D];
            }
        }
        for &(link, correction) in &p.table.rest_corrections {
            let is_in = |island: &Island| island.links.contains(&link);
            if p.awake(awake).any(is_in) {
                for (node, c, force) in p.line.links[link].shares(correction) {
                    self.add_point_force(chain, self.points[node], c, force);
                }
            }
        }
        for &island in &*awake {
            self.apply_stiff_forces(island, chain, (u, delta));
        }
        self.gather_increments(chain, (u, delta));
    }

    /// Commits the step: see
    /// [`WireModel::commit`](crate::integrator::wire_model::WireModel::commit).
    pub(crate) fn commit<const D: usize>(&self, state: &mut WireState<D>) {
        let WireState {
            u,
            v,
            delta,
            awake,
            stepping: Stepping::Explicit(chain),
            ..
        } = state
        else {
            return;
        };
        self.commit_nodes(chain, awake, delta, (u, v));
        for &island in &*awake {
            self.advance_island(island, chain);
        }
        chain.steps += 1;
    }
}
