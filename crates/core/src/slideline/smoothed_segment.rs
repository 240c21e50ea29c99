//! Smoothed segment of a chain: the curve that contacts meet in explicit steps.
//!
//! Chords have a corner at every point, and are less compliant between points than the wire. Here a
//! position x between the points 1 and 2, ℓ apart along the track, is on a cubic with the slopes of
//! parabolas through three points each (Catmull & Rom 1974; Keys, IEEE Trans. ASSP 29 (1981) 1153),
//!
//!   u(x) = h₀₀ u₁ + ℓ h₁₀ s₁ + h₀₁ u₂ + ℓ h₁₁ s₂,   sᵢ = (b Δ₋ + a Δ₊)/(a + b)
//!
//! with h those of Hermite, a and b the lengths before and behind point i, Δ₋ and Δ₊ the slopes of
//! the chords there. A parabola is met exactly, and slopes do not jump.
//!
//! **Slope jumps.** Where a support or a link holds the wire its slope has a jump κ, rounded over
//! λ = √(EI/T); the points of the chain have one that is rounded over their distance:
//!
//!   wire    κ g(s),    g(s)  = (|s| + λ e^{−|s|/λ})/2,    T g″ − EI g⁗ = T δ
//!   chain   κ g*(s),   g*(s) = (|s| + a e^{−|s|/d})/2,    a = ℓ/sinh μ,  d = ℓ/μ,
//!                                                          4 sinh² (μ/2) = T ℓ²/EI*
//!
//! The interpolation of g* by the cubic is subtracted and g is added: also at the point itself,
//! where the wire is κ (λ − a)/2 above it. Chords turn by Δ₊ − Δ₋ there, by less than κ as they cut
//! the corner: κ follows from this turn and that of the chords of g*. Height and slope at the far
//! end of the element stay those of the cubic, which the next element has as well, so neither
//! jumps.
//!
//! **Residual flexibility.** G(x, y) = c − g(x − y)/T is the displacement of the wire at x under a
//! unit force at y, near y, and c − g*(xᵢ − xⱼ)/T the displacement of point i of the chain under a
//! unit force on point j. So with φ the shape functions of the points the chain lacks
//!
//!   R(x, y) = G(x, y) − Σ φᵢ(x) φⱼ(y) G*ᵢⱼ = (Σ φᵢ(x) φⱼ(y) g*(xᵢ − yⱼ) − g(x − y))/T
//!
//! −0.3 µm/N at a point of a contact wire in elements of 0.45 m, 2 µm/N between two, and zero two
//! elements further. It is applied where that of cubic elements is ([local
//! compliance](crate::slideline::local_compliance)). Where a link hangs, φ has the slope jump in
//! it, R between the contact and its node is zero, and both share their force as they should.

use crate::element::hermite;

/// Rounded corner (|s| + a e^{−|s|/d})/2 of a wire or a chain under a point force.
#[derive(Debug, Clone, Copy)]
struct Corner {
    /// Height a at s = 0, m.
    height: f64,
    /// Width d, m.
    width: f64,
}

impl Corner {
    /// Value at the distance `s`, m.
    fn value(&self, s: f64) -> f64 {
        0.5 * (s.abs() + self.height * self.decay(s))
    }

    /// Slope at the distance `s`.
    fn slope(&self, s: f64) -> f64 {
        let ratio = if self.width > 0.0 {
            self.height / self.width
        } else {
            0.0
        };
        0.5 * s.signum() * (1.0 - ratio * self.decay(s))
    }

    /// Decay e^{−|s|/d} at the distance `s`, m.
    fn decay(&self, s: f64) -> f64 {
        if self.width > 0.0 {
            (-s.abs() / self.width).exp()
        } else {
            0.0
        }
    }
}

/// Corner shapes of a wire under tension and of the chain that models it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CornerShapes {
    /// Tension T, N.
    pub tension: f64,
    wire: Corner,
    chain: Corner,
}

impl CornerShapes {
    /// Corner shapes for EI of the wire and EI* of the chain, N·m², with elements of `length`, m.
    pub(crate) fn new(tension: f64, [wire, chain]: [f64; 2], length: f64) -> Self {
        let radius = (wire / tension).sqrt();
        let half = 0.5 * length * (tension / chain).sqrt();
        // sinh (μ/2) is half; without bending stiffness the chords are exact.
        let mu = 2.0 * half.asinh();
        let chain = if mu.is_finite() && mu > 0.0 {
            Corner {
                height: length / mu.sinh(),
                width: length / mu,
            }
        } else {
            Corner {
                height: 0.0,
                width: 0.0,
            }
        };
        Self {
            tension,
            wire: Corner {
                height: radius,
                width: radius,
            },
            chain,
        }
    }
}

