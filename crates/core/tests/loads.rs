//! Forces given on the line over time: closed forms of a taut string, the ledger, no trace of zero.

use crate::tests::common;

use arcless_core::CoreError;
use arcless_core::linear::loads::Load;
use arcless_core::scheme::Scheme;
use arcless_core::simulation::inputs::Trajectory;
use arcless_core::simulation::recording::record::Record;
use arcless_core::statics::Geometry;
use common::{Single, everything, free_mass, run, three_masses, travel};
use std::f64::consts::PI;

/// Weightless, so that nothing couples its motions across and upwards.
const STRING: Single = Single {
    length: 55.0,
    elements: 80,
    mass: 1.35,
    axial: 15e6,
    bending: 1e-3,
    tension: 22e3,
    gravity: 0.0,
};
const STEP: f64 = 1e-3;
/// Force across per metre, N/m.
const FORCE: f64 = 8.0;
/// Periods are (ωh)²/12 too long, 4e-6 for the first and 4e-5 for the third motion; over the 13 rad
/// of the first that are followed, and with shares of 1/n³ or less, that is below 1e-4.
const CLOSE: f64 = 3e-4;

/// Motion of the middle of the string under a uniform force across of the given size over time.
fn swung(size: impl Fn(f64) -> f64, seconds: f64) -> Record {
    let (structure, path) = STRING.structure(3);
    let steps = (seconds / STEP) as usize;
    let geometry = Geometry::<3, 6>::new(structure.clone()).expect("a valid structure");
    let pattern = geometry.nodal_forces(&vec![[0.0, FORCE, 0.0]; STRING.elements]);
    let trapezoidal = Scheme::generalised_alpha(1.0);
    let p = common::prepare_any::<3, 6>((structure, path), |_| (), trapezoidal, STEP, 50e3);
    let way = Trajectory {
        positions: vec![0.5 * STRING.length; steps + 1],
        speeds: vec![0.0; steps + 1],
        distances: vec![0.0],
        friction: 0.0,
        loads: vec![Load {
            pattern: pattern.expect("one for each element"),
            sizes: (0..=steps).map(|i| size(i as f64 * STEP)).collect(),
        }],
    };
    run(&p, &[free_mass(1.0, 1e-3)], &way, &everything())
}

/// Wave speed of the stretched string: its metres weigh less than those of rest length.
fn wave_speed() -> f64 {
    (STRING.tension * (1.0 + STRING.stretch()) / STRING.mass).sqrt()
}

/// Σ over odd n of 4q/(nπμω_n²) sin(nπ/2) times a motion of each, q/μ per metre of rest length.
fn sum_of_modes(motion: impl Fn(f64) -> f64) -> f64 {
    let first = PI * wave_speed() / STRING.length;
    let odd = (0..200).map(|k| 2 * k + 1);
    odd.map(|n| {
        let (number, omega) = (f64::from(n), f64::from(n) * first);
        let sign = if n % 4 == 1 { 1.0 } else { -1.0 };
        4.0 * FORCE / (number * PI * STRING.mass * omega * omega) * sign * motion(omega)
    })
    .sum()
}

/// From rest, (sin ωt − (ω/ω_n) sin ω_n t)/(1 − (ω/ω_n)²) times what the force does when steady.
#[test]
fn a_string_follows_a_harmonic_force_as_its_modes_do() {
    let first = PI * wave_speed() / STRING.length;
    for ratio in [0.2, 0.9, 1.15] {
        let omega = ratio * first;
        let r = swung(|t| (omega * t).sin(), 1.8);
        let exact = r.time.iter().map(|&t| {
            sum_of_modes(|w| {
                let q = omega / w;
                ((omega * t).sin() - q * (w * t).sin()) / (1.0 - q * q)
            })
        });
        let exact: Vec<f64> = exact.collect();
        let error = common::difference(&r.lateral, &exact);
        assert!(
            error < CLOSE,
            "at {ratio} of the first frequency: {error:e}"
        );
    }
}

