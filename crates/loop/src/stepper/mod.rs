//! Values of the variables of a device, whole steps, and states.
//!
//! Inputs hold until they are given again. A communication step of H = n h is n steps of the
//! device; within it a position, and what has a velocity, moves on evenly.

use crate::failure::{Failure, Kind};
use crate::file;
use crate::variable::{Causality, Variable};
use arcless_core::CoreError;
use arcless_core::checkpoint::Checkpoint;
use std::collections::BTreeMap;

/// Largest difference from a whole number of steps, as a share of a step: lengths are differences
/// of times, which lose 10⁻¹⁰ of a millisecond in an hour.
const LENGTH_TOLERANCE: f64 = 1e-6;
/// Largest difference between the time that is named and that of the device, as a share of a step:
/// a step left out or taken twice is a whole one, sums of a million lengths lose 10⁻⁶.
const TIME_TOLERANCE: f64 = 1e-3;

/// Place of a step of the device within a communication step.
#[derive(Debug, Clone, Copy)]
pub struct Substep {
    /// Number, from 0.
    pub number: usize,
    /// Number of steps of the communication step.
    pub of: usize,
}

impl Substep {
    /// Single step.
    pub const WHOLE: Self = Self { number: 0, of: 1 };

    /// Value at the end of this step of what moves evenly to `target`, from `now` at its start.
    #[must_use]
    pub fn towards(self, now: f64, target: f64) -> f64 {
        let left = self.of - self.number;
        if left == 1 {
            return target;
        }
        now + (target - now) / left as f64
    }
}

/// Device that takes whole steps. Values are in the order of its variables of the same role.
pub trait Device: Send {
    /// Variables: inputs, then outputs, then constants.
    fn variables(&self) -> Vec<Variable>;

    /// Length of a step, s.
    fn step_length(&self) -> f64;

    /// Takes a step; after a failure the device stands where it stood.
    ///
    /// # Errors
    /// Any of the core.
    fn step(&mut self, inputs: &[f64], place: Substep) -> Result<(), CoreError>;

    /// Reads the outputs that the last step has left.
    fn read(&self, outputs: &mut [f64]);

    /// Reads the outputs that say what the next step would bring, a single one.
    ///
    /// # Errors
    /// Any of the core.
    fn predict(&mut self, inputs: &[f64], outputs: &mut [f64]) -> Result<(), CoreError>;

    /// Message of a failure of the core, with the names of the parts of the device.
    fn explain(&self, error: &CoreError) -> String;

    /// State between two steps.
    ///
    /// # Errors
    /// None for a state that steps have left.
    fn save(&mut self) -> Result<Checkpoint, CoreError>;

    /// Restores a state.
    ///
    /// # Errors
    /// [`CoreError::Input`] for a state of another device; the present one is then kept.
    fn restore(&mut self, saved: &Checkpoint) -> Result<(), CoreError>;
}

/// Device with the values of its variables. Variable 0 is time; the others are numbered from 1 in
/// the order of [`Device::variables`].
pub struct Stepper {
    device: Box<dyn Device>,
    variables: Vec<Variable>,
    /// Values by number; that of time is not kept here.
    values: Vec<f64>,
    inputs: Range,
    outputs: Range,
    predictions: Range,
    steps: u64,
    /// Time of the start, s.
    origin: f64,
    step_length: f64,
    digest: u128,
    /// True when the outputs of the last step have been read, and when the predictions are those
    /// of the present inputs.
    is_read: bool,
    is_predicted: bool,
    beginning: Vec<u8>,
}

type Range = std::ops::Range<usize>;

/// Saved state: steps, inputs, and what moves.
#[derive(serde::Serialize, serde::Deserialize)]
struct SavedState {
    model: u128,
    origin: f64,
    steps: u64,
    inputs: Vec<f64>,
    step: u64,
    numbers: BTreeMap<String, Vec<f64>>,
}

impl Stepper {
    /// Device of an exported file, at its start.
    ///
    /// # Errors
    /// [`Failure`]: no such file, a damaged one, or one whose model cannot be stepped.
    pub fn open(bytes: &[u8]) -> Result<Self, Failure> {
        let (digest, model) = file::unpack(bytes)?;
        Self::new(model.device()?, digest)
    }

