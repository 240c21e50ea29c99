//! Other ways to solve the same problem, sharing no code with `arcless_core::lcp`.

pub mod enumeration;
pub mod generate;
pub mod lemke;

/// A problem `y = Hx + w` with a name for messages.
#[derive(Clone, Debug)]
pub struct Problem {
    pub h: Vec<f64>,
    pub w: Vec<f64>,
}

impl Problem {
    pub fn new(h: &[&[f64]], w: &[f64]) -> Self {
        Self {
            h: h.concat(),
            w: w.to_vec(),
        }
    }

    pub fn n(&self) -> usize {
        self.w.len()
    }

    /// `Hx + w`.
    pub fn y(&self, x: &[f64]) -> Vec<f64> {
        let n = self.n();
        let dot = |i: usize| {
            self.h[i * n..(i + 1) * n]
                .iter()
                .zip(x)
                .map(|(a, b)| a * b)
                .sum::<f64>()
        };
        (0..n).map(|i| dot(i) + self.w[i]).collect()
    }
}

/// Gauss elimination with row interchanges; `None` when a pivot vanishes.
pub fn gauss(mut a: Vec<f64>, mut b: Vec<f64>) -> Option<Vec<f64>> {
    let m = b.len();
    for k in 0..m {
        let p = (k..m).max_by(|i, j| a[i * m + k].abs().total_cmp(&a[j * m + k].abs()))?;
        if a[p * m + k] == 0.0 {
            return None;
        }
        for j in 0..m {
            a.swap(k * m + j, p * m + j);
        }
        b.swap(k, p);
        for i in k + 1..m {
            let f = a[i * m + k] / a[k * m + k];
            for j in k..m {
                a[i * m + j] -= f * a[k * m + j];
            }
            b[i] -= f * b[k];
        }
    }
    for i in (0..m).rev() {
        let sum: f64 = (i + 1..m).map(|j| a[i * m + j] * b[j]).sum();
        b[i] = (b[i] - sum) / a[i * m + i];
    }
    Some(b)
}
