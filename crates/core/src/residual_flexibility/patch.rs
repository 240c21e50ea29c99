//! Patch of wires around a place, in which R is found: motion across, heights fixed at the rim.
//!
//! The mesh is one of cubic elements, or a chain: for a segment T/ℓ between the heights of its
//! ends, for a bend EI* ℓ̄ w wᵀ of the three heights next to it ([`chain`](crate::element::chain)).
//! The exact stiffness is that of the same wires divided at the same nodes; where a chain does not
//! bend at a node, its wires turn freely there.

use super::string_beam::{EndVector, StringBeam};
use crate::linalg::dense;
use std::collections::{BTreeMap, BTreeSet};

/// Least number of elements from the place to the rim. R of cubic elements decays to a fifth over
/// each, however the rim is held.
const MIN_ELEMENTS_TO_RIM: usize = 4;
/// Additional distance of the rim for chains, in lengths λ = √(EI/T): their R decays over the
/// longer of element and λ.
const DECAY_LENGTHS: f64 = 8.0;
/// Largest number of elements to the rim: those of a chain are hardly shorter than λ/2.
const MAX_ELEMENTS_TO_RIM: usize = 24;

/// Element between two nodes, with the coordinates of its ends.
#[derive(Debug)]
pub struct NetworkElement {
    /// Exact and cubic stiffness of the element.
    pub beam: StringBeam,
    /// Coordinates: node, and 0 for its height or 1 for its slope; both ends, height before slope.
    pub coordinates: [(usize, usize); 4],
}

/// Stiffness of a chain's bend for the heights of three nodes.
#[derive(Debug)]
pub struct BendStiffness {
    /// Nodes, in the order along the wire.
    pub nodes: [usize; 3],
    /// Stiffness i, j of the heights, N/m.
    pub stiffness: [[f64; 3]; 3],
}

/// Elements of all wires of a structure, by their nodes.
#[derive(Debug)]
pub struct WireNetwork {
    elements: Vec<NetworkElement>,
    at_node: Vec<Vec<usize>>,
    /// Bends by their middle node; `None` for cubic elements.
    bends: Option<BTreeMap<usize, BendStiffness>>,
}

impl WireNetwork {
    /// Builds a network of elements; bends of chains by their middle node, `None` for cubic
    /// elements.
    #[must_use]
    pub fn new(
        nodes: usize,
        elements: Vec<NetworkElement>,
        bends: Option<BTreeMap<usize, BendStiffness>>,
    ) -> Self {
        let mut at_node = vec![Vec::new(); nodes];
        for (k, element) in elements.iter().enumerate() {
            at_node[element.coordinates[0].0].push(k);
            at_node[element.coordinates[2].0].push(k);
        }
        Self {
            elements,
            at_node,
            bends,
        }
    }

    /// Returns the beam of an element.
    #[must_use]
    pub fn beam(&self, number: usize) -> &StringBeam {
        &self.elements[number].beam
    }

    /// Returns the number of elements from `nodes` to the rim of a patch around them.
    fn elements_to_rim(&self, nodes: &[usize]) -> usize {
        if self.bends.is_none() {
            return MIN_ELEMENTS_TO_RIM;
        }
        let adjacent = nodes.iter().flat_map(|&node| &self.at_node[node]);
        let decay_lengths = adjacent.map(|&k| {
            let beam = &self.elements[k].beam;
            // Decay length over the length of the element.
            1.0 / beam.tension_parameter().max(1e-3)
        });
        let decay_elements = (DECAY_LENGTHS * decay_lengths.fold(0.0, f64::max)).ceil();
        (MIN_ELEMENTS_TO_RIM + decay_elements as usize).min(MAX_ELEMENTS_TO_RIM)
    }

    /// Adds the stiffness of the mesh between unknowns, N/m.
    fn add_mesh(&self, elements: &[usize], unknowns: &Unknowns, matrix: &mut [f64]) {
        let Some(bends) = &self.bends else {
            for &k in elements {
                let element = &self.elements[k];
                add_part(
                    matrix,
                    unknowns,
                    &element.coordinates,
                    &element.beam.cubic(),
                );
            }
            return;
        };
        for &k in elements {
            let element = &self.elements[k];
            let [a, _, b, _] = element.coordinates;
            let string = element.beam.tension / element.beam.length;
            add_part(
                matrix,
                unknowns,
                &[a, b],
                &[[string, -string], [-string, string]],
            );
        }
        let n = unknowns.len();
        for (&(node, kind), &i) in unknowns {
            if kind == 1 {
                // A chain has no slopes: they stay zero and are not read.
                matrix[i * n + i] = 1.0;
            } else if let Some(bend) = bends.get(&node) {
                let coordinates = bend.nodes.map(|node| (node, 0));
                add_part(matrix, unknowns, &coordinates, &bend.stiffness);
            }
        }
    }
}

/// Number of each unknown of a patch: node, and 0 for its height or 1 for its slope.
type Unknowns = BTreeMap<(usize, usize), usize>;

/// Stiffness of the wires around nodes, of the mesh and exact: Cholesky factors.
#[derive(Debug)]
pub struct Patch<'a> {
    network: &'a WireNetwork,
    unknowns: Unknowns,
    mesh: Vec<f64>,
    exact: Vec<f64>,
}

