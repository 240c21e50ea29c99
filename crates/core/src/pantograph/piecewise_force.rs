//! Springs and dampers of a rider given by a table: force over displacement or velocity.
//!
//!   force on the rider = −g f(q),   q = gᵀw or gᵀẇ,   f continuous, linear between points, not falling
//!
//! Beyond its first and last point f goes on with the last slope. The steepest piece goes into K or C
//! (with the force of its line at q = 0 beside it), the changes of slope to its left and right become
//! [kinks](crate::pantograph::breakpoint). Beyond a kink f is the steepest line plus all changes passed, so
//!
//!   slope after the changes passed = steepest + Σ hardening − Σ softening ≥ 0
//!
//! **One side at a time.** Kinks of one side stand in the problem of a step; on the other side the
//! steepest line goes on. When the solution lies there, the law changes sides and the problem is
//! solved again. Let the first law on the wrong side turn, and begin anew (Murty's least-index rule):
//!
//! * Every step minimises a strictly convex function of the increment, whatever the sides. So with
//!   everything else eliminated, q falls as a force against it grows, and where it meets the growing
//!   f is one point.
//! * Both sides agree up to the first kink of the wrong one. If the point found lies beyond it, the
//!   true one does too: it turns, and never back while the laws behind it keep their sides.
//!
//! So n laws settle after at most 2ⁿ − 1 turns, and mostly after none: a side is kept from step to step.
//! With both sides in at once the matrix need not be a P-matrix: softening on both sides of a slope k
//! takes 2 k from it.
//!
//! **What enters is a P-matrix.** On one side the softening adds up to the steepest slope at most if
//! slopes fall from kink to kink; then A − D_s κ_s D_sᵀ contains m and is positive definite. Where a
//! slope falls, rises and falls again the sum may be larger; inertia, c_m m with c_m ∝ 1/h², carries
//! it when the step is short enough. [`check_steps`] tells.

use crate::error::CoreError;
use crate::linalg::dense;
use crate::pantograph::breakpoint::{Breakpoint, ForceKind, Instant, RelativeCoordinate};
use crate::pantograph::system::{inner, multiply};
use crate::scheme::Coefficients;

/// A change of slope below this share of the steepest is rounding of what is written.
const SAME_SLOPE: f64 = 1e-12;

/// A spring or a damper with a table.
#[derive(Debug, Clone)]
pub struct PiecewiseForce {
    /// g: q = gᵀw.
    pub direction: Vec<f64>,
    /// Whether it is a spring or a damper.
    pub motion: ForceKind,
    /// Displacement in m (or velocity in m/s) and force in N, at least two.
    pub points: Vec<[f64; 2]>,
}

/// Side of the steepest piece.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Branch {
    /// Below it.
    Left,
    /// Above it.
    Right,
}

impl PiecewiseForce {
    pub(crate) fn is_sound(&self, n: usize) -> bool {
        self.direction.len() == n
            && self.direction.iter().all(|v| v.is_finite())
            && self.points.len() >= 2
            && self.points.iter().flatten().all(|v| v.is_finite())
            && self
                .points
                .windows(2)
                .all(|p| p[1][0] > p[0][0] && p[1][1] >= p[0][1])
    }

    /// Slope of a piece.
    pub(crate) fn slope(&self, piece: usize) -> f64 {
        let [a, b] = [self.points[piece], self.points[piece + 1]];
        (b[1] - a[1]) / (b[0] - a[0])
    }

    /// Number of pieces.
    pub(crate) fn pieces(&self) -> usize {
        self.points.len() - 1
    }

    /// The first of the steepest pieces.
    pub(crate) fn steepest(&self) -> usize {
        (1..self.pieces()).fold(0, |best, i| {
            if self.slope(i) > self.slope(best) {
                i
            } else {
                best
            }
        })
    }

    /// Force of the line through a piece at q = 0, N.
    pub(crate) fn intercept(&self, piece: usize) -> f64 {
        let [x, f] = self.points[piece];
        f - self.slope(piece) * x
    }

    /// Places and changes of slope on a side of the steepest piece, from it outwards.
    fn changes(&self, side: Branch) -> Vec<[f64; 2]> {
        let (steepest, slope) = (self.steepest(), self.slope(self.steepest()));
        let between = |inner: usize, outer: usize, at: usize| {
            let change = self.slope(outer) - self.slope(inner);
            [self.points[at][0], change]
        };
        let all: Vec<[f64; 2]> = match side {
            Branch::Left => (0..steepest)
                .rev()
                .map(|i| between(i + 1, i, i + 1))
                .collect(),
            Branch::Right => (steepest..self.pieces() - 1)
                .map(|i| between(i, i + 1, i + 1))
                .collect(),
        };
        let real = |change: &[f64; 2]| change[1].abs() > SAME_SLOPE * slope;
        all.into_iter().filter(real).collect()
    }

