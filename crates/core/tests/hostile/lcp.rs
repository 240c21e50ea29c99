//! Complementarity problems of any numbers, and P-matrices made on purpose.

use super::super::lcp_oracle::{Problem, lemke};
use super::feed::Feed;
use arcless_core::lcp::{FailureReason, LcpSolver, RESIDUAL_MAX, residual};

/// Outcome of a problem.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Outcome {
    /// The arrays do not belong together or are not finite.
    Refused,
    /// No verified solution: the matrix is no P-matrix to working precision.
    Failed,
    /// Solved and verified.
    Solved,
}

/// Rows at most.
const MOST_ROWS: usize = 12;

/// Read a problem, solve it, judge the answer by the conditions themselves.
///
/// # Panics
/// When the answer does not satisfy them, when a sound problem is not solved, when the core panics.
pub fn solve(bytes: &[u8]) -> Outcome {
    let feed = &mut Feed::new(bytes);
    let n = feed.below(MOST_ROWS + 1);
    let is_sound = feed.flag();
    let mut problem = if is_sound {
        coupled(feed, n)
    } else {
        plain(feed, n)
    };
    let (mut warm, mut x, mut y) = (warm(feed, n), vec![0.0; n], vec![0.0; n]);
    if !is_sound {
        match feed.below(16) {
            11 => feed.disturb(&mut problem.h),
            12 => feed.disturb(&mut problem.w),
            13 => feed.disturb(&mut warm),
            14 => feed.disturb(&mut x),
            15 => feed.disturb(&mut y),
            _ => (),
        }
    }
    let mut solver = LcpSolver::new();
    let (h, w) = (&problem.h, &problem.w);
    match solver.solve(h, w, &mut x, &mut y, &warm) {
        Ok(stats) => {
            let found = residual(h, w, &x, &y);
            assert!(found <= RESIDUAL_MAX && found.to_bits() == stats.residual.to_bits());
            assert!(x.iter().chain(&y).all(|v| v.is_finite() && *v >= 0.0));
            assert!(x.iter().zip(&y).all(|(x, y)| *x == 0.0 || *y == 0.0));
            if is_sound {
                agree(&problem, &x);
            }
            Outcome::Solved
        }
        Err(failure) => {
            assert!(!is_sound, "a P-matrix: {failure}: {h:?} {w:?}");
            assert!(!failure.to_string().is_empty());
            assert!(x.iter().chain(&y).all(|v| v.is_nan()));
            match failure.reason {
                FailureReason::Shape { .. } | FailureReason::NotFinite { .. } => Outcome::Refused,
                _ => Outcome::Failed,
            }
        }
    }
}

/// Lemke's method finds the same x: the matrices here have pivots of at least one.
fn agree(problem: &Problem, x: &[f64]) {
    let Some(other) = lemke::solve(problem) else {
        return;
    };
    let size = x.iter().fold(1.0, |m: f64, v| m.max(*v));
    let apart = x.iter().zip(&other).map(|(a, b)| (a - b).abs());
    let worst = apart.fold(0.0, f64::max);
    assert!(
        worst <= 1e-8 * size,
        "{x:?} and by Lemke's method {other:?}"
    );
}

fn warm(feed: &mut Feed<'_>, n: usize) -> Vec<bool> {
    if feed.flag() {
        (0..n).map(|_| feed.flag()).collect()
    } else {
        Vec::new()
    }
}

/// Any numbers, mostly a positive diagonal.
fn plain(feed: &mut Feed<'_>, n: usize) -> Problem {
    let mut h = vec![0.0; n * n];
    for (k, value) in h.iter_mut().enumerate() {
        let usual = if k.is_multiple_of(n + 1) { 2.0 } else { 0.25 };
        *value = feed.number(usual);
    }
    let w = (0..n).map(|_| feed.number(-1.0)).collect();
    Problem { h, w }
}

/// 1 + G Gᵀ, with the coupling of two kinds of rows, [[P, −Q], [Qᵀ, S]], and small whole numbers:
/// a P-matrix of moderate condition whatever the bytes.
fn coupled(feed: &mut Feed<'_>, n: usize) -> Problem {
    let small = |feed: &mut Feed<'_>| f64::from(feed.byte() as i8) / 16.0;
    let g: Vec<f64> = (0..n * n).map(|_| small(feed)).collect();
    let split = feed.below(n + 1);
    let mut h = vec![0.0; n * n];
    for i in 0..n {
        for j in 0..n {
            let dot: f64 = (0..n).map(|k| g[i * n + k] * g[j * n + k]).sum();
            let coupling = (i < split) != (j < split);
            let sign = if coupling && i < j { -1.0 } else { 1.0 };
            let own = if i == j { 1.0 } else { 0.0 };
            h[i * n + j] = own + sign * dot;
        }
    }
    let w = (0..n).map(|_| small(feed)).collect();
    Problem { h, w }
}
