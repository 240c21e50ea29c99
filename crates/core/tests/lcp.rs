//! The complementarity solver against enumeration, Lemke's method and published hard problems.

#[path = "lcp_hard/mod.rs"]
mod lcp_hard;

use crate::tests::lcp_oracle;
use arcless_core::lcp::{FailureReason, LcpFailure, LcpSolver, LcpStats, RESIDUAL_MAX, residual};
use lcp_oracle::{Problem, enumeration, generate, lemke};
use proptest::prelude::*;

fn try_solve(p: &Problem, warm: &[bool]) -> Result<(Vec<f64>, Vec<f64>, LcpStats), LcpFailure> {
    let (mut x, mut y) = (vec![0.0; p.n()], vec![0.0; p.n()]);
    let stats = LcpSolver::new().solve(&p.h, &p.w, &mut x, &mut y, warm)?;
    Ok((x, y, stats))
}

fn solve(p: &Problem) -> (Vec<f64>, Vec<f64>, LcpStats) {
    try_solve(p, &[]).expect("the problem has a solution")
}

/// Difference relative to the largest entry, so that a tolerance means digits.
fn difference(a: &[f64], b: &[f64]) -> f64 {
    let size = b.iter().fold(f64::MIN_POSITIVE, |m, v| v.abs().max(m));
    a.iter()
        .zip(b)
        .fold(0.0, |m: f64, (u, v)| m.max((u - v).abs()))
        / size
}

fn conditions_hold(p: &Problem, x: &[f64], y: &[f64]) -> bool {
    let signs = x.iter().chain(y).all(|v| *v >= 0.0);
    let complementary = x.iter().zip(y).all(|(a, b)| *a == 0.0 || *b == 0.0);
    signs && complementary && residual(&p.h, &p.w, x, y) <= RESIDUAL_MAX
}

/// `½ xᵀHx + wᵀx`, unique even where `x` is badly determined.
fn energy(p: &Problem, x: &[f64]) -> f64 {
    p.y(x)
        .iter()
        .zip(&p.w)
        .zip(x)
        .map(|((y, w), x)| 0.5 * (y + w) * x)
        .sum()
}

