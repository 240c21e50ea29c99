//! A run: model, state, and the step between two states.

pub mod callbacks;
pub(crate) mod control;
pub(crate) mod external;
pub(crate) mod initial_equilibrium;
pub mod inputs;
pub mod model;
pub mod motion;
pub mod recording;
pub mod run;
pub(crate) mod saved;
pub mod sleep;
pub(crate) mod solve_constraints;
pub(crate) mod start;
pub mod state;
pub mod step;
