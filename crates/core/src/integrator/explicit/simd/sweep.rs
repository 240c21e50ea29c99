//! Sweep over the points of an island that takes a step and finds the forces for the next one,
//! block by block and stage by stage: see [`plan`](crate::integrator::explicit::simd::plan).

use crate::integrator::explicit::simd::kernels::{
    MotionKernel, PackedCoefficients, RiseSum, WireForceKernel,
};
use crate::integrator::explicit::simd::packed::{
    HALO, SIMD_LANES, SimdVector, TransverseMotion, per_lane,
};
use crate::integrator::explicit::{ChainState, Explicit, IslandModel, StripedBlock};
use crate::linalg::Kernel;
use std::ops::Range;

/// Kernel that takes a step, and finds the forces for the next one.
pub(in crate::integrator::explicit) struct ChainSweep<'a, const DIM: usize> {
    pub steps: &'a Explicit<DIM>,
    pub island: &'a IslandModel,
    pub chain: &'a mut ChainState,
}

/// Kernel that finds the forces at the present positions.
pub(in crate::integrator::explicit) struct WireForces<'a, const DIM: usize>(
    pub ChainSweep<'a, DIM>,
);

/// Block, and the state of the chain model.
struct BlockSweep<'a, const DIM: usize> {
    steps: &'a Explicit<DIM>,
    block: &'a StripedBlock,
    chain: &'a mut ChainState,
}

impl<const DIM: usize> Kernel for ChainSweep<'_, DIM> {
    #[inline(always)]
    fn run(self) {
        let Self {
            steps,
            island,
            chain,
        } = self;
        steps.advance_masters(island, chain);
        steps.clear_master_forces(island, chain);
        for block in &island.blocks {
            let sweep = BlockSweep {
                steps,
                block,
                chain,
            };
            match block.is_uniform {
                true => sweep.step::<true>(),
                false => sweep.step::<false>(),
            }
        }
    }
}

impl<const DIM: usize> Kernel for WireForces<'_, DIM> {
    #[inline(always)]
    fn run(self) {
        let ChainSweep {
            steps,
            island,
            chain,
        } = self.0;
        steps.clear_master_forces(island, chain);
        for block in &island.blocks {
            BlockSweep {
                steps,
                block,
                chain,
            }
            .find_forces();
        }
    }
}

impl<'a, const DIM: usize> BlockSweep<'a, DIM> {
    /// Takes a step; blocks that are `UNIFORM` have the same damping everywhere.
    #[inline(always)]
    fn step<const UNIFORM: bool>(mut self) {
        let (block, plan) = (self.block, &self.block.plan);
        let mut motions = [self.motion(0); 2];
        if DIM == 3 {
            motions[1] = self.motion(1);
        }
        let (mut forces, mut forced) = (None, plan.first - 1);
        let (mut moved, mut stretched) = (HALO, block.axial_elements.start);
        for stage in &plan.stages {
            self.move_rows::<UNIFORM>(&mut motions, moved..stage.moved);
            self.add_axial_forces(stretched..stage.stretched);
            (moved, stretched) = (stage.moved, stage.stretched);
            if stage.forced > plan.first {
                if forces.is_none() {
                    forces = Some(self.forces());
                }
                if let Some(all) = &mut forces {
                    self.force_rows::<UNIFORM>(all, forced..stage.forced);
                }
                forced = stage.forced;
            }
        }
        for motion in &motions[..DIM - 1] {
            motion.check_finite(&mut self.chain.finite_check);
        }
        self.steps.copy_ghost_positions(block, self.chain);
        self.steps.rise_to_ghosts(block, self.chain);
        self.finish::<UNIFORM>(forces, forced);
    }

    #[inline(always)]
    fn find_forces(mut self) {
        let (block, plan) = (self.block, &self.block.plan);
        self.steps.copy_ghost_positions(block, self.chain);
        self.measure();
        self.steps.rise_to_ghosts(block, self.chain);
        self.add_axial_forces(block.axial_elements.start..plan.within);
        self.finish::<false>(None, plan.first - 1);
    }

    /// Adds axial forces; straight elements pay nothing for curves.
    #[inline(always)]
    fn add_axial_forces(&mut self, axial_elements: Range<usize>) {
        match self.block.curved.is_empty() {
            true => self
                .steps
                .add_axial_forces::<false>(axial_elements, self.chain),
            false => self
                .steps
                .add_axial_forces::<true>(axial_elements, self.chain),
        }
    }

