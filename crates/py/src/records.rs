//! Record of a run: the plan that comes from Python, and the arrays returned to it.

use arcless_core::checkpoint::Checkpoint;
use arcless_core::energy_terms::EnergyTerms;
use arcless_core::simulation::recording::record::{Record, RecordPlan};
use arcless_core::simulation::recording::support_parts::SupportParts;
use arcless_core::simulation::recording::window::{MotionPlan, Near, SortedStations};
use numpy::{IntoPyArray, ToPyArray};
use pyo3::prelude::*;
use pyo3::types::PyDict;

#[derive(FromPyObject)]
pub struct PlanData {
    contact_every: usize,
    line_every: usize,
    links: bool,
    nodes: Vec<usize>,
    supports: Vec<SupportData>,
    points: Vec<f64>,
    ledger: bool,
    ledger_every: usize,
    near: Option<NearData>,
    motion: Option<MotionData>,
}

#[derive(FromPyObject)]
struct SupportData {
    vertical: Option<usize>,
    lateral: Option<usize>,
    arm: Option<usize>,
}

impl From<SupportData> for SupportParts {
    fn from(data: SupportData) -> Self {
        Self {
            vertical: data.vertical,
            lateral: data.lateral,
            arm: data.arm,
        }
    }
}

#[derive(FromPyObject)]
struct NearData {
    behind: f64,
    links: StationsData,
    nodes: StationsData,
}

#[derive(FromPyObject)]
struct MotionData {
    every: usize,
    behind: f64,
    wires: Vec<StationsData>,
    links: StationsData,
}

#[derive(FromPyObject)]
struct StationsData {
    of: Vec<usize>,
    x: Vec<f64>,
    in_row: usize,
}

impl From<StationsData> for SortedStations {
    fn from(data: StationsData) -> Self {
        Self {
            of: data.of,
            x: data.x,
            count: data.in_row,
        }
    }
}

impl From<PlanData> for RecordPlan {
    fn from(data: PlanData) -> Self {
        Self {
            contact_every: data.contact_every,
            line_every: data.line_every,
            links: data.links,
            nodes: data.nodes,
            supports: data.supports.into_iter().map(Into::into).collect(),
            points: data.points,
            ledger: data.ledger,
            ledger_every: data.ledger_every,
            near: data.near.map(|near| Near {
                behind: near.behind,
                links: near.links.into(),
                nodes: near.nodes.into(),
            }),
            motion: data.motion.map(|motion| MotionPlan {
                every: motion.every,
                behind: motion.behind,
                wires: motion.wires.into_iter().map(Into::into).collect(),
                links: motion.links.into(),
            }),
        }
    }
}

pub fn numbers<'py>(py: Python<'py>, state: &Checkpoint) -> PyResult<Bound<'py, PyDict>> {
    let out = PyDict::new(py);
    for (name, values) in &state.numbers {
        out.set_item(name, values.to_pyarray(py))?;
    }
    Ok(out)
}

pub fn arrays(py: Python<'_>, mut r: Record) -> PyResult<Bound<'_, PyDict>> {
    let out = PyDict::new(py);
    out.set_item("contacts", &r.contacts)?;
    out.set_item("energy", energies(py, &r.energy)?)?;
    out.set_item("pivot_counts", &r.pivot_counts)?;
    out.set_item("motion", std::mem::take(&mut r.motion).into_pyarray(py))?;
    for (name, count) in r.counts() {
        out.set_item(name, count)?;
    }
    for (name, value) in r.largest() {
        out.set_item(name, value)?;
    }
    // The arrays take over the memory of the record: nothing is copied.
    for (name, values) in r.into_arrays() {
        out.set_item(name, values.into_pyarray(py))?;
    }
    Ok(out)
}

fn energies<'py>(py: Python<'py>, ledger: &[EnergyTerms]) -> PyResult<Bound<'py, PyDict>> {
    let energy = PyDict::new(py);
    for (entry, name) in EnergyTerms::NAMES.iter().enumerate() {
        let values: Vec<f64> = ledger.iter().map(|row| row.values()[entry]).collect();
        energy.set_item(name, values.into_pyarray(py))?;
    }
    let residual: Vec<f64> = ledger.iter().map(EnergyTerms::residual).collect();
    energy.set_item("residual", residual.into_pyarray(py))?;
    Ok(energy)
}
