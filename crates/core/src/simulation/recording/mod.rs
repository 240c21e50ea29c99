//! Recording of a run.

pub(crate) mod energy_balance;
mod finite_rows;
pub mod motion;
pub mod record;
pub(crate) mod recorder;
pub(crate) mod subgrid_height;
pub(crate) mod support_loads;
pub mod support_parts;
pub mod window;
