//! A chain between its points: the curve that contacts meet in explicit steps.
//!
//! Chords have a corner at every point, and yield less between points than the wire. Here a place x between the
//! points 1 and 2, ℓ apart along the track, lies on a cubic with the slopes of parabolas through three points
//! each (Catmull & Rom 1974; Keys, IEEE Trans. ASSP 29 (1981) 1153),
//!
//!   u(x) = h₀₀ u₁ + ℓ h₁₀ s₁ + h₀₁ u₂ + ℓ h₁₁ s₂,   sᵢ = (b Δ₋ + a Δ₊)/(a + b)
//!
//! with h those of Hermite, a and b the lengths before and behind point i, Δ₋ and Δ₊ the slopes of the chords
//! there. A parabola is met exactly, and slopes do not jump.
//!
//! **Kinks.** Where something holds the wire it has a kink κ, rounded over λ = √(EI/T); the points of the chain have
//! one that is rounded over their distance:
//!
//!   wire    κ g(s),    g(s)  = (|s| + λ e^{−|s|/λ})/2,    T g″ − EI g⁗ = T δ
//!   chain   κ g*(s),   g*(s) = (|s| + a e^{−|s|/d})/2,    a = ℓ/sinh μ,  d = ℓ/μ,  4 sinh² (μ/2) = T ℓ²/EI*
//!
//! What the cubic makes of g* is taken out and g put in: also at the point itself, where the wire is κ (λ − a)/2 above
//! it. Chords turn by Δ₊ − Δ₋ there, less than by κ as they cut the corner: κ is that for what it is of g*. Height and
//! slope at the far end of the element stay those of the cubic, which the next element has as well, so neither jumps.
//!
//! **Yield.** G(x, y) = c − g(x − y)/T is what a force at y raises the wire at x by, near y, and c − g*(xᵢ − xⱼ)/T what a
//! force on point j raises point i of the chain by. So with φ the shares of the points in a place the chain misses
//!
//!   R(x, y) = G(x, y) − Σ φᵢ(x) φⱼ(y) G*ᵢⱼ = (Σ φᵢ(x) φⱼ(y) g*(xᵢ − yⱼ) − g(x − y))/T
//!
//! −0.3 µm/N at a point of a contact wire in elements of 0.45 m, 2 µm/N between two, and gone two elements further. It
//! is put where that of cubic elements is ([`yields`](crate::slideline::residual_flexibility)). Where a link hangs, φ has the kink in it, R
//! between the contact and its node is zero, and both share their force as they should.

use crate::element::hermite;

/// A corner (|s| + a e^{−|s|/d})/2.
#[derive(Debug, Clone, Copy)]
struct Corner {
    rise: f64,
    width: f64,
}

impl Corner {
    /// m
    fn at(&self, s: f64) -> f64 {
        0.5 * (s.abs() + self.rise * self.faded(s))
    }

    fn slope(&self, s: f64) -> f64 {
        let share = if self.width > 0.0 {
            self.rise / self.width
        } else {
            0.0
        };
        0.5 * s.signum() * (1.0 - share * self.faded(s))
    }

    /// e^{−|s|/d}
    fn faded(&self, s: f64) -> f64 {
        if self.width > 0.0 {
            (-s.abs() / self.width).exp()
        } else {
            0.0
        }
    }
}

/// A piece of wire, and the chain that stands for it there.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Taut {
    /// N
    pub tension: f64,
    wire: Corner,
    chain: Corner,
}

impl Taut {
    /// With EI of the wire and EI* of the chain, N·m², whose elements are `length` long.
    pub(crate) fn new(tension: f64, [wire, chain]: [f64; 2], length: f64) -> Self {
        let radius = (wire / tension).sqrt();
        let half = 0.5 * length * (tension / chain).sqrt();
        // sinh (μ/2) is half; without bending stiffness chords are the wire's.
        let mu = 2.0 * half.asinh();
        let chain = if mu.is_finite() && mu > 0.0 {
            Corner {
                rise: length / mu.sinh(),
                width: length / mu,
            }
        } else {
            Corner {
                rise: 0.0,
                width: 0.0,
            }
        };
        Self {
            tension,
            wire: Corner {
                rise: radius,
                width: radius,
            },
            chain,
        }
    }
}

