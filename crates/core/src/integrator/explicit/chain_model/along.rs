//! Along the wire: masters, reaches between them, and where all points lie.

use crate::error::CoreError;
use crate::integrator::explicit::Along;
use crate::integrator::explicit::chain_model::blocks::Run;
use crate::integrator::explicit::chain_model::layout::{Chains, along};
use crate::integrator::explicit::simd::rows::LANES;
use crate::linear::model::LinearModel;
use crate::statics::assembly::{Geometry, Shape};
use std::collections::BTreeSet;
use std::ops::Range;

/// Shortest reach along the wire, in those that are just stable. At 1 ms it is 5.6 m, and tension of 20 Hz runs by
/// (kL)²/24, two thousandths, too slowly. With up to 1.5 the lowest force of AC simple stays within 0.3 N; with more it
/// depends on where reaches begin, by 1 N.
const REACH: f64 = 1.5;

/// A piece of wire between two masters.
pub(in crate::integrator::explicit) struct Reach {
    pub masters: [usize; 2],
    /// Its segments.
    pub segments: Range<usize>,
    /// k, N/m.
    pub stiffness: f64,
    /// Half the angle by which the track turns along it, rad.
    pub lean: f64,
}

impl Chains {
    /// Masters, reaches, and where all points lie between them, island by island.
    pub(in crate::integrator::explicit) fn lay_along<const DIM: usize, const D: usize>(
        &mut self,
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        line: &LinearModel<DIM, D>,
        (runs, islands): (&[Run], usize),
        masses: &[[f64; 2]],
    ) -> Result<(), CoreError> {
        let mut master = vec![usize::MAX; self.nodes.len()];
        let mut is_owner = vec![false; self.nodes.len()];
        self.guests
            .iter()
            .for_each(|&(_, owner)| is_owner[owner] = true);
        let mut own = Vec::new();
        for island in 0..islands {
            let of = || runs.iter().filter(|run| run.island == island);
            let firsts = [self.masters.len(), self.reaches.len()];
            let places = |run| self.places_along(geometry, line, run, &is_owner);
            let places: Vec<Vec<usize>> = of().map(places).collect();
            self.number_masters(places.concat(), &mut master);
            for (run, places) in of().zip(&places) {
                self.add_reaches(geometry, shape, run, places, &master);
            }
            own.push(self.ranges(of(), firsts)?);
        }
        self.own = own;
        for member in self.clusters.iter_mut().flat_map(|c| &mut c.members) {
            member.along = self.along[member.point];
        }
        self.weigh_masters(line, masses, &master);
        Ok(())
    }

    /// A master for each place, in the order of rows, so that those of four strands stand together.
    fn number_masters(&mut self, mut places: Vec<usize>, master: &mut [usize]) {
        places.sort_by_key(|&point| self.slots[point]);
        for point in places {
            let owner = self.points[self.nodes[point]];
            if master[owner] == usize::MAX {
                master[owner] = self.masters.len();
                self.masters.push([0.0, 0.0, self.lag[owner]]);
            }
        }
    }

    /// Masses of masters, with those of the points between them.
    fn weigh_masters<const DIM: usize, const D: usize>(
        &mut self,
        line: &LinearModel<DIM, D>,
        masses: &[[f64; 2]],
        master: &[usize],
    ) {
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
    }

