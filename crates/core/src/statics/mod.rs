//! Static equilibrium with exact geometry.
//!
//! * [`design`](design::design): positions are given, unstretched lengths are found;
//! * [`service`](service::settle): unstretched lengths are given, positions are found.

pub mod assembly;
mod chain;
pub mod design;
pub mod service;

pub use assembly::{Geometry, Shape};
