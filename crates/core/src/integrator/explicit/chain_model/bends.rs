//! Bends of a chain with the bending stiffness EI* fitted to the wire: [`Geometry::bending`].

use crate::statics::assembly::{Geometry, Shape};
use crate::structure::Bend;

/// Largest ε, which stands for no tension.
const LARGEST: f64 = 1e6;

/// Bend with fitted stiffness.
pub(in crate::integrator::explicit) struct FittedBend {
    /// Fitted bending stiffness EI* = EI x coth x, N·m².
    pub bending: f64,
    /// Added length squared (EI* − EI)/T, m²: at most ℓ̄²/12, its limit without tension. EI* has
    /// the tension of the design, so it would grow without bound for a wire that lost its tension.
    pub added: f64,
    /// Mean length ℓ̄ of both segments, m.
    pub length: f64,
    /// Ratio ε = EI/(T ℓ̄²).
    pub ratio: f64,
}

impl FittedBend {
    pub fn new<const DIM: usize, const D: usize>(
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        bend: &Bend,
    ) -> Self {
        let segments = bend.segments.map(|k| &geometry.structure.segments[k]);
        let tension =
            |k: usize| Geometry::<DIM, D>::segment_state(shape, segments[k]).linear_tension;
        let tension = (0.5 * (tension(0) + tension(1))).max(0.0);
        let length = 0.5 * (segments[0].rest_length + segments[1].rest_length);
        let bending = geometry.bending(bend);
        let over_tension = |stiffness: f64| {
            if stiffness > 0.0 {
                stiffness / tension
            } else {
                0.0
            }
        };
        Self {
            bending,
            added: over_tension(bending - bend.stiffness).min(length * length / 12.0),
            length,
            ratio: (over_tension(bend.stiffness) / (length * length)).min(LARGEST),
        }
    }
}
