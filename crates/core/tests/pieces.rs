//! Series handed on in pieces, and rows that hold only what is near.

use crate::tests::common::{everything, prepare, simple_line, three_masses};
use crate::tests::resume::{bits, way};

use arcless_core::CoreError;
use arcless_core::integrator::wire_model::WireModel;
use arcless_core::linear::loads::Load;
use arcless_core::pantograph::actuator::Sample;
use arcless_core::pantograph::external::Nobody;
use arcless_core::scheme::Scheme;
use arcless_core::simulation::callbacks::Callbacks;
use arcless_core::simulation::inputs::Trajectory;
use arcless_core::simulation::recording::record::{Record, RecordPlan};
use arcless_core::simulation::recording::window::{MotionPlan, Near, SortedStations};
use arcless_core::simulation::run::Part;

const STEPS: usize = 1030;

fn line() -> WireModel<2, 4> {
    prepare(simple_line(3), |_| (), Scheme::hht(0.1), 1e-3, 5e4)
}

/// A run with its series handed on whenever they hold so many numbers.
fn run(
    p: &WireModel<2, 4>,
    plan: &RecordPlan,
    enough: usize,
    take: &mut dyn FnMut(Record) -> bool,
) -> Result<Record, CoreError> {
    run_along(p, &way(STEPS, vec![0.0]), plan, enough, take)
}

fn run_along(
    p: &WireModel<2, 4>,
    way: &Trajectory,
    plan: &RecordPlan,
    enough: usize,
    take: &mut dyn FnMut(Record) -> bool,
) -> Result<Record, CoreError> {
    let mut nobody = |_: usize, _: &Sample| Err("nobody controls it".into());
    let callers = Callbacks {
        observe: &mut |_| true,
        ask: &mut nobody,
        outside: &mut Nobody,
        take: Some((enough, take)),
    };
    let done = p.run_pieces(&[three_masses(90.0)], way, plan, Part::default(), callers);
    done.map(|(record, _)| record)
}

fn whole(p: &WireModel<2, 4>, plan: &RecordPlan) -> Record {
    run(p, plan, usize::MAX, &mut |_| panic!("nothing to hand on")).expect("a run")
}

#[test]
fn pieces_one_after_the_other_are_the_whole() {
    let (p, plan) = (line(), everything());
    let whole = whole(&p, &plan);
    let mut pieces: Vec<Record> = Vec::new();
    let last = run(&p, &plan, 10_000, &mut |piece| {
        pieces.push(piece);
        true
    });
    let last = last.expect("a run");
    assert!(pieces.len() > 2, "{} pieces", pieces.len());
    assert!(pieces.iter().all(|piece| piece.time.len() % 256 == 0));
    assert_eq!(
        (&last.link_max, last.pivots),
        (&whole.link_max, whole.pivots)
    );
    let mut joined = vec![Vec::new(); bits(&whole).len()];
    let mut before = &pieces[0];
    for piece in pieces.iter().chain([&last]) {
        assert_eq!(piece.contacts, whole.contacts);
        // Extremes and counts are those so far: they only grow, and end as those of the whole.
        let grows = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| a <= b);
        assert!(grows(&before.link_max, &piece.link_max) && !piece.link_max.is_empty());
        assert!(before.steps <= piece.steps);
        before = piece;
        let all = joined.iter_mut().zip(bits(piece));
        all.for_each(|(all, new): (&mut Vec<u64>, _)| all.extend(new));
    }
    assert!(joined == bits(&whole));
}

#[test]
fn who_takes_a_piece_may_end_the_run() {
    let ended = run(&line(), &everything(), 10_000, &mut |_| false);
    assert!(matches!(ended, Err(CoreError::Cancelled { step }) if step > 0));
}

