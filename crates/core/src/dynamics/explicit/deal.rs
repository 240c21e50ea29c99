//! From lists of points to rows: see [`rows`](super::rows).

use super::along;
use super::groups::Groups;
use super::layout::{Chains, Ranges};
use super::plan::{Plan, Span};
use super::rows::{Across, Common, HALO, LANES, place};
use super::{Along, Cut, Explicit, Masters, Own, Reach};
use std::ops::Range;

/// Where the points of an island lie.
struct Strands {
    points: Range<usize>,
    /// Its first row.
    first: usize,
    /// Points of a strand.
    length: usize,
}

impl Strands {
    /// Rows, those of copies included.
    fn rows(&self) -> Range<usize> {
        self.first..self.first + self.length + 2 * HALO
    }

    /// Slot of a point in its own strand.
    fn slot(&self, point: usize) -> usize {
        let number = point - self.points.start;
        self.slot_in(number / self.length, point)
    }

    /// Slot of a point as a strand has it, of its own or as a copy.
    fn slot_in(&self, strand: usize, point: usize) -> usize {
        let row = self.first + HALO + point - self.points.start - strand * self.length;
        LANES * row + strand
    }

    /// Strands with points, and the length of all but the last of them.
    fn counts(&self) -> (usize, usize) {
        (self.points.len().div_ceil(self.length), self.length)
    }

    /// Points of a strand.
    fn strand(&self, strand: usize) -> Range<usize> {
        let end = self.points.end;
        let first = (self.points.start + strand * self.length).min(end);
        first..(first + self.length).min(end)
    }

    /// Slots of copies, and the points that they are copies of.
    fn copies(&self) -> Vec<[usize; 2]> {
        let Range { start, end } = self.points;
        let of = |strand: usize| {
            let own = self.strand(strand);
            let (mut before, mut behind) = (0..0, 0..0);
            if !own.is_empty() {
                before = own.start.saturating_sub(HALO).max(start)..own.start;
                behind = own.end..(own.end + HALO).min(end);
            }
            let copy = move |point| [self.slot_in(strand, point), point];
            before.chain(behind).map(copy)
        };
        (0..LANES).flat_map(of).collect()
    }

    /// How a reach lies in the strands.
    fn span(&self, reach: &along::Reach) -> Span {
        let Range { start, end } = reach.segments;
        let strand = (start - self.points.start) / self.length;
        let row = |point: usize| place(self.slot_in(strand, point)).0 - self.first;
        Span {
            strand,
            rows: [row(start), row(end)],
            is_over_cut: !self.strand(strand).contains(&end),
        }
    }

    /// Reaches as they end, those over cuts last.
    fn order(&self, reaches: &[along::Reach]) -> Vec<usize> {
        let mut order: Vec<usize> = (0..reaches.len()).collect();
        order.sort_by_key(|&k| {
            let span = self.span(&reaches[k]);
            (span.is_over_cut, span.rows[1])
        });
        order
    }

    /// Places between two strands, for reaches in their order along the wires; `new` says which numbers they get.
    fn cuts(&self, reaches: &[along::Reach], new: &[usize]) -> Vec<Cut> {
        let firsts = (1..LANES).map(|strand| (strand, self.strand(strand)));
        let firsts = firsts.filter(|(_, own)| !own.is_empty());
        let cut = |(strand, own): (usize, Range<usize>)| {
            let behind = own.start;
            let next = reaches.partition_point(|r| r.segments.start < behind);
            let is_over = |k: &usize| reaches[*k].segments.end >= behind;
            let is_next = |k: &usize| own.contains(&reaches[*k].segments.start);
            let last = next.checked_sub(1);
            Cut {
                head: self.slot_in(strand, behind - 1),
                tail: self.slot_in(strand - 1, behind),
                last: last.map(|k| new[k]),
                over: last.filter(is_over).map(|k| new[k]),
                next: Some(next)
                    .filter(|k| *k < reaches.len())
                    .filter(is_next)
                    .map(|k| new[k]),
            }
        };
        firsts.map(cut).collect()
    }
}

