//! Steps of a device that counts: whole ones, cut ones, refused ones; states; what is read when.

use super::{Device, Stepper, Substep};
use crate::failure::{Kind, invalid};
use crate::variable::{Causality, Variable};
use arcless_core::CoreError;
use arcless_core::checkpoint::Checkpoint;

/// Sum of what was put in, which moves evenly within a communication step. Refuses to pass 100.
#[derive(Debug, Default)]
struct Sum {
    place: f64,
    sum: f64,
    steps: usize,
}

const H: f64 = 0.25;

impl Device for Sum {
    fn variables(&self) -> Vec<Variable> {
        let text = || "what it is".to_string();
        vec![
            Variable::input("place".into(), "m", text(), 1.0),
            Variable::input("force".into(), "N", text(), 2.0),
            Variable::output("sum".into(), "m", text()),
            Variable::prediction("next".into(), "m", text()),
            Variable::constant("h", "s", "length", H),
        ]
    }

    fn step_length(&self) -> f64 {
        H
    }

    fn step(&mut self, inputs: &[f64], place: Substep) -> Result<(), CoreError> {
        let next = place.towards(self.place, inputs[0]);
        if next > 100.0 {
            return Err(invalid("place", "beyond 100"));
        }
        self.place = next;
        self.sum += next + inputs[1];
        self.steps += 1;
        Ok(())
    }

    fn read(&self, outputs: &mut [f64]) {
        outputs[0] = self.sum;
    }

    fn predict(&mut self, inputs: &[f64], outputs: &mut [f64]) -> Result<(), CoreError> {
        if inputs[0] > 100.0 {
            return Err(invalid("place", "beyond 100"));
        }
        outputs[0] = self.sum + inputs[0] + inputs[1];
        Ok(())
    }

    fn explain(&self, error: &CoreError) -> String {
        error.to_string()
    }

    fn save(&mut self) -> Result<Checkpoint, CoreError> {
        let mut saved = Checkpoint {
            step: self.steps,
            ..Checkpoint::default()
        };
        saved
            .numbers
            .insert("sum".into(), vec![self.place, self.sum]);
        Ok(saved)
    }

    fn restore(&mut self, saved: &Checkpoint) -> Result<(), CoreError> {
        let Some([place, sum]) = saved.numbers.get("sum").map(Vec::as_slice) else {
            return Err(invalid("state", "of another one"));
        };
        (self.place, self.sum, self.steps) = (*place, *sum, saved.step);
        Ok(())
    }
}

const TIME: usize = 0;
const PLACE: usize = 1;
const SUM: usize = 3;
const NEXT: usize = 4;

fn stepper() -> Stepper {
    Stepper::new(Box::new(Sum::default()), 7).expect("it stands")
}

fn value(stepper: &mut Stepper, number: usize) -> f64 {
    stepper.get(number).expect("a value")
}

#[test]
fn variables_are_numbered_in_their_order() {
    let mut s = stepper();
    let names: Vec<&str> = s.variables().iter().map(|v| v.name.as_str()).collect();
    assert_eq!(names, ["time", "place", "force", "sum", "next", "h"]);
    assert_eq!(s.variables()[TIME].causality, Causality::Independent);
    assert_eq!(s.find("sum"), Some(SUM));
    assert_eq!(s.find("none"), None);
    let all: Vec<f64> = (0..6).map(|number| value(&mut s, number)).collect();
    assert_eq!(all, [0.0, 1.0, 2.0, 0.0, 3.0, H]);
}

#[test]
fn a_long_step_is_cut_and_moves_evenly() {
    let mut s = stepper();
    s.set(PLACE, 4.0).expect("an input");
    s.advance(0.0, 4.0 * H).expect("four steps");
    // 1 + 2 + 3 + 4, and 2 in each.
    assert_eq!(value(&mut s, SUM), 18.0);
    assert_eq!((s.steps(), s.time()), (4, 1.0));
    // The last one reaches the target to the bit: 0.1 is no sum of thirds.
    let mut now = 0.0;
    for number in 0..3 {
        now = Substep { number, of: 3 }.towards(now, 0.1);
    }
    assert_eq!(now, 0.1);
}

