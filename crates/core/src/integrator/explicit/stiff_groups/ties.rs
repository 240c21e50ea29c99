//! Ends of wires at a point of another: they go with it, and what pulls at them pulls at it.

use crate::integrator::explicit::simd::rows::{LANES, Moving, Wide, place};
use crate::integrator::explicit::stepping::accelerated;
use crate::integrator::explicit::{Explicit, Grid, Own};

/// Row and lane.
#[derive(Debug, Clone, Copy)]
struct Seat {
    row: u32,
    lane: u32,
}

impl Seat {
    fn of(slot: usize) -> Self {
        let (row, lane) = place(slot);
        let (row, lane) = (row as u32, lane as u32);
        Self { row, lane }
    }

    #[inline(always)]
    fn read(self, rows: &[Moving]) -> f64 {
        rows[self.row as usize].w[self.lane as usize % LANES]
    }

    #[inline(always)]
    fn w(self, rows: &mut [Moving]) -> &mut f64 {
        let w: &mut Wide = &mut rows[self.row as usize].w;
        &mut w[self.lane as usize % LANES]
    }
}

/// What a step needs of an end and of the point that it goes with, found once.
#[derive(Debug, Clone)]
pub(in crate::integrator::explicit) struct Guest {
    own: Seat,
    /// Its owner, and the two points on both sides of that.
    around: [Seat; 5],
    /// Of the segments before and behind the owner, and of the points beside it and itself, kg/s².
    filter: [f64; 2],
    second: [f64; 3],
    /// h²/m of the owner in each direction across, s²/kg.
    inverse: [f64; 2],
}

impl Guest {
    pub fn new<const DIM: usize>(steps: &Explicit<DIM>, guest: usize, owner: usize) -> Self {
        let (row, lane) = place(owner);
        let near = &steps.common[row - 1..=row + 1];
        let across = |c: usize| steps.across.get(c).map_or(0.0, |r| r[row].inverse[lane]);
        Self {
            own: Seat::of(guest),
            around: steps.around(owner).map(Seat::of),
            filter: [0, 1].map(|k| near[k].filter[lane]),
            second: [0, 1, 2].map(|k| near[k].second[lane]),
            inverse: [0, 1].map(across),
        }
    }
}

impl<const DIM: usize> Explicit<DIM> {
    /// Ends get h² times the acceleration of what they go with: they have no mass, and nothing that filters.
    #[inline(always)]
    pub(in crate::integrator::explicit) fn take_along(&self, own: &Own, grid: &mut Grid) {
        for (across, rows) in grid.moving.iter_mut().enumerate() {
            let rows = &mut rows[..];
            for guest in &own.guests {
                let w: [f64; 5] = std::array::from_fn(|k| guest.around[k].read(rows));
                let inverse = guest.inverse[across];
                *guest.own.w(rows) = accelerated(w, guest.filter, guest.second, inverse);
            }
        }
    }

    /// What pulls at ends pulls at what they go with.
    #[inline(always)]
    pub(in crate::integrator::explicit) fn hand_over(&self, own: &Own, grid: &mut Grid) {
        for (across, rows) in grid.moving.iter_mut().enumerate() {
            let rows = &mut rows[..];
            for guest in &own.guests {
                let felt = std::mem::take(guest.own.w(rows));
                *guest.around[2].w(rows) += guest.inverse[across] * felt;
            }
        }
    }
}