impl Chains {
    /// The same in rows.
    pub fn dealt<const DIM: usize>(mut self) -> Explicit<DIM> {
        let mut all: Vec<Strands> = Vec::new();
        for own in &self.own {
            all.push(Strands {
                points: own.points.clone(),
                first: all.last().map_or(0, |s| s.rows().end),
                length: own.points.len().div_ceil(LANES),
            });
        }
        let mut slots = vec![usize::MAX; self.nodes.len()];
        for strands in &all {
            let points = strands.points.clone();
            points.for_each(|point| slots[point] = strands.slot(point));
        }
        let clusters = self.clusters.iter_mut().flat_map(|c| &mut c.members);
        clusters.for_each(|m| m.point = slots[m.point]);
        let mut new = self.empty(&slots, all.last().map_or(0, |s| s.rows().end));
        for (strands, own) in all.iter().zip(&self.own) {
            for point in strands.points.clone() {
                let slot = slots[point];
                self.put(point, slot, &mut new);
                new.nodes[slot] = self.nodes[point];
            }
            let mut copies = strands.copies();
            for [copy, point] in &mut copies {
                self.put(*point, *copy, &mut new);
                *point = slots[*point];
                new.home[*copy] = *point;
            }
            let (cuts, plan) = self.deal_reaches(own, strands, &slots, &mut new.reaches);
            new.own.push(Own {
                rows: strands.rows(),
                copies,
                cuts,
                plan,
                reaches: own.reaches.clone(),
                masters: own.masters.clone(),
                guests: own.guests.clone(),
                groups: Groups::new(&new.clusters[own.clusters.clone()]),
                linked: new.linked(own.clusters.clone()),
            });
        }
        new
    }

    /// Reaches of an island in the order of their ends; what lies between strands, and what comes when.
    fn deal_reaches(
        &self,
        own: &Ranges,
        strands: &Strands,
        slots: &[usize],
        to: &mut Vec<Reach>,
    ) -> (Vec<Cut>, Plan) {
        let (reaches, first) = (&self.reaches[own.reaches.clone()], own.reaches.start);
        let (order, none) = (strands.order(reaches), self.reaches.len());
        let mut numbers = vec![none; reaches.len()];
        for (k, &old) in order.iter().enumerate() {
            numbers[old] = first + k;
        }
        let spans: Vec<Span> = order.iter().map(|&k| strands.span(&reaches[k])).collect();
        for (&k, span) in order.iter().zip(&spans) {
            let before = k.checked_sub(1);
            let before = before.filter(|&k| strands.span(&reaches[k]).strand == span.strand);
            let Range { start, end } = reaches[k].segments;
            to.push(Reach {
                masters: reaches[k].masters.map(|m| m as u32),
                ends: [slots[start] as u32, slots[end] as u32],
                before: before.map_or(none, |k| numbers[k]) as u32,
                stiffness: reaches[k].stiffness,
            });
        }
        let plan = Plan::new(&spans, strands.counts(), first, none);
        (strands.cuts(reaches, &numbers), plan)
    }

    /// Everything but rows and what belongs to islands.
    fn empty<const DIM: usize>(&mut self, slots: &[usize], rows: usize) -> Explicit<DIM> {
        let numbers = LANES * rows;
        let of_masters = |k: usize| self.masters.iter().map(|m| m[k]).collect();
        let points = self.points.iter().map(|&point| slots[point]).collect();
        let guests = self.guests.iter();
        Explicit {
            h: self.h,
            per_step: 1.0 / self.h,
            nodes: vec![usize::MAX; numbers],
            points,
            home: (0..numbers).collect(),
            own: Vec::new(),
            common: vec![Common::default(); rows],
            across: vec![vec![Across::default(); rows]; DIM - 1],
            along: vec![Along::default(); numbers],
            reaches: Vec::new(),
            masters: Masters {
                inverse: of_masters(0),
                damping: of_masters(1),
                lag: of_masters(2),
            },
            clusters: std::mem::take(&mut self.clusters),
            in_cluster: vec![None; numbers],
            guests: guests.map(|&(g, o)| (slots[g], slots[o])).collect(),
        }
    }

    /// Put the numbers of a point where it lies.
    fn put<const DIM: usize>(&self, point: usize, slot: usize, to: &mut Explicit<DIM>) {
        let (row, lane) = place(slot);
        let common = &mut to.common[row];
        common.filter[lane] = self.filter[point];
        common.second[lane] = self.second[point];
        common.per_length[lane] = self.per_length[point];
        common.bending[lane] = self.bending[point];
        common.damping[lane] = self.damping[point];
        common.lag[lane] = self.lag[point];
        for (c, across) in to.across.iter_mut().enumerate() {
            across[row].inverse[lane] = self.inverse[c][point];
            across[row].tension[lane] = self.tension[c][point];
            across[row].slope[lane] = self.slope[c][point];
        }
        to.along[slot] = self.along[point];
        to.in_cluster[slot] = self.in_cluster[point];
    }
}

impl<const DIM: usize> Explicit<DIM> {
    /// Nodes of some clusters.
    fn linked(&self, clusters: Range<usize>) -> Vec<usize> {
        let members = self.clusters[clusters].iter().flat_map(|c| &c.members);
        members.map(|m| m.node).collect()
    }
}
