//! Beam under tension between two nodes: its exact stiffness and shape functions, and the stiffness
//! of the cubic element.
//!
//!   EI w⁗ − T w″ = 0,   w = a + b s + c e^(−λs) + d e^(−λ(ℓ−s)),   λ = √(T/EI)
//!
//! Unknowns w₁, w₁′, w₂, w₂′. With φ = λℓ and D = 2 − 2 cosh φ + φ sinh φ the stability functions
//! of a tension member (Livesley, Matrix Methods of Structural Analysis, 1964) are
//!
//!   k_ww = φ³ sinh φ/D,            k_wθ = φ² (cosh φ − 1)/D,
//!   k_θθ = φ (φ cosh φ − sinh φ)/D,  k_θθ′ = φ (sinh φ − φ)/D
//!
//! times EI/ℓ³, EI/ℓ², EI/ℓ, EI/ℓ; all hyperbolic functions are taken times e^(−φ). The four
//! constants follow from c + d = (w₂′ − w₁′)/(λ (1 − e^(−φ))) and (d − c) (1 − e^(−φ) − ½φ (1 +
//! e^(−φ))) = w₂ − w₁ − ½ℓ (w₁′ + w₂′).

use crate::element::hermite;

/// Vector of the end coordinates w₁, w₁′, w₂, w₂′.
pub type EndVector = [f64; 4];
/// Matrix of the four end coordinates: stiffness, or its inverse.
pub type EndMatrix = [EndVector; 4];

/// Largest φ; more flexible wires get this one: their rounded corners differ by ℓ/(4000 T).
const MAX_TENSION_PARAMETER: f64 = 2000.0;
/// Smallest φ: below it the cubic element is exact to eight digits, and the functions lose as many.
const MIN_TENSION_PARAMETER: f64 = 0.05;
/// Share of an element next to a clamped end that counts as rigid: less than 10⁻¹⁸ ℓ³/EI.
const RIGID_END_SHARE: f64 = 1e-6;

/// Beam under tension between two nodes.
#[derive(Debug, Clone, Copy)]
pub struct StringBeam {
    /// Length, m.
    pub length: f64,
    /// Tension, N.
    pub tension: f64,
    /// Bending stiffness, N·m².
    pub bending: f64,
}

impl StringBeam {
    /// Returns the tension parameter φ = λℓ.
    #[must_use]
    pub fn tension_parameter(&self) -> f64 {
        if self.tension <= 0.0 {
            return 0.0;
        }
        let stiffness = self.tension * self.length * self.length;
        (stiffness / self.bending).sqrt().min(MAX_TENSION_PARAMETER)
    }

    /// Returns the stiffness of the cubic element.
    #[must_use]
    pub fn cubic(&self) -> EndMatrix {
        let (l, t) = (self.length, self.tension.max(0.0) / 30.0);
        let b = self.bending / (l * l * l);
        let ends = [36.0 * t / l + 12.0 * b, 3.0 * t + 6.0 * b * l];
        let slopes = [(4.0 * t + 4.0 * b * l) * l, (-t + 2.0 * b * l) * l];
        symmetric(ends, slopes)
    }

    /// Returns the exact stiffness.
    #[must_use]
    pub fn exact(&self) -> EndMatrix {
        let phi = self.tension_parameter();
        if phi < MIN_TENSION_PARAMETER {
            return self.cubic();
        }
        let (e, l) = ((-phi).exp(), self.length);
        let (sinh, cosh) = (0.5 * (1.0 - e * e), 0.5 * (1.0 + e * e));
        // EI/D with the bending stiffness that φ stands for.
        let scale = self.tension * l * l / (phi * phi) / (2.0 * e - 2.0 * cosh + phi * sinh);
        let ends = [
            scale * phi.powi(3) * sinh / l.powi(3),
            scale * phi * phi * (cosh - e) / (l * l),
        ];
        let slopes = [
            scale * phi * (phi * cosh - sinh) / l,
            scale * phi * (sinh - phi * e) / l,
        ];
        symmetric(ends, slopes)
    }

