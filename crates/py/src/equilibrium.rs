//! Static equilibrium and what is read from it.

use crate::error::convert;
use crate::model::WireModel;
use crate::structure;
use arcless_core::line::{AnyLine, Stepping};
use arcless_core::scheme::Scheme;
use numpy::{IntoPyArray, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Static equilibrium of a structure.
#[pyclass(frozen)]
pub struct Equilibrium(pub AnyLine);

#[pymethods]
impl Equilibrium {
    /// Find the equilibrium; with `design`, unknown lengths are found first. Without Hermite
    /// elements in the table `wires`, the wires are the chains in `segments` and `bends`. With
    /// `residual_flexibility`, the compliance that cubic elements lack under droppers, supports and
    /// contacts is added there; with `fitted_bends`, points of chains yield as those of their wires
    /// do; with `across_only`, the linear model moves across the track alone, at the tensions of
    /// rest. With `near`, an equilibrium of the same elements, the design is searched for from
    /// there.
    #[new]
    #[pyo3(signature = (*, dimension, positions, slopes, parts, gravity, design, residual_flexibility = false, fitted_bends = false, across_only = false, near = None))]
    fn new(
        py: Python<'_>,
        dimension: usize,
        positions: PyReadonlyArray2<'_, f64>,
        slopes: PyReadonlyArray2<'_, f64>,
        parts: &Bound<'_, PyDict>,
        gravity: f64,
        design: bool,
        residual_flexibility: bool,
        fitted_bends: bool,
        across_only: bool,
        near: Option<Py<Self>>,
    ) -> PyResult<Self> {
        let near = near.as_ref().map(|known| &known.get().0);
        let mut s = structure::build(dimension, &positions, &slopes, parts, gravity)?;
        s.fitted_bends = fitted_bends;
        s.across_only = across_only;
        let found = py.detach(|| AnyLine::new(s, design, residual_flexibility, near));
        found.map(Self).map_err(|e| convert(py, &e))
    }

    /// Equilibrium of the same structure after changes: factors on lengths and stiffnesses, new
    /// masses, loads along the wires, offsets of link lengths and of the rest positions of springs
    /// and struts, forces at free ends, links removed.
    fn altered(&self, py: Python<'_>, changes: &Bound<'_, PyDict>) -> PyResult<Self> {
        let change = structure::alteration(changes)?;
        let found = py.detach(|| self.0.altered(&change));
        found.map(Self).map_err(|e| convert(py, &e))
    }

    /// Forces on nodes (node, component, N) of a force in N/m along each wire element or segment.
    fn nodal_forces(
        &self,
        py: Python<'_>,
        load: PyReadonlyArray2<'_, f64>,
    ) -> PyResult<Vec<(usize, usize, f64)>> {
        let load = structure::triples(&load)?;
        let found = self.0.nodal_forces(&load);
        found.map_err(|e| convert(py, &e))
    }

    /// Shape, lengths and forces as arrays.
    fn arrays<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let out = PyDict::new(py);
        for (name, values) in self.0.arrays() {
            out.set_item(name, values.into_pyarray(py))?;
        }
        Ok(out)
    }

    /// Elasticity in m/N at coordinates `x` in m, for a force in N on the wires of `lanes`: wire
    /// elements in the order of the track, one list for each lane.
    fn elasticity(
        &self,
        py: Python<'_>,
        lanes: Vec<Vec<usize>>,
        x: Vec<f64>,
        force: f64,
    ) -> PyResult<Vec<f64>> {
        let found = py.detach(|| self.0.elasticity(&lanes, &x, force));
        found.map_err(|e| convert(py, &e))
    }

    /// Lowest natural frequencies in Hz.
    fn frequencies(&self, py: Python<'_>, count: usize) -> PyResult<Vec<f64>> {
        let mut raised = None::<PyErr>;
        let found = py.detach(|| {
            let mut go_on = || {
                let signals = Python::attach(|py| py.check_signals());
                signals.map_err(|error| raised = Some(error)).is_ok()
            };
            self.0.frequencies_while(count, &mut go_on)
        });
        found.map_err(|e| raised.unwrap_or_else(|| convert(py, &e)))
    }

    /// Modes that a vertical force of 1 N at coordinate `x` in m excites, shared equally by the
    /// wires of `lanes`: square of the start vector's length, diagonal and off-diagonal of the
    /// Lanczos matrix of 1/ω².
    fn modes_moved(
        &self,
        py: Python<'_>,
        lanes: Vec<Vec<usize>>,
        x: f64,
        steps: usize,
    ) -> PyResult<(f64, Vec<f64>, Vec<f64>)> {
        let found = py.detach(|| self.0.modes_moved(&lanes, x, steps));
        let found = found.map_err(|e| convert(py, &e))?;
        Ok((found.squared_length, found.diagonal, found.off))
    }

    /// Factorise for stepping: wire elements of each lane in the order of the track, scheme as name
    /// and parameters, step in s, contact stiffness in N/m (infinite when rigid), updated or
    /// linearised kinematics, and whether the mass of the wires is corrected for the period error
    /// of the scheme.
    #[pyo3(signature = (*, lanes, scheme, step, contact_stiffness, updated, period_correction = false))]
    fn prepare(
        &self,
        py: Python<'_>,
        lanes: Vec<Vec<usize>>,
        scheme: (String, Vec<f64>),
        step: f64,
        contact_stiffness: f64,
        updated: bool,
        period_correction: bool,
    ) -> PyResult<WireModel> {
        let stepping = SteppingData {
            scheme,
            step,
            contact_stiffness,
            updated,
            period_correction,
        };
        let stepping = stepping.stepping()?;
        let found = py.detach(|| self.0.prepare(&lanes, &stepping));
        found.map(WireModel).map_err(|e| convert(py, &e))
    }
}

/// Choice of the steps of a line.
#[derive(FromPyObject)]
pub struct SteppingData {
    scheme: (String, Vec<f64>),
    step: f64,
    contact_stiffness: f64,
    updated: bool,
    period_correction: bool,
}

impl SteppingData {
    /// Data of the core.
    pub fn stepping(&self) -> PyResult<Stepping> {
        let (name, parameters) = &self.scheme;
        Ok(Stepping {
            scheme: read_scheme(name, parameters)?,
            step: self.step,
            contact_stiffness: self.contact_stiffness,
            explicit: name == EXPLICIT,
            updated: self.updated,
            period_correction: self.period_correction,
        })
    }
}

const EXPLICIT: &str = "central-difference";

fn read_scheme(name: &str, parameters: &[f64]) -> PyResult<Scheme> {
    match (name, parameters) {
        ("generalised-alpha", &[radius]) => Ok(Scheme::generalised_alpha(radius)),
        ("hht", &[alpha]) => Ok(Scheme::hht(alpha)),
        ("newmark", &[beta, gamma]) => Ok(Scheme::newmark(beta, gamma)),
        ("trapezoidal", &[]) => Ok(Scheme::generalised_alpha(1.0)),
        // Scheme of the parts that are not stepped explicitly.
        (EXPLICIT, &[]) => Ok(Scheme::newmark(0.25, 0.5)),
        ("backward-difference", &[]) => Ok(Scheme::BackwardDifference),
        _ => Err(PyValueError::new_err(format!(
            "unknown scheme {name} with {} parameters",
            parameters.len()
        ))),
    }
}
