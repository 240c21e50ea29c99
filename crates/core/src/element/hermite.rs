//! Two-node wire element: position and slope at each node, cubic Hermite interpolation.
//!
//! Coordinates e = (r₁, r₁′, r₂, r₂′) with r′ = ∂r/∂s along the unstretched length s ∈ [0, L].
//!
//!   r(s) = Σ Sₖ(s) eₖ
//!   U    = ∫₀ᴸ ½ EA ε² + ½ EI κ² ds,   ε = ½ (r′·r′ − 1),   κ² = |r′ × r″|² / |r′|⁶
//!
//! Sources: Berzeri & Shabana, J. Sound Vib. 235 (2000) 539 (strain and curvature of the ANCF
//! cable); Tur, García, Baeza & Fuenmayor, Eng. Struct. 71 (2014) 234 (overhead lines).

use crate::linalg;
use crate::structure::Section;

/// Coordinates of an element, or forces on them: r₁, r₁′, r₂, r₂′.
pub type Coordinates<const DIM: usize> = [[f64; DIM]; 4];

/// Gauss–Legendre points on [0, 1]: five points integrate ε² (degree 8 in s) exactly.
pub(super) const GAUSS: [(f64, f64); 5] = [
    (0.046_910_077_030_668_004, 0.118_463_442_528_094_54),
    (0.230_765_344_947_158_45, 0.239_314_335_249_683_23),
    (0.5, 0.284_444_444_444_444_44),
    (0.769_234_655_052_841_6, 0.239_314_335_249_683_23),
    (0.953_089_922_969_332, 0.118_463_442_528_094_54),
];

/// Shape functions at ξ = s/L.
#[must_use]
pub fn shape(xi: f64, l: f64) -> [f64; 4] {
    let (x2, x3) = (xi * xi, xi * xi * xi);
    [
        1.0 - 3.0 * x2 + 2.0 * x3,
        l * (xi - 2.0 * x2 + x3),
        3.0 * x2 - 2.0 * x3,
        l * (x3 - x2),
    ]
}

/// Derivatives ∂S/∂s at ξ, 1/m.
#[inline(always)]
#[must_use]
pub fn shape_slope(xi: f64, l: f64) -> [f64; 4] {
    let x2 = xi * xi;
    [
        6.0 * (x2 - xi) / l,
        1.0 - 4.0 * xi + 3.0 * x2,
        6.0 * (xi - x2) / l,
        3.0 * x2 - 2.0 * xi,
    ]
}

/// Second derivatives ∂²S/∂s² at ξ, 1/m².
#[inline(always)]
#[must_use]
pub fn shape_curvature(xi: f64, l: f64) -> [f64; 4] {
    [
        (12.0 * xi - 6.0) / (l * l),
        (6.0 * xi - 4.0) / l,
        (6.0 - 12.0 * xi) / (l * l),
        (6.0 * xi - 2.0) / l,
    ]
}

/// Weighted sum of the coordinates: a point, slope or curvature vector.
#[inline(always)]
#[must_use]
pub fn interpolate<const DIM: usize>(weights: &[f64; 4], e: &Coordinates<DIM>) -> [f64; DIM] {
    let mut r = [0.0; DIM];
    for k in 0..4 {
        for c in 0..DIM {
            r[c] += weights[k] * e[k][c];
        }
    }
    r
}

#[inline(always)]
pub(super) fn dot<const DIM: usize>(a: &[f64; DIM], b: &[f64; DIM]) -> f64 {
    (0..DIM).map(|c| a[c] * b[c]).sum()
}

/// Squared curvature κ² as a function of a = r′ and b = r″ through s = a·a, t = b·b, w = a·b:
/// κ² = t/s² − w²/s³, with its first and second partial derivatives.
pub(super) struct Curvature {
    value: f64,
    pub(super) s: f64,
    pub(super) t: f64,
    w: f64,
    pub(super) ss: f64,
    st: f64,
    pub(super) sw: f64,
    pub(super) ww: f64,
}

