//! What the wires of an island store, and what they take in a step.

use crate::integrator::explicit::energy::field::{Field, total};
use crate::integrator::explicit::energy::filtered::{Filtered, energy};
use crate::integrator::explicit::energy::joined::{FEW, Joined};
use crate::integrator::explicit::energy::{Lost, Stored};
use crate::integrator::explicit::simd::rows::LANES;
use crate::integrator::explicit::stiff_groups::cluster::WIDEST;
use crate::integrator::explicit::{Explicit, Grid};
use std::ops::Range;

/// A piece between two masters: their numbers on the island, its first and last point, N/m.
#[derive(Debug, Clone, Copy)]
pub(in crate::integrator::explicit::energy) struct Piece {
    pub masters: [usize; 2],
    pub points: [usize; 2],
    pub stiffness: f64,
    /// What it is shorter by for a motion of both ends to the side, in curves.
    pub lean: f64,
}

/// Numbers of an island that stay, point by point along its wires.
#[derive(Debug, Clone)]
pub(in crate::integrator::explicit) struct Form {
    /// Where the points lie: so many rows of a lane, one lane after the other.
    pub(in crate::integrator::explicit::energy) lanes: Vec<(Range<usize>, usize)>,
    pub(in crate::integrator::explicit::energy) masters: Range<usize>,
    /// 1/L of the segment behind each point; EI*/ℓ̄ of the point.
    pub(in crate::integrator::explicit::energy) per_length: Vec<f64>,
    pub(in crate::integrator::explicit::energy) bending: Vec<f64>,
    pub(in crate::integrator::explicit::energy) tension: [Vec<f64>; 2],
    pub(in crate::integrator::explicit::energy) slope: [Vec<f64>; 2],
    /// m/h²; zero where held, and of guests.
    pub(in crate::integrator::explicit::energy) weight: [Vec<f64>; 2],
    /// α h and β/h.
    pub(in crate::integrator::explicit::energy) alpha: Vec<f64>,
    pub(in crate::integrator::explicit::energy) lag: Vec<f64>,
    pub(in crate::integrator::explicit::energy) pieces: Vec<Piece>,
    pub(in crate::integrator::explicit::energy) clusters: Vec<Joined>,
    pub(in crate::integrator::explicit::energy) filtered: [Filtered; 2],
}

/// What moves of an island.
#[derive(Debug, Clone)]
pub(in crate::integrator::explicit::energy) struct Room {
    /// Predictor and increment, increment before the step that is measured, and work space.
    pub y: Field,
    pub d: Field,
    pub old: Field,
    work: Field,
}

impl Form {
    /// Room for what moves there.
    pub(in crate::integrator::explicit::energy) fn room(&self, directions: usize) -> Room {
        let still = Field::still(self.lag.len(), self.masters.len(), directions);
        Room {
            y: still.clone(),
            d: still.clone(),
            old: still.clone(),
            work: still,
        }
    }

    /// Read y and d.
    #[inline(always)]
    pub(in crate::integrator::explicit::energy) fn read(&self, grid: &Grid, room: &mut Room) {
        for (c, rows) in grid.moving.iter().enumerate() {
            let (mut y, mut d) = (&mut room.y.across[c][..], &mut room.d.across[c][..]);
            let mut lag = &self.lag[..];
            for (which, lane) in &self.lanes {
                let (rows, lane) = (&rows[which.clone()], *lane % LANES);
                let (here_y, next_y) = y.split_at_mut(rows.len());
                let (here_d, next_d) = d.split_at_mut(rows.len());
                let (here_lag, next_lag) = lag.split_at(rows.len());
                for (k, row) in rows.iter().enumerate() {
                    here_d[k] = row.d[lane];
                    here_y[k] = row.s[lane] - here_lag[k] * row.d[lane];
                }
                (y, d, lag) = (next_y, next_d, next_lag);
            }
        }
        let [x, d] = [0, 1].map(|k| &grid.x[k][self.masters.clone()]);
        room.y.along.copy_from_slice(x);
        room.d.along.copy_from_slice(d);
    }

