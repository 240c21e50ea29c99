//! Axial force H of each axial element, and the motion of the masters.

use crate::integrator::explicit::simd::packed::{
    SIMD_LANES, SimdVector, TransverseMotion, per_lane, row_and_lane,
};
use crate::integrator::explicit::{AxialElement, ChainState, Explicit, IslandModel, StripedBlock};
use std::ops::Range;

#[inline(always)]
fn rise_at(first: &[TransverseMotion], packed_index: usize) -> f64 {
    let (row, simd_lane) = row_and_lane(packed_index);
    first[row].w[simd_lane]
}

/// Returns the lateral position y of a point, m, in three dimensions.
#[inline(always)]
fn lateral_at(first: &[TransverseMotion], packed_index: usize) -> f64 {
    let (row, simd_lane) = row_and_lane(packed_index);
    first[row].s[simd_lane]
}

impl<const DIM: usize> Explicit<DIM> {
    /// Advances the masters of an island by one step.
    #[inline(always)]
    pub(in crate::integrator::explicit) fn advance_masters(
        &self,
        island: &IslandModel,
        chain: &mut ChainState,
    ) {
        let which = island.masters.clone();
        let (inverse, damping) = (&self.masters.inverse, &self.masters.damping);
        let numbers = inverse[which.clone()].iter().zip(&damping[which.clone()]);
        let numbers = numbers.zip(&chain.master_force[which.clone()]);
        let [x, d] = &mut chain.x;
        let moving = x[which.clone()].iter_mut().zip(&mut d[which]);
        for ((x, d), ((inverse, damping), master_force)) in moving.zip(numbers) {
            *d += inverse * master_force - damping * *d;
            *x += *d;
        }
        let mut sums = SimdVector::default();
        for four in chain.x[0][island.masters.clone()].chunks(SIMD_LANES) {
            (0..four.len()).for_each(|l| sums[l] += four[l]);
        }
        let finite_check = &mut chain.finite_check;
        *finite_check = per_lane(|l| 0.0f64.mul_add(sums[l], finite_check[l]));
    }

    /// Clears the forces on the masters, and sets their positions x + (β/h) d.
    #[inline(always)]
    pub(in crate::integrator::explicit) fn clear_master_forces(
        &self,
        island: &IslandModel,
        chain: &mut ChainState,
    ) {
        let which = island.masters.clone();
        chain.master_force[which.clone()].fill(0.0);
        let [x, d] = &chain.x;
        let lag = &self.masters.lag[which.clone()];
        let parts = x[which.clone()].iter().zip(&d[which.clone()]).zip(lag);
        for (s, ((x, d), lag)) in chain.lagged[which].iter_mut().zip(parts) {
            *s = x + lag * d;
        }
    }

    /// Finds H of axial elements, and adds it to the masters; without `CURVED` all are straight.
    #[inline(always)]
    pub(in crate::integrator::explicit) fn add_axial_forces<const CURVED: bool>(
        &self,
        axial_elements: Range<usize>,
        chain: &mut ChainState,
    ) {
        let mut forces = AxialForces::new(chain);
        let (mut number, mut left) = (axial_elements.start, &self.axial_elements[axial_elements]);
        while let [axial_element, behind @ ..] = left {
            match left.split_first_chunk::<SIMD_LANES>() {
                Some((four, behind)) if axial_element.is_packed => {
                    forces.add_packed::<CURVED>(number, four);
                    (number, left) = (number + SIMD_LANES, behind);
                }
                _ => {
                    forces.add::<CURVED>(number, axial_element, 0.0);
                    (number, left) = (number + 1, behind);
                }
            }
        }
    }

    /// Adds the forces that H exerts at the ends of axial elements in curves, to the inside, N.
    /// Call after the forces of wires.
    pub(in crate::integrator::explicit) fn add_curve_forces(
        &self,
        island: &IslandModel,
        chain: &mut ChainState,
    ) {
        for &number in island.blocks.iter().flat_map(|block| &block.curved) {
            let number = number as usize;
            let axial_element = &self.axial_elements[number];
            let force = axial_element.half_turn * chain.axial_force[number];
            for packed_index in axial_element.ends {
                self.add_point_force(chain, self.home[packed_index as usize], 1, force);
            }
        }
    }

