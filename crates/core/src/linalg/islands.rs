//! Islands: ranges of nodes that are not coupled to any other node.
//!
//! A block diagonal matrix is as many systems side by side. Each island is eliminated alone, so
//! that the others are not needed when only one of them is solved for.

use super::symmetric::SymmetricBlocks;
use std::ops::Range;

/// Islands of a matrix whose nodes are numbered one island after the other, in that order. Islands
/// whose numbers overlap are taken as one.
#[must_use]
pub fn islands<const D: usize>(a: &SymmetricBlocks<D>) -> Vec<Range<usize>> {
    let n = a.rows();
    // Last node that each node is coupled to.
    let mut last: Vec<usize> = (0..n).collect();
    for i in 0..n {
        for &j in &a.columns[a.row_start[i]..a.row_start[i + 1]] {
            last[j] = last[j].max(i);
        }
    }
    let (mut islands, mut start, mut last_of_island) = (Vec::new(), 0, 0);
    for (i, &coupled) in last.iter().enumerate() {
        last_of_island = last_of_island.max(coupled);
        if last_of_island == i {
            islands.push(start..i + 1);
            start = i + 1;
        }
    }
    islands
}
