//! Dense square blocks of a size known at compile time: one block couples two nodes.

/// Square block, row by row.
pub type Block<const D: usize> = [[f64; D]; D];

/// Block of zeros.
#[must_use]
pub fn zero<const D: usize>() -> Block<D> {
    [[0.0; D]; D]
}

/// Adds a product: `y += a x`.
#[inline(always)]
pub fn add_product<const D: usize>(y: &mut [f64; D], a: &Block<D>, x: &[f64; D]) {
    for i in 0..D {
        let mut sum = 0.0;
        for j in 0..D {
            sum += a[i][j] * x[j];
        }
        y[i] += sum;
    }
}

/// Subtracts a transposed product: `y -= aᵀ x`.
#[inline(always)]
pub fn subtract_transposed_product<const D: usize>(y: &mut [f64; D], a: &Block<D>, x: &[f64; D]) {
    let product = transposed_product(a, x);
    for j in 0..D {
        y[j] -= product[j];
    }
}

/// Transposed product `aᵀ x`.
#[inline(always)]
#[must_use]
pub fn transposed_product<const D: usize>(a: &Block<D>, x: &[f64; D]) -> [f64; D] {
    // Pairs shorten the chain of dependent additions; a block of odd size has one row left over. A
    // start with the first pair, not with zero, shortens it by one more.
    let pair = |i: usize, j: usize| a[i][j] * x[i] + a[i + 1][j] * x[i + 1];
    let mut y: [f64; D] = std::array::from_fn(|j| pair(0, j));
    for i in (2..D - D % 2).step_by(2) {
        for j in 0..D {
            y[j] += pair(i, j);
        }
    }
    if D % 2 == 1 {
        for j in 0..D {
            y[j] += a[D - 1][j] * x[D - 1];
        }
    }
    y
}

/// Product `a b`.
#[must_use]
pub fn product<const D: usize>(a: &Block<D>, b: &Block<D>) -> Block<D> {
    let mut c = zero();
    for i in 0..D {
        for k in 0..D {
            for j in 0..D {
                c[i][j] += a[i][k] * b[k][j];
            }
        }
    }
    c
}

/// Subtracts a product: `c -= a bᵀ`.
pub fn subtract_product_transposed<const D: usize>(c: &mut Block<D>, a: &Block<D>, b: &Block<D>) {
    for i in 0..D {
        for j in 0..D {
            let mut sum = 0.0;
            for k in 0..D {
                sum += a[i][k] * b[j][k];
            }
            c[i][j] -= sum;
        }
    }
}

/// Transpose.
#[must_use]
pub fn transpose<const D: usize>(a: &Block<D>) -> Block<D> {
    let mut t = zero();
    for i in 0..D {
        for j in 0..D {
            t[j][i] = a[i][j];
        }
    }
    t
}

/// Smallest pivot, relative to the diagonal it started from, that still counts as stiffness.
/// Rounding leaves about 1e-16; a mechanism of zero stiffness has to be noticed.
const SINGULAR_PIVOT: f64 = 1e-13;

/// Inverse of a symmetric block by LDLᵀ without pivoting, and the number of negative pivots
/// (zero for a positive definite block). `None` when a pivot vanishes.
#[must_use]
pub fn inverse<const D: usize>(a: &Block<D>) -> Option<(Block<D>, usize)> {
    let mut l = *a;
    let mut pivots = [0.0; D];
    let mut negative = 0;
    for j in 0..D {
        let mut pivot = l[j][j];
        for k in 0..j {
            pivot -= l[j][k] * l[j][k] * pivots[k];
        }
        if !pivot.is_finite() || pivot.abs() <= SINGULAR_PIVOT * a[j][j].abs() {
            return None;
        }
        negative += usize::from(pivot < 0.0);
        pivots[j] = pivot;
        for i in j + 1..D {
            let mut sum = a[i][j];
            for k in 0..j {
                sum -= l[i][k] * l[j][k] * pivots[k];
            }
            l[i][j] = sum / pivot;
        }
    }
    let mut inverse = zero();
    for column in 0..D {
        let mut x = [0.0; D];
        x[column] = 1.0;
        for i in 0..D {
            for k in 0..i {
                x[i] -= l[i][k] * x[k];
            }
        }
        for i in 0..D {
            x[i] /= pivots[i];
        }
        for i in (0..D).rev() {
            for k in i + 1..D {
                x[i] -= l[k][i] * x[k];
            }
        }
        for i in 0..D {
            inverse[i][column] = x[i];
        }
    }
    for i in 0..D {
        for j in 0..i {
            let mean = 0.5 * (inverse[i][j] + inverse[j][i]);
            inverse[i][j] = mean;
            inverse[j][i] = mean;
        }
    }
    Some((inverse, negative))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inverse_times_block_is_identity() {
        let a = [[4.0, 1.0, 0.5], [1.0, 3.0, -0.2], [0.5, -0.2, -2.0]];
        let (b, negative) = inverse(&a).expect("regular");
        assert_eq!(negative, 1);
        let c = product(&a, &b);
        for i in 0..3 {
            for j in 0..3 {
                let expected = f64::from(u8::from(i == j));
                assert!(
                    (c[i][j] - expected).abs() < 1e-14,
                    "rounding of a 3×3 product"
                );
            }
        }
    }

    #[test]
    fn transposed_product_takes_blocks_of_odd_size() {
        let a = [[4.0, 1.0, 0.5], [1.0, 3.0, -0.25], [2.0, -1.0, -2.0]];
        let mut y = [1.0, 1.0, 1.0];
        subtract_transposed_product(&mut y, &a, &[1.0, 2.0, 4.0]);
        assert_eq!(y, [-13.0, -2.0, 9.0]);
    }

    #[test]
    fn singular_block_is_noticed() {
        assert!(inverse(&[[1.0, 1.0], [1.0, 1.0]]).is_none());
    }
}