    /// Finds H of axial elements that span a seam, and its jump on both sides of each seam.
    #[inline(always)]
    pub(in crate::integrator::explicit) fn add_axial_forces_over_seams(
        &self,
        block: &StripedBlock,
        chain: &mut ChainState,
    ) {
        for number in block.plan.within..block.axial_elements.end {
            let ghosts = block
                .seams
                .iter()
                .filter(|seam| seam.spanning == Some(number));
            let rise_before = ghosts
                .map(|seam| rise_at(&chain.moving[0], seam.ghost_behind))
                .sum();
            AxialForces::new(chain).add::<true>(number, &self.axial_elements[number], rise_before);
        }
        for seam in &block.seams {
            let last_before = seam
                .last_before
                .map_or(0.0, |number| chain.axial_force[number]);
            set_jump(&mut chain.axial_force_jump, seam.ghost_before, last_before);
            if let Some(first_behind) = seam.first_behind {
                let from = self.axial_elements[first_behind].ends[0] as usize;
                set_jump(
                    &mut chain.axial_force_jump,
                    from,
                    chain.axial_force[first_behind] - last_before,
                );
            }
        }
    }
}

/// Sets the axial force of a segment minus that of the preceding one, N.
#[inline(always)]
fn set_jump(list: &mut [SimdVector], packed_index: usize, axial_force: f64) {
    let (row, simd_lane) = row_and_lane(packed_index);
    list[row][simd_lane] = axial_force;
}

/// Data that axial elements read and write. Slices, not `Vec`s: without them the compiler must
/// assume aliasing and reload the pointers in the loop.
struct AxialForces<'a> {
    /// Rows of the first transverse direction, which hold the rise.
    first: &'a [TransverseMotion],
    jump: &'a mut [SimdVector],
    lagged: &'a [f64],
    master_force: &'a mut [f64],
    axial_force: &'a mut [f64],
}

impl<'a> AxialForces<'a> {
    #[inline(always)]
    fn new(chain: &'a mut ChainState) -> Self {
        Self {
            first: &chain.moving[0],
            jump: &mut chain.axial_force_jump,
            lagged: &chain.lagged,
            master_force: &mut chain.master_force,
            axial_force: &mut chain.axial_force,
        }
    }

    /// Finds H of four axial elements that share packed rows.
    #[inline(always)]
    fn add_packed<const CURVED: bool>(
        &mut self,
        number: usize,
        axial_elements: &[AxialElement; SIMD_LANES],
    ) {
        let first = &axial_elements[0];
        let [a, b] = first.masters.map(|m| m as usize);
        let [from, to] = first
            .ends
            .map(|packed_index| row_and_lane(packed_index as usize).0);
        let rise: SimdVector = {
            let (from, to) = (&self.first[from], &self.first[to]);
            let straight = per_lane(|l| to.w[l] - from.w[l]);
            match CURVED {
                true => {
                    per_lane(|l| straight[l] - axial_elements[l].half_turn * (from.s[l] + to.s[l]))
                }
                false => straight,
            }
        };
        let (lagged, further) = (
            &self.lagged[a..][..SIMD_LANES],
            &self.lagged[b..][..SIMD_LANES],
        );
        let force = per_lane(|l| axial_elements[l].stiffness * (further[l] - lagged[l] + rise[l]));
        let master_force = &mut self.master_force[a..][..SIMD_LANES];
        (0..SIMD_LANES).for_each(|l| master_force[l] += force[l]);
        let master_force = &mut self.master_force[b..][..SIMD_LANES];
        (0..SIMD_LANES).for_each(|l| master_force[l] -= force[l]);
        let previous = &self.axial_force[first.previous as usize..][..SIMD_LANES];
        self.jump[from] = per_lane(|l| force[l] - previous[l]);
        self.axial_force[number..][..SIMD_LANES].copy_from_slice(&force[..]);
    }

    /// Finds H of one axial element. `rise_before`: rise of the stripes before the one it ends in,
    /// m.
    #[inline(always)]
    fn add<const CURVED: bool>(
        &mut self,
        number: usize,
        axial_element: &AxialElement,
        rise_before: f64,
    ) {
        let [a, b] = axial_element.masters.map(|m| m as usize);
        let [from, to] = axial_element.ends.map(|packed_index| packed_index as usize);
        let mut rise = rise_at(self.first, to) - rise_at(self.first, from) + rise_before;
        if CURVED {
            rise -= axial_element.half_turn
                * (lateral_at(self.first, from) + lateral_at(self.first, to));
        }
        let force = axial_element.stiffness * (self.lagged[b] - self.lagged[a] + rise);
        self.master_force[a] += force;
        self.master_force[b] -= force;
        set_jump(
            self.jump,
            from,
            force - self.axial_force[axial_element.previous as usize],
        );
        self.axial_force[number] = force;
    }
}
