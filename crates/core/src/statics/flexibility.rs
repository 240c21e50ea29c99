//! Residual flexibility in the statics: stiffnesses of what is attached to wires, and heights of the real wire.
//!
//! A link pulls kinks into the wires at its ends, and each yields by R T more than the mesh shows (less, where R is
//! negative). So for the mesh the link is one of 1/k′ = 1/k + R + R, and a strut or a spring to ground one of
//! 1/k + R. Across the track a wire yields as it does in the vertical; along the track R has no part, so R counts by
//! 1 − n² with n the share of the direction along the track. Links that share a node share its kink. The real wire at
//! node n lies higher than the mesh by Σ R(n, m) F_m, with F the sum of all that acts on a wire at a point: what the
//! wire itself and what is spread along it do not balance.
//!
//! k′ stays positive: where a negative R would take more than half of 1/k, it takes that half. What is so stiff,
//! 1/k below 2 |R| or some 0.8 µm/N, moves by less than |R| times its force too little, 0.04 mm for 100 N.

use super::assembly::{Geometry, Shape, add_weight};
use crate::error::CoreError;
use crate::flexibility::patch::{Patch, Web};
use crate::structure::{ResidualFlexibility, SpringMode};
use std::collections::BTreeSet;

/// R below this share of its peak is left out: with four elements to the rim less is no number.
const FAINT: f64 = 1e-3;
/// Changes of the tension change R, and R the tension by a thousandth of that.
const MOST_ROUNDS: usize = 20;
/// Change of a stiffness that is rounding.
const SAME: f64 = 1e-12;
/// Share of 1/k that a negative R leaves at least: k′ ≤ 2 k, so that it stays positive and of the size of k.
const LEAST: f64 = 0.5;

/// Give something of stiffness k on wires that yield R more than the mesh its k′; returns the relative change.
fn set(stiffness: &mut f64, given: f64, r: f64) -> f64 {
    let share = 1.0 + given * r;
    let new = given / share.max(LEAST);
    let change = (new - *stiffness).abs();
    *stiffness = new;
    // Nothing may have no stiffness.
    if change > 0.0 {
        change / given.abs()
    } else {
        0.0
    }
}

