//! Kernels that a step applies to packed rows in order, in one transverse direction.
//!
//!   Qⱼ = Tⱼ (sⱼ₊₁ − sⱼ) − (mⱼ₊₁ − mⱼ)/L + H tan φⱼ,   mᵢ = (EI/ℓ̄) (s′ᵢ − s′ᵢ₋₁),   s′ⱼ = (sⱼ₊₁ −
//!   sⱼ)/L w = h² M⁻¹ (Qᵢ − Qᵢ₋₁) − α h d,        h² a = w + M⁻¹ E w
//!
//! Each takes some rows and leaves the state for the next ones, so that rows may come in pieces.

use crate::integrator::explicit::simd::packed::{
    DampingCoefficients, SharedCoefficients, SimdVector, TransverseCoefficients, TransverseMotion,
    per_lane,
};
use std::ops::Range;

/// Constant coefficients of a transverse direction, by packed row.
#[derive(Clone, Copy)]
pub(in crate::integrator::explicit) struct PackedCoefficients<'a> {
    pub common: &'a [SharedCoefficients],
    pub damping: &'a [DampingCoefficients],
    pub across: &'a [TransverseCoefficients],
}

impl<'a> PackedCoefficients<'a> {
    /// Returns the damping of rows; a `UNIFORM` block has one row for all.
    #[inline(always)]
    fn damping<const UNIFORM: bool>(&self, rows: &Range<usize>) -> &'a [DampingCoefficients] {
        match UNIFORM {
            true => &self.damping[..1],
            false => &self.damping[rows.start..rows.end],
        }
    }
}

/// Kernel of wire forces, with the state it carries from row to row.
#[derive(Clone, Copy)]
pub(in crate::integrator::explicit) struct WireForceKernel {
    /// s of the next row; difference and slope of the segment behind it; moment and shear before
    /// it; H.
    s: SimdVector,
    difference: SimdVector,
    slope: SimdVector,
    moment: SimdVector,
    shear: SimdVector,
    axial_force: SimdVector,
}

impl WireForceKernel {
    /// Starts before `row`, with H of the segment that precedes the one ending there.
    ///
    /// The first row yields the shear for the second; its own w is not valid.
    #[inline(always)]
    pub fn before(
        row: usize,
        fixed: PackedCoefficients<'_>,
        rows: &[TransverseMotion],
        axial_force: SimdVector,
    ) -> Self {
        let common = &fixed.common[row - 1..=row];
        let rows = &rows[row - 1..=row + 1];
        let (_, before) = difference_and_slope(&rows[0].s, &rows[1].s, &common[0]);
        let (difference, slope) = difference_and_slope(&rows[1].s, &rows[2].s, &common[1]);
        Self {
            s: rows[2].s,
            difference,
            slope,
            moment: per_lane(|l| common[1].bending[l] * (slope[l] - before[l])),
            shear: SimdVector::default(),
            axial_force,
        }
    }

    /// Finds w of rows from s, d, and the jumps of H.
    #[inline(always)]
    pub fn advance<const UNIFORM: bool>(
        &mut self,
        rows: Range<usize>,
        fixed: PackedCoefficients<'_>,
        axial_force_jump: &[SimdVector],
        moving: &mut [TransverseMotion],
    ) {
        let moving = &mut moving[rows.start..rows.end + 2];
        let Some(n) = moving.len().checked_sub(2) else {
            return;
        };
        let (common, behind) = (&fixed.common[rows.start..], &fixed.common[rows.start + 1..]);
        let (common, behind) = (&common[..n], &behind[..n]);
        let (across, axial_force_jump) = (
            &fixed.across[rows.start..][..n],
            &axial_force_jump[rows.start..][..n],
        );
        let damping = fixed.damping::<UNIFORM>(&rows);
        let mut now = *self;
        for k in 0..n {
            let next = moving[k + 2].s;
            let (difference, slope) = difference_and_slope(&now.s, &next, &behind[k]);
            let bending = &behind[k].bending;
            let moment: SimdVector = per_lane(|l| bending[l] * (slope[l] - now.slope[l]));
            let (shared, transverse) = (&common[k], &across[k]);
            now.axial_force = per_lane(|l| now.axial_force[l] + axial_force_jump[k][l]);
            let shear: SimdVector = per_lane(|l| {
                let bent = (now.moment[l] - moment[l]).mul_add(
                    shared.per_length[l],
                    now.axial_force[l] * transverse.slope[l],
                );
                transverse.tension[l].mul_add(now.difference[l], bent)
            });
            let (d, alpha) = (moving[k].d, &damping[if UNIFORM { 0 } else { k }].alpha);
            moving[k].w = per_lane(|l| {
                transverse.inverse[l].mul_add(shear[l] - now.shear[l], -alpha[l] * d[l])
            });
            (now.difference, now.slope, now.moment, now.shear, now.s) =
                (difference, slope, moment, shear, next);
        }
        *self = now;
    }
}

/// Returns the difference and the slope of s along a segment.
#[inline(always)]
fn difference_and_slope(
    from: &SimdVector,
    to: &SimdVector,
    common: &SharedCoefficients,
) -> (SimdVector, SimdVector) {
    let difference: SimdVector = per_lane(|l| to[l] - from[l]);
    (
        difference,
        per_lane(|l| difference[l] * common.per_length[l]),
    )
}

