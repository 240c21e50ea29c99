//! Pantographs outside of the core: those that a program moves give the motion of simulated ones.

use crate::tests::common;

use allocation_counter::measure;
use arcless_core::CoreError;
use arcless_core::integrator::wire_model::WireModel;
use arcless_core::linalg::small::inner;
use arcless_core::pantograph::actuator::Sample;
use arcless_core::pantograph::external::{Outside, StepStart};
use arcless_core::pantograph::model::Pantograph;
use arcless_core::pantograph::state::PantographState;
use arcless_core::pantograph::strip::Strip;
use arcless_core::scheme::{Coefficients, Scheme};
use arcless_core::session::{Session, SessionStart};
use arcless_core::simulation::callbacks::Callbacks;
use arcless_core::simulation::recording::record::Record;
use arcless_core::simulation::run::Part;
use common::chain::{explicit, lumped};
use common::{SPAN, difference, everything, peak, simple_line, steady, three_masses};
use std::sync::Arc;

const H: f64 = 1e-3;
const SPEED: f64 = 80.0;
const START: f64 = 1.3 * SPAN;
const STEPS: usize = 600;
const FORCE: f64 = 250.0;
/// Sum of the rounding of some hundred steps, as a share.
const ROUNDING: f64 = 1e-6;

/// Program outside: pantographs of three masses, stepped by the scheme of the line.
struct Simulated {
    coefficients: Coefficients,
    states: Vec<Option<PantographState>>,
    asked: Vec<StepStart>,
}

impl Simulated {
    fn new(coefficients: Coefficients, count: usize) -> Self {
        Self {
            coefficients,
            states: vec![None; count],
            asked: Vec::new(),
        }
    }

    fn strip(&self, number: usize) -> (&PantographState, &[f64]) {
        let state = self.states[number].as_ref().expect("it has begun");
        (state, &state.model.strips[0].vectors[0])
    }

    /// Height of the strip at the end of the step without contact, m, and its compliance, m/N.
    fn free_motion(&mut self, number: usize) -> (f64, f64) {
        let c = self.coefficients;
        let state = self.states[number].as_mut().expect("it has begun");
        state.predict(&c, SPEED);
        let (state, e) = self.strip(number);
        let height = inner(e, &state.u) + inner(e, &state.delta);
        (height, inner(e, &state.response(e)))
    }

    fn take(&mut self, number: usize, force: f64) -> f64 {
        let c = self.coefficients;
        let (state, e) = self.strip(number);
        let column = state.response(e);
        let state = self.states[number].as_mut().expect("it has begun");
        state.apply_contact_force(force, &column);
        state.commit(&c);
        let (state, e) = self.strip(number);
        inner(e, &state.u)
    }
}

impl Outside for Simulated {
    fn begin(&mut self, number: usize, heights: &[f64], forces: &[f64]) -> Result<(), String> {
        assert!((forces[0] - FORCE).abs() < 1e-9, "{forces:?}");
        let state =
            PantographState::new(three_masses(FORCE), &self.coefficients, heights[0], SPEED);
        self.states[number] = Some(state.expect("it stands"));
        Ok(())
    }

    fn predict(
        &mut self,
        number: usize,
        start: &StepStart,
        heights: &mut [f64],
        compliance: &mut [f64],
    ) -> Result<(), String> {
        self.asked.push(*start);
        (heights[0], compliance[0]) = self.free_motion(number);
        Ok(())
    }

    fn advance(
        &mut self,
        number: usize,
        forces: &[f64],
        heights: &mut [f64],
    ) -> Result<(), String> {
        let reached = self.take(number, forces[0]);
        assert!((reached - heights[0]).abs() < 1e-12, "a linear pantograph");
        heights[0] = reached;
        Ok(())
    }
}

fn external() -> Pantograph {
    Pantograph::external(vec![Strip::plain(vec![1.0])], 1, FORCE)
}

