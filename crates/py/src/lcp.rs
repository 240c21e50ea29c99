//! One linear complementarity problem: arrays in, arrays out.

use crate::error::NativeError;
use arcless_core::lcp::{LcpFailure, LcpSolver};
use numpy::{PyArray1, PyReadonlyArray1, ToPyArray};
use pyo3::prelude::*;
use pyo3::types::PyDict;

type Vector<'py> = Bound<'py, PyArray1<f64>>;

/// Solve `y = Hx + w`, `x ≥ 0`, `y ≥ 0`, `xᵀy = 0`; `h` holds the rows of `H` one after the other.
///
/// Returns `x`, `y`, the number of pivots, whether the fallback was used, and the residual.
#[pyfunction]
pub fn solve_lcp<'py>(
    py: Python<'py>,
    h: PyReadonlyArray1<'py, f64>,
    w: PyReadonlyArray1<'py, f64>,
) -> PyResult<(Vector<'py>, Vector<'py>, usize, bool, f64)> {
    let (h, w) = (h.as_slice()?, w.as_slice()?);
    let (mut x, mut y) = (vec![0.0; w.len()], vec![0.0; w.len()]);
    let solved = py.detach(|| LcpSolver::new().solve(h, w, &mut x, &mut y, &[]));
    let stats = solved.map_err(|failure| convert(py, &failure))?;
    Ok((
        x.to_pyarray(py),
        y.to_pyarray(py),
        stats.pivots,
        stats.fallback_used,
        stats.residual,
    ))
}

fn convert(py: Python<'_>, failure: &LcpFailure) -> PyErr {
    let details = PyDict::new(py);
    let filled = details
        .set_item("reason", failure.reason.to_string())
        .and_then(|()| details.set_item("pivots", failure.pivots))
        .and_then(|()| details.set_item("residual", failure.residual));
    match filled {
        Ok(()) => NativeError::new_err(("lcp", failure.to_string(), details.unbind())),
        Err(error) => error,
    }
}
