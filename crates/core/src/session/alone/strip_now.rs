//! Strips of a pantograph by itself, where the wires lie on them.

use crate::pantograph::state::PantographState;
use crate::pantograph::strip::Strip;

/// Strip with what depends on the lateral position of the wire.
#[derive(Debug, Clone)]
pub(super) struct StripNow {
    /// Vector e(y).
    pub(super) vector: Vec<f64>,
    /// Column A⁻¹e.
    pub(super) column: Vec<f64>,
    /// Columns at each knot of the strip.
    columns: Vec<Vec<f64>>,
}

impl StripNow {
    pub(super) fn new(strip: &Strip, state: &PantographState) -> Self {
        let columns = strip.vectors.iter().map(|e| state.response(e));
        Self {
            vector: strip.vectors[0].clone(),
            column: state.response(&strip.vectors[0]),
            columns: columns.collect(),
        }
    }

    /// Moves the wire to a lateral position, m.
    pub(super) fn move_wire(&mut self, strip: &Strip, lateral: f64) {
        strip.interpolate(&strip.vectors, lateral, &mut self.vector);
        strip.interpolate(&self.columns, lateral, &mut self.column);
    }
}
