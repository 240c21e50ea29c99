//! Lumped masses: one list for every model of a line.
//!
//! Half of the mass of a segment, a link or a strut's moving part goes to each node that it moves.
//! The mass-proportional damping of a node is Σ α m over its lumped masses.

use crate::statics::assembly::{Geometry, Shape};

/// Mass at a node, kg, with the factor α of its damping α m, 1/s.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LumpedMass {
    pub node: usize,
    pub mass: f64,
    pub alpha: f64,
}

/// Returns the masses of the segments of chains, half at each end.
pub(crate) fn of_segments<const DIM: usize, const D: usize>(
    geometry: &Geometry<DIM, D>,
) -> impl Iterator<Item = LumpedMass> {
    geometry.structure.segments.iter().flat_map(|segment| {
        let (mass, alpha) = (
            0.5 * segment.mass * segment.rest_length,
            segment.damping.alpha,
        );
        segment.nodes.map(|node| LumpedMass { node, mass, alpha })
    })
}

/// Returns the masses on the wires: point masses, links (half at each end), moving parts of struts.
/// Struts have the damping of most wires, `common_alpha`.
pub(crate) fn on_wires<'a, const DIM: usize, const D: usize>(
    geometry: &'a Geometry<DIM, D>,
    shape: &'a Shape<D>,
    common_alpha: f64,
) -> impl Iterator<Item = LumpedMass> + 'a {
    let s = &geometry.structure;
    let points = s.masses.iter().map(|m| LumpedMass {
        node: m.node,
        mass: m.mass,
        alpha: m.alpha,
    });
    let links = s.links.iter().flat_map(move |link| {
        let length = Geometry::<DIM, D>::link_state(shape, link).length;
        let (mass, alpha) = (0.5 * link.mass * length, link.damping.alpha);
        link.nodes.map(|node| LumpedMass { node, mass, alpha })
    });
    let struts = s.struts.iter().map(move |strut| LumpedMass {
        node: strut.node,
        mass: strut.moving_mass,
        alpha: common_alpha,
    });
    points.chain(links).chain(struts)
}
