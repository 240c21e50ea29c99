//! Tied ends: ends of wires at a point of another wire, which they follow and transfer their forces
//! to.

use crate::integrator::explicit::simd::packed::{
    SIMD_LANES, SimdVector, TransverseMotion, row_and_lane,
};
use crate::integrator::explicit::stepping::filtered_acceleration;
use crate::integrator::explicit::{ChainState, Explicit, IslandModel};

/// Packed position: row and SIMD lane.
#[derive(Debug, Clone, Copy)]
struct PackedPosition {
    row: u32,
    simd_lane: u32,
}

impl PackedPosition {
    fn of(packed_index: usize) -> Self {
        let (row, simd_lane) = row_and_lane(packed_index);
        let (row, simd_lane) = (row as u32, simd_lane as u32);
        Self { row, simd_lane }
    }

    #[inline(always)]
    fn read(self, rows: &[TransverseMotion]) -> f64 {
        rows[self.row as usize].w[self.simd_lane as usize % SIMD_LANES]
    }

    #[inline(always)]
    fn w(self, rows: &mut [TransverseMotion]) -> &mut f64 {
        let w: &mut SimdVector = &mut rows[self.row as usize].w;
        &mut w[self.simd_lane as usize % SIMD_LANES]
    }
}

/// Tied end, with the data of the point it is tied to.
#[derive(Debug, Clone)]
pub(in crate::integrator::explicit) struct TiedEnd {
    island: PackedPosition,
    /// Stencil of the tie's master point: the point and its two neighbours on both sides.
    stencil: [PackedPosition; 5],
    /// Filter weights of the segments at the master point, and of its neighbours and itself, kg/s².
    filter: [f64; 2],
    second: [f64; 3],
    /// Inverse mass h²/m of the master point in each transverse direction, s²/kg.
    inverse: [f64; 2],
}

impl TiedEnd {
    pub fn new<const DIM: usize>(steps: &Explicit<DIM>, tied: usize, tie_master: usize) -> Self {
        let (row, simd_lane) = row_and_lane(tie_master);
        let near = &steps.common[row - 1..=row + 1];
        let across = |c: usize| {
            steps
                .transverse
                .get(c)
                .map_or(0.0, |r| r[row].inverse[simd_lane])
        };
        Self {
            island: PackedPosition::of(tied),
            stencil: steps.stencil(tie_master).map(PackedPosition::of),
            filter: [0, 1].map(|k| near[k].filter[simd_lane]),
            second: [0, 1, 2].map(|k| near[k].second[simd_lane]),
            inverse: [0, 1].map(across),
        }
    }
}

impl<const DIM: usize> Explicit<DIM> {
    /// Accelerates tied ends like their master points; they have no mass and no filter.
    #[inline(always)]
    pub(in crate::integrator::explicit) fn accelerate_tied_ends(
        &self,
        island: &IslandModel,
        chain: &mut ChainState,
    ) {
        for (across, rows) in chain.moving.iter_mut().enumerate() {
            let rows = &mut rows[..];
            for tied in &island.tied_ends {
                let w: [f64; 5] = std::array::from_fn(|k| tied.stencil[k].read(rows));
                let inverse = tied.inverse[across];
                *tied.island.w(rows) = filtered_acceleration(w, tied.filter, tied.second, inverse);
            }
        }
    }

    /// Transfers the forces on tied ends to their master points.
    #[inline(always)]
    pub(in crate::integrator::explicit) fn transfer_tied_forces(
        &self,
        island: &IslandModel,
        chain: &mut ChainState,
    ) {
        for (across, rows) in chain.moving.iter_mut().enumerate() {
            let rows = &mut rows[..];
            for tied in &island.tied_ends {
                let force = std::mem::take(tied.island.w(rows));
                *tied.stencil[2].w(rows) += tied.inverse[across] * force;
            }
        }
    }
}
