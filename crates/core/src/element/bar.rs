//! Straight bar or string between two points: U = ½ k (ℓ − ℓ₀)², optionally tension only.

/// State of a bar: direction, length and tension.
#[derive(Debug, Clone, Copy)]
pub struct BarState<const DIM: usize> {
    /// Unit vector from the first to the second end.
    pub direction: [f64; DIM],
    /// Distance of the ends, m.
    pub length: f64,
    /// Tension k (ℓ − ℓ₀), N; negative in compression, also for a tension-only bar.
    pub linear_tension: f64,
}

impl<const DIM: usize> BarState<DIM> {
    /// State for given end positions.
    #[must_use]
    pub fn new(first: &[f64; DIM], second: &[f64; DIM], rest_length: f64, stiffness: f64) -> Self {
        let mut direction = [0.0; DIM];
        for c in 0..DIM {
            direction[c] = second[c] - first[c];
        }
        let length = direction.iter().map(|d| d * d).sum::<f64>().sqrt();
        direction.iter_mut().for_each(|d| *d /= length);
        Self {
            direction,
            length,
            linear_tension: stiffness * (length - rest_length),
        }
    }

    /// Tangent ∂²U/∂x² for the second end, N/m: k n nᵀ + (T/ℓ)(1 − n nᵀ). The stiffness is zero for
    /// a slack bar.
    #[must_use]
    pub fn tangent(&self, stiffness: f64, tension: f64) -> [[f64; DIM]; DIM] {
        let geometric = tension / self.length;
        let n = &self.direction;
        let mut k = [[0.0; DIM]; DIM];
        for p in 0..DIM {
            for q in 0..DIM {
                let one = f64::from(u8::from(p == q));
                k[p][q] = (stiffness - geometric) * n[p] * n[q] + geometric * one;
            }
        }
        k
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tangent_matches_finite_differences() {
        let (a, b, l0, k) = ([0.0, 0.1, 0.0], [0.1, 0.3, -1.0], 0.9, 2e5);
        let state = BarState::new(&a, &b, l0, k);
        let tangent = state.tangent(k, state.linear_tension);
        let h = 1e-6;
        for q in 0..3 {
            let (mut up, mut down) = (b, b);
            up[q] += h;
            down[q] -= h;
            let (u, d) = (
                BarState::new(&a, &up, l0, k),
                BarState::new(&a, &down, l0, k),
            );
            for p in 0..3 {
                let slope = (u.linear_tension * u.direction[p] - d.linear_tension * d.direction[p])
                    / (2.0 * h);
                // h² k/ℓ² plus rounding of the force over h.
                assert!((slope - tangent[p][q]).abs() < 1e-4 * k);
            }
        }
    }
}
