//! A line stepped from outside: one call for each step, into arrays that stay.

use crate::error::convert;
use crate::prepared::{Any, Prepared};
use crate::records::numbers;
use crate::riders::{RiderData, rider};
use arcless_core::CoreError;
use arcless_core::checkpoint::Checkpoint;
use arcless_core::integrator::prepared::WireModel;
use arcless_core::session::{self, Begin, Collector};
use numpy::{PyReadonlyArray1, PyReadwriteArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::collections::BTreeMap;
use std::sync::Arc;

/// A loop on a line in two or three dimensions; see [`Any`].
enum Loop {
    Planar(session::Session<2, 4>),
    Spatial(session::Session<3, 6>),
    PlanarChain(session::Session<2, 2>),
    SpatialChain(session::Session<3, 3>),
}

/// Call a method of whichever variant is there.
macro_rules! either {
    ($any:expr, $live:ident => $body:expr) => {
        match $any {
            Loop::Planar($live) => $body,
            Loop::Spatial($live) => $body,
            Loop::PlanarChain($live) => $body,
            Loop::SpatialChain($live) => $body,
        }
    };
}

// Python's objects are aligned to 16 bytes, and what lies in them is stepped where it lies.
const _: () = assert!(align_of::<Loop>() <= 16);

/// A line in a loop with the outside. Made by the class methods.
#[pyclass]
pub struct Live(Loop);

/// Position in m, speed in m/s, coefficient of friction.
type BeginData = (f64, f64, f64);

fn begin((position, speed, friction): BeginData) -> Begin {
    Begin {
        position,
        speed,
        friction,
    }
}

type Made<const DIM: usize, const D: usize> = Result<session::Session<DIM, D>, CoreError>;

#[pymethods]
impl Live {
    /// Forces given: distance in m behind the position and half width in m of each collector, its
    /// force in N at the start.
    #[staticmethod]
    fn with_forces(
        py: Python<'_>,
        line: &Prepared,
        collectors: Vec<(f64, f64)>,
        forces: Vec<f64>,
        start: BeginData,
    ) -> PyResult<Self> {
        let collectors = collectors.into_iter();
        let collectors = collectors.map(|(behind, half_width)| Collector { behind, half_width });
        let collectors: Vec<Collector> = collectors.collect();
        fn make<const DIM: usize, const D: usize>(
            p: &Arc<WireModel<DIM, D>>,
            collectors: Vec<Collector>,
            forces: &[f64],
            start: BeginData,
        ) -> Made<DIM, D> {
            session::Session::with_forces(p.clone(), collectors, forces, begin(start))
        }
        let found = py.detach(|| match &line.0 {
            Any::Planar(p) => make(p, collectors, &forces, start).map(Loop::Planar),
            Any::Spatial(p) => make(p, collectors, &forces, start).map(Loop::Spatial),
            Any::PlanarChain(p) => make(p, collectors, &forces, start).map(Loop::PlanarChain),
            Any::SpatialChain(p) => make(p, collectors, &forces, start).map(Loop::SpatialChain),
        });
        found.map(Self).map_err(|e| convert(py, &e))
    }

    /// Riders simulated, at `distances` (m) behind the first; nobody is asked for their actuators.
    #[staticmethod]
    fn with_riders(
        py: Python<'_>,
        line: &Prepared,
        riders: Vec<RiderData>,
        distances: Vec<f64>,
        start: BeginData,
    ) -> PyResult<Self> {
        let riders = riders.into_iter().map(|data| rider(data).0).collect();
        fn make<const DIM: usize, const D: usize>(
            p: &Arc<WireModel<DIM, D>>,
            (riders, distances): (Vec<arcless_core::pantograph::system::Pantograph>, Vec<f64>),
            start: BeginData,
        ) -> Made<DIM, D> {
            session::Session::with_riders(p.clone(), riders, distances, begin(start))
        }
        let what = (riders, distances);
        let found = py.detach(|| match &line.0 {
            Any::Planar(p) => make(p, what, start).map(Loop::Planar),
            Any::Spatial(p) => make(p, what, start).map(Loop::Spatial),
            Any::PlanarChain(p) => make(p, what, start).map(Loop::PlanarChain),
            Any::SpatialChain(p) => make(p, what, start).map(Loop::SpatialChain),
        });
        found.map(Self).map_err(|e| convert(py, &e))
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
        let taken = either!(&mut self.0, live => live.step(forces, position, speed));
        taken.map_err(|e| convert(py, &e))?;
        self.read(out)
    }

    /// Write what the last step has left: force in N, height, lateral place in m, rate of the height in
    /// m/s, each for all contacts; displacement in m and velocity in m/s of all coordinates of riders.
    fn read(&self, mut out: PyReadwriteArray1<'_, f64>) -> PyResult<()> {
        let reading = either!(&self.0, live => live.reading());
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

    /// Numbers of contacts and of coordinates of all riders.
    fn sizes(&self) -> (usize, usize) {
        let reading = either!(&self.0, live => live.reading());
        (reading.force.len(), reading.velocity.len())
    }

    /// Contacts: rider, strip and lane of each; none where forces are given.
    fn contacts(&self) -> Vec<[usize; 3]> {
        either!(&self.0, live => live.reading().contacts.clone())
    }

    /// Steps taken, position in m, speed in m/s.
    fn place(&self) -> (usize, f64, f64) {
        let (position, speed) = either!(&self.0, live => live.place());
        (either!(&self.0, live => live.steps()), position, speed)
    }

    /// Steps taken, and the state as numbers by name.
    fn take_down<'py>(&mut self, py: Python<'py>) -> PyResult<(usize, Bound<'py, PyDict>)> {
        let state = either!(&mut self.0, live => live.take_down());
        let state = state.map_err(|e| convert(py, &e))?;
        Ok((state.step, numbers(py, &state)?))
    }

    /// Go on from a state.
    fn put_back(
        &mut self,
        py: Python<'_>,
        state: (usize, BTreeMap<String, Vec<f64>>),
    ) -> PyResult<()> {
        let (step, numbers) = state;
        let state = Checkpoint { step, numbers };
        either!(&mut self.0, live => live.put_back(&state)).map_err(|e| convert(py, &e))
    }
}
