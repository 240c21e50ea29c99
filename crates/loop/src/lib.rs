//! Line or pantograph as a device that other programs step: named variables, whole steps, states.
//!
//! ```text
//! scenario ─export→ file ─open→ Stepper ─set, step, get→ …
//! ```
//!
//! * [`file`] — the exported model as bytes, with a digest;
//! * [`model`] — what is exported: a [`line`], or a [`pantograph`] by itself;
//! * [`variable`] — names, units and descriptions;
//! * [`stepper`] — values of the variables, whole steps, saved states;
//! * [`failure`] — messages with variable and time.
//!
//! The [C interface and FMI](../arcless_loop/index.html) are a crate of their own. Nothing is
//! allocated between two steps, nor in one.

pub mod failure;
pub mod file;
pub mod line;
pub mod model;
pub mod pantograph;
pub mod stepper;
pub mod variable;

pub use failure::{Failure, Kind};
pub use stepper::Stepper;
pub use variable::{Causality, Variable};
