//! Several contacts of one pantograph: on several wires, and with several strips.

use crate::tests::common;

use arcless_core::CoreError;
use arcless_core::integrator::wire_model::WireModel;
use arcless_core::linear::static_response::StaticSolver;
use arcless_core::pantograph::model::Pantograph;
use arcless_core::pantograph::strip::Strip;
use arcless_core::scheme::Scheme;
use arcless_core::simulation::recording::record::Record;
use common::lanes::{At, STRING, lined, strings};
use common::{Single, difference, everything, free_mass, peak, run, three_masses, travel};

const CONTACT: f64 = 50e3;

fn scheme() -> Scheme {
    Scheme::generalised_alpha(0.9)
}

/// Every `count`-th value from `first`.
fn column(values: &[f64], first: usize, count: usize) -> Vec<f64> {
    values.iter().skip(first).step_by(count).copied().collect()
}

/// Rigid head that rises by z and tilts by φ about the track, with a spring against the tilt; its
/// strip is straight: z + y φ.
fn tilting(force: f64, half_width: f64, tilt_stiffness: f64) -> Pantograph {
    Pantograph {
        mass: vec![8.0, 0.0, 0.0, 1.0],
        damping: vec![0.0, 0.0, 0.0, 5.0],
        stiffness: vec![0.0, 0.0, 0.0, tilt_stiffness],
        strips: vec![Strip {
            offset: 0.0,
            half_width,
            knots: vec![-1.0, 1.0],
            vectors: vec![vec![1.0, -1.0], vec![1.0, 1.0]],
        }],
        preload: vec![1.0, 0.0],
        lift: vec![0.0; 2],
        ..free_mass(1.0, force)
    }
}

/// Two wires with half of every property each equal one wire. Each contact, half as stiff, carries
/// half of the force at the same depth.
#[test]
fn two_equal_wires_are_one_of_twice_everything() {
    let double = Single {
        mass: 2.0 * STRING.mass,
        axial: 2.0 * STRING.axial,
        tension: 2.0 * STRING.tension,
        ..STRING
    };
    let level = At::level(0.0, 0.0);
    let one = lined(strings(&double, &[level]), scheme(), CONTACT);
    let two = lined(strings(&STRING, &[level, level]), scheme(), 0.5 * CONTACT);
    let way = travel(10.0, 50.0, 60.0, 1e-3);
    let ride = |p: &WireModel<3, 6>| run(p, &[three_masses(150.0)], &way, &everything());
    let (one, two) = (ride(&one), ride(&two));
    assert_eq!(two.contacts, [[0, 0, 0], [0, 0, 1]]);
    let each = [0, 1].map(|first| column(&two.force, first, 2));
    // Rounding: the share of two equal wires is the same to the last bits of a step, 700 of them.
    assert!(difference(&each[0], &each[1]) < 1e-10);
    let sum: Vec<f64> = each[0].iter().zip(&each[1]).map(|(a, b)| a + b).collect();
    assert!(difference(&sum, &one.force) < 1e-9);
    assert!(difference(&two.masses, &one.masses) < 1e-9);
    // Partner: a wire of one and a half.
    let more = Single {
        mass: 2.1 * STRING.mass,
        ..double
    };
    let other = ride(&lined(strings(&more, &[level]), scheme(), CONTACT));
    assert!(difference(&sum, &other.force) > 1e-4);
}

/// One wire rises from 0 m to 60 m, another comes down through it from 30 m to 90 m.
fn overlap() -> WireModel<3, 6> {
    let falls = At {
        up: [0.0, 0.10],
        ..At::level(0.0, 0.0)
    };
    let comes = At {
        up: [0.25, -0.35],
        ..At::level(30.0, 0.0)
    };
    lined(strings(&STRING, &[falls, comes]), scheme(), CONTACT)
}

fn slow_run(p: &WireModel<3, 6>, pantographs: &[Pantograph], to: f64) -> Record {
    let way = travel(20.0, to, 5.0, 1e-3);
    run(p, pantographs, &way, &everything())
}

