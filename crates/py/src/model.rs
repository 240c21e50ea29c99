//! Line that is ready for steps, and runs on it.

use crate::error::convert;
use crate::outside::Programs;
use crate::pantographs::{AskedPantograph, PantographData, pantograph};
use crate::records::{PlanData, arrays, numbers};
use arcless_core::CoreError;
use arcless_core::checkpoint::Checkpoint;
use arcless_core::each_kind;
use arcless_core::line::AnyWireModel;
use arcless_core::linear::loads::Load;
use arcless_core::pantograph::actuator::Sample;
use arcless_core::simulation::callbacks::Callbacks;
use arcless_core::simulation::inputs::Trajectory;
use arcless_core::simulation::recording::record::Record;
use arcless_core::simulation::run::Part;
use numpy::{PyArrayLike1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::collections::BTreeMap;

/// A line whose step matrix is factorised; it serves any number of runs.
#[pyclass(frozen)]
pub struct WireModel(pub AnyWireModel);

/// Forces on the line: node, component and force for the size 1 of each part of the pattern; its
/// size at every instant.
#[derive(FromPyObject)]
struct LoadData {
    pattern: Vec<(usize, usize, f64)>,
    sizes: Vec<f64>,
}

/// The answer of a controller to a sample, N.
fn answer(controller: Option<&Py<PyAny>>, sample: &Sample) -> PyResult<f64> {
    Python::attach(|py| {
        let Some(controller) = controller else {
            return Ok(0.0);
        };
        let answer = controller.call1(
            py,
            (
                sample.number,
                sample.time,
                sample.position,
                sample.speed,
                sample.force,
                sample.displacements.clone(),
                sample.velocities.clone(),
            ),
        );
        answer?.extract::<f64>(py)
    })
}

#[pymethods]
impl WireModel {
    /// Run along `positions` (m) with `speeds` (m/s), one for every step and one more.
    ///
    /// `observe(step)` is called at intervals and returns whether to continue. With `take`
    /// (numbers, function) the function receives the series whenever they hold that many numbers,
    /// and the returned record has the rest. `state` is the state to resume from (steps done,
    /// numbers by name) or None, `until` the number of steps to stop after or None; the state there
    /// is part of the returned record.
    #[pyo3(signature = (*, pantographs, distances, positions, speeds, friction, loads, plan, observe, state=None, until=None, take=None))]
    fn run<'py>(
        &self,
        py: Python<'py>,
        pantographs: Vec<PantographData>,
        distances: Vec<f64>,
        positions: PyArrayLike1<'_, f64>,
        speeds: PyArrayLike1<'_, f64>,
        friction: f64,
        loads: Vec<LoadData>,
        plan: PlanData,
        observe: &Bound<'py, PyAny>,
        state: Option<(usize, BTreeMap<String, Vec<f64>>)>,
        until: Option<usize>,
        take: Option<(usize, Py<PyAny>)>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let pantographs = pantographs.into_iter().map(pantograph);
        let pantographs = pantographs.collect::<PyResult<Vec<_>>>()?;
        let (pantographs, [controllers, programs]) = AskedPantograph::split(pantographs);
        let travel = Trajectory {
            positions: positions.to_vec()?,
            speeds: speeds.to_vec()?,
            distances,
            friction,
            loads: loads
                .into_iter()
                .map(|LoadData { pattern, sizes }| Load { pattern, sizes })
                .collect(),
        };
        let plan = plan.into();
        let state = state.map(|(step, numbers)| Checkpoint { step, numbers });
        let observer = observe.clone().unbind();
        let mut outside = Programs {
            programs: &programs,
            raised: None,
        };
        let (mut raised, mut failed, mut lost) = (None::<PyErr>, None::<PyErr>, None::<PyErr>);
        let outcome = py.detach(|| {
            let mut go_on = |step: usize| {
                Python::attach(|py| {
                    let answer = py
                        .check_signals()
                        .and_then(|()| observer.call1(py, (step,)))
                        .and_then(|answer| answer.extract::<bool>(py));
                    answer.unwrap_or_else(|error| {
                        raised = Some(error);
                        false
                    })
                })
            };
            let mut ask = |which: usize, sample: &Sample| {
                answer(controllers[which].as_ref(), sample).map_err(|error| {
                    let reason = error.to_string();
                    failed = Some(error);
                    reason
                })
            };
            let part = Part {
                from: state.as_ref(),
                until,
            };
            let mut hand_on = |piece: Record| {
                let Some((_, taker)) = &take else {
                    return true;
                };
                Python::attach(|py| {
                    let taken = arrays(py, piece).and_then(|piece| taker.call1(py, (piece,)));
                    taken.map_err(|error| lost = Some(error)).is_ok()
                })
            };
            let enough = take.as_ref().map(|(numbers, _)| *numbers);
            let callers = Callbacks {
                observe: &mut go_on,
                ask: &mut ask,
                outside: &mut outside,
                take: enough.map(|numbers| (numbers, &mut hand_on as _)),
            };
            each_kind!(&self.0, AnyWireModel, p => p.run_pieces(&pantographs, &travel, &plan, part, callers))
        });
        let ended_by = CoreError::is_ended_from_outside;
        match (outcome, raised.or(failed).or(outside.raised).or(lost)) {
            (Err(error), Some(raised)) if ended_by(&error) => Err(raised),
            (Err(error), _) => Err(convert(py, &error)),
            (Ok((record, state)), _) => {
                let out = arrays(py, record)?;
                out.set_item("state", (state.step, numbers(py, &state)?))?;
                Ok(out)
            }
        }
    }

    /// Sizes that explain the cost of a step: nodes, blocks of the factor, numbers in the columns.
    fn cost(&self) -> (usize, usize, usize) {
        self.0.cost()
    }
}
