//! Records of a run.

pub mod record;
pub(crate) mod recorder;
pub(crate) mod subgrid_height;
pub mod window;
