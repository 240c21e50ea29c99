//! What the wire of a lane yields beyond the mesh, element by element: see [`crate::flexibility`].
//!
//! With R_d = R(x, x_d) for the clamp of link d, positive where its tension raises the wire, k its
//! stiffness with R at both ends, and T_d − c ė = T₀ + k (e − R_d λ) + r its tension but for damping, the
//! wire at a contact under λ is at
//!
//!   z = z₀ + S(x)ᵀu + Σ R_d (T_d − c ė − T_d0) + R(x, x) λ
//!
//! and λ takes R_d λ from the elongation of the link. Both are one change of the vector of the contact,
//! and what is left is a compliance beside that of the contact law:
//!
//!   z = z₀ + sᵀu + Σ R_d (r − r₀) + R̃ λ,   s = S + Σ R_d k g_d,   R̃(x, y) = R(x, y) − Σ R_d(x) k R_d(y)
//!
//! The force acts on the mesh along the same s. So the matrix of a step stays symmetric in the
//! contacts, and R̃ is positive: R_d² ≤ R(x, x) R(x_d, x_d), and 1/k ≥ R(x_d, x_d). The static height z₀ has
//! the kinks of all that is at rest: Σ R F over the points with forces on the wire.
//!
//! R is a static one also under a moving force; decision 36 has what that leaves.

use crate::element::hermite;
use crate::flexibility::between::{Between, Field, Shapes};
use crate::flexibility::patch::{Patch, Web};
use crate::flexibility::taut::Taut;
use crate::slideline::Slideline;
use crate::slideline::point::SlidelinePoint;
use crate::statics::assembly::{Geometry, Shape};
use std::sync::Arc;

/// Most links that one place feels: with a node at every one, and four elements to the rim of a patch,
/// there are eight.
pub(crate) const MOST: usize = 8;
/// Fields below this share of R of their own node are left out: one more element away and R is 8·10⁻³.
const FAINT: f64 = 2e-3;
/// Elements ahead on which R of a second place is known: further on it is below 1 %.
const AHEAD: usize = 3;

/// What contacts with a lane meet beyond its mesh.
#[derive(Debug, Clone, Default)]
pub(crate) enum LocalCompliances {
    #[default]
    Nothing,
    /// Residual flexibility, element by element.
    OfCubics(Arc<Vec<ElementCompliance>>),
    /// That of a chain between its points: see [`rounded`](crate::slideline::smoothed_segment).
    OfChains,
}

/// Fields of one element of a lane.
#[derive(Debug)]
pub(crate) struct ElementCompliance {
    taut: Taut,
    /// R on the element itself, and between it and the next ones.
    pairs: Vec<Between>,
    /// What the forces at rest raise the wire by.
    rise: Field,
    /// Links, by how much their tension pulls the wire up, and R of the clamp.
    links: Vec<(usize, f64, Field)>,
}

/// What one place needs of it.
#[derive(Debug, Clone, Copy, Default)]
pub struct LocalCompliance {
    /// R(x, x), m/N.
    pub(crate) own: f64,
    /// Static height above the mesh, m.
    pub(crate) rise: f64,
    links: [usize; MOST],
    rises: [f64; MOST],
    count: usize,
}

impl LocalCompliance {
    /// Links and R_d, m/N.
    #[inline(always)]
    pub(crate) fn pulls(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        let (links, rises) = (&self.links[..self.count], &self.rises[..self.count]);
        links.iter().copied().zip(rises.iter().copied())
    }

    /// R_d of a link.
    #[inline(always)]
    pub(crate) fn of(&self, link: usize) -> f64 {
        let mut pulls = self.pulls();
        pulls.find(|(l, _)| *l == link).map_or(0.0, |(_, r)| r)
    }
}

impl ElementCompliance {
    /// Shape functions at a place with the given ones of the mesh.
    fn shapes(&self, weights: &[f64; 4]) -> Shapes {
        // A straight line is a cubic, so ξ = N₂ + (N₁′ + N₂′)/ℓ.
        let xi = weights[2] + (weights[1] + weights[3]) / self.taut.length;
        Shapes::new(&self.taut, xi, *weights)
    }

    fn at(&self, weights: &[f64; 4]) -> LocalCompliance {
        let shapes = self.shapes(weights);
        let mut found = LocalCompliance {
            own: self.pairs[0].within(&self.taut, &shapes, &shapes),
            rise: self.rise.at(&shapes),
            count: self.links.len(),
            ..LocalCompliance::default()
        };
        for (slot, (link, up, field)) in self.links.iter().enumerate() {
            found.links[slot] = *link;
            found.rises[slot] = up * field.at(&shapes);
        }
        found
    }
}

/// What point forces there are, for the fields of all elements.
struct Sources {
    /// Upward force on the wires at each node with anything attached, N.
    forces: Vec<(usize, f64)>,
    /// By node: links, and how much their tension pulls the wire up there.
    links: Vec<Vec<(usize, f64)>>,
}

