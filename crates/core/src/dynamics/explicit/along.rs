//! Along the wire: masters, reaches between them, and where all points lie.

use super::Along;
use super::blocks::Run;
use super::layout::{Chains, along};
use crate::dynamics::line::Line;
use crate::error::CoreError;
use crate::statics::assembly::{Geometry, Shape};
use std::ops::Range;

/// Shortest reach along the wire, in those that are just stable. At 1 ms it is 9 m, and tension of 20 Hz runs by
/// (kL)²/24, half a per cent, too slowly.
const REACH: f64 = 2.4;

/// A piece of wire between two masters.
pub(super) struct Reach {
    pub masters: [usize; 2],
    /// Its segments.
    pub segments: Range<usize>,
    /// k, N/m.
    pub stiffness: f64,
}

impl Chains {
    /// Masters, reaches, and where all points lie between them, island by island.
    pub(super) fn lay_along<const DIM: usize, const D: usize>(
        &mut self,
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        line: &Line<DIM, D>,
        (runs, islands): (&[Run], usize),
        masses: &[[f64; 2]],
    ) -> Result<(), CoreError> {
        let mut master = vec![usize::MAX; self.nodes.len()];
        let mut is_owner = vec![false; self.nodes.len()];
        self.guests
            .iter()
            .for_each(|&(_, owner)| is_owner[owner] = true);
        let mut lengths: Vec<(usize, Vec<usize>)> = Vec::new();
        let mut own = Vec::new();
        for island in 0..islands {
            let of = || runs.iter().filter(|run| run.island == island);
            let (masters, reaches) = (self.masters.len(), self.reaches.len());
            for run in of() {
                for point in self.places_along(geometry, line, run, &is_owner) {
                    let owner = self.points[self.nodes[point]];
                    if master[owner] == usize::MAX {
                        master[owner] = self.masters.len();
                        self.masters.push([0.0, 0.0, self.lag[owner]]);
                    }
                    match lengths.last_mut() {
                        Some((first, points)) if *first == run.first => points.push(point),
                        _ => lengths.push((run.first, vec![point])),
                    }
                }
            }
            for run in of() {
                let at = lengths.partition_point(|(first, _)| *first < run.first);
                let places = lengths[at].1.clone();
                self.add_reaches(geometry, shape, run, &places, &master);
            }
            own.push(self.ranges(of(), [masters, reaches])?);
        }
        self.own = own;
        for member in self.clusters.iter_mut().flat_map(|c| &mut c.members) {
            member.along = self.along[member.point];
        }
        for (node, [mass, damped]) in masses.iter().enumerate() {
            let along = self.along[self.points[node]];
            for (m, share) in along
                .masters
                .into_iter()
                .zip([1.0 - along.share, along.share])
            {
                self.masters[m][0] += share * mass;
                self.masters[m][1] += share * damped;
            }
        }
        let mut held = vec![false; self.masters.len()];
        for point in self.all() {
            let owner = self.points[self.nodes[point]];
            if master[owner] != usize::MAX && !line.free[self.nodes[point]][0] {
                held[master[owner]] = true;
            }
        }
        for (numbers, held) in self.masters.iter_mut().zip(held) {
            let [mass, damped, lag] = *numbers;
            *numbers = if held || mass <= 0.0 {
                [0.0; 3]
            } else {
                [self.h * self.h / mass, damped / mass * self.h, lag]
            };
        }
        Ok(())
    }

    /// Points of a wire that become masters: its ends, what is held or has guests, and between them so
    /// many that reaches are equally long and long enough.
    fn places_along<const DIM: usize, const D: usize>(
        &self,
        geometry: &Geometry<DIM, D>,
        line: &Line<DIM, D>,
        run: &Run,
        is_owner: &[bool],
    ) -> Vec<usize> {
        let segments = &geometry.structure.segments;
        let last = run.nodes.len() - 1;
        let needed = |k: usize| {
            k == 0 || k == last || !line.free[run.nodes[k]][0] || is_owner[run.first + k]
        };
        let needed: Vec<usize> = (0..=last).filter(|&k| needed(k)).collect();
        let mut at = vec![0.0; last + 1];
        let mut fastest: f64 = 0.0;
        for (k, &number) in run.segments.iter().enumerate() {
            let segment = &segments[number];
            at[k + 1] = at[k] + segment.rest_length;
            // Damping shortens the longest step by the root of this, see `stable`; as much again is room.
            let damped = 1.0 + 2.0 * segment.damping.beta / self.h;
            fastest = fastest.max(damped * (segment.axial_stiffness / segment.mass).sqrt());
        }
        let shortest = REACH * fastest * self.h;
        let mut places = vec![run.first];
        for pair in needed.windows(2) {
            let (mut from, to) = (at[pair[0]], at[pair[1]]);
            let pieces = ((to - from) / shortest).floor().max(1.0);
            let wanted = ((to - from) / pieces).min(to - from);
            for k in pair[0] + 1..pair[1] {
                // Rounding must not make a piece longer by an element.
                if at[k] - from > wanted * (1.0 - 1e-9) && to - at[k] >= shortest {
                    places.push(run.first + k);
                    from = at[k];
                }
            }
            places.push(run.first + pair[1]);
        }
        places.dedup();
        places
    }

    fn add_reaches<const DIM: usize, const D: usize>(
        &mut self,
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        run: &Run,
        places: &[usize],
        master: &[usize],
    ) {
        let of = |point: usize| master[self.points[self.nodes[point]]];
        let all = &geometry.structure.segments;
        if let [only] = places {
            self.along[*only] = Along {
                masters: [of(*only); 2],
                share: 0.0,
            };
        }
        for pair in places.windows(2) {
            let ends = [of(pair[0]), of(pair[1])];
            let (mut flexibility, mut at) = (0.0, vec![0.0]);
            for j in pair[0]..pair[1] {
                let segment = &all[run.segments[j - run.first]];
                let state = Geometry::<DIM, D>::segment_state(shape, segment);
                flexibility += 1.0 / along(segment, &state).2;
                at.push(at[at.len() - 1] + segment.rest_length);
            }
            let length = at[at.len() - 1];
            for (k, place) in at.iter().enumerate() {
                self.along[pair[0] + k] = Along {
                    masters: ends,
                    share: place / length,
                };
            }
            self.reaches.push(Reach {
                masters: ends,
                segments: pair[0]..pair[1],
                stiffness: 1.0 / flexibility,
            });
        }
    }
}
