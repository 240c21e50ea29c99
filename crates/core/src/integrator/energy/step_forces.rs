//! Forces of one step, for its energy balance.

use crate::constraint::contacts::Contacts;
use crate::constraint::problem::ConstraintProblem;
use crate::linear::loads::Loads;

/// Forces of one step that its energy balance reads besides the states before and after.
#[derive(Debug)]
pub struct StepForces<'a, const DIM: usize> {
    /// Contacts.
    pub contacts: &'a Contacts<DIM>,
    /// Contact forces and corrections of the step.
    pub problem: &'a ConstraintProblem,
    /// Friction force along the wire at each contact, N.
    pub friction: &'a [f64],
    /// Loads on the line at the time of balance.
    pub(crate) loads: Loads<'a>,
    /// Datum of the heights of strips, m.
    pub datum: f64,
}
