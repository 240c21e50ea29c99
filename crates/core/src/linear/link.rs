//! Links of the linearised line.

use crate::slideline::point::Nodal;
use crate::statics::assembly::{Geometry, Shape};
use crate::structure::Link;

/// Link about equilibrium: elongation e = n·(u₂ − u₁).
#[derive(Debug, Clone, Copy)]
pub struct LinearLink<const DIM: usize> {
    /// Upper and lower node.
    pub nodes: [usize; 2],
    /// Unit vector n from the upper to the lower node.
    pub direction: [f64; DIM],
    /// Stiffness, N/m.
    pub stiffness: f64,
    /// Damping along the link, with its proportional part, N·s/m.
    pub viscosity: f64,
    /// Tension k (ℓ − ℓ₀) at equilibrium, N; negative when it is slack at equilibrium.
    pub rest_tension: f64,
    /// True for a link that carries tension only.
    pub unilateral: bool,
}

impl<const DIM: usize> LinearLink<DIM> {
    pub(super) fn new<const D: usize>(link: &Link, shape: &Shape<D>) -> Self {
        let state = Geometry::<DIM, D>::link_state(shape, link);
        Self {
            nodes: link.nodes,
            direction: state.direction,
            stiffness: link.stiffness,
            viscosity: link.viscosity + link.damping.beta * link.stiffness,
            rest_tension: state.linear_tension,
            unilateral: link.unilateral,
        }
    }

    /// Returns the correction r₀ that acts at equilibrium, N: positive for a link that is slack
    /// there.
    #[must_use]
    pub fn rest_correction(&self) -> f64 {
        if self.unilateral {
            (-self.rest_tension).max(0.0)
        } else {
            0.0
        }
    }

    /// Returns the elongation e = gᵀx in a displacement field x, m.
    #[inline(always)]
    #[must_use]
    pub fn elongation<const D: usize>(&self, x: &(impl Nodal<D> + ?Sized)) -> f64 {
        let [a, b] = self.nodes.map(|node| x.at(node));
        let mut e = 0.0;
        for c in 0..DIM {
            e += self.direction[c] * (b[c] - a[c]);
        }
        e
    }

    /// Returns g, node by node: the forces of a unit tension.
    #[must_use]
    pub fn unit_pull<const D: usize>(&self) -> [(usize, [f64; D]); 2] {
        let [a, b] = self.nodes;
        let (mut upper, mut lower) = ([0.0; D], [0.0; D]);
        for c in 0..DIM {
            upper[c] = -self.direction[c];
            lower[c] = self.direction[c];
        }
        [(a, upper), (b, lower)]
    }

    /// Returns `factor` · g, entry by entry: node, component, force.
    pub(crate) fn shares(&self, factor: f64) -> impl Iterator<Item = (usize, usize, f64)> {
        let ([a, b], n) = (self.nodes, self.direction);
        let ends = [(a, -factor), (b, factor)].into_iter();
        ends.flat_map(move |(node, force)| (0..DIM).map(move |c| (node, c, force * n[c])))
    }

    /// Adds `factor` · g to `f`.
    pub fn add_to<const D: usize>(&self, factor: f64, f: &mut [[f64; D]]) {
        let [a, b] = self.nodes;
        for c in 0..DIM {
            f[a][c] -= factor * self.direction[c];
            f[b][c] += factor * self.direction[c];
        }
    }
}
