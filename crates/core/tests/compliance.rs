//! Compliance of the line in the coming step, with which a program outside solves contact itself.

use crate::tests::common;

use allocation_counter::measure;
use arcless_core::CoreError;
use arcless_core::integrator::wire_model::WireModel;
use arcless_core::lcp::LcpSolver;
use arcless_core::linalg::small::inner;
use arcless_core::pantograph::model::Pantograph;
use arcless_core::pantograph::state::PantographState;
use arcless_core::pantograph::strip::Strip;
use arcless_core::scheme::Scheme;
use arcless_core::session::{Collector, Compliance, Session, SessionStart};
use common::chain::{explicit, lumped};
use common::{SPAN, difference, everything, simple_line, steady, three_masses};
use std::sync::Arc;

const H: f64 = 1e-3;
const SPEED: f64 = 80.0;
const START: f64 = 1.3 * SPAN;
const CONTACT: f64 = 50e3;
const DISTANCES: [f64; 2] = [0.0, 3.0];

fn begin() -> SessionStart {
    SessionStart {
        position: START,
        speed: SPEED,
        friction: 0.0,
    }
}

fn position(step: usize) -> f64 {
    START + SPEED * H * step as f64
}

/// Two collectors, near one another, so that each lifts the wire at the other.
fn pressed<const DIM: usize, const D: usize>(
    p: &Arc<WireModel<DIM, D>>,
    force: f64,
) -> Session<DIM, D> {
    let collectors = DISTANCES.map(|behind| Collector {
        behind,
        half_width: f64::INFINITY,
    });
    Session::with_forces(p.clone(), collectors.into(), &[force; 2], begin()).expect("it stands")
}

fn planar(scheme: Scheme) -> Arc<WireModel<2, 4>> {
    Arc::new(common::prepared(5, scheme, H, CONTACT))
}

fn yielding(scheme: Scheme) -> Arc<WireModel<2, 4>> {
    Arc::new(common::yielding(simple_line(5), |_| (), scheme, H, CONTACT))
}

fn chain() -> Arc<WireModel<2, 2>> {
    let (structure, path) = simple_line(5);
    let chain = (lumped(&structure), vec![path]);
    Arc::new(explicit(&chain, H, CONTACT).expect("short steps"))
}

/// Compares the predicted heights with those of a step under other forces, for a scheme whose
/// balance is at the end of the step, as the outputs are. `slack` links are allowed for.
fn heights_are_those_of_a_step<const DIM: usize, const D: usize>(
    p: &Arc<WireModel<DIM, D>>,
    force: f64,
) {
    let mut session = pressed(p, force);
    let mut undisturbed = pressed(p, force);
    for step in 0..250 {
        let next = position(step + 1);
        let found = session
            .compliance(next, SPEED)
            .expect("a compliance")
            .clone();
        let [w00, w01, w10, w11] = found.matrix[..] else {
            panic!("{found:?}");
        };
        // Damping of slack links, whose tension follows their elongation, not the force above them.
        assert!((w01 - w10).abs() < 1e-3 * w00, "{found:?}");
        assert!(w00 > 0.0 && w00 * w11 > w01 * w10, "{found:?}");
        let saved = session.save().expect("a state");
        // So little that no link slackens or tightens because of it.
        for change in [[0.0, 0.0], [0.05, 0.0], [0.0, -0.05], [0.05, 0.05]] {
            let forces = [force + change[0], force + change[1]];
            session.step(&forces, next, SPEED).expect("a step");
            for (number, height) in session.outputs().height.iter().enumerate() {
                let row = &found.matrix[2 * number..][..2];
                let expected = found.free_height[number] + inner(row, &forces);
                assert!(
                    (height - expected).abs() < 1e-12,
                    "{height} {expected} in {step}"
                );
            }
            session.restore(&saved).expect("its own state");
        }
        session.step(&[force; 2], next, SPEED).expect("a step");
        undisturbed.step(&[force; 2], next, SPEED).expect("a step");
        assert_eq!(session.outputs().height, undisturbed.outputs().height);
        assert_eq!(session.outputs().rate, undisturbed.outputs().rate);
    }
}

