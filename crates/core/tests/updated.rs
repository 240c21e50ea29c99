//! Updated kinematics: small motion, rest, large forces, and what they refuse. Each step is held
//! against the published one in `tests/verification/references/test_literal_step.py`.

use crate::tests::common;

use arcless_core::CoreError;
use arcless_core::integrator::wire_model::WireModel;
use arcless_core::linear::model::LinearModel;
use arcless_core::pantograph::excitation::Excitation;
use arcless_core::pantograph::model::Pantograph;
use arcless_core::pantograph::strip::Strip;
use arcless_core::scheme::Scheme;
use arcless_core::simulation::inputs::Trajectory;
use arcless_core::simulation::recording::record::{Record, RecordPlan};
use arcless_core::slideline::Slideline;
use arcless_core::structure::Structure;
use common::chain::{lumped, settled};
use common::{Single, orders, simple_line_of, three_masses};

const CONTACT: f64 = 50e3;

fn plan(points: Vec<f64>) -> RecordPlan {
    RecordPlan {
        contact_every: 1,
        line_every: 1,
        links: true,
        nodes: Vec::new(),
        supports: Vec::new(),
        points,
        ledger: false,
        ledger_every: 1,
        near: None,
        motion: None,
    }
}

fn travel(start: f64, speed: f64, h: f64, steps: usize) -> Trajectory {
    Trajectory {
        positions: (0..=steps).map(|i| start + speed * h * i as f64).collect(),
        speeds: vec![speed; steps + 1],
        distances: vec![0.0],
        friction: 0.0,
        loads: Vec::new(),
    }
}

fn updated<const DIM: usize, const D: usize>(
    (structure, path): &(Structure, Vec<usize>),
    scheme: Scheme,
    h: f64,
    contact: f64,
) -> WireModel<DIM, D> {
    let (geometry, shape) = settled::<DIM, D>(structure.clone());
    let lanes = Slideline::from_elements(&geometry, &shape, std::slice::from_ref(path))
        .expect("the wire is a path");
    WireModel::updated(
        &geometry,
        LinearModel::new(&geometry, shape.clone()),
        lanes,
        scheme,
        h,
        contact,
    )
    .expect("regular")
}

fn linearised<const DIM: usize, const D: usize>(
    line: &(Structure, Vec<usize>),
    scheme: Scheme,
    h: f64,
    contact: f64,
) -> WireModel<DIM, D> {
    common::prepare_any(line.clone(), |_| (), scheme, h, contact)
}

fn run<const DIM: usize, const D: usize>(
    p: &WireModel<DIM, D>,
    pantograph: &Pantograph,
    travel: &Trajectory,
    points: Vec<f64>,
) -> Record {
    p.run(
        std::slice::from_ref(pantograph),
        travel,
        &plan(points),
        &mut |_| true,
    )
    .expect("the run goes through")
}

/// The two masses of the paper's example, without damping.
fn two_masses(force: f64) -> Pantograph {
    Pantograph {
        mass: vec![45.0, 0.0, 0.0, 16.0],
        damping: vec![0.0; 4],
        stiffness: vec![7e3, -6e3, -6e3, 6e3],
        strips: vec![Strip::plain(vec![0.0, 1.0])],
        preload: vec![1.0, 0.0],
        lift: vec![0.0; 2],
        start_force: force,
        excitation: Excitation::default(),
        stops: Vec::new(),
        piecewise_forces: Vec::new(),
        actuator: None,
        is_external: false,
    }
}

/// A slack-free single wire of point masses that sags by some centimetres.
fn wire() -> (Structure, Vec<usize>) {
    let single = Single {
        length: 24.0,
        elements: 48,
        mass: 1.07,
        axial: 12e6,
        bending: 145.0,
        tension: 12e3,
        gravity: 9.81,
    };
    let (structure, path) = single.structure(2);
    (lumped(&structure), path)
}

