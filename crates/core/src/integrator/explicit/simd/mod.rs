//! Points side by side in the lanes of the processor.

pub(crate) mod deal;
pub(crate) mod kernels;
pub(crate) mod plan;
pub(crate) mod rows;
#[cfg(test)]
mod rows_tests;
pub(crate) mod strands;
pub(crate) mod stretch;
pub(crate) mod sweep;
