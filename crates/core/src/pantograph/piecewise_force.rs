//! Piecewise linear springs and dampers of a pantograph: force over displacement or velocity by
//! table.
//!
//!   force on the pantograph = −g f(q),   q = gᵀw or gᵀẇ
//!
//! with f continuous, linear between points, not falling.
//!
//! Beyond its first and last point f continues with the last slope. The steepest piece goes into K
//! or C (together with the force of its line at q = 0), the changes of slope to its left and right
//! become [breakpoints](crate::pantograph::breakpoint). Beyond a breakpoint f is the steepest line
//! plus all changes passed, so
//!
//!   slope after the changes passed = steepest + Σ hardening − Σ softening ≥ 0
//!
//! **One branch at a time.** Breakpoints of one branch are in the problem of a step; on the other
//! side the steepest line continues. When the solution lies there, the force switches its branch
//! and the problem is solved again. The first force on the wrong branch switches, and the search
//! starts again (Murty's least-index rule):
//!
//! * Every step minimises a strictly convex function of the increment, whatever the branches. So
//!   with everything else eliminated, q falls as a force against it grows, and where it meets the
//!   growing f is one point.
//! * Both branches agree up to the first breakpoint of the wrong one. If the point found lies
//!   beyond it, the true one does too: the force switches, and never back while the later forces
//!   keep their branches.
//!
//! So n forces settle after at most 2ⁿ − 1 switches, and mostly after none: a branch is kept from
//! step to step. With both branches in at once the matrix need not be a P-matrix: softening on both
//! sides of a slope k subtracts 2 k from it.
//!
//! **The problem has a P-matrix.** On one branch the softening adds up to the steepest slope at
//! most if slopes fall from breakpoint to breakpoint; then A − D_s κ_s D_sᵀ contains m and is
//! positive definite. Where a slope falls, rises and falls again the sum may be larger; inertia,
//! c_m m with c_m ∝ 1/h², carries it when the step is short enough, which [`check_steps`] verifies.

use crate::error::CoreError;
use crate::linalg::dense;
use crate::linalg::small::{add_outer, inner, matrix_vector};
use crate::pantograph::breakpoint::{
    BalanceInstant, Branch, Breakpoint, ForceKind, RelativeCoordinate,
};
use crate::scheme::Coefficients;

/// Smallest relative change of slope; a smaller one is rounding of the numbers of the table.
const SAME_SLOPE: f64 = 1e-12;

/// Spring or damper given by a table.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PiecewiseForce {
    /// Direction g of the coordinate q = gᵀw.
    pub direction: Vec<f64>,
    /// Spring or damper.
    pub kind: ForceKind,
    /// Points: displacement in m (or velocity in m/s) and force in N, at least two.
    pub points: Vec<[f64; 2]>,
}

impl PiecewiseForce {
    /// Tells whether sizes and numbers fit a pantograph of `n` coordinates.
    pub(crate) fn is_valid(&self, n: usize) -> bool {
        self.direction.len() == n
            && self.direction.iter().all(|v| v.is_finite())
            && self.points.len() >= 2
            && self.points.iter().flatten().all(|v| v.is_finite())
            && self
                .points
                .windows(2)
                .all(|p| p[1][0] > p[0][0] && p[1][1] >= p[0][1])
    }

    /// Slope of a piece, N/m or N·s/m.
    pub(crate) fn slope(&self, piece: usize) -> f64 {
        let [a, b] = [self.points[piece], self.points[piece + 1]];
        (b[1] - a[1]) / (b[0] - a[0])
    }

    /// Number of pieces.
    pub(crate) fn pieces(&self) -> usize {
        self.points.len() - 1
    }

    /// Index of the first of the steepest pieces.
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

    /// Coordinates and changes of slope of a branch, from the steepest piece outwards.
    fn changes(&self, branch: Branch) -> Vec<[f64; 2]> {
        let (steepest, slope) = (self.steepest(), self.slope(self.steepest()));
        let between = |inner: usize, outer: usize, point: usize| {
            let change = self.slope(outer) - self.slope(inner);
            [self.points[point][0], change]
        };
        let all: Vec<[f64; 2]> = match branch {
            Branch::Left => (0..steepest)
                .rev()
                .map(|i| between(i + 1, i, i + 1))
                .collect(),
            Branch::Right => (steepest..self.pieces() - 1)
                .map(|i| between(i, i + 1, i + 1))
                .collect(),
        };
        let is_real = |change: &[f64; 2]| change[1].abs() > SAME_SLOPE * slope;
        all.into_iter().filter(is_real).collect()
    }

    /// Largest sum of softening on one of the branches, N/m or N·s/m.
    fn softening(&self) -> f64 {
        let sum = |branch| {
            let changes = self.changes(branch).into_iter();
            changes.map(|[_, change]| (-change).max(0.0)).sum::<f64>()
        };
        f64::max(sum(Branch::Left), sum(Branch::Right))
    }

