//! Pantographs on moving ground, under given forces, and against their stops.

use crate::tests::common;

use arcless_core::pantograph::bump_stop::BumpStop;
use arcless_core::pantograph::excitation::{BaseMotion, Excitation, ExcitationNow, ForceHistory};
use arcless_core::pantograph::model::Pantograph;
use arcless_core::pantograph::state::PantographState;
use arcless_core::pantograph::strip::Strip;
use arcless_core::scheme::Scheme;
use arcless_core::simulation::inputs::Trajectory;
use arcless_core::simulation::recording::record::Record;
use common::{difference, everything, free_mass, run, three_masses, travel};
use std::f64::consts::PI;

/// Two masses in series on the ground, well damped so that transients die within seconds.
fn two_masses() -> Pantograph {
    let (k, c) = ([900.0, 5000.0], [60.0, 80.0]);
    Pantograph {
        mass: vec![15.0, 0.0, 0.0, 7.2],
        damping: vec![c[0] + c[1], -c[1], -c[1], c[1]],
        stiffness: vec![k[0] + k[1], -k[1], -k[1], k[1]],
        strips: vec![Strip::plain(vec![0.0, 1.0])],
        preload: vec![1.0, 0.0],
        lift: vec![0.0; 2],
        start_force: 0.0,
        excitation: Excitation::default(),
        stops: Vec::new(),
        piecewise_forces: Vec::new(),
        actuator: None,
        is_external: false,
    }
}

/// Complex numbers as pairs: as much as two equations need.
type Complex = (f64, f64);

fn times(a: Complex, b: Complex) -> Complex {
    (a.0 * b.0 - a.1 * b.1, a.0 * b.1 + a.1 * b.0)
}

fn minus(a: Complex, b: Complex) -> Complex {
    (a.0 - b.0, a.1 - b.1)
}

fn over(a: Complex, b: Complex) -> Complex {
    let size = b.0 * b.0 + b.1 * b.1;
    times(a, (b.0 / size, -b.1 / size))
}

/// Transmissibility û/ẑ of both masses: (k − ω²m + iωc) û = (k + iωc) r ẑ, by Cramer's rule.
fn transmissibility(pantograph: &Pantograph, omega: f64) -> [Complex; 2] {
    let dynamic = |i: usize| {
        let real = pantograph.stiffness[i] - omega * omega * pantograph.mass[i];
        (real, omega * pantograph.damping[i])
    };
    let pull = |i: usize| {
        let of = |m: &[f64]| m[2 * i] + m[2 * i + 1];
        (of(&pantograph.stiffness), omega * of(&pantograph.damping))
    };
    let a = [0, 1, 2, 3].map(dynamic);
    let (p, q) = (pull(0), pull(1));
    let determinant = minus(times(a[0], a[3]), times(a[1], a[2]));
    [
        over(minus(times(p, a[3]), times(a[1], q)), determinant),
        over(minus(times(a[0], q), times(a[2], p)), determinant),
    ]
}

/// Largest error of both masses over the last period, relative to the largest motion.
fn response_error(frequency: f64, h: f64) -> f64 {
    let (omega, size) = (2.0 * PI * frequency, 0.01);
    // Slowest decay: c/2m ≈ 60/44 per second. After 16 s e⁻²² of the transient is left.
    let steps = (16.0 / h) as usize;
    let time = |i: usize| i as f64 * h;
    let mut pantograph = two_masses();
    let exact = transmissibility(&pantograph, omega);
    pantograph.excitation.base = Some(BaseMotion {
        influence: vec![1.0, 1.0],
        displacement: (0..=steps)
            .map(|i| size * (omega * time(i)).sin())
            .collect(),
        rate: (0..=steps)
            .map(|i| size * omega * (omega * time(i)).cos())
            .collect(),
    });
    let scheme = Scheme::generalised_alpha(1.0);
    let c = scheme.coefficients(h);
    let mut now = ExcitationNow::zero(pantograph.size());
    let mut state = PantographState::new(pantograph, &c, 0.0, 0.0).expect("an equilibrium");
    let (mut error, mut largest): (f64, f64) = (0.0, 0.0);
    let last_period = steps - (1.0 / (frequency * h)) as usize;
    for step in 0..steps {
        state.model.excitation.read(step, c.old, &mut now);
        state.set_excitation(&now);
        state.predict(&c, 0.0);
        state.commit(&c);
        if step >= last_period {
            let phase = omega * time(step + 1);
            for (u, (re, im)) in state.u.iter().zip(exact) {
                let known = size * (re * phase.sin() + im * phase.cos());
                error = error.max((u - known).abs());
                largest = largest.max(known.abs());
            }
        }
    }
    error / largest
}