#[test]
fn force_goes_over_from_one_wire_to_the_next() {
    let r = slow_run(&overlap(), &[free_mass(8.0, 120.0)], 70.0);
    let each = [0, 1].map(|first| column(&r.force, first, 2));
    let gaps = [0, 1].map(|first| column(&r.gap, first, 2));
    let total: Vec<f64> = each[0].iter().zip(&each[1]).map(|(a, b)| a + b).collect();
    // Only inertia adds to the preload: the wires meet with 5 m/s · 20 mm/m = 0.1 m/s, and a string
    // resists motion with 2 √(T m) = 345 N·s/m. Half of the 0.1 m/s for either makes 17 N.
    assert!(
        total.iter().all(|f| (f - 120.0).abs() < 20.0),
        "{}",
        peak(&total)
    );
    let both = each[0]
        .iter()
        .zip(&each[1])
        .filter(|(a, b)| **a > 1.0 && **b > 1.0);
    assert!(
        both.count() > 500,
        "the wires carry together for some metres"
    );
    assert!(
        each[1][0] == 0.0 && gaps[1][0].is_infinite(),
        "not there yet"
    );
    let last = total.len() - 1;
    assert!(
        each[0][last] == 0.0 && gaps[0][last].is_infinite(),
        "no longer there"
    );
    assert!(r.height[1].is_nan() && r.height[2 * last].is_nan());
}

/// A wire that begins below the strip is lifted onto it at once, and one that ends under load loses
/// the energy of its contact: both are switching, and the ledger closes. Measured: 1e-13 to 4e-12.
#[test]
fn ledger_closes_where_contacts_appear_and_go() {
    let below = [At::level(0.0, 0.0), At::level(40.0, -0.002)];
    for radius in [1.0, 0.8] {
        for contact in [CONTACT, f64::INFINITY] {
            let damped = Scheme::generalised_alpha(if contact.is_finite() { radius } else { 0.0 });
            let p = lined(strings(&STRING, &below), damped, contact);
            let mut way = travel(30.0, 80.0, 40.0, 1e-3);
            way.friction = 0.1;
            let r = run(&p, &[three_masses(120.0)], &way, &everything());
            // Rounding of some 1e4 sums.
            assert!(r.force.contains(&0.0) && r.energy_turnover > 1.0);
            assert!(
                r.energy_residual < 1e-11 * r.energy_turnover,
                "{:e}",
                r.energy_residual
            );
        }
    }
}

/// A wire that crosses from one side to the other slides over a head which is tilted by its own
/// contact. Nothing opens, so nothing may be lost by switching.
#[test]
fn a_wire_sliding_over_a_tilted_strip_does_work() {
    let crossing = At {
        across: [-0.3, 0.3],
        ..At::level(0.0, 0.0)
    };
    let p = lined(
        strings(&STRING, &[crossing]),
        Scheme::generalised_alpha(1.0),
        CONTACT,
    );
    let way = travel(5.0, 55.0, 10.0, 1e-3);
    let r = run(&p, &[tilting(100.0, 1.0, 800.0)], &way, &everything());
    // Rounding of some 1e4 sums.
    let end = r.energy.last().expect("recorded");
    assert!(r.gap.iter().all(|&g| g == 0.0));
    assert!(r.energy_residual < 1e-11 * r.energy_turnover);
    // Moment F y tilts the head by F y/k = 25 mm/m at y = 0.2 m: the strip rises under the wire by
    // y F y/k = 5 mm between the middle and there, F · 5 mm = 0.5 J. A step that takes y at its
    // start errs by 1e-3 of this per metre across.
    assert!(end.work_traction.abs() > 0.05, "{end:?}");
    assert!(
        end.switching.abs() < 1e-2 * end.work_traction.abs(),
        "{end:?}"
    );
}