fn run<const DIM: usize, const D: usize>(
    p: &WireModel<DIM, D>,
    pantographs: &[Pantograph],
    outside: &mut dyn Outside,
) -> Result<Record, CoreError> {
    let mut way = steady(START, SPEED, H, STEPS);
    way.distances = [0.0, 31.0][..pantographs.len()].to_vec();
    let callbacks = Callbacks {
        observe: &mut |_| true,
        ask: &mut |_: usize, _: &Sample| Err("nobody controls it".into()),
        outside,
        take: None,
    };
    let done = p.run_pieces(pantographs, &way, &everything(), Part::default(), callbacks);
    done.map(|(record, _)| record)
}

/// Compares a run with pantographs outside with one of simulated ones. The same equations are
/// solved in another order: rounding, which the contact stiffness multiplies. `work` is a tolerance
/// for the work on the strips, as a share of the energy turned over.
fn is_as_simulated<const DIM: usize, const D: usize>(p: &WireModel<DIM, D>, work: f64) {
    let inside = [three_masses(FORCE), three_masses(FORCE)];
    let mut outside = Simulated::new(p.coefficients, 2);
    let expected = run(p, &inside, &mut outside).expect("it runs");
    let found = run(p, &[external(), external()], &mut outside).expect("it runs");
    assert!(expected.slack_max > 0, "links go slack");
    let moved: Vec<f64> = expected.force.iter().map(|f| f - FORCE).collect();
    assert!(peak(&moved) > 50.0, "the force changes");
    let off = difference(&found.force, &expected.force);
    assert!(off < 1e-9, "{off}");
    let off = difference(&found.height, &expected.height);
    assert!(off < 1e-9, "{off}");
    // Masses of the strips alone, of the pantographs the last of three each.
    let strips: Vec<f64> = expected.masses.chunks(3).map(|all| all[2]).collect();
    assert!(difference(&found.masses, &strips) < 1e-9);
    // The balance closed in every step (it ends the run where it does not). In the end the work on
    // the strips is that of the uplift less what pantographs store and dissipate.
    let [e, f] = [&expected, &found].map(|r| r.energy[r.energy.len() - 1]);
    assert_eq!((f.pantographs, f.dissipated_pantographs), (0.0, 0.0));
    let on_strips = e.work_uplift - e.pantographs - e.dissipated_pantographs;
    let scheme = e.dissipated_scheme - f.dissipated_scheme;
    let off = (f.work_uplift - (on_strips - scheme)).abs();
    assert!(off < work * e.turnover(), "{off} of {}", e.turnover());
    let asked = &outside.asked;
    assert_eq!(asked.len(), 2 * STEPS);
    let last = asked[2 * STEPS - 1];
    assert_eq!((last.step, last.time), (STEPS - 1, (STEPS - 1) as f64 * H));
    assert_eq!(
        (last.position, last.speed),
        (position(STEPS - 1) - 31.0, SPEED)
    );
}

fn position(step: usize) -> f64 {
    START + SPEED * H * step as f64
}

fn planar(scheme: Scheme) -> WireModel<2, 4> {
    common::prepared(5, scheme, H, 50e3)
}

#[test]
fn strips_moved_by_a_program_are_those_of_simulated_pantographs() {
    is_as_simulated(&planar(Scheme::generalised_alpha(0.9)), ROUNDING);
    is_as_simulated(&planar(Scheme::generalised_alpha(1.0)), ROUNDING);
    is_as_simulated(&planar(Scheme::newmark(0.3025, 0.6)), ROUNDING);
    is_as_simulated(&planar(Scheme::BackwardDifference), ROUNDING);
    let scheme = Scheme::generalised_alpha(0.9);
    let line = common::yielding(simple_line(5), |_| (), scheme, H, 50e3);
    is_as_simulated::<2, 4>(&line, ROUNDING);
}

#[test]
fn strips_moved_by_a_program_press_on_chains() {
    let (structure, path) = simple_line(5);
    let chain = (lumped(&structure), vec![path]);
    // Energies of explicit steps belong to half a step later, where the velocity of a strip is one
    // of the whole step: 250 N · ½ h · some 0.1 m/s of some 100 J.
    is_as_simulated(
        &explicit::<2, 2>(&chain, H, 50e3).expect("short steps"),
        2e-4,
    );
}

fn begin() -> SessionStart {
    SessionStart {
        position: START,
        speed: SPEED,
        friction: 0.0,
    }
}

