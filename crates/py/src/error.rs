//! One table from core errors to one Python exception: `CoreError(kind, message, details)`.

use arcless_core::CoreError;
use pyo3::create_exception;
use pyo3::exceptions::PyException;
use pyo3::prelude::*;
use pyo3::types::PyDict;

create_exception!(
    arcless._core,
    NativeError,
    PyException,
    "Failure in the core: kind, message, details."
);

/// Python exception for a core error; the details are what a caller needs to name the culprit.
pub fn convert(py: Python<'_>, error: &CoreError) -> PyErr {
    match details(py, error) {
        Ok((kind, details)) => NativeError::new_err((kind, error.to_string(), details.unbind())),
        Err(failure) => failure,
    }
}

fn details<'py>(
    py: Python<'py>,
    error: &CoreError,
) -> PyResult<(&'static str, Bound<'py, PyDict>)> {
    let d = PyDict::new(py);
    let kind = match error {
        CoreError::Input { array, reason } => {
            d.set_item("array", array)?;
            d.set_item("reason", reason)?;
            "input"
        }
        CoreError::StepTooLong { longest, .. } => {
            d.set_item("longest", longest)?;
            "too_long"
        }
        CoreError::Singular { node } => {
            d.set_item("node", node)?;
            "singular"
        }
        CoreError::Unstable { directions } => {
            d.set_item("directions", directions)?;
            "unstable"
        }
        CoreError::NoEquilibrium {
            iterations,
            residual,
            node,
            tolerance,
        } => {
            d.set_item("iterations", iterations)?;
            d.set_item("residual", residual)?;
            d.set_item("node", node)?;
            d.set_item("tolerance", tolerance)?;
            "equilibrium"
        }
        CoreError::PushingLink { link, force } => {
            d.set_item("link", link)?;
            d.set_item("force", force)?;
            "pushing"
        }
        CoreError::BeyondTable {
            pantograph,
            table,
            displacement,
            end,
        } => {
            d.set_item("pantograph", pantograph)?;
            d.set_item("table", table)?;
            d.set_item("place", displacement)?;
            d.set_item("end", end)?;
            "beyond_table"
        }
        CoreError::Control {
            pantograph,
            step,
            time,
            position,
            reason,
        } => {
            d.set_item("pantograph", pantograph)?;
            d.set_item("step", step)?;
            d.set_item("time", time)?;
            d.set_item("position", position)?;
            d.set_item("reason", reason)?;
            "control"
        }
        CoreError::External {
            pantograph,
            step,
            time,
            position,
            reason,
        } => {
            d.set_item("pantograph", pantograph)?;
            d.set_item("step", step)?;
            d.set_item("time", time)?;
            d.set_item("position", position)?;
            d.set_item("reason", reason)?;
            "external"
        }
        CoreError::NotFinite { step, .. } => {
            d.set_item("step", step)?;
            "not_finite"
        }
        CoreError::Balance {
            what,
            step,
            time,
            off,
            turnover,
        } => {
            d.set_item("what", what)?;
            d.set_item("step", step)?;
            d.set_item("time", time)?;
            d.set_item("off", off)?;
            d.set_item("turnover", turnover)?;
            "balance"
        }
        CoreError::Folded { step } => {
            d.set_item("step", step)?;
            "folded"
        }
        CoreError::Lcp {
            step,
            time,
            contacts,
            links,
            stops,
            failure,
        } => {
            d.set_item("step", step)?;
            d.set_item("time", time)?;
            d.set_item("contacts", contacts)?;
            d.set_item("links", links)?;
            d.set_item("stops", stops)?;
            d.set_item("h", &failure.h)?;
            d.set_item("w", &failure.w)?;
            d.set_item("reason", failure.to_string())?;
            "lcp"
        }
        CoreError::SlackSet { step, time } => {
            d.set_item("step", step)?;
            d.set_item("time", time)?;
            "slack_set"
        }
        CoreError::OffWire {
            pantograph,
            position,
            step,
        } => {
            d.set_item("pantograph", pantograph)?;
            d.set_item("position", position)?;
            d.set_item("step", step)?;
            "off_wire"
        }
        CoreError::OutOfReach {
            pantograph,
            position,
            lateral,
            half_width,
            step,
        } => {
            d.set_item("pantograph", pantograph)?;
            d.set_item("position", position)?;
            d.set_item("lateral", lateral)?;
            d.set_item("half_width", half_width)?;
            d.set_item("step", step)?;
            "out_of_reach"
        }
        CoreError::Cancelled { step } => {
            d.set_item("step", step)?;
            "cancelled"
        }
    };
    Ok((kind, d))
}
