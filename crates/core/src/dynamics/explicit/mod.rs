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
//!   In a curve r is counted from the track, which turns by τⱼ along a segment, and y, to the left, takes
//!   ½ τⱼ (yⱼ + yⱼ₊₁) away from the bracket. With θ the direction of the track at the middle of a segment, less that
//!   in the middle of the reach, and ±½ τ that at its ends, the sum by parts is
//!
//!     Σ (tan φⱼ + θⱼ) (yⱼ₊₁ − yⱼ) − ½ τ (y_a + y_b)
//!
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
//! speed it up by (ω h)²/24. A filter of all forces, M⁻¹ + M⁻¹ E M⁻¹ in the place of M⁻¹, takes that away and the
//! next order too ([`waves`]); the statics stay.
//!
//! **Contacts meet curves** between points, not chords: [`rounded`](super::rounded).
//!
//! **Points yield like the wire.** A wire of tension T and bending stiffness EI under a force has the kink of a
//! string, rounded over λ = √(EI/T), some 10 cm. A chain rounds it over ℓ instead and yields too much at its points.
//! With EI x coth x in the place of EI, x = ℓ/2λ, forces on points displace points as they do on the wire, but
//! for terms in (k ℓ)⁴; what that adds to the speed of waves is taken back by the filter. docs/theory/dynamics.md derives it.

mod along;
mod bends;
mod blocks;
mod cluster;
mod clusters;
mod deal;
pub(super) mod energy;
mod groups;
mod guests;
mod kernels;
mod layout;
mod line;
mod plan;
mod push;
mod rest;
mod rows;
#[cfg(test)]
mod rows_tests;
mod settle;
#[cfg(test)]
mod slide_tests;
mod stable;
mod stepping;
mod strands;
mod stretch;
mod sweep;
mod waves;

use cluster::Cluster;
use energy::Form;
use groups::Groups;
use guests::Guest;
use plan::Plan;
use rows::{Across, Common, Damped, Moving, Wide};
use std::ops::Range;
use std::sync::OnceLock;

/// Newmark's β.
const BETA: f64 = 0.25;

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

/// A piece of wire between two masters, and the slots of its ends.
#[derive(Debug, Clone, Copy)]
struct Reach {
    masters: [u32; 2],
    ends: [u32; 2],
    /// Number of the one before it in its strand; of none behind the last of all.
    before: u32,
    /// k, N/m.
    stiffness: f64,
    /// Half the angle by which the track turns along it, rad.
    lean: f64,
    /// Whether it and the next three have the same rows, in the lanes from the first on, and all that belongs to them
    /// is numbered likewise.
    is_row: bool,
}

/// Where a wire goes on from one strand to the next.
#[derive(Debug, Clone, Copy)]
struct Cut {
    /// The last point before it, as the second strand has it.
    head: usize,
    /// The first point behind it, as the first strand has it.
    tail: usize,
    /// The last reach that begins before it.
    last: Option<usize>,
    /// The reach that goes over it.
    over: Option<usize>,
    /// The first reach that begins behind it, in the second strand.
    next: Option<usize>,
}

/// A wire, or some short ones one behind the other, cut into strands.
#[derive(Debug, Clone)]
struct Block {
    rows: Range<usize>,
    /// Slots of copies, and of what they are copies of.
    copies: Vec<[u32; 2]>,
    cuts: Vec<Cut>,
    plan: Plan,
    /// As they end, those over cuts last.
    reaches: Range<usize>,
    /// Those in curves.
    leaning: Vec<u32>,
    /// Whether all rows have the same damping.
    is_even: bool,
}

/// What belongs to one island.
#[derive(Debug, Clone)]
struct Own {
    blocks: Vec<Block>,
    /// Those of all blocks.
    rows: Range<usize>,
    masters: Range<usize>,
    guests: Vec<Guest>,
    groups: Groups,
    /// Slots of copies that clusters read, and of what they are copies of.
    read: Vec<[u32; 2]>,
    /// Nodes of all clusters.
    linked: Vec<usize>,
}

/// Masters along the wire.
#[derive(Debug, Clone)]
struct Masters {
    /// h²/m, s²/kg.
    inverse: Vec<f64>,
    /// α h.
    damping: Vec<f64>,
    /// β/h.
    lag: Vec<f64>,
}

/// A line of chains, ready for explicit steps: see [`rows`]. Lists of lists hold one for each direction across.
#[derive(Debug, Clone)]
pub struct Explicit<const DIM: usize> {
    /// Step, s, and 1/h.
    h: f64,
    per_step: f64,
    /// Node of each slot; none where there is no point, or a copy.
    nodes: Vec<usize>,
    /// Slot of each node.
    points: Vec<usize>,
    /// Slot of which each is a copy, or its own.
    home: Vec<usize>,
    own: Vec<Own>,
    common: Vec<Common>,
    damped: Vec<Damped>,
    across: Vec<Vec<Across>>,
    along: Vec<Along>,
    reaches: Vec<Reach>,
    masters: Masters,
    clusters: Vec<Cluster>,
    /// Cluster of each slot, and which of its points it is.
    in_cluster: Vec<Option<(usize, usize)>>,
    /// What energies are formed with, island by island, once somebody asked for them.
    forms: OnceLock<Vec<Form>>,
}

/// What moves.
#[derive(Debug, Clone)]
pub struct Grid {
    /// Rows of each direction across.
    moving: Vec<Vec<Moving>>,
    /// H of each segment less that of the one before it, N.
    more: Vec<Wide>,
    /// Predictor of the masters along, and its last increment, m.
    pub(super) x: [Vec<f64>; 2],
    /// x + (β/h) d, m.
    lagged: Vec<f64>,
    /// Force along on the masters, N.
    pull: Vec<f64>,
    /// H of each reach, N, and behind them a zero.
    thrust: Vec<f64>,
    /// Slots that others read beside those of clusters: where contacts are, and always.
    near: Vec<usize>,
    watched: Vec<usize>,
    /// Steps done, and for each node the number of the last one at whose end its motion is found, counted
    /// from one.
    pub(super) steps: u64,
    pub(super) found: Vec<u64>,
    /// Zeros as long as all that moves is finite; one is no number from the step on in which something is not. Lanes
    /// are never added up: with a sum across them the compiler would halve all rows of the sweep.
    sound: Wide,
}

impl Grid {
    /// Whether all points and masters that were stepped are at finite places.
    pub(super) fn is_sound(&self) -> bool {
        self.sound.iter().all(|sound| *sound == 0.0)
    }

    /// Numbers that a later run goes on with.
    pub(super) fn across(&mut self) -> impl Iterator<Item = &mut f64> {
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
