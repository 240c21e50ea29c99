//! The wires around a place, in which R is found: motion across, heights fixed at the rim.
//!
//! The mesh is one of cubic elements, or a chain: for a segment T/ℓ between the heights of its ends, for a bend
//! EI* ℓ̄ w wᵀ of the three heights beside it ([`chain`](crate::element::chain)). The exact stiffness is that of the same
//! wires cut at the same nodes; where a chain does not bend at a node, its wires turn freely there.

use super::taut::{Ends, Taut};
use crate::element::hermite;
use crate::linalg::dense;
use crate::statics::assembly::{Geometry, Shape};
use std::collections::{BTreeMap, BTreeSet};

/// Elements from the place to the rim. R of cubic elements decays to a fifth over each, whatever holds the rim.
const REACH: usize = 4;
/// R of a chain decays over the longer of its elements and λ = √(EI/T): the rim lies so many λ further out.
const RADII: f64 = 8.0;
/// Elements to the rim at most: those of a chain are hardly shorter than λ/2.
const FURTHEST: usize = 24;

/// A piece of wire, and where its four unknowns live.
#[derive(Debug)]
struct Piece {
    taut: Taut,
    places: [(usize, usize); 4],
}

/// What a bend of a chain makes of the heights of three nodes: stiffness i, j of them.
#[derive(Debug)]
struct Bent {
    nodes: [usize; 3],
    stiffness: [[f64; 3]; 3],
}

/// All wires of a structure, by their nodes.
#[derive(Debug)]
pub struct Web {
    pieces: Vec<Piece>,
    at: Vec<Vec<usize>>,
    /// Bends by their middle node; `None` for cubic elements.
    bends: Option<BTreeMap<usize, Bent>>,
}

impl Web {
    /// The wires in a shape; in an unknown one under the tension of their design.
    #[must_use]
    pub fn new<const DIM: usize, const D: usize>(
        geometry: &Geometry<DIM, D>,
        shape: Option<&Shape<D>>,
    ) -> Self {
        if geometry.structure.segments.is_empty() {
            Self::of_cubics(geometry, shape)
        } else {
            Self::of_chains(geometry, shape)
        }
    }

    fn of_cubics<const DIM: usize, const D: usize>(
        geometry: &Geometry<DIM, D>,
        shape: Option<&Shape<D>>,
    ) -> Self {
        let wires = geometry.structure.wires.iter();
        let pieces = wires.map(|wire| {
            let tension = shape.map_or(wire.design_tension, |shape| {
                let e = Geometry::<DIM, D>::straightened(shape, wire);
                hermite::tension(&wire.section, &e, 0.5)
            });
            let taut = Taut {
                length: wire.section.rest_length,
                tension: tension.max(0.0),
                bending: wire.section.bending_stiffness,
            };
            let places = wire.places();
            Piece { taut, places }
        });
        Self::with(geometry.nodes(), pieces.collect(), None)
    }

    fn of_chains<const DIM: usize, const D: usize>(
        geometry: &Geometry<DIM, D>,
        shape: Option<&Shape<D>>,
    ) -> Self {
        let s = &geometry.structure;
        // Slopes of its own for every end of a segment, but where two bend together.
        let mut slopes: Vec<[(usize, usize); 2]> = (0..s.segments.len())
            .map(|k| [2 * k, 2 * k + 1].map(|own| (usize::MAX - own, 1)))
            .collect();
        let mut bending = vec![0.0_f64; s.segments.len()];
        let mut bends = BTreeMap::new();
        for bend in &s.bends {
            let (nodes, element) = (s.bend_nodes(bend), geometry.bend_element(bend));
            let stiffness =
                std::array::from_fn(|i| std::array::from_fn(|j| element.stiffness(i, j)));
            bends.insert(nodes[1], Bent { nodes, stiffness });
            let [before, behind] = bend.segments;
            (slopes[before][1], slopes[behind][0]) = ((nodes[1], 1), (nodes[1], 1));
            for k in bend.segments {
                bending[k] = bending[k].max(bend.stiffness);
            }
        }
        let pieces = s.segments.iter().enumerate().map(|(k, segment)| {
            let (tension, length) =
                shape.map_or((segment.design_tension, segment.rest_length), |shape| {
                    let state = Geometry::<DIM, D>::segment_state(shape, segment);
                    (state.linear_tension, state.length)
                });
            let taut = Taut {
                length,
                tension: tension.max(0.0),
                bending: bending[k],
            };
            let ([a, b], [c, d]) = (segment.nodes, slopes[k]);
            let places = [(a, 0), c, (b, 0), d];
            Piece { taut, places }
        });
        Self::with(geometry.nodes(), pieces.collect(), Some(bends))
    }

