//! Numbers of an island that stay, from those of its steps.

use crate::integrator::explicit::energy::filtered::Filtered;
use crate::integrator::explicit::energy::form::{Form, Piece};
use crate::integrator::explicit::energy::joined::{Joined, Joint};
use crate::integrator::explicit::simd::rows::{LANES, place};
use crate::integrator::explicit::stiff_groups::cluster::Member;
use crate::integrator::explicit::{Along, Explicit, Own, Reach};
use std::collections::BTreeSet;
use std::ops::Range;

impl Form {
    pub(in crate::integrator::explicit::energy) fn new<const DIM: usize>(
        steps: &Explicit<DIM>,
        island: usize,
    ) -> Self {
        let own = &steps.own[island];
        let lanes = lanes(steps, own);
        let points = Points::new(steps, own, &lanes);
        let weight = points.both(|c, slot| points.weight(c, slot));
        let filter = points.of(|row, lane| steps.common[row].filter[lane]);
        let second = points.of(|row, lane| steps.common[row].second[lane]);
        let across = |c: usize, slot: usize| (&steps.across[c][slot / LANES], slot % LANES);
        Self {
            masters: own.masters.clone(),
            per_length: points.of(|row, lane| steps.common[row].per_length[lane]),
            bending: points.of(|row, lane| steps.common[row].bending[lane]),
            tension: points.both(|c, slot| {
                let (across, lane) = across(c, slot);
                across.tension[lane]
            }),
            slope: points.both(|c, slot| {
                let (across, lane) = across(c, slot);
                across.slope[lane]
            }),
            filtered: [0, 1].map(|c| Filtered::new(&weight[c], &filter, &second)),
            alpha: points.of(|row, lane| steps.damped[row].alpha[lane]),
            lag: points.of(|row, lane| steps.damped[row].lag[lane]),
            pieces: points.pieces(),
            clusters: points.clusters(),
            weight,
            lanes,
        }
    }
}

/// Where the points of an island lie, one behind the other along its wires: rows of a lane.
fn lanes<const DIM: usize>(steps: &Explicit<DIM>, own: &Own) -> Vec<(Range<usize>, usize)> {
    let mut found: Vec<(Range<usize>, usize)> = Vec::new();
    for block in &own.blocks {
        for lane in 0..LANES {
            let is_there = |row: &usize| steps.nodes[LANES * row + lane] != usize::MAX;
            for row in block.rows.clone().filter(is_there) {
                match found.last_mut() {
                    Some((rows, of)) if *of == lane && rows.end == row => rows.end += 1,
                    _ => found.push((row..row + 1, lane)),
                }
            }
        }
    }
    found
}

/// Points of an island, one behind the other along its wires.
struct Points<'a, const DIM: usize> {
    steps: &'a Explicit<DIM>,
    own: &'a Own,
    slots: Vec<usize>,
    /// Number of each slot.
    number: Vec<usize>,
}

impl<'a, const DIM: usize> Points<'a, DIM> {
    fn new(steps: &'a Explicit<DIM>, own: &'a Own, lanes: &[(Range<usize>, usize)]) -> Self {
        let of = |(rows, lane): &(Range<usize>, usize)| {
            let lane = *lane;
            rows.clone().map(move |row| LANES * row + lane)
        };
        let slots: Vec<usize> = lanes.iter().flat_map(of).collect();
        let mut number = vec![usize::MAX; steps.nodes.len()];
        for (k, &slot) in slots.iter().enumerate() {
            number[slot] = k;
        }
        Self {
            steps,
            own,
            slots,
            number,
        }
    }

    /// A number of each, from its row and lane.
    fn of(&self, read: impl Fn(usize, usize) -> f64) -> Vec<f64> {
        let read = |&slot: &usize| {
            let (row, lane) = place(slot);
            read(row, lane)
        };
        self.slots.iter().map(read).collect()
    }

    /// The same of each direction across.
    fn both(&self, read: impl Fn(usize, usize) -> f64) -> [Vec<f64>; 2] {
        let of = |c: usize| self.slots.iter().map(|&slot| read(c, slot)).collect();
        [0, 1].map(|c| if c + 1 < DIM { of(c) } else { Vec::new() })
    }

    /// m/h²; zero where it is held, and of guests.
    fn weight(&self, across: usize, slot: usize) -> f64 {
        let (row, lane) = place(slot);
        let inverse = self.steps.across[across][row].inverse[lane];
        let is_guest = self.steps.points[self.steps.nodes[slot]] != slot;
        if inverse > 0.0 && !is_guest {
            1.0 / inverse
        } else {
            0.0
        }
    }

    fn pieces(&self) -> Vec<Piece> {
        let blocks = self.own.blocks.iter();
        let reaches = blocks.flat_map(|b| &self.steps.reaches[b.reaches.clone()]);
        let piece = |reach: &Reach| Piece {
            masters: reach.masters.map(|m| m as usize - self.own.masters.start),
            points: reach.ends.map(|slot| self.number[slot as usize]),
            stiffness: reach.stiffness,
            lean: reach.lean,
        };
        reaches.map(piece).collect()
    }

    fn clusters(&self) -> Vec<Joined> {
        let numbers = self.slots.iter().filter_map(|&s| self.steps.in_cluster[s]);
        let numbers: BTreeSet<usize> = numbers.map(|(number, _)| number).collect();
        let joint = |member: &Member| Joint {
            point: self.number[member.point],
            along: Along {
                masters: member.along.masters.map(|m| m - self.own.masters.start),
                share: member.along.share,
            },
        };
        let members = |number: usize| self.steps.clusters[number].members.iter();
        let joined = |number: usize| Joined {
            number,
            joints: members(number).map(joint).collect(),
        };
        numbers.into_iter().map(joined).collect()
    }
}
