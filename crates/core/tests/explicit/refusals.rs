//! Refusal of lines that explicit steps cannot compute.

use super::{Chain, WIRE, prepare, seen_wire};
use crate::tests::common::chain::settled;
use crate::tests::common::simple_line;
use arcless_core::CoreError;
use arcless_core::integrator::wire_model::WireModel;
use arcless_core::linear::model::LinearModel;
use arcless_core::slideline::Slideline;
use arcless_core::structure::{Link, Rayleigh};

const STEP: f64 = 1e-3;

fn reason(refused: Result<WireModel<2, 2>, CoreError>) -> String {
    match refused {
        Err(CoreError::Input {
            array: "solver",
            reason,
        }) => reason,
        other => panic!("{:?}", other.map(|_| "it runs")),
    }
}

#[test]
fn cubic_elements_are_refused() {
    let (structure, path) = simple_line(2);
    let (geometry, shape) = settled::<2, 4>(structure);
    let lanes = Slideline::from_elements(&geometry, &shape, &[path]).expect("a path");
    let line = LinearModel::new(&geometry, shape);
    let refused = WireModel::explicit(&geometry, line, lanes, STEP, 5e4);
    let Err(CoreError::Input { array, reason }) = refused else {
        panic!("cubic elements have no point masses");
    };
    assert_eq!(array, "solver");
    assert!(reason.contains("cubic elements"), "{reason}");
}

fn link(nodes: [usize; 2], mass: f64) -> Link {
    Link {
        nodes,
        rest_length: 1.0,
        stiffness: 1e5,
        viscosity: 0.0,
        damping: Rayleigh::default(),
        mass,
        unilateral: false,
        adjust: false,
    }
}

/// A comb of links from one node of the wire to others of it.
fn comb(others: usize) -> Chain {
    let (mut s, lanes) = seen_wire(&WIRE, 2);
    let nodes = (0..others).map(|k| 20 + 2 * k);
    let links = nodes.map(|node| Link {
        rest_length: 0.5 * (node - 10) as f64,
        stiffness: 1e3,
        ..link([10, node], 0.1)
    });
    s.links.extend(links);
    (s, lanes)
}

/// A cluster of 48 components is the largest: 24 points in the plane.
#[test]
fn clusters_that_are_too_large_are_refused() {
    let refused = reason(prepare(&comb(24), STEP));
    assert!(
        refused.contains("25 points linked with each other"),
        "{refused}"
    );
    assert!(prepare::<2, 2>(&comb(23), STEP).is_ok());
}