impl Sources {
    fn new<const DIM: usize, const D: usize>(
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
    ) -> Self {
        let all = geometry.point_forces(shape);
        let mut links = vec![Vec::new(); geometry.nodes()];
        for (number, link) in geometry.structure.links.iter().enumerate() {
            let down = Geometry::<DIM, D>::link_state(shape, link).direction[DIM - 1];
            for (node, up) in link.nodes.into_iter().zip([down, -down]) {
                links[node].push((number, up));
            }
        }
        let loaded = geometry.loaded().into_iter();
        Self {
            forces: loaded.map(|node| (node, all[node])).collect(),
            links,
        }
    }
}

/// Fields of element `wire`, which those `ahead` follow on the lane.
fn element(
    web: &Web,
    sources: &Sources,
    (wire, nodes): (usize, &[usize; 2]),
    ahead: &[usize],
) -> ElementCompliance {
    let taut = *web.wire(wire);
    let mut found = ElementCompliance {
        taut,
        pairs: vec![Between::default()],
        rise: Field::default(),
        links: Vec::new(),
    };
    let Some(patch) = Patch::new(web, nodes) else {
        return found;
    };
    let responses = patch.respond_to_ends(wire);
    let pair = |&other: &usize| Between::of(&patch, &responses, other);
    found.pairs = std::iter::once(&wire).chain(ahead).map(pair).collect();
    let mut links = Vec::new();
    for node in patch.nodes() {
        let field = Field::of(&patch, &responses, node);
        if let Ok(at) = sources.forces.binary_search_by_key(&node, |f| f.0) {
            found.rise.add(sources.forces[at].1, &field);
        }
        let size = field.size(&taut);
        let of_node = sources.links[node].iter();
        links.extend(of_node.map(|&(link, up)| (size, (link, up, field))));
    }
    let middle = Shapes::new(&taut, 0.5, hermite::shape(0.5, taut.length));
    let peak = found.pairs[0].within(&taut, &middle, &middle);
    links.retain(|(size, _)| *size > FAINT * peak);
    links.sort_by(|a, b| b.0.total_cmp(&a.0));
    links.truncate(MOST);
    found.links = links.into_iter().map(|(_, link)| link).collect();
    found
}

/// R between two places on cubic elements, m/N.
fn between<const DIM: usize>(
    elements: &[ElementCompliance],
    first: &SlidelinePoint<DIM>,
    second: &SlidelinePoint<DIM>,
) -> f64 {
    let own = &elements[first.element];
    let Some(pair) = own.pairs.get(second.element - first.element) else {
        return 0.0;
    };
    let x = own.shapes(&first.weights);
    let y = elements[second.element].shapes(&second.weights);
    if first.element == second.element {
        pair.within(&own.taut, &x, &y)
    } else {
        pair.at(&x, &y)
    }
}

impl<const DIM: usize> Slideline<DIM> {
    /// Lanes on which contacts meet what their wires yield beyond the mesh; `lanes` are their wires.
    #[must_use]
    pub fn yielding<const D: usize>(
        mut paths: Vec<Self>,
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        lanes: &[Vec<usize>],
    ) -> Vec<Self> {
        let web = Web::new(geometry, Some(shape));
        let sources = Sources::new(geometry, shape);
        for (path, wires) in paths.iter_mut().zip(lanes) {
            let yields = wires.iter().enumerate().map(|(k, &wire)| {
                let is_one = |other: &usize| path.wires[*other] == path.wires[k];
                let next = (k + 1..wires.len().min(k + AHEAD)).take_while(is_one);
                let ahead: Vec<usize> = next.map(|k| wires[k]).collect();
                element(&web, &sources, (wire, &path.ends[k]), &ahead)
            });
            path.yields = LocalCompliances::OfCubics(Arc::new(yields.collect()));
        }
        paths
    }

    /// What the wire yields at a place beyond the mesh.
    #[inline]
    pub(crate) fn yield_at(&self, place: &SlidelinePoint<DIM>) -> LocalCompliance {
        match &self.yields {
            LocalCompliances::Nothing => LocalCompliance::default(),
            LocalCompliances::OfCubics(elements) => elements[place.element].at(&place.weights),
            LocalCompliances::OfChains => LocalCompliance {
                own: self.elements[place.element].missing(&place.weights),
                ..LocalCompliance::default()
            },
        }
    }

    /// Whether places on the lane yield as the mesh does.
    pub(crate) fn is_rigid(&self) -> bool {
        matches!(self.yields, LocalCompliances::Nothing)
    }

    /// R between two places on the lane, m/N.
    pub(crate) fn between(&self, a: &SlidelinePoint<DIM>, b: &SlidelinePoint<DIM>) -> f64 {
        let (first, second) = if a.element <= b.element {
            (a, b)
        } else {
            (b, a)
        };
        match &self.yields {
            LocalCompliances::Nothing => 0.0,
            LocalCompliances::OfCubics(elements) => between(elements, first, second),
            LocalCompliances::OfChains => {
                let [own, other] = [first, second].map(|at| &self.elements[at.element]);
                own.missing_between(&first.weights, other, &second.weights)
            }
        }
    }
}
