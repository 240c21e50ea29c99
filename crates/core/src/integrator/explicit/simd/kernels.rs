//! What a step does with rows, one after the other, in one direction across.
//!
//!   Qⱼ = Tⱼ (sⱼ₊₁ − sⱼ) − (mⱼ₊₁ − mⱼ)/L + H tan φⱼ,   mᵢ = (EI/ℓ̄) (s′ᵢ − s′ᵢ₋₁),   s′ⱼ = (sⱼ₊₁ − sⱼ)/L
//!   w = h² M⁻¹ (Qᵢ − Qᵢ₋₁) − α h d,        h² a = w + M⁻¹ E w
//!
//! Each takes some rows and leaves what the next ones need, so that rows may come in pieces.

use crate::integrator::explicit::simd::rows::{Across, Common, Damped, Moving, Wide, each};
use std::ops::Range;

/// Numbers of a direction that stay, row by row.
#[derive(Clone, Copy)]
pub(in crate::integrator::explicit) struct Fixed<'a> {
    pub common: &'a [Common],
    pub damped: &'a [Damped],
    pub across: &'a [Across],
}

impl<'a> Fixed<'a> {
    /// What damps some rows, of which an `EVEN` block has one for all.
    #[inline(always)]
    fn damped<const EVEN: bool>(&self, rows: &Range<usize>) -> &'a [Damped] {
        match EVEN {
            true => &self.damped[..1],
            false => &self.damped[rows.start..rows.end],
        }
    }
}

/// Forces of wires, on their way through the rows.
#[derive(Clone, Copy)]
pub(in crate::integrator::explicit) struct Forces {
    /// s of the next row; s, s′ of the segment behind it; moment and shear before that, H.
    s: Wide,
    by: Wide,
    slope: Wide,
    moment: Wide,
    shear: Wide,
    thrust: Wide,
}

impl Forces {
    /// Before a row, with H of the segment before the one that ends there.
    ///
    /// The first row finds the shear for the second one; its own w is of no use.
    #[inline(always)]
    pub fn before(row: usize, fixed: Fixed<'_>, rows: &[Moving], thrust: Wide) -> Self {
        let common = &fixed.common[row - 1..=row];
        let rows = &rows[row - 1..=row + 1];
        let (_, before) = turn(&rows[0].s, &rows[1].s, &common[0]);
        let (by, slope) = turn(&rows[1].s, &rows[2].s, &common[1]);
        Self {
            s: rows[2].s,
            by,
            slope,
            moment: each(|l| common[1].bending[l] * (slope[l] - before[l])),
            shear: Wide::default(),
            thrust,
        }
    }

    /// w of some rows, from s, d, and what H has more in a segment than in the one before it.
    #[inline(always)]
    pub fn go<const EVEN: bool>(
        &mut self,
        rows: Range<usize>,
        fixed: Fixed<'_>,
        more: &[Wide],
        moving: &mut [Moving],
    ) {
        let moving = &mut moving[rows.start..rows.end + 2];
        let Some(n) = moving.len().checked_sub(2) else {
            return;
        };
        let (common, behind) = (&fixed.common[rows.start..], &fixed.common[rows.start + 1..]);
        let (common, behind) = (&common[..n], &behind[..n]);
        let (across, more) = (&fixed.across[rows.start..][..n], &more[rows.start..][..n]);
        let damped = fixed.damped::<EVEN>(&rows);
        let mut at = *self;
        for k in 0..n {
            let next = moving[k + 2].s;
            let (by, slope) = turn(&at.s, &next, &behind[k]);
            let bending = &behind[k].bending;
            let moment: Wide = each(|l| bending[l] * (slope[l] - at.slope[l]));
            let (here, this) = (&common[k], &across[k]);
            at.thrust = each(|l| at.thrust[l] + more[k][l]);
            let shear: Wide = each(|l| {
                let bent = (at.moment[l] - moment[l])
                    .mul_add(here.per_length[l], at.thrust[l] * this.slope[l]);
                this.tension[l].mul_add(at.by[l], bent)
            });
            let (d, alpha) = (moving[k].d, &damped[if EVEN { 0 } else { k }].alpha);
            moving[k].w =
                each(|l| this.inverse[l].mul_add(shear[l] - at.shear[l], -alpha[l] * d[l]));
            (at.by, at.slope, at.moment, at.shear, at.s) = (by, slope, moment, shear, next);
        }
        *self = at;
    }
}

/// Difference and slope of a segment.
#[inline(always)]
fn turn(from: &Wide, to: &Wide, common: &Common) -> (Wide, Wide) {
    let by: Wide = each(|l| to[l] - from[l]);
    (by, each(|l| by[l] * common.per_length[l]))
}

