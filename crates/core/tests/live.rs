//! Line stepped from outside: the steps of a run, no allocation, and an intact state after a
//! failure.

use crate::tests::common;

use allocation_counter::measure;
use arcless_core::CoreError;
use arcless_core::integrator::wire_model::WireModel;
use arcless_core::pantograph::actuator::{Actuator, Sample};
use arcless_core::pantograph::excitation::ForceHistory;
use arcless_core::pantograph::model::Pantograph;
use arcless_core::scheme::Scheme;
use arcless_core::session::{Collector, Session, SessionStart};
use arcless_core::simulation::recording::record::Record;
use common::space::staggered;
use common::{SPAN, difference, everything, peak, simple_line, three_masses, travel};
use std::hint::black_box;
use std::sync::Arc;

const H: f64 = 1e-3;
const SPEED: f64 = 80.0;
const START: f64 = 1.3 * SPAN;

fn begin() -> SessionStart {
    SessionStart {
        position: START,
        speed: SPEED,
        friction: 0.1,
    }
}

fn planar(scheme: Scheme) -> Arc<WireModel<2, 4>> {
    Arc::new(common::prepared(5, scheme, H, 50e3))
}

fn spatial() -> Arc<WireModel<3, 6>> {
    let (structure, path) = simple_line(5);
    let line = (staggered(&structure, 5, 0.2), path);
    let scheme = Scheme::generalised_alpha(0.9);
    Arc::new(common::prepare_any(line, |_| (), scheme, H, 50e3))
}

/// Lines with residual flexibility.
fn yielding(scheme: Scheme) -> Arc<WireModel<2, 4>> {
    Arc::new(common::yielding(simple_line(5), |_| (), scheme, H, 50e3))
}

fn position(step: usize) -> f64 {
    START + SPEED * H * step as f64
}

/// The force of an actuator over time.
fn pushed(step: usize) -> f64 {
    40.0 * (0.02 * step as f64).sin()
}

fn driven() -> Pantograph {
    let mut pantograph = three_masses(250.0);
    pantograph.actuator = Some(Actuator {
        direction: vec![1.0, 0.0, 0.0],
        every: 1,
        delay: 0,
    });
    pantograph
}

fn pair() -> (Vec<Pantograph>, Vec<f64>) {
    (vec![driven(), driven()], vec![0.0, 31.0])
}

fn run<const DIM: usize, const D: usize>(
    p: &WireModel<DIM, D>,
    steps: usize,
    friction: f64,
) -> Record {
    let (pantographs, distances) = pair();
    let mut way = travel(START, position(steps) + 1e-6, SPEED, H);
    (way.distances, way.friction) = (distances, friction);
    let ask = &mut |_: usize, s: &Sample| Ok(pushed(s.number));
    let done = p.run_controlled(&pantographs, &way, &everything(), &mut |_| true, ask);
    let record = done.expect("it runs");
    assert!(record.slack_max > 0, "links go slack");
    record
}

fn with_pantographs<const DIM: usize, const D: usize>(
    p: &Arc<WireModel<DIM, D>>,
) -> Session<DIM, D> {
    let (pantographs, distances) = pair();
    Session::with_pantographs(p.clone(), pantographs, distances, begin()).expect("it stands")
}

fn with_forces<const DIM: usize, const D: usize>(p: &Arc<WireModel<DIM, D>>) -> Session<DIM, D> {
    with_friction(p, 0.1)
}

fn with_friction<const DIM: usize, const D: usize>(
    p: &Arc<WireModel<DIM, D>>,
    friction: f64,
) -> Session<DIM, D> {
    let begin = SessionStart {
        friction,
        ..begin()
    };
    let collectors = [0.0, 31.0].map(|behind| Collector {
        behind,
        half_width: 0.6,
    });
    Session::with_forces(p.clone(), collectors.into(), &[250.0; 2], begin).expect("it stands")
}

/// Steps with simulated pantographs are those of a run, bit for bit.
fn is_the_run<const DIM: usize, const D: usize>(p: &Arc<WireModel<DIM, D>>) {
    let record = run(p, 700, 0.1);
    let mut live = with_pantographs(p);
    for step in 0..700 {
        let force = pushed(step);
        live.step(&[force, force], position(step + 1), SPEED)
            .expect("a step");
        assert_eq!(
            live.outputs().force[..],
            record.force[2 * step..][..2],
            "{step}"
        );
    }
    assert_eq!(live.outputs().contacts, record.contacts);
}