impl<const DIM: usize, const D: usize> Geometry<DIM, D> {
    /// Let links, struts and springs yield with the kinks that they pull into their wires, under the
    /// tension of the design. Unstretched lengths then are those between the clamps of the real wires.
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
        self.soften(None);
    }

    /// Equilibrium in which R is that of its own tensions; nothing to do without residual flexibility.
    pub(super) fn resettle(&mut self, mut shape: Shape<D>) -> Result<Shape<D>, CoreError> {
        if self.structure.residual.is_none() {
            return Ok(shape);
        }
        for _ in 0..MOST_ROUNDS {
            let change = self.soften(Some(&shape));
            shape = self.settle(&shape)?;
            if change <= SAME {
                break;
            }
        }
        Ok(shape)
    }

    /// Find R at all nodes with point forces, and the stiffnesses with it; returns the largest relative
    /// change of one.
    fn soften(&mut self, shape: Option<&Shape<D>>) -> f64 {
        let Some(mut residual) = self.structure.residual.take() else {
            return 0.0;
        };
        let own = self.find_residual(shape, &mut residual.pairs);
        let hanging = self.hanging();
        // Directions at rest; of a design that has not begun, those of the drawing.
        let across = |direction: &[f64]| 1.0 - direction[0] * direction[0];
        let drawn = self.initial_shape();
        let shape = shape.unwrap_or(&drawn);
        let of_links: Vec<f64> = self
            .structure
            .links
            .iter()
            .map(|link| {
                let [a, b] = link.nodes;
                let yields = hanging[a].max(0.0) * own[a] + (-hanging[b]).max(0.0) * own[b];
                across(&Self::link_state(shape, link).direction) * yields
            })
            .collect();
        let s = &mut self.structure;
        let mut most: f64 = 0.0;
        for ((link, &given), r) in s.links.iter_mut().zip(&residual.links).zip(of_links) {
            most = most.max(set(&mut link.stiffness, given, r));
        }
        for (strut, &given) in s.struts.iter_mut().zip(&residual.struts) {
            let r = across(&strut.direction) * own[strut.node];
            most = most.max(set(&mut strut.stiffness, given, r));
        }
        let all = s.springs.iter_mut().zip(&residual.springs);
        for (spring, &given) in all.filter(|(spring, _)| spring.component > 0) {
            most = most.max(set(&mut spring.stiffness, given, own[spring.node]));
        }
        s.residual = Some(residual);
        most
    }

    /// How many more links hang on each node than hold it up. Links that share a node pull its kink together: with
    /// equal forces each feels R as often as links pull its way, and not at all where the force goes straight through.
    fn hanging(&self) -> Vec<f64> {
        let mut hanging = vec![0.0; self.nodes()];
        for link in &self.structure.links {
            hanging[link.nodes[0]] += 1.0;
            hanging[link.nodes[1]] -= 1.0;
        }
        hanging
    }

    /// R at all nodes with point forces, m/N; and between these and the nodes around them.
    fn find_residual(
        &self,
        shape: Option<&Shape<D>>,
        pairs: &mut Vec<(usize, usize, f64)>,
    ) -> Vec<f64> {
        let web = Web::new(self, shape);
        let mut own = vec![0.0; self.nodes()];
        pairs.clear();
        for node in self.loaded() {
            let patch = Patch::new(&web, &[node]);
            let Some((patch, response)) = patch.and_then(|p| p.respond((node, 0)).map(|r| (p, r)))
            else {
                continue;
            };
            let missing = |near: usize| {
                let [mesh, exact] = patch.at(&response, near);
                exact - mesh
            };
            own[node] = missing(node);
            let found = patch.nodes().map(|near| (near, node, missing(near)));
            let felt = found.filter(|(_, _, r)| r.abs() > FAINT * own[node].abs());
            pairs.extend(felt);
        }
        own
    }

    /// Nodes at which something may act on a wire.
    pub(crate) fn loaded(&self) -> BTreeSet<usize> {
        let s = &self.structure;
        let links = s.links.iter().flat_map(|link| link.nodes);
        let springs = s.springs.iter().map(|p| p.node);
        let struts = s.struts.iter().map(|t| t.node);
        let masses = s.masses.iter().map(|m| m.node);
        let loads = s.loads.iter().map(|l| l.0);
        let held = links.chain(springs).chain(struts);
        held.chain(masses).chain(loads).collect()
    }

    /// Upward force on the wires at each node, N: what their elements, weight and loads do not balance.
    pub(crate) fn point_forces(&self, shape: &Shape<D>) -> Vec<f64> {
        let s = &self.structure;
        let mut residual = vec![[0.0; D]; self.nodes()];
        for wire in &s.wires {
            let mut force = Self::wire_force(shape, wire);
            add_weight(wire, s.gravity, &mut force);
            for ((node, slot), f) in wire.places().into_iter().zip(&force) {
                if slot == 0 {
                    residual[node][Self::UP] += f[DIM - 1];
                }
            }
        }
        self.add_chain_forces(shape, &mut residual);
        self.add_wire_loads(&mut residual);
        residual.iter().map(|node| node[Self::UP]).collect()
    }

    /// What the nodes of the real wire lie above those of the mesh, m; empty without residual flexibility.
    #[must_use]
    pub fn rises(&self, shape: &Shape<D>) -> Vec<f64> {
        let Some(residual) = &self.structure.residual else {
            return Vec::new();
        };
        let forces = self.point_forces(shape);
        let mut rises = vec![0.0; shape.len()];
        for &(node, source, missing) in &residual.pairs {
            rises[node] += missing * forces[source];
        }
        rises
    }

    /// The shape of the real wires at their nodes.
    #[must_use]
    pub fn real_shape(&self, shape: &Shape<D>) -> Shape<D> {
        let mut real = shape.clone();
        for (node, rise) in real.iter_mut().zip(self.rises(shape)) {
            node[Self::UP] += rise;
        }
        real
    }

    /// Put what the design holds in height so low that the real wire has the height of the drawing;
    /// returns the largest change, m.
    pub(super) fn hold_real_heights(&self, shape: &mut Shape<D>) -> f64 {
        let rises = self.rises(shape);
        if rises.is_empty() {
            return 0.0;
        }
        let s = &self.structure;
        let lower = s.links.iter().filter(|l| l.adjust).map(|l| l.nodes[1]);
        let held = s.springs.iter();
        let held = held.filter(|p| p.mode == SpringMode::Held && p.component == Self::UP);
        let mut most: f64 = 0.0;
        for node in lower.chain(held.map(|p| p.node)) {
            let wanted = s.positions[node][Self::UP] - rises[node];
            most = most.max((wanted - shape[node][Self::UP]).abs());
            shape[node][Self::UP] = wanted;
        }
        most
    }
}
