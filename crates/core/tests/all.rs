//! All tests of the core in one program: in parts, each would compile its generic code anew.

mod alteration;
mod border;
mod common;
mod contact;
mod contacts;
mod control;
mod dynamics;
mod equivalence;
mod hostile;
mod hostile_input;
mod lanes;
mod laws;
mod lcp;
mod lcp_oracle;
mod ledger;
mod live;
mod loads;
mod lumped;
mod pieces;
mod published;
mod resume;
mod rider;
mod scheme;
mod statics;
mod untensioned;
mod updated;
