//! Relaxation of the length corrections of the design calculation.

/// Bound on the iterations; lines need about 10, spatial ones about 20.
const MOST_ITERATIONS: usize = 200;

/// Bound on the iterations where each element has its own relaxation factor.
const MOST_ITERATIONS_PER_ELEMENT: usize = 500;

/// Way in which lengths follow their errors; what made a line converge suits those like it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Pace {
    /// One factor for all elements.
    Uniform(f64),
    /// Factors of their own.
    PerElement,
}

/// Relaxation factors of the length corrections: one for all elements, or one for each. Where a
/// stiffer neighbour holds a steep element, its slope does not follow the force, and the full
/// correction is too large by up to EA z′²/T.
pub(super) struct LengthRelaxation {
    /// Factor of all elements, where they are alike.
    uniform: f64,
    /// Factor and last error, N, of each element; empty where all are alike.
    per_element: Vec<(f64, f64)>,
}

impl LengthRelaxation {
    /// Relaxation factors at the start, for a number of elements.
    pub(super) fn new(pace: Pace, elements: usize) -> Self {
        match pace {
            Pace::Uniform(factor) => Self::uniform(factor),
            Pace::PerElement => Self::per_element(elements),
        }
    }

    /// One factor for all elements.
    fn uniform(factor: f64) -> Self {
        Self {
            uniform: factor,
            per_element: Vec::new(),
        }
    }

    /// Factors of their own for a number of elements.
    fn per_element(elements: usize) -> Self {
        Self {
            uniform: 1.0,
            per_element: vec![(1.0, 0.0); elements],
        }
    }

    /// Bound on the iterations with these factors.
    pub(super) fn most_iterations(&self) -> usize {
        if self.per_element.is_empty() {
            MOST_ITERATIONS
        } else {
            MOST_ITERATIONS_PER_ELEMENT
        }
    }

    /// Factor on the correction of an element with an `error`, N: the factor that would have left
    /// no error last time (secant), but changed by no more than a half or twice, and never above
    /// one.
    pub(super) fn factor(&mut self, element: usize, error: f64) -> f64 {
        let Some((factor, last)) = self.per_element.get_mut(element) else {
            return self.uniform;
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

/// Largest strain of one correction of an element that shall carry no tension: some hundred times
/// the strain that a sag of a thousandth of the span needs.
const UNTENSIONED_STRAIN: f64 = 1e-3;

/// Relative change of length of an element whose horizontal force has an `error`, N, limited to the
/// strain of its tension: a wild first guess must not slacken or overstretch it.
pub(super) fn length_change(error: f64, flexibility: f64, strain: f64) -> f64 {
    let limit = if strain > 0.0 {
        strain
    } else {
        UNTENSIONED_STRAIN
    };
    (error * flexibility).clamp(-limit, limit)
}
