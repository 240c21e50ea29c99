//! Everything that a session is made of, as plain data: a session made of them again, here or on
//! another machine of the same kind, takes the same steps bit for bit.

use crate::error::CoreError;
use crate::line::{AnyLine, Stepping};
use crate::pantograph::model::Pantograph;
use crate::session::{AnySession, Collector, SessionStart};
use crate::structure::Structure;

/// Line at rest, its steps, what presses against it, and the start.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Prepared {
    /// Structure, with lengths that the design has found.
    pub structure: Structure,
    /// Static shape, node by node: position and slope, m.
    pub shape: Vec<f64>,
    /// Wire elements of each lane in the order of the track.
    pub lanes: Vec<Vec<usize>>,
    /// Scheme, step length and contact.
    pub stepping: Stepping,
    /// Forces, pantographs or strips that press against the line.
    pub drive: Drive,
    /// Position, speed and friction at the start.
    pub start: SessionStart,
    /// Nodes whose uplift is read.
    pub watched: Vec<usize>,
}

/// Forces, pantographs or strips that press against a line: the kinds of
/// [session](crate::session).
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Drive {
    /// Given forces.
    Forces {
        /// Collectors.
        collectors: Vec<Collector>,
        /// Force of each at the start, N.
        forces: Vec<f64>,
    },
    /// Simulated pantographs.
    Pantographs {
        /// Pantographs.
        pantographs: Vec<Pantograph>,
        /// Distance of each behind the first, m.
        distances: Vec<f64>,
    },
    /// Given strips.
    Strips {
        /// External pantographs.
        pantographs: Vec<Pantograph>,
        /// Distance of each behind the first, m.
        distances: Vec<f64>,
    },
}

impl Prepared {
    /// Data of a session on a line at rest.
    #[must_use]
    pub fn new(
        line: &AnyLine,
        lanes: Vec<Vec<usize>>,
        stepping: Stepping,
        drive: Drive,
        start: SessionStart,
        watched: Vec<usize>,
    ) -> Self {
        Self {
            structure: line.structure().clone(),
            shape: line.shape_numbers(),
            lanes,
            stepping,
            drive,
            start,
            watched,
        }
    }

    /// Makes the session at its start.
    ///
    /// # Errors
    /// [`CoreError::Input`] for data that do not fit one another, or any error of the start.
    pub fn session(&self) -> Result<AnySession, CoreError> {
        let line = AnyLine::from_known(self.structure.clone(), &self.shape)?;
        let line = line.prepare(&self.lanes, &self.stepping)?;
        let start = self.start;
        let mut session = match &self.drive {
            Drive::Forces { collectors, forces } => {
                AnySession::with_forces(&line, collectors.clone(), forces, start)
            }
            Drive::Pantographs {
                pantographs,
                distances,
            } => AnySession::with_pantographs(&line, pantographs.clone(), distances.clone(), start),
            Drive::Strips {
                pantographs,
                distances,
            } => AnySession::with_strips(&line, pantographs.clone(), distances.clone(), start),
        }?;
        if !self.watched.is_empty() {
            session.watch(&self.watched)?;
        }
        Ok(session)
    }
}
