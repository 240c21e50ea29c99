//! What of an island is cut into strands together.
//!
//! A long wire by itself: cut at equal parts of a regular line, its links then lie in the same rows of all strands.

use crate::error::CoreError;
use crate::integrator::explicit::chain_model::layout::Chains;
use crate::integrator::explicit::refuse;
use crate::integrator::explicit::simd::strands::Strands;
use std::ops::Range;

/// Nodes of a wire that is cut into strands by itself.
const LONG: usize = 64;

/// A wire, or a node of none, with the island it is in.
pub(in crate::integrator::explicit) struct Run {
    pub island: usize,
    pub segments: Vec<usize>,
    pub nodes: Vec<usize>,
    pub first: usize,
}

impl Run {
    pub fn is_long(&self) -> bool {
        self.nodes.len() >= LONG
    }

    fn points(&self) -> Range<usize> {
        self.first..self.first + self.nodes.len()
    }
}

/// Points that are cut into strands together: those of a long wire, or of all short ones.
fn blocks<'a>(runs: impl Iterator<Item = &'a Run>) -> Vec<Range<usize>> {
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

/// What belongs to one island.
pub(in crate::integrator::explicit) struct Ranges {
    /// Reaches of each block.
    pub blocks: Vec<Range<usize>>,
    pub masters: Range<usize>,
    pub clusters: Range<usize>,
    pub guests: Range<usize>,
}

impl Chains {
    /// Cut all blocks into strands, and place their points.
    pub(in crate::integrator::explicit) fn cut(&mut self, runs: &[Run], islands: usize) {
        for island in 0..islands {
            for points in blocks(runs.iter().filter(|run| run.island == island)) {
                let first = self.strands.last().map_or(0, |s| s.rows().end);
                let is_linked = |point: usize| self.in_cluster[point].is_some();
                let strands = Strands::new(points.clone(), first, is_linked);
                points.for_each(|point| self.slots[point] = strands.slot(point));
                self.strands.push(strands);
            }
        }
    }

    /// How a wire is cut that is cut by itself.
    pub(in crate::integrator::explicit) fn strands_of(&self, run: &Run) -> Option<&Strands> {
        let own = self.strands.iter().find(|s| s.points == run.points());
        own.filter(|_| run.is_long())
    }

    /// What belongs to the island of some runs, which is cut, and whose masters and reaches are the last ones, from
    /// a number on.
    pub(in crate::integrator::explicit) fn ranges<'a>(
        &self,
        runs: impl Iterator<Item = &'a Run>,
        [masters, mut reaches]: [usize; 2],
    ) -> Result<Ranges, CoreError> {
        let of_runs = runs.map(Run::points);
        let Some(points) = of_runs.reduce(|all, own| all.start..own.end) else {
            return Err(refuse("an island without points"));
        };
        let blocks = self.strands.iter().map(|strands| &strands.points);
        let own = blocks.filter(|block| points.contains(&block.start));
        let of_blocks = own.map(|block| {
            let begin = reaches;
            let own = self.reaches[begin..].iter();
            reaches += own.take_while(|r| r.segments.start < block.end).count();
            begin..reaches
        });
        Ok(Ranges {
            blocks: of_blocks.collect(),
            masters: masters..self.masters.len(),
            clusters: within(self.clusters.iter().map(|c| c.members[0].point), &points),
            guests: within(self.guests.iter().map(|g| g.0), &points),
        })
    }
}

/// Numbers of those, one behind the other, that are in a range.
fn within(of: impl Iterator<Item = usize>, range: &Range<usize>) -> Range<usize> {
    let inside = of.enumerate().filter(|(_, point)| range.contains(point));
    let mut numbers = inside.map(|(number, _)| number);
    let first = numbers.next();
    first.map_or(0..0, |first| first..first + 1 + numbers.count())
}