    /// Device at its start, with the digest of the model that it is of.
    ///
    /// # Errors
    /// [`Failure`] of saving its state.
    pub fn new(device: Box<dyn Device>, digest: u128) -> Result<Self, Failure> {
        let mut variables = vec![Variable::time()];
        variables.extend(device.variables());
        let find = |wanted: &dyn Fn(&Variable) -> bool| {
            let first = variables.iter().position(wanted).unwrap_or(0);
            let count = variables.iter().filter(|v| wanted(v)).count();
            first..first + count
        };
        let is = |v: &Variable, causality| v.causality == causality;
        let mut made = Self {
            inputs: find(&|v| is(v, Causality::Input)),
            outputs: find(&|v| is(v, Causality::Output) && !v.is_prediction),
            predictions: find(&|v| v.is_prediction),
            values: variables.iter().map(|v| v.start).collect(),
            step_length: device.step_length(),
            variables,
            device,
            steps: 0,
            origin: 0.0,
            digest,
            is_read: false,
            is_predicted: false,
            beginning: Vec::new(),
        };
        made.beginning = made.save()?;
        Ok(made)
    }

    /// Variables; the number of each is its place.
    #[must_use]
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// Digest of the model.
    #[must_use]
    pub fn digest(&self) -> u128 {
        self.digest
    }

    /// Length of a step, s.
    #[must_use]
    pub fn step_length(&self) -> f64 {
        self.step_length
    }

