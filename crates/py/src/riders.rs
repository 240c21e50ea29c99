//! Riders as they come from Python.

use arcless_core::pantograph::actuator::Actuator;
use arcless_core::pantograph::breakpoint::ForceKind;
use arcless_core::pantograph::bump_stop::BumpStop;
use arcless_core::pantograph::excitation::{BaseMotion, Excitation, ForceHistory};
use arcless_core::pantograph::piecewise_force::PiecewiseForce;
use arcless_core::pantograph::strip::Strip;
use arcless_core::pantograph::system::Pantograph;
use pyo3::prelude::*;

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

/// Direction that opens the stop, gap in m, stiffness in N/m.
type StopData = (Vec<f64>, f64, f64);

/// Direction of a spring or damper, whether it is a damper, points (m or m/s, N).
type LawData = (Vec<f64>, bool, Vec<[f64; 2]>);

fn given((forces, ground): GivenData) -> Excitation {
    let history = |(direction, values)| ForceHistory { direction, values };
    Excitation {
        forces: forces.into_iter().map(history).collect(),
        ground: ground.map(|(carried, displacement, rate)| BaseMotion {
            carried,
            displacement,
            rate,
        }),
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

fn stop((direction, gap, stiffness): StopData) -> BumpStop {
    BumpStop {
        direction,
        gap,
        stiffness,
    }
}

fn law((direction, is_damper, points): LawData) -> PiecewiseForce {
    PiecewiseForce {
        direction,
        motion: if is_damper {
            ForceKind::Damper
        } else {
            ForceKind::Spring
        },
        points,
    }
}

/// The rider, and who is asked for the force of its actuator.
pub fn rider(data: RiderData) -> (Pantograph, Option<Py<PyAny>>) {
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
    let rider = Pantograph {
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