#[test]
fn predictions_follow_the_inputs() {
    let mut s = stepper();
    assert_eq!(value(&mut s, NEXT), 3.0);
    s.set(PLACE, 5.0).expect("an input");
    assert_eq!(value(&mut s, NEXT), 7.0);
    s.step().expect("a step");
    assert_eq!(value(&mut s, SUM), 7.0);
    assert_eq!(value(&mut s, NEXT), 14.0);
    s.set(PLACE, 200.0).expect("an input");
    let failure = s.get(NEXT).expect_err("beyond");
    assert_eq!(failure.kind, Kind::Step);
    assert!(
        failure
            .message
            .starts_with("`next` has no value at t = 0.25 s: ")
    );
}

#[test]
fn what_is_wrong_is_refused_and_changes_nothing() {
    let mut s = stepper();
    for (number, given, words) in [
        (
            PLACE,
            f64::NAN,
            "`place` is NaN at t = 0 s: expected a finite number in m",
        ),
        (SUM, 1.0, "`sum` is set at t = 0 s: it is an output"),
        (TIME, 1.0, "`time` is set at t = 0 s: it is an independent"),
        (
            99,
            1.0,
            "no variable 99 at t = 0 s: their numbers are 0 to 5",
        ),
    ] {
        let failure = s.set(number, given).expect_err(words);
        assert_eq!(failure.kind, Kind::Value);
        assert!(failure.message.starts_with(words), "{failure}");
    }
    for (from, length) in [
        (0.0, 0.5 * H),
        (0.0, 0.0),
        (0.0, -H),
        (0.0, f64::NAN),
        (0.0, 1.001 * H),
        (H, H),
        (-H, H),
        (f64::NAN, H),
    ] {
        let failure = s.advance(from, length).expect_err("refused");
        assert_eq!(failure.kind, Kind::Time, "{from} {length}");
    }
    assert_eq!((s.steps(), value(&mut s, PLACE)), (0, 1.0));
}

#[test]
fn what_was_stepped_before_a_failure_stays() {
    let mut s = stepper();
    s.set(PLACE, 200.0).expect("an input");
    let failure = s.advance(0.0, 4.0 * H).expect_err("beyond");
    assert_eq!(failure.kind, Kind::Step);
    let words = "the step from t = 0.5 s to 0.75 s: ";
    assert!(failure.message.starts_with(words), "{failure}");
    assert_eq!(s.steps(), 2);
}

#[test]
fn states_are_of_one_model() {
    let mut s = stepper();
    s.begin(10.0).expect("a start");
    s.set(PLACE, 3.0).expect("an input");
    s.step().expect("a step");
    let saved = s.save().expect("a state");
    s.set(PLACE, 9.0).expect("an input");
    s.step().expect("a step");
    s.restore(&saved).expect("its own");
    assert_eq!(
        (s.time(), value(&mut s, PLACE), value(&mut s, SUM)),
        (10.25, 3.0, 5.0)
    );
    let mut other = Stepper::new(Box::new(Sum::default()), 8).expect("it stands");
    let failure = other.restore(&saved).expect_err("foreign");
    assert_eq!(
        failure.message,
        "a state is restored at t = 0 s: it is of another model"
    );
    assert!(s.restore(&saved[..20]).is_err());
    assert!(s.begin(0.0).is_err(), "a step was taken");
    s.reset().expect("a start");
    assert_eq!(
        (s.time(), value(&mut s, PLACE), value(&mut s, SUM)),
        (0.0, 1.0, 0.0)
    );
    assert!(s.begin(f64::INFINITY).is_err());
}
