//! Wire under tension between two nodes: its exact stiffness and shapes, and those of the cubic element.
//!
//!   EI w⁗ − T w″ = 0,   w = a + b s + c e^(−λs) + d e^(−λ(ℓ−s)),   λ = √(T/EI)
//!
//! Unknowns w₁, w₁′, w₂, w₂′. With φ = λℓ and D = 2 − 2 cosh φ + φ sinh φ the stability functions of a
//! tension member (Livesley, Matrix Methods of Structural Analysis, 1964) are
//!
//!   k_ww = φ³ sinh φ/D,  k_wθ = φ² (cosh φ − 1)/D,  k_θθ = φ (φ cosh φ − sinh φ)/D,  k_θθ′ = φ (sinh φ − φ)/D
//!
//! times EI/ℓ³, EI/ℓ², EI/ℓ, EI/ℓ; all hyperbolic functions are taken times e^(−φ). The four constants
//! follow from c + d = (w₂′ − w₁′)/(λ (1 − e^(−φ))) and
//! (d − c) (1 − e^(−φ) − ½φ (1 + e^(−φ))) = w₂ − w₁ − ½ℓ (w₁′ + w₂′).

use crate::element::hermite;

/// w₁, w₁′, w₂, w₂′, or what belongs to each of them.
pub type Ends = [f64; 4];
/// Stiffness of four unknowns, or its inverse.
pub type Square = [Ends; 4];

/// Wires that bend more easily than this (λℓ) are taken so stiff: their kinks differ by ℓ/(4000 T).
const SHARPEST: f64 = 2000.0;
/// Below this λℓ the cubic element is exact to eight digits, and the functions lose as many.
const STIFFEST: f64 = 0.05;
/// Share of an element next to a clamped end in which it does not yield: less than 10⁻¹⁸ ℓ³/EI.
const AT_END: f64 = 1e-6;

/// A piece of wire.
#[derive(Debug, Clone, Copy)]
pub struct Taut {
    /// Length, m.
    pub length: f64,
    /// Tension, N.
    pub tension: f64,
    /// Bending stiffness, N·m².
    pub bending: f64,
}

impl Taut {
    /// λℓ.
    #[must_use]
    pub fn sharpness(&self) -> f64 {
        if self.tension <= 0.0 {
            return 0.0;
        }
        let stiffness = self.tension * self.length * self.length;
        (stiffness / self.bending).sqrt().min(SHARPEST)
    }

    /// Stiffness of the cubic element.
    #[must_use]
    pub fn cubic(&self) -> Square {
        let (l, t) = (self.length, self.tension.max(0.0) / 30.0);
        let b = self.bending / (l * l * l);
        let ends = [36.0 * t / l + 12.0 * b, 3.0 * t + 6.0 * b * l];
        let turns = [(4.0 * t + 4.0 * b * l) * l, (-t + 2.0 * b * l) * l];
        arranged(ends, turns)
    }

    /// Stiffness of the wire itself.
    #[must_use]
    pub fn exact(&self) -> Square {
        let phi = self.sharpness();
        if phi < STIFFEST {
            return self.cubic();
        }
        let (e, l) = ((-phi).exp(), self.length);
        let (sinh, cosh) = (0.5 * (1.0 - e * e), 0.5 * (1.0 + e * e));
        // EI/D with the stiffness that belongs to φ.
        let scale = self.tension * l * l / (phi * phi) / (2.0 * e - 2.0 * cosh + phi * sinh);
        let ends = [
            scale * phi.powi(3) * sinh / l.powi(3),
            scale * phi * phi * (cosh - e) / (l * l),
        ];
        let turns = [
            scale * phi * (phi * cosh - sinh) / l,
            scale * phi * (sinh - phi * e) / l,
        ];
        arranged(ends, turns)
    }

    /// Shape functions of the wire itself, at ξ from 0 to 1.
    #[must_use]
    pub fn shapes(&self, xi: f64) -> Ends {
        let (phi, l) = (self.sharpness(), self.length);
        if phi < STIFFEST {
            return hermite::shape(xi, l);
        }
        let e = (-phi).exp();
        // Both layers without their values at the ends.
        let first = (-phi * xi).exp() - (1.0 - xi) - e * xi;
        let second = (-phi * (1.0 - xi)).exp() - e * (1.0 - xi) - xi;
        let even = 0.5 * (first + second) * l / (phi * (1.0 - e));
        let odd = 0.5 * (second - first) / (1.0 - e - 0.5 * phi * (1.0 + e));
        let turn = 0.5 * l * odd;
        [1.0 - xi - odd, -even - turn, xi + odd, even - turn]
    }

