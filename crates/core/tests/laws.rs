//! Springs, dampers and dry friction given by tables, in whole runs.

use crate::tests::common;

use arcless_core::CoreError;
use arcless_core::pantograph::breakpoint::ForceKind;
use arcless_core::pantograph::bump_stop::BumpStop;
use arcless_core::pantograph::equilibrium;
use arcless_core::pantograph::excitation::{BaseMotion, ForceHistory};
use arcless_core::pantograph::model::Pantograph;
use arcless_core::pantograph::piecewise_force::PiecewiseForce;
use arcless_core::pantograph::strip::Strip;
use arcless_core::scheme::Scheme;
use arcless_core::simulation::recording::record::Record;
use common::{difference, everything, free_mass, run, three_masses, travel};
use std::f64::consts::PI;

fn trapezoidal() -> Scheme {
    Scheme::generalised_alpha(1.0)
}

fn law(direction: &[f64], kind: ForceKind, points: &[[f64; 2]]) -> PiecewiseForce {
    PiecewiseForce {
        direction: direction.to_vec(),
        kind,
        points: points.to_vec(),
    }
}

fn friction(direction: &[f64], force: f64, speed: f64) -> PiecewiseForce {
    let points = [
        [-2.0 * speed, -force],
        [-speed, -force],
        [speed, force],
        [2.0 * speed, force],
    ];
    law(direction, ForceKind::Damper, &points)
}

/// Three masses under a wire on shaking ground.
fn shaken(change: impl FnOnce(&mut Pantograph), scheme: Scheme, contact: f64) -> Record {
    let p = common::prepare(common::simple_line(5), |_| (), scheme, 1e-3, contact);
    let way = travel(70.0, 200.0, 70.0, 1e-3);
    let mut pantograph = three_masses(90.0);
    let t: Vec<f64> = (0..way.positions.len()).map(|i| i as f64 * 1e-3).collect();
    let omega = 2.0 * PI * 1.7;
    pantograph.excitation.base = Some(BaseMotion {
        influence: vec![1.0; 3],
        displacement: t.iter().map(|t| 0.03 * (omega * t).sin()).collect(),
        rate: t.iter().map(|t| 0.03 * omega * (omega * t).cos()).collect(),
    });
    change(&mut pantograph);
    run(&p, &[pantograph], &way, &everything())
}

const SCHEMES: [fn() -> Scheme; 5] = [
    trapezoidal,
    || Scheme::generalised_alpha(0.9),
    || Scheme::hht(0.1),
    || Scheme::newmark(1.0, 1.0),
    || Scheme::BackwardDifference,
];

/// Of a line with droppers that slacken: what rounding may grow to in two seconds.
const SAME_RUN: f64 = 1e-6;

#[test]
fn a_straight_table_is_the_linear_spring_or_damper() {
    let plain = shaken(|_| (), trapezoidal(), 50e3);
    let listed = shaken(
        |pantograph| {
            // The spring and damper between the first two masses, from the matrices into tables.
            let joint = [-1.0, 1.0, 0.0];
            let (k, c) = (-pantograph.stiffness[1], -pantograph.damping[1]);
            for i in [0, 1] {
                for j in [0, 1] {
                    pantograph.stiffness[3 * i + j] -= k * joint[i] * joint[j];
                    pantograph.damping[3 * i + j] -= c * joint[i] * joint[j];
                }
            }
            let line = |slope: f64| {
                [
                    [-0.02, -0.02 * slope],
                    [0.01, 0.01 * slope],
                    [0.5, 0.5 * slope],
                ]
            };
            pantograph.piecewise_forces = vec![
                law(&joint, ForceKind::Spring, &line(k)),
                law(&joint, ForceKind::Damper, &line(c)),
            ];
        },
        trapezoidal(),
        50e3,
    );
    assert!(difference(&plain.force, &listed.force) < SAME_RUN);
    // Rounding of some 1e4 sums.
    assert!(listed.energy_residual < 1e-11 * listed.energy_turnover);
}

