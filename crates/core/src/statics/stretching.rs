//! Axial part of the tangents: the stiffness against stretching alone.
//!
//!   cubic elements   EA ∫ (r′·δr′)(r′·δr′) ds          of  ∫ EA (r′·δr′)² + EA ε δr′·δr′ ds
//!   segments         (EA/L − T/ℓ) n nᵀ                 of  (EA/L − T/ℓ) n nᵀ + (T/ℓ) 1
//!
//! Where all motion is across the track and the tension stays that at rest, this part is left out.
//! The second parts are, for a motion w across, H ∫ (∂w/∂x)² dx with the horizontal force H: those
//! of a string.

use super::assembly::{Geometry, Shape};
use crate::element::tangent;
use crate::linalg::SymmetricBlocks;
use crate::structure::{Segment, Wire};

impl<const DIM: usize, const D: usize> Geometry<DIM, D> {
    /// Adds the axial part of the tangent of one wire element, times `factor`.
    pub fn add_wire_stretching(
        k: &mut SymmetricBlocks<D>,
        shape: &Shape<D>,
        wire: &Wire,
        factor: f64,
    ) {
        let part = tangent::stretching(&wire.section, &Self::frame_coordinates(shape, wire));
        Self::add_element(k, wire, &part, factor);
    }

    /// Adds the axial part of the tangent of one segment, times `factor`.
    pub fn add_segment_stretching(
        k: &mut SymmetricBlocks<D>,
        shape: &Shape<D>,
        segment: &Segment,
        factor: f64,
    ) {
        let state = Self::segment_state(shape, segment);
        let geometric = state.linear_tension / state.length;
        let along = factor * (segment.stiffness() - geometric);
        let n = &state.direction;
        let part = n.map(|p| n.map(|q| along * p * q));
        Self::add_segment_matrix(k, segment, &part);
    }
}
