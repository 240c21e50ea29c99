//! At rest under a pantograph, and the sag that it takes away, as the implicit line has them.

use super::{Chain, WIRE, explicit, fitted, pass, plan, seen_wire, way};
use crate::tests::common::chain::lumped;
use crate::tests::common::space::{in_space, staggered};
use crate::tests::common::{Single, difference, peak, simple_line_of};

const STEP: f64 = 1e-3;
const FORCE: f64 = 90.0;

fn planar() -> Chain {
    let (structure, path) = WIRE.structure(2);
    (lumped(&structure), vec![path])
}

fn spatial() -> Chain {
    let (structure, path) = WIRE.structure(2);
    (lumped(&in_space(&structure)), vec![path])
}

/// A line of two wires, links and arms, which hold it to the side.
fn whole() -> Chain {
    let (structure, path) = simple_line_of(3, [0.48, 0.48]);
    (lumped(&staggered(&structure, 3, 0.2)), vec![path])
}

/// Relative tolerances: `force` of the drift of force and uplifts at rest, `line` of the difference
/// between the values of explicit and implicit steps.
struct Close {
    force: f64,
    line: f64,
}

/// Check that nothing moves, and that uplifts, heights and link forces agree with implicit steps of
/// the same bends and curves.
fn stands<const DIM: usize, const D: usize>(chain: &Chain, h: f64, at: f64, close: &Close) {
    let every = if chain.0.segments.len() > 50 { 7 } else { 2 };
    let [ours, theirs] = [explicit::<DIM, D>(chain, h), fitted::<DIM, D>(chain, h)].map(|p| {
        let nodes = (0..p.line.nodes()).step_by(every).collect();
        pass(&p, FORCE, &way(at, 0.0, h, 600.0 * h), &plan(nodes))
    });
    // Rounding of forces of 15 MN, 1e-16 of them, on one of 90 N, in 600 steps: 1e-9 and less.
    for (record, most) in [(&ours, close.force), (&theirs, 1e-9)] {
        let moved: Vec<f64> = record.force.iter().map(|f| f / FORCE - 1.0).collect();
        assert!(peak(&moved) < most, "{:e}", peak(&moved));
        let all = record.uplift.len() / record.line_time.len();
        let last = &record.uplift[record.uplift.len() - all..];
        let apart = difference(last, &record.uplift[..all]);
        assert!(apart < most, "it moves: {apart:e}");
        assert!(peak(last) > 1e-2, "it is lifted");
    }
    let apart = [
        difference(&ours.uplift, &theirs.uplift),
        difference(&ours.height, &theirs.height),
        difference(&ours.link_force, &theirs.link_force),
    ];
    assert!(apart.iter().all(|d| *d < close.line), "{apart:?}");
}

/// Estimate of the terms that explicit steps neglect in the plane: bending along the wire,
/// EI/L² = 780 N compared with EA = 15 MN, 5e-5, times the square of slopes of 0.04 at most: 8e-8.
#[test]
fn a_pantograph_stands_on_a_sagging_wire() {
    // The force shows the difference of 46 mm of lift through 50 kN/m on 90 N: 26 times as large.
    let close = Close {
        force: 2.6e-6,
        line: 1e-7,
    };
    stands::<2, 2>(&planar(), STEP, 20.3, &close);
    stands::<3, 3>(&spatial(), STEP, 20.3, &close);
}

/// Across and up are coupled by the product of their slopes, 0.007 and 0.04 at most, neglected in
/// the forces that turn a segment: 3e-4 of T where both are largest. A tenth is allowed on the
/// line.
#[test]
fn a_pantograph_stands_on_a_line_in_space() {
    let close = Close {
        force: 3e-4,
        line: 3e-5,
    };
    stands::<3, 3>(&whole(), STEP, 70.3, &close);
}

/// Reach through several strands: in steps of 20 ms tension acts along all of a wire, and with few
/// points a strand has two to five. Ten times the estimate above, for segments up to ten times as
/// long, which turn by more; without H in one of the strands the error would be a percent.
#[test]
fn a_pantograph_stands_on_a_wire_of_few_points() {
    let close = Close {
        force: 2.6e-5,
        line: 1e-6,
    };
    for elements in 5..18 {
        let wire = Single { elements, ..WIRE };
        let chain = seen_wire(&wire, 2);
        stands::<2, 2>(&chain, 2e-2, 20.3, &close);
        stands::<2, 2>(&chain, STEP, 20.3, &close);
    }
}
