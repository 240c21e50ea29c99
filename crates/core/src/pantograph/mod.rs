//! Pantographs, which travel along the wires and press against them.

pub mod actuator;
pub mod breakpoint;
pub mod bump_stop;
pub mod energy;
pub mod equilibrium;
pub mod excitation;
pub mod external;
pub(crate) mod half_steps;
pub mod model;
pub mod piecewise_force;
pub mod state;
pub mod strip;