    /// Returns the constant coefficients of a transverse direction.
    #[inline(always)]
    fn fixed(&self, across: usize) -> PackedCoefficients<'a> {
        let (steps, which) = (self.steps, self.block.rows.clone());
        PackedCoefficients {
            common: &steps.common[which.clone()],
            damping: &steps.damping[which.clone()],
            across: &steps.transverse[across][which],
        }
    }

    /// Returns the moving rows of a transverse direction.
    #[inline(always)]
    fn rows(&mut self, across: usize) -> &mut [TransverseMotion] {
        &mut self.chain.moving[across][self.block.rows.clone()]
    }

    #[inline(always)]
    fn motion(&mut self, across: usize) -> MotionKernel {
        MotionKernel::before(HALO, self.fixed(across).common, self.rows(across))
    }

    #[inline(always)]
    fn move_rows<const UNIFORM: bool>(
        &mut self,
        motions: &mut [MotionKernel; 2],
        which: Range<usize>,
    ) {
        let fixed = self.fixed(0);
        motions[0].advance::<UNIFORM>(which.clone(), fixed, self.rows(0), None);
        if DIM == 3 {
            let (fixed, block_rows) = (self.fixed(1), &self.block.rows);
            if let [first, second] = &mut self.chain.moving[..] {
                let (first, second) = (
                    &mut first[block_rows.clone()],
                    &mut second[block_rows.clone()],
                );
                motions[1].advance::<UNIFORM>(which, fixed, second, Some(first));
            }
        }
    }

    /// Finds the rise of the wire up to each point, from the positions.
    #[inline(always)]
    fn measure(&mut self) {
        for c in 0..DIM - 1 {
            let fixed = self.fixed(c);
            let mut rise = RiseSum::new();
            for k in self.block.plan.rows.clone() {
                let up_to_row = rise.add_row(&fixed.across[k - 1], self.rows(c)[k].s);
                let first = &mut self.rows(0)[k].w;
                *first = per_lane(|l| {
                    if c == 0 {
                        up_to_row[l]
                    } else {
                        first[l] + up_to_row[l]
                    }
                });
            }
        }
    }

    /// Starts the forces before the first row that does not wait.
    #[inline(always)]
    fn forces(&mut self) -> [WireForceKernel; 2] {
        let plan = &self.block.plan;
        let mut axial_force = SimdVector::default();
        for l in 0..SIMD_LANES {
            axial_force[l] = self.chain.axial_force[plan.axial_forces[l]];
        }
        self.forces_before(plan.first - 1, axial_force)
    }

    /// Starts the forces before a row. Closures would not be compiled for wide vectors.
    #[inline(always)]
    fn forces_before(&mut self, row: usize, axial_force: SimdVector) -> [WireForceKernel; 2] {
        let mut all = [WireForceKernel::before(row, self.fixed(0), self.rows(0), axial_force); 2];
        if DIM == 3 {
            all[1] = WireForceKernel::before(row, self.fixed(1), self.rows(1), axial_force);
        }
        all
    }

    #[inline(always)]
    fn force_rows<const UNIFORM: bool>(
        &mut self,
        forces: &mut [WireForceKernel; 2],
        which: Range<usize>,
    ) {
        for c in 0..DIM - 1 {
            let (fixed, block_rows) = (self.fixed(c), &self.block.rows);
            let ChainState {
                moving,
                axial_force_jump,
                ..
            } = &mut *self.chain;
            let (axial_force_jump, rows) = (
                &axial_force_jump[block_rows.clone()],
                &mut moving[c][block_rows.clone()],
            );
            forces[c].advance::<UNIFORM>(which.clone(), fixed, axial_force_jump, rows);
        }
    }

    /// Finds the forces of the remaining rows: the last ones, and those that wait.
    #[inline(always)]
    fn finish<const UNIFORM: bool>(&mut self, begun: Option<[WireForceKernel; 2]>, forced: usize) {
        let plan = &self.block.plan;
        self.steps
            .add_axial_forces_over_seams(self.block, self.chain);
        if plan.first < plan.rows.end {
            let mut forces = match begun {
                Some(forces) => forces,
                None => self.forces(),
            };
            self.force_rows::<UNIFORM>(&mut forces, forced..plan.rows.end);
        }
        let mut early = self.forces_before(HALO - 1, SimdVector::default());
        self.force_rows::<UNIFORM>(&mut early, HALO - 1..plan.first);
    }
}