    /// The largest sum of softening on one of the sides.
    fn softening(&self) -> f64 {
        let sum = |side| {
            let changes = self.changes(side).into_iter();
            changes.map(|[_, change]| (-change).max(0.0)).sum::<f64>()
        };
        f64::max(sum(Branch::Left), sum(Branch::Right))
    }

    /// Its kinks during a run; `number` is its own, `inverse` that of the matrix of the scheme.
    pub(crate) fn kinks(
        &self,
        number: usize,
        c: &Coefficients,
        inverse: &[f64],
        carried: &[f64],
    ) -> Vec<Breakpoint> {
        let kink = |side: Branch, opens: f64, [place, change]: [f64; 2]| {
            let direction: Vec<f64> = self.direction.iter().map(|g| opens * g).collect();
            Breakpoint {
                column: multiply(inverse, &direction),
                gauge: RelativeCoordinate {
                    carried: inner(&direction, carried),
                    direction,
                    motion: self.motion,
                },
                sign: change.signum(),
                factor: self.motion.factor(c),
                flexibility: 1.0 / change.abs(),
                closed: opens * place,
                law: Some((number, side)),
                is_in: side == Branch::Right,
                free: 0.0,
                force: 0.0,
            }
        };
        [(Branch::Left, 1.0), (Branch::Right, -1.0)]
            .into_iter()
            .flat_map(|(side, opens)| {
                let changes = self.changes(side).into_iter();
                changes
                    .map(|change| kink(side, opens, change))
                    .collect::<Vec<_>>()
            })
            .collect()
    }
}

/// A law during a run.
#[derive(Debug, Clone)]
pub(crate) struct PiecewiseForceState {
    pub(crate) gauge: RelativeCoordinate,
    /// Force of the steepest line at q = 0, N.
    pub(crate) intercept: f64,
    /// The first kink on each side; infinite without.
    ends: [f64; 2],
    pub(crate) side: Branch,
    /// Smallest and largest q of the run so far.
    pub(crate) range: [f64; 2],
}

impl PiecewiseForceState {
    pub(crate) fn new(law: &PiecewiseForce, carried: &[f64]) -> Self {
        let first = |side, none| law.changes(side).first().map_or(none, |change| change[0]);
        Self {
            gauge: RelativeCoordinate {
                carried: inner(&law.direction, carried),
                direction: law.direction.clone(),
                motion: law.motion,
            },
            intercept: law.intercept(law.steepest()),
            ends: [
                first(Branch::Left, f64::NEG_INFINITY),
                first(Branch::Right, f64::INFINITY),
            ],
            side: Branch::Right,
            range: [f64::INFINITY, f64::NEG_INFINITY],
        }
    }

    /// The side where a motion lies: the present one up to the first kink of the other.
    pub(crate) fn side_of(&self, q: f64) -> Branch {
        match self.side {
            Branch::Right if q < self.ends[0] => Branch::Left,
            Branch::Left if q > self.ends[1] => Branch::Right,
            side => side,
        }
    }

    /// q at the time of balance after an increment.
    pub(crate) fn at(&self, c: &Coefficients, instant: &Instant, delta: &[f64]) -> f64 {
        self.gauge.beyond(0.0, c, instant, delta)
    }

    /// Energy of the steepest line beside ½ k q², J; none for a damper.
    pub(crate) fn energy(&self, u: &[f64], ground: f64) -> f64 {
        match self.gauge.motion {
            ForceKind::Spring => self.intercept * self.gauge.place(u, ground),
            ForceKind::Damper => 0.0,
        }
    }
}

/// Add the steepest slopes to K and C.
pub(crate) fn add_slopes(laws: &[PiecewiseForce], stiffness: &mut [f64], damping: &mut [f64]) {
    for law in laws {
        let matrix = match law.motion {
            ForceKind::Spring => &mut *stiffness,
            ForceKind::Damper => &mut *damping,
        };
        add_outer(law.slope(law.steepest()), &law.direction, matrix);
    }
}

/// matrix += factor · d dᵀ
pub(crate) fn add_outer(factor: f64, d: &[f64], matrix: &mut [f64]) {
    let n = d.len();
    for i in 0..n {
        for j in 0..n {
            matrix[i * n + j] += factor * d[i] * d[j];
        }
    }
}

/// Refuse laws whose softening the matrix A of the scheme does not carry.
///
/// # Errors
/// [`CoreError::Input`].
pub(crate) fn check_steps(
    laws: &[PiecewiseForce],
    matrix: &[f64],
    c: &Coefficients,
) -> Result<(), CoreError> {
    let Some(first) = laws.first() else {
        return Ok(());
    };
    let mut rest = matrix.to_vec();
    for law in laws {
        let softened = -law.motion.factor(c) * law.softening();
        add_outer(softened, &law.direction, &mut rest);
    }
    if dense::is_positive(&rest, first.direction.len()) {
        return Ok(());
    }
    Err(CoreError::Input {
        array: "laws",
        reason: "a table that softens, hardens and softens again needs a shorter step".into(),
    })
}
