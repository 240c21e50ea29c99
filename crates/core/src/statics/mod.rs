//! Static equilibrium with exact geometry.
//!
//! * [`design`](design::design): positions are given, unstretched lengths are found;
//! * [`service`](service::settle): unstretched lengths are given, positions are found;
//! * [`alteration`]: what is changed after the design, before the line is in service;
//! * `loads`: forces along the wires, steady or given over time;
//! * `flexibility`: what elements yield too little at point forces.

pub mod alteration;
pub mod assembly;
mod chain;
pub mod design;
mod flexibility;
mod loads;
mod newton;
mod pace;
pub mod service;
mod stretching;

pub use alteration::Alteration;
pub use assembly::{Geometry, Shape};
