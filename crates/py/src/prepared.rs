//! Runs on a prepared line.

use crate::error::convert;
use arcless_core::CoreError;
use arcless_core::dynamics::actuator::{Actuator, Sample};
use arcless_core::dynamics::given::{Given, Ground, History};
use arcless_core::dynamics::kink::Motion;
use arcless_core::dynamics::law::Law;
use arcless_core::dynamics::ledger::Entries;
use arcless_core::dynamics::loads::Load;
use arcless_core::dynamics::near::{Near, Ordered};
use arcless_core::dynamics::part::{Callers, Part};
use arcless_core::dynamics::record::{Record, RecordPlan};
use arcless_core::dynamics::rider::Rider;
use arcless_core::dynamics::run::Travel;
use arcless_core::dynamics::state::State;
use arcless_core::dynamics::stepper;
use arcless_core::dynamics::stop::Stop;
use arcless_core::dynamics::strip::Strip;
use numpy::{IntoPyArray, PyArrayLike1, PyArrayMethods, ToPyArray};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Prepared line in two or three dimensions.
pub enum Any {
    /// Along and up, Hermite elements.
    Planar(Arc<stepper::Prepared<2, 4>>),
    /// Along, across and up, Hermite elements.
    Spatial(Arc<stepper::Prepared<3, 6>>),
    /// Along and up, chains of point masses.
    PlanarChain(Arc<stepper::Prepared<2, 2>>),
    /// Along, across and up, chains of point masses.
    SpatialChain(Arc<stepper::Prepared<3, 3>>),
}

/// Call a method of whichever variant is there.
macro_rules! either {
    ($any:expr, $p:ident => $body:expr) => {
        match $any {
            Any::Planar($p) => $body,
            Any::Spatial($p) => $body,
            Any::PlanarChain($p) => $body,
            Any::SpatialChain($p) => $body,
        }
    };
}

/// A line whose step matrix is factorised; it serves any number of runs.
#[pyclass(frozen)]
pub struct Prepared(pub Any);

/// One rider as it comes from Python: mass, damping, stiffness matrices by rows; strips; preload, lift
/// vectors; contact force at the start; what is given; stops; springs and dampers with tables; actuator.
pub type RiderData = (
    Vec<f64>,
    Vec<f64>,
    Vec<f64>,
    Vec<StripData>,
    Vec<f64>,
    Vec<f64>,
    f64,
    GivenData,
    Vec<StopData>,
    Vec<LawData>,
    Option<ActuatorData>,
);

/// Direction, steps from sample to sample, steps of delay, and who is asked.
type ActuatorData = (Vec<f64>, usize, usize, Py<PyAny>);

/// Offset behind the reference point and half width in m; lateral places in m, and a vector for each
/// whose product with the displacements is the height there.
type StripData = (f64, f64, Vec<f64>, Vec<Vec<f64>>);

/// Forces (direction, N at every instant), and the ground: displacement that goes with it, its
/// own in m and its rate in m/s at every instant.
type GivenData = (
    Vec<(Vec<f64>, Vec<f64>)>,
    Option<(Vec<f64>, Vec<f64>, Vec<f64>)>,
);

/// Forces on the line: node, component and force for the size 1 of each part of the pattern; its
/// size at every instant.
type LoadData = (Vec<(usize, usize, f64)>, Vec<f64>);

/// Direction that opens the stop, gap in m, stiffness in N/m.
type StopData = (Vec<f64>, f64, f64);

/// Distance behind the last rider in m; links; nodes.
type NearData = (f64, OrderedData, OrderedData);

/// Numbers in the order along the track, coordinates in m, and how many a row holds.
type OrderedData = (Vec<usize>, Vec<f64>, usize);

/// Direction of a spring or damper, whether it is a damper, points (m or m/s, N).
type LawData = (Vec<f64>, bool, Vec<[f64; 2]>);

fn given((forces, ground): GivenData) -> Given {
    let history = |(direction, values)| History { direction, values };
    Given {
        forces: forces.into_iter().map(history).collect(),
        ground: ground.map(|(carried, displacement, rate)| Ground {
            carried,
            displacement,
            rate,
        }),
    }
}

