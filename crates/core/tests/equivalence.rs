//! Equal results obtained in another way: rerun, thinned record, moved origin, mirrored line, third
//! dimension, dense matrices.

use crate::tests::common;

use arcless_core::constraint::columns::ComplianceColumns;
use arcless_core::integrator::wire_model::WireModel;
use arcless_core::linalg::{BlockLdl, SymmetricBlocks, dense};
use arcless_core::linear::model::LinearModel;
use arcless_core::scheme::Scheme;
use arcless_core::simulation::recording::record::{Record, RecordPlan};
use arcless_core::slideline::Slideline;
use arcless_core::statics::Geometry;
use arcless_core::structure::Structure;
use common::space::in_space;
use common::{Single, difference, everything, run, three_masses, travel};
use proptest::prelude::*;

const SPEED: f64 = 320.0 / 3.6;
const STEP: f64 = 1e-3;
const CONTACT: f64 = 50e3;
const SPANS: usize = 4;

fn scheme() -> Scheme {
    Scheme::generalised_alpha(0.9)
}

fn short_run(p: &WireModel<2, 4>, from: f64, plan: &RecordPlan) -> Record {
    run(
        p,
        &[three_masses(170.0)],
        &travel(from, from + 90.0, SPEED, STEP),
        plan,
    )
}

fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|v| v.to_bits()).collect()
}

#[test]
fn rerun_gives_the_same_bits() {
    let results = [0, 1].map(|_| {
        let p = common::prepared(SPANS, scheme(), STEP, CONTACT);
        short_run(&p, 65.0, &everything())
    });
    let [a, b] = &results;
    assert!(
        a.slack_max > 0,
        "droppers go slack, so that the solver has work"
    );
    assert_eq!(bits(&a.force), bits(&b.force));
    assert_eq!(bits(&a.link_force), bits(&b.link_force));
    assert_eq!(bits(&a.masses), bits(&b.masses));
    let p = common::prepared(SPANS, scheme(), STEP, 1.01 * CONTACT);
    assert_ne!(
        bits(&a.force),
        bits(&short_run(&p, 65.0, &everything()).force)
    );
}

/// A thinned record without the ledger holds the values of a full one: recording changes nothing.
#[test]
fn thinned_record_holds_the_same_values() {
    let p = common::prepared(SPANS, scheme(), STEP, CONTACT);
    let full = short_run(&p, 65.0, &everything());
    let plan = RecordPlan {
        contact_every: 10,
        line_every: 7,
        ledger: false,
        ledger_every: 1,
        ..everything()
    };
    let thin = short_run(&p, 65.0, &plan);
    let every = |values: &[f64], width: usize, n: usize| -> Vec<f64> {
        values.chunks(width).step_by(n).flatten().copied().collect()
    };
    assert_eq!(bits(&thin.time), bits(&every(&full.time, 1, 10)));
    assert_eq!(bits(&thin.force), bits(&every(&full.force, 1, 10)));
    assert_eq!(bits(&thin.masses), bits(&every(&full.masses, 3, 10)));
    let links = p.line.links.len();
    assert_eq!(
        bits(&thin.link_force),
        bits(&every(&full.link_force, links, 7))
    );
    assert_eq!(
        bits(&thin.link_max),
        bits(&full.link_max),
        "extremes come from every step"
    );
}

/// Difference of the force of the first of two pantographs on 16 spans from its force alone. With
/// `anchored` both wires are held along the track at a support between the two.
fn first_of_two(distance: f64, anchored: bool) -> f64 {
    let (mut s, path) = common::simple_line(16);
    if anchored {
        let anchor = 6.0 * common::SPAN;
        let nodes = 0..s.positions.len();
        let held = nodes.filter(|&i| (s.positions[i][0] - anchor).abs() < 1e-6);
        s.fixed.extend(held.map(|i| (i, 0)).collect::<Vec<_>>());
    }
    let p = common::prepare((s, path), |_| (), scheme(), STEP, CONTACT);
    let mut way = travel(700.0, 790.0, SPEED, STEP);
    let alone = run(&p, &[three_masses(170.0)], &way, &everything());
    way.distances.push(distance);
    let pair = run(&p, &[170.0, 170.0].map(three_masses), &way, &everything());
    let first: Vec<f64> = pair.force.iter().step_by(2).copied().collect();
    difference(&first, &alone.force)
}

