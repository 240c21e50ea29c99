//! Actuators: when a force is asked for, when it acts, and where its work is booked.

use crate::tests::common;

use arcless_core::CoreError;
use arcless_core::pantograph::actuator::{Actuator, Sample};
use arcless_core::pantograph::excitation::ForceHistory;
use arcless_core::pantograph::model::Pantograph;
use arcless_core::scheme::Scheme;
use arcless_core::simulation::recording::record::Record;
use common::{difference, everything, three_masses, travel};

fn controlled(
    pantograph: Pantograph,
    scheme: Scheme,
    ask: &mut dyn FnMut(usize, &Sample) -> Result<f64, String>,
) -> Result<Record, CoreError> {
    let p = common::prepare(common::simple_line(4), |_| (), scheme, 1e-3, 50e3);
    let way = travel(70.0, 120.0, 70.0, 1e-3);
    p.run_controlled(&[pantograph], &way, &everything(), &mut |_| true, ask)
}

fn with_actuator(every: usize, delay: usize) -> Pantograph {
    let mut pantograph = three_masses(90.0);
    let direction = vec![1.0, 0.0, 0.0];
    pantograph.actuator = Some(Actuator {
        direction,
        every,
        delay,
    });
    pantograph
}

#[test]
fn a_force_acts_from_its_delay_on_until_the_next_one() {
    for (every, delay) in [(1, 0), (1, 2), (5, 0), (5, 3), (5, 12)] {
        let mut times = Vec::new();
        let r = controlled(
            with_actuator(every, delay),
            Scheme::generalised_alpha(0.9),
            &mut |_, sample| {
                times.push(sample.time);
                Ok(1.0 + sample.number as f64)
            },
        )
        .expect("it runs");
        let known = |step: usize| match step.checked_sub(delay) {
            None => 0.0,
            Some(after) => 1.0 + (after / every) as f64,
        };
        let known: Vec<f64> = (0..r.steps).map(known).collect();
        assert_eq!(r.control, known, "{every} {delay}");
        let known = (0..times.len()).map(|i| (i * every) as f64 * 1e-3);
        assert!(
            times
                .iter()
                .zip(known)
                .all(|(t, known)| (t - known).abs() < 1e-15)
        );
    }
}

/// A controller's force, constant within a step, equals a prescribed force, for a scheme that reads
/// it at the end of the step.
#[test]
fn an_answered_force_is_a_given_force() {
    let scheme = Scheme::newmark(0.3025, 0.6);
    let force = |time: f64| 20.0 * (9.0 * time).sin();
    let answered =
        controlled(with_actuator(1, 0), scheme, &mut |_, s| Ok(force(s.time))).expect("it runs");
    let mut pantograph = three_masses(90.0);
    let count = travel(70.0, 120.0, 70.0, 1e-3).positions.len();
    // Newmark's balance is at the end of the step, where the answer of its start is held.
    let values = (0..count).map(|i| force(i.saturating_sub(1) as f64 * 1e-3));
    pantograph.excitation.forces.push(ForceHistory {
        direction: vec![1.0, 0.0, 0.0],
        values: values.collect(),
    });
    let given = controlled(pantograph, scheme, &mut |_, _| Err("nobody".into())).expect("it runs");
    // Rounding, which slack links let grow.
    assert!(difference(&answered.force, &given.force) < 1e-9);
    let work = |r: &Record, own: bool| {
        let e = r.energy.last().expect("a record");
        if own { e.work_control } else { e.work_uplift }
    };
    assert!(work(&answered, true).abs() > 0.01);
    let [both, one] = [
        work(&answered, true) + work(&answered, false),
        work(&given, false),
    ];
    // Rounding of work of some joules.
    assert!((both - one).abs() < 1e-9, "{both} {one}");
}

#[test]
fn the_balance_closes_with_an_actuator() {
    for scheme in [
        Scheme::generalised_alpha(1.0),
        Scheme::generalised_alpha(0.9),
        Scheme::newmark(1.0, 1.0),
        Scheme::BackwardDifference,
    ] {
        let r = controlled(with_actuator(3, 4), scheme, &mut |_, s| {
            Ok(0.5 * (90.0 - s.force) - 40.0 * s.velocities[0])
        })
        .expect("it runs");
        // Rounding of some 1e3 sums.
        let relative = r.energy_residual / r.energy_turnover;
        assert!(relative < 1e-11, "{scheme:?}: {relative:e}");
        assert!(r.energy.last().expect("a record").work_control.abs() > 0.01);
    }
}

#[test]
fn no_force_is_an_error_that_says_when() {
    let scheme = Scheme::generalised_alpha(0.9);
    type Answer = fn(&Sample) -> Result<f64, String>;
    let answers: [Answer; 2] = [
        |s| {
            if s.number < 7 {
                Ok(1.0)
            } else {
                Err("lost".into())
            }
        },
        |s| Ok(if s.number < 7 { 1.0 } else { f64::NAN }),
    ];
    for (answer, words) in answers.into_iter().zip(["lost", "NaN"]) {
        let error =
            controlled(with_actuator(2, 0), scheme, &mut |_, s| answer(s)).expect_err("it fails");
        let CoreError::Control {
            pantograph,
            step,
            position,
            reason,
            ..
        } = error
        else {
            panic!("{error}")
        };
        // Rounding of a place of 70 m.
        assert_eq!((pantograph, step), (0, 14));
        assert!((position - 70.0 - 0.07 * 14.0).abs() < 1e-9);
        assert!(reason.contains(words), "{reason}");
    }
    let mut wrong = with_actuator(0, 0);
    assert!(controlled(wrong.clone(), scheme, &mut |_, _| Ok(0.0)).is_err());
    wrong.actuator = Some(Actuator {
        direction: vec![1.0],
        every: 1,
        delay: 0,
    });
    assert!(controlled(wrong, scheme, &mut |_, _| Ok(0.0)).is_err());
}