impl Curvature {
    #[inline(always)]
    pub(super) fn new(s: f64, t: f64, w: f64) -> Self {
        let (s2, s3) = (s * s, s * s * s);
        Self {
            value: t / s2 - w * w / s3,
            s: -2.0 * t / s3 + 3.0 * w * w / (s2 * s2),
            t: 1.0 / s2,
            w: -2.0 * w / s3,
            ss: 6.0 * t / (s2 * s2) - 12.0 * w * w / (s2 * s3),
            st: -2.0 / s3,
            sw: 6.0 * w / (s2 * s2),
            ww: -2.0 / s3,
        }
    }

    /// Mixed derivative ½ ∂²κ²/∂aₚ∂b_q, used twice by the two orders of p and q.
    #[inline(always)]
    pub(super) fn cross<const DIM: usize>(
        &self,
        a: &[f64; DIM],
        b: &[f64; DIM],
        p: usize,
        q: usize,
    ) -> f64 {
        let one = f64::from(u8::from(p == q));
        self.w * one + 2.0 * a[p] * (2.0 * self.st * b[q] + self.sw * a[q]) + self.ww * b[p] * a[q]
    }
}

/// Strain energy, J.
#[must_use]
pub fn energy<const DIM: usize>(section: &Section, e: &Coordinates<DIM>) -> f64 {
    let l = section.rest_length;
    GAUSS
        .iter()
        .map(|&(xi, weight)| {
            let a = interpolate(&shape_slope(xi, l), e);
            let b = interpolate(&shape_curvature(xi, l), e);
            let s = dot(&a, &a);
            let strain = 0.5 * (s - 1.0);
            let kappa2 = Curvature::new(s, dot(&b, &b), dot(&a, &b)).value;
            let axial = section.axial_stiffness * strain * strain;
            0.5 * weight * l * (axial + section.bending_stiffness * kappa2)
        })
        .sum()
}

/// Axial force EA ε |r′| at ξ, N: the true tension of the stretched wire.
#[must_use]
pub fn tension<const DIM: usize>(section: &Section, e: &Coordinates<DIM>, xi: f64) -> f64 {
    let a = interpolate(&shape_slope(xi, section.rest_length), e);
    let s = dot(&a, &a);
    section.axial_stiffness * 0.5 * (s - 1.0) * s.sqrt()
}

/// Adds the gradient of the energy, the internal forces on the coordinates, N, to `force`.
pub fn add_force<const DIM: usize>(
    section: &Section,
    e: &Coordinates<DIM>,
    force: &mut Coordinates<DIM>,
) {
    linalg::widest(ForceKernel { section, e, force });
}

struct ForceKernel<'a, const DIM: usize> {
    section: &'a Section,
    e: &'a Coordinates<DIM>,
    force: &'a mut Coordinates<DIM>,
}

impl<const DIM: usize> linalg::Kernel for ForceKernel<'_, DIM> {
    #[inline(always)]
    fn run(self) {
        let Self { section, e, force } = self;
        for point in &GAUSS {
            add_force_at(section, e, point, |k, c, part| force[k][c] += part);
        }
    }
}

/// Horizontal force on the second end: a component of [`add_force`], to the bit.
#[must_use]
pub fn end_force_along<const DIM: usize>(section: &Section, e: &Coordinates<DIM>) -> f64 {
    let mut force = 0.0;
    for point in &GAUSS {
        // The compiler leaves out the components that are not used.
        add_force_at(section, e, point, |k, c, part| {
            if (k, c) == (2, 0) {
                force += part;
            }
        });
    }
    force
}