proptest! {
    // Condition number below 10³ costs three of sixteen digits; 1e-10 leaves three in reserve.
    #[test]
    fn definite_agrees_with_enumeration(n in 1_usize..=10, seed in 0_u64..1 << 40) {
        let p = generate::definite(n, seed);
        let (x, y, _) = solve(&p);
        let (x_all, y_all) = enumeration::solve(&p);
        prop_assert!(conditions_hold(&p, &x, &y));
        // Condition numbers are some hundreds: 1e-13, and a thousand times that for rare seeds.
        prop_assert!(difference(&x, &x_all) < 1e-10 && difference(&y, &y_all) < 1e-10);
    }

    // Tolerance 1e-8, because the entries of x and y span the four decades of the two units.
    #[test]
    fn skew_coupled_agrees_with_enumeration(n in 2_usize..=9, seed in 0_u64..1 << 40) {
        let p = generate::skew_coupled(n, seed);
        let (x, y, _) = solve(&p);
        let (x_all, y_all) = enumeration::solve(&p);
        prop_assert!(conditions_hold(&p, &x, &y));
        // Asymmetric, so nothing bounds the condition number; 1e-8 still tells two solutions apart.
        prop_assert!(difference(&x, &x_all) < 1e-8 && difference(&y, &y_all) < 1e-8);
    }

    // Condition number 1e9: x keeps seven digits, the minimum of the energy about twice as many;
    // for rare seeds, with an energy above 1e8, six (1.2e-6 for n = 8, seed 927686499521).
    #[test]
    fn near_singular_finds_the_least_energy(n in 2_usize..=9, seed in 0_u64..1 << 40) {
        let p = generate::near_singular(n, seed);
        let (x, y, _) = solve(&p);
        let (x_all, _) = enumeration::solve(&p);
        prop_assert!(conditions_hold(&p, &x, &y));
        let (e, e_all) = (energy(&p, &x), energy(&p, &x_all));
        prop_assert!((e - e_all).abs() <= 1e-5 * e_all.abs(), "{e} {e_all}");
    }

    #[test]
    fn degenerate_agrees_with_enumeration(n in 1_usize..=8, seed in 0_u64..1 << 40) {
        let p = generate::degenerate(n, seed);
        let (x, y, _) = solve(&p);
        let (x_all, y_all) = enumeration::solve(&p);
        prop_assert!(conditions_hold(&p, &x, &y));
        // Whole numbers up to 9: the gaps are exact to rounding, and zero where they should be.
        prop_assert!(difference(&x, &x_all) < 1e-11, "{x:?} {x_all:?}");
        prop_assert!(y.iter().zip(&y_all).all(|(a, b)| (a - b).abs() < 1e-11));
    }

    /// The order of the pivots is the energy criterion's, worked out without a table.
    #[test]
    fn pivots_follow_the_energy_criterion(n in 1_usize..=8, seed in 0_u64..1 << 40) {
        let p = generate::definite(n, seed);
        let (x, _, stats) = solve(&p);
        let walk = enumeration::energy_walk(&p, 200);
        prop_assert_eq!(stats.pivots, walk.len() - 1);
        // Tolerance as above, for condition numbers of some hundreds.
        let last = enumeration::candidate(&p, walk[walk.len() - 1]).expect("regular block");
        prop_assert!(difference(&x, &last.0) < 1e-10);
    }

    #[test]
    fn any_warm_start_gives_the_same_answer(n in 1_usize..=8, seed in 0_u64..1 << 40) {
        for p in [generate::definite(n, seed), generate::skew_coupled(n.max(2), seed)] {
            let (x, y, _) = solve(&p);
            for set in 0..1_usize << p.n() {
                let warm: Vec<bool> = (0..p.n()).map(|k| set >> k & 1 == 1).collect();
                let (x_warm, y_warm, stats) = try_solve(&p, &warm).expect("a solution");
                // Tolerance as above, for the class without a bound on its condition numbers.
                prop_assert!(difference(&x_warm, &x) < 1e-8 && difference(&y_warm, &y) < 1e-8);
                prop_assert_eq!(stats.warm_pivots, set.count_ones() as usize);
            }
        }
    }

    /// Metres or micrometres in a row change neither the pivots nor the answer.
    #[test]
    fn units_do_not_matter(n in 2_usize..=8, seed in 0_u64..1 << 40) {
        let p = generate::definite(n, seed);
        let d: Vec<f64> = (0..n).map(|k| 10_f64.powi(3 * (k as i32 % 5) - 6)).collect();
        let h = (0..n * n).map(|i| p.h[i] * d[i / n] * d[i % n]).collect();
        let scaled = Problem { h, w: (0..n).map(|k| p.w[k] * d[k]).collect() };
        let ((x, _, stats), (x_scaled, _, stats_scaled)) = (solve(&p), solve(&scaled));
        let back: Vec<f64> = x_scaled.iter().zip(&d).map(|(x, d)| x * d).collect();
        // Condition numbers of some hundreds; scaling with powers of ten rounds each entry once.
        prop_assert!(difference(&back, &x) < 1e-10);
        prop_assert_eq!(stats.pivots, stats_scaled.pivots);
    }
}

#[test]
fn large_problems_agree_with_lemke() {
    for (n, seed) in [(20, 1), (100, 2), (500, 3)] {
        let p = generate::definite(n, seed);
        let (x, y, stats) = solve(&p);
        let x_lemke = lemke::solve(&p).expect("Lemke's method ends for definite matrices");
        assert!(conditions_hold(&p, &x, &y));
        // Lemke's table gathers the rounding of some 500 pivots at condition number 1e4.
        assert!(
            difference(&x, &x_lemke) < 1e-7,
            "n = {n}: {}",
            difference(&x, &x_lemke)
        );
        assert!(stats.pivots < 3 * n / 2, "n = {n}: {stats:?}");
    }
}

#[test]
fn large_near_singular_problem_is_solved() {
    let p = generate::near_singular(500, 4);
    let (x, y, _) = solve(&p);
    assert!(conditions_hold(&p, &x, &y));
}

#[test]
fn sizes_zero_and_one() {
    assert_eq!(solve(&Problem::new(&[], &[])).2, LcpStats::default());
    let one = |w: f64| solve(&Problem::new(&[&[4.0]], &[w]));
    assert_eq!((one(2.0).0[0], one(2.0).1[0]), (0.0, 2.0));
    assert_eq!((one(-2.0).0[0], one(-2.0).1[0]), (0.5, 0.0));
    assert_eq!((one(0.0).0[0], one(0.0).1[0]), (0.0, 0.0));
}

