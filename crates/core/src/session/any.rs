//! Session on a line of any kind.

use crate::checkpoint::Checkpoint;
use crate::each_kind;
use crate::error::CoreError;
use crate::line::AnyWireModel;
use crate::pantograph::model::Pantograph;
use crate::session::alone::AloneStart;
use crate::session::{Collector, Compliance, Outputs, Session, SessionStart};

/// Session on a line in the plane or in space, of Hermite elements or of chains.
#[derive(Debug)]
pub enum AnySession {
    /// Along and up, Hermite elements.
    Planar(Session<2, 4>),
    /// Along, across and up, Hermite elements.
    Spatial(Session<3, 6>),
    /// Along and up, chains of point masses.
    PlanarChain(Session<2, 2>),
    /// Along, across and up, chains of point masses.
    SpatialChain(Session<3, 3>),
}

impl AnySession {
    /// Session with given forces: see [`Session::with_forces`].
    ///
    /// # Errors
    /// [`CoreError::Input`]: no collector, several slidelines, updated kinematics;
    /// [`CoreError::OffWire`], or any error of a static solution.
    pub fn with_forces(
        line: &AnyWireModel,
        collectors: Vec<Collector>,
        forces: &[f64],
        start: SessionStart,
    ) -> Result<Self, CoreError> {
        each_kind!(line, AnyWireModel => Self, p => {
            Session::with_forces(p.clone(), collectors, forces, start)
        })
    }

    /// Session with simulated pantographs: see [`Session::with_pantographs`].
    ///
    /// # Errors
    /// [`CoreError::Input`]: excitation for a whole run, an actuator with a delay, or updated
    /// kinematics; or any error of the start of a run.
    pub fn with_pantographs(
        line: &AnyWireModel,
        pantographs: Vec<Pantograph>,
        distances: Vec<f64>,
        start: SessionStart,
    ) -> Result<Self, CoreError> {
        each_kind!(line, AnyWireModel => Self, p => {
            Session::with_pantographs(p.clone(), pantographs, distances, start)
        })
    }

    /// Session with given strips: see [`Session::with_strips`].
    ///
    /// # Errors
    /// [`CoreError::Input`]: a pantograph that is not external, or updated kinematics; or any error
    /// of the start of a run.
    pub fn with_strips(
        line: &AnyWireModel,
        pantographs: Vec<Pantograph>,
        distances: Vec<f64>,
        start: SessionStart,
    ) -> Result<Self, CoreError> {
        each_kind!(line, AnyWireModel => Self, p => {
            Session::with_strips(p.clone(), pantographs, distances, start)
        })
    }
}

/// Defines methods of [`AnySession`] that are those of the session in it.
macro_rules! passed_on {
    ($($(#[$documentation:meta])* fn $name:ident(
        $self:ident: $receiver:ty $(, $argument:ident: $type:ty)*
    ) -> $result:ty;)*) => {
        impl AnySession {
            $(
                $(#[$documentation])*
                pub fn $name($self: $receiver, $($argument: $type),*) -> $result {
                    each_kind!($self, Self, session => session.$name($($argument),*))
                }
            )*
        }
    };
}

passed_on! {
    /// Takes a step under forces: see [`Session::step`].
    ///
    /// # Errors
    /// [`CoreError::Input`], or any [`CoreError`] that a step can raise.
    fn step(self: &mut Self, forces: &[f64], position: f64, speed: f64) -> Result<(), CoreError>;

    /// Takes a step with given strips: see [`Session::step_strips`].
    ///
    /// # Errors
    /// [`CoreError::Input`], or any [`CoreError`] that a step can raise.
    fn step_strips(
        self: &mut Self, heights: &[f64], compliance: &[f64], position: f64, speed: f64
    ) -> Result<(), CoreError>;

    /// Finds the wire at the collectors in the coming step: see [`Session::compliance`].
    ///
    /// # Errors
    /// [`CoreError::Input`] where no forces are given, or any [`CoreError`] that a step can raise.
    fn compliance(self: &mut Self, position: f64, speed: f64) -> Result<&Compliance, CoreError>;

    /// Finds the wire about other forces: see [`Session::compliance_about`].
    ///
    /// # Errors
    /// [`CoreError::Input`] where no forces are given, or for forces that are not finite or not one
    /// for each collector; or any [`CoreError`] that a step can raise.
    fn compliance_about(
        self: &mut Self, forces: &[f64], position: f64, speed: f64
    ) -> Result<&Compliance, CoreError>;

    /// Chooses the nodes whose uplift is read: see [`Session::watch`].
    ///
    /// # Errors
    /// [`CoreError::Input`] for a node that does not exist, or after a step.
    fn watch(self: &mut Self, nodes: &[usize]) -> Result<(), CoreError>;

    /// Outputs of the last step, or of the start.
    #[must_use]
    fn outputs(self: &Self) -> &Outputs;

    /// Number of steps taken.
    #[must_use]
    fn steps(self: &Self) -> usize;

    /// Number of forces that a step needs; zero where strips are given.
    #[must_use]
    fn inputs(self: &Self) -> usize;

    /// Number of nodes of the line.
    #[must_use]
    fn nodes(self: &Self) -> usize;

    /// Displacements of all nodes from the static shape, m, node by node.
    #[must_use]
    fn displacements(self: &Self) -> Vec<f64>;

    /// Position along the track in m, and speed in m/s.
    #[must_use]
    fn position_and_speed(self: &Self) -> (f64, f64);

    /// Step length, s.
    #[must_use]
    fn step_length(self: &Self) -> f64;

    /// Weight α_f of the start of a step in its balance.
    #[must_use]
    fn old_weight(self: &Self) -> f64;

    /// Flexibility 1/k_c of a contact, m/N.
    #[must_use]
    fn contact_flexibility(self: &Self) -> f64;

    /// Saves the state between two steps.
    ///
    /// # Errors
    /// None for a state that steps have left.
    fn save(self: &mut Self) -> Result<Checkpoint, CoreError>;

    /// Restores a saved state: see [`Session::restore`].
    ///
    /// # Errors
    /// [`CoreError::Input`] for a state of another session; the present one is then kept.
    fn restore(self: &mut Self, saved: &Checkpoint) -> Result<(), CoreError>;

    /// Simulated pantograph by itself: see [`Session::standing_alone`].
    #[must_use]
    fn standing_alone(self: &Self, number: usize) -> Option<(Pantograph, AloneStart)>;
}
