//! Longest stable step: ω h < 2 for the fastest motion of what is explicit. Damping takes the velocity of
//! the step before, which shortens it: what changes its sign in every step has the increment d = 2 y, so
//! that 4 = ω² h² (1 + 2β/h) + 2 α h there.

use crate::error::CoreError;
use crate::integrator::explicit::simd::rows::place;
use crate::integrator::explicit::stiff_groups::cluster::Member;
use crate::integrator::explicit::{Explicit, Grid};

/// Share of the limit that may be used: the rest is for contacts and links, which add no mass.
const SHARE: f64 = 0.95;
/// Rounds of the power iteration; the highest frequencies of a chain lie close together, so that the
/// estimate is theirs long before the motion is.
const ROUNDS: usize = 60;
/// Halvings in the search for the longest step: to 1/4096 of it.
const HALVINGS: usize = 12;

impl<const DIM: usize> Explicit<DIM> {
    /// `with` is the same line with other steps: reaches, filter and damping depend on them.
    ///
    /// # Errors
    /// [`CoreError::StepTooLong`].
    pub(in crate::integrator::explicit) fn check_step(
        &self,
        with: impl Fn(f64) -> Result<Self, CoreError>,
    ) -> Result<(), CoreError> {
        if self.is_short() {
            return Ok(());
        }
        let fits = |h: f64| with(h).is_ok_and(|other| other.is_short());
        let (mut low, mut high) = (0.5 * self.h, self.h);
        while !fits(low) && low > f64::MIN_POSITIVE {
            (low, high) = (0.5 * low, low);
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if fits(middle) {
                low = middle;
            } else {
                high = middle;
            }
        }
        // Four figures, rounded down.
        let unit = 10_f64.powf(low.log10().floor() - 3.0);
        let longest = (low / unit).floor() * unit;
        Err(CoreError::StepTooLong {
            step: self.h,
            longest,
        })
    }

    fn is_short(&self) -> bool {
        self.fastest() < 2.0 * SHARE
    }

    /// Highest frequency of the explicit part times h, that which damping adds included.
    fn fastest(&self) -> f64 {
        let mut grid = self.still();
        // Neighbours by turns, and no regular pattern.
        let mut y: Vec<[f64; DIM]> = vec![[0.0; DIM]; self.nodes.len()];
        for (slot, _) in self.all() {
            let ((row, lane), number) = (place(slot), self.along_strands(slot));
            let sign = if number % 2 == 0 { 1.0 } else { -1.0 };
            for (c, across) in self.across.iter().enumerate() {
                let free = f64::from(u8::from(across[row].inverse[lane] > 0.0));
                y[slot][c + 1] = free * sign * (1.0 + 0.1 * ((number * number) as f64).sin());
            }
        }
        for (m, x) in grid.x[0].iter_mut().enumerate() {
            *x = if m % 2 == 0 { 1e-2 } else { -1e-2 };
        }
        let mut squared = 0.0;
        for _ in 0..ROUNDS {
            self.shake(&y, &mut grid);
            let before = size(y.iter().flatten().chain(&grid.x[0]));
            for (slot, _) in self.all() {
                for (c, rows) in grid.moving.iter().enumerate() {
                    y[slot][c + 1] = self.acceleration(c, slot, rows);
                }
            }
            let numbers = self.masters.inverse.iter().zip(&self.masters.damping);
            let moving = grid.pull.iter().zip(&grid.x[1]).zip(numbers);
            let along = moving.map(|((f, d), (inverse, damping))| f * inverse - damping * d);
            grid.x[0] = along.collect();
            squared = size(y.iter().flatten().chain(&grid.x[0])) / before;
            let all = y.iter_mut().flatten().chain(&mut grid.x[0]);
            all.for_each(|v| *v /= before * squared);
        }
        squared.sqrt()
    }

    /// Number of a point in its block, one strand behind the other.
    fn along_strands(&self, slot: usize) -> usize {
        let (row, lane) = place(slot);
        let mut blocks = self.own.iter().flat_map(|own| &own.blocks);
        let block = blocks.find(|block| block.rows.contains(&row));
        block.map_or(0, |block| {
            lane * block.plan.rows.len() + row - block.rows.start
        })
    }

    /// Forces of wires whose points were as far on the other side a step ago.
    fn shake(&self, y: &[[f64; DIM]], grid: &mut Grid) {
        for (slot, node) in self.all() {
            let ((row, lane), y) = (place(slot), &y[self.points[node]]);
            for (c, rows) in grid.moving.iter_mut().enumerate() {
                let (y, d) = (y[c + 1], 2.0 * y[c + 1]);
                rows[row].d[lane] = d;
                rows[row].s[lane] = y + self.damped[row].lag[lane] * d;
            }
        }
        let [x, d] = &mut grid.x;
        x.iter().zip(d).for_each(|(x, d)| *d = 2.0 * x);
        for (island, own) in self.own.iter().enumerate() {
            self.wire_forces(island, grid);
            self.copy_forces(own, grid);
        }
        self.hold_along(grid);
    }

    /// Forces along the wire of links, struts and springs, which are explicit there: q = −K x − C d/h.
    fn hold_along(&self, grid: &mut Grid) {
        let [x, d] = &grid.x;
        for cluster in &self.clusters {
            let width = cluster.size / cluster.members.len();
            for (i, member) in cluster.members.iter().enumerate() {
                let of = |(j, other): (usize, &Member)| {
                    let at = i * width * cluster.size + j * width;
                    let (k, c) = (cluster.stiffness[at], cluster.damping[at]);
                    k * other.along.read(x) + c / self.h * other.along.read(d)
                };
                let force: f64 = cluster.members.iter().enumerate().map(of).sum();
                member.along.add(-force, &mut grid.pull);
            }
        }
    }
}

fn size<'a>(numbers: impl Iterator<Item = &'a f64>) -> f64 {
    numbers.map(|v| v * v).sum::<f64>().sqrt()
}