/// The error of linearisation grows with the square of the motion: half of the static force, and
/// with it of the motion, leaves a quarter of the difference of the contact forces.
#[test]
fn small_motion_is_linearised_motion() {
    let mut line = simple_line_of(2, [1.45, 2.9]);
    line.0.links.iter_mut().for_each(|l| l.unilateral = false);
    let (h, scheme) = (2e-3, Scheme::generalised_alpha(0.5));
    let old = linearised::<2, 4>(&line, scheme, h, CONTACT);
    let new = updated::<2, 4>(&line, scheme, h, CONTACT);
    let way = travel(40.0, 40.0, h, 300);
    let apart = |force: f64| {
        let pantograph = three_masses(force);
        let (a, b) = (
            run(&old, &pantograph, &way, Vec::new()),
            run(&new, &pantograph, &way, Vec::new()),
        );
        let pairs = a.force.iter().zip(&b.force);
        pairs.map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
    };
    let found = orders(&[400.0, 200.0, 100.0].map(apart));
    // Two, up to the cubic part and to a small linear one: the static slope of the wire times its
    // displacement along the track, which linearised contacts leave out.
    assert!(found.iter().all(|p| (p - 2.0).abs() < 0.05), "{found:?}");
}

/// A collector that stands still stays in its first equilibrium, whatever the force: nothing moves.
#[test]
fn the_first_equilibrium_lasts() {
    let line = simple_line_of(2, [1.45, 2.9]);
    for contact in [CONTACT, f64::INFINITY] {
        let scheme = Scheme::generalised_alpha(0.0);
        let p = updated::<2, 4>(&line, scheme, 1e-3, contact);
        for force in [100.0, 900.0] {
            let way = travel(52.0, 0.0, 1e-3, 60);
            let r = run(&p, &three_masses(force), &way, vec![52.0]);
            // The balance is found to about 1e-6 N; heights to that over 1e3 N/m.
            // Forces balance to EA ε x / L; some droppers are slack at 900 N.
            assert!(
                r.force.iter().all(|f| (f - force).abs() < 1e-5),
                "{contact}"
            );
            assert_eq!(r.slack_max > 0, force > 500.0);
            let rise = &r.point_uplift;
            assert!(rise.iter().all(|z| (z - rise[0]).abs() < 1e-9));
        }
    }
}

/// Static lift of the middle of a taut string by a force that is not small: with the ends held,
/// T = T₀ + EA (ℓ/L − 1) and P = 4 T z / ℓ, ℓ² = L² + 4 z² (two straight halves).
#[test]
fn a_large_static_force_stiffens_the_string() {
    let (length, tension, axial) = (24.0, 12e3, 12e6);
    let single = Single {
        length,
        elements: 48,
        mass: 1e-3,
        axial,
        bending: 0.0,
        tension,
        gravity: 0.0,
    };
    let (structure, path) = single.structure(2);
    let line = (lumped(&structure), path);
    let p = updated::<2, 2>(&line, Scheme::BackwardDifference, 1e-3, f64::INFINITY);
    let force = 3000.0;
    let r = run(
        &p,
        &two_masses(force),
        &travel(12.0, 0.0, 1e-3, 2),
        vec![12.0],
    );
    let unstretched = length / (1.0 + tension / axial);
    let lift = |z: f64| {
        let long = (length * length + 4.0 * z * z).sqrt();
        axial * (long / unstretched - 1.0) * 4.0 * z / long
    };
    let z = r.point_uplift[0];
    // Newton's method leaves the balance of the forces to 1e-7 N.
    assert!((lift(z) / force - 1.0).abs() < 1e-7, "{z}");
    assert!(
        4.0 * tension * z / length < 0.6 * force,
        "the partner: linear theory"
    );
}

#[test]
fn an_energy_ledger_is_refused() {
    let p = updated::<2, 2>(&wire(), Scheme::BackwardDifference, 1e-3, CONTACT);
    let with = RecordPlan {
        ledger: true,
        ledger_every: 1,
        ..plan(Vec::new())
    };
    let way = travel(6.0, 60.0, 1e-3, 3);
    let refused = p.run(&[two_masses(100.0)], &way, &with, &mut |_| true);
    assert!(matches!(
        refused,
        Err(CoreError::Input { array: "plan", .. })
    ));
}

#[test]
fn a_wire_that_folds_back_is_noticed() {
    let (structure, elements) = wire();
    let (geometry, shape) = settled::<2, 2>(structure);
    let mut path = Slideline::new(&geometry, &shape, &elements).expect("a path");
    let mut u = vec![[0.0; 2]; shape.len()];
    u[20][0] = 0.49;
    assert!(path.update_geometry(&u), "just not yet: elements of 0.5 m");
    u[20][0] = 0.51;
    assert!(!path.update_geometry(&u));
}
