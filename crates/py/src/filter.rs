//! A recursive filter: arrays in, arrays out.

use arcless_core::filter::{Section, cascade};
use numpy::{PyArray1, PyReadonlyArray1, PyReadonlyArray2, ToPyArray};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// Filter a signal with sections (n × 5: b₀, b₁, b₂, a₁, a₂) from a state (n × 2).
#[pyfunction]
pub fn filtered<'py>(
    py: Python<'py>,
    sections: PyReadonlyArray2<'py, f64>,
    state: PyReadonlyArray2<'py, f64>,
    signal: PyReadonlyArray1<'py, f64>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let (sections, state) = (sections.as_array(), state.as_array());
    if sections.ncols() != 5 || state.ncols() != 2 || sections.nrows() != state.nrows() {
        return Err(PyValueError::new_err(
            "sections are n × 5, their state is n × 2",
        ));
    }
    let rows = sections.rows().into_iter();
    let sections: Vec<Section> = rows.map(|r| [r[0], r[1], r[2], r[3], r[4]]).collect();
    let mut state: Vec<[f64; 2]> = state.rows().into_iter().map(|r| [r[0], r[1]]).collect();
    let mut values: Vec<f64> = signal.as_array().iter().copied().collect();
    py.detach(|| cascade(&sections, &mut state, &mut values));
    Ok(values.to_pyarray(py))
}