/// Transverse waves need longer than the run, 600 m at 128 m/s, and the static uplift decays from
/// span to span. Along the track the wires are stiff and run freely through the supports: the
/// second pantograph changes their tension everywhere, unless something anchors them between the
/// two.
#[test]
fn pantograph_far_from_the_other_is_alone() {
    // With an anchor between them only what decays from span to span is left; without one the
    // tension changes everywhere, by some per cent of the force.
    let (anchored, free, near) = (
        first_of_two(600.0, true),
        first_of_two(600.0, false),
        first_of_two(50.0, true),
    );
    assert!(anchored < 1e-4, "{anchored:e}");
    assert!(free < 0.03, "{free:e}");
    assert!(near > 1e-2, "the partner: near pantographs feel each other");
}

fn shifted(mut s: Structure, by: f64) -> Structure {
    s.positions.iter_mut().for_each(|p| p[0] += by);
    s
}

#[test]
fn origin_does_not_matter() {
    let (s, path) = common::simple_line(SPANS);
    let far = 1024.0;
    let at = |by: f64| {
        let line = (shifted(s.clone(), by), path.clone());
        let p = common::prepare(line, |_| (), scheme(), STEP, CONTACT);
        short_run(&p, 65.0 + by, &everything())
    };
    let (here, there) = (at(0.0), at(far));
    // Coordinates of 1e3 m round at 1e-13 m; over an element, times EA, that is 1e-6 N.
    assert!(difference(&there.force, &here.force) < 1e-6);
    assert!(difference(&there.link_force, &here.link_force) < 1e-6);
    let p = common::prepare((s, path), |_| (), scheme(), STEP, CONTACT);
    let wrong = short_run(&p, 65.01, &everything());
    assert!(
        difference(&wrong.force, &here.force) > 1e-5,
        "the partner: one centimetre on"
    );
}

/// Mirrored along the track: a train that runs backwards through the mirrored line.
fn mirrored(s: &Structure, path: &[usize]) -> (Structure, Vec<usize>) {
    let n = s.positions.len();
    let turn = |i: usize| n - 1 - i;
    let mut m = s.clone();
    for i in 0..n {
        m.positions[turn(i)] = s.positions[i];
        m.positions[turn(i)][0] *= -1.0;
        m.slopes[turn(i)] = s.slopes[i].map(|c| -c);
        m.slopes[turn(i)][0] *= -1.0;
    }
    for w in &mut m.wires {
        w.nodes = [turn(w.nodes[1]), turn(w.nodes[0])];
        w.slope_nodes = [turn(w.slope_nodes[1]), turn(w.slope_nodes[0])];
    }
    m.links.iter_mut().for_each(|l| l.nodes = l.nodes.map(turn));
    m.springs.iter_mut().for_each(|p| p.node = turn(p.node));
    m.masses.iter_mut().for_each(|p| p.node = turn(p.node));
    m.fixed.iter_mut().for_each(|p| p.0 = turn(p.0));
    for e in &mut m.ends {
        e.node = turn(e.node);
        e.force *= -1.0;
    }
    (m, path.iter().rev().copied().collect())
}

#[test]
fn mirrored_line_answers_a_train_that_runs_back() {
    let (mut s, path) = common::simple_line(SPANS);
    // Something for which the two directions differ.
    s.links[14].mass = 1.5;
    let mirror = mirrored(&s, &path);
    let forward = common::prepare((s, path), |_| (), scheme(), STEP, CONTACT);
    let back = common::prepare(mirror, |_| (), scheme(), STEP, CONTACT);
    let a = short_run(&forward, 65.0, &everything());
    let mut way = travel(65.0, 155.0, SPEED, STEP);
    way.positions.iter_mut().for_each(|x| *x *= -1.0);
    let b = run(&back, &[three_masses(170.0)], &way, &everything());
    // The order of elimination differs: rounding of 1e-5 N in the statics of 170 N.
    assert!(difference(&b.force, &a.force) < 1e-6);
    let wrong = run(
        &back,
        &[three_masses(170.0)],
        &travel(-155.0, -65.0, SPEED, STEP),
        &everything(),
    );
    // The partner: a hundredth of the force, where mirrored runs agree to rounding.
    assert!(
        difference(&wrong.force, &a.force) > 1e-2,
        "the partner: not mirrored"
    );
}

#[test]
fn planar_line_is_the_spatial_one_without_stagger() {
    let (s, path) = common::simple_line(SPANS);
    let mut g = Geometry::<3, 6>::new(in_space(&s)).expect("a valid structure");
    let shape = g
        .design()
        .and_then(|shape| g.find_equilibrium(&shape))
        .expect("an equilibrium");
    let places = Slideline::from_elements(&g, &shape, std::slice::from_ref(&path)).expect("a path");
    let spatial = WireModel::new(LinearModel::new(&g, shape), places, scheme(), STEP, CONTACT)
        .expect("regular");
    let planar = common::prepare((s, path), |_| (), scheme(), STEP, CONTACT);
    let flat = short_run(&planar, 65.0, &everything());
    let way = travel(65.0, 155.0, SPEED, STEP);
    let deep = run(&spatial, &[three_masses(170.0)], &way, &everything());
    assert!(common::peak(&deep.lateral) == 0.0);
    // Blocks of another size round differently: as in the mirrored line.
    assert!(difference(&deep.force, &flat.force) < 1e-6);
    assert!(difference(&deep.link_force, &flat.link_force) < 1e-6);
}