#[test]
fn rows_before_a_failure_are_handed_on() {
    let p = line();
    // A force beyond all numbers, from a step on after the first pieces.
    let from = 600;
    let mut way = way(STEPS, vec![0.0]);
    let sizes = (0..STEPS).map(|step| if step < from { 0.0 } else { f64::MAX });
    way.loads = vec![Load {
        pattern: vec![(3, 1, 1.0); 2],
        sizes: sizes.collect(),
    }];
    for ledger in [false, true] {
        let plan = RecordPlan {
            nodes: vec![1, 3, 5, 7, 9],
            motion: Some(motion(&p)),
            ledger,
            ..everything()
        };
        let mut pieces = Vec::new();
        let failed = run_along(&p, &way, &plan, 1, &mut |piece| {
            pieces.push(piece);
            true
        });
        let error = failed.expect_err("a force beyond all numbers");
        assert!(!matches!(error, CoreError::Input { .. }), "{error}");
        let all = |series: fn(&Record) -> &Vec<f64>| -> Vec<f64> {
            pieces.iter().flat_map(series).copied().collect()
        };
        // The row of the step in which the force begins, of balance between its ends, may be there.
        let (times, rows) = (all(|r| &r.time), from - 1);
        assert!((rows..=from).contains(&times.len()), "{} rows", times.len());
        assert_eq!(all(|r| &r.line_time), times);
        assert_eq!(all(|r| &r.motion_time).len(), times.len().div_ceil(10));
        for series in [all(|r| &r.force), all(|r| &r.masses), all(|r| &r.uplift)] {
            assert_eq!(series.len() % times.len(), 0);
            assert!(series.iter().all(|v| v.is_finite()));
        }
        for piece in &pieces {
            assert_eq!(piece.motion.len(), piece.motion_time.len() * (3 + 4));
            assert!(piece.motion.iter().all(|v| v.is_finite()));
            let energies = if ledger { piece.line_time.len() } else { 0 };
            assert_eq!(piece.energy.len(), energies);
        }
    }
}

#[test]
fn nothing_is_handed_on_after_an_end_from_outside() {
    let (p, way) = (line(), way(STEPS, vec![0.0]));
    let (mut taken, mut nobody) = (0, |_: usize, _: &Sample| Err("nobody controls it".into()));
    let callbacks = Callbacks {
        observe: &mut |step| step < 512,
        ask: &mut nobody,
        outside: &mut Nobody,
        take: Some((usize::MAX, &mut |_| {
            taken += 1;
            true
        })),
    };
    let part = Part::default();
    let ended = p.run_pieces(&[three_masses(90.0)], &way, &everything(), part, callbacks);
    assert!(matches!(ended, Err(CoreError::Cancelled { step: 512 })));
    assert_eq!(taken, 0);
}

/// Links along the track, of which four are recorded from 20 m behind on; and two nodes of five.
fn near(p: &WireModel<2, 4>) -> Near {
    let count = p.line.links.len();
    let place = |i: &usize| 6.0 * (count - i) as f64;
    let links: Vec<usize> = (0..count).rev().collect();
    Near {
        behind: 20.0,
        links: SortedStations {
            x: links.iter().map(place).collect(),
            of: links,
            count: 4,
        },
        nodes: SortedStations {
            of: vec![9, 5, 7, 3, 1],
            x: vec![0.0, 60.0, 90.0, 120.0, 150.0],
            count: 2,
        },
    }
}

#[test]
fn near_rows_are_cut_from_whole_ones() {
    let p = line();
    let nodes = vec![1, 3, 5, 7, 9];
    let all = RecordPlan {
        nodes: nodes.clone(),
        ..everything()
    };
    let some = RecordPlan {
        near: Some(near(&p)),
        ..all.clone()
    };
    let (whole, cut, near) = (whole(&p, &all), whole(&p, &some), near(&p));
    assert_eq!(bits(&whole)[1], bits(&cut)[1]);
    let count = p.line.links.len();
    let mut firsts = Vec::new();
    for (row, position) in cut.position.iter().enumerate() {
        let first = cut.link_first[row] as usize;
        assert!(first == count - 4 || near.links.x[first] >= position - 20.0);
        assert!(first == 0 || near.links.x[first - 1] < position - 20.0);
        for k in 0..4 {
            let of = near.links.of[first + k];
            assert_eq!(
                cut.link_force[row * 4 + k],
                whole.link_force[row * count + of]
            );
        }
        let first = cut.uplift_first[row] as usize;
        for k in 0..2 {
            let node = near.nodes.of[first + k];
            let at = nodes.iter().position(|n| *n == node).expect("watched");
            assert_eq!(cut.uplift[row * 2 + k], whole.uplift[row * 5 + at]);
        }
        firsts.push(first);
    }
    firsts.dedup();
    assert!(firsts.len() > 1, "it moves on");
    assert_eq!(cut.link_min, whole.link_min);
    assert_eq!(cut.uplift_max, whole.uplift_max);
}

