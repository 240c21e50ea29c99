//! Variables of a line as a device.

use crate::line::{Kind, LineDevice, Travel};
use crate::model::element;
use crate::pantograph::constants;
use crate::variable::Variable;
use arcless_core::session::prepared::{Drive, Prepared};

/// Variables: inputs, outputs, predictions, constants.
pub(crate) fn of(device: &LineDevice, prepared: &Prepared) -> Vec<Variable> {
    let mut all = inputs(device, prepared);
    all.extend(outputs(device));
    all.extend(predictions(device));
    let session = &device.session;
    all.extend(constants(device.step_length, session.old_weight()));
    let what = "Flexibility of contact between strip and wire: 1 over the contact stiffness";
    let flexibility = session.contact_flexibility();
    all.push(Variable::constant(
        "contact_flexibility",
        "m/N",
        what,
        flexibility,
    ));
    all
}

fn inputs(device: &LineDevice, prepared: &Prepared) -> Vec<Variable> {
    let (names, start) = (&device.names, prepared.start);
    let input =
        |name: String, unit, what: &str, start| Variable::input(name, unit, what.into(), start);
    let mut all = vec![match device.travel {
        Travel::Position => input(
            "position".into(),
            "m",
            "Position of the first pantograph along the track at the end of the step, to which it \
             moves evenly",
            start.position,
        ),
        Travel::Speed => input(
            "speed".into(),
            "m/s",
            "Speed at the end of the step, to which it changes evenly",
            start.speed,
        ),
    }];
    match &prepared.drive {
        Drive::Forces { forces, .. } => {
            for (name, force) in names.strips.iter().zip(forces) {
                let what = "Contact force on the wire during the step, upwards positive";
                all.push(input(format!("{name}.contact_force"), "N", what, *force));
            }
        }
        Drive::Strips { .. } => {
            let heights = &device.session.outputs().strip_height;
            for (name, height) in names.strips.iter().zip(heights) {
                let what = "Height of the strip above the rail at the start of the step; with \
                            strip_compliance that at its end without contact force in the step";
                all.push(input(format!("{name}.strip_height"), "m", what, *height));
            }
            for name in &names.strips {
                let what = "Velocity of the strip, with which its height moves on in the step; 0 \
                            where strip_height is that at the end";
                all.push(input(format!("{name}.strip_velocity"), "m/s", what, 0.0));
            }
            for (name, strips) in names.pantographs.iter().zip(&device.strips) {
                let count = strips.len();
                for place in (0..count).flat_map(|i| (0..count).map(move |j| (i, j))) {
                    let what = "Compliance of the strips in the step: contact forces lower them by \
                                it; 0 holds them at the height that is given";
                    let name = format!("{name}.{}", element("strip_compliance", count, place));
                    all.push(input(name, "m/N", what, 0.0));
                }
            }
        }
        Drive::Pantographs { .. } => {
            for name in &names.driven {
                let what = "Controlled force during the step, upwards positive";
                all.push(input(format!("{name}.control_force"), "N", what, 0.0));
            }
        }
    }
    all
}

fn outputs(device: &LineDevice) -> Vec<Variable> {
    let names = &device.names;
    let output = |name: String, unit, what: &str| Variable::output(name, unit, what.into());
    let mut all = vec![match device.travel {
        Travel::Position => output("speed".into(), "m/s", "Speed"),
        Travel::Speed => output(
            "position".into(),
            "m",
            "Position of the first pantograph along the track",
        ),
    }];
    if device.kind != Kind::ContactForce {
        for name in &names.strips {
            let what = "Contact force of the strip at the time of balance of the step";
            all.push(output(format!("{name}.contact_force"), "N", what));
        }
        for (name, strips) in names.pantographs.iter().zip(&device.strips) {
            if strips.len() > 1 {
                let what = "Contact force of all strips at the time of balance of the step";
                all.push(output(format!("{name}.contact_force"), "N", what));
            }
        }
    }
    for name in &names.strips {
        let what = "Height of the contact wire above the rail at the strip";
        all.push(output(format!("{name}.wire_height"), "m", what));
    }
    for name in &names.strips {
        let what = "Rate of the height of the contact wire that the moving strip meets";
        all.push(output(format!("{name}.wire_velocity"), "m/s", what));
    }
    for name in names.strips.iter().filter(|_| names.is_spatial) {
        let what = "Lateral position of the contact wire at the strip, to the left positive";
        all.push(output(format!("{name}.wire_lateral"), "m", what));
    }
    if device.kind == Kind::StripHeight {
        for name in &names.strips {
            let what = "Height of the strip above the rail that the step has reached";
            all.push(output(format!("{name}.reached_height"), "m", what));
        }
    }
    for name in &names.heights {
        let what = "Displacement since the start, upwards positive";
        all.push(output(format!("{name}.displacement"), "m", what));
    }
    for name in &names.heights {
        let what = "Velocity, upwards positive";
        all.push(output(format!("{name}.velocity"), "m/s", what));
    }
    for name in &names.supports {
        let what = "Uplift of the contact wire at the support";
        all.push(output(format!("{name}.uplift"), "m", what));
    }
    all
}

fn predictions(device: &LineDevice) -> Vec<Variable> {
    if device.kind != Kind::ContactForce {
        return Vec::new();
    }
    let (strips, count) = (&device.names.strips, device.names.strips.len());
    let prediction = |name, unit, what: &str| Variable::prediction(name, unit, what.into());
    let mut all = Vec::new();
    for name in strips {
        let what = "Height of the contact wire at the time of balance of the next step without \
                    contact forces in it, about those that are set";
        all.push(prediction(format!("{name}.free_height"), "m", what));
    }
    for place in (0..count).flat_map(|i| (0..count).map(move |j| (i, j))) {
        let what = "Compliance of the contact wire in the next step: contact forces raise it above \
                    free_height by it";
        all.push(prediction(element("compliance", count, place), "m/N", what));
    }
    for name in strips {
        let what = "Stiffness of the contact wire that the strip feels in the next step: 1 over its \
                    compliance";
        all.push(prediction(format!("{name}.wire_stiffness"), "N/m", what));
    }
    all
}