#[test]
fn simulated_pantographs_step_as_in_a_run() {
    is_the_run(&planar(Scheme::generalised_alpha(0.9)));
    is_the_run(&spatial());
    is_the_run(&yielding(Scheme::generalised_alpha(0.9)));
}

/// Contact forces of a run, prescribed, move the wire as they did in the run. With Newmark's scheme
/// a run records the end of each step. Rounding: the run adds contact forces as prepared columns.
/// (Without friction, which a run takes from the force of the step before.)
#[test]
fn given_forces_of_a_run_move_the_wire_as_the_run() {
    move_as_the_run(&planar(Scheme::newmark(0.3025, 0.6)));
    move_as_the_run(&yielding(Scheme::newmark(0.3025, 0.6)));
}

fn move_as_the_run(p: &Arc<WireModel<2, 4>>) {
    let record = run(p, 700, 0.0);
    let mut live = with_friction(p, 0.0);
    let mut heights = Vec::new();
    for (step, forces) in record.force.chunks(2).enumerate() {
        live.step(forces, position(step + 1), SPEED)
            .expect("a step");
        heights.extend_from_slice(&live.outputs().height);
    }
    let moved: Vec<f64> = record.height.iter().map(|z| z - record.height[0]).collect();
    let found: Vec<f64> = heights.iter().map(|z| z - record.height[0]).collect();
    assert!(peak(&moved) > 0.05, "the wire moves");
    assert!(
        difference(&found, &moved) < 1e-9,
        "{}",
        difference(&found, &moved)
    );
}

/// The integral of the rate dz/dt at the moving contact is the height. The trapezoidal rule misses
/// changes within single steps: links go slack, the force moves on by 8 cm (by 2 cm where kinks are
/// rounded over 9 cm).
#[test]
fn the_rate_is_the_derivative_of_the_height() {
    rate_is_derivative(&planar(Scheme::generalised_alpha(0.9)), SPEED);
    rate_is_derivative(&yielding(Scheme::generalised_alpha(0.9)), 0.25 * SPEED);
}

fn rate_is_derivative(p: &Arc<WireModel<2, 4>>, speed: f64) {
    let mut live = with_forces(p);
    let (mut height, mut sum) = (Vec::new(), vec![0.0]);
    let mut before = 0.0;
    for step in 0..800 {
        let force = 150.0 + 0.1 * step as f64;
        let x = START + speed * H * (step + 1) as f64;
        live.step(&[force, 150.0], x, speed).expect("a step");
        let rate = live.outputs().rate[0];
        if step >= 200 {
            height.push(live.outputs().height[0]);
        }
        if step > 200 {
            sum.push(sum[sum.len() - 1] + 0.5 * H * (before + rate));
        }
        before = rate;
    }
    let moved: Vec<f64> = height.iter().map(|z| z - height[0]).collect();
    assert!(peak(&moved) > 0.02, "the wire moves");
    let error = difference(&sum, &moved);
    assert!(error < 0.01, "{error}");
}

fn allocations<const DIM: usize, const D: usize>(mut live: Session<DIM, D>, most: f64) -> u64 {
    let counted = measure(|| {
        for step in 0..900 {
            let force = most * (0.5 - 0.5 * (0.05 * step as f64).cos());
            let done = live.step(&[force; 2], position(step + 1), SPEED);
            assert!(done.is_ok());
        }
    });
    counted.count_total
}

#[test]
fn a_step_allocates_nothing() {
    let p = planar(Scheme::generalised_alpha(0.9));
    // Forces that lift many links at once, and pantographs that lose contact.
    assert_eq!(allocations(with_forces(&p), 900.0), 0);
    assert_eq!(allocations(with_pantographs(&p), -400.0), 0);
    assert_eq!(allocations(with_forces(&spatial()), 900.0), 0);
    assert_eq!(allocations(with_pantographs(&spatial()), -400.0), 0);
    let p = yielding(Scheme::generalised_alpha(0.9));
    assert_eq!(allocations(with_forces(&p), 900.0), 0);
    assert_eq!(allocations(with_pantographs(&p), -400.0), 0);
    let counted = measure(|| drop(black_box(vec![1.0; 3])));
    assert_eq!(counted.count_total, 1, "allocations are noticed");
}

