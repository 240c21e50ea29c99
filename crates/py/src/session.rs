//! Real-time session: a line stepped from outside, one call for each step, into arrays that stay.

use crate::error::convert;
use crate::model::{Any, WireModel};
use crate::pantographs::{PantographData, pantograph};
use crate::records::numbers;
use arcless_core::CoreError;
use arcless_core::checkpoint::Checkpoint;
use arcless_core::integrator::wire_model;
use arcless_core::pantograph::model::Pantograph;
use arcless_core::session::{self, Collector, SessionStart};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1, PyReadwriteArray1, ToPyArray};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Session on a line in two or three dimensions; see [`Any`].
enum AnySession {
    Planar(session::Session<2, 4>),
    Spatial(session::Session<3, 6>),
    PlanarChain(session::Session<2, 2>),
    SpatialChain(session::Session<3, 3>),
}

/// Call a method of whichever variant is there.
macro_rules! either {
    ($any:expr, $session:ident => $body:expr) => {
        match $any {
            AnySession::Planar($session) => $body,
            AnySession::Spatial($session) => $body,
            AnySession::PlanarChain($session) => $body,
            AnySession::SpatialChain($session) => $body,
        }
    };
}

// Python's objects are aligned to 16 bytes, and what lies in them is stepped where it lies.
const _: () = assert!(align_of::<AnySession>() <= 16);

/// Line stepped from outside. Made by the class methods.
#[pyclass]
pub struct Session(AnySession);

#[derive(FromPyObject)]
struct StartData {
    position: f64,
    speed: f64,
    friction: f64,
}

impl From<StartData> for SessionStart {
    fn from(data: StartData) -> Self {
        Self {
            position: data.position,
            speed: data.speed,
            friction: data.friction,
        }
    }
}

#[derive(FromPyObject)]
struct CollectorData {
    behind: f64,
    half_width: f64,
}

type Made<const DIM: usize, const D: usize> = Result<session::Session<DIM, D>, CoreError>;

#[pymethods]
impl Session {
    /// Forces given, for each collector that in N at the start.
    #[staticmethod]
    #[pyo3(signature = (*, line, collectors, forces, start))]
    fn with_forces(
        py: Python<'_>,
        line: &WireModel,
        collectors: Vec<CollectorData>,
        forces: Vec<f64>,
        start: StartData,
    ) -> PyResult<Self> {
        let collectors = collectors.into_iter();
        let collector = |CollectorData { behind, half_width }| Collector { behind, half_width };
        let collectors: Vec<Collector> = collectors.map(collector).collect();
        fn make<const DIM: usize, const D: usize>(
            p: &Arc<wire_model::WireModel<DIM, D>>,
            collectors: Vec<Collector>,
            forces: &[f64],
            start: StartData,
        ) -> Made<DIM, D> {
            session::Session::with_forces(p.clone(), collectors, forces, start.into())
        }
        let found = py.detach(|| match &line.0 {
            Any::Planar(p) => make(p, collectors, &forces, start).map(AnySession::Planar),
            Any::Spatial(p) => make(p, collectors, &forces, start).map(AnySession::Spatial),
            Any::PlanarChain(p) => make(p, collectors, &forces, start).map(AnySession::PlanarChain),
            Any::SpatialChain(p) => {
                make(p, collectors, &forces, start).map(AnySession::SpatialChain)
            }
        });
        found.map(Self).map_err(|e| convert(py, &e))
    }

    /// Session with simulated pantographs at `distances` (m) behind the first; their actuators take
    /// no answer from a controller.
    #[staticmethod]
    #[pyo3(signature = (*, line, pantographs, distances, start))]
    fn with_pantographs(
        py: Python<'_>,
        line: &WireModel,
        pantographs: Vec<PantographData>,
        distances: Vec<f64>,
        start: StartData,
    ) -> PyResult<Self> {
        let pantographs = pantographs.into_iter();
        let pantographs = pantographs.map(|data| Ok(pantograph(data)?.pantograph));
        let pantographs = pantographs.collect::<PyResult<Vec<_>>>()?;
        fn make<const DIM: usize, const D: usize>(
            p: &Arc<wire_model::WireModel<DIM, D>>,
            (pantographs, distances): (Vec<Pantograph>, Vec<f64>),
            start: StartData,
        ) -> Made<DIM, D> {
            session::Session::with_pantographs(p.clone(), pantographs, distances, start.into())
        }
        let what = (pantographs, distances);
        let found = py.detach(|| match &line.0 {
            Any::Planar(p) => make(p, what, start).map(AnySession::Planar),
            Any::Spatial(p) => make(p, what, start).map(AnySession::Spatial),
            Any::PlanarChain(p) => make(p, what, start).map(AnySession::PlanarChain),
            Any::SpatialChain(p) => make(p, what, start).map(AnySession::SpatialChain),
        });
        found.map(Self).map_err(|e| convert(py, &e))
    }

