//! Start of a pantograph by itself, and the inputs of its steps.

/// Start of a pantograph by itself, in equilibrium.
#[derive(Debug, Clone, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct AloneStart {
    /// Displacements, m.
    pub displacements: Vec<f64>,
    /// Preload p, N.
    pub preload: f64,
    /// Height above the rail that displacements count from, m.
    pub datum: f64,
    /// Contact force on each strip, N.
    pub forces: Vec<f64>,
    /// Lateral position of the wire on each strip, m.
    pub laterals: Vec<f64>,
}

impl AloneStart {
    pub(super) fn is_finite(&self) -> bool {
        let lists = [&self.displacements, &self.forces, &self.laterals];
        let numbers = [self.preload, self.datum];
        lists
            .into_iter()
            .flatten()
            .chain(&numbers)
            .all(|v| v.is_finite())
    }
}

/// Inputs of a step.
#[derive(Debug, Clone, Copy)]
pub struct AloneInputs<'a> {
    /// Contact force on each strip at the time of balance, N, which pushes it down.
    pub forces: &'a [f64],
    /// Lateral position of the wire on each strip, m.
    pub laterals: &'a [f64],
    /// Force of the actuator, N.
    pub actuator: f64,
    /// Speed at the time of balance, m/s.
    pub speed: f64,
    /// Displacement of the base at the end of the step, m, and its rate, m/s.
    pub base: [f64; 2],
}
