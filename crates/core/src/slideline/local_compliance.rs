//! Local compliance of the wire of a slideline beyond the mesh, element by element: see
//! [`crate::residual_flexibility`].
//!
//! With R_d = R(x, x_d) for the clamp of link d, positive where its tension raises the wire, k its
//! stiffness with R at both ends, and T_d − c ė = T₀ + k (e − R_d λ) + r its tension without
//! damping, the wire at a contact under λ is at
//!
//!   z = z₀ + S(x)ᵀu + Σ R_d (T_d − c ė − T_d0) + R(x, x) λ
//!
//! and λ takes R_d λ from the elongation of the link. Both are one change of the vector of the
//! contact, and the rest is a compliance in addition to that of the contact law:
//!
//!   z = z₀ + sᵀu + Σ R_d (r − r₀) + R̃ λ,
//!   s = S + Σ R_d k g_d,   R̃(x, y) = R(x, y) − Σ R_d(x) k R_d(y)
//!
//! The force acts on the mesh along the same s. So the matrix of a step stays symmetric in the
//! contacts, and R̃ is positive: R_d² ≤ R(x, x) R(x_d, x_d), and 1/k ≥ R(x_d, x_d). The static
//! height z₀ has the kinks of all forces at rest: Σ R F over the points with forces on the wire.
//!
//! R is that of statics also under a moving force; decision 36 tells the error that this leaves.

use crate::residual_flexibility::green_function::{
    ElementGreenFunction, NodeGreenFunction, ShapeFunctions,
};
use crate::residual_flexibility::string_beam::StringBeam;
use crate::slideline::point::SlidelinePoint;
use std::sync::Arc;

/// Largest number of links with residual flexibility to one point: with a node at every one, and
/// four elements to the rim of a patch, there are eight.
pub(crate) const MOST_LINKS: usize = 8;

/// Local compliances of a slideline.
#[derive(Debug, Clone, Default)]
pub(crate) enum LocalCompliances {
    #[default]
    Nothing,
    /// Residual flexibility of cubic elements, element by element.
    OfCubics(Arc<Vec<ElementCompliance>>),
    /// Residual flexibility of a chain between its points: see
    /// [`smoothed_segment`](crate::slideline::smoothed_segment).
    OfChains,
}

/// Residual flexibility of one element of a slideline.
#[derive(Debug)]
pub(crate) struct ElementCompliance {
    pub(super) beam: StringBeam,
    /// Residual flexibility R on the element itself, and between it and the next ones.
    pub(super) pairs: Vec<ElementGreenFunction>,
    /// Static height above the mesh under the forces at rest, m.
    pub(super) static_height: NodeGreenFunction,
    /// Links: index, upward force on the wire per tension, and R of the clamp.
    pub(super) links: Vec<(usize, f64, NodeGreenFunction)>,
}

/// Local compliance at a point.
#[derive(Debug, Clone, Copy, Default)]
pub struct LocalCompliance {
    /// Residual flexibility R(x, x), m/N.
    pub(crate) flexibility: f64,
    /// Static height above the mesh, m.
    pub(crate) static_height: f64,
    links: [usize; MOST_LINKS],
    link_flexibilities: [f64; MOST_LINKS],
    count: usize,
}

impl LocalCompliance {
    /// Residual flexibility R(x, x) of a chain between its points, m/N.
    pub(super) fn of_chain(flexibility: f64) -> Self {
        Self {
            flexibility,
            ..Self::default()
        }
    }

    /// Links with their residual flexibility R_d, m/N.
    #[inline(always)]
    pub(crate) fn links(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        let links = self.links[..self.count].iter();
        let flexibilities = self.link_flexibilities[..self.count].iter();
        links.copied().zip(flexibilities.copied())
    }

    /// Residual flexibility R_d of a link, m/N; zero without one.
    #[inline(always)]
    pub(crate) fn of_link(&self, link: usize) -> f64 {
        let mut links = self.links();
        links.find(|(l, _)| *l == link).map_or(0.0, |(_, r)| r)
    }
}

impl ElementCompliance {
    /// Element without residual flexibility.
    pub(super) fn none(beam: StringBeam) -> Self {
        Self {
            beam,
            pairs: vec![ElementGreenFunction::default()],
            static_height: NodeGreenFunction::default(),
            links: Vec::new(),
        }
    }

    /// Exact and cubic shape functions at a point with the given ones of the mesh.
    fn shapes(&self, weights: &[f64; 4]) -> ShapeFunctions {
        // A straight line is a cubic, so ξ = N₂ + (N₁′ + N₂′)/ℓ.
        let xi = weights[2] + (weights[1] + weights[3]) / self.beam.length;
        ShapeFunctions::new(&self.beam, xi, *weights)
    }

    /// Local compliance at the point with these shape functions of the mesh.
    pub(super) fn at(&self, weights: &[f64; 4]) -> LocalCompliance {
        let shapes = self.shapes(weights);
        let mut compliance = LocalCompliance {
            flexibility: self.pairs[0].within(&self.beam, &shapes, &shapes),
            static_height: self.static_height.at(&shapes),
            count: self.links.len(),
            ..LocalCompliance::default()
        };
        for (slot, (link, up, field)) in self.links.iter().enumerate() {
            compliance.links[slot] = *link;
            compliance.link_flexibilities[slot] = up * field.at(&shapes);
        }
        compliance
    }
}

/// Residual flexibility R between two points of cubic elements, m/N.
pub(super) fn between<const DIM: usize>(
    elements: &[ElementCompliance],
    first: &SlidelinePoint<DIM>,
    second: &SlidelinePoint<DIM>,
) -> f64 {
    let element = &elements[first.element];
    let Some(pair) = element.pairs.get(second.element - first.element) else {
        return 0.0;
    };
    let x = element.shapes(&first.weights);
    let y = elements[second.element].shapes(&second.weights);
    if first.element == second.element {
        pair.within(&element.beam, &x, &y)
    } else {
        pair.at(&x, &y)
    }
}
