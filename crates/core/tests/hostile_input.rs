//! Replay of the inputs that the fuzzer kept, `fuzz/corpus`, one line each: those that reach code
//! that no other input reaches. `make fuzz` looks for more; its findings are written out in
//! `border.rs`.

use crate::tests::hostile::border::{self, Reached};
use crate::tests::hostile::lcp;
use std::collections::BTreeSet;
use std::path::PathBuf;

fn inputs(target: &str) -> Vec<Vec<u8>> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus");
    let text = std::fs::read_to_string(folder.join(format!("{target}.txt"))).expect("the inputs");
    let byte = |digits| u8::from_str_radix(digits, 16).expect("two hexadecimal digits");
    text.lines()
        .map(|line| {
            (0..line.len())
                .step_by(2)
                .map(|k| byte(&line[k..k + 2]))
                .collect()
        })
        .collect()
}

#[test]
fn arrays_of_any_kind_are_refused_or_give_finite_numbers() {
    let seen: BTreeSet<_> = inputs("border")
        .iter()
        .map(|bytes| border::cross(bytes))
        .collect();
    // The corpus is worth something only where it comes far, in each kind of line.
    for dim in [2, 3] {
        for chain in [false, true] {
            for reached in [Reached::Nothing, Reached::Equilibrium, Reached::Run] {
                let outcome = border::Outcome {
                    dim,
                    chain,
                    reached,
                };
                assert!(seen.contains(&outcome), "no input comes to {outcome:?}");
            }
        }
    }
}

#[test]
fn problems_of_any_kind_are_refused_or_solved() {
    let seen: BTreeSet<_> = inputs("lcp")
        .iter()
        .map(|bytes| lcp::solve(bytes))
        .collect();
    assert_eq!(seen.len(), 3, "only {seen:?}");
}

#[test]
fn bytes_of_zero_are_a_sound_run() {
    for first in [[0, 0], [0, 1], [1, 0], [1, 1]] {
        assert_eq!(border::cross(&first).reached, Reached::Run);
    }
}
