//! Two tension lengths of chains: what sleeps, and parts of a run, as with implicit steps.

use super::{Chain, explicit};
use crate::tests::common::chain::lumped;
use crate::tests::common::simple_line_of;
use crate::tests::islands::{
    SHIFT, is_laid_to_rest, parts_are_the_whole, put_behind, sleeps_as_if_awake,
    untouched_is_at_rest,
};
use arcless_core::integrator::wire_model::WireModel;

fn chains() -> Chain {
    let (mut structure, path) = simple_line_of(3, [0.9, 0.9]);
    let other = structure.clone();
    let behind = path.iter().map(|k| k + other.wires.len()).collect();
    put_behind(&mut structure, &other, SHIFT);
    (lumped(&structure), vec![path, behind])
}

pub fn two_lengths() -> WireModel<2, 2> {
    explicit(&chains(), 1e-3)
}

#[test]
fn what_sleeps_would_not_have_moved() {
    sleeps_as_if_awake(&two_lengths());
}

#[test]
fn an_untouched_length_is_at_rest_exactly() {
    untouched_is_at_rest(&two_lengths());
}

#[test]
fn a_length_left_behind_is_laid_to_rest() {
    is_laid_to_rest(&two_lengths());
}

#[test]
fn parts_of_a_run_are_the_whole() {
    parts_are_the_whole(&two_lengths());
}
