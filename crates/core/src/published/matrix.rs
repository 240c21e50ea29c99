//! Small matrices by rows, and the checks of what is given to a step.

use crate::error::CoreError;

/// Largest accepted difference of two entries that symmetry makes equal, relative to the diagonal of
/// A: sums of element matrices differ by 10⁻¹⁴, a wrong entry by far more.
const SYMMETRY: f64 = 1e-10;

/// Matrix by rows.
#[derive(Debug, Clone, PartialEq)]
pub struct Matrix {
    /// Number of rows.
    pub rows: usize,
    /// Number of columns.
    pub columns: usize,
    /// Entries, row after row.
    pub values: Vec<f64>,
}

impl Matrix {
    /// From its entries; the number of columns follows from that of the rows.
    ///
    /// # Errors
    /// [`CoreError::Input`] with the name of the `array` when the entries are not `rows × columns`
    /// finite numbers.
    pub fn new(
        array: &'static str,
        rows: usize,
        columns: usize,
        values: Vec<f64>,
    ) -> Result<Self, CoreError> {
        let Some(length) = rows.checked_mul(columns) else {
            return refuse(array, format!("{rows} × {columns} entries"));
        };
        finite(array, &values, length)?;
        Ok(Self {
            rows,
            columns,
            values,
        })
    }

    /// Entry of row `i` and column `j`.
    #[must_use]
    pub fn at(&self, i: usize, j: usize) -> f64 {
        self.values[i * self.columns + j]
    }

    /// Product with a vector.
    #[must_use]
    pub fn times(&self, x: &[f64]) -> Vec<f64> {
        let entry = |i| (0..self.columns).map(|j| self.at(i, j) * x[j]).sum();
        (0..self.rows).map(entry).collect()
    }

    pub(super) fn product(&self, other: &Self) -> Self {
        Self::filled(self.rows, other.columns, |i, j| {
            (0..self.columns)
                .map(|k| self.at(i, k) * other.at(k, j))
                .sum()
        })
    }

    pub(super) fn filled(rows: usize, columns: usize, entry: impl Fn(usize, usize) -> f64) -> Self {
        let values = (0..rows * columns)
            .map(|k| entry(k / columns, k % columns))
            .collect();
        Self {
            rows,
            columns,
            values,
        }
    }
}

pub(super) fn square(array: &'static str, matrix: &Matrix, size: usize) -> Result<(), CoreError> {
    if (matrix.rows, matrix.columns) == (size, size) {
        return finite(array, &matrix.values, size * size);
    }
    let reason = format!(
        "{} × {} entries, expected {size} × {size}",
        matrix.rows, matrix.columns
    );
    refuse(array, reason)
}

/// Symmetry of `matrix`, which enters A with `factor`, measured in units of A's diagonal.
pub(super) fn symmetric(
    array: &'static str,
    matrix: &Matrix,
    factor: f64,
    a: &Matrix,
) -> Result<(), CoreError> {
    for i in 0..matrix.rows {
        for j in 0..i {
            let (one, other) = (matrix.at(i, j), matrix.at(j, i));
            let unit = (a.at(i, i) * a.at(j, j)).abs().sqrt();
            if factor * (one - other).abs() > SYMMETRY * unit {
                let reason = format!(
                    "not symmetric: entry ({j}, {i}) is {other} and entry ({i}, {j}) is {one}"
                );
                return refuse(array, reason);
            }
        }
    }
    Ok(())
}

pub(super) fn finite(array: &'static str, values: &[f64], length: usize) -> Result<(), CoreError> {
    if values.len() != length {
        let reason = format!("{} entries, expected {length}", values.len());
        return refuse(array, reason);
    }
    match values.iter().position(|v| !v.is_finite()) {
        None => Ok(()),
        Some(k) => refuse(array, format!("entry {k} is {}", values[k])),
    }
}

pub(super) fn refuse<T>(array: &'static str, reason: String) -> Result<T, CoreError> {
    Err(CoreError::Input { array, reason })
}
