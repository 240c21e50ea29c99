//! Explicit integrator: wires as chains of point masses, stepped by central differences.
//!
//! Motion across a wire propagates at the wave speed √(T/m), some 120 m/s: in a millisecond less
//! than the length of an element. So the new acceleration of a point depends on its neighbours
//! alone. Three things are too stiff for that, and are treated separately:
//!
//! * *Axial stretching.* Tension propagates at √(EA/m), 3 km/s. A chain of points transmits it at
//!   once: between two points *along* the wire, some metres apart, the increment H of the
//!   horizontal force is constant,
//!
//!     H = k (x_b − x_a + Σ tan φⱼ (rⱼ₊₁ − rⱼ)),   1/k = Σ 1/(A cos² φ + B sin² φ)
//!
//!   for r across (lateral, up), slopes φ of the rest position, A = EA/L and B = T/ℓ; tan φ up to a
//!   relative T/EA. Points between them follow. This is static condensation of the motion along the
//!   wire (Guyan, AIAA Journal 3 (1965) 380). In a curve r is counted from the track, which turns
//!   by τⱼ along a segment, and y, to the left, takes ½ τⱼ (yⱼ + yⱼ₊₁) away from the bracket. With
//!   θ the direction of the track at the middle of a segment, less that in the middle of the axial
//!   element, and ±½ τ that at its ends, the sum by parts is
//!
//!     Σ (tan φⱼ + θⱼ) (yⱼ₊₁ − yⱼ) − ½ τ (y_a + y_b)
//!
//! * *Links, struts and springs* on a few points: implicit, by stiff groups, with small dense
//!   matrices.
//! * *Contacts and slack links:* in the complementarity problem, as always.
//!
//! The split is that of Hughes & Liu (J. Appl. Mech. 45 (1978) 371) with Newmark's β = ¼, γ = ½:
//!
//!   M aₙ₊₁ + C vₙ₊₁ + K_I uₙ₊₁ + K_E yₙ₊₁ = fₙ₊₁,   uₙ₊₁ = yₙ₊₁ + β h² aₙ₊₁
//!
//! where K_I is implicit, and the predictor y obeys central differences exactly,
//! yₙ₊₂ − 2 yₙ₊₁ + yₙ = h² aₙ₊₁: stable for ω h < 2 of the explicit part, and without
//! numerical damping.
//!
//! **Dispersion correction.** Lumped masses slow a wave of number k by (k ℓ)²/24, central
//! differences speed it up by (ω h)²/24. A filter of all forces, M⁻¹ + M⁻¹ E M⁻¹ instead of M⁻¹,
//! removes that and the next order too ([`dispersion`](chain_model::dispersion)); the statics stay.
//!
//! **Contacts meet curves** between points, not chords:
//! [smoothed segments](crate::slideline::smoothed_segment).
//!
//! **Points yield like the wire.** A wire of tension T and bending stiffness EI under a force has
//! the corner of a string, rounded over λ = √(EI/T), some 10 cm. A chain rounds it over ℓ instead
//! and yields too much at its points. With EI x coth x instead of EI, x = ℓ/2λ, forces on points
//! displace points as they do on the wire, up to terms in (k ℓ)⁴; the filter compensates the effect
//! on the wave speed. docs/theory/dynamics.md derives it.

pub(crate) mod chain_model;
pub(crate) mod critical_step;
pub(crate) mod energy;
pub(crate) mod forces;
pub(crate) mod interface;
#[cfg(test)]
mod masters_tests;
pub(crate) mod simd;
pub(crate) mod static_state;
pub(crate) mod stepping;
pub(crate) mod stiff_groups;

use energy::EnergyForm;
use simd::packed::{
    DampingCoefficients, SharedCoefficients, SimdVector, TransverseCoefficients, TransverseMotion,
};
use simd::plan::Plan;
use std::ops::Range;
use std::sync::OnceLock;
use stiff_groups::batches::StiffBatches;
use stiff_groups::stiff_group::StiffGroup;
use stiff_groups::ties::TiedEnd;

/// Newmark's β.
const BETA: f64 = 0.25;

/// Axial position of a point: between two masters.
#[derive(Debug, Clone, Copy, Default)]
struct AxialPosition {
    masters: [usize; 2],
    /// Share of the second master.
    share: f64,
}

impl AxialPosition {
    #[inline(always)]
    fn read(&self, x: &[f64]) -> f64 {
        let [a, b] = self.masters;
        (1.0 - self.share) * x[a] + self.share * x[b]
    }

    #[inline(always)]
    fn add(&self, force: f64, f: &mut [f64]) {
        let [a, b] = self.masters;
        f[a] += (1.0 - self.share) * force;
        f[b] += self.share * force;
    }
}

/// Piece of wire between two masters, and the packed indices of its ends.
#[derive(Debug, Clone, Copy)]
struct AxialElement {
    masters: [u32; 2],
    ends: [u32; 2],
    /// Number of the preceding axial element in its stripe; if there is none, the number behind the
    /// last of all.
    previous: u32,
    /// Axial stiffness k, N/m.
    stiffness: f64,
    /// Half the angle by which the track turns along it, rad.
    half_turn: f64,
    /// True if this element and the next three share packed rows, in ascending SIMD lanes from the
    /// first on, and their masters and predecessors are numbered consecutively.
    is_packed: bool,
}

