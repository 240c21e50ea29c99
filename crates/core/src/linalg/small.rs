//! Vectors and square matrices of a few coordinates, as slices; matrices row by row.

/// Scalar product.
#[must_use]
pub fn inner(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(a, b)| a * b).sum()
}

/// Product of a factor and a vector.
#[must_use]
pub fn scaled(factor: f64, x: &[f64]) -> Vec<f64> {
    x.iter().map(|x| x * factor).collect()
}

/// Product of a square matrix and a vector.
#[must_use]
pub fn matrix_vector(a: &[f64], x: &[f64]) -> Vec<f64> {
    let n = x.len();
    (0..n)
        .map(|i| (0..n).map(|j| a[i * n + j] * x[j]).sum())
        .collect()
}

/// Adds a multiple of a vector: sum += factor · x.
pub fn add_scaled(factor: f64, x: &[f64], sum: &mut [f64]) {
    for (sum, x) in sum.iter_mut().zip(x) {
        *sum += factor * x;
    }
}

/// Adds a multiple of an outer product: matrix += factor · d dᵀ.
pub fn add_outer(factor: f64, d: &[f64], matrix: &mut [f64]) {
    let n = d.len();
    for i in 0..n {
        for j in 0..n {
            matrix[i * n + j] += factor * d[i] * d[j];
        }
    }
}
