//! Time-stepping schemes, all as `A Δu = b + C λ` with a constant matrix A.
//!
//! Balance at the generalised midpoint (Chung & Hulbert, J. Appl. Mech. 60 (1993) 371):
//!
//!   M a_m + C v_f + K u_f = f_f
//!   a_m = (1−α_m) aₙ₊₁ + α_m aₙ,   x_f = (1−α_f) xₙ₊₁ + α_f xₙ
//!   uₙ₊₁ = uₙ + h vₙ + h² [(½−β) aₙ + β aₙ₊₁],   vₙ₊₁ = vₙ + h [(1−γ) aₙ + γ aₙ₊₁]
//!
//! Members: HHT (α_m = 0), Newmark (α_m = α_f = 0), trapezoidal rule (spectral radius one:
//! α_m = α_f = ½, β = ¼, γ = ½, which conserves energy exactly).
//!
//! Besides the family, the backward differences of the published method (Kolesnikov & Kuvshinov,
//! about 2009), with the balance at the end of the step:
//!
//!   vₙ₊₁ = (uₙ₊₁ − uₙ)/h,   aₙ₊₁ = (uₙ₊₁ − 2uₙ + uₙ₋₁)/h² = (vₙ₊₁ − vₙ)/h
//!
//! They are of first order and damp strongly: an oscillator loses the factor 1/√(1 + ω²h²) in
//! amplitude every step.

use crate::error::CoreError;

/// Time-stepping scheme.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Scheme {
    /// Member of the generalised-α family.
    Alpha(AlphaScheme),
    /// One-sided differences.
    BackwardDifference,
}

/// Parameters of a member of the generalised-α family.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct AlphaScheme {
    /// Parameter β of Newmark.
    pub beta: f64,
    /// Parameter γ of Newmark.
    pub gamma: f64,
    /// Weight α_m of the old acceleration in the balance.
    pub alpha_m: f64,
    /// Weight α_f of the old state in the balance.
    pub alpha_f: f64,
}

impl Scheme {
    /// Generalised-α member with the given spectral radius at infinite frequency, 0 ≤ ρ ≤ 1.
    #[must_use]
    pub fn generalised_alpha(radius: f64) -> Self {
        let alpha_m = (2.0 * radius - 1.0) / (radius + 1.0);
        let alpha_f = radius / (radius + 1.0);
        Self::Alpha(AlphaScheme {
            beta: 0.25 * (1.0 - alpha_m + alpha_f).powi(2),
            gamma: 0.5 - alpha_m + alpha_f,
            alpha_m,
            alpha_f,
        })
    }

    /// Hilber–Hughes–Taylor member, 0 ≤ α ≤ 1/3.
    #[must_use]
    pub fn hht(alpha: f64) -> Self {
        Self::Alpha(AlphaScheme {
            beta: 0.25 * (1.0 + alpha) * (1.0 + alpha),
            gamma: 0.5 + alpha,
            alpha_m: 0.0,
            alpha_f: alpha,
        })
    }

    /// Newmark member with the balance at the end of the step.
    #[must_use]
    pub fn newmark(beta: f64, gamma: f64) -> Self {
        Self::Alpha(AlphaScheme {
            beta,
            gamma,
            alpha_m: 0.0,
            alpha_f: 0.0,
        })
    }

    /// Checks that the scheme is implicit and unconditionally stable for linear systems.
    ///
    /// # Errors
    /// [`CoreError::Input`].
    pub fn check(&self) -> Result<(), CoreError> {
        match self {
            Self::Alpha(member) => member.check(),
            Self::BackwardDifference => Ok(()),
        }
    }

    /// Coefficient c of the period error: an undamped oscillator of frequency ω is too slow by the
    /// share c (ωh)² + O((ωh)⁴). `None` where the error is of another order.
    #[must_use]
    pub fn period_error(&self) -> Option<f64> {
        match self {
            Self::Alpha(member) => member.period_error(),
            Self::BackwardDifference => None,
        }
    }

    /// Coefficients for step length `h` in s.
    #[must_use]
    pub fn coefficients(&self, h: f64) -> Coefficients {
        match self {
            Self::Alpha(member) => member.coefficients(h),
            Self::BackwardDifference => Coefficients::backward_difference(h),
        }
    }
}

impl AlphaScheme {
    /// Checks stability: α_m ≤ α_f ≤ ½, γ ≥ ½ − α_m + α_f, β ≥ ½ γ (Chung & Hulbert 1993; Newmark's
    /// 2β ≥ γ ≥ ½).
    fn check(&self) -> Result<(), CoreError> {
        let finite = [self.beta, self.gamma, self.alpha_m, self.alpha_f]
            .iter()
            .all(|v| v.is_finite());
        // Rounding of the parameters must not refuse the limit ρ = 1.
        let slack = 1e-12;
        let stable = self.alpha_m <= self.alpha_f + slack
            && self.alpha_f <= 0.5 + slack
            && self.beta + slack >= 0.5 * self.gamma
            && self.gamma + slack >= 0.5 - self.alpha_m + self.alpha_f;
        if finite && stable {
            return Ok(());
        }
        Err(CoreError::Input {
            array: "scheme",
            reason: format!("{self:?} is not unconditionally stable"),
        })
    }

