//! Steps an FMU with given forces and prints the bits of what comes out.
//!
//!     arcless-importer FILE.fmu VERSION STEPS INPUT OUTPUT
//!
//! INPUT gets 120 + 40 sin(0.02 n) in step n; the bits of OUTPUT are printed after each step.

use fmi_rs::fmi2::builder::FMU2Builder;
use fmi_rs::fmi2::types::{fmi2Status, fmi2True};
use fmi_rs::fmi3::builder::FMU3Builder;
use fmi_rs::fmi3::types::fmi3Status;
use std::path::PathBuf;

fn force(step: u32) -> f64 {
    120.0 + 40.0 * (0.02 * f64::from(step)).sin()
}

fn main() {
    let all: Vec<String> = std::env::args().collect();
    let [_, path, version, steps, input, output] = &all[..] else {
        panic!("FILE VERSION STEPS INPUT OUTPUT");
    };
    let (path, steps) = (PathBuf::from(path), steps.parse().expect("a number"));
    match version.as_str() {
        "2" => fmi2(&path, steps, input, output),
        _ => fmi3(&path, steps, input, output),
    }
}

fn fmi2(path: &PathBuf, steps: u32, input: &str, output: &str) {
    let made = FMU2Builder::new(path).expect("an FMU");
    let variables = &made.model_description.modelVariables;
    let find = |name: &str| {
        let found = variables.iter().find(|v| v.name == name);
        found.expect("a variable").valueReference
    };
    let (input, output) = ([find(input)], [find(output), find("step_length")]);
    let fmu = made.instantiate_cs("line").expect("an instance");
    let ok = |status| assert_eq!(status, fmi2Status::Ok);
    ok(fmu.setupExperiment(None, 0.0, None));
    ok(fmu.enterInitializationMode());
    ok(fmu.exitInitializationMode());
    let mut found = [0.0; 2];
    ok(fmu.getReal(&output, &mut found));
    let h = found[1];
    for step in 0..steps {
        ok(fmu.setReal(&input, &[force(step)]));
        ok(fmu.doStep(f64::from(step) * h, h, fmi2True));
        ok(fmu.getReal(&output, &mut found));
        println!("{:016x}", found[0].to_bits());
    }
    ok(fmu.terminate());
}

fn fmi3(path: &PathBuf, steps: u32, input: &str, output: &str) {
    let mut made = FMU3Builder::new(path).expect("an FMU");
    (made.eventModeUsed, made.earlyReturnAllowed) = (false, false);
    let variables = &made.model_description.modelVariables;
    let find = |name: &str| {
        let found = variables.iter().find(|v| v.name == name);
        found.expect("a variable").valueReference
    };
    let (input, output) = ([find(input)], [find(output), find("step_length")]);
    let fmu = made.instantiate_cs("line").expect("an instance");
    let ok = |status| assert_eq!(status, fmi3Status::Ok);
    ok(fmu.enterInitializationMode(None, 0.0, None));
    ok(fmu.exitInitializationMode());
    let mut found = [0.0; 2];
    ok(fmu.getFloat64(&output, &mut found));
    let (h, mut time) = (found[1], 0.0);
    let mut flags = [false; 3];
    for step in 0..steps {
        ok(fmu.setFloat64(&input, &[force(step)]));
        let [event, end, early] = &mut flags;
        ok(fmu.doStep(f64::from(step) * h, h, true, event, end, early, &mut time));
        ok(fmu.getFloat64(&output, &mut found));
        println!("{:016x}", found[0].to_bits());
    }
    ok(fmu.terminate());
}
