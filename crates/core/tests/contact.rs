//! Moving contacts against closed forms, and what a unilateral contact must never do.

use crate::tests::common;

use arcless_core::energy_terms::EnergyTerms;
use arcless_core::linear::static_response::StaticSolver;
use arcless_core::scheme::Scheme;
use arcless_core::simulation::recording::record::Record;
use arcless_core::structure::Rayleigh;
use common::{Single, difference, everything, free_mass, peak, run, three_masses, travel};
use std::f64::consts::PI;

const STRING: Single = Single {
    length: 60.0,
    elements: 120,
    mass: 1.35,
    axial: 15e6,
    bending: 0.0,
    tension: 22e3,
    gravity: 0.0,
};

/// Mass so small that its inertia is no part of the force: 1e-6 kg · 100 m/s² = 1e-4 N of 100 N.
const FEATHER: f64 = 1e-6;
const FORCE: f64 = 100.0;

/// Displacement at `x` of a taut string, at rest at t = 0, under a force that enters at one end
/// with speed `v`. Source: Fryba, Vibration of Solids and Structures under Moving Loads, section
/// 1.2, with bending and damping left out. Terms decay as 1/n²; 2000 leave 1e-7.
fn series(s: &Single, v: f64, x: f64, t: f64) -> f64 {
    // Mass per metre of the stretched string.
    let mass = s.mass / (1.0 + s.stretch());
    let c = (s.tension / mass).sqrt();
    let sum: f64 = (1..=2000)
        .map(|n| {
            let k = f64::from(n) * PI / s.length;
            let (drive, own) = (k * v, k * c);
            let time = (drive * t).sin() - drive / own * (own * t).sin();
            (k * x).sin() * time / (own * own - drive * drive)
        })
        .sum();
    2.0 * FORCE / (mass * s.length) * sum
}

/// Largest and mean error of the uplift of three points while the force crosses the string,
/// relative to the largest uplift.
fn crossing_error(s: &Single, exact: &Single, speed: f64, h: f64) -> (f64, f64) {
    let p = common::prepare(
        s.structure(2),
        |_| (),
        Scheme::generalised_alpha(0.8),
        h,
        50e3,
    );
    let mut plan = everything();
    plan.points = vec![20.0, 30.0, 50.0];
    let way = travel(0.0, s.length, speed, h);
    let r = run(&p, &[free_mass(FEATHER, FORCE)], &way, &plan);
    let exact_at = |t: f64| plan.points.iter().map(move |&x| series(exact, speed, x, t));
    let known: Vec<f64> = r.line_time.iter().flat_map(|&t| exact_at(t)).collect();
    let errors = r
        .point_uplift
        .iter()
        .zip(&known)
        .map(|(a, b)| (a - b).abs());
    let mean = errors.sum::<f64>() / known.len() as f64;
    (difference(&r.point_uplift, &known), mean / peak(&known))
}

/// At 320 km/h the wave front reaches the far end after 0.47 s, the force after 0.67 s: the
/// reflected wave meets the force on its way and passes the points again.
#[test]
fn moving_force_and_its_reflection_follow_the_exact_series() {
    let speed = 320.0 / 3.6;
    let meshes = [
        (30, 2e-3),
        (60, 1e-3),
        (120, 5e-4),
        (240, 2.5e-4),
        (480, 1.25e-4),
    ];
    let errors = meshes.map(|(elements, h)| {
        let s = Single { elements, ..STRING };
        crossing_error(&s, &s, speed, h)
    });
    // A scheme of second order smears the kink at the front over a width of order h^(2/3), which is
    // also the order of the largest error (Brenner, Thomee & Wahlbin 1975).
    let orders = common::orders(&errors.map(|e| e.0));
    assert!(orders.iter().all(|&p| p > 0.6), "{errors:?}");
    assert!(errors[2].0 < 8e-3 && errors[2].1 < 3e-4, "{errors:?}");
    // Partner: one per cent of tension.
    let tension = 1.01 * STRING.tension;
    let fault = crossing_error(&STRING, &Single { tension, ..STRING }, speed, 5e-4);
    assert!(fault.0 > 1.2e-2 && fault.1 > 1e-3, "{fault:?}");
}

#[test]
fn standing_pantographs_stay_as_they_started() {
    for contact in [50e3, f64::INFINITY] {
        let scheme = Scheme::generalised_alpha(0.9);
        let p = common::prepare(common::simple_line(4), |_| (), scheme, 1e-3, contact);
        let mut way = travel(130.0, 150.0, 100.0, 1e-3);
        way.positions.fill(130.0);
        way.speeds.fill(0.0);
        way.distances = vec![0.0, 37.0];
        let forces = [150.0, 80.0];
        let r = run(&p, &forces.map(three_masses), &way, &everything());
        let places = [130.0, 93.0].map(|x| p.slidelines[0].locate(x, 0).expect("on the wire"));
        let still = StaticSolver::new(&p.line)
            .and_then(|mut s| s.solve(&places, &forces))
            .expect("an equilibrium");
        for (j, force) in forces.iter().enumerate() {
            let height = places[j].height + places[j].displacement(&still.u, 1);
            for row in 0..r.time.len() {
                // Rounding of K u over the stiffness of the scheme, which 200 steps may add up.
                assert!((r.force[2 * row + j] - force).abs() < 1e-6);
                assert!((r.height[2 * row + j] - height).abs() < 1e-9);
                assert!(r.gap[2 * row + j] == 0.0);
            }
        }
        assert!(peak(&r.masses) < 1e-9);
    }
}

