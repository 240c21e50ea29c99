//! Correction of the period error of the time-stepping scheme, for waves that tension carries.
//!
//! A scheme of second order slows an oscillator of frequency ω by the share c (ωh)². With
//!
//!   M* = M − 2 c h² K_T,    K_T = T ∫ N′N′ᵀ ds
//!
//! instead of M, a wave that tension alone carries has K = K_T, so its frequency becomes ω² / (1 −
//! 2 c h² ω²): too fast by the same share, and the leading errors cancel. The remainder is
//! O((ωh)⁴). Bending, links and axial waves keep their error.
//!
//! A mass matrix with a share of the stiffness is a known device (Fox & Goodwin's method for u″ =
//! −ω²u, Proc. Camb. Phil. Soc. 45 (1949) 373; Krenk, Comput. Methods Appl. Mech. Eng. 191 (2001)
//! 975 with elements).
//!
//! M* must stay positive. For any motion of an element N, with ℓ its length and μ its mass per
//! metre,
//!
//!   T ∫ (N′e)² ds  ≤  (90 + √6420) T/(μ ℓ²) · μ ∫ (N e)² ds
//!
//! The factor is the largest eigenvalue of the two matrices: 60 with even shapes; κ² − 180 κ + 1680
//! = 0 with odd ones. Where more than [`MAX_MASS_SHARE`] of the mass of a motion would be taken,
//! the correction of the element is made smaller so that it is just that share: continuous in h and
//! ℓ.

use crate::element::hermite;
use crate::linear::model::LinearModel;
use crate::scheme::Scheme;
use crate::statics::assembly::Geometry;

/// Largest share of its mass that any motion of an element may lose, no unit. A larger one leaves
/// nearly massless motions of short elements, which is stable but stiff; a smaller one leaves a
/// period error in elements that need not have it (below 0.8 m at 1 ms).
const MAX_MASS_SHARE: f64 = 0.75;

impl<const DIM: usize, const D: usize> LinearModel<DIM, D> {
    /// Subtracts 2 c h² K_T from the mass of cubic elements, for steps of `h` seconds. The model
    /// stays as it is with schemes of first order and with chains of point masses.
    #[must_use]
    pub fn with_correct_period(
        mut self,
        geometry: &Geometry<DIM, D>,
        scheme: &Scheme,
        h: f64,
    ) -> Self {
        let Some(error) = scheme.period_error() else {
            return self;
        };
        let bound = 90.0 + 6420.0_f64.sqrt();
        for wire in &geometry.structure.wires {
            let l = wire.section.rest_length;
            let e = Geometry::<DIM, D>::frame_coordinates(&self.shape, wire);
            let tension = hermite::tension(&wire.section, &e, 0.5).max(0.0);
            let mass_to_remove = 2.0 * error * h * h * tension;
            let max_removed = MAX_MASS_SHARE * wire.mass * l * l / bound;
            let removed = mass_to_remove.min(max_removed);
            self.mass
                .add_hermite_slopes(wire.coordinate_slots(), l, -removed);
        }
        self.mass.pack();
        self
    }
}
