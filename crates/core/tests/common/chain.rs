//! Chains of point masses made from wires of Hermite elements.

use arcless_core::CoreError;
use arcless_core::integrator::wire_model::WireModel;
use arcless_core::linear::model::LinearModel;
use arcless_core::slideline::Slideline;
use arcless_core::statics::{Geometry, Shape};
use arcless_core::structure::{Bend, Segment, Structure};

/// Every Hermite element becomes a segment, every node where two meet gets a bend.
pub fn lumped(s: &Structure) -> Structure {
    let mut t = s.clone();
    for wire in t.wires.drain(..) {
        t.segments.push(Segment {
            nodes: wire.nodes,
            rest_length: wire.section.rest_length,
            axial_stiffness: wire.section.axial_stiffness,
            turn: wire.turn,
            mass: wire.mass,
            damping: wire.damping,
            design_tension: wire.design_tension,
        });
    }
    for (k, pair) in s.wires.windows(2).enumerate() {
        if pair[0].nodes[1] == pair[1].nodes[0] {
            t.bends.push(Bend {
                segments: [k, k + 1],
                stiffness: pair[0].section.bending_stiffness,
                beta: pair[0].damping.beta,
            });
        }
    }
    t.slopes.fill([0.0; 3]);
    t
}

/// Geometry and shape in service, after the design calculation; chains with fitted bends have
/// residual flexibility.
pub fn settled<const DIM: usize, const D: usize>(s: Structure) -> (Geometry<DIM, D>, Shape<D>) {
    let mut geometry = Geometry::<DIM, D>::new(s).expect("a valid structure");
    if geometry.structure.fitted_bends {
        geometry.add_residual_flexibility();
    }
    let start = geometry.design().expect("the design converges");
    let shape = geometry
        .find_equilibrium(&start)
        .expect("the equilibrium converges");
    (geometry, shape)
}

/// Copy of a chain with fitted bends: its points yield as those of the wire do.
pub fn yielding(chain: &Structure) -> Structure {
    Structure {
        fitted_bends: true,
        ..chain.clone()
    }
}

/// Explicit steps of a chain, if they can be.
pub fn explicit<const DIM: usize, const D: usize>(
    (structure, lanes): &(Structure, Vec<Vec<usize>>),
    h: f64,
    contact_stiffness: f64,
) -> Result<WireModel<DIM, D>, CoreError> {
    let (geometry, shape) = settled::<DIM, D>(yielding(structure));
    let lanes = Slideline::from_elements(&geometry, &shape, lanes).expect("lanes");
    let lanes = Slideline::smoothed(lanes, &geometry, &shape);
    let line = LinearModel::new(&geometry, shape);
    WireModel::explicit(&geometry, line, lanes, h, contact_stiffness)
}
