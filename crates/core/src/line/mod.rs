//! Lines at rest and lines prepared for steps, of the four kinds that there are: in the plane or
//! in space, of Hermite elements or of chains of point masses.
//!
//! ```text
//! Structure ─→ AnyLine (shape at rest) ─prepare→ AnyWireModel ─→ runs, AnySession
//! ```
//!
//! * [`at_rest`] — a line of one kind: geometry and static shape, and what is read from them;
//! * [`arrays`] — its lengths, forces and positions by their names;
//! * [`stepping`] — how it is to be stepped;
//! * [`any`] — a line of any kind.

pub mod any;
pub mod arrays;
pub mod at_rest;
pub mod stepping;

pub use any::{AnyLine, AnyWireModel};
pub use at_rest::LineAtRest;
pub use stepping::Stepping;
