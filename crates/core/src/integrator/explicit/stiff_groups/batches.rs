//! Batches of stiff groups of equal size, one to a SIMD lane.

use crate::integrator::explicit::simd::packed::{SIMD_LANES, row_and_lane};
use crate::integrator::explicit::stiff_groups::stiff_group::{Member, StiffGroup};
use std::collections::BTreeMap;

/// One point of each stiff group of a batch.
#[derive(Debug, Clone, Copy)]
pub(in crate::integrator::explicit) struct BatchPoints<const L: usize> {
    pub row: [u32; L],
    pub simd_lane: [u32; L],
    pub node: [u32; L],
    pub masters: [[u32; L]; 2],
    /// Share of the second master.
    pub share: [f64; L],
    pub lag: [f64; L],
    /// Filter weights q/m of the segments before and behind, by transverse direction.
    pub filter: [[[f64; L]; 2]; 2],
    /// Second filter weights r/m of the preceding point, the point itself and the next one.
    pub second: [[[f64; L]; 3]; 2],
    /// Inverse mass h²/m and response P across, s²/kg.
    pub inverse: [[f64; L]; 2],
    pub response: [[f64; L]; 2],
}

/// Stiff groups whose numbers are stored side by side.
#[derive(Debug, Clone)]
pub(in crate::integrator::explicit) struct StiffBatch<const L: usize> {
    pub points: Vec<BatchPoints<L>>,
    /// Matrices −W K and −W C/h by column: numbers for u°, then for h v°, N/m.
    pub columns: Vec<[f64; L]>,
}

/// Pairs whose numbers are stored side by side, with matrices for differences.
#[derive(Debug, Clone)]
pub(in crate::integrator::explicit) struct PairBatch<const L: usize> {
    pub points: [BatchPoints<L>; 2],
    pub columns: Vec<[f64; L]>,
}

/// All stiff groups of an island.
#[derive(Debug, Clone, Default)]
pub(in crate::integrator::explicit) struct StiffBatches {
    /// Pairs whose points fill packed rows, in ascending SIMD lanes, with consecutive masters.
    pub packed_pairs: Vec<PairBatch<SIMD_LANES>>,
    pub pairs: Vec<PairBatch<SIMD_LANES>>,
    pub wide: Vec<StiffBatch<SIMD_LANES>>,
    pub single: Vec<StiffBatch<1>>,
}

impl StiffBatches {
    pub fn new(stiff_groups: &[StiffGroup]) -> Self {
        let pairs = stiff_groups.iter().filter(|c| c.pair.is_some());
        let (packed_pairs, others) = packed_pairs(pairs.collect());
        let (pairs, over) = others.as_chunks::<SIMD_LANES>();
        let mut by_size = BTreeMap::<usize, Vec<&StiffGroup>>::new();
        let others = stiff_groups.iter().filter(|c| c.pair.is_none());
        for stiff_group in others.chain(over.iter().copied()) {
            by_size
                .entry(stiff_group.size)
                .or_default()
                .push(stiff_group);
        }
        let mut new = Self {
            packed_pairs: packed_pairs.iter().filter_map(PairBatch::new).collect(),
            pairs: pairs.iter().filter_map(PairBatch::new).collect(),
            ..Self::default()
        };
        for alike in by_size.values() {
            let (wide, rest) = alike.as_chunks::<SIMD_LANES>();
            new.wide.extend(wide.iter().map(StiffBatch::new));
            new.single
                .extend(rest.iter().map(|one| StiffBatch::new(&[*one])));
        }
        new
    }
}