/// A stop gives the run of a table whose steepest piece is the closed stop: the table is computed
/// with softening pieces, the stop with a hardening one.
#[test]
fn a_stop_is_the_table_of_a_stop() {
    let (gap, stiffness) = (0.004, 2e5);
    let rigid = (f64::INFINITY, Scheme::newmark(1.0, 1.0));
    for (sign, (contact, scheme)) in [(1.0, (50e3, trapezoidal())), (-1.0, rigid)] {
        let joint = [0.0, -sign, sign];
        let stopped = shaken(
            |pantograph| {
                pantograph.stops.push(BumpStop {
                    direction: joint.to_vec(),
                    gap,
                    stiffness,
                });
            },
            scheme,
            contact,
        );
        assert!(stopped.stop_max[0] > 50.0, "{:?}", stopped.stop_max);
        let listed = shaken(
            |pantograph| {
                // The elongation of the joint at the start: all of the static force compresses it.
                let start = sign * -90.0 / -pantograph.stiffness[5];
                let closed = start - gap;
                let points = [[closed - 1.0, -stiffness], [closed, 0.0], [1.0, 0.0]];
                pantograph.piecewise_forces = vec![law(&joint, ForceKind::Spring, &points)];
            },
            scheme,
            contact,
        );
        let size = difference(&stopped.force, &listed.force);
        assert!(size < SAME_RUN, "{size:e}");
    }
}

/// A table is what its parts are together: one of five pieces against three laws of two or three.
#[test]
fn tables_add_up() {
    let joint = [0.0, -1.0, 1.0];
    let parts = [
        [[-0.5, -260.5], [-0.007, -14.0], [0.5, 1000.0]],
        [[-0.5, -2972.5], [-0.0055, -5.5], [0.5, 500.0]],
        [[-0.5, 0.0], [-0.0045, 0.0], [0.5, 5045.0]],
    ];
    let several = shaken(
        |pantograph| {
            pantograph.piecewise_forces = parts.map(|p| law(&joint, ForceKind::Spring, &p)).to_vec()
        },
        trapezoidal(),
        50e3,
    );
    let force = |x: f64| -> f64 {
        let at = |p: &[[f64; 2]; 3]| {
            let [a, b] = if x < p[1][0] {
                [p[0], p[1]]
            } else {
                [p[1], p[2]]
            };
            a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0])
        };
        parts.iter().map(at).sum()
    };
    let sum = [-0.5, -0.007, -0.0055, -0.0045, 0.5].map(|x| [x, force(x)]);
    let one = shaken(
        |pantograph| pantograph.piecewise_forces = vec![law(&joint, ForceKind::Spring, &sum)],
        trapezoidal(),
        50e3,
    );
    let size = difference(&several.force, &one.force);
    assert!(size < SAME_RUN, "{size:e}");
    // All kinks of the table are met, so that the test says something.
    let [lowest, highest] = [one.law_ranges[0], one.law_ranges[1]];
    assert!(lowest < -0.007 && highest > -0.0045, "{lowest} {highest}");
}

#[test]
fn the_balance_closes_with_tables_and_friction() {
    for scheme in SCHEMES {
        for contact in [50e3, f64::INFINITY] {
            let r = shaken(
                |pantograph| {
                    let joint = [0.0, -1.0, 1.0];
                    let base = [1.0, 0.0, 0.0];
                    let spring = [
                        [-0.5, -8e3],
                        [-0.008, -80.0],
                        [-0.005, -10.0],
                        [0.01, 9.0],
                        [0.2, 2e3],
                    ];
                    let damper = [
                        [-1.0, -60.0],
                        [-0.1, -40.0],
                        [0.0, 0.0],
                        [0.05, 40.0],
                        [1.0, 50.0],
                    ];
                    pantograph.piecewise_forces = vec![
                        friction(&base, 12.0, 1e-3),
                        law(&joint, ForceKind::Spring, &spring),
                        law(&joint, ForceKind::Damper, &damper),
                        friction(&joint, 5.0, 1e-3),
                    ];
                },
                scheme(),
                contact,
            );
            let relative = r.energy_residual / r.energy_turnover;
            // Tolerance as for the ledger without laws: rounding of some thousand steps.
            assert!(relative < 1e-11, "{:?} {contact}: {relative:e}", scheme());
            assert!(
                r.law_ranges[0] < -0.01 && r.law_ranges[1] > 0.01,
                "friction slides"
            );
            assert!(
                r.law_ranges[2] < -0.008 && r.law_ranges[3] > -0.005,
                "{:?}",
                r.law_ranges
            );
        }
    }
}

const MASS: f64 = 8.0;
const SPRING: f64 = 2000.0;
const FRICTION: f64 = 10.0;
const PULL: f64 = 200.0;