    /// Session with given strips, those of external pantographs at `distances` (m) behind the
    /// first; programs that they bring are not called.
    #[staticmethod]
    #[pyo3(signature = (*, line, pantographs, distances, start))]
    fn with_strips(
        py: Python<'_>,
        line: &WireModel,
        pantographs: Vec<PantographData>,
        distances: Vec<f64>,
        start: StartData,
    ) -> PyResult<Self> {
        let pantographs = pantographs.into_iter();
        let pantographs = pantographs.map(|data| Ok(pantograph(data)?.pantograph));
        let pantographs = pantographs.collect::<PyResult<Vec<_>>>()?;
        fn make<const DIM: usize, const D: usize>(
            p: &Arc<wire_model::WireModel<DIM, D>>,
            (pantographs, distances): (Vec<Pantograph>, Vec<f64>),
            start: StartData,
        ) -> Made<DIM, D> {
            session::Session::with_strips(p.clone(), pantographs, distances, start.into())
        }
        let what = (pantographs, distances);
        let found = py.detach(|| match &line.0 {
            Any::Planar(p) => make(p, what, start).map(AnySession::Planar),
            Any::Spatial(p) => make(p, what, start).map(AnySession::Spatial),
            Any::PlanarChain(p) => make(p, what, start).map(AnySession::PlanarChain),
            Any::SpatialChain(p) => make(p, what, start).map(AnySession::SpatialChain),
        });
        found.map(Self).map_err(|e| convert(py, &e))
    }

    /// Take a step with given strips that ends at `position` (m) with `speed` (m/s): heights at its
    /// end without contact (m), compliances (m/N) row by row, of all pantographs one after the
    /// other; write what it leaves into `out`, see `read`.
    fn step_strips(
        &mut self,
        py: Python<'_>,
        heights: PyReadonlyArray1<'_, f64>,
        compliance: PyReadonlyArray1<'_, f64>,
        position: f64,
        speed: f64,
        out: PyReadwriteArray1<'_, f64>,
    ) -> PyResult<()> {
        let (z, s) = (heights.as_slice()?, compliance.as_slice()?);
        let taken = either!(&mut self.0, session => session.step_strips(z, s, position, speed));
        taken.map_err(|e| convert(py, &e))?;
        self.read(out)
    }

    /// Heights of the strips of external pantographs at the end of the last step, m.
    fn strip_heights<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        let outputs = either!(&self.0, session => session.outputs());
        outputs.strip_height.to_pyarray(py)
    }

    /// Take a step that ends at `position` (m) with `speed` (m/s) under `forces` (N), and write
    /// what it leaves into `out`, see `read`.
    ///
    /// The interpreter is not released: that would cost more jitter than the step takes.
    fn step(
        &mut self,
        py: Python<'_>,
        forces: PyReadonlyArray1<'_, f64>,
        position: f64,
        speed: f64,
        out: PyReadwriteArray1<'_, f64>,
    ) -> PyResult<()> {
        let forces = forces.as_slice()?;
        let taken = either!(&mut self.0, session => session.step(forces, position, speed));
        taken.map_err(|e| convert(py, &e))?;
        self.read(out)
    }

    /// Write the result of the last step: force in N, height and lateral position in m, rate of the
    /// height in m/s, each for all contacts; displacement in m and velocity in m/s of all
    /// coordinates of pantographs.
    fn read(&self, mut out: PyReadwriteArray1<'_, f64>) -> PyResult<()> {
        let reading = either!(&self.0, session => session.outputs());
        let r = reading;
        let parts = [
            &r.force,
            &r.height,
            &r.lateral,
            &r.rate,
            &r.displacement,
            &r.velocity,
        ];
        let out = out.as_slice_mut()?;
        if out.len() != parts.iter().map(|part| part.len()).sum::<usize>() {
            return Err(PyValueError::new_err(
                "out: not the length that `sizes` tells",
            ));
        }
        let mut first = 0;
        for part in parts {
            out[first..first + part.len()].copy_from_slice(part);
            first += part.len();
        }
        Ok(())
    }

    /// Numbers of contacts and of coordinates of all pantographs.
    fn sizes(&self) -> (usize, usize) {
        let reading = either!(&self.0, session => session.outputs());
        (reading.force.len(), reading.velocity.len())
    }

    /// Contacts: pantograph, strip and lane of each; none where forces are given.
    fn contacts(&self) -> Vec<[usize; 3]> {
        either!(&self.0, session => session.outputs().contacts.clone())
    }

    /// Displacements of all nodes of the line from rest, m, node by node: along, across (in space
    /// only), up.
    fn displacements<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        either!(&self.0, session => session.displacements()).into_pyarray(py)
    }

    /// Steps taken, position in m, speed in m/s.
    fn place(&self) -> (usize, f64, f64) {
        let (position, speed) = either!(&self.0, session => session.position_and_speed());
        (
            either!(&self.0, session => session.steps()),
            position,
            speed,
        )
    }

    /// Steps taken, and the state as numbers by name.
    fn take_down<'py>(&mut self, py: Python<'py>) -> PyResult<(usize, Bound<'py, PyDict>)> {
        let state = either!(&mut self.0, session => session.save());
        let state = state.map_err(|e| convert(py, &e))?;
        Ok((state.step, numbers(py, &state)?))
    }

    /// Restore a state.
    fn put_back(
        &mut self,
        py: Python<'_>,
        state: (usize, BTreeMap<String, Vec<f64>>),
    ) -> PyResult<()> {
        let (step, numbers) = state;
        let state = Checkpoint { step, numbers };
        either!(&mut self.0, session => session.restore(&state)).map_err(|e| convert(py, &e))
    }
}
