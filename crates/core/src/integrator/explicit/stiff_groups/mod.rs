//! Groups of points that stiff links, struts and springs join: implicit.

pub(crate) mod apply;
pub(crate) mod batches;
pub(crate) mod cluster;
pub(crate) mod clusters;
pub(crate) mod ties;
