//! Pantographs as they come from Python, by the names of their fields: see
//! `arcless.simulate.setup.core_data`.

use arcless_core::pantograph::actuator::Actuator;
use arcless_core::pantograph::breakpoint::ForceKind;
use arcless_core::pantograph::bump_stop::BumpStop;
use arcless_core::pantograph::excitation::{BaseMotion, Excitation, ForceHistory};
use arcless_core::pantograph::model::Pantograph;
use arcless_core::pantograph::piecewise_force::PiecewiseForce;
use arcless_core::pantograph::strip::Strip;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

#[derive(FromPyObject)]
pub struct PantographData {
    mass: Vec<f64>,
    damping: Vec<f64>,
    stiffness: Vec<f64>,
    strips: Vec<StripData>,
    preload: Vec<f64>,
    lift: Vec<f64>,
    start_force: f64,
    excitation: ExcitationData,
    stops: Vec<BumpStopData>,
    piecewise_forces: Vec<PiecewiseForceData>,
    actuator: Option<ActuatorData>,
    external: Option<Py<PyAny>>,
}

#[derive(FromPyObject)]
struct StripData {
    offset: f64,
    half_width: f64,
    knots: Vec<f64>,
    vectors: Vec<Vec<f64>>,
}

#[derive(FromPyObject)]
struct ExcitationData {
    forces: Vec<ForceHistoryData>,
    base: Option<BaseMotionData>,
}

#[derive(FromPyObject)]
struct ForceHistoryData {
    direction: Vec<f64>,
    values: Vec<f64>,
}

#[derive(FromPyObject)]
struct BaseMotionData {
    influence: Vec<f64>,
    displacement: Vec<f64>,
    rate: Vec<f64>,
}

#[derive(FromPyObject)]
struct BumpStopData {
    direction: Vec<f64>,
    gap: f64,
    stiffness: f64,
}

#[derive(FromPyObject)]
struct PiecewiseForceData {
    direction: Vec<f64>,
    is_damper: bool,
    points: Vec<[f64; 2]>,
}

#[derive(FromPyObject)]
struct ActuatorData {
    direction: Vec<f64>,
    every: usize,
    delay: usize,
    controller: Option<Py<PyAny>>,
}

impl From<StripData> for Strip {
    fn from(data: StripData) -> Self {
        Self {
            offset: data.offset,
            half_width: data.half_width,
            knots: data.knots,
            vectors: data.vectors,
        }
    }
}

impl From<ExcitationData> for Excitation {
    fn from(data: ExcitationData) -> Self {
        let forces = data.forces.into_iter().map(|force| ForceHistory {
            direction: force.direction,
            values: force.values,
        });
        Self {
            forces: forces.collect(),
            base: data.base.map(|base| BaseMotion {
                influence: base.influence,
                displacement: base.displacement,
                rate: base.rate,
            }),
        }
    }
}

impl From<BumpStopData> for BumpStop {
    fn from(data: BumpStopData) -> Self {
        Self {
            direction: data.direction,
            gap: data.gap,
            stiffness: data.stiffness,
        }
    }
}

impl From<PiecewiseForceData> for PiecewiseForce {
    fn from(data: PiecewiseForceData) -> Self {
        Self {
            direction: data.direction,
            kind: if data.is_damper {
                ForceKind::Damper
            } else {
                ForceKind::Spring
            },
            points: data.points,
        }
    }
}

/// Pantograph of the core, with the objects of Python that are asked about it during a run.
pub struct AskedPantograph {
    pub pantograph: Pantograph,
    /// Controller of its actuator.
    pub controller: Option<Py<PyAny>>,
    /// Program that moves it, of an external one.
    pub program: Option<Py<PyAny>>,
}

/// Objects of Python for each pantograph; None where there is none.
pub type Objects = Vec<Option<Py<PyAny>>>;

impl AskedPantograph {
    /// Splits a list into pantographs, their controllers and their programs.
    pub fn split(list: Vec<Self>) -> (Vec<Pantograph>, [Objects; 2]) {
        let (mut pantographs, mut asked) = (Vec::new(), [Vec::new(), Vec::new()]);
        for own in list {
            pantographs.push(own.pantograph);
            asked[0].push(own.controller);
            asked[1].push(own.program);
        }
        (pantographs, asked)
    }
}

/// External pantograph: it has strips and a force at the start alone.
fn external(data: PantographData) -> PyResult<Pantograph> {
    let numbers = [
        &data.mass,
        &data.damping,
        &data.stiffness,
        &data.preload,
        &data.lift,
    ];
    let has_forces = data.actuator.is_some()
        || !(data.stops.is_empty() && data.piecewise_forces.is_empty())
        || !data.excitation.forces.is_empty()
        || data.excitation.base.is_some();
    if has_forces || numbers.iter().any(|list| !list.is_empty()) {
        let message = "an external pantograph has no matrices and no forces of its own";
        return Err(PyValueError::new_err(message));
    }
    let size = data.strips.first().and_then(|strip| strip.vectors.first());
    let size = size.map_or(0, Vec::len);
    let strips = data.strips.into_iter().map(Strip::from).collect();
    Ok(Pantograph::external(strips, size, data.start_force))
}

/// Pantograph of the core.
pub fn pantograph(mut data: PantographData) -> PyResult<AskedPantograph> {
    if let Some(program) = data.external.take() {
        return Ok(AskedPantograph {
            pantograph: external(data)?,
            controller: None,
            program: Some(program),
        });
    }
    let (actuator, controller) = data.actuator.map_or((None, None), |own| {
        let actuator = Actuator {
            direction: own.direction,
            every: own.every,
            delay: own.delay,
        };
        (Some(actuator), own.controller)
    });
    let pantograph = Pantograph {
        mass: data.mass,
        damping: data.damping,
        stiffness: data.stiffness,
        strips: data.strips.into_iter().map(Strip::from).collect(),
        preload: data.preload,
        lift: data.lift,
        start_force: data.start_force,
        excitation: data.excitation.into(),
        stops: data.stops.into_iter().map(BumpStop::from).collect(),
        piecewise_forces: data
            .piecewise_forces
            .into_iter()
            .map(PiecewiseForce::from)
            .collect(),
        actuator,
        is_external: false,
    };
    Ok(AskedPantograph {
        pantograph,
        controller,
        program: None,
    })
}