/// Steps of a session with strips given, moved by pantographs outside, and their contact forces.
fn session_forces<const DIM: usize, const D: usize>(
    session: &mut Session<DIM, D>,
    outside: &mut Simulated,
    steps: std::ops::Range<usize>,
) -> Vec<f64> {
    let mut forces = Vec::new();
    for step in steps {
        let (heights, compliance): (Vec<f64>, Vec<f64>) =
            (0..2).map(|number| outside.free_motion(number)).unzip();
        let done = session.step_strips(&heights, &compliance, position(step + 1), SPEED);
        done.expect("a step");
        for number in 0..2 {
            let reached = outside.take(number, session.outputs().force[number]);
            let off = (reached - session.outputs().strip_height[number]).abs();
            assert!(off < 1e-12, "{off}");
        }
        forces.extend_from_slice(&session.outputs().force);
    }
    forces
}

fn started<const DIM: usize, const D: usize>(
    p: &Arc<WireModel<DIM, D>>,
) -> (Session<DIM, D>, Simulated) {
    let pantographs = vec![external(), external()];
    let session = Session::with_strips(p.clone(), pantographs, vec![0.0, 31.0], begin());
    let session = session.expect("it stands");
    let mut outside = Simulated::new(p.coefficients, 2);
    for number in 0..2 {
        let height = session.outputs().strip_height[number];
        // At the wire, into which the contact stiffness lets it.
        let off = height - session.outputs().height[number] - FORCE / 50e3;
        assert!(off.abs() < 1e-12, "{off}");
        outside
            .begin(number, &[height], &[FORCE])
            .expect("it begins");
    }
    (session, outside)
}

/// A session with strips given is the run of simulated pantographs, and its states can be restored.
#[test]
fn a_session_with_strips_is_the_run() {
    let p = Arc::new(planar(Scheme::generalised_alpha(0.9)));
    let inside = [three_masses(FORCE), three_masses(FORCE)];
    let mut nobody = Simulated::new(p.coefficients, 0);
    let expected = run(&p, &inside, &mut nobody).expect("it runs");
    let (mut session, mut outside) = started(&p);
    let mut found = session_forces(&mut session, &mut outside, 0..STEPS / 2);
    let saved = session.save().expect("a state");
    let states = outside.states.clone();
    let second = session_forces(&mut session, &mut outside, STEPS / 2..STEPS);
    session.restore(&saved).expect("its own state");
    outside.states = states;
    let again = session_forces(&mut session, &mut outside, STEPS / 2..STEPS);
    assert_eq!(second, again);
    found.extend(second);
    let off = difference(&found, &expected.force);
    assert!(off < 1e-9, "{off}");
}

/// Strips that are held at a height rise along with nothing: the gap is that of the wire.
#[test]
fn held_strips_press_by_the_contact_law() {
    let p = Arc::new(planar(Scheme::newmark(0.3025, 0.6)));
    let (mut session, _) = started(&p);
    let held = [0, 1].map(|number| session.outputs().strip_height[number]);
    for step in 0..200 {
        session
            .step_strips(&held, &[0.0; 2], position(step + 1), SPEED)
            .expect("a step");
        let outputs = session.outputs();
        assert_eq!(outputs.strip_height, held);
        for number in 0..2 {
            let overlap = held[number] - outputs.height[number];
            let force = 50e3 * overlap.max(0.0);
            assert!((outputs.force[number] - force).abs() < 1e-6 * FORCE);
        }
    }
}

#[test]
fn a_step_of_strips_allocates_nothing() {
    let p = Arc::new(planar(Scheme::generalised_alpha(0.9)));
    let (mut session, _) = started(&p);
    let counted = measure(|| {
        for step in 0..300 {
            let heights = [0.05 * (0.05 * step as f64).sin(), 0.01];
            let done = session.step_strips(&heights, &[1e-4; 2], position(step + 1), SPEED);
            assert!(done.is_ok());
        }
    });
    assert_eq!(counted.count_total, 0);
}

fn refused<T>(result: Result<T, CoreError>, text: &str) {
    match result {
        Err(CoreError::Input { reason, .. }) => assert!(reason.contains(text), "{reason}"),
        Err(other) => panic!("{other}"),
        Ok(_) => panic!("accepted, without: {text}"),
    }
}