    fn with(nodes: usize, pieces: Vec<Piece>, bends: Option<BTreeMap<usize, Bent>>) -> Self {
        let mut at = vec![Vec::new(); nodes];
        for (k, piece) in pieces.iter().enumerate() {
            at[piece.places[0].0].push(k);
            at[piece.places[2].0].push(k);
        }
        Self { pieces, at, bends }
    }

    /// A wire.
    #[must_use]
    pub fn wire(&self, number: usize) -> &Taut {
        &self.pieces[number].taut
    }

    /// Elements from some nodes to the rim of a patch around them.
    fn reach(&self, nodes: &[usize]) -> usize {
        if self.bends.is_none() {
            return REACH;
        }
        let beside = nodes.iter().flat_map(|&node| &self.at[node]);
        let radii = beside.map(|&k| {
            let taut = &self.pieces[k].taut;
            // λ over the length of the element.
            1.0 / taut.sharpness().max(1e-3)
        });
        let further = (RADII * radii.fold(0.0, f64::max)).ceil();
        (REACH + further as usize).min(FURTHEST)
    }

    /// Add the stiffness of the mesh between unknowns.
    fn add_mesh(&self, pieces: &[usize], unknowns: &Unknowns, matrix: &mut [f64]) {
        let Some(bends) = &self.bends else {
            for &k in pieces {
                let piece = &self.pieces[k];
                add(matrix, unknowns, &piece.places, &piece.taut.cubic());
            }
            return;
        };
        for &k in pieces {
            let piece = &self.pieces[k];
            let [a, _, b, _] = piece.places;
            let string = piece.taut.tension / piece.taut.length;
            add(
                matrix,
                unknowns,
                &[a, b],
                &[[string, -string], [-string, string]],
            );
        }
        let n = unknowns.len();
        for (&(node, slot), &i) in unknowns {
            if slot == 1 {
                // A chain has no slopes: they stay at rest, and nobody asks for them.
                matrix[i * n + i] = 1.0;
            } else if let Some(bent) = bends.get(&node) {
                let places = bent.nodes.map(|node| (node, 0));
                add(matrix, unknowns, &places, &bent.stiffness);
            }
        }
    }
}

/// Number of each unknown of a patch: node, and 0 for its height or 1 for its slope.
type Unknowns = BTreeMap<(usize, usize), usize>;

/// Stiffness of the wires around some nodes, of the mesh and exact: Cholesky's factors.
#[derive(Debug)]
pub struct Patch<'a> {
    web: &'a Web,
    unknowns: Unknowns,
    mesh: Vec<f64>,
    exact: Vec<f64>,
}

/// Displacements in a patch under a unit force on one unknown.
#[derive(Debug)]
pub struct Response {
    mesh: Vec<f64>,
    exact: Vec<f64>,
}

impl<'a> Patch<'a> {
    /// Around nodes; `None` when no wire is there, or when something is loose.
    #[must_use]
    pub fn new(web: &'a Web, nodes: &[usize]) -> Option<Self> {
        let (pieces, unknowns) = around(web, nodes);
        let n = unknowns.len();
        let (mut mesh, mut exact) = (vec![0.0; n * n], vec![0.0; n * n]);
        web.add_mesh(&pieces, &unknowns, &mut mesh);
        for &k in &pieces {
            let piece = &web.pieces[k];
            add(&mut exact, &unknowns, &piece.places, &piece.taut.exact());
        }
        Some(Self {
            mesh: dense::cholesky(&mesh, n)?,
            exact: dense::cholesky(&exact, n)?,
            web,
            unknowns,
        })
    }

