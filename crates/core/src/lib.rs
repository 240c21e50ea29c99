//! Numerical core of Arcless: numbers in, numbers out. It knows no files, no names, no printing.
//!
//! The arrow of the core:
//!
//! ```text
//! Structure ─→ Geometry ─→ shape (static equilibrium) ─→ Line (linearised) ─→ Prepared ─→ Record
//! ```
//!
//! * [`structure`] — wires, links, springs and masses as plain data;
//! * [`statics`] — positions from lengths, or lengths from positions;
//! * [`dynamics`] — steps about the equilibrium, everything unilateral in one [`lcp`] per step;
//! * [`element`], [`linalg`], [`scheme`] — what these are made of;
//! * [`filter`] — recursive filters for what was recorded.
//!
//! `DIM` is the number of components of space (2 or 3), `D` the unknowns of a node: `2·DIM` (position
//! and slope) where wires are Hermite elements, `DIM` where they are chains of point masses.

pub mod dynamics;
pub mod element;
pub mod error;
pub mod filter;
pub mod flexibility;
pub mod lcp;
pub mod linalg;
pub mod scheme;
pub mod statics;
pub mod structure;
mod structure_check;

pub use error::CoreError;

// Tests of what is private use the lines of the other tests, which name this library.
#[cfg(test)]
extern crate self as arcless_core;
#[cfg(test)]
#[path = "../tests/common/mod.rs"]
mod common;
