//! Lanes: wires one behind the other.

use crate::tests::common;

use arcless_core::slideline::Slideline;
use arcless_core::statics::Geometry;
use common::lanes::STRING;

/// Lanes over the elements of a wire, 1 m each.
fn lanes(lists: &[Vec<usize>]) -> Result<Vec<Slideline<2>>, String> {
    let (structure, _) = STRING.structure(2);
    let geometry = Geometry::<2, 4>::new(structure).expect("a valid structure");
    let shape = geometry
        .find_equilibrium(&geometry.initial_shape())
        .expect("at rest");
    Slideline::from_elements(&geometry, &shape, lists).map_err(|e| e.to_string())
}

#[test]
fn a_place_in_a_gap_is_on_no_wire() {
    let split = [(0..20).chain(30..60).collect(), (20..30).collect()];
    let (whole, split) = (lanes(&[(0..60).collect()]), lanes(&split));
    let (whole, split) = (whole.expect("a lane"), split.expect("lanes"));
    for near in [0, 19, 20, 49] {
        for x in [-1.0, 20.001, 25.0, 29.999, 60.001, f64::NAN] {
            assert!(split[0].locate(x, near).is_none(), "{x} from {near}");
        }
        assert!(
            [0.0, 20.0, 30.0, 60.0]
                .iter()
                .all(|&x| split[0].locate(x, near).is_some())
        );
        for x in [3.3, 19.999, 30.001, 45.7] {
            let (place, same) = (split[0].locate(x, near), whole[0].locate(x, near));
            let (place, same) = (place.expect("on the wire"), same.expect("on the wire"));
            assert_eq!((place.nodes, place.weights), (same.nodes, same.weights));
        }
    }
    // Influence columns: 21 nodes, 31 nodes, then the 11 nodes of the second lane.
    let number = |lane: usize, x: f64| split[lane].locate(x, 0).expect("on the wire").number;
    assert_eq!(
        [number(0, 19.5), number(0, 30.5), number(0, 59.5)],
        [19, 21, 50]
    );
    assert_eq!([number(1, 20.5), number(1, 29.5)], [52, 61]);
}

#[test]
fn wires_of_a_lane_lie_one_behind_the_other() {
    let said = |lists: &[Vec<usize>]| lanes(lists).expect_err("refused");
    assert!(said(&[(0..20).chain(15..60).collect()]).contains("two places"));
    assert!(said(&[(30..60).chain(0..20).collect()]).contains("overlap"));
    assert!(said(&[(0..20).collect(), (19..60).collect()]).contains("two places"));
    assert!(said(&[]).contains("none"));
    assert!(said(&[vec![]]).contains("no elements"));
}
