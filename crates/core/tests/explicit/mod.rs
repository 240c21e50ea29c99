//! Explicit steps of chains, against closed forms and against the implicit ones.

mod energy;
mod growth;
mod guests;
mod islands;
mod lines;
mod live;
mod refusals;
mod rest;
mod rounded;
mod waves;

use crate::tests::common::chain::{self, lumped, settled, yielding};
use crate::tests::common::{Single, steady, three_masses};
use arcless_core::CoreError;
use arcless_core::integrator::wire_model::WireModel;
use arcless_core::linear::model::LinearModel;
use arcless_core::scheme::Scheme;
use arcless_core::simulation::inputs::Trajectory;
use arcless_core::simulation::recording::record::{Record, RecordPlan};
use arcless_core::slideline::Slideline;
use arcless_core::statics::{Geometry, Shape};
use arcless_core::structure::{Spring, SpringMode, Structure};

pub const CONTACT: f64 = 50e3;

/// A wire of 50 m that sags by 19 cm.
pub const WIRE: Single = Single {
    length: 50.0,
    elements: 100,
    mass: 1.35,
    axial: 15e6,
    bending: 195.0,
    tension: 22e3,
    gravity: 9.81,
};

/// A chain and the wires of its lanes.
pub type Chain = (Structure, Vec<Vec<usize>>);

/// Explicit steps, if they can be.
pub fn prepare<const DIM: usize, const D: usize>(
    chain: &Chain,
    h: f64,
) -> Result<WireModel<DIM, D>, CoreError> {
    chain::explicit(chain, h, CONTACT)
}

pub fn explicit<const DIM: usize, const D: usize>(chain: &Chain, h: f64) -> WireModel<DIM, D> {
    prepare(chain, h).expect("short steps")
}

/// Model of the chain for the trapezoidal rule, with its own bends, and chords between its points.
pub fn implicit<const DIM: usize, const D: usize>(
    (structure, lanes): &Chain,
    h: f64,
) -> WireModel<DIM, D> {
    solved(structure.clone(), lanes, h, |_, _, lanes| lanes)
}

/// Model as of `implicit`, with points that yield as those of the wire do.
pub fn angular<const DIM: usize, const D: usize>(
    (structure, lanes): &Chain,
    h: f64,
) -> WireModel<DIM, D> {
    solved(yielding(structure), lanes, h, |_, _, lanes| lanes)
}

/// Model as of `angular`, with curves between points: all that explicit steps have.
pub fn fitted<const DIM: usize, const D: usize>(
    (structure, lanes): &Chain,
    h: f64,
) -> WireModel<DIM, D> {
    solved(yielding(structure), lanes, h, |geometry, shape, lanes| {
        Slideline::smoothed(lanes, geometry, shape)
    })
}

/// EI x coth x, x = (ℓ/2)√(T/EI).
pub fn stiffer(bending: f64, tension: f64, length: f64) -> f64 {
    let x = 0.5 * length * (tension / bending).sqrt();
    bending * x / x.tanh()
}

fn solved<const DIM: usize, const D: usize>(
    structure: Structure,
    lanes: &[Vec<usize>],
    h: f64,
    change: impl FnOnce(&Geometry<DIM, D>, &Shape<D>, Vec<Slideline<DIM>>) -> Vec<Slideline<DIM>>,
) -> WireModel<DIM, D> {
    let (geometry, shape) = settled::<DIM, D>(structure);
    let lanes = Slideline::from_elements(&geometry, &shape, lanes).expect("lanes");
    let lanes = change(&geometry, &shape, lanes);
    let line = LinearModel::new(&geometry, shape);
    WireModel::new(line, lanes, Scheme::newmark(0.25, 0.5), h, CONTACT).expect("regular")
}

/// A spring that does as good as nothing: steps tell of a node that has one.
pub fn seen(node: usize, component: usize) -> Spring {
    Spring {
        node,
        component,
        stiffness: 1e-9,
        viscosity: 0.0,
        rest: 0.0,
        mode: SpringMode::Unloaded,
    }
}

/// A wire as a chain, of which the node in the middle is seen.
pub fn seen_wire(s: &Single, dim: usize) -> Chain {
    let (structure, path) = s.structure(dim);
    let mut chain = lumped(&structure);
    chain.springs.push(seen(s.elements / 2, dim - 1));
    (chain, vec![path])
}

/// All that is recorded but energies.
pub fn plan(nodes: Vec<usize>) -> RecordPlan {
    RecordPlan {
        contact_every: 1,
        line_every: 1,
        links: true,
        nodes,
        supports: Vec::new(),
        points: Vec::new(),
        ledger: false,
        ledger_every: 1,
        near: None,
        motion: None,
    }
}

/// From a place, for some seconds, in steps of h.
pub fn way(start: f64, speed: f64, h: f64, seconds: f64) -> Trajectory {
    steady(start, speed, h, (seconds / h).round() as usize)
}

/// A run of the three masses.
pub fn pass<const DIM: usize, const D: usize>(
    p: &WireModel<DIM, D>,
    force: f64,
    travel: &Trajectory,
    plan: &RecordPlan,
) -> Record {
    let pantographs = [three_masses(force)];
    p.run(&pantographs, travel, plan, &mut |_| true)
        .expect("a run")
}

/// Every n-th value, the n-th first: the ends of long steps among short ones.
pub fn every(n: usize, values: &[f64]) -> Vec<f64> {
    values.iter().skip(n - 1).step_by(n).copied().collect()
}