    /// Breakpoints during a run of this force, which has index `number`. `inverse`: A⁻¹ of the
    /// pantograph; `influence`: influence vector r of its base.
    pub(crate) fn breakpoints(
        &self,
        number: usize,
        c: &Coefficients,
        inverse: &[f64],
        influence: &[f64],
    ) -> Vec<Breakpoint> {
        let breakpoint = |branch: Branch, opening_sign: f64, [position, change]: [f64; 2]| {
            let direction: Vec<f64> = self.direction.iter().map(|g| opening_sign * g).collect();
            Breakpoint {
                column: matrix_vector(inverse, &direction),
                coordinate: RelativeCoordinate {
                    influence: inner(&direction, influence),
                    direction,
                    kind: self.kind,
                },
                sign: change.signum(),
                factor: self.kind.factor(c),
                flexibility: 1.0 / change.abs(),
                threshold: opening_sign * position,
                branch_of: Some((number, branch)),
                active: branch == Branch::Right,
                predicted_opening: 0.0,
                force: 0.0,
            }
        };
        [(Branch::Left, 1.0), (Branch::Right, -1.0)]
            .into_iter()
            .flat_map(|(branch, opening_sign)| {
                let changes = self.changes(branch).into_iter();
                changes
                    .map(|change| breakpoint(branch, opening_sign, change))
                    .collect::<Vec<_>>()
            })
            .collect()
    }
}

/// Piecewise linear force during a run.
#[derive(Debug, Clone)]
pub(crate) struct PiecewiseForceState {
    /// Relative coordinate q.
    pub(crate) coordinate: RelativeCoordinate,
    /// Force of the steepest line at q = 0, N.
    pub(crate) intercept: f64,
    /// Coordinates of the first breakpoint on each branch; infinite without one.
    first_breakpoints: [f64; 2],
    /// Branch whose breakpoints are active.
    pub(crate) branch: Branch,
    /// Smallest and largest q of the run so far, m or m/s.
    pub(crate) range: [f64; 2],
}

impl PiecewiseForceState {
    /// State at the start of a run; `influence` is the influence vector r of the base.
    pub(crate) fn new(force: &PiecewiseForce, influence: &[f64]) -> Self {
        let first = |branch, none| {
            force
                .changes(branch)
                .first()
                .map_or(none, |change| change[0])
        };
        Self {
            coordinate: RelativeCoordinate {
                influence: inner(&force.direction, influence),
                direction: force.direction.clone(),
                kind: force.kind,
            },
            intercept: force.intercept(force.steepest()),
            first_breakpoints: [
                first(Branch::Left, f64::NEG_INFINITY),
                first(Branch::Right, f64::INFINITY),
            ],
            branch: Branch::Right,
            range: [f64::INFINITY, f64::NEG_INFINITY],
        }
    }

    /// Branch that coordinate `q` lies on: the present one up to the first breakpoint of the other.
    pub(crate) fn branch_at(&self, q: f64) -> Branch {
        match self.branch {
            Branch::Right if q < self.first_breakpoints[0] => Branch::Left,
            Branch::Left if q > self.first_breakpoints[1] => Branch::Right,
            branch => branch,
        }
    }

    /// Coordinate q at the time of balance after an increment, m or m/s.
    pub(crate) fn coordinate_at_balance(
        &self,
        c: &Coefficients,
        start: &BalanceInstant,
        delta: &[f64],
    ) -> f64 {
        self.coordinate.at_balance(0.0, c, start, delta)
    }

    /// Energy of the steepest line in addition to ½ k q², J; none for a damper.
    pub(crate) fn energy(&self, u: &[f64], base: f64) -> f64 {
        match self.coordinate.kind {
            ForceKind::Spring => self.intercept * self.coordinate.displacement(u, base),
            ForceKind::Damper => 0.0,
        }
    }
}

/// Adds the steepest slopes to K and C.
pub(crate) fn add_slopes(forces: &[PiecewiseForce], stiffness: &mut [f64], damping: &mut [f64]) {
    for force in forces {
        let matrix = match force.kind {
            ForceKind::Spring => &mut *stiffness,
            ForceKind::Damper => &mut *damping,
        };
        add_outer(force.slope(force.steepest()), &force.direction, matrix);
    }
}

/// Refuses forces whose softening the matrix A of the scheme does not carry.
///
/// # Errors
/// [`CoreError::Input`].
pub(crate) fn check_steps(
    forces: &[PiecewiseForce],
    matrix: &[f64],
    c: &Coefficients,
) -> Result<(), CoreError> {
    let Some(first) = forces.first() else {
        return Ok(());
    };
    let mut softened = matrix.to_vec();
    for force in forces {
        let change = -force.kind.factor(c) * force.softening();
        add_outer(change, &force.direction, &mut softened);
    }
    if dense::is_positive(&softened, first.direction.len()) {
        return Ok(());
    }
    let reason = "a table that softens, hardens and softens again needs a shorter step";
    Err(CoreError::invalid("piecewise_forces", reason))
}

#[cfg(test)]
mod tests;