/// Smoothed segment between two points, with their neighbours.
#[derive(Debug, Clone)]
pub(crate) struct SmoothedSegment<const DIM: usize> {
    corners: CornerShapes,
    /// Corners of the chain at both ends.
    end_corners: [Corner; 2],
    /// Points in the order of the track, m; unused beyond `count`.
    points: [[f64; DIM]; 4],
    /// Number of points, two to four.
    count: usize,
    /// Index of the point at the first end: 1, or 0 where a wire begins.
    first: usize,
    /// Weights of the points in the slopes at both ends, 1/m.
    slopes: [[f64; 4]; 2],
    /// Weights of the points in the slope jumps κ at both ends, 1/m, where the wire is held.
    slope_jumps: [Option<[f64; 4]>; 2],
    /// Corners g*(xᵢ − xⱼ) of the chain between its points, m.
    chain_corners: [[f64; 4]; 4],
}

impl<const DIM: usize> SmoothedSegment<DIM> {
    /// Segment on two to four points, of which `first` and the next one are its ends. `held`:
    /// corner shapes at those ends where a support or a link holds the wire.
    pub(crate) fn new(
        corners: CornerShapes,
        points: &[[f64; DIM]],
        first: usize,
        held: [Option<CornerShapes>; 2],
    ) -> Self {
        let mut new = Self {
            corners,
            end_corners: held.map(|shapes| shapes.unwrap_or(corners).chain),
            points: [[0.0; DIM]; 4],
            count: points.len(),
            first,
            slopes: [[0.0; 4]; 2],
            slope_jumps: [None; 2],
            chain_corners: [[0.0; 4]; 4],
        };
        new.points[..points.len()].copy_from_slice(points);
        let chord = new.chord_slope(first);
        // Where a wire ends its last three points make one parabola.
        let opposite = |slope: [f64; 4]| std::array::from_fn(|k| 2.0 * chord[k] - slope[k]);
        new.slopes = match [first, first + 1].map(|point| new.point_slope(point)) {
            [Some(a), Some(b)] => [a, b],
            [Some(a), None] => [a, opposite(a)],
            [None, Some(b)] => [opposite(b), b],
            [None, None] => [chord; 2],
        };
        for i in 0..points.len() {
            new.chain_corners[i] =
                std::array::from_fn(|j| corners.chain.value(new.x(i) - new.x(j)));
        }
        new.slope_jumps = std::array::from_fn(|end| held[end].and_then(|_| new.slope_jump(end)));
        new
    }

    /// Coordinate of a point along the track, m.
    fn x(&self, point: usize) -> f64 {
        self.points[point][0]
    }

    /// Tells whether a point has neighbours on both sides.
    fn is_inside(&self, point: usize) -> bool {
        (1..self.count - 1).contains(&point)
    }

    /// Weights of the points in the slope of the chord behind a point, 1/m.
    fn chord_slope(&self, point: usize) -> [f64; 4] {
        let mut weights = [0.0; 4];
        let per_length = 1.0 / (self.x(point + 1) - self.x(point));
        (weights[point], weights[point + 1]) = (-per_length, per_length);
        weights
    }

    /// Weights of the points in the slope at a point, 1/m.
    fn point_slope(&self, point: usize) -> Option<[f64; 4]> {
        self.is_inside(point).then(|| {
            let (before, behind) = (self.chord_slope(point - 1), self.chord_slope(point));
            let [from, at, to] = [point - 1, point, point + 1].map(|k| self.x(k));
            let weight = (to - at) / (to - from);
            std::array::from_fn(|k| weight * before[k] + (1.0 - weight) * behind[k])
        })
    }

    /// Weights of the points in the slope jump κ at an end, 1/m.
    fn slope_jump(&self, end: usize) -> Option<[f64; 4]> {
        let point = self.first + end;
        self.is_inside(point).then(|| {
            let (before, behind) = (self.chord_slope(point - 1), self.chord_slope(point));
            let turn: [f64; 4] = std::array::from_fn(|k| behind[k] - before[k]);
            let unit_turn: f64 = (0..self.count)
                .map(|k| turn[k] * self.chain_corner(k, end))
                .sum();
            turn.map(|weight| weight / unit_turn)
        })
    }

    /// Corner g* of the chain about an end, at a point, m.
    fn chain_corner(&self, point: usize, end: usize) -> f64 {
        self.end_corners[end].value(self.x(point) - self.x(self.first + end))
    }

    /// Coordinates of both ends along the track, m.
    pub(crate) fn range(&self) -> (f64, f64) {
        (self.x(self.first), self.x(self.first + 1))
    }

    /// Number of points before the first end, and in all.
    pub(crate) fn point_window(&self) -> (usize, usize) {
        (self.first, self.count)
    }

