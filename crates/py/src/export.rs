//! Models for other programs: lines and pantographs as the bytes that `arcless_loop` opens.

use crate::equilibrium::{Equilibrium, SteppingData};
use crate::error::convert;
use crate::pantographs::{PantographData, pantograph};
use crate::session::{CollectorData, Session, StartData, collectors};
use arcless_core::pantograph::excitation::BaseMotion;
use arcless_core::session::{Drive, Prepared};
use arcless_device::line::{LineDevice, LineModel, OnLine, Travel};
use arcless_device::model::{Model, Part};
use arcless_device::pantograph::{PantographDevice, PantographModel};
use arcless_device::{Failure, Stepper, file};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

/// Load of an exported line: collectors with their forces, or pantographs.
#[derive(FromPyObject)]
pub struct DriveData {
    collectors: Vec<CollectorData>,
    forces: Vec<f64>,
    pantographs: Vec<PantographData>,
    distances: Vec<f64>,
}

/// Pantograph on an exported line.
#[derive(FromPyObject)]
pub struct OnLineData {
    name: String,
    strips: usize,
    heights: Vec<(usize, String)>,
}

fn drive(data: DriveData) -> PyResult<Drive> {
    if data.pantographs.is_empty() {
        return Ok(Drive::Forces {
            collectors: collectors(data.collectors),
            forces: data.forces,
        });
    }
    let pantographs = data.pantographs.into_iter();
    let pantographs = pantographs.map(|data| Ok(pantograph(data)?.pantograph));
    let pantographs = pantographs.collect::<PyResult<Vec<_>>>()?;
    let distances = data.distances;
    Ok(if pantographs.iter().all(|p| p.is_external) {
        Drive::Strips {
            pantographs,
            distances,
        }
    } else {
        Drive::Pantographs {
            pantographs,
            distances,
        }
    })
}

fn refused(failure: Failure) -> PyErr {
    PyValueError::new_err(failure.message)
}

fn packed(py: Python<'_>, part: Part) -> PyResult<Bound<'_, PyBytes>> {
    let bytes = file::pack(&Model::new(part)).map_err(refused)?;
    Ok(PyBytes::new(py, &bytes))
}

/// Model of a line with what presses against it; `travel` is `position` or `speed`, `watched` are
/// the nodes of `supports` whose uplift is read.
#[pyfunction]
#[pyo3(signature = (*, line, lanes, stepping, drive, start, travel, pantographs, watched, supports))]
pub fn exported_line<'py>(
    py: Python<'py>,
    line: &Equilibrium,
    lanes: Vec<Vec<usize>>,
    stepping: SteppingData,
    drive: DriveData,
    start: StartData,
    travel: &str,
    pantographs: Vec<OnLineData>,
    watched: Vec<usize>,
    supports: Vec<String>,
) -> PyResult<Bound<'py, PyBytes>> {
    let travel = match travel {
        "position" => Travel::Position,
        "speed" => Travel::Speed,
        _ => return Err(PyValueError::new_err("travel: position or speed")),
    };
    let (stepping, drive) = (stepping.stepping()?, self::drive(drive)?);
    let pantographs = pantographs.into_iter().map(|p| OnLine {
        name: p.name,
        strips: p.strips,
        heights: p.heights,
    });
    let model = LineModel {
        prepared: Prepared::new(&line.0, lanes, stepping, drive, start.into(), watched),
        travel,
        pantographs: pantographs.collect(),
        supports,
    };
    let tried = py.detach(|| LineDevice::new(model.clone()));
    tried.map_err(|e| convert(py, &e))?;
    packed(py, Part::Line(Box::new(model)))
}

/// Model of pantograph `number` of a session that stands at its start; a displacement of its base
/// raises the coordinates by `influence`.
#[pyfunction]
#[pyo3(signature = (*, session, number, stepping, name, heights, influence))]
pub fn exported_pantograph<'py>(
    py: Python<'py>,
    session: &Session,
    number: usize,
    stepping: SteppingData,
    name: String,
    heights: Vec<(usize, String)>,
    influence: Vec<f64>,
) -> PyResult<Bound<'py, PyBytes>> {
    let stepping = stepping.stepping()?;
    let Some((mut pantograph, start)) = session.0.standing_alone(number) else {
        return Err(PyValueError::new_err("number: no such pantograph"));
    };
    pantograph.excitation.base = Some(BaseMotion {
        influence,
        displacement: vec![0.0],
        rate: vec![0.0],
    });
    let model = PantographModel {
        name,
        pantograph,
        scheme: stepping.scheme,
        step_length: stepping.step,
        start,
        speed: session.0.position_and_speed().1,
        heights,
    };
    PantographDevice::new(model.clone()).map_err(|e| convert(py, &e))?;
    packed(py, Part::Pantograph(Box::new(model)))
}

/// Description of an exported model: `token`, `step_length` in s, and `variables` in the order of
/// their numbers: name, unit, description, causality, start, whether it is of the coming step.
#[pyfunction]
pub fn described<'py>(py: Python<'py>, model: &[u8]) -> PyResult<Bound<'py, PyDict>> {
    let stepper = py.detach(|| Stepper::open(model)).map_err(refused)?;
    let variables = stepper.variables().iter().map(|v| {
        let start = v.start;
        (
            &v.name,
            v.unit,
            &v.description,
            v.causality.name(),
            start,
            v.is_prediction,
        )
    });
    let out = PyDict::new(py);
    out.set_item("token", file::token(stepper.digest()))?;
    out.set_item("step_length", stepper.step_length())?;
    out.set_item("variables", variables.collect::<Vec<_>>())?;
    Ok(out)
}
