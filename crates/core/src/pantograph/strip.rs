//! Contact strips of a pantograph.
//!
//!   height of the strip at y = e(y)ᵀ u,
//!   e(y) = (1 − t) e_k + t e_{k+1},   y = (1 − t) y_k + t y_{k+1}
//!
//! y is the lateral position of the wire on the strip. Between knots the height is linear, beyond
//! them constant; a strip with one knot is uniform.

use crate::error::CoreError;

/// Contact strip of a pantograph.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Strip {
    /// Distance behind the reference point of the pantograph, m.
    pub offset: f64,
    /// Half width to either side, m; infinite where every lateral position is within it.
    pub half_width: f64,
    /// Lateral positions of the knots, ascending, m.
    pub knots: Vec<f64>,
    /// Vector e at each knot.
    pub vectors: Vec<Vec<f64>>,
}

impl Strip {
    /// Strip at the reference point whose height is vectorᵀ u everywhere.
    #[must_use]
    pub fn plain(vector: Vec<f64>) -> Self {
        Self {
            offset: 0.0,
            half_width: f64::INFINITY,
            knots: vec![0.0],
            vectors: vec![vector],
        }
    }

    /// Tells whether sizes and numbers fit a pantograph of `n` coordinates.
    pub(crate) fn is_valid(&self, n: usize) -> bool {
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

    /// Tells whether the contact depends on the lateral position of the wire.
    pub(crate) fn depends_on_lateral_position(&self) -> bool {
        self.half_width.is_finite() || self.knots.len() > 1
    }

    /// Interpolates vectors `at_knots` to the lateral position `y`, m: e(y) from those of the
    /// strip.
    pub(crate) fn interpolate(&self, at_knots: &[Vec<f64>], y: f64, out: &mut [f64]) {
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

/// Checks the strips of a pantograph of `n` coordinates.
///
/// # Errors
/// [`CoreError::Input`].
pub(crate) fn check(strips: &[Strip], n: usize) -> Result<(), CoreError> {
    if !strips.is_empty() && strips.iter().all(|strip| strip.is_valid(n)) {
        return Ok(());
    }
    let reason = "no strip, or one whose sizes disagree or whose knots do not ascend";
    Err(CoreError::invalid("pantographs", reason))
}
