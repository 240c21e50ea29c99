//! Small dense systems (a few dozen unknowns at most), row by row.

/// Solves `A x = b` in place by Gaussian elimination with partial pivoting; `a` is destroyed and
/// `b` becomes `x`. Returns `false` when `A` is singular to working precision.
#[must_use]
pub fn solve_in_place(a: &mut [f64], b: &mut [f64]) -> bool {
    let n = b.len();
    debug_assert_eq!(a.len(), n * n);
    for k in 0..n {
        let pivot = (k..n).max_by(|&i, &j| a[i * n + k].abs().total_cmp(&a[j * n + k].abs()));
        let Some(p) = pivot else { return false };
        if a[p * n + k] == 0.0 || !a[p * n + k].is_finite() {
            return false;
        }
        if p != k {
            for j in 0..n {
                a.swap(p * n + j, k * n + j);
            }
            b.swap(p, k);
        }
        for i in k + 1..n {
            let factor = a[i * n + k] / a[k * n + k];
            for j in k..n {
                a[i * n + j] -= factor * a[k * n + j];
            }
            b[i] -= factor * b[k];
        }
    }
    for i in (0..n).rev() {
        for j in i + 1..n {
            b[i] -= a[i * n + j] * b[j];
        }
        b[i] /= a[i * n + i];
    }
    b.iter().all(|x| x.is_finite())
}

/// Inverse of a small matrix; `None` when singular.
#[must_use]
pub fn inverse(a: &[f64], n: usize) -> Option<Vec<f64>> {
    let mut inverse = vec![0.0; n * n];
    for column in 0..n {
        let mut copy = a.to_vec();
        let mut b = vec![0.0; n];
        b[column] = 1.0;
        if !solve_in_place(&mut copy, &mut b) {
            return None;
        }
        for i in 0..n {
            inverse[i * n + column] = b[i];
        }
    }
    Some(inverse)
}

/// Cholesky's lower factor of a symmetric matrix; `None` when that is not positive definite.
#[must_use]
pub fn cholesky(a: &[f64], n: usize) -> Option<Vec<f64>> {
    let mut lower = vec![0.0; n * n];
    for i in 0..n {
        for j in 0..=i {
            let known: f64 = (0..j).map(|k| lower[i * n + k] * lower[j * n + k]).sum();
            let reduced = a[i * n + j] - known;
            lower[i * n + j] = if i == j {
                reduced.sqrt()
            } else {
                reduced / lower[j * n + j]
            };
        }
        if !(lower[i * n + i].is_finite() && lower[i * n + i] > 0.0) {
            return None;
        }
    }
    Some(lower)
}

/// Solves `L Lᵀ x = b` in place.
pub fn solve_cholesky(lower: &[f64], b: &mut [f64]) {
    let n = b.len();
    for i in 0..n {
        let known: f64 = (0..i).map(|k| lower[i * n + k] * b[k]).sum();
        b[i] = (b[i] - known) / lower[i * n + i];
    }
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|k| lower[k * n + i] * b[k]).sum();
        b[i] = (b[i] - known) / lower[i * n + i];
    }
}

/// Tells whether a symmetric matrix is positive definite to working precision: Cholesky's pivots,
/// each above the rounding of what was subtracted from it.
#[must_use]
pub fn is_positive(a: &[f64], n: usize) -> bool {
    let mut lower = vec![0.0; n * n];
    for i in 0..n {
        for j in 0..=i {
            let known: f64 = (0..j).map(|k| lower[i * n + k] * lower[j * n + k]).sum();
            let reduced = a[i * n + j] - known;
            if i != j {
                lower[i * n + j] = reduced / lower[j * n + j];
            } else if reduced > 4.0 * n as f64 * f64::EPSILON * (a[i * n + i].abs() + known) {
                lower[i * n + i] = reduced.sqrt();
            } else {
                return false;
            }
        }
    }
    true
}

/// Eigenvalues (ascending) of a symmetric tridiagonal matrix by bisection with Sturm counts.
/// Source: Golub & Van Loan, Matrix Computations, section 8.4.
#[must_use]
pub fn tridiagonal_eigenvalues(diagonal: &[f64], off: &[f64]) -> Vec<f64> {
    let n = diagonal.len();
    let radius = |i: usize| {
        let left = if i > 0 { off[i - 1].abs() } else { 0.0 };
        let right = if i + 1 < n { off[i].abs() } else { 0.0 };
        left + right
    };
    let low = (0..n)
        .map(|i| diagonal[i] - radius(i))
        .fold(f64::INFINITY, f64::min);
    let high = (0..n)
        .map(|i| diagonal[i] + radius(i))
        .fold(f64::NEG_INFINITY, f64::max);
    let below = |x: f64| {
        let mut count = 0;
        let mut q = 1.0_f64;
        for i in 0..n {
            let coupling = if i > 0 {
                off[i - 1] * off[i - 1] / q
            } else {
                0.0
            };
            q = diagonal[i] - x - coupling;
            if q == 0.0 {
                q = f64::EPSILON * (low.abs() + high.abs());
            }
            count += usize::from(q < 0.0);
        }
        count
    };
    (0..n)
        .map(|k| {
            let (mut a, mut b) = (low, high);
            // 100 halvings shrink any interval to the spacing of floating-point numbers.
            for _ in 0..100 {
                let middle = 0.5 * (a + b);
                if below(middle) > k {
                    b = middle
                } else {
                    a = middle
                }
            }
            0.5 * (a + b)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tridiagonal_of_a_string() {
        // Second difference matrix: 2 − 2 cos(kπ/(n+1)).
        let n = 12;
        let values = tridiagonal_eigenvalues(&vec![2.0; n], &vec![-1.0; n - 1]);
        for (k, value) in values.iter().enumerate() {
            let angle = (k + 1) as f64 * std::f64::consts::PI / (n + 1) as f64;
            assert!(
                (value - (2.0 - 2.0 * angle.cos())).abs() < 1e-13,
                "rounding"
            );
        }
    }

    #[test]
    fn solve_needs_a_row_exchange() {
        let mut a = vec![0.0, 2.0, 1.0, 1.0];
        let mut b = vec![4.0, 3.0];
        assert!(solve_in_place(&mut a, &mut b));
        assert_eq!(b, vec![1.0, 2.0]);
        assert!(!solve_in_place(&mut [1.0, 1.0, 1.0, 1.0], &mut [1.0, 2.0]));
    }
}