    /// Displacement at one ξ under a unit force at another, between clamped ends, m/N.
    #[must_use]
    pub fn clamped(&self, x: f64, y: f64) -> f64 {
        let (x, y) = (x.min(y), x.max(y));
        if x < AT_END || 1.0 - y < AT_END {
            return 0.0;
        }
        // Cut at the force.
        let part = |share: f64| Self {
            length: self.length * share,
            ..*self
        };
        let (left, right) = (part(y), part(1.0 - y));
        let (before, behind) = (left.exact(), right.exact());
        let k = |i: usize, j: usize| before[i + 2][j + 2] + behind[i][j];
        let determinant = k(0, 0) * k(1, 1) - k(0, 1) * k(1, 0);
        let shapes = left.shapes(x / y);
        (shapes[2] * k(1, 1) - shapes[3] * k(0, 1)) / determinant
    }
}

fn arranged([ww, wt]: [f64; 2], [tt, across]: [f64; 2]) -> Square {
    [
        [ww, wt, -ww, wt],
        [wt, tt, -wt, across],
        [-ww, -wt, ww, -wt],
        [wt, across, -wt, tt],
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    const WIRE: Taut = Taut {
        length: 4.0,
        tension: 22e3,
        bending: 195.0,
    };

    /// As φ → 0 both are the beam's with tension: they differ by φ⁴/700 of the bending part.
    #[test]
    fn stiff_wires_are_cubic() {
        let wire = Taut {
            length: 1.0,
            tension: 1.0,
            bending: 25.0,
        };
        let (cubic, exact) = (wire.cubic(), wire.exact());
        for (a, b) in cubic.iter().flatten().zip(exact.iter().flatten()) {
            // φ = 0.2: φ⁴/700 of 12 EI is 7e-5; rounding of D, 1e-16/φ⁴ of 300.
            assert!((a - b).abs() < 1e-3, "{a} {b}");
        }
    }

    /// A wire without bending stiffness is a string: k_ww = T/ℓ.
    #[test]
    fn wires_that_bend_freely_are_strings() {
        let wire = Taut {
            length: 2.0,
            bending: 0.0,
            ..WIRE
        };
        let [ww, wt] = [wire.exact()[0][0], wire.exact()[0][1]];
        // Corrections of 2/φ, which is 1e-3.
        assert!((ww / 11e3 - 1.0).abs() < 2e-3, "{ww}");
        assert!(wt < 22e3 * 1e-3, "{wt}");
    }

    /// A clamped wire yields like a string shorter by 1/λ at each end, less √(EI/T)/(2T), which the
    /// rounding of the kink takes.
    #[test]
    fn a_clamped_wire_yields_as_one_should() {
        let (t, lambda) = (WIRE.tension, (WIRE.tension / WIRE.bending).sqrt());
        let expected = (WIRE.length - 2.0 / lambda) / (4.0 * t) - 1.0 / (2.0 * t * lambda);
        // Exact but for e^(−φ/2), 1e-9.
        assert!((WIRE.clamped(0.5, 0.5) / expected - 1.0).abs() < 1e-6);
        // Maxwell: exchanging the places changes nothing but rounding.
        let (there, back) = (WIRE.clamped(0.2, 0.7), WIRE.clamped(0.7, 0.2));
        assert!((there / back - 1.0).abs() < 1e-12);
    }

    /// A force on the wire loads its clamped ends as the shape functions say (reciprocity): with the wire
    /// cut there, the ends carry −K_ec K_cc⁻¹ of it.
    #[test]
    fn shapes_are_what_the_ends_carry() {
        let cut = 0.3;
        let part = |share: f64| Taut {
            length: WIRE.length * share,
            ..WIRE
        };
        let (left, right) = (part(cut).exact(), part(1.0 - cut).exact());
        let k = |i: usize, j: usize| left[i + 2][j + 2] + right[i][j];
        let determinant = k(0, 0) * k(1, 1) - k(0, 1) * k(1, 0);
        let inverse = [k(1, 1) / determinant, -k(0, 1) / determinant];
        for (q, shape) in WIRE.shapes(cut).into_iter().enumerate() {
            let of = |row: usize| {
                if q < 2 {
                    left[row + 2][q]
                } else {
                    right[row][q]
                }
            };
            let carried = -(inverse[0] * of(0) + inverse[1] * of(1));
            // Rounding of the hyperbolic functions.
            assert!((carried - shape).abs() < 1e-12, "{q}: {carried} {shape}");
        }
    }
}