/// Kernel of motion, with the state it carries from row to row: a from w, then d and s, and the
/// rise of the wire.
#[derive(Clone, Copy)]
pub(in crate::integrator::explicit) struct MotionKernel {
    /// Difference of w between the two rows ahead.
    difference: SimdVector,
    /// r times the second difference of w, at the next row.
    second_difference: SimdVector,
    /// Filter term of the preceding segment.
    shared: SimdVector,
    rise: RiseSum,
}

impl MotionKernel {
    /// Starts before `row`.
    #[inline(always)]
    pub fn before(row: usize, common: &[SharedCoefficients], rows: &[TransverseMotion]) -> Self {
        let rows: [&SimdVector; 4] = std::array::from_fn(|k| &rows[row + k - 2].w);
        let difference: [SimdVector; 3] =
            std::array::from_fn(|k| per_lane(|l| rows[k + 1][l] - rows[k][l]));
        let second_difference: [SimdVector; 2] = std::array::from_fn(|k| {
            let second = &common[row + k - 1].second;
            per_lane(|l| second[l] * (difference[k + 1][l] - difference[k][l]))
        });
        let filter = &common[row - 1].filter;
        Self {
            difference: difference[2],
            second_difference: second_difference[1],
            shared: per_lane(|l| {
                filter[l] * difference[1][l] - (second_difference[1][l] - second_difference[0][l])
            }),
            rise: RiseSum::new(),
        }
    }

    /// Adds zeros if all positions of the rows so far are finite: each has contributed to the rise
    /// of its stripe.
    #[inline(always)]
    pub fn check_finite(&self, finite_check: &mut SimdVector) {
        *finite_check = per_lane(|l| 0.0f64.mul_add(self.rise.sum[l], finite_check[l]));
    }

    /// Moves rows. The rise replaces w; that of a second direction is added to that of the first.
    #[inline(always)]
    pub fn advance<const UNIFORM: bool>(
        &mut self,
        rows: Range<usize>,
        fixed: PackedCoefficients<'_>,
        moving: &mut [TransverseMotion],
        first: Option<&mut [TransverseMotion]>,
    ) {
        let moving = &mut moving[rows.start..rows.end + 2];
        let Some(n) = moving.len().checked_sub(2) else {
            return;
        };
        let (common, behind) = (&fixed.common[rows.start..], &fixed.common[rows.start + 1..]);
        let (common, behind) = (&common[..n], &behind[..n]);
        let damping = fixed.damping::<UNIFORM>(&rows);
        let mut first = first.map(|first| &mut first[rows.start..][..n]);
        let (before, across) = (&fixed.across[rows.start - 1..], &fixed.across[rows.start..]);
        let (before, across) = (&before[..n], &across[..n]);
        let mut now = *self;
        let (mut w, mut ahead) = (moving[0].w, moving[1].w);
        for k in 0..n {
            let next = moving[k + 2].w;
            let difference: SimdVector = per_lane(|l| next[l] - ahead[l]);
            let (filter, second) = (&common[k].filter, &behind[k].second);
            let second_difference: SimdVector =
                per_lane(|l| second[l] * (difference[l] - now.difference[l]));
            let shared: SimdVector = per_lane(|l| {
                filter[l].mul_add(
                    now.difference[l],
                    now.second_difference[l] - second_difference[l],
                )
            });
            let (inverse, lag) = (
                &across[k].inverse,
                &damping[if UNIFORM { 0 } else { k }].lag,
            );
            let a: SimdVector = per_lane(|l| inverse[l].mul_add(now.shared[l] - shared[l], w[l]));
            let row = &mut moving[k];
            let d = per_lane(|l| row.d[l] + a[l]);
            let s = per_lane(|l| row.s[l] + lag[l].mul_add(a[l], d[l]));
            (row.s, row.d) = (s, d);
            let rise = now.rise.add_row(&before[k], s);
            match &mut first {
                None => row.w = rise,
                Some(first) => first[k].w = per_lane(|l| first[k].w[l] + rise[l]),
            }
            (w, ahead) = (ahead, next);
            (now.difference, now.second_difference, now.shared) =
                (difference, second_difference, shared);
        }
        *self = now;
    }
}

/// Rise Σ tan φ Δs from the first point of a stripe on, m.
#[derive(Clone, Copy)]
pub(in crate::integrator::explicit) struct RiseSum {
    sum: SimdVector,
    /// s of the last row, m.
    s: Option<SimdVector>,
}

impl RiseSum {
    pub fn new() -> Self {
        Self {
            sum: SimdVector::default(),
            s: None,
        }
    }

    /// Adds a row and the segment that ends there; returns the rise up to it.
    #[inline(always)]
    pub fn add_row(&mut self, segment: &TransverseCoefficients, s: SimdVector) -> SimdVector {
        let before = self.s.unwrap_or(s);
        let sum = per_lane(|l| segment.slope[l].mul_add(s[l] - before[l], self.sum[l]));
        *self = Self { sum, s: Some(s) };
        sum
    }
}