fn near((behind, links, nodes): NearData) -> Near {
    let ordered = |(of, x, count): OrderedData| Ordered { of, x, count };
    Near {
        behind,
        links: ordered(links),
        nodes: ordered(nodes),
    }
}

fn strip((offset, half_width, knots, vectors): StripData) -> Strip {
    Strip {
        offset,
        half_width,
        knots,
        vectors,
    }
}

fn stop((direction, gap, stiffness): StopData) -> Stop {
    Stop {
        direction,
        gap,
        stiffness,
    }
}

fn law((direction, is_damper, points): LawData) -> Law {
    Law {
        direction,
        motion: if is_damper {
            Motion::Rate
        } else {
            Motion::Place
        },
        points,
    }
}

/// The rider, and who is asked for the force of its actuator.
pub fn rider(data: RiderData) -> (Rider, Option<Py<PyAny>>) {
    let (
        mass,
        damping,
        stiffness,
        strips,
        preload,
        lift,
        start_force,
        outside,
        stops,
        laws,
        given_by,
    ) = data;
    let (actuator, asked) = match given_by {
        None => (None, None),
        Some((direction, every, delay, asked)) => {
            let actuator = Actuator {
                direction,
                every,
                delay,
            };
            (Some(actuator), Some(asked))
        }
    };
    let rider = Rider {
        given: given(outside),
        stops: stops.into_iter().map(stop).collect(),
        laws: laws.into_iter().map(law).collect(),
        mass,
        damping,
        stiffness,
        strips: strips.into_iter().map(strip).collect(),
        preload,
        lift,
        start_force,
        actuator,
    };
    (rider, asked)
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
impl Prepared {
    /// Run along `positions` (m) with `speeds` (m/s), given at every step and one more.
    ///
    /// `plan` has contact_every, line_every, links, nodes, points, ledger, near. `observe(step)` is
    /// called now and then and returns whether to go on. With `take` (numbers, function) the series are
    /// handed to the function whenever they hold that many numbers; what is returned has the rest of them. `state` is the one to go on from (steps done,
    /// numbers by name) or None, `until` the number of steps to stop after or None; the state there
    /// is part of what is returned.
    #[pyo3(signature = (riders, distances, positions, speeds, friction, loads, plan, observe, state=None, until=None, take=None))]
    fn run<'py>(
        &self,
        py: Python<'py>,
        riders: Vec<RiderData>,
        distances: Vec<f64>,
        positions: PyArrayLike1<'_, f64>,
        speeds: PyArrayLike1<'_, f64>,
        friction: f64,
        loads: Vec<LoadData>,
        plan: &Bound<'py, PyDict>,
        observe: &Bound<'py, PyAny>,
        state: Option<(usize, BTreeMap<String, Vec<f64>>)>,
        until: Option<usize>,
        take: Option<(usize, Py<PyAny>)>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let (riders, controllers): (Vec<Rider>, Vec<Option<Py<PyAny>>>) =
            riders.into_iter().map(rider).unzip();
        let travel = Travel {
            positions: positions.to_vec()?,
            speeds: speeds.to_vec()?,
            distances,
            friction,
            loads: loads
                .into_iter()
                .map(|(pattern, sizes)| Load { pattern, sizes })
                .collect(),
        };
        let plan = read_plan(plan)?;
        let state = state.map(|(step, numbers)| State { step, numbers });
        let observer = observe.clone().unbind();
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
            let mut ask = |rider: usize, sample: &Sample| {
                answer(controllers[rider].as_ref(), sample).map_err(|error| {
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
            let callers = Callers {
                observe: &mut go_on,
                ask: &mut ask,
                take: enough.map(|numbers| (numbers, &mut hand_on as _)),
            };
            either!(&self.0, p => p.run_pieces(&riders, &travel, &plan, part, callers))
        });
        match (outcome, raised.or(failed).or(lost)) {
            (Err(CoreError::Cancelled { .. } | CoreError::Control { .. }), Some(error)) => {
                Err(error)
            }
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
        either!(&self.0, p => (p.line.nodes(), p.fill(), p.columns.stored()))
    }
}

fn read_plan(plan: &Bound<'_, PyDict>) -> PyResult<RecordPlan> {
    let get = |key: &str| plan.as_any().get_item(key);
    Ok(RecordPlan {
        contact_every: get("contact_every")?.extract()?,
        line_every: get("line_every")?.extract()?,
        links: get("links")?.extract()?,
        nodes: get("nodes")?.extract()?,
        points: get("points")?.extract()?,
        ledger: get("ledger")?.extract()?,
        near: plan
            .get_item("near")?
            .map(|v| v.extract::<Option<NearData>>())
            .transpose()?
            .flatten()
            .map(near),
    })
}

pub fn numbers<'py>(py: Python<'py>, state: &State) -> PyResult<Bound<'py, PyDict>> {
    let out = PyDict::new(py);
    for (name, values) in &state.numbers {
        out.set_item(name, values.to_pyarray(py))?;
    }
    Ok(out)
}