    /// Under a unit force (couple) at a place; `None` where that is held.
    #[must_use]
    pub fn respond(&self, place: (usize, usize)) -> Option<Response> {
        let &number = self.unknowns.get(&place)?;
        let solve = |factor: &[f64]| {
            let mut x = vec![0.0; self.unknowns.len()];
            x[number] = 1.0;
            dense::solve_cholesky(factor, &mut x);
            x
        };
        Some(Response {
            mesh: solve(&self.mesh),
            exact: solve(&self.exact),
        })
    }

    /// Under a unit force at each end of a wire; none where that is held.
    #[must_use]
    pub fn respond_to_ends(&self, wire: usize) -> [Option<Response>; 4] {
        self.web.pieces[wire]
            .places
            .map(|place| self.respond(place))
    }

    /// Displacements of the ends of a wire: of the mesh and exact.
    #[must_use]
    pub fn ends(&self, of: &Response, wire: usize) -> [Ends; 2] {
        let places = &self.web.pieces[wire].places;
        [&of.mesh, &of.exact]
            .map(|x| places.map(|place| self.unknowns.get(&place).map_or(0.0, |&i| x[i])))
    }

    /// Displacement of a node: of the mesh and exact.
    #[must_use]
    pub fn at(&self, of: &Response, node: usize) -> [f64; 2] {
        let number = self.unknowns.get(&(node, 0));
        number.map_or([0.0; 2], |&i| [of.mesh[i], of.exact[i]])
    }

    /// Nodes whose height is unknown.
    pub fn nodes(&self) -> impl Iterator<Item = usize> + '_ {
        let heights = self.unknowns.keys().filter(|(_, slot)| *slot == 0);
        heights.map(|(node, _)| *node)
    }
}

/// Wires and unknowns around nodes.
fn around(web: &Web, nodes: &[usize]) -> (Vec<usize>, Unknowns) {
    let reach = web.reach(nodes);
    let mut depth: BTreeMap<usize, usize> = nodes.iter().map(|&n| (n, 0)).collect();
    let (mut front, mut pieces, mut known) = (nodes.to_vec(), Vec::new(), BTreeSet::new());
    for level in 1..=reach {
        let mut next = Vec::new();
        for &k in front.iter().flat_map(|&node| &web.at[node]) {
            if !known.insert(k) {
                continue;
            }
            pieces.push(k);
            let places = web.pieces[k].places;
            for (node, _) in [places[0], places[2]] {
                depth.entry(node).or_insert_with(|| {
                    next.push(node);
                    level
                });
            }
        }
        front = next;
    }
    // The ends of a wire are held as well, by what it ends at.
    let is_held = |node: usize| depth.get(&node) == Some(&reach) || web.at[node].len() < 2;
    let mut unknowns = BTreeMap::new();
    for &k in &pieces {
        for (node, slot) in web.pieces[k].places {
            if slot == 1 || !is_held(node) {
                let n = unknowns.len();
                unknowns.entry((node, slot)).or_insert(n);
            }
        }
    }
    (pieces, unknowns)
}

/// Add a part between places to a matrix of unknowns.
fn add<const N: usize>(
    matrix: &mut [f64],
    unknowns: &Unknowns,
    places: &[(usize, usize); N],
    part: &[[f64; N]; N],
) {
    let n = unknowns.len();
    let numbers = places.map(|place| unknowns.get(&place).copied());
    for (i, row) in numbers.iter().zip(part) {
        for (j, value) in numbers.iter().zip(row) {
            if let (Some(i), Some(j)) = (i, j) {
                matrix[i * n + j] += value;
            }
        }
    }
}
