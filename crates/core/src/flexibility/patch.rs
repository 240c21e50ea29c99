//! The wires around a place, in which R is found: motion across, heights fixed at the rim.

use super::taut::{Ends, Square, Taut};
use crate::element::hermite;
use crate::linalg::dense;
use crate::statics::assembly::{Geometry, Shape};
use std::collections::BTreeMap;

/// Elements from the place to the rim. R decays to a fifth over each, whatever holds the rim.
const REACH: usize = 4;

/// All wires of a structure, by their nodes.
#[derive(Debug)]
pub struct Web {
    wires: Vec<(Taut, [(usize, usize); 4])>,
    at: Vec<Vec<usize>>,
}

impl Web {
    /// The wires in a shape; in an unknown one under the tension of their design.
    #[must_use]
    pub fn new<const DIM: usize, const D: usize>(
        geometry: &Geometry<DIM, D>,
        shape: Option<&Shape<D>>,
    ) -> Self {
        let mut at = vec![Vec::new(); geometry.nodes()];
        let wires = geometry
            .structure
            .wires
            .iter()
            .enumerate()
            .map(|(k, wire)| {
                wire.nodes.iter().for_each(|&node| at[node].push(k));
                let tension = shape.map_or(wire.design_tension, |shape| {
                    let e = Geometry::<DIM, D>::straightened(shape, wire);
                    hermite::tension(&wire.section, &e, 0.5)
                });
                let taut = Taut {
                    length: wire.section.rest_length,
                    tension: tension.max(0.0),
                    bending: wire.section.bending_stiffness,
                };
                (taut, wire.places())
            });
        Self {
            wires: wires.collect(),
            at,
        }
    }

    /// A wire.
    #[must_use]
    pub fn wire(&self, number: usize) -> &Taut {
        &self.wires[number].0
    }
}

/// Stiffness of the wires around some nodes, of the mesh and exact: Cholesky's factors.
#[derive(Debug)]
pub struct Patch<'a> {
    web: &'a Web,
    unknowns: BTreeMap<(usize, usize), usize>,
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
        let (wires, unknowns) = around(web, nodes);
        let n = unknowns.len();
        let (mut mesh, mut exact) = (vec![0.0; n * n], vec![0.0; n * n]);
        for k in wires {
            let (taut, places) = &web.wires[k];
            let numbers = places.map(|place| unknowns.get(&place).copied());
            add(&mut mesh, n, &numbers, &taut.cubic());
            add(&mut exact, n, &numbers, &taut.exact());
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
        self.web.wires[wire].1.map(|place| self.respond(place))
    }

    /// Displacements of the ends of a wire: of the mesh and exact.
    #[must_use]
    pub fn ends(&self, of: &Response, wire: usize) -> [Ends; 2] {
        let places = &self.web.wires[wire].1;
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

/// Wires and unknowns (node, slot) around nodes.
fn around(web: &Web, nodes: &[usize]) -> (Vec<usize>, BTreeMap<(usize, usize), usize>) {
    let mut depth: BTreeMap<usize, usize> = nodes.iter().map(|&n| (n, 0)).collect();
    let (mut front, mut wires) = (nodes.to_vec(), Vec::new());
    for level in 1..=REACH {
        let mut next = Vec::new();
        for &k in front.iter().flat_map(|&node| &web.at[node]) {
            if wires.contains(&k) {
                continue;
            }
            wires.push(k);
            let places = web.wires[k].1;
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
    let is_held = |node: usize| depth.get(&node) == Some(&REACH) || web.at[node].len() < 2;
    let mut unknowns = BTreeMap::new();
    for &k in &wires {
        for (node, slot) in web.wires[k].1 {
            if slot == 1 || !is_held(node) {
                let n = unknowns.len();
                unknowns.entry((node, slot)).or_insert(n);
            }
        }
    }
    (wires, unknowns)
}

fn add(matrix: &mut [f64], n: usize, numbers: &[Option<usize>; 4], part: &Square) {
    for (i, row) in numbers.iter().zip(part) {
        for (j, value) in numbers.iter().zip(row) {
            if let (Some(i), Some(j)) = (i, j) {
                matrix[i * n + j] += value;
            }
        }
    }
}
