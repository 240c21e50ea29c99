//! Steps without a system to solve: wires as chains of point masses, stepped by central differences.
//!
//! What moves across a wire does so at the speed of its waves, √(T/m), some 120 m/s: in a millisecond
//! less than the length of an element. Then the new acceleration of a point needs the points beside it
//! alone. Three things are too stiff for that, and are taken out of the way:
//!
//! * *Stretching.* Tension runs at √(EA/m), 3 km/s. A chain of points hands it on as it comes: between
//!   two points *along* the wire, some metres apart, the increment H of the horizontal force is constant,
//!
//!     H = k (x_b − x_a + Σ tan φⱼ (rⱼ₊₁ − rⱼ)),   1/k = Σ 1/(A cos² φ + B sin² φ)
//!
//!   for r across (lateral, up), slopes φ of the rest position, A = EA/L and B = T/ℓ; tan φ but for a
//!   share of T/EA. Points between them follow. This is static condensation of the motion along the
//!   wire (Guyan, AIAA Journal 3 (1965) 380).
//! * *Links, struts and springs* on a few points: implicit, cluster by cluster, with a small dense matrix.
//! * *Contacts and slack links:* in the complementarity problem, as always.
//!
//! The split is that of Hughes & Liu (J. Appl. Mech. 45 (1978) 371) with Newmark's β = ¼, γ = ½:
//!
//!   M aₙ₊₁ + C vₙ₊₁ + K_I uₙ₊₁ + K_E yₙ₊₁ = fₙ₊₁,   uₙ₊₁ = yₙ₊₁ + β h² aₙ₊₁
//!
//! where K_I is implicit, and the predictor y obeys central differences exactly,
//! yₙ₊₂ − 2 yₙ₊₁ + yₙ = h² aₙ₊₁: stable for ω h < 2 of the explicit part, without damping of its own.
//!
//! **Waves keep their speed.** Lumped masses slow a wave of number k by (k ℓ)²/24, central differences
//! speed it up by (ω h)²/24. With the mass M − E, E = Σ q [1 −1; −1 1], q = (m ℓ/12)(1 − (c h/ℓ)²), both
//! leading errors go; its inverse is taken as M⁻¹ + M⁻¹ E M⁻¹, the same to this order and positive. It
//! filters all forces, so the statics stay.

mod along;
mod cluster;
mod clusters;
mod kernels;
mod layout;
mod line;
mod push;
mod rest;
mod settle;
mod stable;
mod stepping;
mod stretch;

use cluster::Cluster;

use std::ops::Range;

/// Newmark's β.
const BETA: f64 = 0.25;
/// Points of no wire before the first and behind the last.
const PAD: usize = 2;

/// Where a point lies along its wire: between two masters.
#[derive(Debug, Clone, Copy, Default)]
struct Along {
    masters: [usize; 2],
    /// Share of the second.
    share: f64,
}

impl Along {
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

/// A piece of wire between two masters.
#[derive(Debug, Clone)]
struct Reach {
    masters: [usize; 2],
    /// Its segments.
    segments: Range<usize>,
    /// k, N/m.
    stiffness: f64,
}

/// What belongs to one island.
#[derive(Debug, Clone)]
struct Own {
    points: Range<usize>,
    reaches: Range<usize>,
    masters: Range<usize>,
    clusters: Range<usize>,
    guests: Range<usize>,
}

/// A line of chains, ready for explicit steps. Segment j lies between points j and j + 1; where two
/// wires meet in the numbering, its numbers are zero. `T` lists hold one for each direction across.
#[derive(Debug, Clone)]
pub struct Explicit<const DIM: usize> {
    /// Step, s, and 1/h.
    h: f64,
    per_step: f64,
    /// Node of each point.
    nodes: Vec<usize>,
    /// Point of each node.
    points: Vec<usize>,
    own: Vec<Own>,
    /// 1/m of each point, 1/kg; zero where held; one for a guest.
    inverse: Vec<Vec<f64>>,
    /// α/h of each point, 1/s².
    damping: Vec<f64>,
    /// β/h of each point.
    lag: Vec<f64>,
    /// Stiffness of a segment under tension, N/m.
    tension: Vec<Vec<f64>>,
    /// 1/L of a segment, 1/m.
    per_length: Vec<f64>,
    /// EI/ℓ̄ of a point, N·m.
    bending: Vec<f64>,
    /// tan φ of a segment.
    slope: Vec<Vec<f64>>,
    /// q of a segment, kg.
    filter: Vec<f64>,
    reaches: Vec<Reach>,
    along: Vec<Along>,
    /// 1/m of each master along the wire, 1/kg; α/h; β/h.
    masters: Vec<[f64; 3]>,
    clusters: Vec<Cluster>,
    /// Cluster of each point, and which of its points it is.
    in_cluster: Vec<Option<(usize, usize)>>,
    /// Ends of wires at a point of another: guest, owner.
    guests: Vec<(usize, usize)>,
}

/// What moves.
#[derive(Debug, Clone)]
pub struct Grid {
    /// Predictor y across, m; of the coming step.
    pub(super) y: Vec<Vec<f64>>,
    /// Its increment in the last step, m.
    pub(super) d: Vec<Vec<f64>>,
    /// The same along, of the masters.
    pub(super) x: [Vec<f64>; 2],
    /// y + (β/h) d.
    lagged: Vec<Vec<f64>>,
    /// M⁻¹ f, m/s².
    w: Vec<Vec<f64>>,
    /// Force along on the masters, N.
    pull: Vec<f64>,
    /// H of each segment, N.
    thrust: Vec<f64>,
    /// Points that others read beside those of clusters: where contacts are, and always.
    near: Vec<usize>,
    watched: Vec<usize>,
}

fn refuse(reason: &str) -> crate::error::CoreError {
    crate::error::CoreError::Input {
        array: "solver",
        reason: reason.into(),
    }
}