/// Nodes of a wire, of which three are recorded from 20 m behind on, and links.
fn motion(p: &WireModel<2, 4>) -> MotionPlan {
    MotionPlan {
        every: 10,
        behind: 20.0,
        wires: vec![SortedStations {
            of: vec![1, 3, 5, 7, 9],
            x: vec![0.0, 60.0, 90.0, 120.0, 150.0],
            count: 3,
        }],
        links: near(p).links,
    }
}

#[test]
fn rows_of_motion_are_cut_from_whole_ones() {
    let p = line();
    let nodes = vec![1, 3, 5, 7, 9];
    let all = RecordPlan {
        nodes,
        line_every: 10,
        ..everything()
    };
    let moving = RecordPlan {
        motion: Some(motion(&p)),
        ..all.clone()
    };
    let (plain, seen) = (whole(&p, &all), whole(&p, &moving));
    assert_eq!(seen.motion_time, plain.line_time);
    assert_eq!(plain.force, seen.force);
    let (links, plan) = (p.line.links.len(), motion(&p));
    let mut firsts = Vec::new();
    for (row, values) in seen.motion.chunks(3 + 4).enumerate() {
        let first = seen.motion_first[2 * row] as usize;
        for (k, value) in values[..3].iter().enumerate() {
            assert_eq!(*value, plain.uplift[row * 5 + first + k] as f32);
        }
        firsts.push(first);
        let first = seen.motion_first[2 * row + 1] as usize;
        for (k, value) in values[3..].iter().enumerate() {
            let link = plan.links.of[first + k];
            assert_eq!(*value, plain.link_force[row * links + link] as f32);
        }
    }
    firsts.dedup();
    assert!(firsts.len() > 1, "it moves on");
    let mut pieces = Vec::new();
    let last = run(&p, &moving, 1000, &mut |piece| {
        pieces.push(piece.motion);
        true
    });
    pieces.push(last.expect("a run").motion);
    assert!(pieces.len() > 2);
    assert_eq!(pieces.concat(), seen.motion);
}

#[test]
fn motion_must_be_there_and_in_order() {
    let p = line();
    let bad: [fn(&mut MotionPlan); 5] = [
        |plan| plan.every = 0,
        |plan| plan.behind = f64::INFINITY,
        |plan| plan.wires[0].of[0] = usize::MAX,
        |plan| plan.wires[0].x[1] = 1e9,
        |plan| plan.links.count = usize::MAX,
    ];
    for spoil in bad {
        let mut motion = motion(&p);
        spoil(&mut motion);
        let plan = RecordPlan {
            motion: Some(motion),
            ..everything()
        };
        let told = run(&p, &plan, usize::MAX, &mut |_| true);
        assert!(matches!(told, Err(CoreError::Input { array: "plan", .. })));
    }
}

#[test]
fn what_is_near_must_be_there_and_in_order() {
    let p = line();
    let bad: [fn(&mut Near); 6] = [
        |near| near.behind = f64::NAN,
        |near| near.links.of[0] = usize::MAX,
        |near| near.links.x[1] = 1e9,
        |near| near.links.count = usize::MAX,
        |near| near.nodes.x[0] = f64::NEG_INFINITY,
        |near| near.nodes.of.truncate(4),
    ];
    for spoil in bad {
        let mut near = near(&p);
        spoil(&mut near);
        let plan = RecordPlan {
            near: Some(near),
            ..everything()
        };
        let told = run(&p, &plan, 1, &mut |_| true);
        assert!(matches!(told, Err(CoreError::Input { array: "plan", .. })));
    }
}
