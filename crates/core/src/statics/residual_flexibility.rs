//! Residual flexibility in the statics: stiffnesses of elements attached to wires, and heights of
//! the real wire.
//!
//! A link pulls kinks into the wires at its ends, and each end moves by R T more than the mesh
//! shows (less, where R is negative). So for the mesh the link is one of 1/k′ = 1/k + R + R, and a
//! strut or a spring to ground one of 1/k + R. Across the track a wire is as compliant as in the
//! vertical; along the track R has no part, so R counts by 1 − n² with n the share of the direction
//! along the track. Links that share a node share its kink. The real wire at node n lies higher
//! than the mesh by Σ R(n, m) F_m, with F the sum of all point forces on a wire: the force that the
//! wire itself and its distributed loads do not balance.
//!
//! k′ stays positive: where a negative R would take more than half of 1/k, it takes that half.
//! Elements so stiff, 1/k below 2 |R| or some 0.8 µm/N, move by less than |R| times their force too
//! little, 0.04 mm for 100 N.

use super::assembly::{Geometry, Shape, add_weight};
use crate::error::CoreError;
use crate::residual_flexibility::patch::Patch;
use crate::structure::{ResidualFlexibility, SpringMode};
use std::collections::BTreeSet;

/// Share of its peak below which R is left out: with four elements to the rim, less is rounding.
const NEGLIGIBLE: f64 = 1e-3;
/// Bound on the rounds: changes of the tension change R, and R the tension by a thousandth of that.
const MOST_ROUNDS: usize = 20;
/// Relative change of a stiffness that is rounding.
const CONVERGED: f64 = 1e-12;
/// Smallest share of 1/k that a negative R leaves: k′ ≤ 2 k, so that it stays positive and of the
/// size of k.
const LEAST_SHARE: f64 = 0.5;

/// Sets the stiffness k′ of an element of given stiffness k on wires of residual flexibility `r`,
/// m/N; returns the relative change.
fn set_stiffness(stiffness: &mut f64, given: f64, r: f64) -> f64 {
    let share = 1.0 + given * r;
    let new = given / share.max(LEAST_SHARE);
    let change = (new - *stiffness).abs();
    *stiffness = new;
    // An element may have no stiffness.
    if change > 0.0 {
        change / given.abs()
    } else {
        0.0
    }
}

impl<const DIM: usize, const D: usize> Geometry<DIM, D> {
    /// Adds the residual flexibility of wires at the point forces of links, struts and springs,
    /// under the tension of the design. Unstretched lengths then are those between the clamps of
    /// the real wires.
    ///
    /// Wires are cubic elements, or chains whose bends are [fitted](Geometry::bending).
    pub fn add_residual_flexibility(&mut self) {
        let s = &self.structure;
        self.structure.residual = Some(ResidualFlexibility {
            links: s.links.iter().map(|link| link.stiffness).collect(),
            struts: s.struts.iter().map(|strut| strut.stiffness).collect(),
            springs: s.springs.iter().map(|spring| spring.stiffness).collect(),
            ..ResidualFlexibility::default()
        });
        self.update_residual_flexibility(None);
    }

    /// Refines the residual flexibility R until it is that of the tensions in equilibrium; returns
    /// the equilibrium. Without residual flexibility it is the given one.
    pub(super) fn refine_residual_flexibility(
        &mut self,
        mut shape: Shape<D>,
    ) -> Result<Shape<D>, CoreError> {
        if self.structure.residual.is_none() {
            return Ok(shape);
        }
        for _ in 0..MOST_ROUNDS {
            let change = self.update_residual_flexibility(Some(&shape));
            shape = self.find_equilibrium(&shape)?;
            if change <= CONVERGED {
                break;
            }
        }
        Ok(shape)
    }

    /// Updates R at all nodes with point forces, and the stiffnesses with it; returns the largest
    /// relative change of one.
    fn update_residual_flexibility(&mut self, shape: Option<&Shape<D>>) -> f64 {
        let Some(mut residual) = self.structure.residual.take() else {
            return 0.0;
        };
        let at_node = self.find_residual(shape, &mut residual.pairs);
        let hanging = self.net_hanging_links();
        // Directions at rest; before a design calculation, those of the drawing.
        let across = |direction: &[f64]| 1.0 - direction[0] * direction[0];
        let drawn = self.initial_shape();
        let shape = shape.unwrap_or(&drawn);
        let link_flexibilities: Vec<f64> = self
            .structure
            .links
            .iter()
            .map(|link| {
                let [a, b] = link.nodes;
                let flexibility =
                    hanging[a].max(0.0) * at_node[a] + (-hanging[b]).max(0.0) * at_node[b];
                across(&Self::link_state(shape, link).direction) * flexibility
            })
            .collect();
        let s = &mut self.structure;
        let mut most: f64 = 0.0;
        for ((link, &given), r) in s
            .links
            .iter_mut()
            .zip(&residual.links)
            .zip(link_flexibilities)
        {
            most = most.max(set_stiffness(&mut link.stiffness, given, r));
        }
        for (strut, &given) in s.struts.iter_mut().zip(&residual.struts) {
            let r = across(&strut.direction) * at_node[strut.node];
            most = most.max(set_stiffness(&mut strut.stiffness, given, r));
        }
        let all = s.springs.iter_mut().zip(&residual.springs);
        for (spring, &given) in all.filter(|(spring, _)| spring.component > 0) {
            most = most.max(set_stiffness(
                &mut spring.stiffness,
                given,
                at_node[spring.node],
            ));
        }
        s.residual = Some(residual);
        most
    }

