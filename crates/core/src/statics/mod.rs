//! Static equilibrium with exact geometry.
//!
//! * [`form_finding`]: positions are given, unstretched lengths are found;
//! * [`equilibrium`]: unstretched lengths are given, positions are found;
//! * [`alteration`]: changes after the design, before the line is in service;
//! * `loads`: forces along the wires, steady or given over time;
//! * `residual_flexibility`: compliance that the elements lack at point forces.

pub mod alteration;
pub mod assembly;
mod chain;
pub mod equilibrium;
pub mod form_finding;
mod link_matrices;
mod loads;
mod newton;
mod relaxation;
mod residual_flexibility;
mod stretching;
mod wire_network;

pub use alteration::Alteration;
pub use assembly::{Geometry, Shape};
