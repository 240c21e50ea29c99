//! The longest step, by the closed form of a uniform string.
//!
//! A wave with q = 4 sin²(kℓ/2) has ω² h² = C² q f(q), C = c h/ℓ (see `waves`), with
//!
//!   f(q) = 1 + (1 − C²) q/12 + (1 − C²)(4 − C²) q²/360
//!
//! It grows with q, which is below 4: ω h < 2 C √f(4), which is 2 for C = 1. With a damping β of
//! stiffness, of the velocity of the step before, and α of mass, the shortest wave that changes its
//! sign in every step has (4 C² (1 + 2β/h) + 2 α h) f(4) = 4.

use super::{Chain, prepare, seen_wire};
use crate::tests::common::Single;
use arcless_core::CoreError;
use arcless_core::slideline::point::Nodal;
use arcless_core::structure::Rayleigh;

const STRING: Single = Single {
    length: 40.0,
    elements: 80,
    mass: 1.35,
    axial: 15e6,
    bending: 0.0,
    tension: 22e3,
    gravity: 0.0,
};

/// C of a step.
fn courant(h: f64) -> f64 {
    let s = &STRING;
    let speed = (s.tension * (1.0 + s.tension / s.axial) / s.mass).sqrt();
    speed * h * s.elements as f64 / s.length
}

/// Step in which the shortest wave has a given share of 4, by bisection.
fn step_of(share: f64, damping: Rayleigh) -> f64 {
    let used = |h: f64| {
        let c = courant(h).powi(2);
        let all = 4.0 * c * (1.0 + 2.0 * damping.beta / h) + 2.0 * damping.alpha * h;
        let filter = 1.0 + (1.0 - c) / 3.0 * (1.0 + 2.0 * (4.0 - c) / 15.0);
        all * filter / 4.0
    };
    let (mut low, mut high) = (0.0, 1.0 / courant(1.0));
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if used(middle) < share {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

fn string(damping: Rayleigh) -> Chain {
    let mut chain = seen_wire(&STRING, 2);
    let segments = &mut chain.0.segments;
    segments.iter_mut().for_each(|s| s.damping = damping);
    chain
}

const DAMPINGS: [Rayleigh; 3] = [
    Rayleigh {
        alpha: 0.0,
        beta: 0.0,
    },
    Rayleigh {
        alpha: 0.0125,
        beta: 1e-4,
    },
    Rayleigh {
        alpha: 60.0,
        beta: 2e-3,
    },
];

/// The longest step that a refusal names.
fn named(chain: &Chain, h: f64) -> f64 {
    let Err(CoreError::StepTooLong { step, longest }) = prepare::<2, 2>(chain, h) else {
        panic!("{h} s is too long");
    };
    assert!(step.total_cmp(&h).is_eq(), "{step} {h}");
    longest
}

/// Of the limit ω h = 2, 0.95 may be used; a step is given with four figures, rounded down. The
/// shortest wave of 80 elements has q below 4 by (π/80)²/4 = 4e-4 of it, and the search for it errs
/// by as much.
#[test]
fn a_step_that_is_too_long_names_the_longest() {
    for damping in DAMPINGS {
        let (chain, longest) = (string(damping), step_of(0.95 * 0.95, damping));
        for factor in [1.01, 1.3, 2.0, 10.0] {
            let found = named(&chain, factor * longest);
            assert!((found / longest - 1.0).abs() < 3e-3, "{found} {longest}");
            prepare::<2, 2>(&chain, found).expect("what is named is short enough");
        }
        prepare::<2, 2>(&chain, 0.995 * longest).expect("short enough");
    }
}

/// Largest displacement of the middle in the last of many steps, for that in the first.
fn growth(chain: &Chain, h: f64) -> f64 {
    let p = prepare::<2, 2>(chain, h).expect("short enough");
    // All waves at once, the shortest among them.
    let mut start = vec![[0.0; 2]; STRING.elements + 1];
    start[STRING.elements / 2][1] = 1e-3;
    start[7][1] = -1e-3;
    let mut state = p.at_rest(start);
    let mut largest = [0.0_f64; 2];
    for step in 0..6000 {
        p.predict(&mut state, |_| false);
        p.commit(&mut state);
        let seen = state.displacement().at(STRING.elements / 2)[1].abs();
        if !seen.is_finite() {
            return f64::INFINITY;
        }
        if !(500..5500).contains(&step) {
            let part = &mut largest[usize::from(step >= 500)];
            *part = part.max(seen);
        }
    }
    largest[1] / largest[0]
}

#[test]
fn just_below_the_longest_step_nothing_grows() {
    for damping in DAMPINGS {
        let (chain, longest) = (string(damping), step_of(0.95 * 0.95, damping));
        let found = growth(&chain, 0.995 * longest);
        // Waves of an undamped string meet again, but not in greater height than they had together.
        assert!(found < 1.0, "{found}");
        assert!(
            damping.beta > 0.0 || found > 0.1,
            "nothing is lost: {found}"
        );
    }
}
