//! Energy balance of a run.

pub(crate) mod contact_energy;
pub mod explicit;
pub(crate) mod explicit_contacts;
pub(crate) mod explicit_links;
pub mod implicit;
pub mod step_forces;