/// Seam between two stripes of a wire.
#[derive(Debug, Clone, Copy)]
struct Seam {
    /// Last point before the seam: its ghost in the second stripe.
    ghost_before: usize,
    /// First point behind the seam: its ghost in the first stripe.
    ghost_behind: usize,
    /// Last axial element that begins before the seam.
    last_before: Option<usize>,
    /// Axial element that spans the seam.
    spanning: Option<usize>,
    /// First axial element that begins behind the seam, in the second stripe.
    first_behind: Option<usize>,
}

/// Wire, or several short ones in a row, divided into stripes.
#[derive(Debug, Clone)]
struct StripedBlock {
    rows: Range<usize>,
    /// Packed indices of ghosts, and of the points they copy.
    ghosts: Vec<[u32; 2]>,
    seams: Vec<Seam>,
    plan: Plan,
    /// Axial elements by their ends, those that span seams last.
    axial_elements: Range<usize>,
    /// Axial elements in curves.
    curved: Vec<u32>,
    /// True if all rows have the same damping.
    is_uniform: bool,
}

/// Parts of the chain model that belong to one island.
#[derive(Debug, Clone)]
struct IslandModel {
    blocks: Vec<StripedBlock>,
    /// Packed rows of all blocks.
    rows: Range<usize>,
    masters: Range<usize>,
    tied_ends: Vec<TiedEnd>,
    batches: StiffBatches,
    /// Packed indices of ghosts that stiff groups read, and of the points they copy.
    read_ghosts: Vec<[u32; 2]>,
    /// Nodes of all stiff groups.
    stiff_nodes: Vec<usize>,
}

/// Masters: points with inertia along the track.
#[derive(Debug, Clone)]
struct Masters {
    /// Inverse mass h²/m, s²/kg.
    inverse: Vec<f64>,
    /// Mass-proportional damping α h.
    damping: Vec<f64>,
    /// Stiffness-proportional damping β/h.
    lag: Vec<f64>,
}

/// Chain model, ready for explicit steps: see [`packed`](simd::packed). Outer lists have one entry
/// for each transverse direction.
#[derive(Debug, Clone)]
pub struct Explicit<const DIM: usize> {
    /// Time step h, s, and 1/h.
    h: f64,
    per_step: f64,
    /// Node of each packed index; `usize::MAX` for unused ones and ghosts.
    nodes: Vec<usize>,
    /// Packed index of each node.
    points: Vec<usize>,
    /// Packed index of the point of which each is a ghost, or its own.
    home: Vec<usize>,
    islands: Vec<IslandModel>,
    common: Vec<SharedCoefficients>,
    damping: Vec<DampingCoefficients>,
    transverse: Vec<Vec<TransverseCoefficients>>,
    axial_positions: Vec<AxialPosition>,
    axial_elements: Vec<AxialElement>,
    masters: Masters,
    stiff_groups: Vec<StiffGroup>,
    /// Stiff group of each packed index, and the index of the point in it.
    in_stiff_group: Vec<Option<(usize, usize)>>,
    /// Constants of the energy forms, by island, built at the first request.
    forms: OnceLock<Vec<EnergyForm>>,
}

/// State of the chain model.
#[derive(Debug, Clone)]
pub struct ChainState {
    /// Motion of the packed rows in each transverse direction.
    moving: Vec<Vec<TransverseMotion>>,
    /// Axial force H of each segment minus that of the preceding one, N.
    axial_force_jump: Vec<SimdVector>,
    /// Predictor of the masters, and its last increment, m.
    pub(crate) x: [Vec<f64>; 2],
    /// Position x + (β/h) d of the masters, with damping, m.
    lagged: Vec<f64>,
    /// Axial force on each master, N.
    master_force: Vec<f64>,
    /// Axial force H of each axial element, N, followed by a zero.
    axial_force: Vec<f64>,
    /// Packed indices that are read in addition to stiff groups: near contacts, and always.
    requested: Vec<usize>,
    always_requested: Vec<usize>,
    /// Number of steps done, and for each node the last step, counted from one, after which its
    /// motion is known.
    pub(crate) steps: u64,
    pub(crate) known_until: Vec<u64>,
    /// Zeros as long as the motion is finite, otherwise NaN. SIMD lanes are never added up: a sum
    /// across them would make the compiler halve all vectors of the sweep.
    finite_check: SimdVector,
}

impl ChainState {
    /// Returns true if the positions of all points and masters are finite.
    pub(crate) fn is_finite(&self) -> bool {
        self.finite_check
            .iter()
            .all(|finite_check| *finite_check == 0.0)
    }

    /// Iterates over the numbers that a saved state keeps.
    pub(crate) fn transverse_motion(&mut self) -> impl Iterator<Item = &mut f64> {
        let rows = self.moving.iter_mut().flatten();
        rows.flat_map(|row| row.s.iter_mut().chain(row.d.iter_mut()))
    }
}

fn refuse(reason: &str) -> crate::error::CoreError {
    crate::error::CoreError::Input {
        array: "solver",
        reason: reason.into(),
    }
}
