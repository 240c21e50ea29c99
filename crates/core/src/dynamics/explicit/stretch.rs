//! H of each reach.

use super::{Explicit, Grid, Own};
use crate::linalg::Kernel;
use std::ops::Range;

/// H of the reaches of an island, and what it pulls the masters along by.
pub(super) struct Stretch<'a, const DIM: usize> {
    pub p: &'a Explicit<DIM>,
    pub own: &'a Own,
    pub grid: &'a mut Grid,
}

impl<const DIM: usize> Kernel for Stretch<'_, DIM> {
    #[inline(always)]
    fn run(self) {
        let (p, own, grid) = (self.p, self.own, self.grid);
        let Range { start, end } = own.points;
        for across in 0..DIM - 1 {
            let (slope, s) = (&p.slope[across], &grid.lagged[across]);
            rise(
                across == 0,
                &slope[start..end],
                &s[start..=end],
                &mut grid.thrust[start..end],
            );
        }
        let [x, d] = &grid.x;
        for reach in &p.reaches[own.reaches.clone()] {
            let [a, b] = reach.masters;
            let thrust = &mut grid.thrust[reach.segments.clone()];
            let longer = x[b] - x[a] + p.masters[b][2] * d[b] - p.masters[a][2] * d[a];
            let force = reach.stiffness * (longer + sum(thrust));
            thrust.fill(force);
            grid.pull[a] += force;
            grid.pull[b] -= force;
        }
    }
}

/// tan φ (sⱼ₊₁ − sⱼ) of each segment, in the place of what stood there or in addition to it.
#[inline(always)]
fn rise(first: bool, slope: &[f64], s: &[f64], rise: &mut [f64]) {
    let n = rise.len();
    let (slope, s, next) = (&slope[..n], &s[..n], &s[1..][..n]);
    for k in 0..n {
        let before = if first { 0.0 } else { rise[k] };
        rise[k] = before + slope[k] * (next[k] - s[k]);
    }
}

/// Sum of a few numbers.
#[inline(always)]
fn sum(numbers: &[f64]) -> f64 {
    let mut sums = [0.0; 4];
    let (fours, rest) = numbers.as_chunks::<4>();
    for four in fours {
        for k in 0..4 {
            sums[k] += four[k];
        }
    }
    for (sum, number) in sums.iter_mut().zip(rest) {
        *sum += number;
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3])
}
