//! Points side by side in the lanes of the processor.
//!
//! A long wire is cut into as many strands as there are lanes, equally long but for the last; so are all short ones
//! of an island, one behind the other. Points of the same number in their strands make a row, so the points beside
//! all of a row are the rows before and behind, and what a step hands on from point to point stays in registers.
//! Copies of the points beyond a cut stand before and behind each strand. Where a wire is regular it is cut where it
//! repeats itself, and then four links, or four reaches, fill rows as well.
//!
//! A place in the rows is called a slot: [`LANES`] × row + lane. The points beside it are [`LANES`] off.

/// Lanes, and strands of a block.
pub(in crate::integrator::explicit) const LANES: usize = 4;
/// Rows of copies before, and behind: bending reaches two points far.
pub(in crate::integrator::explicit) const HALO: usize = 2;

/// A number for each lane; none lies across two lines of a cache.
#[derive(Debug, Clone, Copy, Default)]
#[repr(align(32))]
pub struct Wide(pub [f64; LANES]);

impl std::ops::Deref for Wide {
    type Target = [f64; LANES];

    #[inline(always)]
    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

impl std::ops::DerefMut for Wide {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut Self::Target {
        &mut self.0
    }
}

/// Lane by lane.
#[inline(always)]
pub(in crate::integrator::explicit) fn each(of: impl Fn(usize) -> f64) -> Wide {
    Wide(lanes(of))
}

/// A number for each of some lanes. A loop of its own: what the library maps arrays with may not be compiled for
/// wide lanes.
#[inline(always)]
pub(in crate::integrator::explicit) fn lanes<const L: usize>(
    of: impl Fn(usize) -> f64,
) -> [f64; L] {
    let mut all = [0.0; L];
    for l in 0..L {
        all[l] = of(l);
    }
    all
}

/// What is the same across in all directions. Segments have the row of their first point.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::integrator::explicit) struct Common {
    /// q/h² of the segment, kg/s².
    pub filter: Wide,
    /// r/h² of the point, kg/s².
    pub second: Wide,
    /// 1/L of the segment, 1/m.
    pub per_length: Wide,
    /// EI*/ℓ̄ of the point, N·m; see [`bends`](crate::integrator::explicit::chain_model::bends).
    pub bending: Wide,
}

/// What damps a point. Where it is the same for all points of a block, one row is read for all.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::integrator::explicit) struct Damped {
    /// α h.
    pub alpha: Wide,
    /// β/h.
    pub lag: Wide,
}

/// What belongs to a direction across.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::integrator::explicit) struct Across {
    /// h²/m of the point, s²/kg.
    pub inverse: Wide,
    /// Stiffness of the segment under tension, N/m.
    pub tension: Wide,
    /// tan φ of the segment.
    pub slope: Wide,
}

/// What moves in a direction across.
#[derive(Debug, Clone, Copy, Default)]
pub struct Moving {
    /// y + (β/h) d, m, with y the predictor of the coming step.
    pub(in crate::integrator::explicit) s: Wide,
    /// Increment of y in the last step, m.
    pub(in crate::integrator::explicit) d: Wide,
    /// h² M⁻¹ f, m. Between the motion and the forces, in the first direction: Σ tan φ Δs of all directions, from
    /// the begin of the strand to the point.
    pub(in crate::integrator::explicit) w: Wide,
}

/// Row and lane of a slot.
#[inline(always)]
pub(in crate::integrator::explicit) const fn place(slot: usize) -> (usize, usize) {
    (slot / LANES, slot % LANES)
}