/// Adds the forces of one integration point by `add`: coordinate, component, force.
#[inline(always)]
fn add_force_at<const DIM: usize>(
    section: &Section,
    e: &Coordinates<DIM>,
    &(xi, weight): &(f64, f64),
    mut add: impl FnMut(usize, usize, f64),
) {
    let l = section.rest_length;
    let (d1, d2) = (shape_slope(xi, l), shape_curvature(xi, l));
    let (a, b) = (interpolate(&d1, e), interpolate(&d2, e));
    let s = dot(&a, &a);
    let kappa = Curvature::new(s, dot(&b, &b), dot(&a, &b));
    let axial = weight * l * section.axial_stiffness * 0.5 * (s - 1.0);
    let bending = weight * l * 0.5 * section.bending_stiffness;
    for c in 0..DIM {
        let by_slope = 2.0 * kappa.s * a[c] + kappa.w * b[c];
        let by_curvature = 2.0 * kappa.t * b[c] + kappa.w * a[c];
        for k in 0..4 {
            let bent = bending * (by_slope * d1[k] + by_curvature * d2[k]);
            add(k, c, axial * a[c] * d1[k] + bent);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::tangent::tangent;
    use super::*;

    const SECTION: Section = Section {
        rest_length: 1.4,
        axial_stiffness: 15.0e6,
        bending_stiffness: 195.0,
    };

    fn bent() -> Coordinates<3> {
        [
            [0.1, 0.0, 5.0],
            [1.001, 0.02, 0.1],
            [1.49, 0.05, 5.2],
            [0.998, 0.03, -0.05],
        ]
    }

    /// Central difference of a smooth function: error h² f‴, rounding ε f / h; with h = 1e-6 and
    /// values of order EA both stay below 1e-7 of the largest entry.
    const DIFFERENCE: f64 = 1e-6;

    #[test]
    fn force_is_the_gradient_of_the_energy() {
        let e = bent();
        let mut force = [[0.0; 3]; 4];
        add_force(&SECTION, &e, &mut force);
        for k in 0..4 {
            for c in 0..3 {
                let (mut up, mut down) = (e, e);
                // Central differences of forces of order EA: 1e-16 of EA over DIFFERENCE, and its
                // square.
                up[k][c] += DIFFERENCE;
                down[k][c] -= DIFFERENCE;
                let slope = (energy(&SECTION, &up) - energy(&SECTION, &down)) / (2.0 * DIFFERENCE);
                assert!((slope - force[k][c]).abs() < 1e-7 * SECTION.axial_stiffness);
            }
        }
    }

    #[test]
    fn tangent_is_the_gradient_of_the_force_and_symmetric() {
        for ei in [0.0, 195.0, 1e5] {
            let section = Section {
                bending_stiffness: ei,
                ..SECTION
            };
            let e = bent();
            let k = tangent(&section, &e);
            for n in 0..4 {
                for q in 0..3 {
                    let (mut up, mut down) = (e, e);
                    up[n][q] += DIFFERENCE;
                    down[n][q] -= DIFFERENCE;
                    let (mut fu, mut fd) = ([[0.0; 3]; 4], [[0.0; 3]; 4]);
                    add_force(&section, &up, &mut fu);
                    add_force(&section, &down, &mut fd);
                    for m in 0..4 {
                        for p in 0..3 {
                            // Tolerance as above; the matrix is symmetric by construction up to
                            // rounding of EA.
                            let slope = (fu[m][p] - fd[m][p]) / (2.0 * DIFFERENCE);
                            assert!((slope - k[m][n][p][q]).abs() < 1e-7 * section.axial_stiffness);
                            assert!((k[m][n][p][q] - k[n][m][q][p]).abs() < 1e-9 * 15e6);
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn rigid_motion_needs_no_force() {
        let (sin, cos) = 0.7_f64.sin_cos();
        let along = [cos, 0.0, sin];
        let end = [3.0 + 1.4 * cos, -2.0, 1.0 + 1.4 * sin];
        let mut force = [[0.0; 3]; 4];
        add_force(&SECTION, &[[3.0, -2.0, 1.0], along, end, along], &mut force);
        // EA times the rounding of the strain.
        assert!(force.iter().flatten().all(|f| f.abs() < 15e6 * 1e-14));
    }

    #[test]
    fn straight_stretch_gives_the_tension() {
        let stretch = 1.0015;
        let e = [
            [0.0, 0.0],
            [stretch, 0.0],
            [1.4 * stretch, 0.0],
            [stretch, 0.0],
        ];
        let mut force = [[0.0; 2]; 4];
        add_force(&SECTION, &e, &mut force);
        let expected = 15e6 * 0.5 * (stretch * stretch - 1.0) * stretch;
        assert!((force[2][0] - expected).abs() < 1e-6, "rounding of EA");
        assert!(
            (tension(&SECTION, &e, 0.3) - expected).abs() < 1e-6,
            "rounding of EA"
        );
    }
}
