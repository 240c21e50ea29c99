//! Checks independent of the solver: of the input before, of the solution after.

use super::FailureReason;

/// Checks that lengths fit together and numbers are finite.
pub(super) fn input(
    h: &[f64],
    w: &[f64],
    x: &[f64],
    y: &[f64],
    warm: &[bool],
) -> Result<(), FailureReason> {
    let n = w.len();
    length("matrix H", h.len(), n * n)?;
    length("vector x", x.len(), n)?;
    length("vector y", y.len(), n)?;
    if !warm.is_empty() {
        length("warm start", warm.len(), n)?;
    }
    finite("matrix H", h)?;
    finite("vector w", w)
}

fn length(array: &'static str, got: usize, expected: usize) -> Result<(), FailureReason> {
    if got == expected {
        Ok(())
    } else {
        Err(FailureReason::Shape {
            array,
            got,
            expected,
        })
    }
}

fn finite(array: &'static str, values: &[f64]) -> Result<(), FailureReason> {
    match values.iter().position(|value| !value.is_finite()) {
        None => Ok(()),
        Some(position) => Err(FailureReason::NotFinite { array, position }),
    }
}

/// Violation by `x`, `y` of `y = Hx + w`, `x ≥ 0`, `y ≥ 0`, `xᵀy = 0`; zero for an exact solution.
///
/// Rows are brought to one unit, √J, by the diagonal of `H`: `x̂_k = x_k √H_kk`, `ŷ_k = y_k /
/// √H_kk`. Returned is the largest of `|ŷ − Ĥx̂ − ŵ|_k`, `−x̂_k`, `−ŷ_k` and `min(x̂_k, ŷ_k)`,
/// divided by the size of the terms that cancel in the equation, `max |ŵ| + max |Ĥ| max |x̂|`. NaN
/// when any entry is NaN or a diagonal entry of `H` is not positive.
#[must_use]
pub fn residual(h: &[f64], w: &[f64], x: &[f64], y: &[f64]) -> f64 {
    let n = w.len();
    let root = |k: usize| h[k * n + k].sqrt();
    let (mut worst, mut w_max, mut x_max, mut h_max) = (0.0, 0.0, 0.0, 0.0);
    for k in 0..n {
        let row = &h[k * n..(k + 1) * n];
        let sum: f64 = row.iter().zip(x).map(|(a, b)| a * b).sum();
        let (x_k, y_k) = (x[k] * root(k), y[k] / root(k));
        let defect = (y[k] - sum - w[k]).abs() / root(k);
        for violation in [defect, -x_k, -y_k, x_k.min(y_k)] {
            worst = larger(worst, violation);
        }
        w_max = larger(w_max, w[k].abs() / root(k));
        x_max = larger(x_max, x_k.abs());
        for (j, a) in row.iter().enumerate() {
            h_max = larger(h_max, a.abs() / (root(k) * root(j)));
        }
    }
    if worst == 0.0 {
        0.0
    } else {
        worst / (w_max + h_max * x_max)
    }
}

/// Maximum of two numbers that keeps a NaN, which `f64::max` would drop.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}
