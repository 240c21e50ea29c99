//! A loop with explicit steps: the steps of a run.

use super::{explicit, plan, way};
use crate::tests::common::chain::lumped;
use crate::tests::common::space::staggered;
use crate::tests::common::{SPAN, difference, peak, simple_line_of, three_masses};
use allocation_counter::measure;
use arcless_core::integrator::wire_model::WireModel;
use arcless_core::session::{Collector, Session, SessionStart};
use arcless_core::simulation::recording::record::Record;
use std::sync::Arc;

const H: f64 = 1e-3;
const SPEED: f64 = 80.0;
const START: f64 = 1.3 * SPAN;
const STEPS: usize = 700;
const BEHIND: [f64; 2] = [0.0, 31.0];
const FORCE: f64 = 250.0;

fn planar() -> Arc<WireModel<2, 2>> {
    let (structure, path) = simple_line_of(4, [0.9; 2]);
    Arc::new(explicit(&(lumped(&structure), vec![path]), H))
}

fn spatial() -> Arc<WireModel<3, 3>> {
    let (structure, path) = simple_line_of(4, [0.9; 2]);
    let chain = lumped(&staggered(&structure, 4, 0.2));
    Arc::new(explicit(&(chain, vec![path]), H))
}

fn position(step: usize) -> f64 {
    START + SPEED * H * step as f64
}

fn begin() -> SessionStart {
    SessionStart {
        position: START,
        speed: SPEED,
        friction: 0.0,
    }
}

fn run<const DIM: usize, const D: usize>(p: &WireModel<DIM, D>) -> Record {
    let mut travel = way(START, SPEED, H, H * STEPS as f64);
    travel.distances = BEHIND.to_vec();
    let pantographs = [FORCE; 2].map(three_masses);
    let record = p.run(&pantographs, &travel, &plan(Vec::new()), &mut |_| true);
    let record = record.expect("it runs");
    assert!(record.slack_max > 0, "links go slack");
    record
}

fn with_pantographs<const DIM: usize, const D: usize>(
    p: &Arc<WireModel<DIM, D>>,
) -> Session<DIM, D> {
    let pantographs = [FORCE; 2].map(three_masses).to_vec();
    Session::with_pantographs(p.clone(), pantographs, BEHIND.to_vec(), begin()).expect("it stands")
}

fn with_forces<const DIM: usize, const D: usize>(p: &Arc<WireModel<DIM, D>>) -> Session<DIM, D> {
    let collectors = BEHIND.map(|behind| Collector {
        behind,
        half_width: 0.6,
    });
    Session::with_forces(p.clone(), collectors.to_vec(), &[FORCE; 2], begin()).expect("it stands")
}

fn pantographs_step_as_in_a_run<const DIM: usize, const D: usize>(p: &Arc<WireModel<DIM, D>>) {
    let record = run(p);
    let mut live = with_pantographs(p);
    for step in 0..STEPS {
        live.step(&[0.0; 2], position(step + 1), SPEED)
            .expect("a step");
        assert_eq!(
            live.outputs().force[..],
            record.force[2 * step..][..2],
            "{step}"
        );
    }
}

#[test]
fn simulated_pantographs_step_as_in_a_run() {
    pantographs_step_as_in_a_run(&planar());
    pantographs_step_as_in_a_run(&spatial());
}

/// Rounding: a run adds contact forces behind the answers of links, a loop before them.
fn forces_move_as_the_run<const DIM: usize, const D: usize>(p: &Arc<WireModel<DIM, D>>) {
    let record = run(p);
    let mut live = with_forces(p);
    let (mut heights, mut sides) = (Vec::new(), Vec::new());
    for (step, forces) in record.force.chunks(2).enumerate() {
        live.step(forces, position(step + 1), SPEED)
            .expect("a step");
        heights.extend_from_slice(&live.outputs().height);
        sides.extend_from_slice(&live.outputs().lateral);
    }
    let from = |list: &[f64]| -> Vec<f64> { list.iter().map(|z| z - record.height[0]).collect() };
    let (found, moved) = (from(&heights), from(&record.height));
    assert!(peak(&moved) > 0.05, "the wire moves");
    let apart = difference(&found, &moved);
    assert!(apart < 1e-9, "{apart}");
    assert!(DIM == 2 || difference(&sides, &record.lateral) < 1e-9);
}

#[test]
fn given_forces_of_a_run_move_the_wire_as_the_run() {
    forces_move_as_the_run(&planar());
    forces_move_as_the_run(&spatial());
}

fn allocations<const DIM: usize, const D: usize>(mut live: Session<DIM, D>, force: f64) -> u64 {
    let counted = measure(|| {
        for step in 0..STEPS {
            let done = live.step(&[force; 2], position(step + 1), SPEED);
            assert!(done.is_ok());
        }
    });
    counted.count_total
}

#[test]
fn a_step_allocates_nothing() {
    assert_eq!(allocations(with_pantographs(&planar()), 0.0), 0);
    assert_eq!(allocations(with_forces(&planar()), 400.0), 0);
    assert_eq!(allocations(with_forces(&spatial()), 400.0), 0);
}

#[test]
fn a_state_put_back_repeats_what_followed() {
    let p = planar();
    for (mut live, force) in [(with_pantographs(&p), 0.0), (with_forces(&p), 300.0)] {
        let go = |live: &mut Session<2, 2>| {
            let mut seen = Vec::new();
            for step in live.steps()..live.steps() + 200 {
                live.step(&[force; 2], position(step + 1), SPEED)
                    .expect("a step");
                seen.extend_from_slice(&live.outputs().height);
                seen.extend_from_slice(&live.outputs().rate);
            }
            seen
        };
        go(&mut live);
        let state = live.save().expect("a state");
        let first = go(&mut live);
        live.restore(&state).expect("a state of its own");
        assert_eq!(go(&mut live), first);
    }
}
