//! In what order rows are moved, reaches stretched, and forces found.
//!
//! Forces of a row need H of its reach, and that the motion of all its points. So forces follow the motion some
//! rows behind, as soon as the reaches there have ended: what a step touches is then still in the nearest cache.
//! Rows before the first reach of each strand wait for the end, because the strand before has its H.

use crate::integrator::explicit::simd::rows::{HALO, LANES};
use std::ops::Range;

/// Rows moved at a time. With those that forces are behind, 14 in a reach, they fill most of 32 KiB; each stage begins
/// its loops anew.
const STRIDE: usize = 40;

/// A reach as the order of things sees it: strand, and rows of its first and last point in their strands.
#[derive(Debug, Clone, Copy)]
pub(in crate::integrator::explicit) struct Span {
    pub strand: usize,
    pub rows: [usize; 2],
    pub is_over_cut: bool,
}

/// One after the other: move rows up to one, stretch reaches up to one, find forces up to a row.
#[derive(Debug, Clone, Copy)]
pub(in crate::integrator::explicit) struct Stage {
    pub moved: usize,
    pub stretched: usize,
    pub forced: usize,
}

/// Rows are counted in the island, reaches in all.
#[derive(Debug, Clone)]
pub(in crate::integrator::explicit) struct Plan {
    /// Own rows.
    pub rows: Range<usize>,
    pub stages: Vec<Stage>,
    /// The first reach over a cut.
    pub within: usize,
    /// The first row whose forces do not wait for the end, and the reach of each strand two rows before.
    pub first: usize,
    pub thrusts: [usize; LANES],
}

impl Plan {
    /// For spans in their order, the first of which has a number, and so many strands: points of all but the last
    /// one, and of the longest; `none` is the number of no reach.
    pub fn new(
        spans: &[Span],
        [strands, length, longest]: [usize; 3],
        number: usize,
        none: usize,
    ) -> Self {
        let rows = HALO..HALO + longest;
        let inside = spans.partition_point(|span| !span.is_over_cut);
        // A strand in which none begins has H of one before it all along, and waits.
        let begins = |strand: usize| {
            let of = spans.iter().filter(|span| span.strand == strand);
            of.map(|span| span.rows[0]).min().unwrap_or(rows.end)
        };
        let first = (0..strands).map(begins).max();
        let first = first.map_or(rows.end, |row| (row + 2).min(rows.end));
        let thrust = |strand: usize| {
            let is_in = |span: &Span| span.strand == strand && span.rows[0] + 2 <= first;
            let numbered = spans.iter().enumerate().filter(|(_, span)| is_in(span));
            let latest = numbered.max_by_key(|(_, span)| span.rows[0]);
            latest.map_or(none, |(k, _)| number + k)
        };
        let mut new = Self {
            stages: Vec::new(),
            within: number + inside,
            first,
            thrusts: std::array::from_fn(thrust),
            rows,
        };
        new.stage(spans, inside, number, length);
        new
    }

    fn stage(&mut self, spans: &[Span], inside: usize, number: usize, length: usize) {
        let mut moved = self.rows.start;
        while moved < self.rows.end {
            moved = (moved + STRIDE).min(self.rows.end);
            let stretched = spans[..inside].partition_point(|span| span.rows[1] < moved);
            let waits = spans[stretched..].iter().map(|span| span.rows[0]).min();
            // Rows that bend with points behind cuts need where those are.
            let forced = waits.unwrap_or(moved).min(moved - HALO).min(length);
            self.stages.push(Stage {
                moved,
                stretched: number + stretched,
                forced,
            });
        }
    }
}
