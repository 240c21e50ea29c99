//! Packed reads and writes against the same steps one by one: not a bit may differ.

use crate::integrator::explicit::Explicit;
use crate::integrator::explicit::simd::packed::SIMD_LANES;
use crate::integrator::wire_model::Integrator;
use crate::integrator::wire_model::WireModel;
use crate::simulation::recording::record::{Record, RecordPlan};
use crate::structure::Structure;
use crate::tests::common::chain::{explicit, lumped};
use crate::tests::common::space::staggered;
use crate::tests::common::{everything, run, simple_line_of, steady, three_masses};

const STEP: f64 = 1e-3;
const SPANS: usize = 8;

impl<const DIM: usize> Explicit<DIM> {
    /// Returns the steps without packed links and axial elements, and with damping point by point.
    fn without_packing(mut self) -> Self {
        for island in &mut self.islands {
            let mut pairs = std::mem::take(&mut island.batches.packed_pairs);
            pairs.append(&mut island.batches.pairs);
            island.batches.pairs = pairs;
            island
                .blocks
                .iter_mut()
                .for_each(|block| block.is_uniform = false);
        }
        self.axial_elements
            .iter_mut()
            .for_each(|r| r.is_packed = false);
        self
    }
}

/// Returns a regular line of chains, with elements of 0.5 m on the lower wire.
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
    // Two wires, nine links in each of eight spans, axial elements of some 6 m: most of both must
    // be packed.
    let links = SIMD_LANES * steps.islands[0].batches.packed_pairs.len();
    assert!(links > 8 * SPANS, "{links} of {} links", 9 * SPANS);
    let axial_elements = SIMD_LANES * steps.axial_elements.iter().filter(|r| r.is_packed).count();
    let all = steps.axial_elements.len();
    assert!(
        axial_elements > all / 2,
        "{axial_elements} of {all} axial elements"
    );
    assert!(steps.islands[0].blocks.iter().all(|block| block.is_uniform));

    let in_rows = pass(&p);
    let mut plain = p;
    plain.integrator = Integrator::Explicit(Box::new(steps.without_packing()));
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