/// Head at rest under two wires at y₁, y₂ of equal height and compliance W: z + y φ = W λ,
/// k φ = −Σ y λ.
#[test]
fn a_tilting_head_shares_its_force_by_leverage() {
    let at = |y: f64| At {
        across: [y; 2],
        ..At::level(0.0, 0.0)
    };
    let (y, k, force) = ([-0.1, 0.4], 300.0, 150.0);
    let p = lined(strings(&STRING, &[at(y[0]), at(y[1])]), scheme(), CONTACT);
    let mut way = travel(24.0, 30.0, 10.0, 1e-3);
    way.positions.fill(24.0);
    way.speeds.fill(0.0);
    let r = run(&p, &[tilting(force, 1.0, k)], &way, &everything());
    let mut still = StaticSolver::new(&p.line).expect("a firm line");
    let w = still
        .elasticity(&p.slidelines[..1], &[24.0], 0.0)
        .expect("on the wire")[0];
    let w = w + 1.0 / CONTACT;
    // Both closed: W (λ₂ − λ₁) = (y₂ − y₁) φ with φ = −(y₁ λ₁ + y₂ λ₂)/k and λ₁ + λ₂ = F.
    let apart = y[1] - y[0];
    let share = (w * force - apart * y[0] * force / k) / (2.0 * w + apart * apart / k);
    let known = [force - share, share];
    for row in 0..r.time.len() {
        for j in 0..2 {
            // Rounding of K u over the stiffness of the scheme, which 600 steps may add up.
            assert!(
                (r.force[2 * row + j] - known[j]).abs() < 1e-6,
                "{:?} {known:?}",
                &r.force[..2]
            );
        }
    }
    // Soft against the tilt and with both wires on one side, the head leans off the far one.
    let p = lined(strings(&STRING, &[at(0.1), at(0.4)]), scheme(), CONTACT);
    let r = run(&p, &[tilting(force, 1.0, 20.0)], &way, &everything());
    assert!((r.force[0] - force).abs() < 1e-6 && r.force[1] == 0.0 && r.gap[1] > 0.0);
}

/// Where a strip stands is where its pantograph does, less the offset: the same run to the bit.
#[test]
fn a_strip_behind_its_pantograph_is_a_pantograph_behind() {
    let p = lined(strings(&STRING, &[At::level(0.0, 0.0)]), scheme(), CONTACT);
    let mut behind = three_masses(120.0);
    behind.strips[0].offset = 3.7;
    let mut way = travel(15.0, 50.0, 60.0, 1e-3);
    let strip = run(&p, &[behind], &way, &everything());
    way.distances = vec![3.7];
    let pantograph = run(&p, &[three_masses(120.0)], &way, &everything());
    assert!(strip.force == pantograph.force && strip.height == pantograph.height);
    assert!(strip.position != pantograph.position);
}

/// Two strips of a rigid head on a level wire, at the same distance from its middle: half each, and
/// with the ground spring left out. The first comes to a rise of the wire before the second.
#[test]
fn two_strips_share_half_and_half() {
    let p = lined(strings(&STRING, &[At::level(0.0, 0.0)]), scheme(), CONTACT);
    let mut pantograph = free_mass(10.0, 140.0);
    let strip = |offset: f64| Strip {
        offset,
        ..Strip::plain(vec![1.0])
    };
    pantograph.strips = vec![strip(-0.3), strip(0.3)];
    let mut way = travel(30.0, 31.0, 10.0, 1e-3);
    way.positions.fill(30.0);
    way.speeds.fill(0.0);
    let r = run(&p, &[pantograph], &way, &everything());
    // Tolerance as for any pantograph that stands still.
    assert!(r.force.iter().all(|f| (f - 70.0).abs() < 1e-6));
}

#[test]
fn a_wire_out_of_reach_is_named() {
    let crossing = At {
        across: [-0.3, 0.3],
        ..At::level(0.0, 0.0)
    };
    let p = lined(strings(&STRING, &[crossing]), scheme(), CONTACT);
    let way = travel(30.0, 58.0, 10.0, 1e-3);
    let go = |pantograph: Pantograph| p.run(&[pantograph], &way, &everything(), &mut |_| true);
    match go(tilting(100.0, 0.2, 800.0)) {
        Err(CoreError::OutOfReach {
            pantograph: 0,
            position,
            lateral,
            half_width,
            ..
        }) => {
            // y = 0.2 m at 50 m; a step is 10 mm.
            assert!((position - 50.0).abs() < 0.05 && (lateral - 0.2).abs() < 1e-3);
            assert_eq!(half_width, 0.2);
        }
        other => panic!("{:?}", other.map(|r| r.steps)),
    }
    assert!(go(tilting(100.0, 0.31, 800.0)).is_ok());
    let mut behind = free_mass(8.0, 100.0);
    behind.strips.push(Strip {
        offset: 30.5,
        ..Strip::plain(vec![1.0])
    });
    assert!(matches!(
        go(behind),
        Err(CoreError::OffWire { pantograph: 0, .. })
    ));
}