/// Run of a mass on a spring under a force that is suddenly applied and stays: it swings about
/// −F/k. The pantograph has another mass, at the wire, and nothing else. The displacement of the
/// swinging mass at each step, m, is returned too.
fn swinging(scheme: Scheme, h: f64, speed: f64, pull: f64, end: f64) -> (Record, Vec<f64>) {
    let p = common::prepare(common::simple_line(4), |_| (), scheme, h, 50e3);
    let way = travel(100.0, 100.0 + end, 1.0, h);
    let mut pantograph = free_mass(MASS, 0.0);
    pantograph.mass = vec![1.0, 0.0, 0.0, MASS];
    pantograph.damping = vec![0.0; 4];
    pantograph.stiffness = vec![0.0, 0.0, 0.0, SPRING];
    pantograph.strips = vec![Strip::plain(vec![1.0, 0.0])];
    (pantograph.preload, pantograph.lift) = (vec![1.0, 0.0], vec![0.0; 2]);
    pantograph
        .piecewise_forces
        .push(friction(&[0.0, 1.0], FRICTION, speed));
    let pulls = |x: &f64| if *x > 100.0 { pull } else { 0.0 };
    pantograph.excitation.forces.push(ForceHistory {
        direction: vec![0.0, -1.0],
        values: way.positions.iter().map(pulls).collect(),
    });
    let r = run(&p, &[pantograph], &way, &everything());
    let x = r.masses.iter().skip(1).step_by(2).copied().collect();
    (r, x)
}

/// Turning points of the swing, from its centre.
fn turning_points(x: &[f64]) -> Vec<f64> {
    let x: Vec<f64> = x.iter().map(|u| u + PULL / SPRING).collect();
    let turns = x.windows(3).filter(|w| (w[1] - w[0]) * (w[2] - w[1]) < 0.0);
    turns.map(|w| w[1]).collect()
}

#[test]
fn an_oscillator_with_dry_friction_loses_four_f_over_k_a_cycle() {
    let errors = [0.1, 0.05, 0.025, 0.004].map(|speed| {
        let (_, x) = swinging(trapezoidal(), 1e-4, speed, PULL, 1.4);
        let turns = turning_points(&x);
        assert!(turns.len() >= 6, "{turns:?}");
        let size = |n: usize| PULL / SPRING - 2.0 * FRICTION / SPRING * n as f64;
        // Turning points 1, 2, 3, …: the amplitude falls by 2 F_c/k in each half cycle.
        let error = turns[..6].iter().enumerate().map(|(i, x)| {
            let sign = if i % 2 == 0 { -1.0 } else { 1.0 };
            (x - sign * size(i + 1)).abs()
        });
        error.fold(0.0, f64::max)
    });
    // Below the sliding speed the friction is smaller, for a time in proportion to that speed: the
    // work that is missing is quadratic in it, or better.
    assert!(
        errors[0] > 4.0 * errors[1] && errors[1] > 4.0 * errors[2],
        "{errors:?}"
    );
    // h² ω²/12 of 0.1 m after three cycles of 0.4 s is below a micrometre.
    assert!(errors[3] < 1e-6, "{errors:?}");
}

#[test]
fn friction_turns_motion_into_heat() {
    let (r, x) = swinging(trapezoidal(), 5e-4, 1e-3, PULL, 3.0);
    // Rounding of some 1e3 sums.
    assert!(r.energy_residual < 1e-12 * r.energy_turnover);
    let heat: Vec<f64> = r.energy.iter().map(|e| e.dissipated_pantographs).collect();
    assert!(heat.windows(2).all(|w| w[1] >= w[0]), "never backwards");
    // In the end it stands: what came from the force and is not in the spring is heat, and that is
    // the force times the way.
    let (x, way) = (x[x.len() - 1], path(&x));
    let given = -PULL * x - 0.5 * SPRING * x * x;
    let total = heat[heat.len() - 1];
    assert!((total - given).abs() < 1e-3 * given, "{total} {given}");
    // Of the way a part is crept with less force.
    assert!(
        (total - FRICTION * way).abs() < 2e-3 * total,
        "{total} {way}"
    );
    // Within the dead band about the middle.
    assert!((x + PULL / SPRING).abs() < FRICTION / SPRING, "{x}");
}

fn path(x: &[f64]) -> f64 {
    x.windows(2).map(|w| (w[1] - w[0]).abs()).sum()
}

