//! Plan of a sweep: the order in which rows are moved, and axial and wire forces found.
//!
//! Forces of a row need H of its axial element, and that the motion of all its points. So forces
//! follow the motion some rows behind, as soon as the axial elements there have ended: the data of
//! a step are then still in the nearest cache. Rows before the first axial element of each stripe
//! wait for the end, because H there belongs to the preceding stripe.

use crate::integrator::explicit::simd::packed::{HALO, SIMD_LANES};
use std::ops::Range;

/// Rows moved at a time. With the 14 rows of an axial element by which forces lag behind, they fill
/// most of 32 KiB; each stage restarts its loops.
const STRIDE: usize = 40;

/// Axial element in its block: stripe, and rows of its first and last point in the stripe.
#[derive(Debug, Clone, Copy)]
pub(in crate::integrator::explicit) struct Span {
    pub stripe: usize,
    pub rows: [usize; 2],
    pub spans_seam: bool,
}

/// Stage of a sweep: limits up to which rows are moved, axial forces found, and wire forces found.
#[derive(Debug, Clone, Copy)]
pub(in crate::integrator::explicit) struct Stage {
    pub moved: usize,
    pub stretched: usize,
    pub forced: usize,
}

/// Plan of a sweep over a block. Rows are counted in the block, axial elements in the model.
#[derive(Debug, Clone)]
pub(in crate::integrator::explicit) struct Plan {
    /// Rows of points, without ghosts.
    pub rows: Range<usize>,
    pub stages: Vec<Stage>,
    /// First axial element that spans a seam.
    pub within: usize,
    /// First row whose forces do not wait for the end, and the axial element of each stripe two
    /// rows before.
    pub first: usize,
    pub axial_forces: [usize; SIMD_LANES],
}

impl Plan {
    /// Plans the sweep for spans in their order; `number` is the number of the first, `none` stands
    /// for no axial element. `strands, length, longest`: stripes, points of all but the last one,
    /// and of the longest.
    pub fn new(
        spans: &[Span],
        [stripes, length, longest]: [usize; 3],
        number: usize,
        none: usize,
    ) -> Self {
        let rows = HALO..HALO + longest;
        let inside = spans.partition_point(|span| !span.spans_seam);
        // A stripe in which none begins has H of a preceding stripe everywhere, and waits.
        let begins = |stripe: usize| {
            let own_spans = spans.iter().filter(|span| span.stripe == stripe);
            own_spans.map(|span| span.rows[0]).min().unwrap_or(rows.end)
        };
        let first = (0..stripes).map(begins).max();
        let first = first.map_or(rows.end, |row| (row + 2).min(rows.end));
        let axial_force = |stripe: usize| {
            let is_in = |span: &Span| span.stripe == stripe && span.rows[0] + 2 <= first;
            let numbered = spans.iter().enumerate().filter(|(_, span)| is_in(span));
            let latest = numbered.max_by_key(|(_, span)| span.rows[0]);
            latest.map_or(none, |(k, _)| number + k)
        };
        let mut new = Self {
            stages: Vec::new(),
            within: number + inside,
            first,
            axial_forces: std::array::from_fn(axial_force),
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
            // Rows that bend with points behind seams need the positions of those.
            let forced = waits.unwrap_or(moved).min(moved - HALO).min(length);
            self.stages.push(Stage {
                moved,
                stretched: number + stretched,
                forced,
            });
        }
    }
}