/// An element between two points, with the points beside them.
#[derive(Debug, Clone)]
pub(crate) struct SmoothedSegment<const DIM: usize> {
    taut: Taut,
    /// Of the chain at both ends.
    corners: [Corner; 2],
    /// In the order of the track; of no use beyond `count`.
    points: [[f64; DIM]; 4],
    /// Two to four.
    count: usize,
    /// The point that begins the element: 1, or 0 where a wire begins.
    first: usize,
    /// Shares of the points in the slopes at both ends, 1/m.
    slopes: [[f64; 4]; 2],
    /// Those in κ at both ends, 1/m, where the wire is held.
    kinks: [Option<[f64; 4]>; 2],
    /// g*(xᵢ − xⱼ), m.
    between: [[f64; 4]; 4],
}

impl<const DIM: usize> SmoothedSegment<DIM> {
    /// On two to four points, of which `first` and the next one are its ends. `held` has what the wire and the chain are
    /// like there for those of the two which something holds.
    pub(crate) fn new(
        taut: Taut,
        on: &[[f64; DIM]],
        first: usize,
        held: [Option<Taut>; 2],
    ) -> Self {
        let mut new = Self {
            taut,
            corners: held.map(|at| at.unwrap_or(taut).chain),
            points: [[0.0; DIM]; 4],
            count: on.len(),
            first,
            slopes: [[0.0; 4]; 2],
            kinks: [None; 2],
            between: [[0.0; 4]; 4],
        };
        new.points[..on.len()].copy_from_slice(on);
        let chord = new.chord(first);
        // Where a wire ends its last three points make one parabola.
        let turned = |slope: [f64; 4]| std::array::from_fn(|k| 2.0 * chord[k] - slope[k]);
        new.slopes = match [first, first + 1].map(|point| new.slope(point)) {
            [Some(a), Some(b)] => [a, b],
            [Some(a), None] => [a, turned(a)],
            [None, Some(b)] => [turned(b), b],
            [None, None] => [chord; 2],
        };
        for i in 0..on.len() {
            new.between[i] = std::array::from_fn(|j| taut.chain.at(new.x(i) - new.x(j)));
        }
        new.kinks = std::array::from_fn(|end| held[end].and_then(|_| new.kink(end)));
        new
    }

    fn x(&self, point: usize) -> f64 {
        self.points[point][0]
    }

    fn is_inside(&self, point: usize) -> bool {
        (1..self.count - 1).contains(&point)
    }

    /// Shares in the slope of the chord behind a point.
    fn chord(&self, point: usize) -> [f64; 4] {
        let mut shares = [0.0; 4];
        let per_length = 1.0 / (self.x(point + 1) - self.x(point));
        (shares[point], shares[point + 1]) = (-per_length, per_length);
        shares
    }

    /// Shares in the slope at a point.
    fn slope(&self, point: usize) -> Option<[f64; 4]> {
        self.is_inside(point).then(|| {
            let (before, behind) = (self.chord(point - 1), self.chord(point));
            let [from, at, to] = [point - 1, point, point + 1].map(|k| self.x(k));
            let weight = (to - at) / (to - from);
            std::array::from_fn(|k| weight * before[k] + (1.0 - weight) * behind[k])
        })
    }

    /// Shares in κ at an end.
    fn kink(&self, end: usize) -> Option<[f64; 4]> {
        let point = self.first + end;
        self.is_inside(point).then(|| {
            let (before, behind) = (self.chord(point - 1), self.chord(point));
            let turn: [f64; 4] = std::array::from_fn(|k| behind[k] - before[k]);
            let of_one: f64 = (0..self.count)
                .map(|k| turn[k] * self.cornered(k, end))
                .sum();
            turn.map(|share| share / of_one)
        })
    }

    /// g* about an end, at a point, m.
    fn cornered(&self, point: usize, end: usize) -> f64 {
        self.corners[end].at(self.x(point) - self.x(self.first + end))
    }

    /// Both ends along the track, m.
    pub(crate) fn range(&self) -> (f64, f64) {
        (self.x(self.first), self.x(self.first + 1))
    }

    /// Points that take part before its own, and in all.
    pub(crate) fn window(&self) -> (usize, usize) {
        (self.first, self.count)
    }

