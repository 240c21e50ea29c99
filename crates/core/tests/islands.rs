//! Two tension lengths, of which only those that are touched are stepped.

use crate::tests::common::{everything, simple_line, three_masses};
use crate::tests::resume::{bits, compare, part, sums};

use arcless_core::checkpoint::Checkpoint;
use arcless_core::integrator::wire_model::WireModel;
use arcless_core::linalg::SymmetricBlocks;
use arcless_core::linalg::islands::islands;
use arcless_core::linear::loads::Load;
use arcless_core::linear::model::LinearModel;
use arcless_core::scheme::Scheme;
use arcless_core::simulation::inputs::Trajectory;
use arcless_core::simulation::recording::record::RecordPlan;
use arcless_core::simulation::recording::window::{Near, SortedStations};
use arcless_core::simulation::run::Part;
use arcless_core::slideline::Slideline;
use arcless_core::statics::Geometry;
use arcless_core::structure::Structure;

/// Where the second one begins, m: a span of the three of each is an overlap.
pub const SHIFT: f64 = 110.0;

#[test]
fn islands_are_what_no_block_couples() {
    let of = |n: usize, pairs: &[(usize, usize)]| {
        islands(&SymmetricBlocks::<2>::with_pattern(
            n,
            pairs.iter().copied(),
        ))
    };
    assert_eq!(of(3, &[]), [0..1, 1..2, 2..3]);
    assert_eq!(of(5, &[(1, 0), (4, 3), (3, 2)]), [0..2, 2..5]);
    // Numbers among one another, or between those of a pair: one island.
    assert_eq!(of(5, &[(3, 0), (2, 1)]), [0..4, 4..5]);
    assert_eq!(of(5, &[(3, 0)]), [0..4, 4..5]);
}

/// A second line of the same kind, behind the first.
pub fn put_behind(s: &mut Structure, other: &Structure, shift: f64) {
    let (nodes, wires) = (s.positions.len(), s.wires.len());
    let moved = other.positions.iter().map(|p| [p[0] + shift, p[1], p[2]]);
    s.positions.extend(moved);
    s.slopes.extend(&other.slopes);
    assert_eq!(wires, other.wires.len(), "of the same kind");
    let mut second = other.clone();
    for wire in &mut second.wires {
        wire.nodes = wire.nodes.map(|n| n + nodes);
        wire.slope_nodes = wire.slope_nodes.map(|n| n + nodes);
    }
    second
        .links
        .iter_mut()
        .for_each(|l| l.nodes = l.nodes.map(|n| n + nodes));
    second.springs.iter_mut().for_each(|k| k.node += nodes);
    second.masses.iter_mut().for_each(|m| m.node += nodes);
    second.fixed.iter_mut().for_each(|f| f.0 += nodes);
    second.ends.iter_mut().for_each(|e| e.node += nodes);
    s.wires.append(&mut second.wires);
    s.links.append(&mut second.links);
    s.springs.append(&mut second.springs);
    s.masses.append(&mut second.masses);
    s.fixed.append(&mut second.fixed);
    s.ends.append(&mut second.ends);
}

/// With or without residual flexibility.
fn two_lengths(yields: bool) -> WireModel<2, 4> {
    let (mut structure, path) = simple_line(3);
    let other = structure.clone();
    let behind = path.iter().map(|k| k + other.wires.len()).collect();
    put_behind(&mut structure, &other, SHIFT);
    let mut geometry = Geometry::<2, 4>::new(structure).expect("a valid structure");
    if yields {
        geometry.add_residual_flexibility();
    }
    let start = geometry.design().expect("the design converges");
    let shape = geometry
        .find_equilibrium(&start)
        .expect("the equilibrium converges");
    let wires = [path, behind];
    let mut lanes = Slideline::from_elements(&geometry, &shape, &wires).expect("two lanes");
    if yields {
        lanes = Slideline::with_residual_flexibility(lanes, &geometry, &shape, &wires);
    }
    let line = LinearModel::new(&geometry, shape);
    WireModel::new(line, lanes, Scheme::hht(0.1), 1e-3, 5e4).expect("regular")
}

/// Through the overlap, from one to the other.
pub fn way(instants: usize) -> Trajectory {
    Trajectory {
        positions: (0..instants).map(|i| 70.0 + 0.075 * i as f64).collect(),
        speeds: vec![75.0; instants],
        distances: vec![0.0],
        friction: 0.2,
        loads: Vec::new(),
    }
}

/// A force that is given, and zero: it keeps everything awake and changes nothing.
fn nothing(instants: usize) -> Load {
    Load {
        pattern: vec![(0, 1, 1.0)],
        sizes: vec![0.0; instants],
    }
}

