//! A recursive filter: arrays in, arrays out.

use arcless_core::filter::{Section, cascade};
use numpy::{PyArray1, PyReadonlyArray1, PyReadonlyArray2, PyReadwriteArray2};
use numpy::{PyReadwriteArray3, ToPyArray};
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

/// Filter pieces of several signals (m × k) in place, each from its state (m × n × 2), which is
/// left as the next piece needs it.
#[pyfunction]
pub fn filter_on(
    sections: PyReadonlyArray2<'_, f64>,
    mut states: PyReadwriteArray3<'_, f64>,
    mut signals: PyReadwriteArray2<'_, f64>,
) -> PyResult<()> {
    let (sections, (count, rows, two)) = (sections.as_array(), states.as_array().dim());
    let (signal_count, length) = signals.as_array().dim();
    let is_sound = sections.ncols() == 5 && sections.nrows() == rows && two == 2 && rows > 0;
    if !is_sound || signal_count != count {
        return Err(PyValueError::new_err(
            "sections are n × 5, states m × n × 2, signals m × k",
        ));
    }
    if length == 0 {
        return Ok(());
    }
    let all = sections.rows().into_iter();
    let sections: Vec<Section> = all.map(|r| [r[0], r[1], r[2], r[3], r[4]]).collect();
    let states = states.as_slice_mut()?.as_chunks_mut::<2>().0;
    let signals = signals.as_slice_mut()?;
    for (state, signal) in states
        .chunks_exact_mut(rows)
        .zip(signals.chunks_exact_mut(length))
    {
        cascade(&sections, state, signal);
    }
    Ok(())
}
