//! Loads along the wires as forces on nodes.

use super::assembly::{Geometry, Shape};
use crate::error::CoreError;

impl<const DIM: usize, const D: usize> Geometry<DIM, D> {
    /// Subtracts the steady loads along the wires of the structure from the residual, N.
    pub(super) fn add_wire_loads(&self, residual: &mut Shape<D>) {
        self.distribute(&self.structure.wire_loads, |node, c, force| {
            residual[node][c] -= force;
        });
    }

    /// Forces on nodes (node, component, N) of a force per metre of rest length on each wire
    /// element or segment, N/m.
    ///
    /// # Errors
    /// [`CoreError::Input`] when there is not one for each, or one is not finite.
    pub fn nodal_forces(&self, load: &[[f64; 3]]) -> Result<Vec<(usize, usize, f64)>, CoreError> {
        let expected = self.structure.wires.len() + self.structure.segments.len();
        let invalid = || {
            let reason = format!("has {} entries, expected {expected}, finite", load.len());
            CoreError::invalid("load", reason)
        };
        if load.len() != expected {
            return Err(invalid());
        }
        let mut forces = vec![[0.0; D]; self.nodes()];
        self.distribute(load, |node, c, force| forces[node][c] += force);
        // Sums may overflow: large loads on long elements.
        if forces.iter().flatten().any(|force| !force.is_finite()) {
            return Err(invalid());
        }
        let entries = forces.iter().enumerate().flat_map(|(node, forces)| {
            let components = forces.iter().enumerate();
            components.map(move |(c, &force)| (node, c, force))
        });
        Ok(entries.filter(|(_, _, force)| *force != 0.0).collect())
    }

    /// Distributes a load per metre q to the nodes: ∫ Sₖ q ds on each coordinate of a wire element;
    /// half of it on each end of a segment.
    fn distribute(&self, load: &[[f64; 3]], mut add: impl FnMut(usize, usize, f64)) {
        let s = &self.structure;
        let (on_wires, on_segments) = load.split_at(s.wires.len().min(load.len()));
        for (wire, load) in s.wires.iter().zip(on_wires) {
            let l = wire.section.rest_length;
            let shares = [0.5 * l, l * l / 12.0, 0.5 * l, -l * l / 12.0];
            for ((node, slot), share) in wire.coordinate_slots().into_iter().zip(shares) {
                (0..DIM).for_each(|c| add(node, slot * DIM + c, share * load[c]));
            }
        }
        for (segment, load) in s.segments.iter().zip(on_segments) {
            for node in segment.nodes {
                (0..DIM).for_each(|c| add(node, c, 0.5 * segment.rest_length * load[c]));
            }
        }
    }
}
