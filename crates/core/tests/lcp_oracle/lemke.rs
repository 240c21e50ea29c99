//! Lemke's complementary pivot algorithm (Cottle, Pang & Stone, section 4.4), plain and dense.

use super::Problem;

/// `x` of the solution, or `None` on a ray or after `50 n` pivots.
///
/// Table of `y − Hx − e z₀ = w`; columns: `y` (0..n), `x` (n..2n), `z₀` (2n), right-hand side.
pub fn solve(p: &Problem) -> Option<Vec<f64>> {
    let n = p.n();
    let width = 2 * n + 2;
    let mut t = vec![vec![0.0; width]; n];
    for (i, row) in t.iter_mut().enumerate() {
        row[i] = 1.0;
        for j in 0..n {
            row[n + j] = -p.h[i * n + j];
        }
        row[2 * n] = -1.0;
        row[2 * n + 1] = p.w[i];
    }
    let mut basis: Vec<usize> = (0..n).collect();
    let mut row = (0..n).min_by(|a, b| p.w[*a].total_cmp(&p.w[*b]))?;
    if p.w[row] >= 0.0 {
        return Some(vec![0.0; n]);
    }
    let mut entering = 2 * n;
    for _ in 0..50 * n {
        exchange(&mut t, row, entering);
        let leaving = std::mem::replace(&mut basis[row], entering);
        if leaving == 2 * n {
            return Some(read(&t, &basis));
        }
        entering = if leaving < n {
            leaving + n
        } else {
            leaving - n
        };
        row = ratio_test(&t, &basis, entering)?;
    }
    None
}

fn exchange(t: &mut [Vec<f64>], k: usize, column: usize) {
    let pivot = t[k][column];
    t[k].iter_mut().for_each(|v| *v /= pivot);
    let pivot_row = t[k].clone();
    for (i, row) in t.iter_mut().enumerate() {
        let factor = row[column];
        if i != k && factor != 0.0 {
            row.iter_mut()
                .zip(&pivot_row)
                .for_each(|(a, b)| *a -= factor * b);
        }
    }
}

/// Smallest ratio; on a tie `z₀` leaves, else the lowest row.
fn ratio_test(t: &[Vec<f64>], basis: &[usize], column: usize) -> Option<usize> {
    let n = basis.len();
    let ratio = |i: &usize| t[*i][2 * n + 1] / t[*i][column];
    let rows = || (0..n).filter(|i| t[*i][column] > 1e-11);
    let least = rows().map(|i| ratio(&i)).min_by(f64::total_cmp)?;
    let tied = |i: &usize| ratio(i) <= least + 1e-12 * (1.0 + least.abs());
    rows()
        .filter(tied)
        .max_by_key(|i| (basis[*i] == 2 * n, n - i))
}

fn read(t: &[Vec<f64>], basis: &[usize]) -> Vec<f64> {
    let n = basis.len();
    let mut x = vec![0.0; n];
    for (row, variable) in t.iter().zip(basis) {
        if (n..2 * n).contains(variable) {
            x[variable - n] = row[2 * n + 1];
        }
    }
    x
}
