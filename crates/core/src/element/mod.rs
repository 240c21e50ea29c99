//! Elements: energy, its gradient and its exact tangent for given positions.

pub mod bar;
pub mod chain;
pub mod frame;
pub mod hermite;
pub mod tangent;
