//! How a block is cut into strands: see [`rows`](crate::integrator::explicit::simd::rows).

use crate::integrator::explicit::Cut;
use crate::integrator::explicit::chain_model::along;
use crate::integrator::explicit::simd::plan::Span;
use crate::integrator::explicit::simd::rows::{HALO, LANES, place};
use std::ops::Range;

/// How far a strand may be longer or shorter than a quarter, as a share.
const UNEVEN: f64 = 0.15;
/// Rows that take as long as is saved where four marked points lie in one.
const ROWS: f64 = 4.0;

/// Where the points of a block lie.
pub(in crate::integrator::explicit) struct Strands {
    pub points: Range<usize>,
    /// Its first row.
    first: usize,
    /// Points of a strand; the last one has what is left.
    length: usize,
}

impl Strands {
    /// From a row on. Of lengths near to a quarter of all that is taken which has most of some marked points in
    /// the same rows of all strands.
    pub fn new(points: Range<usize>, first: usize, is_marked: impl Fn(usize) -> bool) -> Self {
        let even = points.len().div_ceil(LANES);
        let marked: Vec<bool> = points.clone().map(is_marked).collect();
        let marks: Vec<usize> = (0..marked.len()).filter(|&k| marked[k]).collect();
        let lined_up = |length: usize| {
            let all = length.min(marked.len().saturating_sub((LANES - 1) * length));
            let first = marks.iter().take_while(|k| **k < all);
            let is_lined = |k: &&usize| (1..LANES).all(|l| marked[**k + l * length]);
            first.filter(is_lined).count()
        };
        let worth = |length: usize| {
            let rows = longest(points.len(), length) as f64;
            ROWS * lined_up(length) as f64 - rows
        };
        let uneven = (UNEVEN * even as f64) as usize;
        let near = even - uneven..=even + uneven;
        let best = near.max_by(|a, b| worth(*a).total_cmp(&worth(*b)));
        Self {
            points,
            first,
            length: best.unwrap_or(even),
        }
    }

    /// Rows, those of copies included.
    pub fn rows(&self) -> Range<usize> {
        let longest = longest(self.points.len(), self.length);
        self.first..self.first + longest + 2 * HALO
    }

    /// Slot of a point in its own strand.
    pub fn slot(&self, point: usize) -> usize {
        let number = point - self.points.start;
        self.slot_in((number / self.length).min(LANES - 1), point)
    }

    /// Slot of a point as a strand has it, of its own or as a copy.
    fn slot_in(&self, strand: usize, point: usize) -> usize {
        let row = self.first + HALO + point - self.points.start - strand * self.length;
        LANES * row + strand
    }

    /// Strands with points; points of all but the last of them, and of the longest.
    pub fn counts(&self) -> [usize; 3] {
        let strands = self.points.len().div_ceil(self.length).min(LANES);
        let longest = longest(self.points.len(), self.length);
        [strands, self.length, longest]
    }

    /// Points of a strand.
    fn strand(&self, strand: usize) -> Range<usize> {
        let end = self.points.end;
        let first = (self.points.start + strand * self.length).min(end);
        let is_last = strand + 1 == LANES;
        first..if is_last {
            end
        } else {
            (first + self.length).min(end)
        }
    }

    /// Slots of copies, and the points that they are copies of.
    pub fn copies(&self) -> Vec<[usize; 2]> {
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
    pub fn span(&self, reach: &along::Reach) -> Span {
        let Range { start, end } = reach.segments;
        let strand = ((start - self.points.start) / self.length).min(LANES - 1);
        let row = |point: usize| place(self.slot_in(strand, point)).0 - self.first;
        Span {
            strand,
            rows: [row(start), row(end)],
            is_over_cut: !self.strand(strand).contains(&end),
        }
    }

    /// Reaches as they end, those over cuts last.
    pub fn order(&self, reaches: &[along::Reach]) -> Vec<usize> {
        let mut order: Vec<usize> = (0..reaches.len()).collect();
        order.sort_by_key(|&k| {
            let span = self.span(&reaches[k]);
            (span.is_over_cut, span.rows[1])
        });
        order
    }

    /// Places between two strands, for reaches in their order along the wires; `new` says which numbers they get.
    pub fn cuts(&self, reaches: &[along::Reach], new: &[usize]) -> Vec<Cut> {
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

/// Points of the longest of all strands.
fn longest(points: usize, length: usize) -> usize {
    length.max(points.saturating_sub((LANES - 1) * length))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Strands of a wire of some points, with marks every `period` from `first` on.
    fn cut(points: usize, first: usize, period: usize) -> Strands {
        let is_marked = |k: usize| k > 9 && k < points + 9 && (k - 10) % period == first;
        Strands::new(10..10 + points, 0, is_marked)
    }

    /// A wire of 20 equal spans has a point more than 20 times those of a span: the last strand gets it.
    #[test]
    fn strands_of_a_regular_wire_begin_alike() {
        for (spans, period) in [(20, 31), (8, 17), (12, 40)] {
            let strands = cut(spans * period + 1, 4, period);
            let [count, length, longest] = strands.counts();
            assert_eq!([count, length], [LANES, spans / 4 * period]);
            assert_eq!(longest, length + 1);
        }
    }

    /// 18 spans: five to a strand are 11 % more rows, and all but the last strand's marks lie in rows.
    #[test]
    fn a_span_more_is_taken_where_marks_are_worth_it() {
        let [_, few, _] = cut(18 * 30 + 1, 4, 30).counts();
        let [_, many, _] = cut(18 * 30 + 1, 1, 3).counts();
        assert_eq!(few, 136, "one mark in thirty is not worth fifteen rows");
        assert_eq!(many % 3, 0, "one in three is");
    }

    #[test]
    fn every_point_has_a_slot_of_its_own() {
        for points in [1, 2, 3, 5, 64, 67, 621] {
            let strands = cut(points, 1, 7);
            let mut slots: Vec<usize> = (10..10 + points).map(|k| strands.slot(k)).collect();
            let copies = strands.copies().into_iter().map(|[copy, _]| copy);
            slots.extend(copies);
            let count = slots.len();
            slots.sort_unstable();
            slots.dedup();
            assert_eq!(slots.len(), count, "{points} points");
            assert!(slots[count - 1] < LANES * strands.rows().end);
        }
    }
}
