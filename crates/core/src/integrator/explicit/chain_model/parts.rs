//! Parts of a line of chains: wires, axial elements, and the ranges of an island.

use std::ops::Range;

/// Least number of nodes of a wire that is a block of its own.
const MIN_OWN_STRIPES: usize = 64;

/// Piece of wire between two masters, before packing.
pub(in crate::integrator::explicit) struct AxialElementSpec {
    pub masters: [usize; 2],
    /// Segments that it consists of.
    pub segments: Range<usize>,
    /// Axial stiffness k, N/m.
    pub stiffness: f64,
    /// Half the angle by which the track turns along it, rad.
    pub half_turn: f64,
}

/// Wire or node without wire, with the island it is in.
pub(in crate::integrator::explicit) struct WireRun {
    pub island: usize,
    pub segments: Vec<usize>,
    pub nodes: Vec<usize>,
    pub first: usize,
}

impl WireRun {
    pub fn is_long(&self) -> bool {
        self.nodes.len() >= MIN_OWN_STRIPES
    }

    pub fn points(&self) -> Range<usize> {
        self.first..self.first + self.nodes.len()
    }
}

/// Index ranges of one island.
pub(in crate::integrator::explicit) struct IslandRanges {
    /// Axial elements of each block.
    pub blocks: Vec<Range<usize>>,
    pub masters: Range<usize>,
    pub stiff_groups: Range<usize>,
    pub tied_ends: Range<usize>,
}