    /// Returns the exact shape functions at ξ from 0 to 1.
    #[must_use]
    pub fn shapes(&self, xi: f64) -> EndVector {
        let (phi, l) = (self.tension_parameter(), self.length);
        if phi < MIN_TENSION_PARAMETER {
            return hermite::shape(xi, l);
        }
        let e = (-phi).exp();
        // Both boundary layers without their values at the ends.
        let first = (-phi * xi).exp() - (1.0 - xi) - e * xi;
        let second = (-phi * (1.0 - xi)).exp() - e * (1.0 - xi) - xi;
        let even = 0.5 * (first + second) * l / (phi * (1.0 - e));
        let odd = 0.5 * (second - first) / (1.0 - e - 0.5 * phi * (1.0 + e));
        let slope_part = 0.5 * l * odd;
        [
            1.0 - xi - odd,
            -even - slope_part,
            xi + odd,
            even - slope_part,
        ]
    }

    /// Returns the displacement at one ξ under a unit force at another, between clamped ends, m/N.
    #[must_use]
    pub fn clamped_compliance(&self, x: f64, y: f64) -> f64 {
        let (x, y) = (x.min(y), x.max(y));
        if x < RIGID_END_SHARE || 1.0 - y < RIGID_END_SHARE {
            return 0.0;
        }
        // Two parts, divided at the force.
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

fn symmetric([ww, wt]: [f64; 2], [tt, tt2]: [f64; 2]) -> EndMatrix {
    [
        [ww, wt, -ww, wt],
        [wt, tt, -wt, tt2],
        [-ww, -wt, ww, -wt],
        [wt, tt2, -wt, tt],
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    const WIRE: StringBeam = StringBeam {
        length: 4.0,
        tension: 22e3,
        bending: 195.0,
    };

    /// For φ → 0 both are those of a beam with tension: they differ by φ⁴/700 of the bending part.
    #[test]
    fn stiff_wires_are_cubic() {
        let wire = StringBeam {
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
        let wire = StringBeam {
            length: 2.0,
            bending: 0.0,
            ..WIRE
        };
        let [ww, wt] = [wire.exact()[0][0], wire.exact()[0][1]];
        // Corrections of 2/φ, which is 1e-3.
        assert!((ww / 11e3 - 1.0).abs() < 2e-3, "{ww}");
        assert!(wt < 22e3 * 1e-3, "{wt}");
    }

    /// A clamped wire yields like a string shorter by 1/λ at each end, less √(EI/T)/(2T), due to
    /// its rounded corner.
    #[test]
    fn a_clamped_wire_yields_as_one_should() {
        let (t, lambda) = (WIRE.tension, (WIRE.tension / WIRE.bending).sqrt());
        let expected = (WIRE.length - 2.0 / lambda) / (4.0 * t) - 1.0 / (2.0 * t * lambda);
        // Exact up to e^(−φ/2), 1e-9.
        assert!((WIRE.clamped_compliance(0.5, 0.5) / expected - 1.0).abs() < 1e-6);
        // Maxwell: exchanging the places changes only rounding.
        let (there, back) = (
            WIRE.clamped_compliance(0.2, 0.7),
            WIRE.clamped_compliance(0.7, 0.2),
        );
        assert!((there / back - 1.0).abs() < 1e-12);
    }

    /// A force on the wire loads its clamped ends by the shape functions (reciprocity): with the
    /// wire divided there, the ends carry −K_ec K_cc⁻¹ of it.
    #[test]
    fn shapes_are_what_the_ends_carry() {
        let cut = 0.3;
        let part = |share: f64| StringBeam {
            length: WIRE.length * share,
            ..WIRE
        };
        let (left, right) = (part(cut).exact(), part(1.0 - cut).exact());
        let k = |i: usize, j: usize| left[i + 2][j + 2] + right[i][j];
        let determinant = k(0, 0) * k(1, 1) - k(0, 1) * k(1, 0);
        let inverse = [k(1, 1) / determinant, -k(0, 1) / determinant];
        for (q, shape) in WIRE.shapes(cut).into_iter().enumerate() {
            let end_entry = |row: usize| {
                if q < 2 {
                    left[row + 2][q]
                } else {
                    right[row][q]
                }
            };
            let carried = -(inverse[0] * end_entry(0) + inverse[1] * end_entry(1));
            // Rounding of the hyperbolic functions.
            assert!((carried - shape).abs() < 1e-12, "{q}: {carried} {shape}");
        }
    }
}
