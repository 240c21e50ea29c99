//! Beams without tension: they carry by bending alone, and the design leaves no axial force.

use crate::tests::common;

use arcless_core::CoreError;
use arcless_core::statics::Geometry;
use arcless_core::structure::Structure;
use common::chain::{lumped, settled};
use common::{Single, orders};

const BEAM: Single = Single {
    length: 8.0,
    elements: 8,
    mass: 8.1,
    axial: 1.5e8,
    bending: 1.7e5,
    tension: 0.0,
    gravity: 9.81,
};

/// The beam drawn straight; its far end slides in service.
fn structure(s: &Single) -> Structure {
    let mut made = s.structure(2).0;
    for (i, (position, slope)) in made.positions.iter_mut().zip(&mut made.slopes).enumerate() {
        *position = [s.length * i as f64 / s.elements as f64, 0.0, 0.0];
        *slope = [1.0, 0.0, 0.0];
    }
    made.ends[0].released = true;
    made
}

/// Sag 5 w L⁴/384 EI of a hinged beam. Source: Timoshenko, Strength of Materials I, section 35. The
/// next terms are of the order of the squared slope at the ends, (16/5 · sag/L)² = 1e-4.
fn sag() -> f64 {
    5.0 * BEAM.mass * 9.81 * BEAM.length.powi(4) / (384.0 * BEAM.bending)
}

/// Cubic elements are exact at the nodes of a beam with even load.
#[test]
fn beam_sags_by_bending_alone() {
    let (geometry, shape) = settled::<2, 4>(structure(&BEAM));
    let found = -shape[BEAM.elements / 2][1];
    assert!((found / sag() - 1.0).abs() < 1e-4, "{found} {}", sag());
    // The way of the sliding end since the design: none, what is held is also what is balanced.
    assert!((shape[BEAM.elements][0] - BEAM.length).abs() < 1e-10);
    // Lengths follow the slopes, ∫ ½ z′² = 17/70 · (16 sag/5)²/L · … > 0: longer than the chord.
    let lengths = geometry.structure.wires.iter();
    let total: f64 = lengths.map(|w| w.section.rest_length).sum();
    assert!(total > BEAM.length && total < BEAM.length * (1.0 + 1e-4));
}

#[test]
fn chain_without_tension_converges_to_the_beam() {
    let errors = [8, 16, 32].map(|elements| {
        let made = lumped(&structure(&Single { elements, ..BEAM }));
        let (_, shape) = settled::<2, 2>(made);
        -shape[elements / 2][1] - sag()
    });
    let errors = errors.map(f64::abs);
    // Differences in place of derivatives leave O(ℓ²).
    assert!(
        orders(&errors).iter().all(|&p| (p - 2.0).abs() < 0.1),
        "{errors:?}"
    );
}

#[test]
fn what_neither_pulls_nor_bends_is_refused() {
    let limp = Single {
        bending: 0.0,
        ..BEAM
    };
    let refused = Geometry::<2, 4>::new(structure(&limp)).err();
    assert!(matches!(
        refused,
        Some(CoreError::Input { array: "wires", .. })
    ));
    let mut pushed = lumped(&structure(&BEAM));
    pushed.segments[0].design_tension = -1.0;
    let refused = Geometry::<2, 2>::new(pushed).err();
    assert!(matches!(
        refused,
        Some(CoreError::Input {
            array: "segments",
            ..
        })
    ));
}
