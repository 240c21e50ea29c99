//! Integrators of the wires: one interface, three integrators behind it.
//!
//! No other folder depends on which one it is. A step is: [`WireModel::predict`], the motion
//! without contact forces and corrections; [`WireModel::apply`], as often as forces are found; and
//! [`WireModel::commit`].

pub mod energy;
pub mod explicit;
pub(crate) mod implicit;
pub mod state;
pub(crate) mod static_line;
pub mod updated_geometry;
pub mod wire_model;
