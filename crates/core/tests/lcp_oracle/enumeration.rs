//! All `2ⁿ` active sets, and the energy criterion walked with a fresh solve for every set.

use super::{Problem, gauss};

/// `x` and `y` for one active set given as bits, whatever their signs.
pub fn candidate(p: &Problem, set: usize) -> Option<(Vec<f64>, Vec<f64>)> {
    let n = p.n();
    let rows: Vec<usize> = (0..n).filter(|k| set >> k & 1 == 1).collect();
    let block = rows
        .iter()
        .flat_map(|i| rows.iter().map(move |j| p.h[i * n + j]))
        .collect();
    let z = gauss(block, rows.iter().map(|i| -p.w[*i]).collect())?;
    let mut x = vec![0.0; n];
    for (k, value) in rows.iter().zip(z) {
        x[*k] = value;
    }
    let mut y = p.y(&x);
    for k in rows {
        y[k] = 0.0;
    }
    Some((x, y))
}

/// The candidate whose most negative entry is least: the solution, up to rounding.
pub fn solve(p: &Problem) -> (Vec<f64>, Vec<f64>) {
    let worst = |(x, y): &(Vec<f64>, Vec<f64>)| x.iter().chain(y).copied().fold(0.0, f64::min);
    (0..1 << p.n())
        .filter_map(|set| candidate(p, set))
        .max_by(|a, b| worst(a).total_cmp(&worst(b)))
        .expect("the empty set is always a candidate")
}

/// Active sets that the plain energy criterion visits from the empty set, at most `limit` of them.
///
/// Pivot of row `k` in the table of set `A`: `H_kk − H_kA H_AA⁻¹ H_Ak` outside of `A`,
/// `(H_AA⁻¹)_kk` inside.
pub fn energy_walk(p: &Problem, limit: usize) -> Vec<usize> {
    let mut walk = vec![0];
    while walk.len() < limit {
        let set = walk[walk.len() - 1];
        let (x, y) = candidate(p, set).expect("regular principal blocks");
        let energy = |k: &usize| {
            let value = x[*k] + y[*k];
            value * value / (2.0 * pivot(p, set, *k))
        };
        let violated = (0..p.n()).filter(|k| x[*k] + y[*k] < -1e-12);
        match violated.max_by(|a, b| energy(a).total_cmp(&energy(b))) {
            Some(k) => walk.push(set ^ 1 << k),
            None => break,
        }
    }
    walk
}

/// Pivot as a ratio of principal minors: `det H_{A∪k} / det H_A`, or its counterpart inside `A`.
fn pivot(p: &Problem, set: usize, k: usize) -> f64 {
    minor(p, set ^ 1 << k) / minor(p, set)
}

fn minor(p: &Problem, set: usize) -> f64 {
    let n = p.n();
    let rows: Vec<usize> = (0..n).filter(|k| set >> k & 1 == 1).collect();
    let m = rows.len();
    let mut a: Vec<f64> = rows
        .iter()
        .flat_map(|i| rows.iter().map(move |j| p.h[i * n + j]))
        .collect();
    let mut product = 1.0;
    for k in 0..m {
        product *= a[k * m + k];
        for i in k + 1..m {
            let f = a[i * m + k] / a[k * m + k];
            for j in k..m {
                a[i * m + j] -= f * a[k * m + j];
            }
        }
    }
    product
}
