//! Motion about the static equilibrium: constant M, C, K; everything unilateral in one linear
//! complementarity problem per step.

pub mod actuator;
mod close;
pub mod columns;
pub mod contact;
mod contact_energy;
pub mod contacts;
mod control;
mod elasticity;
pub mod entries;
pub mod given;
mod influence;
pub mod kink;
pub mod law;
#[cfg(test)]
mod law_tests;
pub mod ledger;
pub mod line;
pub mod links;
pub mod loads;
mod modes;
pub mod near;
pub mod part;
pub mod path;
mod path_element;
pub mod place;
mod reach;
pub mod record;
mod rest;
mod resume;
pub mod rider;
pub mod rider_energy;
mod rider_kinks;
pub mod run;
mod share;
mod standing;
mod start;
pub mod state;
pub mod stepper;
pub mod still;
pub mod stop;
pub mod strip;
pub mod updated;
mod watch;
