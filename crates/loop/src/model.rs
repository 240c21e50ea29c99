//! Exported model: a line, or a pantograph by itself.

use crate::failure::Failure;
use crate::line::{LineDevice, LineModel};
use crate::pantograph::{PantographDevice, PantographModel};
use crate::stepper::Device;
use serde::{Deserialize, Serialize};

/// Exported model with the version of Arcless that made it.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Model {
    /// Version of Arcless.
    pub version: String,
    /// Part of the scenario.
    pub part: Part,
}

/// Part of a scenario that is exported.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub enum Part {
    /// Line, with pantographs or with what presses against it from outside.
    Line(Box<LineModel>),
    /// Pantograph by itself.
    Pantograph(Box<PantographModel>),
}

impl Model {
    /// Model of a part, by this version.
    #[must_use]
    pub fn new(part: Part) -> Self {
        Self {
            version: env!("CARGO_PKG_VERSION").into(),
            part,
        }
    }

    /// Device at its start.
    ///
    /// # Errors
    /// [`Failure`] when it cannot be stepped.
    pub fn device(self) -> Result<Box<dyn Device>, Failure> {
        let refused = |error| Failure::data(format!("the model cannot be stepped: {error}"));
        Ok(match self.part {
            Part::Line(line) => Box::new(LineDevice::new(*line).map_err(refused)?),
            Part::Pantograph(model) => Box::new(PantographDevice::new(*model).map_err(refused)?),
        })
    }
}

/// Prefixes of the names of strips: none where there is one, else `strip_1.` and so on.
pub(crate) fn strip_prefixes(count: usize) -> Vec<String> {
    if count == 1 {
        return vec![String::new()];
    }
    (1..=count)
        .map(|number| format!("strip_{number}."))
        .collect()
}

/// Name of an element of a matrix that is a single number for one row.
pub(crate) fn element(name: &str, count: usize, (row, column): (usize, usize)) -> String {
    if count == 1 {
        return name.into();
    }
    format!("{name}[{},{}]", row + 1, column + 1)
}
