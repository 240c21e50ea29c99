//! Motion along a straight wire, against the recurrence of one mode.
//!
//! With n equal axial elements of L₀ between held ends, masters move as sin (πk/n), and with
//! Λ = (4 EA h²/μ L₀²) sin² (π/2n)
//!
//!   d′ = (1 − αh) d − Λ (x + (β/h) d),   x′ = x + d′
//!
//! whose determinant is 1 − αh − Λβ/h: the factor of x d′ − x′ d of a mode in every step.

use crate::integrator::explicit::{ChainState, Explicit};
use crate::integrator::wire_model::Integrator;
use crate::integrator::wire_model::WireModel;
use crate::structure::Rayleigh;
use crate::tests::common::Single;
use crate::tests::common::chain::{explicit, lumped};
use std::collections::BTreeMap;
use std::f64::consts::PI;

const STEP: f64 = 1e-3;
const WIRE: Single = Single {
    length: 60.0,
    elements: 120,
    mass: 1.35,
    axial: 15e6,
    bending: 0.0,
    tension: 20e3,
    gravity: 0.0,
};

/// Returns the masters from end to end; all axial elements must be equal.
fn in_order(steps: &Explicit<2>) -> Vec<usize> {
    let stiffness = steps.axial_elements[0].stiffness;
    for axial_element in &steps.axial_elements {
        let off = (axial_element.stiffness / stiffness - 1.0).abs();
        assert!(off < 1e-9, "axial elements differ by {off}");
    }
    let pairs = steps
        .axial_elements
        .iter()
        .map(|axial_element| axial_element.masters);
    let next: BTreeMap<u32, u32> = pairs.map(|[a, b]| (a, b)).collect();
    let is_first = |master: &&u32| !next.values().any(|behind| behind == *master);
    let first = next.keys().find(is_first).copied();
    std::iter::successors(first, |master| next.get(master).copied())
        .map(|master| master as usize)
        .collect()
}

/// Returns sin (πk/n) for n axial elements.
fn shape(k: usize, axial_elements: usize) -> f64 {
    (PI * k as f64 / axial_elements as f64).sin()
}

/// Returns the position and the last increment of the mode.
fn mode(chain: &ChainState, masters: &[usize]) -> [f64; 2] {
    let shares = || masters.iter().enumerate();
    let last = masters.len() - 1;
    [0, 1].map(|which: usize| {
        shares()
            .map(|(k, &master)| shape(k, last) * chain.x[which][master])
            .sum()
    })
}

fn decays(damping: Rayleigh) {
    let (structure, path) = WIRE.structure(2);
    let mut chain = lumped(&structure);
    for segment in &mut chain.segments {
        segment.damping = damping;
    }
    let p: WireModel<2, 2> = explicit(&(chain, vec![path]), STEP, 50e3).expect("short steps");
    let Integrator::Explicit(steps) = &p.integrator else {
        panic!("explicit steps");
    };
    let masters = in_order(steps);
    let axial_elements = masters.len() - 1;
    assert!(axial_elements >= 4, "{axial_elements} axial elements");

    let rest = WIRE.length / (1.0 + WIRE.tension / WIRE.axial) / axial_elements as f64;
    let courant = WIRE.axial / WIRE.mass * (STEP / rest).powi(2);
    let lambda = 4.0 * courant * (PI / (2.0 * axial_elements as f64)).sin().powi(2);
    let expected = 1.0 - damping.alpha * STEP - lambda * damping.beta / STEP;

    let mut chain = steps.zero_state();
    for (k, &master) in masters.iter().enumerate() {
        chain.x[0][master] = 1e-3 * shape(k, axial_elements);
    }
    steps.wire_forces(0, &mut chain);
    let mut states = vec![mode(&chain, &masters)];
    for _ in 0..40 {
        steps.advance_island(0, &mut chain);
        states.push(mode(&chain, &masters));
    }
    let area = |pair: &[[f64; 2]]| pair[0][0] * pair[1][1] - pair[1][0] * pair[0][1];
    let areas: Vec<f64> = states.windows(2).map(area).collect();
    for pair in areas.windows(2) {
        let ratio = pair[1] / pair[0];
        assert!((ratio / expected - 1.0).abs() < 1e-9, "{ratio}, {expected}");
    }
}

/// Damping with which all axial elements of the wire are equal, s.
const BETA: f64 = 2e-4;

#[test]
fn damping_in_proportion_to_stiffness_acts_along_the_wire() {
    decays(Rayleigh {
        alpha: 0.0,
        beta: BETA,
    });
}

#[test]
fn so_does_damping_in_proportion_to_mass() {
    decays(Rayleigh {
        alpha: 20.0,
        beta: BETA,
    });
}
