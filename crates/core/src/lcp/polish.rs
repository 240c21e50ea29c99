//! The solution for a known active set, from the original `H` and `w`.
//!
//! With the rows `A` active, `x_A = −H_AA⁻¹ w_A`, `x_I = 0`, `y_A = 0`, `y_I = w_I + H_IA x_A`. The
//! rounding that the exchanges have gathered in the table does not enter: `H_AA` is factorised with
//! row interchanges, and one step of iterative refinement makes the residual as small as the
//! numbers allow.

use super::FailureReason;
use super::tableau::Tableau;

/// Workspace and result of the direct solve, in the scaled variables of the tableau.
#[derive(Debug, Clone, Default)]
pub struct DirectSolve {
    rows: Vec<usize>,
    factor: Vec<f64>,
    order: Vec<usize>,
    right: Vec<f64>,
    solution: Vec<f64>,
    /// Values `x̂_k` of active rows, `ŷ_k` of inactive ones: the exact counterpart of `q`.
    values: Vec<f64>,
    active: Vec<bool>,
}

impl DirectSolve {
    pub(super) fn solve(
        &mut self,
        h: &[f64],
        w: &[f64],
        tableau: &Tableau,
    ) -> Result<(), FailureReason> {
        let (n, d) = (w.len(), tableau.scale());
        self.active.clear();
        self.active.extend_from_slice(tableau.active());
        self.rows.clear();
        self.rows.extend((0..n).filter(|k| tableau.active()[*k]));
        self.factorise(h, d)?;
        self.solution.clear();
        self.solution.resize(self.rows.len(), 0.0);
        for _ in 0..2 {
            self.right.clear();
            for &i in &self.rows {
                let sum = self.row_sum(&h[i * n..(i + 1) * n], d);
                self.right.push(-(w[i] + sum) * d[i]);
            }
            self.substitute();
            for (x, dx) in self.solution.iter_mut().zip(&self.right) {
                *x += dx;
            }
        }
        self.values.clear();
        for i in 0..n {
            let sum = self.row_sum(&h[i * n..(i + 1) * n], d);
            self.values.push((w[i] + sum) * d[i]);
        }
        for (&i, x) in self.rows.iter().zip(&self.solution) {
            self.values[i] = *x;
        }
        Ok(())
    }

    /// Sum `Σ_j H_ij x_j` over the active columns, unscaled.
    fn row_sum(&self, row: &[f64], d: &[f64]) -> f64 {
        self.rows
            .iter()
            .zip(&self.solution)
            .map(|(&j, x)| row[j] * d[j] * x)
            .sum()
    }

    /// Factorises `Ĥ_AA = P L U` with row interchanges, in place.
    fn factorise(&mut self, h: &[f64], d: &[f64]) -> Result<(), FailureReason> {
        let (n, m) = (d.len(), self.rows.len());
        self.factor.clear();
        for &i in &self.rows {
            self.factor
                .extend(self.rows.iter().map(|&j| h[i * n + j] * d[i] * d[j]));
        }
        self.order.clear();
        for k in 0..m {
            let size = |i: &usize| self.factor[i * m + k].abs();
            let p = (k + 1..m).fold(k, |best, i| if size(&i) > size(&best) { i } else { best });
            self.order.push(p);
            if p != k {
                let (upper, lower) = self.factor.split_at_mut(p * m);
                upper[k * m..(k + 1) * m].swap_with_slice(&mut lower[..m]);
            }
            let pivot = self.factor[k * m + k];
            if pivot == 0.0 {
                return Err(FailureReason::Pivot {
                    row: self.rows[k],
                    pivot,
                });
            }
            let (upper, lower) = self.factor.split_at_mut((k + 1) * m);
            let pivot_row = &upper[k * m + k..];
            for row in lower.chunks_exact_mut(m) {
                let multiplier = row[k] / pivot;
                row[k] = multiplier;
                for (a, b) in row[k + 1..].iter_mut().zip(&pivot_row[1..]) {
                    *a -= multiplier * b;
                }
            }
        }
        Ok(())
    }

    /// Replaces `right` by the solution of `P L U z = right`.
    fn substitute(&mut self) {
        let (m, z, lu) = (self.order.len(), &mut self.right, &self.factor);
        for k in 0..m {
            z.swap(k, self.order[k]);
        }
        for i in 0..m {
            let sum: f64 = (0..i).map(|j| lu[i * m + j] * z[j]).sum();
            z[i] -= sum;
        }
        for i in (0..m).rev() {
            let sum: f64 = (i + 1..m).map(|j| lu[i * m + j] * z[j]).sum();
            z[i] = (z[i] - sum) / lu[i * m + i];
        }
    }

    /// Tells whether a value is negative beyond rounding, so that the active set was wrong.
    pub(super) fn contradicts(&self, tableau: &Tableau) -> bool {
        let (active_limit, inactive_limit) = tableau.thresholds(&self.values);
        self.values.iter().zip(&self.active).any(|(value, active)| {
            *value
                < if *active {
                    active_limit
                } else {
                    inactive_limit
                }
        })
    }

    /// Writes non-negative, complementary `x` and `y` in the units of the caller.
    pub(super) fn write(&self, d: &[f64], x: &mut [f64], y: &mut [f64]) {
        for k in 0..self.values.len() {
            let value = if self.values[k] <= 0.0 {
                0.0
            } else {
                self.values[k]
            };
            (x[k], y[k]) = if self.active[k] {
                (value * d[k], 0.0)
            } else {
                (0.0, value / d[k])
            };
        }
    }

    pub(super) fn values(&self) -> &[f64] {
        &self.values
    }
}
