//! Axial motion: masters, the axial elements between them, and the axial positions of all points.

use crate::error::CoreError;
use crate::integrator::explicit::AxialPosition;
use crate::integrator::explicit::chain_model::builder::{ChainBuilder, segment_stiffness};
use crate::integrator::explicit::chain_model::parts::{AxialElementSpec, WireRun};
use crate::integrator::explicit::simd::packed::SIMD_LANES;
use crate::linear::model::LinearModel;
use crate::statics::assembly::{Geometry, Shape};
use std::collections::BTreeSet;

/// Length of the shortest axial element, as a multiple of the just stable one. At 1 ms it is 5.6 m,
/// and a tension wave of 20 Hz is too slow by (kL)²/24, two thousandths. With up to 1.5 the lowest
/// force of AC simple stays within 0.3 N; with more it depends on where elements begin, by 1 N.
const MIN_AXIAL_ELEMENT: f64 = 1.5;

impl ChainBuilder {
    /// Numbers masters and axial elements island by island, and sets the axial position of every
    /// point.
    pub(in crate::integrator::explicit) fn build_axial<const DIM: usize, const D: usize>(
        &mut self,
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        line: &LinearModel<DIM, D>,
        (runs, island_count): (&[WireRun], usize),
        masses: &[[f64; 2]],
    ) -> Result<(), CoreError> {
        let mut master = vec![usize::MAX; self.nodes.len()];
        let mut is_tie_master = vec![false; self.nodes.len()];
        self.tied_ends
            .iter()
            .for_each(|&(_, tie_master)| is_tie_master[tie_master] = true);
        let mut ranges = Vec::new();
        for island in 0..island_count {
            let island_runs = || runs.iter().filter(|run| run.island == island);
            let firsts = [self.masters.len(), self.axial_elements.len()];
            let places = |run| self.master_points(geometry, line, run, &is_tie_master);
            let places: Vec<Vec<usize>> = island_runs().map(places).collect();
            self.number_masters(places.concat(), &mut master);
            for (run, places) in island_runs().zip(&places) {
                self.add_axial_elements(geometry, shape, run, places, &master);
            }
            ranges.push(self.ranges(island_runs(), firsts)?);
        }
        self.islands = ranges;
        for member in self.stiff_groups.iter_mut().flat_map(|c| &mut c.members) {
            member.axial_position = self.axial_positions[member.point];
        }
        self.lump_master_masses(line, masses, &master);
        Ok(())
    }

    /// Numbers a master for each of `places`, in the order of packed rows, so that those of four
    /// stripes are adjacent.
    fn number_masters(&mut self, mut places: Vec<usize>, master: &mut [usize]) {
        places.sort_by_key(|&point| self.packed_indices[point]);
        for point in places {
            let tie_master = self.points[self.nodes[point]];
            if master[tie_master] == usize::MAX {
                master[tie_master] = self.masters.len();
                self.masters.push([0.0, 0.0, self.lag[tie_master]]);
            }
        }
    }