/// H = [[2, 1], [1, 2]], w = (−1, s): row 2 closes when s falls below −1/2.
#[test]
fn sweep_across_a_change_of_the_active_set() {
    let mut solver = LcpSolver::new();
    let (mut x, mut y) = ([0.0; 2], [0.0; 2]);
    let mut warm = vec![false; 2];
    for step in 0..=400 {
        let s = -1.5 + f64::from(step) / 200.0;
        let w = [-1.0, s];
        solver
            .solve(&[2.0, 1.0, 1.0, 2.0], &w, &mut x, &mut y, &warm)
            .expect("a solution");
        let both = [(2.0 + s) / 3.0, (-1.0 - 2.0 * s) / 3.0];
        let expected = if s < -0.5 { both } else { [0.5, 0.0] };
        // The last bits of numbers of order 1.
        assert!((x[0] - expected[0]).abs() < 1e-15 && (x[1] - expected[1]).abs() < 1e-15);
        assert!((y[1] - (s + 0.5).max(0.0)).abs() < 1e-15);
        warm.copy_from_slice(solver.active());
    }
}

#[test]
fn wrong_input_is_named_and_the_output_is_nan() {
    let nan = f64::NAN;
    let h = [2.0, 0.0, 0.0, 2.0];
    let cases: [(&[f64], &[f64], usize, &str); 5] = [
        (
            &h,
            &[1.0, nan],
            0,
            "vector w has an entry that is not finite (position 1)",
        ),
        (
            &[1.0, nan, nan, 1.0],
            &[1.0, 1.0],
            0,
            "matrix H has an entry that is not finite",
        ),
        (
            &[1.0, 2.0],
            &[1.0, 1.0],
            0,
            "matrix H has 2 entries, expected 4",
        ),
        (&h, &[1.0, 1.0], 3, "warm start has 3 entries, expected 2"),
        (&[0.0, 0.0, 0.0, 1.0], &[1.0, 1.0], 0, "not a P-matrix"),
    ];
    let mut solver = LcpSolver::new();
    for (h, w, warm, message) in cases {
        let (mut x, mut y) = ([0.0; 2], [0.0; 2]);
        let failure = solver.solve(h, w, &mut x, &mut y, &vec![true; warm]);
        let failure = failure.expect_err(message);
        assert!(failure.to_string().contains(message), "{failure}");
        assert!(x.iter().chain(&y).all(|v| v.is_nan()));
        let same = |a: &[f64], b: &[f64]| {
            a.iter()
                .map(|v| v.to_bits())
                .eq(b.iter().map(|v| v.to_bits()))
        };
        assert!(
            same(&failure.h, h) && same(&failure.w, w),
            "the problem is in the report"
        );
    }
    let (mut x, mut y) = ([0.0; 2], [0.0; 2]);
    solver
        .solve(&h, &[-2.0, 1.0], &mut x, &mut y, &[])
        .expect("usable after a failure");
    assert_eq!((x, y), ([1.0, 0.0], [0.0, 1.0]));
}

/// Principal minors 1, 1, −3; no solution exists: `y₁ + y₂ = −x₁ − x₂ − 2 < 0`.
#[test]
fn matrix_outside_the_class_is_reported() {
    let p = Problem::new(&[&[1.0, -2.0], &[-2.0, 1.0]], &[-1.0, -1.0]);
    let failure = try_solve(&p, &[]).expect_err("there is no solution");
    assert_eq!(
        failure.reason,
        FailureReason::Pivot {
            row: 1,
            pivot: -3.0
        }
    );
    assert_eq!(failure.pivots, 1);
}

/// Finite input whose solution x = 10⁶⁰⁰ is not a number of the machine.
#[test]
fn overflow_is_a_failure() {
    assert!(try_solve(&Problem::new(&[&[1e-300]], &[-1e300]), &[]).is_err());
}

/// Each of the four conditions alone, broken by 10⁻⁶, is seen.
#[test]
fn residual_sees_every_condition() {
    let (h, w) = ([2.0, 1.0, 1.0, 2.0], [-2.0, 3.0]);
    assert_eq!(residual(&h, &w, &[1.0, 0.0], &[0.0, 4.0]), 0.0);
    let small = 1e-6;
    let broken = [
        ([1.0, 0.0], [0.0, 4.0 + small]),
        ([1.0 + 0.5 * small, -small], [0.0, 4.0 - 1.5 * small]),
        ([1.0 - 0.5 * small, 0.0], [-small, 4.0 - 0.5 * small]),
        ([1.0 + 0.5 * small, 0.0], [small, 4.0 + 0.5 * small]),
    ];
    for (x, y) in broken {
        let found = residual(&h, &w, &x, &y);
        assert!(found > 1e3 * RESIDUAL_MAX && found < small, "{found:e}");
    }
    assert!(residual(&h, &w, &[f64::NAN, 0.0], &[0.0, 4.0]).is_nan());
}