#[test]
fn motions_that_cannot_be_are_refused() {
    let p = Arc::new(planar(Scheme::generalised_alpha(0.9)));
    let (mut session, _) = started(&p);
    let before = session.outputs().force.clone();
    for (heights, compliance, text) in [
        (&[0.0][..], &[0.0; 2][..], "expected [2, 2]"),
        (&[0.0; 2], &[0.0; 4], "expected [2, 2]"),
        (
            &[0.0, f64::NAN],
            &[0.0; 2],
            "pantograph 1: the height is NaN m",
        ),
        (
            &[0.0; 2],
            &[f64::INFINITY, 0.0],
            "pantograph 0: the compliance is inf m/N",
        ),
        (&[0.0; 2], &[-1e-4, 0.0], "negative"),
    ] {
        let step = session.step_strips(heights, compliance, position(1), SPEED);
        refused(step, text);
    }
    refused(session.step(&[], position(1), SPEED), "heights");
    assert_eq!(session.outputs().force, before);
    let strips = [0.0, 0.4].map(|offset| Strip {
        offset,
        ..Strip::plain(if offset == 0.0 {
            vec![1.0, 0.0]
        } else {
            vec![0.0, 1.0]
        })
    });
    let pair = Pantograph::external(strips.to_vec(), 2, FORCE);
    let mut session = Session::with_strips(p.clone(), vec![pair], vec![0.0], begin()).expect("two");
    let heights = [session.outputs().strip_height[0]; 2];
    for (matrix, text) in [
        ([1e-4, 0.0, 1e-5, 1e-4], "not symmetric"),
        ([1e-4, 2e-4, 2e-4, 1e-4], "negative"),
    ] {
        refused(
            session.step_strips(&heights, &matrix, position(1), SPEED),
            text,
        );
    }
    session
        .step_strips(&heights, &[1e-4; 4], position(1), SPEED)
        .expect("strips that yield together");
    let simulated = Session::with_strips(p.clone(), vec![three_masses(FORCE)], vec![0.0], begin());
    refused(simulated, "not external");
    let outside = Session::with_pantographs(p.clone(), vec![external()], vec![0.0], begin());
    refused(outside, "external");
    let heavy = Pantograph {
        mass: vec![1.0],
        ..external()
    };
    refused(
        Session::with_strips(p, vec![heavy], vec![0.0], begin()),
        "matrices",
    );
}

/// Program that fails in its own way.
struct Failing {
    inner: Simulated,
    height: Option<f64>,
}

impl Outside for Failing {
    fn begin(&mut self, number: usize, heights: &[f64], forces: &[f64]) -> Result<(), String> {
        self.inner.begin(number, heights, forces)
    }

    fn predict(
        &mut self,
        number: usize,
        start: &StepStart,
        heights: &mut [f64],
        compliance: &mut [f64],
    ) -> Result<(), String> {
        self.inner.predict(number, start, heights, compliance)?;
        match self.height {
            Some(height) if start.step == 5 => heights[0] = height,
            None if start.step == 5 => return Err("out of order".into()),
            _ => (),
        }
        Ok(())
    }

    fn advance(
        &mut self,
        number: usize,
        forces: &[f64],
        heights: &mut [f64],
    ) -> Result<(), String> {
        self.inner.advance(number, forces, heights)
    }
}

#[test]
fn a_failure_outside_ends_the_run_with_its_place() {
    let p = planar(Scheme::generalised_alpha(0.9));
    for (height, text) in [(None, "out of order"), (Some(f64::NAN), "NaN m")] {
        let inner = Simulated::new(p.coefficients, 1);
        let ended = run(&p, &[external()], &mut Failing { inner, height });
        let Err(CoreError::External {
            pantograph,
            step,
            time,
            position: place,
            reason,
        }) = ended
        else {
            panic!("no failure");
        };
        assert_eq!((pantograph, step, time), (0, 5, 5.0 * H));
        assert_eq!(place, position(5));
        assert!(reason.contains(text), "{reason}");
    }
}
