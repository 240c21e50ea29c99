//! Second derivative of the energy of a wire element; see [`super::hermite`].

use super::hermite::{
    Coordinates, Curvature, GAUSS, dot, interpolate, shape_curvature, shape_slope,
};
use crate::linalg;
use crate::structure::Section;
use std::array::from_fn;

/// Second derivative of the energy: pairs of coordinates, then components.
pub type Tangent<const DIM: usize> = [[[[f64; DIM]; DIM]; 4]; 4];

/// Exact second derivative of the energy.
#[must_use]
pub fn tangent<const DIM: usize>(section: &Section, e: &Coordinates<DIM>) -> Tangent<DIM> {
    let mut by_components = [[[[0.0; 4]; 4]; DIM]; DIM];
    let k = &mut by_components;
    linalg::widest(TangentKernel { section, e, k });
    let second = |m: usize, n: usize| from_fn(|p| from_fn(|q| by_components[p][q][m][n]));
    from_fn(|m| from_fn(|n| second(m, n)))
}

/// Axial part of the tangent, EA ∫ (r′·δr′)(r′·δr′) ds; the rest is proportional to the tension.
#[must_use]
pub fn stretching<const DIM: usize>(section: &Section, e: &Coordinates<DIM>) -> Tangent<DIM> {
    let mut k = [[[[0.0; DIM]; DIM]; 4]; 4];
    for (xi, weight) in GAUSS {
        let d = shape_slope(xi, section.rest_length);
        let a = interpolate(&d, e);
        let axial = weight * section.rest_length * section.axial_stiffness;
        for (m, n) in (0..16).map(|pair| (pair / 4, pair % 4)) {
            for (p, q) in (0..DIM * DIM).map(|pair| (pair / DIM, pair % DIM)) {
                k[m][n][p][q] += axial * d[m] * a[p] * d[n] * a[q];
            }
        }
    }
    k
}

/// Kernel of the tangent by components first: the second coordinate fills the SIMD lanes.
struct TangentKernel<'a, const DIM: usize> {
    section: &'a Section,
    e: &'a Coordinates<DIM>,
    k: &'a mut [[[[f64; 4]; 4]; DIM]; DIM],
}

impl<const DIM: usize> linalg::Kernel for TangentKernel<'_, DIM> {
    #[inline(always)]
    fn run(self) {
        let Self { section, e, k } = self;
        let points = GAUSS.map(|point| TangentPoint::new(section, e, point));
        for p in 0..DIM {
            for q in 0..DIM {
                // Sums that stay in registers: one pair of components at a time.
                let mut sums = [[0.0; 4]; 4];
                for point in &points {
                    point.add(p, q, &mut sums);
                }
                k[p][q] = sums;
            }
        }
    }
}

/// Terms of the tangent at one integration point.
struct TangentPoint<const DIM: usize> {
    d1: [f64; 4],
    d2: [f64; 4],
    a: [f64; DIM],
    b: [f64; DIM],
    s: f64,
    f: Curvature,
    axial: f64,
    bending: f64,
}

impl<const DIM: usize> TangentPoint<DIM> {
    #[inline(always)]
    fn new(section: &Section, e: &Coordinates<DIM>, (xi, weight): (f64, f64)) -> Self {
        let l = section.rest_length;
        let (d1, d2) = (shape_slope(xi, l), shape_curvature(xi, l));
        let (a, b) = (interpolate(&d1, e), interpolate(&d2, e));
        let s = dot(&a, &a);
        let f = Curvature::new(s, dot(&b, &b), dot(&a, &b));
        let axial = weight * l * section.axial_stiffness;
        let bending = weight * l * 0.5 * section.bending_stiffness;
        Self {
            d1,
            d2,
            a,
            b,
            s,
            f,
            axial,
            bending,
        }
    }

    /// Adds the terms of components p and q to all pairs of coordinates.
    #[inline(always)]
    fn add(&self, p: usize, q: usize, sums: &mut [[f64; 4]; 4]) {
        let Self {
            d1, d2, a, b, f, ..
        } = self;
        let (s, axial, bending) = (self.s, self.axial, self.bending);
        let one = f64::from(u8::from(p == q));
        let stretch = axial * (0.5 * (s - 1.0) * one + a[p] * a[q]);
        let aa = 2.0 * f.s * one
            + 4.0 * f.ss * a[p] * a[q]
            + 2.0 * f.sw * (a[p] * b[q] + b[p] * a[q])
            + f.ww * b[p] * b[q];
        let bb = 2.0 * f.t * one + f.ww * a[p] * a[q];
        let (ab, ba) = (f.cross(a, b, p, q), f.cross(a, b, q, p));
        let both = stretch + bending * aa;
        for m in 0..4 {
            for n in 0..4 {
                sums[m][n] += both * d1[m] * d1[n]
                    + bending * (bb * d2[m] * d2[n] + ab * d1[m] * d2[n] + ba * d2[m] * d1[n]);
            }
        }
    }
}
