//! Points packed into SIMD vectors, in stripes.
//!
//! A long wire is divided into as many stripes as there are SIMD lanes, equally long except the
//! last; so are all short wires of an island in a row. Points of the same number in their stripes
//! share a packed row, so the neighbours of a row are the rows before and behind, and the
//! quantities that a step carries from point to point stay in registers. Ghosts of the points
//! beyond a seam stand before and behind each stripe. A regular wire is divided where it repeats
//! itself: then four links, or four axial elements, fill rows as well.
//!
//! The packed index of a point is [`SIMD_LANES`] × row + lane; its neighbours are [`SIMD_LANES`]
//! apart.

/// Number of SIMD lanes, and of stripes of a block.
pub(in crate::integrator::explicit) const SIMD_LANES: usize = 4;
/// Rows of ghosts at each end of a stripe: bending couples points two apart.
pub(in crate::integrator::explicit) const HALO: usize = 2;

/// SIMD vector with one number for each lane, aligned so that it never crosses a cache line.
#[derive(Debug, Clone, Copy, Default)]
#[repr(align(32))]
pub struct SimdVector(pub [f64; SIMD_LANES]);

impl std::ops::Deref for SimdVector {
    type Target = [f64; SIMD_LANES];

    #[inline(always)]
    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

impl std::ops::DerefMut for SimdVector {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut Self::Target {
        &mut self.0
    }
}

/// Returns a vector with the value of a function for each SIMD lane.
#[inline(always)]
pub(in crate::integrator::explicit) fn per_lane(of: impl Fn(usize) -> f64) -> SimdVector {
    SimdVector(simd_array(of))
}

/// Returns an array with the value of a function for each SIMD lane. Written as a loop: array
/// functions of the library may not be compiled for wide vectors.
#[inline(always)]
pub(in crate::integrator::explicit) fn simd_array<const L: usize>(
    of: impl Fn(usize) -> f64,
) -> [f64; L] {
    let mut all = [0.0; L];
    for l in 0..L {
        all[l] = of(l);
    }
    all
}

/// Coefficients that all transverse directions share. Segments have the row of their first point.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::integrator::explicit) struct SharedCoefficients {
    /// Filter weight q/h² of the segment, kg/s².
    pub filter: SimdVector,
    /// Second filter weight r/h² of the point, kg/s².
    pub second: SimdVector,
    /// Inverse length 1/L of the segment, 1/m.
    pub per_length: SimdVector,
    /// Bending stiffness EI*/ℓ̄ of the point, N·m; see
    /// [`bends`](crate::integrator::explicit::chain_model::bends).
    pub bending: SimdVector,
}

/// Damping of a point. In a block of uniform damping one row is read for all.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::integrator::explicit) struct DampingCoefficients {
    /// Mass-proportional damping α h.
    pub alpha: SimdVector,
    /// Stiffness-proportional damping β/h.
    pub lag: SimdVector,
}

/// Coefficients of one transverse direction.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::integrator::explicit) struct TransverseCoefficients {
    /// Inverse mass h²/m of the point, s²/kg.
    pub inverse: SimdVector,
    /// Stiffness of the segment under tension, N/m.
    pub tension: SimdVector,
    /// Slope tan φ of the segment.
    pub slope: SimdVector,
}

/// Motion in one transverse direction.
#[derive(Debug, Clone, Copy, Default)]
pub struct TransverseMotion {
    /// Position y + (β/h) d, m, with y the predictor of the coming step.
    pub(in crate::integrator::explicit) s: SimdVector,
    /// Increment of y in the last step, m.
    pub(in crate::integrator::explicit) d: SimdVector,
    /// Acceleration h² M⁻¹ f, m. Between motion and forces, in the first direction: the rise Σ tan
    /// φ Δs of all directions, from the start of the stripe to the point.
    pub(in crate::integrator::explicit) w: SimdVector,
}

/// Returns row and SIMD lane of a packed index.
#[inline(always)]
pub(in crate::integrator::explicit) const fn row_and_lane(packed_index: usize) -> (usize, usize) {
    (packed_index / SIMD_LANES, packed_index % SIMD_LANES)
}