/// Two loops, one of which fails now and then, go the same way.
fn go_on_after_failures<const DIM: usize, const D: usize>(
    mut live: Session<DIM, D>,
    mut whole: Session<DIM, D>,
) {
    for step in 0..300 {
        let (forces, next) = ([200.0 + pushed(step); 2], position(step + 1));
        if step % 50 == 7 {
            let end = 5.0 * SPAN;
            let beyond = live.step(&forces, end + 1.0, SPEED);
            assert!(matches!(beyond, Err(CoreError::OffWire { step: s, .. }) if s == step));
            let before = live.step(&forces, 20.0, SPEED);
            assert!(matches!(
                before,
                Err(CoreError::OffWire { pantograph: 1, .. })
            ));
            for (forces, next, speed) in [
                (&[f64::NAN, 0.0][..], next, SPEED),
                (&[1.0][..], next, SPEED),
                (&forces[..], f64::INFINITY, SPEED),
                (&forces[..], next, f64::NAN),
            ] {
                let refused = live.step(forces, next, speed);
                assert!(matches!(refused, Err(CoreError::Input { .. })));
            }
        }
        live.step(&forces, next, SPEED).expect("a step");
        whole.step(&forces, next, SPEED).expect("a step");
        assert_eq!(live.outputs().height, whole.outputs().height);
        assert_eq!(live.outputs().force, whole.outputs().force);
    }
}

#[test]
fn a_loop_goes_on_after_a_failure() {
    let p = planar(Scheme::generalised_alpha(0.9));
    go_on_after_failures(with_forces(&p), with_forces(&p));
    go_on_after_failures(with_pantographs(&p), with_pantographs(&p));
}

fn repeats<const DIM: usize, const D: usize>(mut live: Session<DIM, D>) {
    let go = |live: &mut Session<DIM, D>| {
        let first = live.steps();
        let mut seen = Vec::new();
        for step in first..first + 200 {
            live.step(&[200.0 + pushed(step); 2], position(step + 1), SPEED)
                .expect("a step");
            seen.extend_from_slice(&live.outputs().height);
            seen.extend_from_slice(&live.outputs().force);
        }
        seen
    };
    let start = live.save().expect("a state");
    let first = go(&mut live);
    let middle = live.save().expect("a state");
    let second = go(&mut live);
    live.restore(&middle).expect("a state of its own");
    assert_eq!(live.position_and_speed(), (position(200), SPEED));
    assert_eq!(go(&mut live), second);
    live.restore(&start).expect("a state of its own");
    assert_eq!(go(&mut live), first);
    let mut foreign = start.clone();
    foreign.numbers.remove("line_velocity");
    assert!(live.restore(&foreign).is_err());
    assert_eq!(go(&mut live), second, "a refused state changes nothing");
}

#[test]
fn a_state_put_back_repeats_what_followed() {
    let p = planar(Scheme::generalised_alpha(0.9));
    repeats(with_forces(&p));
    repeats(with_pantographs(&p));
    repeats(with_pantographs(&spatial()));
    let p = yielding(Scheme::generalised_alpha(0.9));
    repeats(with_forces(&p));
    repeats(with_pantographs(&p));
}

#[test]
fn what_a_loop_cannot_do_is_refused() {
    let p = planar(Scheme::generalised_alpha(0.9));
    let collector = Collector {
        behind: 0.0,
        half_width: f64::INFINITY,
    };
    let none = Session::with_forces(p.clone(), Vec::new(), &[], begin());
    assert!(matches!(
        none,
        Err(CoreError::Input {
            array: "collectors",
            ..
        })
    ));
    let few = Session::with_forces(p.clone(), vec![collector], &[], begin());
    assert!(matches!(
        few,
        Err(CoreError::Input {
            array: "forces",
            ..
        })
    ));
    let far = SessionStart {
        position: -1.0,
        ..begin()
    };
    let off = Session::with_forces(p.clone(), vec![collector], &[100.0], far);
    assert!(matches!(off, Err(CoreError::OffWire { .. })));
    let mut late = driven();
    late.actuator.as_mut().expect("an actuator").delay = 2;
    let mut given = driven();
    given.excitation.forces.push(ForceHistory {
        direction: vec![0.0; 3],
        values: vec![0.0; 9],
    });
    for pantograph in [late, given] {
        let refused = Session::with_pantographs(p.clone(), vec![pantograph], vec![0.0], begin());
        assert!(matches!(
            refused,
            Err(CoreError::Input {
                array: "pantographs",
                ..
            })
        ));
    }
    let mut live = Session::with_pantographs(p, vec![three_masses(100.0)], vec![0.0], begin())
        .expect("it stands");
    let unheard = live.step(&[1.0], position(1), SPEED);
    assert!(matches!(
        unheard,
        Err(CoreError::Input {
            array: "forces",
            ..
        })
    ));
    live.step(&[0.0], position(1), SPEED)
        .expect("no force, no actuator");
}
