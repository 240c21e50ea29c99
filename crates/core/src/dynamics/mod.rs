//! Motion about the static equilibrium: constant M, C, K; everything unilateral in one linear
//! complementarity problem per step.

pub mod actuator;
mod close;
pub mod columns;
pub mod contact;
mod control;
mod elasticity;
pub mod given;
pub mod kink;
pub mod law;
#[cfg(test)]
mod law_tests;
pub mod ledger;
pub mod line;
pub mod links;
pub mod loads;
pub mod path;
pub mod place;
pub mod record;
mod rest;
pub mod rider;
pub mod rider_energy;
mod rider_kinks;
pub mod run;
pub mod stepper;
pub mod still;
pub mod stop;
pub mod updated;
