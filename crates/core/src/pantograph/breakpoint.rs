//! Breakpoints of the springs and dampers of a pantograph, at which one becomes stiffer or softer.
//!
//! A breakpoint belongs to a relative coordinate x = dᵀw or dᵀẇ of the pantograph and its base, and
//! closes where x has fallen to x₀. With s = x − x₀ at the time of balance and Δ the change of the
//! slope beyond it,
//!
//!   0 ≤ σ  ⊥  s + σ/Δ ≥ 0
//!
//! * hardening: the force + d σ adds to what is there (for a [stop](crate::pantograph::bump_stop):
//!   nothing);
//! * softening: the matrices carry a slope that is too large by Δ beyond x₀; − d σ corrects it.
//!
//! Both conditions read alike, their forces act in opposite directions. With κ = c Δ, c the factor
//! of K or C in the matrix A of the scheme, and rows divided by c,
//!
//!   s/c + σ/κ = s₀/c + Σ ± dᵀA⁻¹dⱼ σⱼ + σ/κ
//!
//! so hardening breakpoints join the contacts of the pantograph (D_h below), softening ones (D_s)
//! the slack links ([problem](crate::constraint::problem)): the matrix is
//!
//!   [ κ_h⁻¹ + D_hᵀA⁻¹D_h    −D_hᵀA⁻¹D_s        ]
//!   [ D_sᵀA⁻¹D_h             κ_s⁻¹ − D_sᵀA⁻¹D_s ]
//!
//! The coupling is skew. The first block is positive definite; the second is if and only if A − D_s
//! κ_s D_sᵀ is (both are Schur complements of [A D_s; D_sᵀ κ_s⁻¹]). A matrix with positive definite
//! symmetric part is a P-matrix (Cottle, Pang & Stone, section 3.3), so the forces are unique.
//! [Piecewise linear forces](crate::pantograph::piecewise_force) ensure that A − D_s κ_s D_sᵀ is
//! positive definite.

use crate::linalg::small::inner;
use crate::scheme::Coefficients;

/// Kind of a force: spring or damper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum ForceKind {
    /// Spring, a function of displacement, m.
    Spring,
    /// Damper, a function of velocity, m/s.
    Damper,
}

impl ForceKind {
    /// Factor c of K or C in the matrix of the scheme.
    pub(crate) fn factor(self, c: &Coefficients) -> f64 {
        match self {
            Self::Spring => c.stiffness,
            Self::Damper => c.damping,
        }
    }
}

/// Branch of a piecewise linear force: the side of its steepest piece whose breakpoints are active.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Branch {
    /// Below the steepest piece.
    Left,
    /// Above the steepest piece.
    Right,
}

/// Coordinate of a pantograph relative to its base, along a direction.
#[derive(Debug, Clone)]
pub(crate) struct RelativeCoordinate {
    /// Direction d.
    pub(crate) direction: Vec<f64>,
    /// Displacement dᵀr of the coordinate for a unit displacement of the base.
    pub(crate) influence: f64,
    /// Displacement (of a spring) or velocity (of a damper).
    pub(crate) kind: ForceKind,
}

/// State of a pantograph at the start of a step, and of its base then and at the time of balance.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BalanceInstant<'a> {
    /// Displacement of the pantograph at the start of the step, m.
    pub(crate) u: &'a [f64],
    /// Velocity of the pantograph at the start of the step, m/s.
    pub(crate) v: &'a [f64],
    /// Acceleration of the pantograph at the start of the step, m/s².
    pub(crate) a: &'a [f64],
    /// Displacement of the base at the start of the step, m.
    pub(crate) base: f64,
    /// Displacement and rate of the base at the time of balance, m and m/s.
    pub(crate) balance: [f64; 2],
}

impl RelativeCoordinate {
    /// Relative displacement dᵀw, m, for displacements of the pantograph and its base.
    pub(crate) fn displacement(&self, u: &[f64], base: f64) -> f64 {
        inner(&self.direction, u) - self.influence * base
    }

    /// Coordinate dᵀw or dᵀẇ at the time of balance after an increment, minus `zero`, m or m/s.
    pub(crate) fn at_balance(
        &self,
        zero: f64,
        c: &Coefficients,
        start: &BalanceInstant,
        delta: &[f64],
    ) -> f64 {
        let increment = inner(&self.direction, delta);
        match self.kind {
            ForceKind::Spring => {
                // The base is at z of the balance, the pantograph at u + (1 − α_f) Δu.
                let base = self.influence * (start.balance[0] - start.base);
                self.displacement(start.u, start.base) - zero + c.stiffness * increment - base
            }
            ForceKind::Damper => {
                let old = c.velocity_from_v * inner(&self.direction, start.v)
                    + c.velocity_from_a * inner(&self.direction, start.a);
                old + c.damping * increment - self.influence * start.balance[1] - zero
            }
        }
    }
}

/// Breakpoint during a run.
#[derive(Debug, Clone)]
pub(crate) struct Breakpoint {
    /// Relative coordinate x; motion along its direction d opens the breakpoint.
    pub(crate) coordinate: RelativeCoordinate,
    /// Response A⁻¹ d of the increment to a unit force.
    pub(crate) column: Vec<f64>,
    /// Sign: +1 when it hardens, −1 when it softens.
    pub(crate) sign: f64,
    /// Factor c of K or C.
    pub(crate) factor: f64,
    /// Flexibility 1/Δ, m/N or m/(N·s).
    pub(crate) flexibility: f64,
    /// Threshold x₀ below which it is closed, m or m/s.
    pub(crate) threshold: f64,
    /// Piecewise linear force and the branch of it that the breakpoint belongs to; none for a stop.
    pub(crate) branch_of: Option<(usize, Branch)>,
    /// Flag of a breakpoint in the complementarity problem.
    pub(crate) active: bool,
    /// Opening s at the time of balance without constraint forces, m or m/s.
    pub(crate) predicted_opening: f64,
    /// Force σ, N.
    pub(crate) force: f64,
}

impl Breakpoint {
    /// Entry of the complementarity matrix in the row of this breakpoint and the column of `other`,
    /// of the same pantograph.
    pub(crate) fn response(&self, other: &Self, is_same: bool) -> f64 {
        let compliance = f64::from(u8::from(is_same)) * self.flexibility / self.factor;
        inner(&self.coordinate.direction, &other.column) * other.sign + compliance
    }

    /// Force ± σ on the pantograph along the direction d, N.
    pub(crate) fn signed_force(&self) -> f64 {
        self.sign * self.force
    }

    /// Energy ± ½ Δ p² of the change of a spring, J, with p the penetration beyond the threshold.
    pub(crate) fn energy(&self, u: &[f64], base: f64) -> f64 {
        if self.flexibility == 0.0 {
            return 0.0;
        }
        let opening = (self.coordinate.displacement(u, base) - self.threshold).min(0.0);
        self.sign * 0.5 * opening.powi(2) / self.flexibility
    }
}
