//! Pantograph by itself: the motion it has on a line under the same contact forces, what it says of
//! the step that comes, and states.

use crate::tests::common;

use allocation_counter::measure;
use arcless_core::CoreError;
use arcless_core::pantograph::actuator::Actuator;
use arcless_core::pantograph::breakpoint::ForceKind;
use arcless_core::pantograph::bump_stop::BumpStop;
use arcless_core::pantograph::excitation::BaseMotion;
use arcless_core::pantograph::model::Pantograph;
use arcless_core::pantograph::piecewise_force::PiecewiseForce;
use arcless_core::scheme::Scheme;
use arcless_core::session::alone::{Alone, AloneInputs};
use arcless_core::session::{Session, SessionStart};
use common::{SPAN, three_masses};
use std::sync::Arc;

const H: f64 = 1e-3;
const SPEED: f64 = 80.0;
const START: f64 = 1.3 * SPAN;

fn plain() -> Pantograph {
    let mut pantograph = three_masses(250.0);
    pantograph.lift = vec![0.001, 0.0, 0.0];
    pantograph.actuator = Some(Actuator {
        direction: vec![1.0, 0.0, 0.0],
        every: 1,
        delay: 0,
    });
    pantograph
}

/// With dry friction and a stop that closes.
fn rough() -> Pantograph {
    let mut pantograph = plain();
    let points = [[-2e-3, -20.0], [-1e-3, -20.0], [1e-3, 20.0], [2e-3, 20.0]];
    pantograph.piecewise_forces = vec![PiecewiseForce {
        direction: vec![1.0, 0.0, 0.0],
        kind: ForceKind::Damper,
        points: points.to_vec(),
    }];
    pantograph.stops = vec![BumpStop {
        direction: vec![0.0, -1.0, 1.0],
        gap: 0.004,
        stiffness: 1e5,
    }];
    pantograph
}

fn pushed(step: usize) -> f64 {
    60.0 * (0.02 * step as f64).sin()
}

/// Session with a pantograph, and the same one by itself.
fn both(pantograph: Pantograph, scheme: Scheme) -> (Session<2, 4>, Alone) {
    let line = Arc::new(common::prepared(5, scheme, H, 50e3));
    let begin = SessionStart {
        position: START,
        speed: SPEED,
        friction: 0.1,
    };
    let live = Session::with_pantographs(line, vec![pantograph], vec![0.0], begin);
    let live = live.expect("it stands");
    let (model, start) = live.standing_alone(0).expect("a pantograph");
    assert!(live.standing_alone(1).is_none());
    let alone = Alone::new(model, (scheme, H), start).expect("it stands");
    (live, alone)
}

fn inputs(forces: &[f64], actuator: f64) -> AloneInputs<'_> {
    AloneInputs {
        forces,
        laterals: &[0.0],
        actuator,
        speed: SPEED,
        base: [0.0; 2],
    }
}

const SCHEMES: [fn() -> Scheme; 3] = [
    || Scheme::generalised_alpha(0.9),
    || Scheme::newmark(0.3025, 0.6),
    || Scheme::BackwardDifference,
];

/// Under the contact forces that it has on a line it moves as there.
#[test]
fn it_moves_as_on_a_line() {
    for scheme in SCHEMES {
        for pantograph in [plain(), rough()] {
            let (mut live, mut alone) = both(pantograph, scheme());
            let mut moved: f64 = 0.0;
            for step in 0..700 {
                let x = START + SPEED * H * (step + 1) as f64;
                live.step(&[pushed(step)], x, SPEED).expect("a step");
                let forces = [live.outputs().force[0]];
                alone.step(&inputs(&forces, pushed(step))).expect("a step");
                for (index, expected) in live.outputs().displacement.iter().enumerate() {
                    let [found, _] = alone.coordinate(index);
                    // Rounding of sums in another order, of some metres.
                    assert!(
                        (found - expected).abs() < 1e-12,
                        "step {step}: {found} {expected}"
                    );
                    moved = moved.max(found.abs());
                }
            }
            assert!(moved > 0.02, "it moves");
        }
    }
}

/// Heights and compliance foretold are those of the step: about any contact force without stops
/// and tables, about the one that acts with them.
#[test]
fn it_knows_how_it_yields() {
    for scheme in SCHEMES {
        let (_, mut alone) = both(plain(), scheme());
        for step in 0..300 {
            let force = [250.0 + 2.0 * pushed(step)];
            foretold(&mut alone, (&[0.0], &force), pushed(step));
        }
        let (mut live, mut alone) = both(rough(), scheme());
        for step in 0..500 {
            let x = START + SPEED * H * (step + 1) as f64;
            live.step(&[pushed(step)], x, SPEED).expect("a step");
            let force = [live.outputs().force[0]];
            foretold(&mut alone, (&force, &force), pushed(step));
        }
    }
}

