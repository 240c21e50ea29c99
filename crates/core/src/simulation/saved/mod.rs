//! Saved states.

pub(crate) mod resume;
