//! SIMD layout of the points, and the kernels that step them.

pub(crate) mod axial_forces;
pub(crate) mod kernels;
pub(crate) mod pack;
pub(crate) mod packed;
#[cfg(test)]
mod packed_tests;
pub(crate) mod plan;
pub(crate) mod stripes;
pub(crate) mod sweep;
