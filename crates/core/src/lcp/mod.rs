//! The linear complementarity problem of one time step, and its solver.
//!
//! ```text
//! y = H x + w,    x ≥ 0,    y ≥ 0,    xᵀ y = 0
//! ```
//!
//! For a contact, `x` is its force (N), `y` its gap (m) and `H` the flexibility of the structure
//! between the contacts (m/N). Rows may have other units; `x_k y_k` is an energy (J) in each.
//!
//! **What `H` must be.** A P-matrix: every principal minor positive. Then the solution exists and
//! is unique for every `w` (Cottle, Pang & Stone, theorem 3.3.7). Symmetric positive definite
//! matrices are P-matrices, and so are the unsymmetric ones of the time step, `[[P, −Q], [Qᵀ, S]]`
//! with `P`, `S` positive definite. The caller is responsible for this property; a pivot that
//! contradicts it is reported, but not every matrix outside the class is recognised.
//!
//! **Method.** Principal pivoting by Jordan exchange (`tableau.rs`). The next row is chosen by the
//! *energy criterion*: among the rows with `q_k < 0` in the current table, the largest `q_k² / (2
//! t_kk)`. The founding paper (Kolesnikov & Kuvshinov, about 2009) names the criterion and
//! attributes it to Kolesnikov & Rakovskaya (2006) without the formula; this is our reading of "the
//! switch that releases the most deformation energy first". The rule can cycle, so cycles are
//! detected and Murty's least-index rule, which cannot, takes over (`pivoting.rs`).
//!
//! **What is returned.** `x` and `y` are computed again from the original `H` and `w` for the
//! active set found (`polish.rs`), are non-negative and complementary exactly, and satisfy `y = Hx
//! + w` to [`RESIDUAL_MAX`], which is measured after every solve by a function that is independent
//! of the solver ([`residual`]).
//!
//! References
//! - R. W. Cottle, J.-S. Pang, R. E. Stone, *The Linear Complementarity Problem*, Academic Press
//!   1992.
//! - K. G. Murty, "Note on a Bard-type scheme for solving the complementarity problem",
//!   *Opsearch* 11 (1974) 123–130.
//! - J. J. Júdice, F. M. Pires, "A block principal pivoting algorithm for large-scale strictly
//!   monotone linear complementarity problems", *Computers & Operations Research* 21 (1994)
//!   587–596: how to return from the least-index rule to the fast one and stay finite.
//! - G. N. Kolesnikov, D. A. Kuvshinov, "Numerical modelling of the semi-coercive mechanical
//!   interaction of a pantograph and an overhead contact line at high locomotive speed" (in
//!   Russian), Petrozavodsk State University, about 2009.

mod check;
mod failure;
mod pivoting;
mod polish;
mod tableau;

pub use check::residual;
pub use failure::{FailureReason, LcpFailure};
pub use pivoting::{ENERGY_PIVOTS_PER_ROW, PIVOTS_BASE, PIVOTS_PER_ROW};
pub use tableau::{FEASIBILITY, PIVOT_MIN, WARM_PIVOT_MIN};

use pivoting::Pivoting;
use polish::DirectSolve;
use tableau::Tableau;

/// Largest accepted [`residual`], relative to the largest terms that are added up in any row.
///
/// Well-conditioned problems leave 10⁻¹⁵, nearly singular ones up to 3·10⁻¹², where [`FEASIBILITY`]
/// cuts; a wrong active set left 5·10⁻⁵ or more. The limit sits between the two.
pub const RESIDUAL_MAX: f64 = 1e-10;

/// Bound on the number of times the table is formed again, because the recomputed solution
/// contradicts it or a pivot in it is not positive.
///
/// Rounding in the table grows with the condition number; up to 10¹⁰ no renewal was seen to be
/// needed, at 10¹³ one in some thousand problems needs one. The others are a reserve.
const RENEWALS_MAX: usize = 3;

