//! Pantographs: what travels along the wires and presses against them.

pub mod actuator;
pub(crate) mod branches;
pub mod breakpoint;
pub mod bump_stop;
pub mod energy;
pub(crate) mod equilibrium;
pub mod excitation;
pub(crate) mod half_steps;
pub mod piecewise_force;
#[cfg(test)]
mod piecewise_force_tests;
pub mod strip;
pub mod system;
