//! H of each reach, and the motion of the masters.

use super::rows::{Tensed, place};
use super::{Explicit, Grid, Own};
use std::ops::Range;

#[inline(always)]
fn rise(tensed: &[Tensed], slot: usize) -> f64 {
    let (row, lane) = place(slot);
    tensed[row].rise[lane]
}

impl<const DIM: usize> Explicit<DIM> {
    /// Let the masters of an island take the step.
    #[inline(always)]
    pub(super) fn slide(&self, own: &Own, grid: &mut Grid) {
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
    }

    /// Nothing pulls the masters any more; x + (β/h) d of them.
    #[inline(always)]
    pub(super) fn release(&self, own: &Own, grid: &mut Grid) {
        let which = own.masters.clone();
        grid.pull[which.clone()].fill(0.0);
        let [x, d] = &grid.x;
        let lag = &self.masters.lag[which.clone()];
        let parts = x[which.clone()].iter().zip(&d[which.clone()]).zip(lag);
        for (s, ((x, d), lag)) in grid.lagged[which].iter_mut().zip(parts) {
            *s = x + lag * d;
        }
    }

    /// H of some reaches, and what they pull the masters along by.
    #[inline(always)]
    pub(super) fn stretch(&self, reaches: Range<usize>, grid: &mut Grid) {
        for number in reaches {
            self.stretch_one(number, 0.0, grid);
        }
    }

    /// The same of one, with the rise of the strands before the one that it ends in.
    #[inline(always)]
    fn stretch_one(&self, number: usize, before: f64, grid: &mut Grid) {
        let reach = &self.reaches[number];
        let [a, b] = reach.masters.map(|m| m as usize);
        let [from, to] = reach.ends.map(|slot| slot as usize);
        let risen = rise(&grid.tensed, to) - rise(&grid.tensed, from) + before;
        let force = reach.stiffness * (grid.lagged[b] - grid.lagged[a] + risen);
        grid.pull[a] += force;
        grid.pull[b] -= force;
        more(grid, from, force - grid.thrust[reach.before as usize]);
        grid.thrust[number] = force;
    }

    /// The same of those that go over cuts, and H on both sides of cuts.
    #[inline(always)]
    pub(super) fn stretch_over_cuts(&self, own: &Own, grid: &mut Grid) {
        for number in own.plan.within..own.reaches.end {
            let tails = own.cuts.iter().filter(|cut| cut.over == Some(number));
            let before = tails.map(|cut| rise(&grid.tensed, cut.tail)).sum();
            self.stretch_one(number, before, grid);
        }
        for cut in &own.cuts {
            let last = cut.last.map_or(0.0, |number| grid.thrust[number]);
            more(grid, cut.head, last);
            if let Some(next) = cut.next {
                let from = self.reaches[next].ends[0] as usize;
                more(grid, from, grid.thrust[next] - last);
            }
        }
    }
}

/// Set what a segment has more than the one before it.
#[inline(always)]
fn more(grid: &mut Grid, slot: usize, thrust: f64) {
    let (row, lane) = place(slot);
    grid.tensed[row].more[lane] = thrust;
}
