//! How far the design calculation corrects the length of an element at once.

/// Bound on the iterations; lines need about 10, spatial ones about 20.
const MOST_ITERATIONS: usize = 200;

/// The same where each element finds its own pace.
const MOST_ITERATIONS_APART: usize = 500;

/// How fast the lengths are corrected: all alike, or each element at its own pace. Where a stiffer
/// neighbour holds a steep element, its slope does not follow the force, and the full correction is
/// too large by up to EA z′²/T.
pub(super) struct Pace {
    relaxation: f64,
    /// Factor and last error of each element; empty where all are alike.
    own: Vec<(f64, f64)>,
}

impl Pace {
    pub(super) fn alike(relaxation: f64) -> Self {
        let own = Vec::new();
        Self { relaxation, own }
    }

    pub(super) fn apart(elements: usize) -> Self {
        let (relaxation, own) = (1.0, vec![(1.0, 0.0); elements]);
        Self { relaxation, own }
    }

    /// Bound on the iterations at this pace.
    pub(super) fn most_iterations(&self) -> usize {
        if self.own.is_empty() {
            MOST_ITERATIONS
        } else {
            MOST_ITERATIONS_APART
        }
    }

    /// Factor on the correction of an element: what would have left no error last time (secant), but
    /// changed by no more than a half or twice, and never above one.
    pub(super) fn of(&mut self, element: usize, error: f64) -> f64 {
        let Some((factor, last)) = self.own.get_mut(element) else {
            return self.relaxation;
        };
        let gain = if *last == 0.0 {
            1.0
        } else {
            1.0 - error / *last
        };
        let change = if gain > 0.5 {
            (1.0 / gain).max(0.5)
        } else {
            2.0
        };
        *factor = (change * *factor).min(1.0);
        *last = error;
        *factor
    }
}

/// Most that one correction may strain an element which shall carry no tension: some hundred times
/// what a sag of a thousandth of the span needs.
const UNTENSIONED_STRAIN: f64 = 1e-3;

/// Relative change of length of an element whose horizontal force is off by `error`, but never by
/// more than the strain of its tension: a wild first guess must not slacken or overstretch it.
pub(super) fn length_change(error: f64, flexibility: f64, strain: f64) -> f64 {
    let most = if strain > 0.0 {
        strain
    } else {
        UNTENSIONED_STRAIN
    };
    (error * flexibility).clamp(-most, most)
}
