//! Seeded random problems of the classes that occur.

use super::Problem;

/// Numbers from a seed (xorshift64*), the same on every machine.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    fn next(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11
    }

    /// Uniform in (−1, 1).
    pub fn unit(&mut self) -> f64 {
        self.next() as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// Whole number in `−limit..=limit`.
    pub fn whole(&mut self, limit: i64) -> f64 {
        (self.next() as i64 % (2 * limit + 1) - limit) as f64
    }

    pub fn vector(&mut self, n: usize) -> Vec<f64> {
        (0..n).map(|_| self.unit()).collect()
    }

    /// `G Gᵀ + shift·1` with `G` of `n × rank`.
    pub fn gram(&mut self, n: usize, rank: usize, shift: f64) -> Vec<f64> {
        let g = self.vector(n * rank);
        gram_of(&g, n, rank, shift)
    }
}

fn gram_of(g: &[f64], n: usize, rank: usize, shift: f64) -> Vec<f64> {
    let mut h = vec![0.0; n * n];
    for i in 0..n {
        for j in 0..n {
            let dot = |k: usize| g[i * rank + k] * g[j * rank + k];
            h[i * n + j] = (0..rank).map(dot).sum::<f64>() + if i == j { shift } else { 0.0 };
        }
    }
    h
}

/// Symmetric positive definite, condition number some hundreds.
pub fn definite(n: usize, seed: u64) -> Problem {
    let mut random = Random::new(seed);
    Problem {
        h: random.gram(n, n, 0.1),
        w: random.vector(n),
    }
}

/// Rank one third plus 1e-9: contacts that move almost together.
pub fn near_singular(n: usize, seed: u64) -> Problem {
    let mut random = Random::new(seed);
    Problem {
        h: random.gram(n, n.div_ceil(3), 1e-9),
        w: random.vector(n),
    }
}

/// `[[P, −Q], [Qᵀ, S]]` with the second block in other units (`x` in m, `y` in N).
pub fn skew_coupled(n: usize, seed: u64) -> Problem {
    let mut random = Random::new(seed);
    let (contacts, unit) = (n.div_ceil(2), 1e4);
    let mut h = random.gram(n, n, 0.1);
    let mut w = random.vector(n);
    for i in 0..n {
        for j in i + 1..n {
            if i < contacts && j >= contacts {
                let coupling = 2.0 * random.unit();
                (h[i * n + j], h[j * n + i]) = (-coupling, coupling);
            }
        }
    }
    for i in contacts..n {
        w[i] *= unit;
        for j in 0..n {
            h[i * n + j] *= unit;
            h[j * n + i] *= unit;
        }
    }
    Problem { h, w }
}

/// Blocks of rank one third plus 1e-13, coupled three times as strongly as they resist.
pub fn near_singular_coupled(n: usize, seed: u64) -> Problem {
    let mut random = Random::new(seed);
    let mut h = random.gram(n, n.div_ceil(3), 1e-13);
    for i in 0..n / 2 {
        for j in n / 2..n {
            let coupling = 3.0 * random.unit();
            (h[i * n + j], h[j * n + i]) = (-coupling, coupling);
        }
    }
    Problem {
        h,
        w: random.vector(n),
    }
}

/// Small whole numbers, many zeros in `w`: `x_k = y_k = 0` and equal energies happen often.
pub fn degenerate(n: usize, seed: u64) -> Problem {
    let mut random = Random::new(seed);
    let g: Vec<f64> = (0..n * n).map(|_| random.whole(1)).collect();
    let w = (0..n).map(|_| random.whole(1)).collect();
    Problem {
        h: gram_of(&g, n, n, 1.0),
        w,
    }
}
