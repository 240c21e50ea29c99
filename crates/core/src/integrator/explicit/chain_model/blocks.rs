//! Blocks: the points of an island that are striped together.
//!
//! A long wire is a block of its own: striped at equal parts of a regular line, its links lie in
//! the same packed rows of all stripes.

use crate::error::CoreError;
use crate::integrator::explicit::chain_model::builder::ChainBuilder;
use crate::integrator::explicit::chain_model::parts::{IslandRanges, WireRun};
use crate::integrator::explicit::refuse;
use crate::integrator::explicit::simd::stripes::Stripes;
use std::ops::Range;

/// Returns the ranges of points that are striped together: those of a long wire, or of consecutive
/// short ones.
fn blocks<'a>(runs: impl Iterator<Item = &'a WireRun>) -> Vec<Range<usize>> {
    let mut all: Vec<Range<usize>> = Vec::new();
    let mut is_open = false;
    for run in runs {
        match all.last_mut().filter(|_| is_open) {
            Some(last) => last.end = run.points().end,
            None => all.push(run.points()),
        }
        is_open = !run.is_long();
    }
    all
}

impl ChainBuilder {
    /// Stripes all blocks, and sets the packed index of their points.
    pub(in crate::integrator::explicit) fn stripe_blocks(
        &mut self,
        runs: &[WireRun],
        islands: usize,
    ) {
        for island in 0..islands {
            for points in blocks(runs.iter().filter(|run| run.island == island)) {
                let first = self.stripes.last().map_or(0, |s| s.rows().end);
                let is_stiff = |point: usize| self.in_stiff_group[point].is_some();
                let stripes = Stripes::new(points.clone(), first, is_stiff);
                points.for_each(|point| self.packed_indices[point] = stripes.packed_index(point));
                self.stripes.push(stripes);
            }
        }
    }

    /// Returns the stripes of a long wire; `None` for wires that share a block.
    pub(in crate::integrator::explicit) fn stripes_of(&self, run: &WireRun) -> Option<&Stripes> {
        let stripes = self.stripes.iter().find(|s| s.points == run.points());
        stripes.filter(|_| run.is_long())
    }

    /// Returns the index ranges (blocks, masters, stiff groups, tied ends) of the island of `runs`,
    /// which was just added. `masters`, `axial_elements`: first index it owns.
    pub(in crate::integrator::explicit) fn ranges<'a>(
        &self,
        runs: impl Iterator<Item = &'a WireRun>,
        [masters, mut axial_elements]: [usize; 2],
    ) -> Result<IslandRanges, CoreError> {
        let of_runs = runs.map(WireRun::points);
        let Some(points) = of_runs.reduce(|first, last| first.start..last.end) else {
            return Err(refuse("an island without points"));
        };
        let blocks = self.stripes.iter().map(|stripes| &stripes.points);
        let own_blocks = blocks.filter(|block| points.contains(&block.start));
        let of_blocks = own_blocks.map(|block| {
            let begin = axial_elements;
            let following = self.axial_elements[begin..].iter();
            axial_elements += following
                .take_while(|r| r.segments.start < block.end)
                .count();
            begin..axial_elements
        });
        Ok(IslandRanges {
            blocks: of_blocks.collect(),
            masters: masters..self.masters.len(),
            stiff_groups: indices_within(
                self.stiff_groups.iter().map(|c| c.members[0].point),
                &points,
            ),
            tied_ends: indices_within(self.tied_ends.iter().map(|g| g.0), &points),
        })
    }
}

/// Returns the range of indices of the points that lie in `range`; they are consecutive.
fn indices_within(points: impl Iterator<Item = usize>, range: &Range<usize>) -> Range<usize> {
    let inside = points
        .enumerate()
        .filter(|(_, point)| range.contains(point));
    let mut numbers = inside.map(|(number, _)| number);
    let first = numbers.next();
    first.map_or(0..0, |first| first..first + 1 + numbers.count())
}
