//! Pantograph: a linear mechanical system, with nonlinear springs, dampers and stops, that travels
//! along the wire and presses against it.
//!
//!   m ü + c u̇ + k u = b p + g V(t)² + f(t) + a q − Σ e λ + Σ d σ
//!
//! f is the [excitation](crate::pantograph::excitation) (the base may move as well), q the force of
//! the [actuator](crate::pantograph::actuator), σ the forces of the
//! [stops](crate::pantograph::bump_stop) and of the [breakpoints](crate::pantograph::breakpoint) of
//! springs and dampers given by [tables](crate::pantograph::piecewise_force). `e` picks the height
//! of a [strip](crate::pantograph::strip), `b` is the direction of the constant preload p, `g` that
//! of forces proportional to the square of speed. Heights are measured from the height of the wire
//! where the run starts. The preload follows from the contact force required at the start, in
//! static equilibrium there; a spring between the first mass and the vehicle is thereby free of
//! force at the working height.

use crate::error::CoreError;
use crate::pantograph::actuator::Actuator;
use crate::pantograph::bump_stop::BumpStop;
use crate::pantograph::excitation::Excitation;
use crate::pantograph::piecewise_force::PiecewiseForce;
use crate::pantograph::strip::{self, Strip};

/// Description of a pantograph. Matrices are n × n, row by row; SI units.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Pantograph {
    /// Mass matrix, kg.
    pub mass: Vec<f64>,
    /// Damping matrix, N·s/m.
    pub damping: Vec<f64>,
    /// Stiffness matrix, N/m.
    pub stiffness: Vec<f64>,
    /// Contact strips, in the direction of travel.
    pub strips: Vec<Strip>,
    /// Direction b of the preload.
    pub preload: Vec<f64>,
    /// Force per squared speed g, N/(m/s)².
    pub lift: Vec<f64>,
    /// Contact force at the start, N, at the speed of the start: the sum over all contacts.
    pub start_force: f64,
    /// Forces and base motion given for the whole run.
    pub excitation: Excitation,
    /// One-sided stops.
    pub stops: Vec<BumpStop>,
    /// Springs and dampers given by tables, in addition to those in the matrices.
    pub piecewise_forces: Vec<PiecewiseForce>,
    /// Force controlled during the run.
    pub actuator: Option<Actuator>,
    /// True for one that a program outside moves: see
    /// [external pantograph](crate::pantograph::external). Its matrices are zero.
    pub is_external: bool,
}

impl Pantograph {
    /// Number n of degrees of freedom.
    #[must_use]
    pub fn size(&self) -> usize {
        self.preload.len()
    }

    /// Checks sizes and numbers.
    ///
    /// # Errors
    /// [`CoreError::Input`].
    pub fn check(&self) -> Result<(), CoreError> {
        let n = self.size();
        let matrices = [&self.mass, &self.damping, &self.stiffness];
        let vectors = [&self.preload, &self.lift];
        let sized =
            matrices.iter().all(|m| m.len() == n * n) && vectors.iter().all(|v| v.len() == n);
        let finite = matrices
            .iter()
            .chain(&vectors)
            .all(|m| m.iter().all(|v| v.is_finite()));
        let parts = self.excitation.is_valid(n)
            && self.stops.iter().all(|s| s.is_valid(n))
            && self.piecewise_forces.iter().all(|f| f.is_valid(n))
            && self.actuator.iter().all(|a| a.is_valid(n));
        if n == 0 || !sized || !finite || !parts || !self.start_force.is_finite() {
            let reason = "sizes disagree or a number is not finite";
            return Err(CoreError::invalid("pantographs", reason));
        }
        if self.is_external && !self.is_free_of_inner_forces() {
            let reason = "an external one with matrices or forces of its own";
            return Err(CoreError::invalid("pantographs", reason));
        }
        strip::check(&self.strips, n)
    }

    /// Forces on the coordinates at the start, N, without preload and contact forces.
    pub(crate) fn start_forces(&self, speed: f64) -> Vec<f64> {
        let excitation = self.excitation.start_forces(&self.stiffness, self.size());
        let lift = self.lift.iter().zip(excitation);
        lift.map(|(g, given)| g * speed * speed + given).collect()
    }
}