    /// Number of steps taken.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Time, s.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.origin + self.steps as f64 * self.step_length
    }

    /// Sets the time of the start, s, before the first step; 0 without.
    ///
    /// # Errors
    /// [`Kind::Time`]: not finite, or steps have been taken.
    pub fn begin(&mut self, time: f64) -> Result<(), Failure> {
        if !time.is_finite() || self.steps > 0 {
            let (now, count) = (self.time(), self.steps);
            let message = format!(
                "a start at t = {time} s, where the device stands at t = {now} s after {count} \
                 steps: expected a finite time, before the first step"
            );
            return Err(Failure::new(Kind::Time, message));
        }
        self.origin = time;
        Ok(())
    }

    /// Number of a variable.
    #[must_use]
    pub fn find(&self, name: &str) -> Option<usize> {
        self.variables.iter().position(|v| v.name == name)
    }

    /// Variable by its number.
    ///
    /// # Errors
    /// [`Kind::Value`]: there is none.
    fn variable(&self, number: usize) -> Result<&Variable, Failure> {
        self.variables.get(number).ok_or_else(|| {
            let last = self.variables.len() - 1;
            let message = format!(
                "no variable {number} at t = {} s: their numbers are 0 to {last}",
                self.time()
            );
            Failure::new(Kind::Value, message)
        })
    }

    /// Sets an input.
    ///
    /// # Errors
    /// [`Kind::Value`]: no input, or not a finite number.
    pub fn set(&mut self, number: usize, value: f64) -> Result<(), Failure> {
        let variable = self.variable(number)?;
        if variable.causality != Causality::Input {
            let message = format!(
                "`{}` is set at t = {} s: it is an {}, only inputs are set",
                variable.name,
                self.time(),
                variable.causality.name()
            );
            return Err(Failure::new(Kind::Value, message));
        }
        if !value.is_finite() {
            let message = format!(
                "`{}` is {value} at t = {} s: expected a finite number in {}; whatever gives it \
                 has failed before",
                variable.name,
                self.time(),
                variable.unit
            );
            return Err(Failure::new(Kind::Value, message));
        }
        self.is_predicted &= self.values[number].to_bits() == value.to_bits();
        self.values[number] = value;
        Ok(())
    }

    /// Value of a variable.
    ///
    /// # Errors
    /// [`Kind::Value`]: there is no such variable. [`Kind::Step`]: the step that a prediction is of
    /// would fail.
    pub fn get(&mut self, number: usize) -> Result<f64, Failure> {
        self.variable(number)?;
        if number == 0 {
            return Ok(self.time());
        }
        if self.outputs.contains(&number) && !self.is_read {
            self.device.read(&mut self.values[self.outputs.clone()]);
            self.is_read = true;
        }
        if self.predictions.contains(&number) && !self.is_predicted {
            self.predict(number)?;
        }
        Ok(self.values[number])
    }

    fn predict(&mut self, number: usize) -> Result<(), Failure> {
        let (known, later) = self.values.split_at_mut(self.predictions.start);
        let inputs = &known[self.inputs.clone()];
        let found = self
            .device
            .predict(inputs, &mut later[..self.predictions.len()]);
        if let Err(error) = found {
            let (name, reason) = (&self.variables[number].name, self.device.explain(&error));
            let message = format!("`{name}` has no value at t = {} s: {reason}", self.time());
            return Err(Failure::new(Kind::Step, message));
        }
        self.is_predicted = true;
        Ok(())
    }

    /// Takes a step.
    ///
    /// # Errors
    /// [`Kind::Step`]; the device then stands where it stood.
    pub fn step(&mut self) -> Result<(), Failure> {
        self.substep(Substep::WHOLE)
    }

    fn substep(&mut self, place: Substep) -> Result<(), Failure> {
        let taken = self.device.step(&self.values[self.inputs.clone()], place);
        if let Err(error) = taken {
            let reason = self.device.explain(&error);
            let (begin, end) = (self.time(), self.time() + self.step_length);
            let message = format!("the step from t = {begin} s to {end} s: {reason}");
            return Err(Failure::new(Kind::Step, message));
        }
        self.steps += 1;
        (self.is_read, self.is_predicted) = (false, false);
        Ok(())
    }

    /// Takes the whole steps of a communication step from `from` of the length `length`, s.
    ///
    /// # Errors
    /// [`Kind::Time`]: another time, or a length that is no whole number of steps. [`Kind::Step`]:
    /// the steps before the one that failed are taken.
    pub fn advance(&mut self, from: f64, length: f64) -> Result<(), Failure> {
        let (now, h) = (self.time(), self.step_length);
        // Written so that NaN is refused as well.
        let is_now = (from - now).abs() <= TIME_TOLERANCE * h;
        if !is_now {
            let message = format!(
                "a step from t = {from} s: the device stands at t = {now} s, and steps follow one \
                 another; restore a state to go back"
            );
            return Err(Failure::new(Kind::Time, message));
        }
        let count = (length / h).round();
        let is_whole = count >= 1.0 && (length / h - count).abs() <= LENGTH_TOLERANCE;
        if !is_whole {
            let message = format!(
                "a step of {length} s at t = {now} s: expected a whole number of steps of {h} s"
            );
            return Err(Failure::new(Kind::Time, message));
        }
        let of = count as usize;
        (0..of).try_for_each(|number| self.substep(Substep { number, of }))
    }

    /// State between two steps, as bytes.
    ///
    /// # Errors
    /// [`Failure`] of the device.
    pub fn save(&mut self) -> Result<Vec<u8>, Failure> {
        let saved = self.device.save();
        let saved = saved.map_err(|error| Failure::data(self.device.explain(&error)))?;
        let state = SavedState {
            model: self.digest,
            origin: self.origin,
            steps: self.steps,
            inputs: self.values[self.inputs.clone()].to_vec(),
            step: saved.step as u64,
            numbers: saved.numbers,
        };
        let body = postcard::to_allocvec(&state);
        let unwritten = |error| Failure::data(format!("the state cannot be written: {error}"));
        Ok(file::wrap(&body.map_err(unwritten)?))
    }

    /// Restores a state of this model: the steps that follow are those that followed it, bit for
    /// bit.
    ///
    /// # Errors
    /// [`Kind::Data`]: damaged, or of another model; the present state is then kept.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        let at = |reason: String, time: f64| {
            Failure::data(format!("a state is restored at t = {time} s: {reason}"))
        };
        let time = self.time();
        let body = match file::contents(bytes) {
            Ok((_, body)) => body,
            Err(_) => return Err(at("it is damaged, or none".into(), time)),
        };
        let state: SavedState = postcard::from_bytes(body)
            .map_err(|_| at("it is of another kind of model".into(), time))?;
        if state.model != self.digest || state.inputs.len() != self.inputs.len() {
            return Err(at("it is of another model".into(), time));
        }
        let saved = Checkpoint {
            step: state.step as usize,
            numbers: state.numbers,
        };
        if let Err(error) = self.device.restore(&saved) {
            return Err(at(self.device.explain(&error), time));
        }
        self.values[self.inputs.clone()].copy_from_slice(&state.inputs);
        (self.origin, self.steps) = (state.origin, state.steps);
        (self.is_read, self.is_predicted) = (false, false);
        Ok(())
    }

    /// Returns to the start, with the inputs of the start.
    ///
    /// # Errors
    /// None for a device whose state was saved at the start.
    pub fn reset(&mut self) -> Result<(), Failure> {
        let beginning = std::mem::take(&mut self.beginning);
        let restored = self.restore(&beginning);
        self.beginning = beginning;
        restored
    }
}

impl std::fmt::Debug for Stepper {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Stepper")
            .field("digest", &self.digest)
            .field("steps", &self.steps)
            .finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests;
