//! Chains of point masses, from the structure to numbers of points.

pub(crate) mod along;
pub(crate) mod bends;
pub(crate) mod blocks;
pub(crate) mod layout;
pub(crate) mod waves;