    /// Coefficient c of the period error. The scheme turns an oscillator by the angle Ω in a step,
    /// and multiplies it by a factor of size 1 + O((ωh)⁴). With u ∝ e^{iΩn} the averages over a
    /// step and its neighbours are powers of e^{iΩ}; their expansion in Ω, put into the balance, is
    /// Ω = ωh (1 − c (ωh)²) with
    ///
    ///   c = ½ (β + ¼ − γ/2 − (γ−½)²/2 + ½ (α_f − α_f² − α_m + α_m²)) − 1/24
    ///
    /// for members of second order, γ = ½ − α_m + α_f; 1/12 for the trapezoidal rule.
    fn period_error(&self) -> Option<f64> {
        let Self {
            beta,
            gamma,
            alpha_m,
            alpha_f,
        } = *self;
        // The parameters are rounded, as in `check`.
        let is_second_order = (gamma - (0.5 - alpha_m + alpha_f)).abs() <= 1e-12;
        let averages = alpha_f * (1.0 - alpha_f) - alpha_m * (1.0 - alpha_m);
        let offset = gamma - 0.5;
        let sum = beta + 0.25 - 0.5 * gamma - 0.5 * offset * offset + 0.5 * averages;
        is_second_order.then_some(0.5 * sum - 1.0 / 24.0)
    }

    fn coefficients(&self, h: f64) -> Coefficients {
        let Self {
            beta,
            gamma,
            alpha_m,
            alpha_f,
        } = *self;
        let (keep_m, keep_f) = (1.0 - alpha_m, 1.0 - alpha_f);
        Coefficients {
            mass: keep_m / (beta * h * h),
            damping: keep_f * gamma / (beta * h),
            stiffness: keep_f,
            acceleration_from_v: -keep_m / (beta * h),
            acceleration_from_a: alpha_m - keep_m * (0.5 / beta - 1.0),
            velocity_from_v: keep_f * (1.0 - gamma / beta) + alpha_f,
            velocity_from_a: keep_f * h * (1.0 - 0.5 * gamma / beta),
            new_a: [1.0 / (beta * h * h), -1.0 / (beta * h), 1.0 - 0.5 / beta],
            new_v: [
                gamma / (beta * h),
                1.0 - gamma / beta,
                h * (1.0 - 0.5 * gamma / beta),
            ],
            old: alpha_f,
        }
    }
}

/// Coefficients of a scheme for one step length.
///
/// With the unknown Δu = uₙ₊₁ − uₙ:  A = mass·M + damping·C + stiffness·K, and
/// a_m = mass·Δu + acceleration_from_v·v + acceleration_from_a·a,
/// v_f = damping·Δu + velocity_from_v·v + velocity_from_a·a,  u_f = stiffness·Δu + u.
#[derive(Debug, Clone, Copy)]
pub struct Coefficients {
    /// Factor of M in A, 1/s².
    pub mass: f64,
    /// Factor of C in A, 1/s.
    pub damping: f64,
    /// Factor of K in A.
    pub stiffness: f64,
    /// Part of a_m that follows from the old velocity, 1/s.
    pub acceleration_from_v: f64,
    /// Part of a_m that follows from the old acceleration.
    pub acceleration_from_a: f64,
    /// Part of v_f that follows from the old velocity.
    pub velocity_from_v: f64,
    /// Part of v_f that follows from the old acceleration, s.
    pub velocity_from_a: f64,
    /// Coefficients of aₙ₊₁ from (Δu, v, a).
    pub new_a: [f64; 3],
    /// Coefficients of vₙ₊₁ from (Δu, v, a).
    pub new_v: [f64; 3],
    /// Weight α_f of the old state in the balance.
    pub old: f64,
}

impl Coefficients {
    /// Coefficients of A = M/h² + C/h + K; a_m = Δu/h² − v/h and v_f = Δu/h, as published.
    fn backward_difference(h: f64) -> Self {
        Self {
            mass: 1.0 / (h * h),
            damping: 1.0 / h,
            stiffness: 1.0,
            acceleration_from_v: -1.0 / h,
            acceleration_from_a: 0.0,
            velocity_from_v: 0.0,
            velocity_from_a: 0.0,
            new_a: [1.0 / (h * h), -1.0 / h, 0.0],
            new_v: [1.0 / h, 0.0, 0.0],
            old: 0.0,
        }
    }

    /// Velocity and acceleration at the end of a step from an increment and the old ones.
    #[inline(always)]
    #[must_use]
    pub fn advance(&self, delta: f64, v: f64, a: f64) -> (f64, f64) {
        (
            self.new_v[0] * delta + self.new_v[1] * v + self.new_v[2] * a,
            self.new_a[0] * delta + self.new_a[1] * v + self.new_a[2] * a,
        )
    }
}