#[test]
fn compliance_is_that_of_a_step_under_two_forces() {
    heights_are_those_of_a_step(&planar(Scheme::newmark(0.3025, 0.6)), 100.0);
    heights_are_those_of_a_step(&yielding(Scheme::newmark(0.3025, 0.6)), 100.0);
    heights_are_those_of_a_step(&chain(), 100.0);
}

/// With forces that lift droppers, the wire is softer than with none of them slack.
#[test]
fn slack_links_make_the_wire_softer() {
    let p = planar(Scheme::newmark(0.3025, 0.6));
    heights_are_those_of_a_step(&p, 500.0);
    heights_are_those_of_a_step(&chain(), 500.0);
    let softness = |force: f64| {
        let mut session = pressed(&p, force);
        let mut sum = 0.0;
        for step in 0..200 {
            let next = position(step + 1);
            sum += session
                .compliance(next, SPEED)
                .expect("a compliance")
                .matrix[0];
            session.step(&[force; 2], next, SPEED).expect("a step");
        }
        sum
    };
    assert!(softness(500.0) > 1.001 * softness(10.0));
}

/// Pantographs outside that solve contact with the compliance of the line: the largest difference
/// of their contact forces from those inside, as a share.
fn coupled_outside<const DIM: usize, const D: usize>(
    p: &Arc<WireModel<DIM, D>>,
    force: f64,
) -> f64 {
    const STEPS: usize = 400;
    let mut way = steady(START, SPEED, H, STEPS);
    way.distances = DISTANCES.to_vec();
    let inside = [three_masses(force), three_masses(force)];
    let record = p.run(&inside, &way, &everything(), &mut |_| true);
    let record = record.expect("it runs");
    assert!(record.force.iter().any(|f| (f - force).abs() > 20.0));
    let mut session = pressed(p, force);
    let (c, keep) = (p.coefficients, p.coefficients.stiffness);
    // Where a run begins: explicit steps move the line at rest by fractions of a micrometre.
    let strip = || Pantograph::external(vec![Strip::plain(vec![1.0])], 1, force);
    let strips = Session::with_strips(
        p.clone(),
        vec![strip(), strip()],
        DISTANCES.to_vec(),
        begin(),
    );
    let heights = strips.expect("they stand").outputs().strip_height.clone();
    let mut states = [0, 1].map(|number| {
        let state = PantographState::new(three_masses(force), &c, heights[number], SPEED);
        state.expect("it stands")
    });
    let (mut solver, mut forces) = (LcpSolver::new(), Vec::new());
    for step in 0..STEPS {
        let next = position(step + 1);
        let e = [0.0, 0.0, 1.0];
        states.iter_mut().for_each(|state| state.predict(&c, SPEED));
        let columns = [0, 1].map(|number: usize| states[number].response(&e));
        let line = session.compliance(next, SPEED);
        let line = line.expect("a compliance").clone();
        let (mut h, mut w) = (line.matrix, line.free_height);
        for (number, state) in states.iter().enumerate() {
            w[number] -= inner(&e, &state.u) + keep * inner(&e, &state.delta);
            h[3 * number] += keep * inner(&e, &columns[number]) + 1.0 / CONTACT;
        }
        let (mut x, mut y) = ([0.0; 2], [0.0; 2]);
        let solved = solver.solve(&h, &w, &mut x, &mut y, &[]);
        solved.expect("a solution");
        for (state, (pressed, column)) in states.iter_mut().zip(x.iter().zip(&columns)) {
            state.apply_contact_force(*pressed, column);
            state.commit(&c);
        }
        session.step(&x, next, SPEED).expect("a step");
        forces.extend_from_slice(&x);
    }
    difference(&forces, &record.force)
}

