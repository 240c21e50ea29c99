//! Many sessions stepped by one call, on several threads, with the interpreter released.

use crate::error::convert;
use crate::session::{Session, width, write};
use arcless_core::CoreError;
use arcless_core::session::AnySession;
use numpy::{PyReadonlyArray1, PyReadonlyArray2, PyReadonlyArray3, PyReadwriteArray3};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::sync::{Mutex, PoisonError};

/// Session with what its steps take and leave.
struct Member<'a> {
    session: &'a mut AnySession,
    /// Forces of each step, N.
    forces: &'a [f64],
    /// Position at the end of each step, m.
    positions: &'a [f64],
    /// Speed at the end of each step, m/s.
    speed: f64,
    /// Outputs of each step.
    out: &'a mut [f64],
    taken: usize,
    failure: Option<CoreError>,
}

impl Member<'_> {
    /// Takes the steps, up to the first that fails.
    fn advance(&mut self) {
        let count = self.positions.len();
        let forces = self.forces.chunks_exact(self.forces.len() / count);
        let rows = self.out.chunks_exact_mut(self.out.len() / count);
        for ((&position, forces), row) in self.positions.iter().zip(forces).zip(rows) {
            if let Err(error) = self.session.step(forces, position, self.speed) {
                self.failure = Some(error);
                return;
            }
            write(self.session.outputs(), row);
            self.taken += 1;
        }
    }
}

/// Steps taken, and the error of the step that failed.
type Advanced = (usize, Option<PyErr>);

/// Take steps with many sessions: `forces` (sessions × steps × inputs, N) act during them,
/// `positions` (sessions × steps, m) are at their ends, `speeds` (m/s) stay; `out` (sessions ×
/// steps × outputs) takes what each leaves, see `Session.read`. A session whose step fails stops
/// before it, the others take all.
///
/// Returns steps taken and error of each session.
#[pyfunction]
#[pyo3(signature = (*, sessions, forces, positions, speeds, out, workers))]
pub fn advance(
    py: Python<'_>,
    mut sessions: Vec<PyRefMut<'_, Session>>,
    forces: PyReadonlyArray3<'_, f64>,
    positions: PyReadonlyArray2<'_, f64>,
    speeds: PyReadonlyArray1<'_, f64>,
    mut out: PyReadwriteArray3<'_, f64>,
    workers: usize,
) -> PyResult<Vec<Advanced>> {
    let (count, steps, inputs) = forces.as_array().dim();
    let (rows, columns, values) = out.as_array().dim();
    let shapes = [(rows, columns), positions.as_array().dim()];
    if steps == 0 || workers == 0 || sessions.len() != count || speeds.len()? != count {
        return Err(PyValueError::new_err("forces: sessions × steps × inputs"));
    }
    if shapes.iter().any(|shape| *shape != (count, steps)) {
        return Err(PyValueError::new_err("positions, out: sessions × steps"));
    }
    if sessions.is_empty() {
        return Ok(Vec::new());
    }
    let fits = |s: &PyRefMut<'_, Session>| width(s.0.outputs()) == values && s.0.inputs() == inputs;
    if inputs == 0 || !sessions.iter().all(fits) {
        return Err(PyValueError::new_err(
            "sessions with other numbers of inputs or outputs",
        ));
    }
    let (forces, positions) = (forces.as_slice()?, positions.as_slice()?);
    let (speeds, out) = (speeds.as_slice()?, out.as_slice_mut()?);
    let parts = sessions
        .iter_mut()
        .zip(forces.chunks_exact(steps * inputs))
        .zip(positions.chunks_exact(steps))
        .zip(speeds)
        .zip(out.chunks_exact_mut(steps * values));
    let members = parts.map(|((((session, forces), positions), speed), out)| Member {
        session: &mut session.0,
        forces,
        positions,
        speed: *speed,
        out,
        taken: 0,
        failure: None,
    });
    let mut members: Vec<Member<'_>> = members.collect();
    py.detach(|| advance_all(&mut members, workers));
    let found = members.iter().map(|member| {
        (
            member.taken,
            member.failure.as_ref().map(|e| convert(py, e)),
        )
    });
    Ok(found.collect())
}

/// Advances all members; each is taken by whichever thread is free, and none sees another.
fn advance_all(members: &mut [Member<'_>], workers: usize) {
    let threads = workers.min(members.len());
    let queue = Mutex::new(members.iter_mut());
    let next = || queue.lock().unwrap_or_else(PoisonError::into_inner).next();
    let work = || {
        while let Some(member) = next() {
            member.advance();
        }
    };
    std::thread::scope(|scope| {
        for _ in 1..threads {
            scope.spawn(work);
        }
        work();
    });
}
