//! The two passes over all points.
//!
//!   Qⱼ = Tⱼ (sⱼ₊₁ − sⱼ) − (mⱼ₊₁ − mⱼ)/L + H tan φⱼ,   mᵢ = (EI/ℓ̄) (s′ᵢ − s′ᵢ₋₁),   s′ⱼ = (sⱼ₊₁ − sⱼ)/L
//!   w = M⁻¹ (Qᵢ − Qᵢ₋₁) − α v,        a = w + M⁻¹ E w

use super::Explicit;
use crate::linalg::Kernel;
use std::ops::Range;

/// Points taken at a time: what lies between the passes stays in the nearest cache.
const CHUNK: usize = 128;

fn chunks(range: &Range<usize>) -> impl Iterator<Item = (usize, usize)> + use<> {
    let end = range.end;
    range
        .clone()
        .step_by(CHUNK)
        .map(move |a| (a, (a + CHUNK).min(end) - a))
}

/// w from s, H and d.
pub(super) struct Forces<'a, const DIM: usize> {
    pub p: &'a Explicit<DIM>,
    pub across: usize,
    pub range: Range<usize>,
    pub s: &'a [f64],
    pub d: &'a [f64],
    pub thrust: &'a [f64],
    pub w: &'a mut [f64],
}

impl<const DIM: usize> Kernel for Forces<'_, DIM> {
    #[inline(always)]
    fn run(self) {
        let p = self.p;
        let (tension, slope) = (&p.tension[self.across], &p.slope[self.across]);
        let inverse = &p.inverse[self.across];
        let (mut first, mut moment, mut shear) =
            ([0.0; CHUNK + 3], [0.0; CHUNK + 2], [0.0; CHUNK + 1]);
        for (a, n) in chunks(&self.range) {
            let (s, next) = (&self.s[a - 2..][..n + 3], &self.s[a - 1..][..n + 3]);
            let per = &p.per_length[a - 2..][..n + 3];
            let first = &mut first[..n + 3];
            for k in 0..n + 3 {
                first[k] = (next[k] - s[k]) * per[k];
            }
            let (bending, moment) = (&p.bending[a - 1..][..n + 2], &mut moment[..n + 2]);
            let (left, right) = (&first[..n + 2], &first[1..][..n + 2]);
            for k in 0..n + 2 {
                moment[k] = bending[k] * (right[k] - left[k]);
            }
            let (s, next) = (&self.s[a - 1..][..n + 1], &self.s[a..][..n + 1]);
            let (tension, slope) = (&tension[a - 1..][..n + 1], &slope[a - 1..][..n + 1]);
            let (per, thrust) = (
                &p.per_length[a - 1..][..n + 1],
                &self.thrust[a - 1..][..n + 1],
            );
            let (left, right) = (&moment[..n + 1], &moment[1..][..n + 1]);
            let shear = &mut shear[..n + 1];
            for k in 0..n + 1 {
                shear[k] = tension[k] * (next[k] - s[k]) - (right[k] - left[k]) * per[k]
                    + thrust[k] * slope[k];
            }
            let (left, right) = (&shear[..n], &shear[1..][..n]);
            let (inverse, damping) = (&inverse[a..][..n], &p.damping[a..][..n]);
            let (d, w) = (&self.d[a..][..n], &mut self.w[a..][..n]);
            for k in 0..n {
                w[k] = inverse[k] * (right[k] - left[k]) - damping[k] * d[k];
            }
        }
    }
}

/// Take the step: a from w, then d and y.
pub(super) struct Move<'a, const DIM: usize> {
    pub p: &'a Explicit<DIM>,
    pub across: usize,
    pub range: Range<usize>,
    pub w: &'a [f64],
    pub d: &'a mut [f64],
    pub y: &'a mut [f64],
}

impl<const DIM: usize> Kernel for Move<'_, DIM> {
    #[inline(always)]
    fn run(self) {
        let (p, squared) = (self.p, self.p.h * self.p.h);
        let inverse = &p.inverse[self.across];
        let mut shared = [0.0; CHUNK + 1];
        for (a, n) in chunks(&self.range) {
            let (w, next) = (&self.w[a - 1..][..n + 1], &self.w[a..][..n + 1]);
            let (filter, shared) = (&p.filter[a - 1..][..n + 1], &mut shared[..n + 1]);
            for k in 0..n + 1 {
                shared[k] = filter[k] * (next[k] - w[k]);
            }
            let (left, right, w) = (&shared[..n], &shared[1..][..n], &self.w[a..][..n]);
            let inverse = &inverse[a..][..n];
            let (d, y) = (&mut self.d[a..][..n], &mut self.y[a..][..n]);
            for k in 0..n {
                let moved = d[k] + squared * (w[k] - inverse[k] * (right[k] - left[k]));
                d[k] = moved;
                y[k] += moved;
            }
        }
    }
}

/// s = y + (β/h) d.
pub(super) struct Lag<'a> {
    pub lag: &'a [f64],
    pub y: &'a [f64],
    pub d: &'a [f64],
    pub s: &'a mut [f64],
}

impl Kernel for Lag<'_> {
    #[inline(always)]
    fn run(self) {
        let n = self.s.len();
        let (lag, y, d) = (&self.lag[..n], &self.y[..n], &self.d[..n]);
        for k in 0..n {
            self.s[k] = y[k] + lag[k] * d[k];
        }
    }
}
