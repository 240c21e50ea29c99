//! Chain model under construction, as lists over points.

use crate::element::bar::BarState;
use crate::integrator::explicit::AxialPosition;
use crate::integrator::explicit::chain_model::parts::{AxialElementSpec, IslandRanges};
use crate::integrator::explicit::simd::stripes::Stripes;
use crate::integrator::explicit::stiff_groups::stiff_group::StiffGroup;
use crate::structure::Segment;
use std::ops::Range;

/// Number of unused points before the first and behind the last wire.
pub(in crate::integrator::explicit) const PAD: usize = 2;

/// Chain model, point by point. Segment j lies between points j and j + 1; its numbers are zero
/// between the last point of a wire and the first of the next. Outer lists have one entry for each
/// transverse direction.
pub(in crate::integrator::explicit) struct ChainBuilder {
    /// Time step h, s.
    pub h: f64,
    /// Node of each point; `usize::MAX` for unused ones.
    pub nodes: Vec<usize>,
    /// Point of each node.
    pub points: Vec<usize>,
    pub islands: Vec<IslandRanges>,
    /// Inverse mass h²/m of each point, s²/kg; zero where held, one for a tied end.
    pub inverse: Vec<Vec<f64>>,
    /// Mass-proportional damping α h of each point.
    pub damping: Vec<f64>,
    /// Stiffness-proportional damping β/h of each point.
    pub lag: Vec<f64>,
    /// Stiffness of a segment under tension, across, N/m.
    pub tension: Vec<Vec<f64>>,
    /// Inverse length 1/L of a segment, 1/m.
    pub per_length: Vec<f64>,
    /// Bending stiffness EI*/ℓ̄ of a point, N·m.
    pub bending: Vec<f64>,
    /// Slope tan φ of a segment.
    pub slope: Vec<Vec<f64>>,
    /// Filter weight q/h² of a segment, kg/s².
    pub filter: Vec<f64>,
    /// Second filter weight r/h² of a point, kg/s².
    pub second: Vec<f64>,
    pub axial_elements: Vec<AxialElementSpec>,
    pub axial_positions: Vec<AxialPosition>,
    /// Masters: inverse mass h²/m, s²/kg; α h; β/h.
    pub masters: Vec<[f64; 3]>,
    pub stiff_groups: Vec<StiffGroup>,
    /// Stiff group of each point, and the index of the point in it.
    pub in_stiff_group: Vec<Option<(usize, usize)>>,
    /// Tied ends of wires: tied point and the tie's master point.
    pub tied_ends: Vec<(usize, usize)>,
    /// Stripes of each block, and the packed index of each point.
    pub stripes: Vec<Stripes>,
    pub packed_indices: Vec<usize>,
}

impl ChainBuilder {
    /// Returns the points of wires, without the unused ones at both ends.
    pub fn points_of_wires(&self) -> Range<usize> {
        PAD..self.nodes.len() - PAD
    }
}

/// Returns the stiffnesses of a segment, N/m: axial A, geometric B, and along the track K = A cos²
/// φ + B sin² φ. With H given, the stiffness across is B (1 + (A − B) sin² φ/K), and tan φ is (A −
/// B) sin φ cos φ/K.
pub(in crate::integrator::explicit) fn segment_stiffness<const DIM: usize>(
    segment: &Segment,
    state: &BarState<DIM>,
) -> (f64, f64, f64) {
    let (axial, geometric) = (segment.stiffness(), state.linear_tension / state.length);
    let squared = state.direction[0] * state.direction[0];
    (
        axial,
        geometric,
        axial * squared + geometric * (1.0 - squared),
    )
}
