//! The line linearised about its equilibrium: matrices, static response, natural frequencies.

mod damping_rest;
pub(crate) mod dispersion;
pub(crate) mod elasticity;
pub mod island;
pub mod link;
pub mod loads;
pub(crate) mod masses;
pub mod model;
pub(crate) mod natural_frequencies;
pub mod static_response;
pub mod supports;
