//! The sweep over the points of an island that takes a step and finds the forces for the next one, block by block
//! and stage by stage: see [`plan`](super::plan).

use super::kernels::{Fixed, Forces, Motion, Rise};
use super::rows::{HALO, LANES, Moving, Tensed, Wide};
use super::{Block, Explicit, Grid, Own};
use crate::linalg::Kernel;
use std::ops::Range;

/// Take a step, and find the forces for the next one.
pub(super) struct Sweep<'a, const DIM: usize> {
    pub p: &'a Explicit<DIM>,
    pub own: &'a Own,
    pub grid: &'a mut Grid,
}

/// Find the forces where the points are.
pub(super) struct Stand<'a, const DIM: usize>(pub Sweep<'a, DIM>);

/// A block and what moves there.
struct On<'a, const DIM: usize> {
    p: &'a Explicit<DIM>,
    own: &'a Block,
    grid: &'a mut Grid,
}

impl<const DIM: usize> Kernel for Sweep<'_, DIM> {
    #[inline(always)]
    fn run(self) {
        let Self { p, own, grid } = self;
        p.slide(own, grid);
        p.release(own, grid);
        for own in &own.blocks {
            On { p, own, grid }.step();
        }
    }
}

impl<const DIM: usize> Kernel for Stand<'_, DIM> {
    #[inline(always)]
    fn run(self) {
        let Sweep { p, own, grid } = self.0;
        p.release(own, grid);
        for own in &own.blocks {
            On { p, own, grid }.stand();
        }
    }
}

impl<const DIM: usize> On<'_, DIM> {
    #[inline(always)]
    fn step(mut self) {
        let (own, plan) = (self.own, &self.own.plan);
        let mut motions = [self.motion(0), self.motion(DIM - 2)];
        let (mut forces, mut forced) = (None, plan.first - 1);
        let (mut moved, mut stretched) = (HALO, own.reaches.start);
        for stage in &plan.stages {
            self.move_rows(&mut motions, moved..stage.moved);
            self.p.stretch(stretched..stage.stretched, self.grid);
            (moved, stretched) = (stage.moved, stage.stretched);
            if stage.forced > plan.first {
                let mut all = forces.unwrap_or_else(|| self.forces());
                self.force_rows(&mut all, forced..stage.forced);
                (forces, forced) = (Some(all), stage.forced);
            }
        }
        self.p.copy_places(own, self.grid);
        self.p.rise_to_tails(own, self.grid);
        self.finish(forces, forced);
    }

    #[inline(always)]
    fn stand(mut self) {
        let (own, plan) = (self.own, &self.own.plan);
        self.p.copy_places(own, self.grid);
        for c in 0..DIM - 1 {
            self.measure(c);
        }
        self.p.rise_to_tails(own, self.grid);
        self.p.stretch(own.reaches.start..plan.within, self.grid);
        self.finish(None, plan.first - 1);
    }

    /// Rows of a direction across.
    #[inline(always)]
    fn rows(&mut self, across: usize) -> (Fixed<'_>, &mut [Tensed], &mut [Moving]) {
        let which = self.own.rows.clone();
        let fixed = Fixed {
            common: &self.p.common[which.clone()],
            across: &self.p.across[across][which.clone()],
        };
        let tensed = &mut self.grid.tensed[which.clone()];
        (fixed, tensed, &mut self.grid.moving[across][which])
    }

    #[inline(always)]
    fn motion(&mut self, across: usize) -> Motion {
        let (fixed, _, rows) = self.rows(across);
        Motion::before(HALO, fixed.common, rows)
    }

    #[inline(always)]
    fn move_rows(&mut self, motions: &mut [Motion; 2], which: Range<usize>) {
        for c in 0..DIM - 1 {
            let (fixed, tensed, rows) = self.rows(c);
            if c == 0 {
                motions[c].go::<true>(which.clone(), fixed, tensed, rows);
            } else {
                motions[c].go::<false>(which.clone(), fixed, tensed, rows);
            }
        }
    }

    /// The rise of the wire up to each point, from where they are.
    #[inline(always)]
    fn measure(&mut self, c: usize) {
        let own = self.own.plan.rows.clone();
        let (fixed, tensed, rows) = self.rows(c);
        let mut rise = Rise::begin();
        for k in own {
            if c == 0 {
                rise.go_on::<true>(&fixed.across[k - 1], &rows[k].s, &mut tensed[k]);
            } else {
                rise.go_on::<false>(&fixed.across[k - 1], &rows[k].s, &mut tensed[k]);
            }
        }
    }

    /// Before the row before the first one that does not wait.
    #[inline(always)]
    fn forces(&mut self) -> [Forces; 2] {
        let plan = &self.own.plan;
        let mut thrust = Wide::default();
        for l in 0..LANES {
            thrust[l] = self.grid.thrust[plan.thrusts[l]];
        }
        let mut of = |c: usize| {
            let (fixed, _, rows) = self.rows(c);
            Forces::before(plan.first - 1, fixed, rows, thrust)
        };
        [of(0), of(DIM - 2)]
    }

    #[inline(always)]
    fn force_rows(&mut self, forces: &mut [Forces; 2], which: Range<usize>) {
        for c in 0..DIM - 1 {
            let (fixed, tensed, rows) = self.rows(c);
            forces[c].go(which.clone(), fixed, tensed, rows);
        }
    }

    /// Forces of the other rows: the last ones, and those that wait.
    #[inline(always)]
    fn finish(&mut self, begun: Option<[Forces; 2]>, forced: usize) {
        let plan = &self.own.plan;
        self.p.stretch_over_cuts(self.own, self.grid);
        if plan.first < plan.rows.end {
            let mut forces = begun.unwrap_or_else(|| self.forces());
            self.force_rows(&mut forces, forced..plan.rows.end);
        }
        for c in 0..DIM - 1 {
            let (fixed, tensed, rows) = self.rows(c);
            let mut early = Forces::before(HALO - 1, fixed, rows, Wide::default());
            early.go(HALO - 1..plan.first, fixed, tensed, rows);
        }
    }
}
