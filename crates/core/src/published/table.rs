//! Steps 6 to 11: the table of a step and its block Jordan exchange.

use super::matrix::Matrix;
use crate::error::CoreError;
use crate::lcp::PIVOT_MIN;

/// A table of four blocks and a column of constants: two vectors expressed by two others.
///
/// ```text
/// [upper]   [ upper_left  upper_right ] [left ]   [upper_constant]
/// [lower] = [ lower_left  lower_right ] [right] + [lower_constant]
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct BlockTable {
    /// A in table 1, A⁻¹ in table 2.
    pub upper_left: Matrix,
    /// −C in table 1, A⁻¹C in table 2.
    pub upper_right: Matrix,
    /// Cᵀ in table 1, CᵀA⁻¹ in table 2.
    pub lower_left: Matrix,
    /// 0 in table 1, CᵀA⁻¹C in table 2.
    pub lower_right: Matrix,
    /// p̂_i in table 1, −A⁻¹p̂_i in table 2.
    pub upper_constant: Vec<f64>,
    /// d0 in table 1, d0 − CᵀA⁻¹p̂_i in table 2.
    pub lower_constant: Vec<f64>,
}

/// **Step 6**, table 1:
///
/// ```text
/// [R_i]   [ A   −C ] [u_i]   [p̂_i]
/// [d_i] = [ Cᵀ   0 ] [n_i] + [d0 ]
/// ```
#[must_use]
pub fn table_1(a: &Matrix, contact_map: &Matrix, p_hat: Vec<f64>, d0: &[f64]) -> BlockTable {
    let (c, n, m) = (contact_map, contact_map.rows, contact_map.columns);
    BlockTable {
        upper_left: a.clone(),
        upper_right: Matrix::filled(n, m, |i, j| -c.at(i, j)),
        lower_left: Matrix::filled(m, n, |i, j| c.at(j, i)),
        lower_right: Matrix::filled(m, m, |_, _| 0.0),
        upper_constant: p_hat,
        lower_constant: d0.to_vec(),
    }
}

impl BlockTable {
    /// **Step 7**, block Jordan exchange: `upper` and `left` change places. From table 1 it leads to
    /// table 2, where the variables that must vanish, all of R, stand on the right:
    ///
    /// ```text
    /// [u_i]   [ A⁻¹      A⁻¹C   ] [R_i]   [ −A⁻¹p̂_i        ]
    /// [d_i] = [ CᵀA⁻¹    CᵀA⁻¹C ] [n_i] + [ d0 − CᵀA⁻¹p̂_i  ]
    /// ```
    ///
    /// `inverse` is that of `upper_left`, the pivot block. For blocks T and constants q the rule is
    /// that of single rows ([`exchange_row`]), with the pivot's inverse in place of a division:
    ///
    /// ```text
    /// T_kk ← P      T_kj ← −P T_kj      q_k ← −P q_k      P = T_kk⁻¹
    /// T_ik ← T_ik P  T_ij ← T_ij − T_ik P T_kj   q_i ← q_i − T_ik P q_k
    /// ```
    #[must_use]
    pub fn exchange(self, inverse: &Matrix) -> Self {
        let upper_right = negative(inverse.product(&self.upper_right));
        let mut lower_right = self.lower_left.product(&upper_right);
        add(&mut lower_right.values, &self.lower_right.values);
        let upper_constant: Vec<f64> = inverse
            .times(&self.upper_constant)
            .iter()
            .map(|v| -v)
            .collect();
        let mut lower_constant = self.lower_left.times(&upper_constant);
        add(&mut lower_constant, &self.lower_constant);
        Self {
            upper_left: inverse.clone(),
            lower_left: self.lower_left.product(inverse),
            upper_right,
            lower_right,
            upper_constant,
            lower_constant,
        }
    }

    /// **Step 9** `H = CᵀA⁻¹C` of table 2: symmetric, positive definite.
    #[must_use]
    pub fn h(&self) -> &Matrix {
        &self.lower_right
    }

    /// **Step 10** `w = d0 − CᵀA⁻¹p̂_i` of table 2.
    #[must_use]
    pub fn w(&self) -> &[f64] {
        &self.lower_constant
    }

    /// **Step 11** `u_i = A⁻¹C n_i − A⁻¹p̂_i`: the upper row of table 2 with R_i = 0.
    #[must_use]
    pub fn displacements(&self, force: &[f64]) -> Vec<f64> {
        let mut u = self.upper_right.times(force);
        add(&mut u, &self.upper_constant);
        u
    }
}

/// Jordan exchange of one row and one column with the same number `k`; columns beyond the square
/// part are constants.
///
/// `T_kk ← 1/p,  T_kj ← −T_kj/p,  T_ik ← T_ik/p,  T_ij ← T_ij − T_ik T_kj/p` with `p = T_kk`.
pub fn exchange_row(table: &mut Matrix, k: usize) {
    let (columns, inverse) = (table.columns, 1.0 / table.at(k, k));
    let row = table.values[k * columns..(k + 1) * columns].to_vec();
    for (i, other) in table.values.chunks_exact_mut(columns).enumerate() {
        let entry = other[k];
        for (j, value) in other.iter_mut().enumerate() {
            // Product before division: a symmetric table stays symmetric to the last bit.
            *value = match (i == k, j == k) {
                (true, true) => inverse,
                (true, false) => -row[j] * inverse,
                (false, true) => entry * inverse,
                (false, false) => *value - entry * row[j] * inverse,
            };
        }
    }
}

/// `A⁻¹` by exchanging all rows of A in turn. Every pivot of a positive definite matrix is positive.
pub(super) fn inverse(a: &Matrix) -> Result<Matrix, CoreError> {
    let mut table = a.clone();
    for k in 0..a.rows {
        let pivot = table.at(k, k);
        // Below the crate's limit for pivots rounding decides about the sign. Written for NaN, too.
        if !(pivot > PIVOT_MIN * a.at(k, k).abs() && pivot.is_finite()) {
            let reason = format!(
                "M/τ² + C_d/τ + K is not positive definite: pivot {pivot:e} in row {k}, diagonal {:e}",
                a.at(k, k)
            );
            return Err(CoreError::Input { array: "A", reason });
        }
        exchange_row(&mut table, k);
    }
    Ok(table)
}

fn negative(mut matrix: Matrix) -> Matrix {
    matrix.values.iter_mut().for_each(|v| *v = -*v);
    matrix
}

fn add(target: &mut [f64], other: &[f64]) {
    target.iter_mut().zip(other).for_each(|(a, b)| *a += b);
}