#[test]
fn moving_ground_is_felt_as_the_frequency_response_says() {
    // Below, at and above both natural frequencies (about 1 and 5 Hz).
    for frequency in [0.4, 1.0, 2.5, 5.0, 9.0] {
        let errors = [2e-3, 1e-3, 5e-4].map(|h| response_error(frequency, h));
        // Second order: the rule warps ω by (ωh)²/12, which a resonance magnifies by its quality.
        let orders = common::orders(&errors);
        assert!(
            orders.iter().all(|&p| (p - 2.0).abs() < 0.05),
            "{frequency} Hz: {errors:?}"
        );
        assert!(errors[2] < 5e-4, "{frequency} Hz: {errors:?}");
    }
}

const STEP: f64 = 2e-4;
const MASS: f64 = 8.0;
const PULL: f64 = 80.0;
const GAP: f64 = 0.05;

/// A mass without springs under a wire; a given force pulls it down onto a stop below.
fn dropped(stiffness: f64, damping: f64, scheme: Scheme) -> Record {
    let p = common::prepare(common::simple_line(4), |_| (), scheme, STEP, 50e3);
    let way = travel(100.0, 103.0, 1.0, STEP);
    let mut pantograph = free_mass(MASS, 0.0);
    pantograph.damping[0] = damping;
    // At the start, in equilibrium, nothing pulls.
    let pulls = |x: &f64| if *x > 100.0 { PULL } else { 0.0 };
    pantograph.excitation.forces.push(ForceHistory {
        direction: vec![-1.0],
        values: way.positions.iter().map(pulls).collect(),
    });
    pantograph.stops.push(BumpStop {
        direction: vec![1.0],
        gap: GAP,
        stiffness,
    });
    run(&p, &[pantograph], &way, &everything())
}

#[test]
fn a_mass_dropped_on_a_stop_compresses_it_as_its_energy_says_and_comes_back() {
    let stiffness = 20e3;
    let r = dropped(stiffness, 0.0, Scheme::generalised_alpha(1.0));
    let lowest = r.masses.iter().fold(0.0_f64, |m, u| m.min(*u));
    // ½ k p² = F (gap + p)
    let depth = (PULL + (PULL * PULL + 2.0 * stiffness * PULL * GAP).sqrt()) / stiffness;
    // The mass meets the stop within a step of 0.7 m/s · 0.2 ms = 0.14 mm; the error is of second
    // order.
    assert!(
        (-lowest - GAP - depth).abs() < 2e-3 * depth,
        "{lowest} {depth}"
    );
    assert!((r.stop_max[0] - stiffness * depth).abs() < 2e-3 * stiffness * depth);
    // The mass falls, bounces, and is back at the wire without velocity; t =
    // 2 (√(2 gap/a) + contact).
    let back = r.masses[r.masses.len() / 6..]
        .iter()
        .fold(-1.0_f64, |m, u| m.max(*u));
    // Each opening or closing within a step moves energy by O(h): half a per cent of F · gap.
    assert!(back > -0.005 * GAP - 1e-4, "{back}");
    let e = r.energy.last().expect("a record");
    assert!(r.energy_residual < 1e-12 * r.energy_turnover);
    assert!(e.switching.abs() < 0.02 * PULL * GAP, "{}", e.switching);
}

#[test]
fn a_damped_mass_comes_to_rest_on_its_stop() {
    let stiffness = 20e3;
    let r = dropped(stiffness, 120.0, Scheme::generalised_alpha(0.9));
    let rest = r.masses[r.masses.len() - 1];
    // 120 N s/m on 8 kg: 7.5 per second, e⁻¹⁶ left after the fall.
    assert!((rest + GAP + PULL / stiffness).abs() < 1e-7, "{rest}");
    assert!(r.energy_residual < 1e-12 * r.energy_turnover);
}

#[test]
fn a_rigid_stop_takes_the_whole_impact() {
    let r = dropped(f64::INFINITY, 0.0, Scheme::newmark(1.0, 1.0));
    let rest = r.masses[r.masses.len() - 1];
    // Condition on position: exact to rounding.
    assert!((rest + GAP).abs() < 1e-12, "{rest}");
    let e = r.energy.last().expect("a record");
    // The work of the fall is lost: in the impact, or in the scheme that quietens it.
    let lost = e.switching + e.dissipated_scheme;
    assert!((lost - PULL * GAP).abs() < 1e-9 * PULL * GAP, "{lost}");
    // Rounding of work of some joules, some 1e3 sums.
    assert!(
        (e.work_uplift - PULL * GAP).abs() < 1e-9,
        "{}",
        e.work_uplift
    );
    assert!(r.energy_residual < 1e-12 * r.energy_turnover);
}

/// All instants of a travel, s.
fn instants(way: &Trajectory) -> Vec<f64> {
    (0..way.positions.len()).map(|i| i as f64 * 1e-3).collect()
}

