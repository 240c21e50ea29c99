//! What is read and written in rows, against the same one by one: not a bit may differ.

use crate::common::chain::{explicit, lumped};
use crate::common::space::staggered;
use crate::common::{everything, run, simple_line_of, steady, three_masses};
use crate::integrator::Integrator;
use crate::integrator::explicit::Explicit;
use crate::integrator::explicit::simd::rows::LANES;
use crate::integrator::prepared::WireModel;
use crate::simulation::recording::record::{Record, RecordPlan};
use crate::structure::Structure;

const STEP: f64 = 1e-3;
const SPANS: usize = 8;

impl<const DIM: usize> Explicit<DIM> {
    /// The same steps without rows of links and reaches, and damping point by point.
    fn one_by_one(mut self) -> Self {
        for own in &mut self.own {
            let mut pairs = std::mem::take(&mut own.groups.rows);
            pairs.append(&mut own.groups.pairs);
            own.groups.pairs = pairs;
            own.blocks
                .iter_mut()
                .for_each(|block| block.is_even = false);
        }
        self.reaches.iter_mut().for_each(|r| r.is_row = false);
        self
    }
}

/// A regular line of chains, with elements of half a metre on the lower wire.
fn line<const DIM: usize>(structure: &Structure, path: &[usize]) -> WireModel<DIM, DIM> {
    explicit(&(lumped(structure), vec![path.to_vec()]), STEP, 50e3).expect("short steps")
}

fn pass<const DIM: usize>(p: &WireModel<DIM, DIM>) -> Record {
    let plan = RecordPlan {
        ledger: false,
        ..everything()
    };
    let travel = steady(70.0, 60.0, STEP, 3000);
    run(p, &[three_masses(250.0)], &travel, &plan)
}

fn compare<const DIM: usize>(p: WireModel<DIM, DIM>) {
    let Integrator::Explicit(steps) = p.integrator.clone() else {
        panic!("explicit steps");
    };
    // Two wires, nine links in each of eight spans, reaches of some 6 m: most of both must lie in rows.
    let links = LANES * steps.own[0].groups.rows.len();
    assert!(links > 8 * SPANS, "{links} of {} links", 9 * SPANS);
    let reaches = LANES * steps.reaches.iter().filter(|r| r.is_row).count();
    let all = steps.reaches.len();
    assert!(reaches > all / 2, "{reaches} of {all} reaches");
    assert!(steps.own[0].blocks.iter().all(|block| block.is_even));

    let in_rows = pass(&p);
    let mut plain = p;
    plain.integrator = Integrator::Explicit(Box::new(steps.one_by_one()));
    let plain = pass(&plain);
    assert!(in_rows.slack_max > 0, "no link was slack");
    let lists = |r: Record| [r.force, r.masses, r.link_force];
    for (a, b) in lists(in_rows).into_iter().zip(lists(plain)) {
        assert!(!a.is_empty());
        assert!(a.iter().zip(&b).all(|(a, b)| a.to_bits() == b.to_bits()));
    }
}

#[test]
fn rows_are_the_same_as_one_by_one() {
    let (structure, path) = simple_line_of(SPANS, [0.5, 0.8]);
    compare::<2>(line(&structure, &path));
}

#[test]
fn so_they_are_in_space() {
    let (structure, path) = simple_line_of(SPANS, [0.5, 0.8]);
    compare::<3>(line(&staggered(&structure, SPANS, 0.2), &path));
}
