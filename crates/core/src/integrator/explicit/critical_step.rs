//! Longest stable step: ω h < 2 for the highest frequency of the explicit part.
//!
//! Damping reads the velocity of the previous step, which shortens it: a motion that changes its
//! sign in every step has the increment d = 2 y, so 4 = ω² h² (1 + 2β/h) + 2 α h there.

use crate::error::CoreError;
use crate::integrator::explicit::simd::packed::row_and_lane;
use crate::integrator::explicit::stiff_groups::stiff_group::Member;
use crate::integrator::explicit::{ChainState, Explicit};

/// Usable share of the limit; the rest is a margin for contacts and links, which add no mass.
const USABLE_SHARE: f64 = 0.95;
/// Number of power iterations. The highest frequencies of a chain are close together, so the
/// estimate converges long before the mode does.
const ROUNDS: usize = 60;
/// Number of bisections in the search for the longest step: to 1/4096 of it.
const HALVINGS: usize = 12;

impl<const DIM: usize> Explicit<DIM> {
    /// Checks that the step is stable. `with` builds the same line for another step, on which axial
    /// elements, filter and damping depend.
    ///
    /// # Errors
    /// [`CoreError::StepTooLong`].
    pub(in crate::integrator::explicit) fn check_step(
        &self,
        with: impl Fn(f64) -> Result<Self, CoreError>,
    ) -> Result<(), CoreError> {
        if self.is_stable() {
            return Ok(());
        }
        let fits = |h: f64| with(h).is_ok_and(|other| other.is_stable());
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
        // Four digits, rounded down.
        let unit = 10_f64.powf(low.log10().floor() - 3.0);
        let longest = (low / unit).floor() * unit;
        Err(CoreError::StepTooLong {
            step: self.h,
            longest,
        })
    }

    fn is_stable(&self) -> bool {
        self.highest_frequency() < 2.0 * USABLE_SHARE
    }

    /// Returns the highest frequency ω h of the explicit part by power iteration, with the effect
    /// of damping.
    fn highest_frequency(&self) -> f64 {
        let mut chain = self.zero_state();
        // Alternating neighbours, without a regular pattern.
        let mut y: Vec<[f64; DIM]> = vec![[0.0; DIM]; self.nodes.len()];
        for (packed_index, _) in self.points_and_nodes() {
            let ((row, simd_lane), number) = (
                row_and_lane(packed_index),
                self.number_along_stripes(packed_index),
            );
            let sign = if number % 2 == 0 { 1.0 } else { -1.0 };
            for (c, across) in self.transverse.iter().enumerate() {
                let free = f64::from(u8::from(across[row].inverse[simd_lane] > 0.0));
                y[packed_index][c + 1] =
                    free * sign * (1.0 + 0.1 * ((number * number) as f64).sin());
            }
        }
        for (m, x) in chain.x[0].iter_mut().enumerate() {
            *x = if m % 2 == 0 { 1e-2 } else { -1e-2 };
        }
        let mut squared = 0.0;
        for _ in 0..ROUNDS {
            self.set_alternating_motion(&y, &mut chain);
            let before = size(y.iter().flatten().chain(&chain.x[0]));
            for (packed_index, _) in self.points_and_nodes() {
                for (c, rows) in chain.moving.iter().enumerate() {
                    y[packed_index][c + 1] = self.acceleration(c, packed_index, rows);
                }
            }
            let numbers = self.masters.inverse.iter().zip(&self.masters.damping);
            let moving = chain.master_force.iter().zip(&chain.x[1]).zip(numbers);
            let along = moving.map(|((f, d), (inverse, damping))| f * inverse - damping * d);
            chain.x[0] = along.collect();
            squared = size(y.iter().flatten().chain(&chain.x[0])) / before;
            let all = y.iter_mut().flatten().chain(&mut chain.x[0]);
            all.for_each(|v| *v /= before * squared);
        }
        squared.sqrt()
    }

    /// Returns the index of a point in its block, counted stripe after stripe.
    fn number_along_stripes(&self, packed_index: usize) -> usize {
        let (row, simd_lane) = row_and_lane(packed_index);
        let mut blocks = self
            .islands
            .iter()
            .flat_map(|island_model| &island_model.blocks);
        let block = blocks.find(|block| block.rows.contains(&row));
        block.map_or(0, |block| {
            simd_lane * block.plan.rows.len() + row - block.rows.start
        })
    }

    /// Sets a motion that was opposite one step ago, and finds its forces.
    fn set_alternating_motion(&self, y: &[[f64; DIM]], chain: &mut ChainState) {
        for (packed_index, node) in self.points_and_nodes() {
            let ((row, simd_lane), y) = (row_and_lane(packed_index), &y[self.points[node]]);
            for (c, rows) in chain.moving.iter_mut().enumerate() {
                let (y, d) = (y[c + 1], 2.0 * y[c + 1]);
                rows[row].d[simd_lane] = d;
                rows[row].s[simd_lane] = y + self.damping[row].lag[simd_lane] * d;
            }
        }
        let [x, d] = &mut chain.x;
        x.iter().zip(d).for_each(|(x, d)| *d = 2.0 * x);
        for (island, island_model) in self.islands.iter().enumerate() {
            self.wire_forces(island, chain);
            self.copy_ghost_forces(island_model, chain);
        }
        self.add_axial_stiff_forces(chain);
    }

    /// Adds the axial forces of links, struts and springs, which are explicit: q = −K x − C d/h.
    fn add_axial_stiff_forces(&self, chain: &mut ChainState) {
        let [x, d] = &chain.x;
        for stiff_group in &self.stiff_groups {
            let width = stiff_group.size / stiff_group.members.len();
            for (i, member) in stiff_group.members.iter().enumerate() {
                let force_by = |(j, other): (usize, &Member)| {
                    let entry = i * width * stiff_group.size + j * width;
                    let (k, c) = (stiff_group.stiffness[entry], stiff_group.damping[entry]);
                    k * other.axial_position.read(x) + c / self.h * other.axial_position.read(d)
                };
                let force: f64 = stiff_group.members.iter().enumerate().map(force_by).sum();
                member.axial_position.add(-force, &mut chain.master_force);
            }
        }
    }
}

fn size<'a>(numbers: impl Iterator<Item = &'a f64>) -> f64 {
    numbers.map(|v| v * v).sum::<f64>().sqrt()
}