    /// Shape functions φ of the points at ξ from 0 to 1.
    pub(crate) fn shape(&self, xi: f64) -> [f64; 4] {
        let functions = hermite::shape(xi, self.length());
        self.with_slope_jumps(xi, &functions, |s| self.corners.wire.value(s))
    }

    /// Derivatives of the shape functions along the track, 1/m.
    pub(crate) fn shape_slope(&self, xi: f64) -> [f64; 4] {
        let functions = hermite::shape_slope(xi, self.length());
        self.with_slope_jumps(xi, &functions, |s| self.corners.wire.slope(s))
    }

    /// Length along the track, m.
    fn length(&self) -> f64 {
        let (from, to) = self.range();
        to - from
    }

    /// Shape functions of the cubic from those of Hermite, or derivatives from derivatives.
    fn cubic(&self, functions: &[f64; 4]) -> [f64; 4] {
        let [before, behind] = &self.slopes;
        let by_slopes = |k: usize| functions[1] * before[k] + functions[3] * behind[k];
        let mut shape: [f64; 4] = std::array::from_fn(by_slopes);
        shape[self.first] += functions[0];
        shape[self.first + 1] += functions[2];
        shape
    }

    /// Shape functions, or their derivatives, in which g replaces the interpolation of g* by the
    /// cubic, except for height and slope at the other end: the next element has them too, without
    /// this slope jump.
    fn with_slope_jumps(&self, xi: f64, functions: &[f64; 4], g: impl Fn(f64) -> f64) -> [f64; 4] {
        let cubic = self.cubic(functions);
        let mut shape = cubic;
        for (end, jump) in self.slope_jumps.iter().enumerate() {
            let Some(jump) = jump else {
                continue;
            };
            let other = 1 - end;
            let interpolated = |weights: &[f64; 4]| -> f64 {
                (0..self.count)
                    .map(|k| weights[k] * self.chain_corner(k, end))
                    .sum()
            };
            let distance = |xi: f64| (xi - end as f64) * self.length();
            let far = distance(other as f64);
            let wire = &self.corners.wire;
            let height = wire.value(far) - self.chain_corner(self.first + other, end);
            let slope = wire.slope(far) - interpolated(&self.slopes[other]);
            let at_other_end = height * functions[2 * other] + slope * functions[1 + 2 * other];
            let correction = g(distance(xi)) - interpolated(&cubic) - at_other_end;
            (0..4).for_each(|k| shape[k] += correction * jump[k]);
        }
        shape
    }

    /// Static position for given shape functions, m.
    pub(crate) fn point(&self, shape: &[f64; 4]) -> [f64; DIM] {
        std::array::from_fn(|c| (0..self.count).map(|k| shape[k] * self.points[k][c]).sum())
    }

    /// Residual flexibility R(x, x), m/N.
    pub(crate) fn residual_flexibility(&self, shape: &[f64; 4]) -> f64 {
        let g = bilinear(shape, shape, |i, j| self.chain_corners[i][j]);
        (g - self.corners.wire.value(0.0)) / self.corners.tension
    }

    /// Residual flexibility R(x, y) between a point of this segment and one of another, m/N.
    pub(crate) fn residual_flexibility_between(
        &self,
        shape: &[f64; 4],
        other: &Self,
        other_shape: &[f64; 4],
    ) -> f64 {
        let (last, other_last) = (self.count - 1, other.count - 1);
        let distance = (other.x(0) - self.x(last)).max(self.x(0) - other.x(other_last));
        // Beyond the neighbouring points both corners are |s|/2 up to e⁻¹⁰.
        let widths = [
            self.corners.wire,
            self.corners.chain,
            other.corners.wire,
            other.corners.chain,
        ];
        if distance
            > 10.0
                * widths
                    .map(|corner| corner.width)
                    .into_iter()
                    .fold(0.0, f64::max)
        {
            return 0.0;
        }
        let [x, y] = [self.point(shape)[0], other.point(other_shape)[0]];
        let difference = |i: usize, j: usize| self.x(i.min(last)) - other.x(j.min(other_last));
        let g = bilinear(shape, other_shape, |i, j| {
            self.corners.chain.value(difference(i, j))
        });
        (g - self.corners.wire.value(x - y)) / self.corners.tension
    }
}

/// Bilinear form Σ aᵢ bⱼ gᵢⱼ.
fn bilinear(a: &[f64; 4], b: &[f64; 4], g: impl Fn(usize, usize) -> f64) -> f64 {
    let row = |i: usize| (0..4).map(|j| b[j] * g(i, j)).sum::<f64>();
    (0..4).map(|i| a[i] * row(i)).sum()
}
