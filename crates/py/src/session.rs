//! Real-time session: a line stepped from outside, one call for each step, into arrays that stay.

use crate::error::convert;
use crate::model::WireModel;
use crate::pantographs::{PantographData, pantograph};
use crate::records::numbers;
use arcless_core::checkpoint::Checkpoint;
use arcless_core::session::{AnySession, Collector, Outputs, SessionStart};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1, PyReadwriteArray1, ToPyArray};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::collections::BTreeMap;

// Python's objects are aligned to 16 bytes, and what lies in them is stepped where it lies.
const _: () = assert!(align_of::<AnySession>() <= 16);

/// Number of values that a step leaves.
pub(crate) fn width(outputs: &Outputs) -> usize {
    4 * outputs.force.len() + 2 * outputs.velocity.len()
}

/// Writes what a step leaves into an array of [`width`] values.
pub(crate) fn write(outputs: &Outputs, out: &mut [f64]) {
    let parts = [
        &outputs.force,
        &outputs.height,
        &outputs.lateral,
        &outputs.rate,
        &outputs.displacement,
        &outputs.velocity,
    ];
    let mut first = 0;
    for part in parts {
        out[first..first + part.len()].copy_from_slice(part);
        first += part.len();
    }
}

/// Line stepped from outside. Made by the class methods.
#[pyclass]
pub struct Session(pub(crate) AnySession);

type Floats<'py> = Bound<'py, PyArray1<f64>>;

#[derive(FromPyObject)]
pub struct StartData {
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
pub struct CollectorData {
    behind: f64,
    half_width: f64,
}

/// Collectors of the core.
pub fn collectors(data: Vec<CollectorData>) -> Vec<Collector> {
    let collector = |CollectorData { behind, half_width }| Collector { behind, half_width };
    data.into_iter().map(collector).collect()
}

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
        let collectors = self::collectors(collectors);
        let found =
            py.detach(|| AnySession::with_forces(&line.0, collectors, &forces, start.into()));
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
        let found = py
            .detach(|| AnySession::with_pantographs(&line.0, pantographs, distances, start.into()));
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
        let found =
            py.detach(|| AnySession::with_strips(&line.0, pantographs, distances, start.into()));
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
        let taken = self.0.step_strips(z, s, position, speed);
        taken.map_err(|e| convert(py, &e))?;
        self.read(out)
    }

    /// Wire at the collectors at the time of balance of the coming step, which is to end at
    /// `position` (m) with `speed` (m/s), about `forces` (N): heights in m if none pressed in it,
    /// and their matrix of m/N row by row.
    fn compliance<'py>(
        &mut self,
        py: Python<'py>,
        forces: PyReadonlyArray1<'_, f64>,
        position: f64,
        speed: f64,
    ) -> PyResult<(Floats<'py>, Floats<'py>)> {
        let found = self.0.compliance_about(forces.as_slice()?, position, speed);
        let found = found.map_err(|e| convert(py, &e))?;
        let [heights, matrix] = [&found.free_height, &found.matrix];
        Ok((heights.to_pyarray(py), matrix.to_pyarray(py)))
    }

    /// Choose the nodes whose uplift is read, before the first step.
    fn watch(&mut self, py: Python<'_>, nodes: Vec<usize>) -> PyResult<()> {
        self.0.watch(&nodes).map_err(|e| convert(py, &e))
    }

    /// Uplift of the watched nodes at the end of the last step, m.
    fn uplift<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.0.outputs().uplift.to_pyarray(py)
    }

    /// Heights of the strips of external pantographs at the end of the last step, m.
    fn strip_heights<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        let outputs = self.0.outputs();
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
        let taken = self.0.step(forces, position, speed);
        taken.map_err(|e| convert(py, &e))?;
        self.read(out)
    }

    /// Write the result of the last step: force in N, height and lateral position in m, rate of the
    /// height in m/s, each for all contacts; displacement in m and velocity in m/s of all
    /// coordinates of pantographs.
    fn read(&self, mut out: PyReadwriteArray1<'_, f64>) -> PyResult<()> {
        let (outputs, out) = (self.0.outputs(), out.as_slice_mut()?);
        if out.len() != width(outputs) {
            return Err(PyValueError::new_err(
                "out: not the length that `sizes` tells",
            ));
        }
        write(outputs, out);
        Ok(())
    }

    /// Numbers of contacts and of coordinates of all pantographs.
    fn sizes(&self) -> (usize, usize) {
        let reading = self.0.outputs();
        (reading.force.len(), reading.velocity.len())
    }

    /// Contacts: pantograph, strip and lane of each; none where forces are given.
    fn contacts(&self) -> Vec<[usize; 3]> {
        self.0.outputs().contacts.clone()
    }

    /// Displacements of all nodes of the line from rest, m, node by node: along, across (in space
    /// only), up.
    fn displacements<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.0.displacements().into_pyarray(py)
    }

    /// Steps taken, position in m, speed in m/s.
    fn place(&self) -> (usize, f64, f64) {
        let (position, speed) = self.0.position_and_speed();
        (self.0.steps(), position, speed)
    }

    /// Steps taken, and the state as numbers by name.
    fn take_down<'py>(&mut self, py: Python<'py>) -> PyResult<(usize, Bound<'py, PyDict>)> {
        let state = self.0.save();
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
        self.0.restore(&state).map_err(|e| convert(py, &e))
    }
}
