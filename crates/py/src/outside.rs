//! Programs of Python that move external pantographs during a run.

use arcless_core::pantograph::external::{Outside, StepStart};
use numpy::PyArray1;
use pyo3::prelude::*;

/// Objects that move the external pantographs of a run, by the numbers of these; see
/// `arcless.simulate.setup.core_data.ExternalPantograph`.
pub struct Programs<'a> {
    /// None where a pantograph is simulated.
    pub programs: &'a [Option<Py<PyAny>>],
    /// Exception that has ended the run.
    pub raised: Option<PyErr>,
}

impl Programs<'_> {
    fn call(
        &mut self,
        pantograph: usize,
        ask: impl FnOnce(Python<'_>, &Bound<'_, PyAny>) -> PyResult<()>,
    ) -> Result<(), String> {
        let Some(program) = &self.programs[pantograph] else {
            return Err("nobody moves it".into());
        };
        Python::attach(|py| {
            ask(py, program.bind(py)).map_err(|error| {
                let reason = error.to_string();
                self.raised = Some(error);
                reason
            })
        })
    }
}

/// Copies the numbers of an answer, which must be as many as expected.
fn fill(values: &[f64], out: &mut [f64], what: &str) -> PyResult<()> {
    if values.len() != out.len() {
        let (got, expected) = (values.len(), out.len());
        let message = format!("{got} {what} of an external pantograph, expected {expected}");
        return Err(pyo3::exceptions::PyValueError::new_err(message));
    }
    out.copy_from_slice(values);
    Ok(())
}

impl Outside for Programs<'_> {
    fn begin(&mut self, pantograph: usize, heights: &[f64], forces: &[f64]) -> Result<(), String> {
        self.call(pantograph, |py, program| {
            let heights = PyArray1::from_slice(py, heights);
            let forces = PyArray1::from_slice(py, forces);
            program.call_method1("begin", (heights, forces)).map(|_| ())
        })
    }

    fn predict(
        &mut self,
        pantograph: usize,
        start: &StepStart,
        heights: &mut [f64],
        compliance: &mut [f64],
    ) -> Result<(), String> {
        self.call(pantograph, |_, program| {
            let asked = (start.step, start.time, start.position, start.speed);
            let answer = program.call_method1("predict", asked)?;
            let (z, s): (Vec<f64>, Vec<Vec<f64>>) = answer.extract()?;
            fill(&z, heights, "heights")?;
            fill(&s.concat(), compliance, "compliances")
        })
    }

    fn advance(
        &mut self,
        pantograph: usize,
        forces: &[f64],
        heights: &mut [f64],
    ) -> Result<(), String> {
        self.call(pantograph, |py, program| {
            let forces = PyArray1::from_slice(py, forces);
            let answer: Vec<f64> = program.call_method1("advance", (forces,))?.extract()?;
            fill(&answer, heights, "heights")
        })
    }
}
