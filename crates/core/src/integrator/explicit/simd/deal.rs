//! From lists of points to rows: see [`rows`](crate::integrator::explicit::simd::rows).

use crate::integrator::explicit::chain_model::layout::Chains;
use crate::integrator::explicit::simd::plan::{Plan, Span};
use crate::integrator::explicit::simd::rows::{Across, Common, Damped, LANES, each, place};
use crate::integrator::explicit::simd::strands::Strands;
use crate::integrator::explicit::stiff_groups::batches::Groups;
use crate::integrator::explicit::{Along, Block, Cut, Explicit, Guest, Masters, Own, Reach};
use std::collections::BTreeSet;
use std::ops::Range;
use std::sync::OnceLock;

/// Share of a number that is rounding of a mean of equal ones.
const ROUNDING: f64 = 1e-12;

impl Chains {
    /// The same in rows.
    pub fn dealt<const DIM: usize>(mut self) -> Explicit<DIM> {
        let (all, slots) = (
            std::mem::take(&mut self.strands),
            std::mem::take(&mut self.slots),
        );
        let clusters = self.clusters.iter_mut().flat_map(|c| &mut c.members);
        clusters.for_each(|m| m.point = slots[m.point]);
        let mut new = self.empty(&slots, all.last().map_or(0, |s| s.rows().end));
        let mut all = all.iter();
        for own in &self.own {
            let first = new.own.last().map_or(0, |own| own.rows.end);
            let strands = all.by_ref().zip(&own.blocks);
            let of = |(strands, reaches): (&Strands, &Range<usize>)| {
                self.block(strands, reaches.clone(), &slots, &mut new)
            };
            let blocks: Vec<Block> = strands.map(of).collect();
            let rows = first..blocks.last().map_or(first, |block| block.rows.end);
            new.own.push(Own {
                blocks,
                rows,
                masters: own.masters.clone(),
                guests: new.guests(&self.guests[own.guests.clone()], &slots),
                groups: Groups::new(&new.clusters[own.clusters.clone()]),
                read: Vec::new(),
                linked: new.linked(own.clusters.clone()),
            });
            let number = new.own.len() - 1;
            new.own[number].read = new.read_by_clusters(number, own.clusters.clone());
        }
        new
    }

    /// Deal out the points and reaches of a block.
    fn block<const DIM: usize>(
        &self,
        strands: &Strands,
        reaches: Range<usize>,
        slots: &[usize],
        to: &mut Explicit<DIM>,
    ) -> Block {
        for point in strands.points.clone() {
            let slot = slots[point];
            self.put(point, slot, to);
            to.nodes[slot] = self.nodes[point];
        }
        let copies = strands.copies().into_iter().map(|[copy, point]| {
            self.put(point, copy, to);
            to.home[copy] = slots[point];
            [copy, slots[point]].map(|slot| slot as u32)
        });
        let copies: Vec<[u32; 2]> = copies.collect();
        let (cuts, plan) = self.deal_reaches(reaches.clone(), strands, slots, &mut to.reaches);
        let leans = |number: &usize| to.reaches[*number].lean != 0.0;
        Block {
            rows: strands.rows(),
            copies,
            cuts,
            plan,
            leaning: reaches.clone().filter(leans).map(|k| k as u32).collect(),
            reaches,
            is_even: self.even_out(strands, &mut to.damped[strands.rows()]),
        }
    }

    /// Give all rows of a block the same damping, if all its points have that but for rounding.
    fn even_out(&self, strands: &Strands, rows: &mut [Damped]) -> bool {
        let is_even = |list: &[f64]| {
            let list = &list[strands.points.clone()];
            let largest = list.iter().fold(0.0_f64, |all, v| all.max(v.abs()));
            let apart = list.iter().map(|v| (v - list[0]).abs());
            apart.fold(0.0_f64, f64::max) <= ROUNDING * largest
        };
        let is_even = is_even(&self.damping) && is_even(&self.lag);
        if is_even {
            let first = strands.points.start;
            let [alpha, lag] = [self.damping[first], self.lag[first]].map(|v| each(|_| v));
            rows.fill(Damped { alpha, lag });
        }
        is_even
    }

    /// Reaches of a block in the order of their ends; what lies between strands, and what comes when.
    fn deal_reaches(
        &self,
        numbers: Range<usize>,
        strands: &Strands,
        slots: &[usize],
        to: &mut Vec<Reach>,
    ) -> (Vec<Cut>, Plan) {
        let (reaches, first) = (&self.reaches[numbers.clone()], numbers.start);
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
                lean: reaches[k].lean,
                is_row: false,
            });
        }
        let plan = Plan::new(&spans, strands.counts(), first, none);
        mark_rows(&mut to[first..plan.within]);
        (strands.cuts(reaches, &numbers), plan)
    }

    /// Everything but rows and what belongs to islands.
    fn empty<const DIM: usize>(&mut self, slots: &[usize], rows: usize) -> Explicit<DIM> {
        let numbers = LANES * rows;
        let of_masters = |k: usize| self.masters.iter().map(|m| m[k]).collect();
        let points = self.points.iter().map(|&point| slots[point]).collect();
        Explicit {
            h: self.h,
            per_step: 1.0 / self.h,
            nodes: vec![usize::MAX; numbers],
            points,
            home: (0..numbers).collect(),
            own: Vec::new(),
            common: vec![Common::default(); rows],
            damped: vec![Damped::default(); rows],
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
            forms: OnceLock::new(),
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
        to.damped[row].alpha[lane] = self.damping[point];
        to.damped[row].lag[lane] = self.lag[point];
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

    /// Copies among the points of some clusters of an island and the two on both sides of each.
    fn read_by_clusters(&self, island: usize, clusters: Range<usize>) -> Vec<[u32; 2]> {
        let members = self.clusters[clusters].iter().flat_map(|c| &c.members);
        let near = members.flat_map(|m| (0..5).map(|k| m.point + LANES * k - 2 * LANES));
        let near: BTreeSet<usize> = near.collect();
        let copies = self.own[island].blocks.iter().flat_map(|b| &b.copies);
        let read = copies.filter(|[copy, _]| near.contains(&(*copy as usize)));
        read.copied().collect()
    }

    /// Some ends of wires, with what they hang on.
    fn guests(&self, pairs: &[(usize, usize)], slots: &[usize]) -> Vec<Guest> {
        let of = |&(guest, owner): &(usize, usize)| Guest::new(self, slots[guest], slots[owner]);
        pairs.iter().map(of).collect()
    }
}

/// Find four reaches each of which all is beside each other.
fn mark_rows(reaches: &mut [Reach]) {
    let mut k = 0;
    while k + LANES <= reaches.len() {
        let four = &reaches[k..k + LANES];
        let first = four[0];
        let is_next = |(lane, reach): (usize, &Reach)| {
            let beside = |a: u32, b: u32| b as usize == a as usize + lane;
            let [masters, ends] = [(first.masters, reach.masters), (first.ends, reach.ends)];
            (0..2).all(|k| beside(masters.0[k], masters.1[k]) && beside(ends.0[k], ends.1[k]))
                && beside(first.before, reach.before)
        };
        let is_row = place(first.ends[0] as usize).1 == 0 && four.iter().enumerate().all(is_next);
        reaches[k].is_row = is_row;
        k += if is_row { LANES } else { 1 };
    }
}