/// Three masses on shaking ground, with stops so close that they are hit often.
fn shaken(scheme: Scheme, contact: f64, stiffness: f64) -> Record {
    let p = common::prepare(common::simple_line(5), |_| (), scheme, 1e-3, contact);
    let way = travel(70.0, 200.0, 70.0, 1e-3);
    let mut pantograph = three_masses(90.0);
    let omega = 2.0 * PI * 1.7;
    let t = instants(&way);
    pantograph.excitation.base = Some(BaseMotion {
        influence: vec![1.0; 3],
        displacement: t.iter().map(|t| 0.03 * (omega * t).sin()).collect(),
        rate: t.iter().map(|t| 0.03 * omega * (omega * t).cos()).collect(),
    });
    pantograph.excitation.forces.push(ForceHistory {
        direction: vec![0.0, 0.0, 1.0],
        values: t.iter().map(|t| 30.0 * (9.0 * t).sin()).collect(),
    });
    pantograph.stops = [
        (vec![1.0, 0.0, 0.0], 0.01),
        (vec![0.0, -1.0, 1.0], 0.002),
        (vec![-1.0, 1.0, 0.0], 0.0005),
    ]
    .map(|(direction, gap)| BumpStop {
        direction,
        gap,
        stiffness,
    })
    .to_vec();
    run(&p, &[pantograph], &way, &everything())
}

#[test]
fn the_balance_closes_with_moving_ground_given_forces_and_stops() {
    for scheme in [
        Scheme::generalised_alpha(1.0),
        Scheme::generalised_alpha(0.9),
        Scheme::hht(0.1),
        Scheme::newmark(1.0, 1.0),
        Scheme::BackwardDifference,
    ] {
        for contact in [50e3, f64::INFINITY] {
            for stiffness in [1e6, f64::INFINITY] {
                let r = shaken(scheme, contact, stiffness);
                assert!(r.stop_max[0] > 20.0, "the stops are hit: {:?}", r.stop_max);
                let relative = r.energy_residual / r.energy_turnover;
                // Tolerance as for the ledger without stops: rounding of some thousand steps.
                assert!(
                    relative < 1e-11,
                    "{scheme:?} {contact} {stiffness}: {relative:e}"
                );
            }
        }
    }
}

/// Partner of the test above: stops that are out of reach change nothing but rounding.
#[test]
fn stops_out_of_reach_change_nothing() {
    let scheme = Scheme::generalised_alpha(0.9);
    let p = common::prepare(common::simple_line(5), |_| (), scheme, 1e-3, 50e3);
    let way = travel(70.0, 200.0, 70.0, 1e-3);
    let plain = run(&p, &[three_masses(90.0)], &way, &everything());
    let mut pantograph = three_masses(90.0);
    for direction in [vec![1.0, 0.0, 0.0], vec![0.0, 1.0, -1.0]] {
        pantograph.stops.push(BumpStop {
            direction,
            gap: 1.0,
            stiffness: 1e6,
        });
    }
    let held = run(&p, &[pantograph], &way, &everything());
    assert_eq!(held.stop_max, [0.0]);
    // Stops that are never met: rounding of their place in the sums, carried on.
    assert!(difference(&held.force, &plain.force) < 1e-10);
}

/// The preload is set with the ground where it starts: only its motion since then is felt.
#[test]
fn ground_that_stands_elsewhere_is_no_ground_motion() {
    let scheme = Scheme::generalised_alpha(0.9);
    let p = common::prepare(common::simple_line(5), |_| (), scheme, 1e-3, 50e3);
    let way = travel(70.0, 120.0, 70.0, 1e-3);
    let plain = run(&p, &[three_masses(90.0)], &way, &everything());
    let mut pantograph = three_masses(90.0);
    let count = way.positions.len();
    pantograph.excitation.base = Some(BaseMotion {
        influence: vec![1.0; 3],
        displacement: vec![0.25; count],
        rate: vec![0.0; count],
    });
    let raised = run(&p, &[pantograph], &way, &everything());
    // 160 N/m · 0.25 m = 40 N come and go in the preload: rounding of 40 N.
    assert!(difference(&raised.force, &plain.force) < 1e-10);
}

#[test]
fn what_is_given_wrongly_is_refused() {
    let scheme = Scheme::generalised_alpha(0.9);
    let p = common::prepare(common::simple_line(4), |_| (), scheme, 1e-3, 50e3);
    let way = travel(70.0, 71.0, 70.0, 1e-3);
    let fails = |change: &dyn Fn(&mut Pantograph), word: &str| {
        let mut pantograph = three_masses(90.0);
        change(&mut pantograph);
        let error = p
            .run(&[pantograph], &way, &everything(), &mut |_| true)
            .expect_err("it is refused");
        assert!(error.to_string().contains(word), "{error}");
    };
    let history = |count: usize| ForceHistory {
        direction: vec![1.0, 0.0, 0.0],
        values: vec![1.0; count],
    };
    fails(&|r| r.excitation.forces.push(history(3)), "each instant");
    fails(&|r| r.excitation.forces.push(history(0)), "each instant");
    let stop = |sign: f64, gap: f64| BumpStop {
        direction: vec![sign, 0.0, 0.0],
        gap,
        stiffness: f64::INFINITY,
    };
    fails(&|r| r.stops.push(stop(1.0, -0.1)), "sizes");
    fails(
        &|r| r.stops.extend([stop(1.0, 0.1), stop(-1.0, 0.1)]),
        "rigid stops block the same motion",
    );
}