/// A symmetric, diagonally dominant matrix on a random pattern, and the same one dense.
fn random_matrix(n: usize, seed: u64) -> (SymmetricBlocks<4>, Vec<f64>) {
    let mut state = seed | 1;
    let mut random = move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    };
    let pairs: Vec<(usize, usize)> = (0..2 * n)
        .map(|_| {
            let pick = |r: f64| (((r + 0.5) * n as f64) as usize).min(n - 1);
            (pick(random()), pick(random()))
        })
        .collect();
    let mut a = SymmetricBlocks::with_pattern(n, pairs);
    let size = 4 * n;
    let mut full = vec![0.0; size * size];
    for i in 0..n {
        for k in a.row_start[i]..a.row_start[i + 1] {
            let j = a.columns[k];
            for p in 0..4 {
                for q in 0..if i == j { p + 1 } else { 4 } {
                    let (row, column) = (4 * i + p, 4 * j + q);
                    let value = random() + if row == column { 8.0 * n as f64 } else { 0.0 };
                    a.blocks[k][p][q] = value;
                    if i == j {
                        a.blocks[k][q][p] = value;
                    }
                    full[row * size + column] = value;
                    full[column * size + row] = value;
                }
            }
        }
    }
    (a, full)
}

proptest! {
    // The diagonal dominates: condition below 3, so the difference is rounding of sums of 4n terms.
    #[test]
    fn block_factor_solves_like_gauss(n in 1_usize..=14, seed in 1_u64..1 << 40) {
        let (a, mut full) = random_matrix(n, seed);
        let b: Vec<[f64; 4]> = (0..n).map(|i| [1.0, -2.0, i as f64, 0.5]).collect();
        let mut expected: Vec<f64> = b.iter().flatten().copied().collect();
        prop_assert!(dense::solve_in_place(&mut full, &mut expected));
        let mut x = b;
        let factor = BlockLdl::new(&a).expect("regular");
        factor.solve(&mut x, &mut vec![[0.0; 4]; n]);
        prop_assert_eq!(factor.negative_pivots(), 0);
        // Rounding of a well-conditioned matrix: it is strongly diagonal.
        let found: Vec<f64> = x.into_iter().flatten().collect();
        prop_assert!(difference(&found, &expected) < 1e-13);
    }
}

/// Windows leave out what is below 1e-17 of the peak: nothing that a sum with the peak could show.
#[test]
fn column_windows_are_the_full_solve() {
    let s = Single {
        length: 220.0,
        elements: 150,
        mass: 1.35,
        axial: 15e6,
        bending: 195.0,
        tension: 22e3,
        gravity: 0.0,
    };
    let p = common::prepare(s.structure(2), |_| (), scheme(), STEP, CONTACT);
    let c = &p.coefficients;
    let factor = BlockLdl::new(&p.line.combine(c.mass, c.damping, c.stiffness)).expect("regular");
    let (mut columns, number) = (ComplianceColumns::new(3), 1);
    let mut unit = vec![[0.0; 4]; p.line.nodes()];
    unit[75][1] = 1.0;
    let load = [(75, unit[75])];
    let [mut x, mut work] = [0, 1].map(|_| vec![[0.0; 4]; p.line.nodes()]);
    columns.set(number, &factor, &load, [&mut x, &mut work]);
    assert!(x.iter().chain(&work).flatten().all(|&v| v == 0.0));
    factor.solve(&mut unit, &mut vec![[0.0; 4]; p.line.nodes()]);
    let mut added = vec![[0.0; 4]; p.line.nodes()];
    columns.add(number, 2.0, &mut added);
    let peak = unit.iter().flatten().fold(0.0_f64, |m, v| m.max(v.abs()));
    for (i, exact) in unit.iter().enumerate() {
        for k in 0..4 {
            assert!((columns.at(number, i)[k] - exact[k]).abs() <= 1e-17 * peak);
            assert!((added[i][k] - 2.0 * exact[k]).abs() <= 2e-17 * peak);
        }
    }
    assert!(
        columns.stored() < 4 * p.line.nodes(),
        "the partner: something is left out"
    );
}