    /// Number of links that hang on each node minus those that hold it up. Links that share a node
    /// share its kink: with equal forces each has R as often as links pull in its direction, and
    /// none where the force passes straight through. Pure dampers pull at no kink.
    fn net_hanging_links(&self) -> Vec<f64> {
        let mut hanging = vec![0.0; self.nodes()];
        for link in self.structure.links.iter().filter(|l| l.is_elastic()) {
            hanging[link.nodes[0]] += 1.0;
            hanging[link.nodes[1]] -= 1.0;
        }
        hanging
    }

    /// Residual flexibility R at all nodes with point forces, m/N; in `pairs` also between these
    /// and the nodes around them.
    fn find_residual(
        &self,
        shape: Option<&Shape<D>>,
        pairs: &mut Vec<(usize, usize, f64)>,
    ) -> Vec<f64> {
        let network = self.wire_network(shape);
        let mut at_node = vec![0.0; self.nodes()];
        pairs.clear();
        for node in self.loaded_nodes() {
            let patch = Patch::new(&network, &[node]);
            let Some((patch, response)) =
                patch.and_then(|p| p.unit_response((node, 0)).map(|r| (p, r)))
            else {
                continue;
            };
            let residual = |near: usize| {
                let [mesh, exact] = patch.displacement(&response, near);
                exact - mesh
            };
            at_node[node] = residual(node);
            let all = patch.nodes().map(|near| (near, node, residual(near)));
            let relevant = all.filter(|(_, _, r)| r.abs() > NEGLIGIBLE * at_node[node].abs());
            pairs.extend(relevant);
        }
        at_node
    }

    /// Nodes at which a point force may act on a wire.
    pub(crate) fn loaded_nodes(&self) -> BTreeSet<usize> {
        let s = &self.structure;
        let links = s.links.iter().flat_map(|link| link.nodes);
        let springs = s.springs.iter().map(|p| p.node);
        let struts = s.struts.iter().map(|t| t.node);
        let masses = s.masses.iter().map(|m| m.node);
        let loads = s.loads.iter().map(|l| l.0);
        let held = links.chain(springs).chain(struts);
        held.chain(masses).chain(loads).collect()
    }

    /// Upward point force on the wires at each node, N: the force that their elements, weight and
    /// loads do not balance.
    pub(crate) fn point_forces(&self, shape: &Shape<D>) -> Vec<f64> {
        let s = &self.structure;
        let mut residual = vec![[0.0; D]; self.nodes()];
        for wire in &s.wires {
            let mut force = Self::wire_force(shape, wire);
            add_weight(wire, s.gravity, &mut force);
            for ((node, slot), f) in wire.coordinate_slots().into_iter().zip(&force) {
                if slot == 0 {
                    residual[node][Self::UP] += f[DIM - 1];
                }
            }
        }
        self.add_chain_forces(shape, &mut residual);
        self.add_wire_loads(&mut residual);
        residual.iter().map(|node| node[Self::UP]).collect()
    }

    /// Heights of the nodes of the real wire above those of the mesh, m; empty without residual
    /// flexibility.
    #[must_use]
    pub fn subgrid_heights(&self, shape: &Shape<D>) -> Vec<f64> {
        let Some(residual) = &self.structure.residual else {
            return Vec::new();
        };
        let forces = self.point_forces(shape);
        let mut heights = vec![0.0; shape.len()];
        for &(node, source, flexibility) in &residual.pairs {
            heights[node] += flexibility * forces[source];
        }
        heights
    }

    /// Shape of the real wires at their nodes, m.
    #[must_use]
    pub fn real_shape(&self, shape: &Shape<D>) -> Shape<D> {
        let mut real = shape.clone();
        for (node, height) in real.iter_mut().zip(self.subgrid_heights(shape)) {
            node[Self::UP] += height;
        }
        real
    }

    /// Lowers the nodes that the design holds so that the real wire has the height of the drawing;
    /// returns the largest change, m.
    pub(super) fn hold_real_heights(&self, shape: &mut Shape<D>) -> f64 {
        let heights = self.subgrid_heights(shape);
        if heights.is_empty() {
            return 0.0;
        }
        let s = &self.structure;
        let lower = s.links.iter().filter(|l| l.adjust).map(|l| l.nodes[1]);
        let held = s.springs.iter();
        let held = held.filter(|p| p.mode == SpringMode::Held && p.component == Self::UP);
        let mut most: f64 = 0.0;
        for node in lower.chain(held.map(|p| p.node)) {
            let target = s.positions[node][Self::UP] - heights[node];
            most = most.max((target - shape[node][Self::UP]).abs());
            shape[node][Self::UP] = target;
        }
        most
    }
}
