//! Islands: runs of nodes that nothing couples to any other node.
//!
//! A matrix that falls apart into blocks is as many systems side by side. Each island is eliminated by
//! itself, so that the others need not be touched when only one of them is solved for.

use super::symmetric::SymmetricBlocks;
use std::ops::Range;

/// The islands of a matrix whose nodes are numbered one island after the other, in that order. Islands
/// whose numbers lie among one another are taken as one.
#[must_use]
pub fn islands<const D: usize>(a: &SymmetricBlocks<D>) -> Vec<Range<usize>> {
    let n = a.rows();
    // The last node that each node, or any before it, is coupled to.
    let mut last: Vec<usize> = (0..n).collect();
    for i in 0..n {
        for &j in &a.columns[a.row_start[i]..a.row_start[i + 1]] {
            last[j] = last[j].max(i);
        }
    }
    let (mut found, mut start, mut reach) = (Vec::new(), 0, 0);
    for (i, &own) in last.iter().enumerate() {
        reach = reach.max(own);
        if reach == i {
            found.push(start..i + 1);
            start = i + 1;
        }
    }
    found
}