/// Below F_c it creeps with v = v_s F/F_c: nothing moves as the width goes to zero.
#[test]
fn the_dead_band_is_one_of_creep() {
    let (pull, end) = (0.6 * FRICTION, 0.2);
    for speed in [1e-3, 1e-4, 1e-5] {
        let (_, x) = swinging(trapezoidal(), 1e-4, speed, pull, end);
        let viscosity = FRICTION / speed;
        let rest = pull / SPRING * (1.0 - (-SPRING / viscosity * end).exp());
        let moved = -x[x.len() - 1];
        // The pull begins within the first step, and inertia answers after m/c ≤ 0.8 ms: both shift
        // the time by less than 1 ms of 200.
        assert!(
            (moved - rest).abs() < 6e-3 * rest,
            "{speed}: {moved} {rest}"
        );
    }
}

fn start_of(laws: Vec<PiecewiseForce>, force: f64) -> Result<(Vec<f64>, f64), CoreError> {
    let mut pantograph = three_masses(force);
    // The joints above the first mass are those of the laws alone.
    pantograph.stiffness = vec![160.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    pantograph.piecewise_forces = laws;
    equilibrium::under_one_contact(&pantograph, force, 0.25, 0.0)
}

#[test]
fn the_start_is_on_the_tables() {
    let force = 90.0;
    // Compressed by 90 N: on the second and the first piece.
    let lower = [
        [-0.1, -130.0],
        [-0.02, -50.0],
        [-0.01, -45.0],
        [0.0, 0.0],
        [0.1, 1e4],
    ];
    let upper = [[-0.01, -180.0], [0.0, 0.0], [0.1, 1e5]];
    let springs = vec![
        law(&[-1.0, 1.0, 0.0], ForceKind::Spring, &lower),
        law(&[0.0, -1.0, 1.0], ForceKind::Spring, &upper),
    ];
    let (u, preload) = start_of(springs, force).expect("an equilibrium");
    let (q1, q2) = (-0.02 - 40.0 / 1000.0, -0.005);
    let known = [0.25 - q2 - q1, 0.25 - q2, 0.25];
    // Rounding of 1e5 N/m over 90 N.
    for (u, known) in u.iter().zip(known) {
        assert!((u - known).abs() < 1e-12, "{u} {known}");
    }
    assert!(
        (preload - force - 160.0 * known[0]).abs() < 1e-9,
        "{preload}"
    );
}

#[test]
fn a_free_play_is_passed_on_the_way_to_the_start() {
    // No force within ±10 mm: the level piece carries nothing, the next one does.
    let play = [[-0.02, -100.0], [-0.01, 0.0], [0.01, 0.0], [0.02, 100.0]];
    let stiff = [[-1.0, -1e5], [1.0, 1e5]];
    let springs = |play: &[[f64; 2]]| {
        vec![
            law(&[-1.0, 1.0, 0.0], ForceKind::Spring, play),
            law(&[0.0, -1.0, 1.0], ForceKind::Spring, &stiff),
        ]
    };
    let (u, _) = start_of(springs(&play), 90.0).expect("an equilibrium");
    // Rounding of a place.
    assert!((u[1] - u[0] + 0.019).abs() < 1e-12, "{u:?}");
    // A spring that is level where the force would have to be.
    let level = [[-0.5, -90.0], [-0.01, -90.0], [0.0, 0.0]];
    let error = start_of(springs(&level), 90.0 + 1e-3).expect_err("loose");
    assert!(matches!(error, CoreError::BeyondTable { .. }), "{error}");
    let short = [[-0.008, -80.0], [0.0, 0.0]];
    match start_of(springs(&short), 90.0).expect_err("it ends at 80 N") {
        CoreError::BeyondTable {
            table,
            displacement,
            end,
            ..
        } => {
            assert_eq!((table, end), (0, -0.008));
            // Rounding of a displacement.
            assert!((displacement + 0.009).abs() < 1e-12, "{displacement}");
        }
        other => panic!("{other}"),
    }
}

#[test]
fn wrong_tables_are_refused() {
    for points in [
        vec![[0.0, 0.0]],
        vec![[0.0, 0.0], [0.0, 1.0]],
        vec![[0.0, 0.0], [1.0, -1.0]],
        vec![[0.0, 0.0], [1.0, f64::NAN]],
    ] {
        let mut pantograph = three_masses(90.0);
        pantograph.piecewise_forces = vec![law(&[1.0, 0.0, 0.0], ForceKind::Spring, &points)];
        assert!(pantograph.check().is_err(), "{points:?}");
        pantograph.piecewise_forces = vec![law(
            &[1.0, 0.0],
            ForceKind::Spring,
            &[[0.0, 0.0], [1.0, 1.0]],
        )];
        assert!(pantograph.check().is_err(), "direction");
    }
}
