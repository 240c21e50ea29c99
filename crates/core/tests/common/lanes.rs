//! Straight wires without weight, side by side or one behind the other.

use super::Single;
use arcless_core::integrator::wire_model::WireModel;
use arcless_core::linear::model::LinearModel;
use arcless_core::scheme::Scheme;
use arcless_core::slideline::Slideline;
use arcless_core::statics::Geometry;
use arcless_core::structure::Structure;

/// A taut string of 60 m.
pub const STRING: Single = Single {
    length: 60.0,
    elements: 60,
    mass: 1.35,
    axial: 15e6,
    bending: 0.0,
    tension: 22e3,
    gravity: 0.0,
};

/// A wire in space: where it begins along the track, and both ends across and up.
#[derive(Clone, Copy)]
pub struct At {
    pub x: f64,
    pub across: [f64; 2],
    pub up: [f64; 2],
}

impl At {
    pub fn level(x: f64, up: f64) -> Self {
        let (across, up) = ([0.0; 2], [up; 2]);
        Self { x, across, up }
    }
}

/// Strings at the given places, each a lane of its own.
pub fn strings(s: &Single, places: &[At]) -> (Structure, Vec<Vec<usize>>) {
    let mut all = Structure {
        dim: 3,
        ..Structure::default()
    };
    let mut lanes = Vec::new();
    for at in places {
        let (one, _) = s.structure(3);
        let (nodes, wires) = (all.positions.len(), all.wires.len());
        let slope = |ends: [f64; 2]| (ends[1] - ends[0]) / s.length;
        for (mut r, mut t) in one.positions.into_iter().zip(one.slopes) {
            let share = r[0];
            r[0] += at.x;
            r[1] = at.across[0] + slope(at.across) * share;
            r[2] = at.up[0] + slope(at.up) * share;
            t[1] = slope(at.across) * t[0];
            t[2] = slope(at.up) * t[0];
            all.positions.push(r);
            all.slopes.push(t);
        }
        for mut wire in one.wires {
            wire.nodes = wire.nodes.map(|n| n + nodes);
            wire.slope_nodes = wire.slope_nodes.map(|n| n + nodes);
            all.wires.push(wire);
        }
        let fixed = one.fixed.into_iter();
        all.fixed.extend(fixed.map(|(node, c)| (node + nodes, c)));
        lanes.push((wires..all.wires.len()).collect());
    }
    (all, lanes)
}

/// A line of the given lanes, ready to step.
pub fn lined(
    (structure, lanes): (Structure, Vec<Vec<usize>>),
    scheme: Scheme,
    contact: f64,
) -> WireModel<3, 6> {
    let geometry = Geometry::<3, 6>::new(structure).expect("a valid structure");
    let shape = geometry
        .find_equilibrium(&geometry.initial_shape())
        .expect("at rest");
    let lanes = Slideline::from_elements(&geometry, &shape, &lanes).expect("lanes");
    WireModel::new(
        LinearModel::new(&geometry, shape),
        lanes,
        scheme,
        1e-3,
        contact,
    )
    .expect("regular")
}
