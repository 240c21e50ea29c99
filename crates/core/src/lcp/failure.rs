//! Failure of a complementarity problem, with its reason.

use super::LcpStats;

/// Reason of an [`LcpFailure`].
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum FailureReason {
    /// Lengths of the arguments do not belong together.
    #[error("the {array} has {got} entries, expected {expected}")]
    Shape {
        /// Name of the argument.
        array: &'static str,
        /// Length of the argument.
        got: usize,
        /// Length that fits `w`.
        expected: usize,
    },
    /// A number of the problem is NaN or infinite.
    #[error("the {array} has an entry that is not finite (position {position})")]
    NotFinite {
        /// Name of the argument.
        array: &'static str,
        /// Index into it.
        position: usize,
    },
    /// A pivot is not positive, which it is for every P-matrix.
    #[error(
        "H is not a P-matrix to working precision: pivot {pivot:e} at row {row}, \
         where every pivot is positive"
    )]
    Pivot {
        /// Row of the pivot.
        row: usize,
        /// Value of the pivot in the scaled table, where the diagonal of H is about 1.
        pivot: f64,
    },
    /// Pivoting did not end within its bound.
    #[error("no solution within {limit} pivots")]
    PivotLimit {
        /// Bound on the pivots.
        limit: usize,
    },
    /// The computed solution does not satisfy the problem.
    #[error("the solution found does not satisfy y = Hx + w")]
    Residual,
}

/// Complementarity problem that was not solved, complete, so that it can be saved and replayed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error(
    "linear complementarity problem of size {}: {reason} ({pivots} pivots, residual {residual:e})",
    w.len()
)]
pub struct LcpFailure {
    /// Reason of the failure.
    pub reason: FailureReason,
    /// Matrix, by rows.
    pub h: Vec<f64>,
    /// Right-hand side.
    pub w: Vec<f64>,
    /// Exchanges made, warm start included.
    pub pivots: usize,
    /// Residual of the last candidate, NaN when there was none.
    pub residual: f64,
}

impl LcpFailure {
    pub(super) fn new(reason: FailureReason, h: &[f64], w: &[f64], stats: &LcpStats) -> Self {
        let measured = matches!(reason, FailureReason::Residual);
        Self {
            reason,
            h: h.to_vec(),
            w: w.to_vec(),
            pivots: stats.pivots + stats.warm_pivots,
            residual: if measured { stats.residual } else { f64::NAN },
        }
    }
}