/// The motion of a step, on its way through the rows: a from w, then d and s, and the rise of the wire.
#[derive(Clone, Copy)]
pub(in crate::integrator::explicit) struct Motion {
    /// By how much w of the row behind the next one is more.
    by: Wide,
    /// r times the difference of two such steps, at the next row.
    turn: Wide,
    /// What the segment before it shares.
    shared: Wide,
    rise: Rise,
}

impl Motion {
    /// Before a row.
    #[inline(always)]
    pub fn before(row: usize, common: &[Common], rows: &[Moving]) -> Self {
        let rows: [&Wide; 4] = std::array::from_fn(|k| &rows[row + k - 2].w);
        let by: [Wide; 3] = std::array::from_fn(|k| each(|l| rows[k + 1][l] - rows[k][l]));
        let turn: [Wide; 2] = std::array::from_fn(|k| {
            let second = &common[row + k - 1].second;
            each(|l| second[l] * (by[k + 1][l] - by[k][l]))
        });
        let filter = &common[row - 1].filter;
        Self {
            by: by[2],
            turn: turn[1],
            shared: each(|l| filter[l] * by[1][l] - (turn[1][l] - turn[0][l])),
            rise: Rise::begin(),
        }
    }

    /// Adds zeros if all places of the rows so far are finite: each has added its way to the rise of its strand.
    #[inline(always)]
    pub fn tell(&self, sound: &mut Wide) {
        *sound = each(|l| 0.0f64.mul_add(self.rise.sum[l], sound[l]));
    }

    /// Move some rows. The rise takes the place of w; that of a second direction is added to that of the first.
    #[inline(always)]
    pub fn go<const EVEN: bool>(
        &mut self,
        rows: Range<usize>,
        fixed: Fixed<'_>,
        moving: &mut [Moving],
        first: Option<&mut [Moving]>,
    ) {
        let moving = &mut moving[rows.start..rows.end + 2];
        let Some(n) = moving.len().checked_sub(2) else {
            return;
        };
        let (common, behind) = (&fixed.common[rows.start..], &fixed.common[rows.start + 1..]);
        let (common, behind) = (&common[..n], &behind[..n]);
        let damped = fixed.damped::<EVEN>(&rows);
        let mut first = first.map(|first| &mut first[rows.start..][..n]);
        let (before, across) = (&fixed.across[rows.start - 1..], &fixed.across[rows.start..]);
        let (before, across) = (&before[..n], &across[..n]);
        let mut at = *self;
        let (mut w, mut ahead) = (moving[0].w, moving[1].w);
        for k in 0..n {
            let next = moving[k + 2].w;
            let by: Wide = each(|l| next[l] - ahead[l]);
            let (filter, second) = (&common[k].filter, &behind[k].second);
            let turn: Wide = each(|l| second[l] * (by[l] - at.by[l]));
            let shared: Wide = each(|l| filter[l].mul_add(at.by[l], at.turn[l] - turn[l]));
            let (inverse, lag) = (&across[k].inverse, &damped[if EVEN { 0 } else { k }].lag);
            let a: Wide = each(|l| inverse[l].mul_add(at.shared[l] - shared[l], w[l]));
            let row = &mut moving[k];
            let d = each(|l| row.d[l] + a[l]);
            let s = each(|l| row.s[l] + lag[l].mul_add(a[l], d[l]));
            (row.s, row.d) = (s, d);
            let rise = at.rise.go_on(&before[k], s);
            match &mut first {
                None => row.w = rise,
                Some(first) => first[k].w = each(|l| first[k].w[l] + rise[l]),
            }
            (w, ahead) = (ahead, next);
            (at.by, at.turn, at.shared) = (by, turn, shared);
        }
        *self = at;
    }
}

/// Σ tan φ Δs, from the first point of a strand on.
#[derive(Clone, Copy)]
pub(in crate::integrator::explicit) struct Rise {
    sum: Wide,
    /// s of the last row.
    s: Option<Wide>,
}

impl Rise {
    pub fn begin() -> Self {
        Self {
            sum: Wide::default(),
            s: None,
        }
    }

    /// On to a row, with the segment that ends there.
    #[inline(always)]
    pub fn go_on(&mut self, segment: &Across, s: Wide) -> Wide {
        let before = self.s.unwrap_or(s);
        let sum = each(|l| segment.slope[l].mul_add(s[l] - before[l], self.sum[l]));
        *self = Self { sum, s: Some(s) };
        sum
    }
}
