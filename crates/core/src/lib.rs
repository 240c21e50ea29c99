//! Numerical core of Arcless: numbers in, numbers out. It knows no files, no names, no printing.
//!
//! The arrow of the core:
//!
//! ```text
//! Structure ─→ Geometry ─→ shape (static equilibrium) ─→ LinearModel ─→ WireModel ─→ Model
//!                                                                         Model ─step─→ Record
//! ```
//!
//! * [`structure`] — wires, links, springs and masses as plain data;
//! * [`statics`] — positions from lengths, or lengths from positions;
//! * [`linear`] — matrices about the equilibrium, static response, natural frequencies;
//! * [`slideline`] — wires that contacts run along;
//! * [`pantograph`] — pantographs that travel along them;
//! * [`constraint`] — contacts, slack links and stops: one [`lcp`] per step;
//! * [`integrator`] — how wires take a step, and the energy balance;
//! * [`line`] — lines at rest and lines ready for steps, of any kind;
//! * [`simulation`] — model, state, and the [step](simulation::step::step) between two states;
//!   runs;
//! * [`session`] — single steps, driven from outside;
//! * [`element`], [`linalg`], [`scheme`], [`residual_flexibility`] — the parts of these;
//! * [`filter`] — recursive filters for recorded signals; [`checkpoint`] — states as plain numbers.
//!
//! `DIM` is the number of components of space (2 or 3), `D` the unknowns of a node: `2·DIM`
//! (position and slope) where wires are Hermite elements, `DIM` where they are chains of point
//! masses.

pub mod checkpoint;
pub mod constraint;
pub mod element;
pub mod energy_terms;
pub mod error;
pub mod filter;
pub mod integrator;
pub mod lcp;
pub mod linalg;
pub mod line;
pub mod linear;
pub mod pantograph;
pub mod residual_flexibility;
pub mod scheme;
pub mod session;
pub mod simulation;
pub mod slideline;
pub mod statics;
pub mod structure;
mod structure_check;

pub use error::CoreError;

// The tests are compiled with the library, and name it as its users do: a program of their own
// would compile the generic code of the core a second time.
#[cfg(test)]
extern crate self as arcless_core;
#[cfg(test)]
#[path = "../tests/all.rs"]
mod tests;