/// Returns the pairs that fill packed rows, four by four, and the others.
fn packed_pairs(mut all: Vec<&StiffGroup>) -> (Vec<[&StiffGroup; SIMD_LANES]>, Vec<&StiffGroup>) {
    let packed_indices = |c: &StiffGroup| [0, 1].map(|k| row_and_lane(c.members[k].point));
    all.sort_by_cached_key(|c| {
        let [(first, simd_lane), (second, second_lane)] = packed_indices(c);
        [first, second, simd_lane, second_lane]
    });
    let (mut packed, mut others) = (Vec::new(), Vec::new());
    let mut left = &all[..];
    while let Some((first, behind)) = left.split_first() {
        left = match left.split_first_chunk() {
            Some((four, behind)) if are_packed(four) => {
                packed.push(*four);
                behind
            }
            _ => {
                others.push(*first);
                behind
            }
        };
    }
    (packed, others)
}

/// Returns true if points share a row, in ascending SIMD lanes, and their masters are consecutive.
fn are_packed(pairs: &[&StiffGroup; SIMD_LANES]) -> bool {
    (0..2).all(|k| {
        let members = pairs.map(|c| &c.members[k]);
        let (row, masters) = (
            row_and_lane(members[0].point).0,
            members[0].axial_position.masters,
        );
        let is_next = |(simd_lane, m): (usize, &&Member)| {
            row_and_lane(m.point) == (row, simd_lane)
                && m.axial_position.masters == masters.map(|master| master + simd_lane)
        };
        members.iter().enumerate().all(is_next)
    })
}

impl<const L: usize> BatchPoints<L> {
    /// Collects point `k` of each stiff group.
    fn new(stiff_groups: &[&StiffGroup; L], k: usize) -> Self {
        let members = stiff_groups.map(|c| &c.members[k]);
        Self {
            row: members.map(|m| row_and_lane(m.point).0 as u32),
            simd_lane: members.map(|m| row_and_lane(m.point).1 as u32),
            node: members.map(|m| m.node as u32),
            masters: [0, 1].map(|end| members.map(|m| m.axial_position.masters[end] as u32)),
            share: members.map(|m| m.axial_position.share),
            lag: members.map(|m| m.lag),
            filter: [0, 1]
                .map(|c| [0, 1].map(|side| members.map(|m| m.inverse[c] * m.filter[side]))),
            second: [0, 1].map(|c| [0, 1, 2].map(|k| members.map(|m| m.inverse[c] * m.second[k]))),
            inverse: [0, 1].map(|c| members.map(|m| m.inverse[c])),
            response: [0, 1].map(|c| members.map(|m| m.response[c])),
        }
    }
}

/// Returns the columns of matrices side by side: numbers for positions, then for velocities.
fn columns<const L: usize>(size: usize, matrices: [[&[f64]; 2]; L]) -> Vec<[f64; L]> {
    let column = |j: usize, kind: usize| {
        (0..size).map(move |i| matrices.map(|both| both[kind][i * size + j]))
    };
    (0..size)
        .flat_map(|j| column(j, 0).chain(column(j, 1)))
        .collect()
}

impl<const L: usize> StiffBatch<L> {
    /// Collects stiff groups of the same number of points.
    fn new(stiff_groups: &[&StiffGroup; L]) -> Self {
        let points = 0..stiff_groups[0].members.len();
        let matrices = stiff_groups.map(|c| [&c.position_columns[..], &c.velocity_columns[..]]);
        Self {
            points: points.map(|k| BatchPoints::new(stiff_groups, k)).collect(),
            columns: columns(stiff_groups[0].size, matrices),
        }
    }
}

impl<const L: usize> PairBatch<L> {
    /// Collects pairs; `None` unless all are.
    fn new(stiff_groups: &[&StiffGroup; L]) -> Option<Self> {
        let mut matrices = [[&[][..]; 2]; L];
        let mut size = 0;
        for (of, stiff_group) in matrices.iter_mut().zip(stiff_groups) {
            let pair = stiff_group.pair.as_ref()?;
            (size, *of) = (
                pair.size,
                [&pair.position_columns[..], &pair.velocity_columns[..]],
            );
        }
        Some(Self {
            points: [0, 1].map(|k| BatchPoints::new(stiff_groups, k)),
            columns: columns(size, matrices),
        })
    }
}