#[test]
fn a_pantograph_outside_is_coupled_as_one_inside() {
    let found = [
        coupled_outside(&planar(Scheme::generalised_alpha(0.9)), 120.0),
        coupled_outside(&planar(Scheme::generalised_alpha(0.9)), 250.0),
        coupled_outside(&planar(Scheme::generalised_alpha(1.0)), 120.0),
        coupled_outside(&planar(Scheme::BackwardDifference), 120.0),
        coupled_outside(&yielding(Scheme::generalised_alpha(0.9)), 250.0),
        coupled_outside(&chain(), 120.0),
    ];
    assert!(found.iter().all(|off| *off < 1e-9), "{found:?}");
}

/// A force that makes links slacken within the step lifts the wire further than it would have been
/// known from small forces; a compliance about that force knows.
#[test]
fn a_compliance_about_a_force_knows_the_links_that_it_lifts() {
    let p = planar(Scheme::newmark(0.3025, 0.6));
    let mut session = pressed(&p, 100.0);
    let [mut most, mut least] = [0.0_f64; 2];
    for step in 0..100 {
        let (next, large) = (position(step + 1), [900.0; 2]);
        let about_small = session
            .compliance(next, SPEED)
            .expect("a compliance")
            .clone();
        let about_large = session.compliance_about(&large, next, SPEED);
        let about_large = about_large.expect("a compliance").clone();
        let saved = session.save().expect("a state");
        session.step(&large, next, SPEED).expect("a step");
        let reached = session.outputs().height[0];
        let off = |found: &Compliance| {
            (reached - found.free_height[0] - inner(&found.matrix[..2], &large)).abs()
        };
        most = most.max(off(&about_small));
        least = least.max(off(&about_large));
        session.restore(&saved).expect("its own state");
        session.step(&[100.0; 2], next, SPEED).expect("a step");
    }
    // A few hundred nanometres; rounding is a millionth of that.
    assert!(most > 1e-8 && least < 1e-12, "{most} {least}");
}

#[test]
fn a_compliance_allocates_nothing() {
    fn none<const DIM: usize, const D: usize>(p: &Arc<WireModel<DIM, D>>) {
        let mut session = pressed(p, 500.0);
        let counted = measure(|| {
            for step in 0..200 {
                let next = position(step + 1);
                assert!(session.compliance(next, SPEED).is_ok());
                assert!(session.step(&[500.0; 2], next, SPEED).is_ok());
            }
        });
        assert_eq!(counted.count_total, 0);
    }
    none(&planar(Scheme::generalised_alpha(0.9)));
    none(&yielding(Scheme::generalised_alpha(0.9)));
    none(&chain());
}

/// A compliance that cannot be found leaves the session as it was.
#[test]
fn a_compliance_beyond_the_wire_is_refused() {
    let p = chain();
    let (mut session, mut other) = (pressed(&p, 100.0), pressed(&p, 100.0));
    for step in 0..50 {
        let off = session.compliance(5.0 * SPAN + 1.0, SPEED);
        assert!(matches!(off, Err(CoreError::OffWire { .. })));
        let infinite = session.compliance(f64::INFINITY, SPEED);
        assert!(matches!(infinite, Err(CoreError::Input { .. })));
        session
            .step(&[100.0; 2], position(step + 1), SPEED)
            .expect("a step");
        other
            .step(&[100.0; 2], position(step + 1), SPEED)
            .expect("a step");
        assert_eq!(session.outputs().height, other.outputs().height);
    }
    let inside = Session::with_pantographs(p, vec![three_masses(100.0)], vec![0.0], begin());
    let mut inside = inside.expect("it stands");
    let none = inside.compliance(position(1), SPEED);
    assert!(matches!(
        none,
        Err(CoreError::Input {
            array: "collectors",
            ..
        })
    ));
}
