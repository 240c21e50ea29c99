//! Stops of a rider: one-sided, each with a gap and a stiffness.
//!
//!   0 ≤ σ  ⊥  s + σ/k_s ≥ 0,   s = gap + dᵀ(w − w₀)
//!
//! w is the displacement relative to the ground, w₀ that at the start of the run, and the force d σ
//! acts on the rider, its opposite on the ground where dᵀr is not zero. The law holds at the time of
//! balance, in the same complementarity problem as contacts and links.

use super::rider::inner;
use crate::error::CoreError;
use crate::scheme::Coefficients;

/// A stop. It closes when dᵀw has fallen by `gap`.
#[derive(Debug, Clone)]
pub struct Stop {
    /// d: the motion that opens it.
    pub direction: Vec<f64>,
    /// Opening at the start, m.
    pub gap: f64,
    /// k_s in N/m; infinite when rigid.
    pub stiffness: f64,
}

impl Stop {
    pub(super) fn is_sound(&self, n: usize) -> bool {
        self.direction.len() == n
            && self.direction.iter().all(|v| v.is_finite())
            && self.gap.is_finite()
            && self.gap >= 0.0
            && self.stiffness > 0.0
    }
}

/// A stop during a run.
#[derive(Debug, Clone)]
pub struct StopState {
    pub(super) direction: Vec<f64>,
    /// A⁻¹ d, the response of the increment to a unit force.
    pub(super) column: Vec<f64>,
    /// dᵀ r.
    pub(super) carried: f64,
    /// 1/k_s, m/N.
    flexibility: f64,
    /// dᵀ w where it closes, m.
    closed: f64,
    /// s at the time of balance, without contact forces and stops, m.
    pub(super) free: f64,
    /// σ, N.
    pub force: f64,
}

impl StopState {
    /// From its description, its response and dᵀw₀.
    pub(super) fn new(stop: &Stop, column: Vec<f64>, carried: &[f64], start: f64) -> Self {
        Self {
            direction: stop.direction.clone(),
            column,
            carried: inner(&stop.direction, carried),
            flexibility: 1.0 / stop.stiffness,
            closed: start - stop.gap,
            free: stop.gap,
            force: 0.0,
        }
    }

    /// s for a displacement of the rider and its ground, m.
    pub(super) fn opening(&self, u: &[f64], ground: f64) -> f64 {
        inner(&self.direction, u) - self.carried * ground - self.closed
    }

    /// dᵀA⁻¹d of two stops of one rider, with the compliance when they are the same.
    pub(super) fn response(&self, other: &Self, is_same: bool, c: &Coefficients) -> f64 {
        let compliance = f64::from(u8::from(is_same)) * self.flexibility / c.stiffness;
        inner(&self.direction, &other.column) + compliance
    }

    /// Energy in it, ½ k_s p² with the overlap p, J.
    pub(super) fn energy(&self, u: &[f64], ground: f64) -> f64 {
        if self.flexibility == 0.0 {
            return 0.0;
        }
        0.5 * self.opening(u, ground).min(0.0).powi(2) / self.flexibility
    }
}

/// Smallest pivot that still tells stops apart, as a share of the response of one of them: far above
/// rounding, far below what any stiffness of machinery adds.
const INDEPENDENT: f64 = 1e-9;

/// Refuse rigid stops that block the same motion: their forces would not be unique.
///
/// # Errors
/// [`CoreError::Input`].
pub(super) fn check_independent(stops: &[StopState], c: &Coefficients) -> Result<(), CoreError> {
    let n = stops.len();
    let scale: Vec<f64> = stops
        .iter()
        .map(|s| s.response(s, true, c).sqrt())
        .collect();
    let mut lower = vec![0.0; n * n];
    for i in 0..n {
        for j in 0..=i {
            let known: f64 = (0..j).map(|k| lower[i * n + k] * lower[j * n + k]).sum();
            let rest = stops[i].response(&stops[j], i == j, c) / (scale[i] * scale[j]) - known;
            if i != j {
                lower[i * n + j] = rest / lower[j * n + j];
                continue;
            }
            // Written so that a response of zero or NaN is refused as well.
            if !matches!(
                rest.partial_cmp(&INDEPENDENT),
                Some(std::cmp::Ordering::Greater)
            ) {
                return Err(CoreError::Input {
                    array: "stops",
                    reason: "rigid stops block the same motion".into(),
                });
            }
            lower[i * n + i] = rest.sqrt();
        }
    }
    Ok(())
}
