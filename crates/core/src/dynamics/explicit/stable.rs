//! Longest stable step: ω h < 2 for the fastest motion of what is explicit.
//!
//! Damping in proportion to stiffness is read a step late, s = y + (β/h) d with the increment d of the
//! last step. At the limit the motion changes sign in every step, so d = 2 y, and the bound becomes
//!
//!   ω h √(1 + 2 β/h) < 2

use super::{Explicit, refuse};
use crate::error::CoreError;

/// Share of the limit that may be used: the rest is for contacts and links, which add no mass.
const SHARE: f64 = 0.95;
/// Rounds of the power iteration; the highest frequencies of a chain lie close together, so that the
/// estimate is theirs long before the motion is.
const ROUNDS: usize = 60;

impl<const DIM: usize> Explicit<DIM> {
    /// # Errors
    /// [`CoreError::Input`] when the step is too long.
    pub(super) fn check_step(&self) -> Result<(), CoreError> {
        let angle = self.h * self.fastest();
        if angle < 2.0 * SHARE {
            return Ok(());
        }
        let longest = self.h * 2.0 * SHARE / angle;
        Err(refuse(&format!(
            "explicit steps of {} s: with these elements the longest stable one is {longest:.3e} s",
            self.h
        )))
    }

    /// Highest frequency of the explicit part, 1/s.
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
            for (d, y) in grid.d.iter_mut().flatten().zip(grid.y.iter().flatten()) {
                *d = 2.0 * y;
            }
            grid.x[1] = grid.x[0].iter().map(|x| 2.0 * x).collect();
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
            let along: Vec<f64> = grid.pull.iter().zip(&self.masters).map(|(f, m)| f * m[0]).collect();
            squared = size(&new, &along) / before;
            for (y, new) in grid.y.iter_mut().zip(new) {
                *y = new.into_iter().map(|v| v / (before * squared)).collect();
            }
            grid.x[0] = along.into_iter().map(|v| v / (before * squared)).collect();
        }
        squared.sqrt()
    }
}