    /// Sets h²/m, α h and β/h of the masters; each has a share of the mass of the points between
    /// them.
    fn lump_master_masses<const DIM: usize, const D: usize>(
        &mut self,
        line: &LinearModel<DIM, D>,
        masses: &[[f64; 2]],
        master: &[usize],
    ) {
        for (node, [mass, damped]) in masses.iter().enumerate() {
            let position = self.axial_positions[self.points[node]];
            for (m, share) in position
                .masters
                .into_iter()
                .zip([1.0 - position.share, position.share])
            {
                self.masters[m][0] += share * mass;
                self.masters[m][1] += share * damped;
            }
        }
        let mut held = vec![false; self.masters.len()];
        for point in self.points_of_wires() {
            let tie_master = self.points[self.nodes[point]];
            if master[tie_master] != usize::MAX && !line.free[self.nodes[point]][0] {
                held[master[tie_master]] = true;
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

    /// Returns the points of a wire that become masters: its ends, points that are held, tied to,
    /// or have a spring along the track, and between them as many as give equal elements of
    /// sufficient length.
    fn master_points<const DIM: usize, const D: usize>(
        &self,
        geometry: &Geometry<DIM, D>,
        line: &LinearModel<DIM, D>,
        run: &WireRun,
        is_tie_master: &[bool],
    ) -> Vec<usize> {
        let segments = &geometry.structure.segments;
        let last = run.nodes.len() - 1;
        // A spring between two masters would pull at both, and miss the yielding of its own place.
        let springs = geometry.structure.springs.iter();
        let sprung: BTreeSet<usize> = springs
            .filter(|spring| spring.component == 0)
            .map(|spring| spring.node)
            .collect();
        let needed = |k: usize| {
            let (node, point) = (run.nodes[k], run.first + k);
            // Where nothing moves along the track, all nodes are held there, which distinguishes
            // none.
            let held = !line.across_only && (!line.free[node][0] || sprung.contains(&node));
            k == 0 || k == last || held || is_tie_master[point]
        };
        let needed: Vec<usize> = (0..=last).filter(|&k| needed(k)).collect();
        let mut distances = vec![0.0; last + 1];
        let mut fastest_wave: f64 = 0.0;
        for (k, &number) in run.segments.iter().enumerate() {
            let segment = &segments[number];
            distances[k + 1] = distances[k] + segment.rest_length;
            // Damping shortens the longest step by the square root of this (`critical_step`); the
            // factor itself leaves a margin.
            let damped = 1.0 + 2.0 * segment.damping.beta / self.h;
            fastest_wave =
                fastest_wave.max(damped * (segment.axial_stiffness / segment.mass).sqrt());
        }
        let shortest = MIN_AXIAL_ELEMENT * fastest_wave * self.h;
        let alike = self.stripes_of(run).and_then(|stripes| {
            let [_, length, _] = stripes.counts();
            subdivide_alike(&needed, &distances, shortest, length)
        });
        let places = alike.unwrap_or_else(|| subdivide(&needed, &distances, shortest));
        places.into_iter().map(|k| run.first + k).collect()
    }

    fn add_axial_elements<const DIM: usize, const D: usize>(
        &mut self,
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        run: &WireRun,
        places: &[usize],
        master: &[usize],
    ) {
        let master_of = |point: usize| master[self.points[self.nodes[point]]];
        let across_only = geometry.structure.across_only;
        let all = &geometry.structure.segments;
        if let [only] = places {
            self.axial_positions[*only] = AxialPosition {
                masters: [master_of(*only); 2],
                share: 0.0,
            };
        }
        for pair in places.windows(2) {
            let ends = [master_of(pair[0]), master_of(pair[1])];
            let segments_between = run.segments[pair[0] - run.first..pair[1] - run.first].iter();
            let half_turn = 0.5
                * segments_between
                    .map(|&number| all[number].turn)
                    .sum::<f64>();
            let (mut flexibility, mut distances, mut direction) = (0.0, vec![0.0], -half_turn);
            for j in pair[0]..pair[1] {
                let segment = &all[run.segments[j - run.first]];
                let state = Geometry::<DIM, D>::segment_state(shape, segment);
                flexibility += 1.0 / segment_stiffness(segment, &state).2;
                distances.push(distances[distances.len() - 1] + segment.rest_length);
                if DIM == 3 && !across_only {
                    self.slope[0][j] += direction + 0.5 * segment.turn;
                    direction += segment.turn;
                }
            }
            let length = distances[distances.len() - 1];
            for (k, place) in distances.iter().enumerate() {
                self.axial_positions[pair[0] + k] = AxialPosition {
                    masters: ends,
                    share: place / length,
                };
            }
            self.axial_elements.push(AxialElementSpec {
                masters: ends,
                segments: pair[0]..pair[1],
                // H stays at its static value where nothing moves along the track.
                half_turn: if DIM == 3 { half_turn } else { 0.0 },
                stiffness: if across_only { 0.0 } else { 1.0 / flexibility },
            });
        }
    }
}

/// Returns the needed places, subdivided into equal lengths of at least `shortest`, m. `at`: arc
/// length of each point, m.
fn subdivide(needed: &[usize], distances: &[f64], shortest: f64) -> Vec<usize> {
    let mut places = vec![0];
    for pair in needed.windows(2) {
        let (mut from, to) = (distances[pair[0]], distances[pair[1]]);
        let count = ((to - from) / shortest).floor().max(1.0);
        let wanted = ((to - from) / count).min(to - from);
        for k in pair[0] + 1..pair[1] {
            // Rounding must not make a part longer by an element.
            if distances[k] - from > wanted * (1.0 - 1e-9) && to - distances[k] >= shortest {
                places.push(k);
                from = distances[k];
            }
        }
        places.push(pair[1]);
    }
    places.dedup();
    places
}

/// Subdivides a striped wire at the same packed rows of all stripes, `length` points each; `None`
/// where elements would be shorter than `shortest`, m.
fn subdivide_alike(
    needed: &[usize],
    distances: &[f64],
    shortest: f64,
    length: usize,
) -> Option<Vec<usize>> {
    let in_stripe = |k: &usize| k - (k / length).min(SIMD_LANES - 1) * length;
    let mut rows: Vec<usize> = needed.iter().map(in_stripe).chain([0, length]).collect();
    rows.sort_unstable();
    rows.dedup();
    let rows = subdivide(&rows, distances, shortest);
    let stripes = (0..SIMD_LANES).map(|stripe| (stripe * length, stripe + 1 == SIMD_LANES));
    let places = stripes.flat_map(|(first, is_last)| {
        let own_rows = rows.iter().filter(move |&&row| is_last || row < length);
        own_rows.map(move |row| first + row)
    });
    let places: Vec<usize> = places.filter(|&k| k < distances.len()).collect();
    let is_long =
        |pair: &[usize]| distances[pair[1]] - distances[pair[0]] >= shortest * (1.0 - 1e-9);
    places.windows(2).all(is_long).then_some(places)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns arc lengths of points 0.5 m apart.
    fn at(points: usize) -> Vec<f64> {
        (0..points).map(|k| 0.5 * k as f64).collect()
    }

    #[test]
    fn places_lie_in_the_same_rows_of_all_strands() {
        // Held every 50 points; 8 spans and an end: stripes of 100.
        let needed: Vec<usize> = (0..=8).map(|k| 50 * k).collect();
        let places = subdivide_alike(&needed, &at(401), 5.0, 100).expect("places");
        assert!(needed.iter().all(|k| places.contains(k)));
        let rows = |stripe: usize| {
            places
                .iter()
                .filter(move |&&k| k / 100 == stripe)
                .map(|k| k % 100)
        };
        for stripe in 1..4 {
            assert!(rows(0).eq(rows(stripe)), "{places:?}");
        }
        assert_eq!(places.last(), Some(&400));
        // The number of equal parts of 5 m or more.
        assert_eq!(places.len(), 8 * 5 + 1);
    }

    #[test]
    fn places_of_one_strand_must_not_be_too_near_to_those_of_another() {
        // The second stripe is held 2 m behind the place of the first one.
        assert_eq!(
            subdivide_alike(&[0, 50, 154, 400], &at(401), 5.0, 100),
            None
        );
        assert!(subdivide_alike(&[0, 50, 160, 400], &at(401), 5.0, 100).is_some());
    }
}