fn on_line(force: f64, speed: f64, contact: f64, radius: f64) -> Record {
    let scheme = Scheme::generalised_alpha(radius);
    let p = common::prepare(common::simple_line(5), |_| (), scheme, 1e-3, contact);
    let way = travel(70.0, 205.0, speed, 1e-3);
    run(&p, &[three_masses(force)], &way, &everything())
}

/// The strip of a contact of stiffness k stands λ/k higher; the forces differ in proportion to 1/k.
#[test]
fn very_stiff_contact_is_the_rigid_one() {
    let rigid = on_line(150.0, 60.0, f64::INFINITY, 0.0);
    let gaps: Vec<f64> = [1e7, 1e8, 1e9]
        .iter()
        .map(|&k| difference(&on_line(150.0, 60.0, k, 0.0).force, &rigid.force))
        .collect();
    // Stiffness of pantograph and wire in one step (A ≈ 4 m/h² = 1e7 N/m) over 1e9 N/m: below 1e-2.
    assert!(gaps[2] < 2e-3, "{gaps:?}");
    assert!(gaps[1] > 5.0 * gaps[2], "{gaps:?}");
    assert!(difference(&on_line(150.0, 60.0, 50e3, 0.0).force, &rigid.force) > 1e-2);
}

#[test]
fn contact_opens_and_closes_without_overlap_or_pull() {
    for contact in [50e3, f64::INFINITY] {
        let r = on_line(50.0, 320.0 / 3.6, contact, 0.5);
        let pairs: Vec<(f64, f64)> = r.force.iter().copied().zip(r.gap.iter().copied()).collect();
        assert!(
            pairs
                .iter()
                .all(|&(f, g)| f >= 0.0 && g >= 0.0 && f * g == 0.0)
        );
        let open: Vec<bool> = pairs.iter().map(|&(_, g)| g > 0.0).collect();
        let changes = open.windows(2).filter(|w| w[0] != w[1]).count();
        assert!(
            open.contains(&true) && changes >= 2,
            "it opens and closes again"
        );
    }
    // Partner: a heavy preload never opens.
    let firm = on_line(200.0, 30.0, 50e3, 0.5);
    assert!(firm.gap.iter().all(|&g| g == 0.0) && firm.force.iter().all(|&f| f > 0.0));
}

/// Run of a light head thrown off the wire of an undamped line, after which the train stands still:
/// mechanical energy from then on in J, and number of touchdowns.
fn thrown_head(contact: f64, radius: f64) -> (Vec<f64>, usize) {
    let (mut structure, path) = common::simple_line(4);
    structure
        .wires
        .iter_mut()
        .for_each(|w| w.damping = Rayleigh::default());
    structure
        .links
        .iter_mut()
        .for_each(|l| l.damping = Rayleigh::default());
    structure.masses.iter_mut().for_each(|m| m.alpha = 0.0);
    structure.springs.iter_mut().for_each(|s| s.viscosity = 0.0);
    let scheme = Scheme::generalised_alpha(radius);
    let p = common::prepare((structure, path), |_| (), scheme, 1e-3, contact);
    let mut way = travel(70.0, 150.0, 320.0 / 3.6, 1e-3);
    let (stop, end) = (620, 3000);
    way.positions.truncate(stop + 1);
    way.positions.resize(end, way.positions[stop]);
    way.speeds.resize(end, 0.0);
    way.speeds[stop..].fill(0.0);
    let r = run(&p, &[free_mass(7.5, 8.0)], &way, &everything());
    let energy =
        |e: &EnergyTerms| e.kinetic + e.elastic + e.contact + e.pantographs - e.work_uplift;
    let total = r.energy[stop + 1..].iter().map(energy).collect();
    let landings = r.gap[stop..]
        .windows(2)
        .filter(|w| w[0] > 0.0 && w[1] == 0.0);
    (total, landings.count())
}

/// Largest growth of the energy in one step, and its last value, both relative to the first.
fn growth(total: &[f64]) -> (f64, f64) {
    let largest = total.windows(2).map(|w| w[1] - w[0]).fold(0.0, f64::max);
    (largest / total[0], total[total.len() - 1] / total[0])
}

/// Nothing supplies energy but the preload, which has a potential: with a compliant contact and any
/// dissipative member, or a rigid one and ρ = 0, it does not grow. What these members decrease is
/// their own norm, which differs from the energy by O(h²): a thousandth from step to step.
#[test]
fn bouncing_head_gains_no_energy() {
    for radius in [0.9, 0.5, 0.0] {
        let (total, landings) = thrown_head(50e3, radius);
        // A thousandth: what the members' own norm differs by, see above.
        let (largest, end) = growth(&total);
        assert!(landings > 3);
        assert!(largest < 1e-3 && end < 1.0, "{radius}: {largest:e} {end}");
    }
    let (total, landings) = thrown_head(f64::INFINITY, 0.0);
    // Tolerance as above, for a rigid contact.
    let (largest, end) = growth(&total);
    assert!(landings > 3 && largest < 1e-3 && end < 1.0);
}

/// The trap of formulation.md, section 5, and the partner of the test above: a rigid contact closed
/// at the level of positions throws the head back with more than it came with unless ρ = 0.
#[test]
fn rigid_contact_needs_full_dissipation() {
    for radius in [1.0, 0.9, 0.5] {
        let (total, _) = thrown_head(f64::INFINITY, radius);
        let (largest, end) = growth(&total);
        assert!(largest > 1e-2 && end > 1.0);
    }
}
