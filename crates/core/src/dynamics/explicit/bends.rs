//! Bends of a chain whose points yield under forces on them as those of the wire do: see the
//! [theory](super).

use crate::dynamics::line::Line;
use crate::statics::assembly::{Geometry, Shape};
use crate::structure::Bend;

/// Below this x coth x is 1 + x²/3, and that 1, to rounding.
const SMALL: f64 = 1e-6;

/// Largest ε: as good as no tension.
const LARGEST: f64 = 1e6;

/// What stands in the place of a bend.
pub(super) struct Fit {
    /// EI of the wire, and EI x coth x, N·m².
    of_wire: f64,
    pub bending: f64,
    /// Their difference over T, m², also without tension.
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
        let tension = |k: usize| {
            let state = Geometry::<DIM, D>::segment_state(shape, segments[k]);
            state.linear_tension.max(0.0)
        };
        let tension = 0.5 * (tension(0) + tension(1));
        let length = 0.5 * (segments[0].rest_length + segments[1].rest_length);
        let squared = 0.25 * length * length;
        let x = (squared * tension / bend.stiffness).sqrt();
        let (bending, longer) = if bend.stiffness <= 0.0 {
            (bend.stiffness, 0.0)
        } else if x > SMALL {
            let more = x / x.tanh() - 1.0;
            (bend.stiffness * (1.0 + more), squared * more / (x * x))
        } else {
            (bend.stiffness, squared / 3.0)
        };
        Self {
            share: (0.25 / (x * x)).min(LARGEST),
            of_wire: bend.stiffness,
            bending,
            longer,
            length,
        }
    }
}

impl<const DIM: usize, const D: usize> Line<DIM, D> {
    /// Let the stiffness be that of explicit steps: what stands at rest under forces is then found with it.
    pub(in crate::dynamics) fn fit_bends(&mut self, geometry: &Geometry<DIM, D>) {
        for bend in &geometry.structure.bends {
            let fit = Fit::new(geometry, &self.shape, bend);
            let more = Bend {
                stiffness: fit.bending - fit.of_wire,
                ..*bend
            };
            geometry.add_bend(&mut self.stiffness, &more, 1.0);
        }
        self.stiffness.keep_free(&self.free);
    }
}
