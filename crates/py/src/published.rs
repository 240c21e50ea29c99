//! The published step: matrices in once, vectors in and the table of a step out.

use crate::error::convert;
use arcless_core::CoreError;
use arcless_core::published::{self, Known, Matrix};
use numpy::{PyArray1, PyReadonlyArray1, ToPyArray};
use pyo3::prelude::*;

type Given<'py> = PyReadonlyArray1<'py, f64>;
type Vector<'py> = Bound<'py, PyArray1<f64>>;

/// A system with its matrices for one step length; all matrices come by rows.
#[pyclass]
pub struct PublishedStep {
    size: usize,
    inner: published::PublishedStep,
}

fn square(array: &'static str, size: usize, values: &Given<'_>) -> PyResult<Matrix> {
    let matrix = Matrix::new(array, size, size, values.as_slice()?.to_vec());
    matrix.map_err(|error| convert(values.py(), &error))
}

#[pymethods]
impl PublishedStep {
    #[new]
    fn new(
        py: Python<'_>,
        size: usize,
        mass: Given<'_>,
        damping: Given<'_>,
        stiffness: Given<'_>,
        time_step: f64,
    ) -> PyResult<Self> {
        let mass = square("mass", size, &mass)?;
        let damping = square("damping", size, &damping)?;
        let stiffness = square("stiffness", size, &stiffness)?;
        let inner =
            py.detach(|| published::PublishedStep::new(mass, damping, &stiffness, time_step));
        let inner = inner.map_err(|error| convert(py, &error))?;
        Ok(Self { size, inner })
    }

    /// Form A anew with another stiffness.
    fn reform(&mut self, py: Python<'_>, stiffness: Given<'_>) -> PyResult<()> {
        let stiffness = square("stiffness", self.size, &stiffness)?;
        let formed = py.detach(|| self.inner.reform(&stiffness));
        formed.map_err(|error| convert(py, &error))
    }

    /// H, w, A⁻¹C and −A⁻¹p̂ of table 2.
    fn table<'py>(
        &self,
        py: Python<'py>,
        u_1: Given<'py>,
        u_2: Given<'py>,
        load: Given<'py>,
        contact_map: Given<'py>,
        initial_gap: Given<'py>,
    ) -> PyResult<(Vector<'py>, Vector<'py>, Vector<'py>, Vector<'py>)> {
        let contacts = initial_gap.as_slice()?.len();
        let map = contact_map.as_slice()?.to_vec();
        let map = Matrix::new("contact_map", self.size, contacts, map);
        let map = map.map_err(|error| convert(py, &error))?;
        let known = Known {
            u_1: u_1.as_slice()?,
            u_2: u_2.as_slice()?,
            load: load.as_slice()?,
            contact_map: &map,
            initial_gap: initial_gap.as_slice()?,
        };
        let table = py.detach(|| self.inner.table_2(&known));
        let table = table.map_err(|error: CoreError| convert(py, &error))?;
        Ok((
            table.h().values.to_pyarray(py),
            table.w().to_pyarray(py),
            table.upper_right.values.to_pyarray(py),
            table.upper_constant.to_pyarray(py),
        ))
    }
}

/// `T_i = f n_{i−1}`.
#[pyfunction]
pub fn friction<'py>(coefficient: f64, force_1: Given<'py>) -> PyResult<Vector<'py>> {
    let tangential = published::friction(coefficient, force_1.as_slice()?);
    Ok(tangential.to_pyarray(force_1.py()))
}
