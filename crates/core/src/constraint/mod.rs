//! Unilateral constraints: contacts, slack links, stops, and the problem that they make together.

pub mod columns;
pub mod contacts;
pub(crate) mod coverage;
pub(crate) mod delassus;
pub(crate) mod link_table;
pub mod links;
pub mod problem;
pub(crate) mod row;
pub mod wires;
