//! Bump stops of a pantograph: one-sided, each with a gap and a stiffness.
//!
//!   0 ≤ σ  ⊥  s + σ/k_s ≥ 0,   s = gap + dᵀ(w − w₀)
//!
//! w is the displacement relative to the base, w₀ that at the start of the run, and the force d σ
//! acts on the pantograph, its opposite on the base where dᵀr is not zero. A stop is the hardening
//! [breakpoint](crate::pantograph::breakpoint) of a spring without force before it.

use crate::error::CoreError;
use crate::linalg::small::{inner, matrix_vector};
use crate::pantograph::breakpoint::{Breakpoint, ForceKind, RelativeCoordinate};
use crate::scheme::Coefficients;

/// Bump stop, which closes when dᵀw has fallen by `gap`.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct BumpStop {
    /// Direction d of the motion that opens it.
    pub direction: Vec<f64>,
    /// Opening at the start, m.
    pub gap: f64,
    /// Stiffness k_s, N/m; infinite when rigid.
    pub stiffness: f64,
}

impl BumpStop {
    /// Tells whether sizes and numbers fit a pantograph of `n` coordinates.
    pub(crate) fn is_valid(&self, n: usize) -> bool {
        self.direction.len() == n
            && self.direction.iter().all(|v| v.is_finite())
            && self.gap.is_finite()
            && self.gap >= 0.0
            && self.stiffness > 0.0
    }

    /// Breakpoint of this stop during a run. `inverse`: A⁻¹ of the pantograph; `base`: influence
    /// vector r and displacement z₀ of the base; `u`: initial displacements, m.
    pub(crate) fn breakpoint(
        &self,
        c: &Coefficients,
        inverse: &[f64],
        (influence, base): (&[f64], f64),
        u: &[f64],
    ) -> Breakpoint {
        let coordinate = RelativeCoordinate {
            direction: self.direction.clone(),
            influence: inner(&self.direction, influence),
            kind: ForceKind::Spring,
        };
        Breakpoint {
            column: matrix_vector(inverse, &self.direction),
            threshold: coordinate.displacement(u, base) - self.gap,
            coordinate,
            sign: 1.0,
            factor: c.stiffness,
            flexibility: 1.0 / self.stiffness,
            branch_of: None,
            active: true,
            predicted_opening: self.gap,
            force: 0.0,
        }
    }
}

/// Smallest pivot of stops that are independent, as a share of the response of one of them: far
/// above rounding, far below the contribution of any stiffness of machinery.
const INDEPENDENT: f64 = 1e-9;

/// Refuses rigid stops that block the same motion: their forces would not be unique.
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
            let reduced = stops[i].response(&stops[j], i == j) / (scale[i] * scale[j]) - known;
            if i != j {
                lower[i * n + j] = reduced / lower[j * n + j];
                continue;
            }
            // Written so that a response of zero or NaN is refused as well.
            if !matches!(
                reduced.partial_cmp(&INDEPENDENT),
                Some(std::cmp::Ordering::Greater)
            ) {
                return Err(CoreError::invalid(
                    "stops",
                    "rigid stops block the same motion",
                ));
            }
            lower[i * n + i] = reduced.sqrt();
        }
    }
    Ok(())
}