fn foretold(alone: &mut Alone, (about, force): (&[f64], &[f64]), actuator: f64) {
    let (mut height, mut compliance) = ([0.0], [0.0]);
    let mut again = [0.0; 2];
    let (supposed, step) = (inputs(about, actuator), inputs(force, actuator));
    alone
        .look_ahead(&supposed, &mut height, &mut compliance)
        .expect("a look");
    let (first, rest) = again.split_at_mut(1);
    alone.look_ahead(&supposed, first, rest).expect("a look");
    assert_eq!(again, [height[0], compliance[0]], "a look changes nothing");
    alone.step(&step).expect("a step");
    let expected = height[0] - compliance[0] * force[0];
    let found = alone.height(0);
    assert!(compliance[0] > 0.0);
    // Rounding of heights of 6 m.
    assert!((found - expected).abs() < 1e-13, "{found} {expected}");
}

/// A base that moves in a step raises a pantograph as in a run. Backward differences do not care
/// what was before, so one step is enough: with c on the base alone, C r ż + K r z is its force.
#[test]
fn its_base_moves_it() {
    let mut pantograph = plain();
    pantograph.excitation.base = Some(BaseMotion {
        influence: vec![1.0; 3],
        displacement: vec![0.0],
        rate: vec![0.0],
    });
    let scheme = Scheme::BackwardDifference;
    let (_, start) = both(plain(), scheme)
        .0
        .standing_alone(0)
        .expect("a pantograph");
    let mut alone = Alone::new(pantograph, (scheme, H), start.clone()).expect("it stands");
    let mut still = Alone::new(plain(), (scheme, H), start).expect("it stands");
    let force = [250.0];
    let mut moving = inputs(&force, 0.0);
    // In the long run everything is raised by as much as the base.
    moving.base = [0.05, 0.0];
    for _ in 0..60_000 {
        alone.step(&moving).expect("a step");
        still.step(&inputs(&force, 0.0)).expect("a step");
    }
    for index in 0..3 {
        let raised = alone.coordinate(index)[0] - still.coordinate(index)[0];
        assert!((raised - 0.05).abs() < 1e-6, "{raised}");
    }
}

#[test]
fn steps_and_looks_allocate_nothing() {
    for pantograph in [plain(), rough()] {
        let (_, mut alone) = both(pantograph, Scheme::generalised_alpha(0.9));
        let (mut height, mut compliance) = ([0.0], [0.0]);
        let counted = measure(|| {
            for step in 0..300 {
                let force = [250.0 + 5.0 * pushed(step)];
                let step = inputs(&force, pushed(step));
                let seen = alone.look_ahead(&step, &mut height, &mut compliance);
                assert!(seen.is_ok() && alone.step(&step).is_ok());
            }
        });
        assert_eq!(counted.count_total, 0);
    }
}

#[test]
fn a_state_put_back_repeats_what_followed() {
    let (_, mut alone) = both(rough(), Scheme::generalised_alpha(0.9));
    let go = |alone: &mut Alone| {
        let mut seen = Vec::new();
        for step in 0..200 {
            let force = [250.0 + 3.0 * pushed(step)];
            alone.step(&inputs(&force, pushed(step))).expect("a step");
            seen.extend([alone.height(0), alone.velocity(0)]);
        }
        seen
    };
    go(&mut alone);
    let saved = alone.save().expect("a state");
    let first = go(&mut alone);
    alone.restore(&saved).expect("a state of its own");
    assert_eq!(alone.steps(), 200);
    assert_eq!(go(&mut alone), first);
    let mut foreign = saved;
    foreign.numbers.remove("alone_velocity");
    assert!(alone.restore(&foreign).is_err());
}

#[test]
fn what_it_cannot_take_is_refused() {
    let (_, mut alone) = both(three_masses(250.0), Scheme::generalised_alpha(0.9));
    for (forces, actuator) in [
        (&[f64::NAN][..], 0.0),
        (&[][..], 0.0),
        (&[1.0, 2.0][..], 0.0),
        (&[1.0][..], f64::INFINITY),
        (&[1.0][..], 5.0),
    ] {
        let refused = alone.step(&inputs(forces, actuator));
        assert!(matches!(refused, Err(CoreError::Input { .. })));
    }
    assert_eq!(alone.steps(), 0);
}