/// Statistics of the solution of one problem.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LcpStats {
    /// Exchanges chosen by the pivoting rules.
    pub pivots: usize,
    /// Exchanges made before that, to enter the warm-start set.
    pub warm_pivots: usize,
    /// Fallback: the energy criterion cycled (or ran far too long) and the least-index rule took
    /// over.
    pub fallback_used: bool,
    /// Largest violation of the four conditions, relative (see [`residual`]).
    pub residual: f64,
}

/// Solver with a workspace that is kept between calls.
///
/// Memory grows to the largest problem seen; further calls of that size or smaller allocate nothing
/// (a failure allocates its report).
#[derive(Debug, Clone, Default)]
pub struct LcpSolver {
    tableau: Tableau,
    pivoting: Pivoting,
    direct: DirectSolve,
}

impl LcpSolver {
    /// Solver with an empty workspace.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Reserves memory for problems of up to `rows` rows, so that none is allocated when they are
    /// solved.
    pub fn reserve(&mut self, rows: usize) {
        // A problem whose every row is active uses all of the workspace.
        let mut h = vec![0.0; rows * rows];
        (0..rows).for_each(|i| h[i * rows + i] = 1.0);
        let (mut x, mut y) = (vec![0.0; rows], vec![0.0; rows]);
        let all = vec![true; rows];
        let solved = self.solve(&h, &vec![-1.0; rows], &mut x, &mut y, &all);
        debug_assert!(solved.is_ok(), "the identity is a P-matrix");
    }

    /// Active set of the last problem, the rows with `x_k` free and `y_k = 0`: the warm start of
    /// the next.
    #[must_use]
    pub fn active(&self) -> &[bool] {
        self.tableau.active()
    }

    /// Solves `y = Hx + w`, `x ≥ 0`, `y ≥ 0`, `xᵀy = 0`.
    ///
    /// `h` is `n × n` by rows with `n = w.len()`; `n = 0` is solved trivially. `warm` is the active
    /// set to start from (a closed contact is `true`), or empty to start with none; it changes the
    /// number of pivots, not the answer.
    ///
    /// # Errors
    /// [`LcpFailure`] with the problem inside it when the lengths differ, a number is not finite, a
    /// pivot shows that `h` is not a P-matrix, a bound on the pivots is reached, or the residual is
    /// too large. `x` and `y` are then NaN, so that an ignored error cannot pass for an answer.
    pub fn solve(
        &mut self,
        h: &[f64],
        w: &[f64],
        x: &mut [f64],
        y: &mut [f64],
        warm: &[bool],
    ) -> Result<LcpStats, LcpFailure> {
        let mut stats = LcpStats::default();
        let solved = check::input(h, w, x, y, warm)
            .and_then(|()| self.solve_checked(h, w, x, y, warm, &mut stats));
        match solved {
            Ok(()) => Ok(stats),
            Err(reason) => {
                x.fill(f64::NAN);
                y.fill(f64::NAN);
                Err(LcpFailure::new(reason, h, w, &stats))
            }
        }
    }

    fn solve_checked(
        &mut self,
        h: &[f64],
        w: &[f64],
        x: &mut [f64],
        y: &mut [f64],
        warm: &[bool],
        stats: &mut LcpStats,
    ) -> Result<(), FailureReason> {
        self.tableau.load(h, w)?;
        stats.warm_pivots = self.tableau.activate(warm);
        self.pivoting.start(w.len());
        for renewals in 0..=RENEWALS_MAX {
            let run = self.pivoting.run(&mut self.tableau);
            stats.pivots = self.pivoting.pivots();
            stats.fallback_used = self.pivoting.fallback_used();
            let pivot_failed = matches!(run, Err(FailureReason::Pivot { .. }));
            if renewals == RENEWALS_MAX || !pivot_failed {
                run?;
            }
            self.direct.solve(h, w, &self.tableau)?;
            self.direct.write(self.tableau.scale(), x, y);
            if !pivot_failed && !self.direct.contradicts(&self.tableau) {
                break;
            }
            self.tableau.renew(h, w, self.direct.values())?;
        }
        stats.residual = residual(h, w, x, y);
        if stats.residual <= RESIDUAL_MAX {
            Ok(())
        } else {
            Err(FailureReason::Residual)
        }
    }
}
