//! Division of a block into stripes: see [`packed`](crate::integrator::explicit::simd::packed).

use crate::integrator::explicit::Seam;
use crate::integrator::explicit::chain_model::parts::AxialElementSpec;
use crate::integrator::explicit::simd::packed::{HALO, SIMD_LANES, row_and_lane};
use crate::integrator::explicit::simd::plan::Span;
use std::ops::Range;

/// Largest deviation of a stripe's length from a quarter, relative.
const UNEVEN: f64 = 0.15;
/// Number of rows whose time is saved by four marked points in one row.
const ROWS: f64 = 4.0;

/// Position of the points of a block.
pub(in crate::integrator::explicit) struct Stripes {
    pub points: Range<usize>,
    /// First packed row of the block.
    first: usize,
    /// Number of points of a stripe; the last one has the rest.
    length: usize,
}

impl Stripes {
    /// Divides a block, from packed row `first` on. Among lengths near a quarter, chooses the one
    /// with most marked points in common rows of all stripes.
    pub fn new(points: Range<usize>, first: usize, is_marked: impl Fn(usize) -> bool) -> Self {
        let even = points.len().div_ceil(SIMD_LANES);
        let marked: Vec<bool> = points.clone().map(is_marked).collect();
        let marks: Vec<usize> = (0..marked.len()).filter(|&k| marked[k]).collect();
        let lined_up = |length: usize| {
            let all = length.min(marked.len().saturating_sub((SIMD_LANES - 1) * length));
            let first = marks.iter().take_while(|k| **k < all);
            let is_lined = |k: &&usize| (1..SIMD_LANES).all(|l| marked[**k + l * length]);
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

    /// Returns the packed rows, ghosts included.
    pub fn rows(&self) -> Range<usize> {
        let longest = longest(self.points.len(), self.length);
        self.first..self.first + longest + 2 * HALO
    }

    /// Returns the packed index of a point in its own stripe.
    pub fn packed_index(&self, point: usize) -> usize {
        let number = point - self.points.start;
        self.packed_index_in((number / self.length).min(SIMD_LANES - 1), point)
    }

    /// Returns the packed index of a point in a stripe, its own one or that of its ghost.
    fn packed_index_in(&self, stripe: usize, point: usize) -> usize {
        let row = self.first + HALO + point - self.points.start - stripe * self.length;
        SIMD_LANES * row + stripe
    }

    /// Returns the number of stripes with points; points of all but the last of them, and of the
    /// longest.
    pub fn counts(&self) -> [usize; 3] {
        let stripes = self.points.len().div_ceil(self.length).min(SIMD_LANES);
        let longest = longest(self.points.len(), self.length);
        [stripes, self.length, longest]
    }

    /// Returns the points of a stripe.
    fn stripe(&self, stripe: usize) -> Range<usize> {
        let end = self.points.end;
        let first = (self.points.start + stripe * self.length).min(end);
        let is_last = stripe + 1 == SIMD_LANES;
        first..if is_last {
            end
        } else {
            (first + self.length).min(end)
        }
    }

    /// Returns packed indices of ghosts, and the points that they copy.
    pub fn ghosts(&self) -> Vec<[usize; 2]> {
        let Range { start, end } = self.points;
        let ghosts = |stripe: usize| {
            let points = self.stripe(stripe);
            let (mut before, mut behind) = (0..0, 0..0);
            if !points.is_empty() {
                before = points.start.saturating_sub(HALO).max(start)..points.start;
                behind = points.end..(points.end + HALO).min(end);
            }
            let copy = move |point| [self.packed_index_in(stripe, point), point];
            before.chain(behind).map(copy)
        };
        (0..SIMD_LANES).flat_map(ghosts).collect()
    }

    /// Returns the position of an axial element in the stripes.
    pub fn span(&self, axial_element: &AxialElementSpec) -> Span {
        let Range { start, end } = axial_element.segments;
        let stripe = ((start - self.points.start) / self.length).min(SIMD_LANES - 1);
        let row = |point: usize| row_and_lane(self.packed_index_in(stripe, point)).0 - self.first;
        Span {
            stripe,
            rows: [row(start), row(end)],
            spans_seam: !self.stripe(stripe).contains(&end),
        }
    }

    /// Returns the order of axial elements by their ends, those that span seams last.
    pub fn order(&self, axial_elements: &[AxialElementSpec]) -> Vec<usize> {
        let mut order: Vec<usize> = (0..axial_elements.len()).collect();
        order.sort_by_key(|&k| {
            let span = self.span(&axial_elements[k]);
            (span.spans_seam, span.rows[1])
        });
        order
    }

    /// Returns the seams, for axial elements in their order along the wires; `new` holds their
    /// packed numbers.
    pub fn seams(&self, axial_elements: &[AxialElementSpec], new: &[usize]) -> Vec<Seam> {
        let firsts = (1..SIMD_LANES).map(|stripe| (stripe, self.stripe(stripe)));
        let firsts = firsts.filter(|(_, points)| !points.is_empty());
        let seam = |(stripe, points): (usize, Range<usize>)| {
            let behind = points.start;
            let first_behind = axial_elements.partition_point(|r| r.segments.start < behind);
            let is_over = |k: &usize| axial_elements[*k].segments.end >= behind;
            let is_next = |k: &usize| points.contains(&axial_elements[*k].segments.start);
            let last_before = first_behind.checked_sub(1);
            Seam {
                ghost_before: self.packed_index_in(stripe, behind - 1),
                ghost_behind: self.packed_index_in(stripe - 1, behind),
                last_before: last_before.map(|k| new[k]),
                spanning: last_before.filter(is_over).map(|k| new[k]),
                first_behind: Some(first_behind)
                    .filter(|k| *k < axial_elements.len())
                    .filter(is_next)
                    .map(|k| new[k]),
            }
        };
        firsts.map(seam).collect()
    }
}

/// Returns the number of points of the longest stripe.
fn longest(points: usize, length: usize) -> usize {
    length.max(points.saturating_sub((SIMD_LANES - 1) * length))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the stripes of a wire with `points` points, marked every `period` from `first` on.
    fn striped(points: usize, first: usize, period: usize) -> Stripes {
        let is_marked = |k: usize| k > 9 && k < points + 9 && (k - 10) % period == first;
        Stripes::new(10..10 + points, 0, is_marked)
    }

    /// A wire of 20 equal spans has one point more than 20 spans; the last stripe gets it.
    #[test]
    fn strands_of_a_regular_wire_begin_alike() {
        for (spans, period) in [(20, 31), (8, 17), (12, 40)] {
            let stripes = striped(spans * period + 1, 4, period);
            let [count, length, longest] = stripes.counts();
            assert_eq!([count, length], [SIMD_LANES, spans / 4 * period]);
            assert_eq!(longest, length + 1);
        }
    }

    /// 18 spans: five to a stripe are 11 % more rows, and all marks but those of the last stripe
    /// share rows.
    #[test]
    fn a_span_more_is_taken_where_marks_are_worth_it() {
        let [_, few, _] = striped(18 * 30 + 1, 4, 30).counts();
        let [_, many, _] = striped(18 * 30 + 1, 1, 3).counts();
        assert_eq!(few, 136, "one mark in thirty is not worth fifteen rows");
        assert_eq!(many % 3, 0, "one in three is");
    }

    #[test]
    fn every_point_has_a_slot_of_its_own() {
        for points in [1, 2, 3, 5, 64, 67, 621] {
            let stripes = striped(points, 1, 7);
            let mut packed_indices: Vec<usize> =
                (10..10 + points).map(|k| stripes.packed_index(k)).collect();
            let ghosts = stripes.ghosts().into_iter().map(|[copy, _]| copy);
            packed_indices.extend(ghosts);
            let count = packed_indices.len();
            packed_indices.sort_unstable();
            packed_indices.dedup();
            assert_eq!(packed_indices.len(), count, "{points} points");
            assert!(packed_indices[count - 1] < SIMD_LANES * stripes.rows().end);
        }
    }
}