    /// Shares φ of the points at ξ from 0 to 1.
    pub(crate) fn shares(&self, xi: f64) -> [f64; 4] {
        let functions = hermite::shape(xi, self.length());
        self.with_kinks(xi, &functions, |s| self.taut.wire.at(s))
    }

    /// Their derivatives along the track, 1/m.
    pub(crate) fn share_slopes(&self, xi: f64) -> [f64; 4] {
        let functions = hermite::shape_slope(xi, self.length());
        self.with_kinks(xi, &functions, |s| self.taut.wire.slope(s))
    }

    fn length(&self) -> f64 {
        let (from, to) = self.range();
        to - from
    }

    /// Shares from the functions of Hermite, or from their derivatives.
    fn smooth(&self, functions: &[f64; 4]) -> [f64; 4] {
        let [before, behind] = &self.slopes;
        let of = |k: usize| functions[1] * before[k] + functions[3] * behind[k];
        let mut shares: [f64; 4] = std::array::from_fn(of);
        shares[self.first] += functions[0];
        shares[self.first + 1] += functions[2];
        shares
    }

    /// With g, or its derivative, in the place of what the cubic makes of g*, but for height and slope at the other end:
    /// the next element has them too, and knows nothing of the kink.
    fn with_kinks(&self, xi: f64, functions: &[f64; 4], g: impl Fn(f64) -> f64) -> [f64; 4] {
        let smooth = self.smooth(functions);
        let mut shares = smooth;
        for (end, kink) in self.kinks.iter().enumerate() {
            let Some(kink) = kink else {
                continue;
            };
            let other = 1 - end;
            let met = |by: &[f64; 4]| -> f64 {
                (0..self.count).map(|k| by[k] * self.cornered(k, end)).sum()
            };
            let away = |xi: f64| (xi - end as f64) * self.length();
            let far = away(other as f64);
            let apart = self.taut.wire.at(far) - self.cornered(self.first + other, end);
            let bent = self.taut.wire.slope(far) - met(&self.slopes[other]);
            let kept = apart * functions[2 * other] + bent * functions[1 + 2 * other];
            let more = g(away(xi)) - met(&smooth) - kept;
            (0..4).for_each(|k| shares[k] += more * kink[k]);
        }
        shares
    }

    /// Static position for given shares.
    pub(crate) fn point(&self, shares: &[f64; 4]) -> [f64; DIM] {
        std::array::from_fn(|c| (0..self.count).map(|k| shares[k] * self.points[k][c]).sum())
    }

    /// R(x, x), m/N.
    pub(crate) fn own(&self, shares: &[f64; 4]) -> f64 {
        let g = weighted(shares, shares, |i, j| self.between[i][j]);
        (g - self.taut.wire.at(0.0)) / self.taut.tension
    }

    /// R(x, y) between a place on this element and one on another, m/N.
    pub(crate) fn missing(&self, shares: &[f64; 4], other: &Self, its: &[f64; 4]) -> f64 {
        let (last, its_last) = (self.count - 1, other.count - 1);
        let apart = (other.x(0) - self.x(last)).max(self.x(0) - other.x(its_last));
        // Beyond the points beside them both corners are |s|/2, and what e⁻¹⁰ leaves.
        let widths = [
            self.taut.wire,
            self.taut.chain,
            other.taut.wire,
            other.taut.chain,
        ];
        if apart
            > 10.0
                * widths
                    .map(|corner| corner.width)
                    .into_iter()
                    .fold(0.0, f64::max)
        {
            return 0.0;
        }
        let [x, y] = [self.point(shares)[0], other.point(its)[0]];
        let at = |i: usize, j: usize| self.x(i.min(last)) - other.x(j.min(its_last));
        let g = weighted(shares, its, |i, j| self.taut.chain.at(at(i, j)));
        (g - self.taut.wire.at(x - y)) / self.taut.tension
    }
}

/// Σ aᵢ bⱼ gᵢⱼ
fn weighted(a: &[f64; 4], b: &[f64; 4], g: impl Fn(usize, usize) -> f64) -> f64 {
    let row = |i: usize| (0..4).map(|j| b[j] * g(i, j)).sum::<f64>();
    (0..4).map(|i| a[i] * row(i)).sum()
}
