//! H of each reach, and the motion of the masters.

use crate::integrator::explicit::simd::rows::{LANES, Moving, Wide, each, place};
use crate::integrator::explicit::{Block, Explicit, Grid, Own, Reach};
use std::ops::Range;

#[inline(always)]
fn rise(first: &[Moving], slot: usize) -> f64 {
    let (row, lane) = place(slot);
    first[row].w[lane]
}

/// y of a point, in space.
#[inline(always)]
fn aside(first: &[Moving], slot: usize) -> f64 {
    let (row, lane) = place(slot);
    first[row].s[lane]
}

impl<const DIM: usize> Explicit<DIM> {
    /// Let the masters of an island take the step.
    #[inline(always)]
    pub(in crate::integrator::explicit) fn slide(&self, own: &Own, grid: &mut Grid) {
        let which = own.masters.clone();
        let (inverse, damping) = (&self.masters.inverse, &self.masters.damping);
        let numbers = inverse[which.clone()].iter().zip(&damping[which.clone()]);
        let numbers = numbers.zip(&grid.pull[which.clone()]);
        let [x, d] = &mut grid.x;
        let moving = x[which.clone()].iter_mut().zip(&mut d[which]);
        for ((x, d), ((inverse, damping), pull)) in moving.zip(numbers) {
            *d += inverse * pull - damping * *d;
            *x += *d;
        }
        let mut sums = Wide::default();
        for four in grid.x[0][own.masters.clone()].chunks(LANES) {
            (0..four.len()).for_each(|l| sums[l] += four[l]);
        }
        let sound = &mut grid.sound;
        *sound = each(|l| 0.0f64.mul_add(sums[l], sound[l]));
    }

    /// Nothing pulls the masters any more; x + (β/h) d of them.
    #[inline(always)]
    pub(in crate::integrator::explicit) fn release(&self, own: &Own, grid: &mut Grid) {
        let which = own.masters.clone();
        grid.pull[which.clone()].fill(0.0);
        let [x, d] = &grid.x;
        let lag = &self.masters.lag[which.clone()];
        let parts = x[which.clone()].iter().zip(&d[which.clone()]).zip(lag);
        for (s, ((x, d), lag)) in grid.lagged[which].iter_mut().zip(parts) {
            *s = x + lag * d;
        }
    }

    /// H of some reaches, and what they pull the masters along by; those that are not `CURVED` are straight.
    #[inline(always)]
    pub(in crate::integrator::explicit) fn stretch<const CURVED: bool>(
        &self,
        reaches: Range<usize>,
        grid: &mut Grid,
    ) {
        let mut pulled = Pulled::of(grid);
        let (mut number, mut left) = (reaches.start, &self.reaches[reaches]);
        while let [reach, behind @ ..] = left {
            match left.split_first_chunk::<LANES>() {
                Some((four, behind)) if reach.is_row => {
                    pulled.stretch_row::<CURVED>(number, four);
                    (number, left) = (number + LANES, behind);
                }
                _ => {
                    pulled.stretch::<CURVED>(number, reach, 0.0);
                    (number, left) = (number + 1, behind);
                }
            }
        }
    }

    /// What H of reaches in curves pulls their ends to the inside by, beside the forces of wires.
    pub(in crate::integrator::explicit) fn lean(&self, own: &Own, grid: &mut Grid) {
        for &number in own.blocks.iter().flat_map(|block| &block.leaning) {
            let number = number as usize;
            let reach = &self.reaches[number];
            let force = reach.lean * grid.thrust[number];
            for slot in reach.ends {
                self.add_force(grid, self.home[slot as usize], 1, force);
            }
        }
    }

    /// The same of those that go over cuts, and H on both sides of cuts.
    #[inline(always)]
    pub(in crate::integrator::explicit) fn stretch_over_cuts(&self, own: &Block, grid: &mut Grid) {
        for number in own.plan.within..own.reaches.end {
            let tails = own.cuts.iter().filter(|cut| cut.over == Some(number));
            let before = tails.map(|cut| rise(&grid.moving[0], cut.tail)).sum();
            Pulled::of(grid).stretch::<true>(number, &self.reaches[number], before);
        }
        for cut in &own.cuts {
            let last = cut.last.map_or(0.0, |number| grid.thrust[number]);
            more(&mut grid.more, cut.head, last);
            if let Some(next) = cut.next {
                let from = self.reaches[next].ends[0] as usize;
                more(&mut grid.more, from, grid.thrust[next] - last);
            }
        }
    }
}

/// Set what a segment has more than the one before it.
#[inline(always)]
fn more(list: &mut [Wide], slot: usize, thrust: f64) {
    let (row, lane) = place(slot);
    list[row][lane] = thrust;
}

/// What reaches read and write. Slices: a list that is written to might be another one for all the compiler
/// knows, and be looked up anew.
struct Pulled<'a> {
    /// Rows of the first direction, which have the rise.
    first: &'a [Moving],
    more: &'a mut [Wide],
    lagged: &'a [f64],
    pull: &'a mut [f64],
    thrust: &'a mut [f64],
}

impl<'a> Pulled<'a> {
    #[inline(always)]
    fn of(grid: &'a mut Grid) -> Self {
        Self {
            first: &grid.moving[0],
            more: &mut grid.more,
            lagged: &grid.lagged,
            pull: &mut grid.pull,
            thrust: &mut grid.thrust,
        }
    }

    /// H of four that are a row.
    #[inline(always)]
    fn stretch_row<const CURVED: bool>(&mut self, number: usize, reaches: &[Reach; LANES]) {
        let first = &reaches[0];
        let [a, b] = first.masters.map(|m| m as usize);
        let [from, to] = first.ends.map(|slot| place(slot as usize).0);
        let risen: Wide = {
            let (from, to) = (&self.first[from], &self.first[to]);
            let straight = each(|l| to.w[l] - from.w[l]);
            match CURVED {
                true => each(|l| straight[l] - reaches[l].lean * (from.s[l] + to.s[l])),
                false => straight,
            }
        };
        let (lagged, further) = (&self.lagged[a..][..LANES], &self.lagged[b..][..LANES]);
        let force = each(|l| reaches[l].stiffness * (further[l] - lagged[l] + risen[l]));
        let pull = &mut self.pull[a..][..LANES];
        (0..LANES).for_each(|l| pull[l] += force[l]);
        let pull = &mut self.pull[b..][..LANES];
        (0..LANES).for_each(|l| pull[l] -= force[l]);
        let before = &self.thrust[first.before as usize..][..LANES];
        self.more[from] = each(|l| force[l] - before[l]);
        self.thrust[number..][..LANES].copy_from_slice(&force[..]);
    }

    /// H of one, with the rise of the strands before the one that it ends in.
    #[inline(always)]
    fn stretch<const CURVED: bool>(&mut self, number: usize, reach: &Reach, before: f64) {
        let [a, b] = reach.masters.map(|m| m as usize);
        let [from, to] = reach.ends.map(|slot| slot as usize);
        let mut risen = rise(self.first, to) - rise(self.first, from) + before;
        if CURVED {
            risen -= reach.lean * (aside(self.first, from) + aside(self.first, to));
        }
        let force = reach.stiffness * (self.lagged[b] - self.lagged[a] + risen);
        self.pull[a] += force;
        self.pull[b] -= force;
        more(self.more, from, force - self.thrust[reach.before as usize]);
        self.thrust[number] = force;
    }
}
