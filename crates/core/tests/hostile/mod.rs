//! Input that means harm: any bytes become arrays at the border of the core, or a complementarity
//! problem. What comes back is an error or finite numbers; a panic or a number that is not finite
//! is a finding.
//!
//! Bytes are read as decisions about a sound line (how many elements, which scheme, …) and then as
//! what is spoilt in it; bytes of zero mean "sound". So a mutation of bytes is a small change of
//! the input, and most inputs come far.
#![allow(dead_code)] // every user takes a part

pub mod border;
pub mod feed;
pub mod finite;
pub mod lcp;
pub mod motion;
pub mod pantographs;
pub mod stepping;
pub mod structure;