fn arrays(py: Python<'_>, r: Record) -> PyResult<Bound<'_, PyDict>> {
    let out = PyDict::new(py);
    out.set_item("contacts", &r.contacts)?;
    out.set_item("energy", energies(py, &r.energy)?)?;
    out.set_item("slack_max", r.slack_max)?;
    out.set_item("pivots", r.pivots)?;
    out.set_item("pivots_max", r.pivots_max)?;
    out.set_item("pivot_counts", &r.pivot_counts)?;
    out.set_item("fallbacks", r.fallbacks)?;
    out.set_item("lcp_residual", r.lcp_residual)?;
    out.set_item("steps", r.steps)?;
    out.set_item("energy_residual", r.energy_residual)?;
    out.set_item("energy_turnover", r.energy_turnover)?;
    // The arrays take over the memory of the record: nothing is copied.
    let series: [(&str, Vec<f64>); 22] = [
        ("time", r.time),
        ("force", r.force),
        ("gap", r.gap),
        ("height", r.height),
        ("lateral", r.lateral),
        ("position", r.position),
        ("speed", r.speed),
        ("masses", r.masses),
        ("line_time", r.line_time),
        ("link_force", r.link_force),
        ("uplift", r.uplift),
        ("link_first", r.link_first),
        ("uplift_first", r.uplift_first),
        ("point_uplift", r.point_uplift),
        ("point_along", r.point_along),
        ("slack", r.slack),
        ("link_min", r.link_min),
        ("link_max", r.link_max),
        ("uplift_max", r.uplift_max),
        ("stop_max", r.stop_max),
        ("law_ranges", r.law_ranges),
        ("control", r.control),
    ];
    for (name, values) in series {
        out.set_item(name, values.into_pyarray(py))?;
    }
    Ok(out)
}

fn energies<'py>(py: Python<'py>, ledger: &[Entries]) -> PyResult<Bound<'py, PyDict>> {
    type Entry = (&'static str, fn(&Entries) -> f64);
    let entries: [Entry; 16] = [
        ("kinetic", |e| e.kinetic),
        ("elastic", |e| e.elastic),
        ("contact", |e| e.contact),
        ("riders", |e| e.riders),
        ("dissipated_line", |e| e.dissipated_line),
        ("dissipated_links", |e| e.dissipated_links),
        ("dissipated_springs", |e| e.dissipated_springs),
        ("dissipated_riders", |e| e.dissipated_riders),
        ("dissipated_scheme", |e| e.dissipated_scheme),
        ("switching", |e| e.switching),
        ("work_uplift", |e| e.work_uplift),
        ("work_control", |e| e.work_control),
        ("work_traction", |e| e.work_traction),
        ("work_friction", |e| e.work_friction),
        ("work_loads", |e| e.work_loads),
        ("residual", Entries::residual),
    ];
    let energy = PyDict::new(py);
    for (name, read) in entries {
        let values: Vec<f64> = ledger.iter().map(read).collect();
        energy.set_item(name, values.to_pyarray(py))?;
    }
    Ok(energy)
}