    /// Points of a wire that become masters: its ends, what is held or has guests or a spring along the wire, and
    /// between them so many that reaches are equally long and long enough.
    fn places_along<const DIM: usize, const D: usize>(
        &self,
        geometry: &Geometry<DIM, D>,
        line: &LinearModel<DIM, D>,
        run: &Run,
        is_owner: &[bool],
    ) -> Vec<usize> {
        let segments = &geometry.structure.segments;
        let last = run.nodes.len() - 1;
        // Between two masters a spring would pull at both of them, and miss what gives way at its own place.
        let springs = geometry.structure.springs.iter();
        let sprung: BTreeSet<usize> = springs
            .filter(|spring| spring.component == 0)
            .map(|spring| spring.node)
            .collect();
        let needed = |k: usize| {
            let (node, point) = (run.nodes[k], run.first + k);
            // Where nothing moves along the track, that all is held tells nothing.
            let held = !line.across_only && (!line.free[node][0] || sprung.contains(&node));
            k == 0 || k == last || held || is_owner[point]
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
        let alike = self.strands_of(run).and_then(|strands| {
            let [_, length, _] = strands.counts();
            alike(&needed, &at, shortest, length)
        });
        let places = alike.unwrap_or_else(|| pieces(&needed, &at, shortest));
        places.into_iter().map(|k| run.first + k).collect()
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
        let across_only = geometry.structure.across_only;
        let all = &geometry.structure.segments;
        if let [only] = places {
            self.along[*only] = Along {
                masters: [of(*only); 2],
                share: 0.0,
            };
        }
        for pair in places.windows(2) {
            let ends = [of(pair[0]), of(pair[1])];
            let own = run.segments[pair[0] - run.first..pair[1] - run.first].iter();
            let lean = 0.5 * own.map(|&number| all[number].turn).sum::<f64>();
            let (mut flexibility, mut at, mut turned) = (0.0, vec![0.0], -lean);
            for j in pair[0]..pair[1] {
                let segment = &all[run.segments[j - run.first]];
                let state = Geometry::<DIM, D>::segment_state(shape, segment);
                flexibility += 1.0 / along(segment, &state).2;
                at.push(at[at.len() - 1] + segment.rest_length);
                if DIM == 3 && !across_only {
                    self.slope[0][j] += turned + 0.5 * segment.turn;
                    turned += segment.turn;
                }
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
                // H stays that at rest where nothing moves along the track.
                lean: if DIM == 3 { lean } else { 0.0 },
                stiffness: if across_only { 0.0 } else { 1.0 / flexibility },
            });
        }
    }
}

/// Places among points at some distances: those that are needed, and between them so many that reaches are equally
/// long and long enough.
fn pieces(needed: &[usize], at: &[f64], shortest: f64) -> Vec<usize> {
    let mut places = vec![0];
    for pair in needed.windows(2) {
        let (mut from, to) = (at[pair[0]], at[pair[1]]);
        let pieces = ((to - from) / shortest).floor().max(1.0);
        let wanted = ((to - from) / pieces).min(to - from);
        for k in pair[0] + 1..pair[1] {
            // Rounding must not make a piece longer by an element.
            if at[k] - from > wanted * (1.0 - 1e-9) && to - at[k] >= shortest {
                places.push(k);
                from = at[k];
            }
        }
        places.push(pair[1]);
    }
    places.dedup();
    places
}

/// The same in strands of a length, with places in the same rows of all; none where reaches would be too short.
fn alike(needed: &[usize], at: &[f64], shortest: f64, length: usize) -> Option<Vec<usize>> {
    let in_strand = |k: &usize| k - (k / length).min(LANES - 1) * length;
    let mut rows: Vec<usize> = needed.iter().map(in_strand).chain([0, length]).collect();
    rows.sort_unstable();
    rows.dedup();
    let rows = pieces(&rows, at, shortest);
    let strands = (0..LANES).map(|strand| (strand * length, strand + 1 == LANES));
    let places = strands.flat_map(|(first, is_last)| {
        let own = rows.iter().filter(move |&&row| is_last || row < length);
        own.map(move |row| first + row)
    });
    let places: Vec<usize> = places.filter(|&k| k < at.len()).collect();
    let is_long = |pair: &[usize]| at[pair[1]] - at[pair[0]] >= shortest * (1.0 - 1e-9);
    places.windows(2).all(is_long).then_some(places)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Distances of points half a metre apart.
    fn at(points: usize) -> Vec<f64> {
        (0..points).map(|k| 0.5 * k as f64).collect()
    }

    #[test]
    fn places_lie_in_the_same_rows_of_all_strands() {
        // Held every 50 points; 8 spans and an end: strands of 100.
        let needed: Vec<usize> = (0..=8).map(|k| 50 * k).collect();
        let places = alike(&needed, &at(401), 5.0, 100).expect("places");
        assert!(needed.iter().all(|k| places.contains(k)));
        let rows = |strand: usize| {
            places
                .iter()
                .filter(move |&&k| k / 100 == strand)
                .map(|k| k % 100)
        };
        for strand in 1..4 {
            assert!(rows(0).eq(rows(strand)), "{places:?}");
        }
        assert_eq!(places.last(), Some(&400));
        // As many as equal pieces of 5 m or more are.
        assert_eq!(places.len(), 8 * 5 + 1);
    }

    #[test]
    fn places_of_one_strand_must_not_be_too_near_to_those_of_another() {
        // The second strand is held 2 m behind where the first one is.
        assert_eq!(alike(&[0, 50, 154, 400], &at(401), 5.0, 100), None);
        assert!(alike(&[0, 50, 160, 400], &at(401), 5.0, 100).is_some());
    }
}
