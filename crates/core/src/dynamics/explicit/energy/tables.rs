//! Numbers of an island that stay, from those of its steps.

use super::field::Field;
use super::filtered::Filtered;
use super::form::{Form, Piece};
use super::joined::{Joined, Joint};
use crate::dynamics::explicit::cluster::Member;
use crate::dynamics::explicit::rows::{LANES, place};
use crate::dynamics::explicit::{Along, Explicit, Reach};

impl Form {
    pub fn new<const DIM: usize>(steps: &Explicit<DIM>, island: usize) -> Self {
        let own = &steps.own[island];
        let slots = along_wires(steps, island);
        let mut number = vec![usize::MAX; steps.nodes.len()];
        slots
            .iter()
            .enumerate()
            .for_each(|(k, &slot)| number[slot] = k);
        let is_guest = |slot: usize| steps.points[steps.nodes[slot]] != slot;
        let of = |read: &dyn Fn(usize, usize) -> f64| -> Vec<f64> {
            let read = |&slot: &usize| {
                let (row, lane) = place(slot);
                read(row, lane)
            };
            slots.iter().map(read).collect()
        };
        let both = |read: &dyn Fn(usize, usize, usize) -> f64| {
            [0, 1].map(|c| {
                if c + 1 < DIM {
                    of(&|r, l| read(c, r, l))
                } else {
                    Vec::new()
                }
            })
        };
        let weight = both(&|c, row, lane| {
            let inverse = steps.across[c][row].inverse[lane];
            let moves = inverse > 0.0 && !is_guest(LANES * row + lane);
            if moves { 1.0 / inverse } else { 0.0 }
        });
        let filter = of(&|r, l| steps.common[r].filter[l]);
        let second = of(&|r, l| steps.common[r].second[l]);
        let reaches = own
            .blocks
            .iter()
            .flat_map(|b| &steps.reaches[b.reaches.clone()]);
        let piece = |reach: &Reach| Piece {
            masters: reach.masters.map(|m| m as usize - own.masters.start),
            points: reach.ends.map(|slot| number[slot as usize]),
            stiffness: reach.stiffness,
            lean: reach.lean,
        };
        let mut clusters: Vec<usize> = slots
            .iter()
            .filter_map(|&s| steps.in_cluster[s])
            .map(|c| c.0)
            .collect();
        clusters.sort_unstable();
        clusters.dedup();
        let joint = |member: &Member| Joint {
            point: number[member.point],
            along: Along {
                masters: member.along.masters.map(|m| m - own.masters.start),
                share: member.along.share,
            },
        };
        let joined = |number: usize| Joined {
            number,
            joints: steps.clusters[number].members.iter().map(joint).collect(),
        };
        Self {
            masters: own.masters.clone(),
            per_length: of(&|r, l| steps.common[r].per_length[l]),
            bending: of(&|r, l| steps.common[r].bending[l]),
            tension: both(&|c, r, l| steps.across[c][r].tension[l]),
            slope: both(&|c, r, l| steps.across[c][r].slope[l]),
            filtered: [0, 1].map(|c| Filtered::new(&weight[c], &filter, &second)),
            alpha: of(&|r, l| steps.damped[r].alpha[l]),
            lag: of(&|r, l| steps.damped[r].lag[l]),
            pieces: reaches.map(piece).collect(),
            clusters: clusters.into_iter().map(joined).collect(),
            y: Field::default(),
            d: Field::default(),
            old: Field::default(),
            work: Field::default(),
            weight,
            slots,
        }
    }
}

/// Slots of an island, point by point along its wires.
fn along_wires<const DIM: usize>(steps: &Explicit<DIM>, island: usize) -> Vec<usize> {
    let mut found = Vec::new();
    for block in &steps.own[island].blocks {
        for lane in 0..LANES {
            let slots = block.rows.clone().map(|row| LANES * row + lane);
            found.extend(slots.filter(|&slot| steps.nodes[slot] != usize::MAX));
        }
    }
    found
}
