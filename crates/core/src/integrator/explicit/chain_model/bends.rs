//! Bends of a chain beside those of its wire: [`Geometry::bending`].

use crate::statics::assembly::{Geometry, Shape};
use crate::structure::Bend;

/// Largest ε: as good as no tension.
const LARGEST: f64 = 1e6;

/// What stands in the place of a bend.
pub(in crate::integrator::explicit) struct Fit {
    /// EI*, N·m².
    pub bending: f64,
    /// (EI* − EI)/T, m²: at most ℓ̄²/12, which it tends to without tension. EI* has the tension of the design,
    /// so a wire that has lost it would have more than all numbers.
    pub longer: f64,
    /// ℓ̄, m.
    pub length: f64,
    /// ε = EI/(T ℓ̄²).
    pub share: f64,
}

impl Fit {
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
        let over = |stiffness: f64| {
            if stiffness > 0.0 {
                stiffness / tension
            } else {
                0.0
            }
        };
        Self {
            bending,
            longer: over(bending - bend.stiffness).min(length * length / 12.0),
            length,
            share: (over(bend.stiffness) / (length * length)).min(LARGEST),
        }
    }
}