/// Displacements in a patch under a unit force on one unknown, m/N: of the mesh and exact.
#[derive(Debug)]
pub struct PatchResponse {
    mesh: Vec<f64>,
    exact: Vec<f64>,
}

impl<'a> Patch<'a> {
    /// Collects the patch around nodes; `None` without a wire there, or with a loose part.
    #[must_use]
    pub fn new(network: &'a WireNetwork, nodes: &[usize]) -> Option<Self> {
        let (elements, unknowns) = collect_around(network, nodes);
        let n = unknowns.len();
        let (mut mesh, mut exact) = (vec![0.0; n * n], vec![0.0; n * n]);
        network.add_mesh(&elements, &unknowns, &mut mesh);
        for &k in &elements {
            let element = &network.elements[k];
            add_part(
                &mut exact,
                &unknowns,
                &element.coordinates,
                &element.beam.exact(),
            );
        }
        Some(Self {
            mesh: dense::cholesky(&mesh, n)?,
            exact: dense::cholesky(&exact, n)?,
            network,
            unknowns,
        })
    }

    /// Returns the response to a unit force (couple) at a coordinate; `None` where that is held.
    #[must_use]
    pub fn unit_response(&self, coordinate: (usize, usize)) -> Option<PatchResponse> {
        let &number = self.unknowns.get(&coordinate)?;
        let solve = |factor: &[f64]| {
            let mut x = vec![0.0; self.unknowns.len()];
            x[number] = 1.0;
            dense::solve_cholesky(factor, &mut x);
            x
        };
        Some(PatchResponse {
            mesh: solve(&self.mesh),
            exact: solve(&self.exact),
        })
    }

    /// Returns the responses to unit forces at the ends of an element; `None` where those are held.
    #[must_use]
    pub fn unit_responses_at_ends(&self, wire: usize) -> [Option<PatchResponse>; 4] {
        self.network.elements[wire]
            .coordinates
            .map(|coordinate| self.unit_response(coordinate))
    }

    /// Returns the displacements of the ends of an element: of the mesh and exact.
    #[must_use]
    pub fn end_displacements(&self, response: &PatchResponse, wire: usize) -> [EndVector; 2] {
        let coordinates = &self.network.elements[wire].coordinates;
        [&response.mesh, &response.exact].map(|x| {
            coordinates.map(|coordinate| self.unknowns.get(&coordinate).map_or(0.0, |&i| x[i]))
        })
    }

    /// Returns the displacement of a node: of the mesh and exact.
    #[must_use]
    pub fn displacement(&self, response: &PatchResponse, node: usize) -> [f64; 2] {
        let number = self.unknowns.get(&(node, 0));
        number.map_or([0.0; 2], |&i| [response.mesh[i], response.exact[i]])
    }

    /// Iterates over the nodes whose height is unknown.
    pub fn nodes(&self) -> impl Iterator<Item = usize> + '_ {
        let heights = self.unknowns.keys().filter(|(_, kind)| *kind == 0);
        heights.map(|(node, _)| *node)
    }
}

/// Collects the elements and unknowns around nodes.
fn collect_around(network: &WireNetwork, nodes: &[usize]) -> (Vec<usize>, Unknowns) {
    let elements_to_rim = network.elements_to_rim(nodes);
    let mut depth: BTreeMap<usize, usize> = nodes.iter().map(|&n| (n, 0)).collect();
    let (mut front, mut elements, mut visited) = (nodes.to_vec(), Vec::new(), BTreeSet::new());
    for level in 1..=elements_to_rim {
        let mut next = Vec::new();
        for &k in front.iter().flat_map(|&node| &network.at_node[node]) {
            if !visited.insert(k) {
                continue;
            }
            elements.push(k);
            let coordinates = network.elements[k].coordinates;
            for (node, _) in [coordinates[0], coordinates[2]] {
                depth.entry(node).or_insert_with(|| {
                    next.push(node);
                    level
                });
            }
        }
        front = next;
    }
    // The ends of a wire are held as well, by their supports.
    let is_held =
        |node: usize| depth.get(&node) == Some(&elements_to_rim) || network.at_node[node].len() < 2;
    let mut unknowns = BTreeMap::new();
    for &k in &elements {
        for (node, kind) in network.elements[k].coordinates {
            if kind == 1 || !is_held(node) {
                let n = unknowns.len();
                unknowns.entry((node, kind)).or_insert(n);
            }
        }
    }
    (elements, unknowns)
}

/// Adds a part between coordinates to a matrix of unknowns.
fn add_part<const N: usize>(
    matrix: &mut [f64],
    unknowns: &Unknowns,
    coordinates: &[(usize, usize); N],
    part: &[[f64; N]; N],
) {
    let n = unknowns.len();
    let numbers = coordinates.map(|coordinate| unknowns.get(&coordinate).copied());
    for (i, row) in numbers.iter().zip(part) {
        for (j, value) in numbers.iter().zip(row) {
            if let (Some(i), Some(j)) = (i, j) {
                matrix[i * n + j] += value;
            }
        }
    }
}
