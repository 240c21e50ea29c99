//! What the wires of an island store, and what they take in a step.

use super::field::{Field, total};
use super::filtered::{Filtered, energy};
use super::joined::{FEW, Joined};
use super::{Lost, Stored};
use crate::dynamics::explicit::cluster::WIDEST;
use crate::dynamics::explicit::rows::place;
use crate::dynamics::explicit::{Explicit, Grid};
use std::ops::Range;

/// A piece between two masters: their numbers on the island, its first and last point, N/m.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    pub masters: [usize; 2],
    pub points: [usize; 2],
    pub stiffness: f64,
    /// What it is shorter by for a motion of both ends to the side, in curves.
    pub lean: f64,
}

/// Numbers of an island, point by point along its wires.
#[derive(Debug, Clone)]
pub(super) struct Form {
    pub slots: Vec<usize>,
    pub masters: Range<usize>,
    /// 1/L of the segment behind each point; EI*/ℓ̄ of the point.
    pub per_length: Vec<f64>,
    pub bending: Vec<f64>,
    pub tension: [Vec<f64>; 2],
    pub slope: [Vec<f64>; 2],
    /// m/h²; zero where held, and of guests.
    pub weight: [Vec<f64>; 2],
    /// α h and β/h.
    pub alpha: Vec<f64>,
    pub lag: Vec<f64>,
    pub pieces: Vec<Piece>,
    pub clusters: Vec<Joined>,
    pub filtered: [Filtered; 2],
    /// Predictor and increment, increment before the step that is measured, and work space.
    pub y: Field,
    pub d: Field,
    pub old: Field,
    pub work: Field,
}

impl Form {
    /// Read y and d.
    pub fn read(&mut self, grid: &Grid) {
        for (c, rows) in grid.moving.iter().enumerate() {
            let (y, d) = (&mut self.y.across[c], &mut self.d.across[c]);
            y.clear();
            d.clear();
            for (&slot, &lag) in self.slots.iter().zip(&self.lag) {
                let (row, lane) = place(slot);
                let row = &rows[row];
                d.push(row.d[lane]);
                y.push(row.s[lane] - lag * row.d[lane]);
            }
        }
        let [x, d] = [0, 1].map(|k| &grid.x[k][self.masters.clone()]);
        for (to, from) in [(&mut self.y, x), (&mut self.d, d)] {
            to.along.clear();
            to.along.extend_from_slice(from);
        }
    }

    /// x·K_E z
    fn of_wires(&self, x: &Field, z: &Field) -> f64 {
        let mut sum = 0.0;
        for c in 0..2 {
            let (x, z) = (&x.across[c][..], &z.across[c][..]);
            let Some(last) = x.len().checked_sub(1) else {
                continue;
            };
            let (per, tension) = (&self.per_length[..], &self.tension[c][..]);
            let pairs = [tension, x, &x[1..], z, &z[1..]];
            sum += total(pairs, |[t, x0, x1, z0, z1]| t * (x1 - x0) * (z1 - z0));
            if last > 1 {
                let lists = [
                    &self.bending[1..],
                    per,
                    &per[1..],
                    x,
                    &x[1..],
                    &x[2..],
                    z,
                    &z[1..],
                    &z[2..],
                ];
                sum += total(lists, |[b, p0, p1, x0, x1, x2, z0, z1, z2]| {
                    let (x, z) = (
                        (x2 - x1) * p1 - (x1 - x0) * p0,
                        (z2 - z1) * p1 - (z1 - z0) * p0,
                    );
                    b * x * z
                });
            }
        }
        for piece in &self.pieces {
            let [a, b] = piece.masters;
            let [from, to] = piece.points;
            let stretched = |f: &Field| {
                let mut by = f.along[b] - f.along[a];
                if piece.lean != 0.0 {
                    by -= piece.lean * (f.across[0][from] + f.across[0][to]);
                }
                for (slope, r) in self.slope.iter().zip(&f.across) {
                    if let Some(r) = r.get(from..=to) {
                        let lists = [&slope[from..to], r, &r[1..]];
                        by += total(lists, |[slope, r0, r1]| slope * (r1 - r0));
                    }
                }
                by
            };
            sum += piece.stiffness * stretched(x) * stretched(z);
        }
        sum
    }

    /// From y and d.
    pub fn stored<const DIM: usize>(&mut self, steps: &Explicit<DIM>) -> Stored {
        let mut before = std::mem::take(&mut self.work);
        before.set(&self.y, &self.d, |y, d| y - d);
        let mut elastic = 0.5 * self.of_wires(&self.y, &before);
        for joined in &self.clusters {
            elastic += match steps.clusters[joined.number].size {
                ..=FEW => joined.stored::<DIM, FEW>(steps, self),
                _ => joined.stored::<DIM, WIDEST>(steps, self),
            };
        }
        self.work = before;
        let mut kinetic = energy(&self.filtered, &self.weight, &self.d.across);
        let inverse = &steps.masters.inverse[self.masters.clone()];
        for (d, inverse) in self.d.along.iter().zip(inverse).filter(|(_, i)| **i > 0.0) {
            kinetic += 0.5 * d * d / inverse;
        }
        Stored { kinetic, elastic }
    }

    /// From d and that before the step.
    pub fn lost<const DIM: usize>(&mut self, steps: &Explicit<DIM>) -> Lost {
        let mut lost = Lost::default();
        for joined in &self.clusters {
            lost = lost.and(match steps.clusters[joined.number].size {
                ..=FEW => joined.lost::<DIM, FEW>(steps, self),
                _ => joined.lost::<DIM, WIDEST>(steps, self),
            });
        }
        let mut moved = std::mem::take(&mut self.work);
        moved.set(&self.d, &self.old, |d, old| 0.5 * (d + old));
        for c in 0..DIM - 1 {
            let (old, moved) = (&mut self.old.across[c][..], &moved.across[c][..]);
            let lists = [&self.weight[c][..], &self.alpha, old, moved];
            lost.damped += total(lists, |[weight, alpha, d, z]| weight * alpha * d * z);
            old.iter_mut().zip(&self.lag).for_each(|(d, lag)| *d *= lag);
        }
        let masters = &steps.masters;
        for (m, (d, z)) in self
            .masters
            .clone()
            .zip(self.old.along.iter_mut().zip(&moved.along))
        {
            if masters.inverse[m] > 0.0 {
                lost.damped += masters.damping[m] / masters.inverse[m] * *d * *z;
            }
            *d *= masters.lag[m];
        }
        lost.damped += self.of_wires(&self.old, &moved);
        self.work = moved;
        lost
    }
}
