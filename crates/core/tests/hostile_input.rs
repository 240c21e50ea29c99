//! Replay of the inputs that the fuzzer kept, `fuzz/corpus`, one file each: those that reach what no
//! other one reaches. `make fuzz` looks for more; what it found is written down in `border.rs`.

use crate::hostile::border::{self, Reached};
use crate::hostile::lcp;
use std::collections::BTreeSet;
use std::path::PathBuf;

fn inputs(target: &str) -> Vec<Vec<u8>> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("fuzz/corpus/{target}"));
    let entries = std::fs::read_dir(&folder).expect("the folder of inputs");
    let mut paths: Vec<PathBuf> = entries.map(|e| e.expect("a file").path()).collect();
    paths.sort();
    let read = |path| std::fs::read(path).expect("a readable file");
    paths.into_iter().map(read).collect()
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
