//! What lets waves keep their speed: forces are filtered before they accelerate points.
//!
//! With K = 4 sin² (kℓ/2), C = ch/ℓ, ε = EI/(Tℓ²), and ε* the same of EI x coth x, a chain of lumped masses has
//! Tℓ⁻² (K + ε* K²) in the place of Tk² + EI k⁴, and central differences (2/h)² sin² (ωh/2) in the place of ω².
//! Forces that are taken 1 + a K + b K² times, with
//!
//!   a = (1 − C²)/12 − (ε* − ε)
//!   b = (ε* + a)/6 − a ε* − (1 − C⁴)/360 − C² ε/6
//!
//! make ω the same up to (kℓ)⁶. What presses and moves at 0.7 of the wave speed sends waves ahead 3.3 times as short
//! as those of a wire that is shaken where it is: 15 Hz are 50 Hz there, and b is what counts for them.
//!
//! On a line, a is q/m of the segments and b is r/m of the points: E = Σ q [1 −1; −1 1] + Σ r [1 −2 1]ᵀ[1 −2 1] is
//! symmetric, and M⁻¹ + M⁻¹ E M⁻¹ filters.

use crate::integrator::explicit::chain_model::bends::Fit;
use crate::integrator::explicit::chain_model::blocks::Run;
use crate::integrator::explicit::chain_model::layout::Chains;

/// Largest b. Where it would be more elements are shorter than 2.6 λ, and need no such care; the step would shrink.
const MOST: f64 = 1.0 / 30.0;

/// What waves depend on, segment by segment and point by point.
pub(in crate::integrator::explicit) struct Waves {
    /// Mass of a segment, kg.
    pub mass: Vec<f64>,
    /// C² of a segment.
    pub courant: Vec<f64>,
    /// ε of a point, and (ε* − ε) ℓ², m².
    bends: Vec<[f64; 2]>,
}

impl Waves {
    pub fn none(points: usize) -> Self {
        Self {
            mass: vec![0.0; points],
            courant: vec![0.0; points],
            bends: vec![[0.0; 2]; points],
        }
    }

    pub fn bend(&mut self, point: usize, fit: &Fit) {
        self.bends[point] = [fit.share, fit.longer];
    }
}

impl Chains {
    /// Set q of segments and r of points, both times h² as yet.
    pub(in crate::integrator::explicit) fn keep_speed(&mut self, runs: &[Run], waves: &Waves) {
        for run in runs {
            let points = run.first..run.first + run.nodes.len();
            // Hinged ends have no bend; beyond them a standing wave goes on as it is before, with its sign changed.
            let inside = |point: usize| match point {
                p if p == points.start => p + 1,
                p if p + 1 == points.end => p - 1,
                p => p,
            };
            for j in points.start..points.end - 1 {
                let longer = [j, j + 1].map(|p| waves.bends[inside(p)][1]);
                let longer = 0.5 * (longer[0] + longer[1]);
                let [a, _] = shares(waves.courant[j], 0.0, longer * self.per_length[j].powi(2));
                self.filter[j] = waves.mass[j] * a;
            }
            for point in points.start + 1..points.end.max(points.start + 2) - 1 {
                let mean = |of: &[f64]| 0.5 * (of[point - 1] + of[point]);
                let [wire, longer] = waves.bends[point];
                let more = longer * mean(&self.per_length).powi(2);
                let [_, b] = shares(mean(&waves.courant), wire, more);
                self.second[point] = mean(&waves.mass) * b;
            }
        }
    }
}

/// a and b for C², ε and ε* − ε.
fn shares(courant: f64, wire: f64, more: f64) -> [f64; 2] {
    let (a, chain) = ((1.0 - courant) / 12.0 - more, wire + more);
    let by_time = (1.0 - courant * courant) / 360.0 + courant * wire / 6.0;
    [
        a,
        ((chain + a) / 6.0 - a * chain - by_time).clamp(0.0, MOST),
    ]
}
