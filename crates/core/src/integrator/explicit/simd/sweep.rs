//! The sweep over the points of an island that takes a step and finds the forces for the next one, block by block
//! and stage by stage: see [`plan`](crate::integrator::explicit::simd::plan).

use crate::integrator::explicit::simd::kernels::{Fixed, Forces, Motion, Rise};
use crate::integrator::explicit::simd::rows::{HALO, LANES, Moving, Wide, each};
use crate::integrator::explicit::{Block, Explicit, Grid, Own};
use crate::linalg::Kernel;
use std::ops::Range;

/// Take a step, and find the forces for the next one.
pub(in crate::integrator::explicit) struct Sweep<'a, const DIM: usize> {
    pub p: &'a Explicit<DIM>,
    pub own: &'a Own,
    pub grid: &'a mut Grid,
}

/// Find the forces where the points are.
pub(in crate::integrator::explicit) struct Stand<'a, const DIM: usize>(pub Sweep<'a, DIM>);

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
            let on = On { p, own, grid };
            match own.is_even {
                true => on.step::<true>(),
                false => on.step::<false>(),
            }
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

impl<'a, const DIM: usize> On<'a, DIM> {
    /// Take a step; blocks that are `EVEN` have the same damping everywhere.
    #[inline(always)]
    fn step<const EVEN: bool>(mut self) {
        let (own, plan) = (self.own, &self.own.plan);
        let mut motions = [self.motion(0); 2];
        if DIM == 3 {
            motions[1] = self.motion(1);
        }
        let (mut forces, mut forced) = (None, plan.first - 1);
        let (mut moved, mut stretched) = (HALO, own.reaches.start);
        for stage in &plan.stages {
            self.move_rows::<EVEN>(&mut motions, moved..stage.moved);
            self.stretch(stretched..stage.stretched);
            (moved, stretched) = (stage.moved, stage.stretched);
            if stage.forced > plan.first {
                if forces.is_none() {
                    forces = Some(self.forces());
                }
                if let Some(all) = &mut forces {
                    self.force_rows::<EVEN>(all, forced..stage.forced);
                }
                forced = stage.forced;
            }
        }
        for motion in &motions[..DIM - 1] {
            motion.tell(&mut self.grid.sound);
        }
        self.p.copy_places(own, self.grid);
        self.p.rise_to_tails(own, self.grid);
        self.finish::<EVEN>(forces, forced);
    }

    #[inline(always)]
    fn stand(mut self) {
        let (own, plan) = (self.own, &self.own.plan);
        self.p.copy_places(own, self.grid);
        self.measure();
        self.p.rise_to_tails(own, self.grid);
        self.stretch(own.reaches.start..plan.within);
        self.finish::<false>(None, plan.first - 1);
    }

    /// Straight ones pay nothing for curves.
    #[inline(always)]
    fn stretch(&mut self, reaches: Range<usize>) {
        match self.own.leaning.is_empty() {
            true => self.p.stretch::<false>(reaches, self.grid),
            false => self.p.stretch::<true>(reaches, self.grid),
        }
    }

    /// What stays of the rows of a direction across.
    #[inline(always)]
    fn fixed(&self, across: usize) -> Fixed<'a> {
        let (p, which) = (self.p, self.own.rows.clone());
        Fixed {
            common: &p.common[which.clone()],
            damped: &p.damped[which.clone()],
            across: &p.across[across][which],
        }
    }

    /// What moves there.
    #[inline(always)]
    fn rows(&mut self, across: usize) -> &mut [Moving] {
        &mut self.grid.moving[across][self.own.rows.clone()]
    }

    #[inline(always)]
    fn motion(&mut self, across: usize) -> Motion {
        Motion::before(HALO, self.fixed(across).common, self.rows(across))
    }

    #[inline(always)]
    fn move_rows<const EVEN: bool>(&mut self, motions: &mut [Motion; 2], which: Range<usize>) {
        let fixed = self.fixed(0);
        motions[0].go::<EVEN>(which.clone(), fixed, self.rows(0), None);
        if DIM == 3 {
            let (fixed, own) = (self.fixed(1), &self.own.rows);
            if let [first, second] = &mut self.grid.moving[..] {
                let (first, second) = (&mut first[own.clone()], &mut second[own.clone()]);
                motions[1].go::<EVEN>(which, fixed, second, Some(first));
            }
        }
    }

    /// The rise of the wire up to each point, from where they are.
    #[inline(always)]
    fn measure(&mut self) {
        for c in 0..DIM - 1 {
            let fixed = self.fixed(c);
            let mut rise = Rise::begin();
            for k in self.own.plan.rows.clone() {
                let more = rise.go_on(&fixed.across[k - 1], self.rows(c)[k].s);
                let first = &mut self.rows(0)[k].w;
                *first = each(|l| if c == 0 { more[l] } else { first[l] + more[l] });
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
        self.before(plan.first - 1, thrust)
    }

    /// Before a row. Closures would not be compiled for wide lanes.
    #[inline(always)]
    fn before(&mut self, row: usize, thrust: Wide) -> [Forces; 2] {
        let mut all = [Forces::before(row, self.fixed(0), self.rows(0), thrust); 2];
        if DIM == 3 {
            all[1] = Forces::before(row, self.fixed(1), self.rows(1), thrust);
        }
        all
    }

    #[inline(always)]
    fn force_rows<const EVEN: bool>(&mut self, forces: &mut [Forces; 2], which: Range<usize>) {
        for c in 0..DIM - 1 {
            let (fixed, own) = (self.fixed(c), &self.own.rows);
            let Grid { moving, more, .. } = &mut *self.grid;
            let (more, rows) = (&more[own.clone()], &mut moving[c][own.clone()]);
            forces[c].go::<EVEN>(which.clone(), fixed, more, rows);
        }
    }

    /// Forces of the other rows: the last ones, and those that wait.
    #[inline(always)]
    fn finish<const EVEN: bool>(&mut self, begun: Option<[Forces; 2]>, forced: usize) {
        let plan = &self.own.plan;
        self.p.stretch_over_cuts(self.own, self.grid);
        if plan.first < plan.rows.end {
            let mut forces = match begun {
                Some(forces) => forces,
                None => self.forces(),
            };
            self.force_rows::<EVEN>(&mut forces, forced..plan.rows.end);
        }
        let mut early = self.before(HALO - 1, Wide::default());
        self.force_rows::<EVEN>(&mut early, HALO - 1..plan.first);
    }
}
