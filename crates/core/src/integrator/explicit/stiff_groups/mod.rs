//! Stiff groups: points that links, struts and springs couple, treated implicitly.

pub(crate) mod apply;
pub(crate) mod batches;
pub(crate) mod grouping;
pub(crate) mod stiff_group;
pub(crate) mod ties;