fn plan<const DIM: usize, const D: usize>(p: &WireModel<DIM, D>) -> RecordPlan {
    RecordPlan {
        nodes: vec![3, 11, p.line.nodes() - 5],
        ledger: false,
        ledger_every: 1,
        ..everything()
    }
}

fn run<const DIM: usize, const D: usize>(
    p: &WireModel<DIM, D>,
    travel: &Trajectory,
    plan: &RecordPlan,
) -> (Vec<Vec<u64>>, Vec<Vec<u64>>, Checkpoint) {
    let pantographs = [three_masses(90.0)];
    let (record, state) = part(p, &pantographs, (travel, plan), Part::default()).expect("a run");
    (bits(&record), sums(&record), state)
}

#[test]
fn what_sleeps_would_not_have_moved() {
    for yields in [false, true] {
        sleeps_as_if_awake(&two_lengths(yields));
    }
}

pub fn sleeps_as_if_awake<const DIM: usize, const D: usize>(p: &WireModel<DIM, D>) {
    let (plan, sleeping) = (plan(p), way(1400));
    let awake = Trajectory {
        loads: vec![nothing(1400)],
        ..sleeping.clone()
    };
    let (series, extremes, _) = run(p, &sleeping, &plan);
    let (all, all_extremes, _) = run(p, &awake, &plan);
    assert!(series == all && extremes == all_extremes);
}

#[test]
fn an_untouched_length_is_at_rest_exactly() {
    untouched_is_at_rest(&two_lengths(false));
}

pub fn untouched_is_at_rest<const DIM: usize, const D: usize>(p: &WireModel<DIM, D>) {
    // Ends before the second one begins.
    let (_, _, state) = run(p, &way(500), &plan(p));
    let u = &state.numbers["line_displacement"];
    let (touched, untouched) = u.split_at(u.len() / 2);
    assert!(touched.iter().any(|v| *v != 0.0));
    assert!(untouched.iter().all(|v| *v == 0.0));
}

/// Only a few links and nodes behind the pantograph.
pub fn near<const DIM: usize, const D: usize>(p: &WireModel<DIM, D>) -> Near {
    let links = &p.line.links;
    let x = |i: usize| p.line.shape[links[i].nodes[0]][0];
    let mut order: Vec<usize> = (0..links.len()).collect();
    order.sort_by(|&a, &b| x(a).total_cmp(&x(b)));
    let nodes = vec![3, 11, p.line.nodes() - 5];
    Near {
        behind: 15.0,
        links: SortedStations {
            x: order.iter().map(|&i| x(i)).collect(),
            of: order,
            count: 4,
        },
        nodes: SortedStations {
            x: nodes.iter().map(|&n| p.line.shape[n][0]).collect(),
            of: nodes,
            count: 1,
        },
    }
}

#[test]
fn a_length_left_behind_is_laid_to_rest() {
    for yields in [false, true] {
        is_laid_to_rest(&two_lengths(yields));
    }
}

pub fn is_laid_to_rest<const DIM: usize, const D: usize>(p: &WireModel<DIM, D>) {
    let whole = plan(p);
    let some = RecordPlan {
        near: Some(near(p)),
        ..whole.clone()
    };
    // The first one ends at 165 m.
    let travel = way(2300);
    let pantographs = [three_masses(90.0)];
    let go = |plan| part(p, &pantographs, (&travel, plan), Part::default()).expect("a run");
    let ((all, _), (cut, state)) = (go(&whole), go(&some));
    assert_eq!(bits(&all)[..9], bits(&cut)[..9], "contacts and pantographs");
    // Extremes are those of the time in which it was awake.
    let pairs = all.link_min.iter().zip(&cut.link_min);
    assert!(pairs.clone().all(|(all, cut)| all <= cut));
    assert!(pairs.clone().any(|(all, cut)| all < cut));
    let u = &state.numbers["line_displacement"];
    let (left, present) = u.split_at(u.len() / 2);
    assert!(left.iter().all(|v| *v == 0.0));
    assert!(present.iter().any(|v| *v != 0.0));
}

#[test]
fn parts_of_such_a_run_are_the_whole() {
    for yields in [false, true] {
        parts_are_the_whole(&two_lengths(yields));
    }
}

pub fn parts_are_the_whole<const DIM: usize, const D: usize>(p: &WireModel<DIM, D>) {
    let some = RecordPlan {
        near: Some(near(p)),
        ..plan(p)
    };
    let pantographs = [three_masses(90.0)];
    for plan in [&plan(p), &some] {
        // Before, in and behind the overlap, and where the first one sleeps again.
        compare(p, &pantographs, (&way(2300), plan), &[300, 800, 1290, 2100]);
    }
}
