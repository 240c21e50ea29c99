//! Dispersion correction: a filter of forces that preserves the wave speed.
//!
//! With K = 4 sin² (kℓ/2), C = ch/ℓ, ε = EI/(Tℓ²), and ε* likewise with EI x coth x, a chain of
//! lumped masses has Tℓ⁻² (K + ε* K²) instead of Tk² + EI k⁴, and central differences (2/h)² sin²
//! (ωh/2) instead of ω². Forces multiplied by 1 + a K + b K², with
//!
//!   a = (1 − C²)/12 − (ε* − ε)
//!   b = (ε* + a)/6 − a ε* − (1 − C⁴)/360 − C² ε/6
//!
//! make ω the same up to (kℓ)⁶. A load that moves at 0.7 of the wave speed sends waves ahead 3.3
//! times as short as those of a wire that is excited in place: 15 Hz are 50 Hz there, and b decides
//! on them.
//!
//! On a line, a is q/m of the segments and b is r/m of the points:
//! E = Σ q [1 −1; −1 1] + Σ r [1 −2 1]ᵀ[1 −2 1] is symmetric, and M⁻¹ + M⁻¹ E M⁻¹ filters.

use crate::integrator::explicit::chain_model::bends::FittedBend;
use crate::integrator::explicit::chain_model::builder::ChainBuilder;
use crate::integrator::explicit::chain_model::parts::WireRun;

/// Largest b. It would be exceeded by elements shorter than 2.6 λ, which do not need the term; the
/// stable step would shrink.
const MAX_SECOND: f64 = 1.0 / 30.0;

/// Parameters of wave dispersion, by segment and by point.
pub(in crate::integrator::explicit) struct DispersionTerms {
    /// Mass of a segment, kg.
    pub mass: Vec<f64>,
    /// Square C² of the Courant number of a segment.
    pub courant: Vec<f64>,
    /// Ratio ε of a point, and (ε* − ε) ℓ², m².
    bends: Vec<[f64; 2]>,
}

impl DispersionTerms {
    pub fn zero(points: usize) -> Self {
        Self {
            mass: vec![0.0; points],
            courant: vec![0.0; points],
            bends: vec![[0.0; 2]; points],
        }
    }

    pub fn set_bend(&mut self, point: usize, fit: &FittedBend) {
        self.bends[point] = [fit.ratio, fit.added];
    }
}

impl ChainBuilder {
    /// Sets the weights q of segments and r of points, both still multiplied by h².
    pub(in crate::integrator::explicit) fn correct_dispersion(
        &mut self,
        runs: &[WireRun],
        terms: &DispersionTerms,
    ) {
        for run in runs {
            let points = run.first..run.first + run.nodes.len();
            // Hinged ends have no bend; beyond them a standing wave continues with its sign
            // changed.
            let inside = |point: usize| match point {
                p if p == points.start => p + 1,
                p if p + 1 == points.end => p - 1,
                p => p,
            };
            for j in points.start..points.end - 1 {
                let added = [j, j + 1].map(|p| terms.bends[inside(p)][1]);
                let added = 0.5 * (added[0] + added[1]);
                let [a, _] =
                    filter_weights(terms.courant[j], 0.0, added * self.per_length[j].powi(2));
                self.filter[j] = terms.mass[j] * a;
            }
            for point in points.start + 1..points.end.max(points.start + 2) - 1 {
                let mean = |values: &[f64]| 0.5 * (values[point - 1] + values[point]);
                let [ratio, added] = terms.bends[point];
                let added_ratio = added * mean(&self.per_length).powi(2);
                let [_, b] = filter_weights(mean(&terms.courant), ratio, added_ratio);
                self.second[point] = mean(&terms.mass) * b;
            }
        }
    }
}

/// Returns the filter weights a and b for C², ε and ε* − ε.
fn filter_weights(courant: f64, ratio: f64, added_ratio: f64) -> [f64; 2] {
    let (a, chain) = ((1.0 - courant) / 12.0 - added_ratio, ratio + added_ratio);
    let of_time = (1.0 - courant * courant) / 360.0 + courant * ratio / 6.0;
    [
        a,
        ((chain + a) / 6.0 - a * chain - of_time).clamp(0.0, MAX_SECOND),
    ]
}
