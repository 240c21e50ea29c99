//! The sweep over the points of an island that takes a step and finds the forces for the next one, stage by
//! stage: see [`plan`](super::plan).

use super::kernels::{Fixed, Forces, Motion, Rise};
use super::rows::{HALO, LANES, Moving, Tensed, Wide};
use super::{Explicit, Grid, Own};
use crate::linalg::Kernel;
use std::ops::Range;

/// An island and what moves there.
pub(super) struct On<'a, const DIM: usize> {
    pub p: &'a Explicit<DIM>,
    pub own: &'a Own,
    pub grid: &'a mut Grid,
}

/// Take a step, and find the forces for the next one.
pub(super) struct Sweep<'a, const DIM: usize>(pub On<'a, DIM>);

/// Find the forces where the points are.
pub(super) struct Stand<'a, const DIM: usize>(pub On<'a, DIM>);

impl<const DIM: usize> Kernel for Sweep<'_, DIM> {
    #[inline(always)]
    fn run(self) {
        let mut on = self.0;
        let (p, own, plan) = (on.p, on.own, &on.own.plan);
        p.slide(own, on.grid);
        p.release(own, on.grid);
        let mut motions = [on.motion(0), on.motion(DIM - 2)];
        let (mut forces, mut forced) = (None, plan.first - 1);
        let (mut moved, mut stretched) = (HALO, own.reaches.start);
        for stage in &plan.stages {
            on.move_rows(&mut motions, moved..stage.moved);
            p.stretch(stretched..stage.stretched, on.grid);
            (moved, stretched) = (stage.moved, stage.stretched);
            if stage.forced > plan.first {
                let mut all = forces.unwrap_or_else(|| on.forces());
                on.force_rows(&mut all, forced..stage.forced);
                (forces, forced) = (Some(all), stage.forced);
            }
        }
        p.copy_places(own, on.grid);
        p.rise_to_tails(own, on.grid);
        on.finish(forces, forced);
    }
}

impl<const DIM: usize> Kernel for Stand<'_, DIM> {
    #[inline(always)]
    fn run(self) {
        let mut on = self.0;
        let (p, own, plan) = (on.p, on.own, &on.own.plan);
        p.copy_places(own, on.grid);
        for c in 0..DIM - 1 {
            on.measure(c);
        }
        p.rise_to_tails(own, on.grid);
        p.release(own, on.grid);
        p.stretch(own.reaches.start..plan.within, on.grid);
        on.finish(None, plan.first - 1);
    }
}

impl<const DIM: usize> On<'_, DIM> {
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
