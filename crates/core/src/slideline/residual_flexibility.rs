//! Residual flexibility of the wires of slidelines, found element by element: see
//! [`local_compliance`](crate::slideline::local_compliance).

use crate::element::hermite;
use crate::residual_flexibility::green_function::{
    ElementGreenFunction, NodeGreenFunction, ShapeFunctions,
};
use crate::residual_flexibility::patch::{Patch, WireNetwork};
use crate::slideline::Slideline;
use crate::slideline::local_compliance::{ElementCompliance, LocalCompliances, MOST_LINKS};
use crate::statics::assembly::{Geometry, Shape};
use std::sync::Arc;

/// Fields below this share of R of their own node are left out; one element further R is 8·10⁻³.
const NEGLIGIBLE: f64 = 2e-3;
/// Number of elements on which R of a second point is known; further on it is below 1 %.
const ELEMENTS_AHEAD: usize = 3;

/// Point forces on the wires.
struct Sources {
    /// Upward force on the wires at each node with anything attached, N.
    forces: Vec<(usize, f64)>,
    /// Links with a stiffness at each node, with the upward force on the wire per tension: R acts
    /// through k only, so that a pure damper would just take a place of [`MOST_LINKS`].
    links: Vec<Vec<(usize, f64)>>,
}

impl Sources {
    fn new<const DIM: usize, const D: usize>(
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
    ) -> Self {
        let forces = geometry.point_forces(shape);
        let mut links = vec![Vec::new(); geometry.nodes()];
        let all = geometry.structure.links.iter().enumerate();
        for (number, link) in all.filter(|(_, link)| link.is_elastic()) {
            let down = Geometry::<DIM, D>::link_state(shape, link).direction[DIM - 1];
            for (node, up) in link.nodes.into_iter().zip([down, -down]) {
                links[node].push((number, up));
            }
        }
        let loaded = geometry.loaded_nodes().into_iter();
        Self {
            forces: loaded.map(|node| (node, forces[node])).collect(),
            links,
        }
    }
}

/// Residual flexibility of element `wire`, followed by the elements `ahead` on the slideline.
fn element(
    network: &WireNetwork,
    sources: &Sources,
    (wire, nodes): (usize, &[usize; 2]),
    ahead: &[usize],
) -> ElementCompliance {
    let beam = *network.beam(wire);
    let mut compliance = ElementCompliance::none(beam);
    let Some(patch) = Patch::new(network, nodes) else {
        return compliance;
    };
    let responses = patch.unit_responses_at_ends(wire);
    let pair = |&other: &usize| ElementGreenFunction::new(&patch, &responses, other);
    compliance.pairs = std::iter::once(&wire).chain(ahead).map(pair).collect();
    let mut links = Vec::new();
    for node in patch.nodes() {
        let field = NodeGreenFunction::new(&patch, &responses, node);
        if let Ok(index) = sources.forces.binary_search_by_key(&node, |f| f.0) {
            compliance
                .static_height
                .add(sources.forces[index].1, &field);
        }
        let size = field.size(&beam);
        let of_node = sources.links[node].iter();
        links.extend(of_node.map(|&(link, up)| (size, (link, up, field))));
    }
    let middle = ShapeFunctions::new(&beam, 0.5, hermite::shape(0.5, beam.length));
    let peak = compliance.pairs[0].within(&beam, &middle, &middle);
    links.retain(|(size, _)| *size > NEGLIGIBLE * peak);
    links.sort_by(|a, b| b.0.total_cmp(&a.0));
    links.truncate(MOST_LINKS);
    compliance.links = links.into_iter().map(|(_, link)| link).collect();
    compliance
}

impl<const DIM: usize> Slideline<DIM> {
    /// Slidelines with the residual flexibility of their wires; `lists` are their elements.
    #[must_use]
    pub fn with_residual_flexibility<const D: usize>(
        slidelines: Vec<Self>,
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        lists: &[Vec<usize>],
    ) -> Vec<Self> {
        let everywhere = (f64::NEG_INFINITY, f64::INFINITY);
        Self::with_residual_flexibility_between(slidelines, geometry, shape, lists, everywhere)
    }

    /// Slidelines with the residual flexibility of elements that reach into a stretch between two
    /// coordinates along the track, m; beyond it they have none, and no point may be asked for.
    #[must_use]
    pub fn with_residual_flexibility_between<const D: usize>(
        mut slidelines: Vec<Self>,
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        lists: &[Vec<usize>],
        (from, to): (f64, f64),
    ) -> Vec<Self> {
        let network = geometry.wire_network(Some(shape));
        let sources = Sources::new(geometry, shape);
        for (slideline, wires) in slidelines.iter_mut().zip(lists) {
            let compliances = wires.iter().enumerate().map(|(k, &wire)| {
                let is_same_wire = |other: &usize| slideline.wires[*other] == slideline.wires[k];
                let next = (k + 1..wires.len().min(k + ELEMENTS_AHEAD)).take_while(is_same_wire);
                let ahead: Vec<usize> = next.map(|k| wires[k]).collect();
                let (first, last) = slideline.elements[k].range();
                if last < from || to < first {
                    return ElementCompliance::none(*network.beam(wire));
                }
                element(&network, &sources, (wire, &slideline.ends[k]), &ahead)
            });
            slideline.compliances = LocalCompliances::OfCubics(Arc::new(compliances.collect()));
        }
        slidelines
    }
}
