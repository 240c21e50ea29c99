//! The condensed tableau of principal pivoting and its Jordan exchange.
//!
//! At every moment the table expresses one half of the variables by the other:
//!
//! ```text
//! v = T u + q,     (v_k, u_k) = (y_k, x_k) for an inactive row, (x_k, y_k) for an active one
//! ```
//!
//! With `u = 0` the values of `v` are `q`, and the problem is solved when `q ≥ 0`. Exchanging row
//! `k` with pivot `p = T_kk` (Cottle, Pang & Stone, section 2.3, principal pivotal transform):
//!
//! ```text
//! T_kk ← 1/p      T_kj ← −T_kj/p      q_k ← −q_k/p
//! T_ik ← T_ik/p   T_ij ← T_ij − T_ik T_kj/p      q_i ← q_i − T_ik q_k/p
//! ```
//!
//! The variables are scaled by powers of two so that the diagonal of `H` is about 1. All rows then
//! have the unit √J, one tolerance fits rows of forces, gaps and tensions, and the scaling itself
//! rounds nothing. The energies `q_k²/(2 T_kk)` (J) do not depend on it.

use super::FailureReason;

/// Smallest pivot (scaled, diagonal of `H` about 1) that is distinguished from rounding.
///
/// A pivot of an inactive row is 1 minus the part that the active rows account for; some tens of
/// roundings of 2·10⁻¹⁶ are in it, so a smaller result says nothing about the sign.
pub const PIVOT_MIN: f64 = 1e-14;

/// Smallest pivot taken while entering the warm-start set.
///
/// Larger than [`PIVOT_MIN`]: the order is given there, and a row that is left out costs one pivot
/// later at most, while a tiny pivot spoils the whole table.
pub const WARM_PIVOT_MIN: f64 = 1e-8;

/// Tolerance of feasibility: a value counts as negative below `−FEASIBILITY` times the size of the
/// terms it is the sum of.
///
/// About a hundred times the rounding of such a sum with `n = 40`, and far below anything that
/// matters: 10⁻¹² of a gap of 1 m is a picometre.
pub const FEASIBILITY: f64 = 1e-12;

/// Table `v = T u + q` in scaled variables.
#[derive(Debug, Clone, Default)]
pub struct Tableau {
    n: usize,
    /// Matrix `T`, by rows.
    table: Vec<f64>,
    q: Vec<f64>,
    active: Vec<bool>,
    /// Scale `d_k`, a power of two near `1/√H_kk`: `x = d x̂`, `y = ŷ/d`.
    scale: Vec<f64>,
    /// Copy of the pivot row during an exchange.
    row: Vec<f64>,
    w_max: f64,
    h_max: f64,
}

impl Tableau {
    /// Loads a problem with no row active: `T = Ĥ`, `q = ŵ`.
    pub(super) fn load(&mut self, h: &[f64], w: &[f64]) -> Result<(), FailureReason> {
        let n = w.len();
        self.n = n;
        self.scale.clear();
        for k in 0..n {
            let pivot = h[k * n + k];
            if pivot < f64::MIN_POSITIVE {
                return Err(FailureReason::Pivot { row: k, pivot });
            }
            let exponent = (0.5 * pivot.log2()).round() as i32;
            self.scale.push(2_f64.powi(-exponent));
        }
        self.active.clear();
        self.active.resize(n, false);
        self.fill(h, w);
        self.w_max = max_abs(&self.q);
        self.h_max = max_abs(&self.table);
        Ok(())
    }

    fn fill(&mut self, h: &[f64], w: &[f64]) {
        let (n, d) = (self.n, &self.scale);
        self.table.clear();
        self.q.clear();
        for k in 0..n {
            let row = &h[k * n..(k + 1) * n];
            self.table
                .extend(row.iter().zip(d).map(|(a, d_j)| a * d[k] * d_j));
            self.q.push(w[k] * d[k]);
        }
    }

    /// Activates the rows of `warm`, except where the pivot is too small; returns the number of
    /// exchanges.
    pub(super) fn activate(&mut self, warm: &[bool]) -> usize {
        let mut count = 0;
        for (k, _) in warm.iter().enumerate().filter(|(_, wanted)| **wanted) {
            if !self.active[k] && self.pivot(k) > WARM_PIVOT_MIN {
                self.exchange(k);
                count += 1;
            }
        }
        count
    }

    /// Forms the table again from `H` and `w` for the present active set, with `values` as `q`.
    pub(super) fn renew(
        &mut self,
        h: &[f64],
        w: &[f64],
        values: &[f64],
    ) -> Result<(), FailureReason> {
        self.fill(h, w);
        for k in 0..self.n {
            if self.active[k] {
                self.active[k] = false;
                self.checked_exchange(k)?;
            }
        }
        self.q.copy_from_slice(values);
        Ok(())
    }

    /// Exchanges row `k` if its pivot is positive, as it is in every table of a P-matrix.
    pub(super) fn checked_exchange(&mut self, k: usize) -> Result<(), FailureReason> {
        let pivot = self.pivot(k);
        if pivot > PIVOT_MIN && pivot.is_finite() {
            self.exchange(k);
            Ok(())
        } else {
            Err(FailureReason::Pivot { row: k, pivot })
        }
    }

    fn exchange(&mut self, k: usize) {
        let n = self.n;
        let inverse = 1.0 / self.pivot(k);
        self.row.clear();
        self.row.extend_from_slice(&self.table[k * n..(k + 1) * n]);
        let q_k = self.q[k];
        for i in (0..n).filter(|i| *i != k) {
            let row_i = &mut self.table[i * n..(i + 1) * n];
            let factor = row_i[k] * inverse;
            if factor != 0.0 {
                for (a, b) in row_i.iter_mut().zip(&self.row) {
                    *a -= factor * b;
                }
                self.q[i] -= factor * q_k;
            }
            row_i[k] = factor;
        }
        for (a, b) in self.table[k * n..(k + 1) * n].iter_mut().zip(&self.row) {
            *a = -b * inverse;
        }
        self.table[k * n + k] = inverse;
        self.q[k] = -q_k * inverse;
        self.active[k] = !self.active[k];
    }

    /// Thresholds below which `x̂` (active rows) and `ŷ` (inactive rows) count as negative.
    ///
    /// `ŷ` is a sum of terms up to `max |ŵ| + max |Ĥ| max |x̂|`; `x̂` multiplies at most `max |Ĥ|`
    /// there.
    pub(super) fn thresholds(&self, values: &[f64]) -> (f64, f64) {
        let x_max = (0..self.n)
            .filter(|k| self.active[*k])
            .fold(0.0, |m: f64, k| m.max(values[k].abs()));
        let inactive = -FEASIBILITY * (self.w_max + self.h_max * x_max);
        (inactive / self.h_max.max(1.0), inactive)
    }

    pub(super) fn pivot(&self, k: usize) -> f64 {
        self.table[k * self.n + k]
    }

    pub(super) fn size(&self) -> usize {
        self.n
    }

    pub(super) fn values(&self) -> &[f64] {
        &self.q
    }

    pub(super) fn active(&self) -> &[bool] {
        &self.active
    }

    pub(super) fn scale(&self) -> &[f64] {
        &self.scale
    }
}

fn max_abs(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |m, v| v.abs().max(m))
}