/// All motions of a uniformly loaded string have odd numbers: half a period of the first after a
/// step, all of them have swung to twice where the steady force would hold it.
#[test]
fn a_sudden_force_overshoots_by_two() {
    let half = STRING.length / wave_speed();
    let r = swung(|_| 1.0, 1.5 * half);
    // The sag of a shallow string per metre of rest length, q L_r²/8 (T/s), L_r = L/s.
    let stretch = 1.0 + STRING.stretch();
    let steady = FORCE * STRING.length.powi(2) / (8.0 * STRING.tension * stretch);
    let (largest, at) = r
        .lateral
        .iter()
        .zip(&r.time)
        .fold((0.0, 0.0), |m, (&y, &t)| if y > m.0 { (y, t) } else { m });
    assert!(
        (largest / (2.0 * steady) - 1.0).abs() < CLOSE,
        "{largest} for {steady}"
    );
    // The top is a corner of the wave that comes back; where it is, to a step or two.
    assert!((at - half).abs() < 3.0 * STEP, "{at} for {half}");
    let upwards = common::peak(&r.force) - 1e-3;
    assert!(
        upwards.abs() < 1e-9,
        "nothing of it goes upwards: {upwards:e}"
    );
}

/// A gusty run on a line with slack droppers and two pantographs.
fn gusty(scheme: Scheme, size: f64) -> Record {
    let (structure, path) = common::simple_line(6);
    let geometry = Geometry::<2, 4>::new(structure.clone()).expect("a valid structure");
    let load = vec![[0.3, 1.0, 0.0]; structure.wires.len()];
    let pattern = geometry.nodal_forces(&load).expect("one for each element");
    let p = common::prepare(
        (structure, path),
        |s| s.links[22].rest_length += 0.015,
        scheme,
        STEP,
        50e3,
    );
    let mut way = travel(110.0, 270.0, 320.0 / 3.6, STEP);
    way.distances = vec![0.0, 50.0];
    let instants = 0..way.positions.len();
    let sizes = instants.map(|i| size * (0.02 * i as f64).sin()).collect();
    way.loads = vec![Load { pattern, sizes }];
    run(
        &p,
        &[three_masses(200.0), three_masses(60.0)],
        &way,
        &everything(),
    )
}

#[test]
fn the_ledger_books_the_work_of_given_forces() {
    for scheme in [
        Scheme::generalised_alpha(1.0),
        Scheme::generalised_alpha(0.9),
        Scheme::BackwardDifference,
    ] {
        let r = gusty(scheme, 5.0);
        let relative = r.energy_residual / r.energy_turnover;
        // Tolerance as in the test of the ledger: rounding of thousands of steps.
        assert!(relative < 1e-11, "{scheme:?}: {relative:e}");
        let work = r.energy.last().expect("energies").work_loads.abs();
        assert!(work > 1e-3 * r.energy_turnover, "the work matters: {work}");
    }
}

#[test]
fn a_force_of_zero_changes_no_bit() {
    let scheme = Scheme::generalised_alpha(0.9);
    let (with, line) = (gusty(scheme, 0.0), common::simple_line(6));
    let p = common::prepare(
        line,
        |s| s.links[22].rest_length += 0.015,
        scheme,
        STEP,
        50e3,
    );
    let mut way = travel(110.0, 270.0, 320.0 / 3.6, STEP);
    way.distances = vec![0.0, 50.0];
    let without = run(
        &p,
        &[three_masses(200.0), three_masses(60.0)],
        &way,
        &everything(),
    );
    let bits = |values: &[f64]| values.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
    for (a, b) in [
        (&with.force, &without.force),
        (&with.link_force, &without.link_force),
    ] {
        assert_eq!(bits(a), bits(b));
    }
    assert_ne!(with.force, gusty(scheme, 5.0).force);
}

#[test]
fn loads_that_do_not_fit_are_refused() {
    let p = common::prepared(3, Scheme::generalised_alpha(0.9), STEP, 50e3);
    let way = travel(60.0, 70.0, 80.0, STEP);
    let count = way.positions.len();
    let good = || Load {
        pattern: vec![(0, 1, 1.0)],
        sizes: vec![0.0; count],
    };
    let faults: [fn(&mut Load); 4] = [
        |l| l.sizes.truncate(3),
        |l| l.sizes[2] = f64::NAN,
        |l| l.pattern[0].0 = 100_000,
        |l| l.pattern[0].1 = 4,
    ];
    for spoil in faults {
        let mut load = good();
        spoil(&mut load);
        let mut way = way.clone();
        way.loads = vec![load];
        let found = p.run(&[free_mass(8.0, 60.0)], &way, &everything(), &mut |_| true);
        assert!(matches!(
            found,
            Err(CoreError::Input { array: "loads", .. })
        ));
    }
    let structure = common::simple_line(3).0;
    let geometry = Geometry::<2, 4>::new(structure).expect("a valid structure");
    assert!(geometry.nodal_forces(&[[0.0; 3]]).is_err());
}