    /// x·K_E z
    #[inline(always)]
    fn of_wires(&self, x: &Field, z: &Field) -> f64 {
        let mut sum = 0.0;
        for c in 0..2 {
            let (x, z) = (&x.across[c][..], &z.across[c][..]);
            if x.is_empty() {
                continue;
            }
            let pairs = [&self.tension[c][..], x, &x[1..], z, &z[1..]];
            sum += total(pairs, |[t, x0, x1, z0, z1]| t * (x1 - x0) * (z1 - z0));
            if x.len() > 2 {
                sum += self.bent(x, z);
            }
        }
        for piece in &self.pieces {
            sum += piece.stiffness * self.stretched(piece, x) * self.stretched(piece, z);
        }
        sum
    }

    /// That of bending, in one direction across.
    #[inline(always)]
    fn bent(&self, x: &[f64], z: &[f64]) -> f64 {
        let (b, p) = (&self.bending[1..], &self.per_length[..]);
        let lists = [b, p, &p[1..], x, &x[1..], &x[2..], z, &z[1..], &z[2..]];
        total(lists, |[b, p0, p1, x0, x1, x2, z0, z1, z2]| {
            let (x, z) = (
                (x2 - x1) * p1 - (x1 - x0) * p0,
                (z2 - z1) * p1 - (z1 - z0) * p0,
            );
            b * x * z
        })
    }

    /// What a piece is longer by.
    #[inline(always)]
    fn stretched(&self, piece: &Piece, f: &Field) -> f64 {
        let ([a, b], [from, to]) = (piece.masters, piece.points);
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
    }

    /// From y and d.
    #[inline(always)]
    pub(in crate::integrator::explicit::energy) fn stored<const DIM: usize>(
        &self,
        steps: &Explicit<DIM>,
        room: &mut Room,
    ) -> Stored {
        room.work.set(&room.y, &room.d, |y, d| y - d);
        let mut elastic = 0.5 * self.of_wires(&room.y, &room.work);
        for joined in &self.clusters {
            elastic += match steps.clusters[joined.number].size {
                ..=FEW => joined.stored::<DIM, FEW>(steps, room),
                _ => joined.stored::<DIM, WIDEST>(steps, room),
            };
        }
        let mut kinetic = energy(&self.filtered, &self.weight, &room.d.across);
        let inverse = &steps.masters.inverse[self.masters.clone()];
        for (d, inverse) in room.d.along.iter().zip(inverse).filter(|(_, i)| **i > 0.0) {
            kinetic += 0.5 * d * d / inverse;
        }
        Stored { kinetic, elastic }
    }

    /// From d and that before the step.
    #[inline(always)]
    pub(in crate::integrator::explicit::energy) fn lost<const DIM: usize>(
        &self,
        steps: &Explicit<DIM>,
        room: &mut Room,
    ) -> Lost {
        let mut lost = Lost::default();
        for joined in &self.clusters {
            lost = lost.and(match steps.clusters[joined.number].size {
                ..=FEW => joined.lost::<DIM, FEW>(steps, room),
                _ => joined.lost::<DIM, WIDEST>(steps, room),
            });
        }
        room.work.set(&room.d, &room.old, |d, old| 0.5 * (d + old));
        let Room {
            old, work: moved, ..
        } = room;
        for c in 0..DIM - 1 {
            let (old, moved) = (&mut old.across[c][..], &moved.across[c][..]);
            let lists = [&self.weight[c][..], &self.alpha, old, moved];
            lost.damped += total(lists, |[weight, alpha, d, z]| weight * alpha * d * z);
            for (d, lag) in old.iter_mut().zip(&self.lag) {
                *d *= lag;
            }
        }
        let masters = &steps.masters;
        let along = old.along.iter_mut().zip(&moved.along);
        for (m, (d, z)) in self.masters.clone().zip(along) {
            if masters.inverse[m] > 0.0 {
                lost.damped += masters.damping[m] / masters.inverse[m] * *d * *z;
            }
            *d *= masters.lag[m];
        }
        lost.damped += self.of_wires(old, moved);
        lost
    }
}
