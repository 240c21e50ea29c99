//! Longest stable step: ω h < 2 for the fastest motion of what is explicit. Damping takes the velocity of
//! the step before, which shortens it: what changes its sign in every step has the increment d = 2 y, so
//! that 4 = ω² h² (1 + 2β/h) + 2 α h there.

use super::{Explicit, refuse};
use crate::error::CoreError;

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
    /// [`CoreError::Input`] when the step is too long.
    pub(super) fn check_step(
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
        Err(refuse(&format!(
            "explicit steps of {} s: with these elements the longest stable one is {longest:.3e} s",
            self.h
        )))
    }

    fn is_short(&self) -> bool {
        self.h * self.fastest() < 2.0 * SHARE
    }

    /// Highest frequency of the explicit part, 1/s, that which damping adds included.
    fn fastest(&self) -> f64 {
        let mut grid = self.still();
        // Neighbours by turns, and no regular pattern.
        for (c, list) in grid.y.iter_mut().enumerate() {
            for (point, y) in list.iter_mut().enumerate() {
                let sign = if point % 2 == 0 { 1.0 } else { -1.0 };
                let free = f64::from(u8::from(self.inverse[c][point] > 0.0));
                *y = free * sign * (1.0 + 0.1 * ((point * point) as f64).sin());
            }
        }
        for (m, x) in grid.x[0].iter_mut().enumerate() {
            *x = if m % 2 == 0 { 1e-2 } else { -1e-2 };
        }
        let mut squared = 0.0;
        for _ in 0..ROUNDS {
            let places = grid.y.iter().chain(&grid.x[..1]).flatten();
            let twice: Vec<f64> = places.map(|y| 2.0 * y).collect();
            let increments = grid.d.iter_mut().chain(&mut grid.x[1..]).flatten();
            increments.zip(&twice).for_each(|(d, y)| *d = *y);
            for own in &self.own {
                for &(guest, owner) in &self.guests[own.guests.clone()] {
                    grid.y.iter_mut().for_each(|y| y[guest] = y[owner]);
                }
                self.wire_forces(own, &mut grid);
            }
            let size = |lists: &[Vec<f64>], x: &[f64]| -> f64 {
                let all = lists.iter().flatten().chain(x);
                all.map(|v| v * v).sum::<f64>().sqrt()
            };
            let before = size(&grid.y, &grid.x[0]);
            let mut new = grid.y.clone();
            for (c, list) in new.iter_mut().enumerate() {
                for point in super::PAD..self.nodes.len() - super::PAD {
                    list[point] = self.acceleration(c, point, &grid.w[c]);
                }
            }
            let along = grid.pull.iter().zip(&self.masters).zip(&grid.x[1]);
            let along: Vec<f64> = along.map(|((f, m), d)| f * m[0] - m[1] * d).collect();
            squared = size(&new, &along) / before;
            for (y, new) in grid.y.iter_mut().zip(new) {
                *y = new.into_iter().map(|v| v / (before * squared)).collect();
            }
            grid.x[0] = along.into_iter().map(|v| v / (before * squared)).collect();
        }
        squared.sqrt()
    }
}
