//! Islands of a line: wires side by side or one behind the other, which nothing couples.

use crate::linalg::islands::islands;
use crate::linalg::{Block, SymmetricBlocks};
use std::ops::Range;

/// Index ranges of an island in the lists of a line.
#[derive(Debug, Clone)]
pub struct Island {
    /// Nodes.
    pub nodes: Range<usize>,
    /// Links.
    pub links: Range<usize>,
    /// Blocks of C − α M − β K.
    pub damping: Range<usize>,
    /// Fixed components.
    pub fixed: Range<usize>,
    /// Largest coordinate along the track, m.
    pub(crate) end: f64,
}

/// Lists of a line that are divided among its islands.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lists<'a, const D: usize> {
    pub stiffness: &'a SymmetricBlocks<D>,
    /// First node of each link.
    pub links: &'a [usize],
    /// Blocks of C − α M − β K, by rows.
    pub damping: &'a [(usize, usize, Block<D>)],
    /// Fixed components: node, component; by nodes.
    pub fixed: &'a [(u32, u32)],
    /// Positions of the nodes, along the track first, m.
    pub shape: &'a [[f64; D]],
}

impl Island {
    /// Finds the islands of a line, in the order of their nodes. A line whose links are not listed
    /// island by island counts as one island.
    pub(crate) fn all<const D: usize>(line: &Lists<'_, D>) -> Vec<Self> {
        let nodes = islands(line.stiffness);
        let ends = nodes.iter().map(|nodes| nodes.end).collect::<Vec<_>>();
        let number = |node: usize| ends.partition_point(|&end| end <= node);
        let link_islands: Vec<usize> = line.links.iter().map(|&node| number(node)).collect();
        if !link_islands.is_sorted() {
            return vec![Self {
                nodes: 0..line.shape.len(),
                links: 0..line.links.len(),
                damping: 0..line.damping.len(),
                fixed: 0..line.fixed.len(),
                end: end(line.shape),
            }];
        }
        let island = |(number, nodes): (usize, Range<usize>)| {
            let link = |number: usize| link_islands.partition_point(|&k| k < number);
            let damping_block = |node: usize| line.damping.partition_point(|b| b.0 < node);
            let fixed = |node: usize| line.fixed.partition_point(|f| (f.0 as usize) < node);
            Self {
                links: link(number)..link(number + 1),
                damping: damping_block(nodes.start)..damping_block(nodes.end),
                fixed: fixed(nodes.start)..fixed(nodes.end),
                end: end(&line.shape[nodes.clone()]),
                nodes,
            }
        };
        nodes.into_iter().enumerate().map(island).collect()
    }
}

/// Returns the largest coordinate along the track of the nodes, m.
fn end<const D: usize>(shape: &[[f64; D]]) -> f64 {
    let along = shape.iter().map(|r| r[0]);
    along.fold(f64::NEG_INFINITY, f64::max)
}
