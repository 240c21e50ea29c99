//! Motion along a straight wire, against the recurrence of one mode.
//!
//! With n equal reaches of L₀ between ends that are held, masters move as sin (πk/n), and with
//! Λ = (4 EA h²/μ L₀²) sin² (π/2n)
//!
//!   d′ = (1 − αh) d − Λ (x + (β/h) d),   x′ = x + d′
//!
//! whose determinant is 1 − αh − Λβ/h: what x d′ − x′ d of a mode is multiplied by in every step.

use crate::common::Single;
use crate::common::chain::{explicit, lumped};
use crate::integrator::Integrator;
use crate::integrator::explicit::{Explicit, Grid};
use crate::integrator::prepared::WireModel;
use crate::structure::Rayleigh;
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

/// Masters from end to end, by the number that they have; all reaches must be alike.
fn in_order(steps: &Explicit<2>) -> Vec<usize> {
    let stiffness = steps.reaches[0].stiffness;
    for reach in &steps.reaches {
        let off = (reach.stiffness / stiffness - 1.0).abs();
        assert!(off < 1e-9, "reaches of {off} more");
    }
    let pairs = steps.reaches.iter().map(|reach| reach.masters);
    let next: BTreeMap<u32, u32> = pairs.map(|[a, b]| (a, b)).collect();
    let is_first = |master: &&u32| !next.values().any(|behind| behind == *master);
    let first = next.keys().find(is_first).copied();
    std::iter::successors(first, |master| next.get(master).copied())
        .map(|master| master as usize)
        .collect()
}

/// sin (πk/n) of n reaches.
fn shape(k: usize, reaches: usize) -> f64 {
    (PI * k as f64 / reaches as f64).sin()
}

/// Place and last increment of the mode.
fn mode(grid: &Grid, masters: &[usize]) -> [f64; 2] {
    let shares = || masters.iter().enumerate();
    let last = masters.len() - 1;
    [0, 1].map(|of: usize| {
        shares()
            .map(|(k, &master)| shape(k, last) * grid.x[of][master])
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
    let reaches = masters.len() - 1;
    assert!(reaches >= 4, "{reaches} reaches");

    let rest = WIRE.length / (1.0 + WIRE.tension / WIRE.axial) / reaches as f64;
    let courant = WIRE.axial / WIRE.mass * (STEP / rest).powi(2);
    let lambda = 4.0 * courant * (PI / (2.0 * reaches as f64)).sin().powi(2);
    let expected = 1.0 - damping.alpha * STEP - lambda * damping.beta / STEP;

    let mut grid = steps.still();
    for (k, &master) in masters.iter().enumerate() {
        grid.x[0][master] = 1e-3 * shape(k, reaches);
    }
    steps.wire_forces(0, &mut grid);
    let mut states = vec![mode(&grid, &masters)];
    for _ in 0..40 {
        steps.go(0, &mut grid);
        states.push(mode(&grid, &masters));
    }
    let area = |pair: &[[f64; 2]]| pair[0][0] * pair[1][1] - pair[1][0] * pair[0][1];
    let areas: Vec<f64> = states.windows(2).map(area).collect();
    for pair in areas.windows(2) {
        let found = pair[1] / pair[0];
        assert!((found / expected - 1.0).abs() < 1e-9, "{found}, {expected}");
    }
}

/// With it all reaches of the wire are alike, s.
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
