//! Kinks of springs and dampers of a rider: where one becomes stiffer, or softer.
//!
//! A kink looks at a motion x = dᵀw or dᵀẇ of the rider relative to its ground, and closes where x has
//! fallen to x₀. With s = x − x₀ at the time of balance and Δ the change of the slope beyond it,
//!
//!   0 ≤ σ  ⊥  s + σ/Δ ≥ 0
//!
//! * hardening: the force + d σ comes on top of what is there (a [stop](crate::pantograph::bump_stop): nothing is);
//! * softening: the matrices carry a slope that is too large by Δ beyond x₀; − d σ takes it back.
//!
//! Both laws read the same, their forces act in opposite directions. With κ = c Δ, c the factor of K
//! or C in the matrix A of the scheme, and rows divided by c,
//!
//!   s/c + σ/κ = s₀/c + Σ ± dᵀA⁻¹dⱼ σⱼ + σ/κ
//!
//! so hardening kinks join the contacts of the rider (D_h below), softening ones (D_s) the slack links
//! ([contact](crate::constraint::problem)): the matrix is
//!
//!   [ κ_h⁻¹ + D_hᵀA⁻¹D_h    −D_hᵀA⁻¹D_s        ]
//!   [ D_sᵀA⁻¹D_h             κ_s⁻¹ − D_sᵀA⁻¹D_s ]
//!
//! The coupling is skew. The first block is positive definite; the second is if and only if
//! A − D_s κ_s D_sᵀ is (both are Schur complements of [A D_s; D_sᵀ κ_s⁻¹]). A matrix with positive
//! definite symmetric part is a P-matrix (Cottle, Pang & Stone, section 3.3), so the forces are
//! unique. [Laws](crate::pantograph::piecewise_force) see to it that A − D_s κ_s D_sᵀ is positive definite.

use crate::pantograph::piecewise_force::Branch;
use crate::pantograph::system::inner;
use crate::scheme::Coefficients;

/// What a spring or a damper looks at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ForceKind {
    /// Displacement, m: a spring.
    Spring,
    /// Velocity, m/s: a damper.
    Damper,
}

impl ForceKind {
    /// Factor of K or C in the matrix of the scheme.
    pub(crate) fn factor(self, c: &Coefficients) -> f64 {
        match self {
            Self::Spring => c.stiffness,
            Self::Damper => c.damping,
        }
    }
}

/// A motion of a rider relative to its ground, along a direction.
#[derive(Debug, Clone)]
pub(crate) struct RelativeCoordinate {
    pub(crate) direction: Vec<f64>,
    /// dᵀ r.
    pub(crate) carried: f64,
    pub(crate) motion: ForceKind,
}

/// State of a rider at the start of a step, and of its ground then and at the time of balance.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Instant<'a> {
    pub(crate) u: &'a [f64],
    pub(crate) v: &'a [f64],
    pub(crate) a: &'a [f64],
    pub(crate) ground: f64,
    pub(crate) balance: [f64; 2],
}

impl RelativeCoordinate {
    /// dᵀw for a displacement of the rider and its ground, m.
    pub(crate) fn place(&self, u: &[f64], ground: f64) -> f64 {
        inner(&self.direction, u) - self.carried * ground
    }

    /// dᵀw or dᵀẇ at the time of balance after an increment, less `zero`.
    pub(crate) fn beyond(&self, zero: f64, c: &Coefficients, at: &Instant, delta: &[f64]) -> f64 {
        let moved = inner(&self.direction, delta);
        match self.motion {
            ForceKind::Spring => {
                // The ground stands at z of the balance, the rider at u + (1 − α_f) Δu.
                let ground = self.carried * (at.balance[0] - at.ground);
                self.place(at.u, at.ground) - zero + c.stiffness * moved - ground
            }
            ForceKind::Damper => {
                let old = c.velocity_from_v * inner(&self.direction, at.v)
                    + c.velocity_from_a * inner(&self.direction, at.a);
                old + c.damping * moved - self.carried * at.balance[1] - zero
            }
        }
    }
}

/// A kink during a run.
#[derive(Debug, Clone)]
pub(crate) struct Breakpoint {
    /// Its motion; d opens it.
    pub(crate) gauge: RelativeCoordinate,
    /// A⁻¹ d, the response of the increment to a unit force.
    pub(crate) column: Vec<f64>,
    /// +1 when it hardens, −1 when it softens.
    pub(crate) sign: f64,
    /// c, the factor of K or C.
    pub(crate) factor: f64,
    /// 1/Δ.
    pub(crate) flexibility: f64,
    /// x₀, where it closes.
    pub(crate) closed: f64,
    /// The law it belongs to and the side of it; none for a stop.
    pub(crate) law: Option<(usize, Branch)>,
    /// Whether it stands in the complementarity problem.
    pub(crate) is_in: bool,
    /// s at the time of balance, without contact forces and kinks.
    pub(crate) free: f64,
    /// σ, N.
    pub(crate) force: f64,
}

impl Breakpoint {
    /// Row of this kink, column of another one of the same rider.
    pub(crate) fn response(&self, other: &Self, is_same: bool) -> f64 {
        let compliance = f64::from(u8::from(is_same)) * self.flexibility / self.factor;
        inner(&self.gauge.direction, &other.column) * other.sign + compliance
    }

    /// Force on the rider along the direction, N.
    pub(crate) fn push(&self) -> f64 {
        self.sign * self.force
    }

    /// Energy of the change of a spring, ± ½ Δ p² with p how far it is beyond, J.
    pub(crate) fn energy(&self, u: &[f64], ground: f64) -> f64 {
        if self.flexibility == 0.0 {
            return 0.0;
        }
        let beyond = (self.gauge.place(u, ground) - self.closed).min(0.0);
        self.sign * 0.5 * beyond.powi(2) / self.flexibility
    }
}
