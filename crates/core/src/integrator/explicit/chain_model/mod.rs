//! Chains of point masses, from the structure to numbers of points.

pub(crate) mod axial;
pub(crate) mod bends;
pub(crate) mod blocks;
pub(crate) mod builder;
pub(crate) mod dispersion;
pub(crate) mod layout;
pub(crate) mod parts;
