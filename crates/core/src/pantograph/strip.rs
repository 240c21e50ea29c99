//! Strips of a rider: what touches the wires.
//!
//!   height of the strip at y = e(y)ᵀ u,   e(y) = (1 − t) e_k + t e_{k+1},   y = (1 − t) y_k + t y_{k+1}
//!
//! y is the lateral place of the wire on the strip. Between knots the height is linear, beyond them
//! constant; a strip with one knot is the same everywhere.

use crate::error::CoreError;

/// A strip of a rider.
#[derive(Debug, Clone)]
pub struct Strip {
    /// Distance behind the reference point of the rider, m.
    pub offset: f64,
    /// Reach to either side, m; infinite when every wire is in reach.
    pub half_width: f64,
    /// Lateral places, ascending, m.
    pub knots: Vec<f64>,
    /// e at each knot.
    pub vectors: Vec<Vec<f64>>,
}

impl Strip {
    /// A strip at the reference point, the same everywhere: height = vectorᵀ u.
    #[must_use]
    pub fn plain(vector: Vec<f64>) -> Self {
        Self {
            offset: 0.0,
            half_width: f64::INFINITY,
            knots: vec![0.0],
            vectors: vec![vector],
        }
    }

    /// Check sizes and numbers for a rider of `n` coordinates.
    pub(crate) fn is_sound(&self, n: usize) -> bool {
        let finite = |x: &[f64]| x.iter().all(|v| v.is_finite());
        let ascending = self.knots.windows(2).all(|pair| pair[0] < pair[1]);
        let sized = !self.knots.is_empty() && self.vectors.len() == self.knots.len();
        let vectors = |e: &Vec<f64>| e.len() == n && finite(e);
        sized
            && ascending
            && finite(&self.knots)
            && self.offset.is_finite()
            && self.half_width > 0.0
            && self.vectors.iter().all(vectors)
    }

    /// Whether the lateral place of the wire matters.
    pub(crate) fn looks_aside(&self) -> bool {
        self.half_width.is_finite() || self.knots.len() > 1
    }

    /// e(y), or whatever else `at_knots` holds for each knot, in the same way.
    pub(crate) fn read(&self, at_knots: &[Vec<f64>], y: f64, out: &mut [f64]) {
        let right = self.knots.partition_point(|&knot| knot <= y);
        if right == 0 || right == self.knots.len() {
            out.copy_from_slice(&at_knots[right.saturating_sub(1)]);
            return;
        }
        let (a, b) = (self.knots[right - 1], self.knots[right]);
        let t = (y - a) / (b - a);
        for (out, (left, right)) in out
            .iter_mut()
            .zip(at_knots[right - 1].iter().zip(&at_knots[right]))
        {
            *out = (1.0 - t) * left + t * right;
        }
    }
}

/// Check the strips of a rider of `n` coordinates.
///
/// # Errors
/// [`CoreError::Input`].
pub(crate) fn check(strips: &[Strip], n: usize) -> Result<(), CoreError> {
    if !strips.is_empty() && strips.iter().all(|strip| strip.is_sound(n)) {
        return Ok(());
    }
    Err(CoreError::Input {
        array: "riders",
        reason: "no strip, or one whose sizes disagree or whose knots do not ascend".into(),
    })
}
