//! Clusters of equally many points side by side in the lanes.

use crate::integrator::explicit::simd::rows::{LANES, place};
use crate::integrator::explicit::stiff_groups::cluster::{Cluster, Member};
use std::collections::BTreeMap;

/// A point of each cluster of a group.
#[derive(Debug, Clone, Copy)]
pub(in crate::integrator::explicit) struct Points<const L: usize> {
    pub row: [u32; L],
    pub lane: [u32; L],
    pub node: [u32; L],
    pub masters: [[u32; L]; 2],
    /// Share of the second master.
    pub share: [f64; L],
    pub lag: [f64; L],
    /// q/m of the segments before and behind, for each direction across.
    pub filter: [[[f64; L]; 2]; 2],
    /// r/m of the points before and behind and of its own, in their order.
    pub second: [[[f64; L]; 3]; 2],
    /// h²/m and P across, s²/kg.
    pub inverse: [[f64; L]; 2],
    pub response: [[f64; L]; 2],
}

/// Clusters whose numbers lie side by side.
#[derive(Debug, Clone)]
pub(in crate::integrator::explicit) struct Group<const L: usize> {
    pub points: Vec<Points<L>>,
    /// −W K and −W C/h, column by column: of each the numbers for u°, then those for h v°.
    pub columns: Vec<[f64; L]>,
}

/// The same of pairs, with matrices for the differences.
#[derive(Debug, Clone)]
pub(in crate::integrator::explicit) struct Pairs<const L: usize> {
    pub points: [Points<L>; 2],
    pub columns: Vec<[f64; L]>,
}

/// All clusters of an island.
#[derive(Debug, Clone, Default)]
pub(in crate::integrator::explicit) struct Groups {
    /// Those whose points fill rows, each in the lane of its number, with masters one behind the other.
    pub rows: Vec<Pairs<LANES>>,
    pub pairs: Vec<Pairs<LANES>>,
    pub wide: Vec<Group<LANES>>,
    pub single: Vec<Group<1>>,
}

impl Groups {
    pub fn new(clusters: &[Cluster]) -> Self {
        let pairs = clusters.iter().filter(|c| c.pair.is_some());
        let (rows, others) = rows(pairs.collect());
        let (pairs, over) = others.as_chunks::<LANES>();
        let mut by_size = BTreeMap::<usize, Vec<&Cluster>>::new();
        let others = clusters.iter().filter(|c| c.pair.is_none());
        for cluster in others.chain(over.iter().copied()) {
            by_size.entry(cluster.size).or_default().push(cluster);
        }
        let mut new = Self {
            rows: rows.iter().filter_map(Pairs::new).collect(),
            pairs: pairs.iter().filter_map(Pairs::new).collect(),
            ..Self::default()
        };
        for alike in by_size.values() {
            let (wide, rest) = alike.as_chunks::<LANES>();
            new.wide.extend(wide.iter().map(Group::new));
            new.single
                .extend(rest.iter().map(|one| Group::new(&[*one])));
        }
        new
    }
}

/// Four and four pairs that fill rows, and the others.
fn rows(mut all: Vec<&Cluster>) -> (Vec<[&Cluster; LANES]>, Vec<&Cluster>) {
    let slots = |c: &Cluster| [0, 1].map(|k| place(c.members[k].point));
    all.sort_by_cached_key(|c| {
        let [(first, lane), (second, its)] = slots(c);
        [first, second, lane, its]
    });
    let (mut found, mut others) = (Vec::new(), Vec::new());
    let mut left = &all[..];
    while let Some((first, behind)) = left.split_first() {
        left = match left.split_first_chunk() {
            Some((four, behind)) if fill_rows(four) => {
                found.push(*four);
                behind
            }
            _ => {
                others.push(*first);
                behind
            }
        };
    }
    (found, others)
}

/// Whether points lie in one row, each in the lane of its number, and their masters one behind the other.
fn fill_rows(pairs: &[&Cluster; LANES]) -> bool {
    (0..2).all(|k| {
        let members = pairs.map(|c| &c.members[k]);
        let (row, masters) = (place(members[0].point).0, members[0].along.masters);
        let is_next = |(lane, m): (usize, &&Member)| {
            place(m.point) == (row, lane) && m.along.masters == masters.map(|master| master + lane)
        };
        members.iter().enumerate().all(is_next)
    })
}

impl<const L: usize> Points<L> {
    /// Point `k` of each cluster.
    fn new(clusters: &[&Cluster; L], k: usize) -> Self {
        let members = clusters.map(|c| &c.members[k]);
        Self {
            row: members.map(|m| place(m.point).0 as u32),
            lane: members.map(|m| place(m.point).1 as u32),
            node: members.map(|m| m.node as u32),
            masters: [0, 1].map(|end| members.map(|m| m.along.masters[end] as u32)),
            share: members.map(|m| m.along.share),
            lag: members.map(|m| m.lag),
            filter: [0, 1]
                .map(|c| [0, 1].map(|side| members.map(|m| m.inverse[c] * m.filter[side]))),
            second: [0, 1].map(|c| [0, 1, 2].map(|k| members.map(|m| m.inverse[c] * m.second[k]))),
            inverse: [0, 1].map(|c| members.map(|m| m.inverse[c])),
            response: [0, 1].map(|c| members.map(|m| m.response[c])),
        }
    }
}

/// Columns of matrices side by side: of each the numbers for places, then those for speeds.
fn columns<const L: usize>(size: usize, matrices: [[&[f64]; 2]; L]) -> Vec<[f64; L]> {
    let of = |j: usize, kind: usize| {
        (0..size).map(move |i| matrices.map(|both| both[kind][i * size + j]))
    };
    (0..size).flat_map(|j| of(j, 0).chain(of(j, 1))).collect()
}

impl<const L: usize> Group<L> {
    /// From clusters with as many points each.
    fn new(clusters: &[&Cluster; L]) -> Self {
        let points = 0..clusters[0].members.len();
        let matrices = clusters.map(|c| [&c.of_place[..], &c.of_speed[..]]);
        Self {
            points: points.map(|k| Points::new(clusters, k)).collect(),
            columns: columns(clusters[0].size, matrices),
        }
    }
}

impl<const L: usize> Pairs<L> {
    /// None unless all are pairs.
    fn new(clusters: &[&Cluster; L]) -> Option<Self> {
        let mut matrices = [[&[][..]; 2]; L];
        let mut size = 0;
        for (of, cluster) in matrices.iter_mut().zip(clusters) {
            let pair = cluster.pair.as_ref()?;
            (size, *of) = (pair.size, [&pair.of_place[..], &pair.of_speed[..]]);
        }
        Some(Self {
            points: [0, 1].map(|k| Points::new(clusters, k)),
            columns: columns(size, matrices),
        })
    }
}
