//! Single steps: a run consists of them, and a copy of a state continues as the original does.

use crate::tests::common;

use arcless_core::integrator::wire_model::WireModel;
use arcless_core::linear::loads::Loads;
use arcless_core::pantograph::model::Pantograph;
use arcless_core::scheme::Scheme;
use arcless_core::simulation::inputs::Inputs;
use arcless_core::simulation::model::Model;
use arcless_core::simulation::state::State;
use arcless_core::simulation::step::step;
use common::{SPAN, everything, prepared, steady, three_masses};

const H: f64 = 1e-3;
const SPEED: f64 = 80.0;
const START: f64 = 1.3 * SPAN;
const STEPS: usize = 300;

fn model<'a>(line: &'a WireModel<2, 4>, pantographs: &'a [Pantograph]) -> Model<'a, 2, 4> {
    Model {
        wires: line,
        pantographs,
        distances: &[0.0],
        friction: 0.1,
    }
}

/// Step number `number` of an even motion.
fn inputs(number: usize, old: f64) -> Inputs<'static> {
    let at = |k: usize| START + SPEED * H * k as f64;
    let (start, end) = (at(number), at(number + 1));
    Inputs {
        positions: [start, (1.0 - old) * end + old * start, end],
        speed: SPEED,
        loads: Loads::new(&[], &[]),
        excitations: &[],
    }
}

#[test]
fn steps_one_by_one_are_a_run_and_a_copy_goes_on_alike() {
    let line = prepared(5, Scheme::generalised_alpha(1.0), H, 50e3);
    let pantographs = [three_masses(250.0)];
    let model = model(&line, &pantographs);
    let old = line.coefficients.old;
    let mut state = State::in_equilibrium(&model, (START, SPEED), true).expect("it stands");
    let mut forces = Vec::new();
    for number in 0..STEPS {
        step(&model, &inputs(number, old), &mut state).expect("it steps");
        forces.push(state.contact_forces()[0]);
    }
    let mut way = steady(START, SPEED, H, STEPS);
    way.friction = 0.1;
    let record = line.run(&pantographs, &way, &everything(), &mut |_| true);
    let record = record.expect("it runs");
    assert_eq!(forces, record.force);

    let mut copy = state.clone();
    for number in STEPS..2 * STEPS {
        step(&model, &inputs(number, old), &mut state).expect("it steps");
    }
    for number in STEPS..2 * STEPS {
        step(&model, &inputs(number, old), &mut copy).expect("it steps");
    }
    assert_eq!(copy.steps(), 2 * STEPS);
    assert_eq!(copy.contact_forces(), state.contact_forces());
    assert_eq!(
        copy.pantograph_displacement(0),
        state.pantograph_displacement(0)
    );
}
