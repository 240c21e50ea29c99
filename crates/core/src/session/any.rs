//! Session on a line of any kind.

use crate::checkpoint::Checkpoint;
use crate::each_kind;
use crate::error::CoreError;
use crate::line::AnyWireModel;
use crate::pantograph::model::Pantograph;
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
    /// As there.
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
    /// As there.
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
    /// As there.
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

    /// Takes a step under forces: see [`Session::step`].
    ///
    /// # Errors
    /// As there.
    pub fn step(&mut self, forces: &[f64], position: f64, speed: f64) -> Result<(), CoreError> {
        each_kind!(self, Self, session => session.step(forces, position, speed))
    }

    /// Takes a step with given strips: see [`Session::step_strips`].
    ///
    /// # Errors
    /// As there.
    pub fn step_strips(
        &mut self,
        heights: &[f64],
        compliance: &[f64],
        position: f64,
        speed: f64,
    ) -> Result<(), CoreError> {
        each_kind!(self, Self, session => session.step_strips(heights, compliance, position, speed))
    }

    /// Finds the wire at the collectors in the coming step: see [`Session::compliance`].
    ///
    /// # Errors
    /// As there.
    pub fn compliance(&mut self, position: f64, speed: f64) -> Result<&Compliance, CoreError> {
        each_kind!(self, Self, session => session.compliance(position, speed))
    }

    /// Chooses the nodes whose uplift is read: see [`Session::watch`].
    ///
    /// # Errors
    /// As there.
    pub fn watch(&mut self, nodes: &[usize]) -> Result<(), CoreError> {
        each_kind!(self, Self, session => session.watch(nodes))
    }

    /// Outputs of the last step, or of the start.
    #[must_use]
    pub fn outputs(&self) -> &Outputs {
        each_kind!(self, Self, session => session.outputs())
    }

    /// Number of steps taken.
    #[must_use]
    pub fn steps(&self) -> usize {
        each_kind!(self, Self, session => session.steps())
    }

    /// Number of forces that a step needs; zero where strips are given.
    #[must_use]
    pub fn inputs(&self) -> usize {
        each_kind!(self, Self, session => session.inputs())
    }

    /// Number of nodes of the line.
    #[must_use]
    pub fn nodes(&self) -> usize {
        each_kind!(self, Self, session => session.nodes())
    }

    /// Displacements of all nodes from the static shape, m, node by node.
    #[must_use]
    pub fn displacements(&self) -> Vec<f64> {
        each_kind!(self, Self, session => session.displacements())
    }

    /// Position along the track in m, and speed in m/s.
    #[must_use]
    pub fn position_and_speed(&self) -> (f64, f64) {
        each_kind!(self, Self, session => session.position_and_speed())
    }

    /// Step length, s.
    #[must_use]
    pub fn step_length(&self) -> f64 {
        each_kind!(self, Self, session => session.step_length())
    }

    /// Weight α_f of the start of a step in its balance.
    #[must_use]
    pub fn old_weight(&self) -> f64 {
        each_kind!(self, Self, session => session.old_weight())
    }

    /// Flexibility 1/k_c of a contact, m/N.
    #[must_use]
    pub fn contact_flexibility(&self) -> f64 {
        each_kind!(self, Self, session => session.contact_flexibility())
    }

    /// Saves the state between two steps.
    ///
    /// # Errors
    /// None for a state that steps have left.
    pub fn save(&mut self) -> Result<Checkpoint, CoreError> {
        each_kind!(self, Self, session => session.save())
    }

    /// Restores a saved state: see [`Session::restore`].
    ///
    /// # Errors
    /// As there.
    pub fn restore(&mut self, saved: &Checkpoint) -> Result<(), CoreError> {
        each_kind!(self, Self, session => session.restore(saved))
    }
}
