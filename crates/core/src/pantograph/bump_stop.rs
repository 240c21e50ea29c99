//! Stops of a rider: one-sided, each with a gap and a stiffness.
//!
//!   0 ≤ σ  ⊥  s + σ/k_s ≥ 0,   s = gap + dᵀ(w − w₀)
//!
//! w is the displacement relative to the ground, w₀ that at the start of the run, and the force d σ
//! acts on the rider, its opposite on the ground where dᵀr is not zero. A stop is the hardening
//! [kink](crate::pantograph::breakpoint) of a spring that is not there before.

use crate::error::CoreError;
use crate::pantograph::breakpoint::{Breakpoint, ForceKind, RelativeCoordinate};
use crate::pantograph::system::{inner, multiply};
use crate::scheme::Coefficients;

/// A stop. It closes when dᵀw has fallen by `gap`.
#[derive(Debug, Clone)]
pub struct BumpStop {
    /// d: the motion that opens it.
    pub direction: Vec<f64>,
    /// Opening at the start, m.
    pub gap: f64,
    /// k_s in N/m; infinite when rigid.
    pub stiffness: f64,
}

impl BumpStop {
    pub(crate) fn is_sound(&self, n: usize) -> bool {
        self.direction.len() == n
            && self.direction.iter().all(|v| v.is_finite())
            && self.gap.is_finite()
            && self.gap >= 0.0
            && self.stiffness > 0.0
    }

    /// It during a run, from the inverse matrix of the scheme, the ground (what goes with it, and its
    /// displacement) and the displacements at the start.
    pub(crate) fn kink(
        &self,
        c: &Coefficients,
        inverse: &[f64],
        (carried, ground): (&[f64], f64),
        u: &[f64],
    ) -> Breakpoint {
        let gauge = RelativeCoordinate {
            direction: self.direction.clone(),
            carried: inner(&self.direction, carried),
            motion: ForceKind::Spring,
        };
        Breakpoint {
            column: multiply(inverse, &self.direction),
            closed: gauge.place(u, ground) - self.gap,
            gauge,
            sign: 1.0,
            factor: c.stiffness,
            flexibility: 1.0 / self.stiffness,
            law: None,
            is_in: true,
            free: self.gap,
            force: 0.0,
        }
    }
}

/// Smallest pivot that still tells stops apart, as a share of the response of one of them: far above
/// rounding, far below what any stiffness of machinery adds.
const INDEPENDENT: f64 = 1e-9;

/// Refuse rigid stops that block the same motion: their forces would not be unique.
///
/// # Errors
/// [`CoreError::Input`].
pub(crate) fn check_independent(stops: &[Breakpoint]) -> Result<(), CoreError> {
    let n = stops.len();
    let scale: Vec<f64> = stops.iter().map(|s| s.response(s, true).sqrt()).collect();
    let mut lower = vec![0.0; n * n];
    for i in 0..n {
        for j in 0..=i {
            let known: f64 = (0..j).map(|k| lower[i * n + k] * lower[j * n + k]).sum();
            let rest = stops[i].response(&stops[j], i == j) / (scale[i] * scale[j]) - known;
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
