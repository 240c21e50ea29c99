//! Pantograph by itself as a device: contact forces in, heights of the strips out.

use crate::failure::invalid;
use crate::model::{element, strip_prefixes};
use crate::stepper::{Device, Substep};
use crate::variable::{Variable, identifiers};
use arcless_core::CoreError;
use arcless_core::checkpoint::Checkpoint;
use arcless_core::pantograph::model::Pantograph;
use arcless_core::scheme::Scheme;
use arcless_core::session::alone::{Alone, AloneInputs, AloneStart};
use serde::{Deserialize, Serialize};

/// Exported pantograph.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct PantographModel {
    /// Name.
    pub name: String,
    /// Pantograph.
    pub pantograph: Pantograph,
    /// Scheme of the steps.
    pub scheme: Scheme,
    /// Length of a step, s.
    pub step_length: f64,
    /// Start, in equilibrium on the line of its scenario.
    pub start: AloneStart,
    /// Speed at the start, m/s.
    pub speed: f64,
    /// Coordinates that are heights, with the names of what they are of.
    pub heights: Vec<(usize, String)>,
}

/// Pantograph by itself.
#[derive(Debug)]
pub struct PantographDevice {
    alone: Alone,
    model: PantographModel,
    /// Speed at the end of the last step, m/s.
    speed: f64,
    layout: Layout,
    /// Lateral positions of a step, m; zero where they do not count.
    laterals: Vec<f64>,
}

/// Places of the inputs; none where the pantograph has no such input.
#[derive(Debug, Clone, Copy, Default)]
struct Layout {
    laterals: Option<usize>,
    actuator: Option<usize>,
    base: Option<usize>,
    speed: usize,
}

/// Name of the speed among the numbers of a saved state.
const SPEED: &str = "device_speed";

impl PantographDevice {
    /// Device at its start.
    ///
    /// # Errors
    /// [`CoreError::Input`].
    pub fn new(model: PantographModel) -> Result<Self, CoreError> {
        let size = model.pantograph.size();
        if model.heights.iter().any(|(index, _)| *index >= size) || !model.speed.is_finite() {
            let reason = "a coordinate that it does not have, or a speed that is not finite";
            return Err(invalid("pantographs", reason));
        }
        let steps = (model.scheme, model.step_length);
        let alone = Alone::new(model.pantograph.clone(), steps, model.start.clone())?;
        let mut layout = Layout::default();
        let mut next = alone.strips();
        let mut take = |count: usize| {
            next += count;
            next - count
        };
        if model.pantograph.strips.iter().any(|s| s.knots.len() > 1) {
            layout.laterals = Some(take(alone.strips()));
        }
        if model.pantograph.actuator.is_some() {
            layout.actuator = Some(take(1));
        }
        if model.pantograph.excitation.base.is_some() {
            layout.base = Some(take(2));
        }
        layout.speed = take(1);
        Ok(Self {
            laterals: vec![0.0; alone.strips()],
            speed: model.speed,
            alone,
            layout,
            model,
        })
    }

    /// Inputs of a step of the core; `laterals` has room for lateral positions.
    fn inputs<'a>(
        &self,
        values: &'a [f64],
        place: Substep,
        laterals: &'a mut [f64],
    ) -> AloneInputs<'a> {
        let count = self.alone.strips();
        if let Some(first) = self.layout.laterals {
            laterals.copy_from_slice(&values[first..first + count]);
        }
        let elapsed = (place.number + 1) as f64 * self.model.step_length;
        let base = self.layout.base.map_or([0.0; 2], |first| {
            [
                values[first] + elapsed * values[first + 1],
                values[first + 1],
            ]
        });
        let old = self.alone.old_weight();
        let speed = place.towards(self.speed, values[self.layout.speed]);
        AloneInputs {
            forces: &values[..count],
            laterals,
            actuator: self.layout.actuator.map_or(0.0, |place| values[place]),
            speed: (1.0 - old) * speed + old * self.speed,
            base,
        }
    }

    fn input_variables(&self) -> Vec<Variable> {
        let (model, prefixes) = (&self.model, strip_prefixes(self.alone.strips()));
        let mut all = Vec::new();
        for (prefix, force) in prefixes.iter().zip(&model.start.forces) {
            let what = "Contact force on the strip during the step, pushing it down";
            all.push(Variable::input(
                format!("{prefix}contact_force"),
                "N",
                what.into(),
                *force,
            ));
        }
        if self.layout.laterals.is_some() {
            for (prefix, lateral) in prefixes.iter().zip(&model.start.laterals) {
                let what = "Lateral position of the wire on the strip";
                all.push(Variable::input(
                    format!("{prefix}wire_lateral"),
                    "m",
                    what.into(),
                    *lateral,
                ));
            }
        }
        let mut add = |name: &str, unit, what: &str, start| {
            all.push(Variable::input(name.into(), unit, what.into(), start));
        };
        if self.layout.actuator.is_some() {
            let what = "Controlled force during the step, upwards positive";
            add("control_force", "N", what, 0.0);
        }
        if self.layout.base.is_some() {
            let what = "Displacement of the base from the start of the run, at the start of the step; \
                        within it, it moves on with base_velocity";
            add("base_displacement", "m", what, 0.0);
            let what = "Velocity of the base during the step";
            add("base_velocity", "m/s", what, 0.0);
        }
        let what = "Speed at the end of the step, to which it changes evenly";
        add("speed", "m/s", what, model.speed);
        all
    }

    fn output_variables(&self) -> Vec<Variable> {
        let prefixes = strip_prefixes(self.alone.strips());
        let output = |name: String, unit, what: &str| Variable::output(name, unit, what.into());
        let mut all = Vec::new();
        for prefix in &prefixes {
            let what = "Height of the strip above the rail";
            all.push(output(format!("{prefix}strip_height"), "m", what));
        }
        for prefix in &prefixes {
            let what = "Velocity of the strip, upwards positive";
            all.push(output(format!("{prefix}strip_velocity"), "m/s", what));
        }
        let names: Vec<String> = self.model.heights.iter().map(|(_, n)| n.clone()).collect();
        let names = identifiers(&names);
        for name in &names {
            let what = format!("Displacement of {name} since the start, upwards positive");
            all.push(output(format!("{name}.displacement"), "m", &what));
        }
        for name in &names {
            let what = format!("Velocity of {name}, upwards positive");
            all.push(output(format!("{name}.velocity"), "m/s", &what));
        }
        all
    }

    fn prediction_variables(&self) -> Vec<Variable> {
        let count = self.alone.strips();
        let mut all = Vec::new();
        for prefix in strip_prefixes(count) {
            let what = "Height of the strip above the rail at the end of the next step without \
                        contact force in it, about the one that is set";
            all.push(Variable::prediction(
                format!("{prefix}free_height"),
                "m",
                what.into(),
            ));
        }
        for row in 0..count {
            for column in 0..count {
                let what = "Compliance of the strips in the next step: it lowers free_height by \
                            compliance times contact force";
                let name = element("compliance", count, (row, column));
                all.push(Variable::prediction(name, "m/N", what.into()));
            }
        }
        all
    }
}

impl Device for PantographDevice {
    fn variables(&self) -> Vec<Variable> {
        let mut all = self.input_variables();
        all.extend(self.output_variables());
        all.extend(self.prediction_variables());
        all.extend(constants(self.model.step_length, self.alone.old_weight()));
        all
    }

    fn step_length(&self) -> f64 {
        self.model.step_length
    }

    fn step(&mut self, inputs: &[f64], place: Substep) -> Result<(), CoreError> {
        let mut laterals = std::mem::take(&mut self.laterals);
        let taken = {
            let inputs = self.inputs(inputs, place, &mut laterals);
            self.alone.step(&inputs)
        };
        self.laterals = laterals;
        taken?;
        self.speed = place.towards(self.speed, inputs[self.layout.speed]);
        Ok(())
    }

    fn read(&self, outputs: &mut [f64]) {
        let strips = 0..self.alone.strips();
        let heights = strips.clone().map(|strip| self.alone.height(strip));
        let velocities = strips.map(|strip| self.alone.velocity(strip));
        let coordinates = self.model.heights.iter();
        let coordinates = coordinates.map(|(index, _)| self.alone.coordinate(*index));
        let all = heights
            .chain(velocities)
            .chain(coordinates.clone().map(|[displacement, _]| displacement))
            .chain(coordinates.map(|[_, velocity]| velocity));
        outputs
            .iter_mut()
            .zip(all)
            .for_each(|(out, value)| *out = value);
    }

    fn predict(&mut self, inputs: &[f64], outputs: &mut [f64]) -> Result<(), CoreError> {
        let mut laterals = std::mem::take(&mut self.laterals);
        let found = {
            let inputs = self.inputs(inputs, Substep::WHOLE, &mut laterals);
            let (heights, compliance) = outputs.split_at_mut(inputs.forces.len());
            self.alone.look_ahead(&inputs, heights, compliance)
        };
        self.laterals = laterals;
        found
    }

    fn explain(&self, error: &CoreError) -> String {
        match error {
            CoreError::NotFinite { .. } => {
                "the motion has grown beyond all bounds: a force or a coupling that is unstable"
                    .into()
            }
            other => other.to_string(),
        }
    }

    fn save(&mut self) -> Result<Checkpoint, CoreError> {
        let mut saved = self.alone.save()?;
        saved.numbers.insert(SPEED.into(), vec![self.speed]);
        Ok(saved)
    }

    fn restore(&mut self, saved: &Checkpoint) -> Result<(), CoreError> {
        let mut saved = saved.clone();
        let numbers = saved.numbers.remove(SPEED).unwrap_or_default();
        let [speed] = numbers[..] else {
            return Err(invalid("state", "it is not of a pantograph"));
        };
        self.alone.restore(&saved)?;
        self.speed = speed;
        Ok(())
    }
}

/// Constants of every device.
pub(crate) fn constants(step_length: f64, old_weight: f64) -> [Variable; 2] {
    let step = "Length of a step; a communication step is a whole number of them";
    let weight = "Weight of the start of a step in its balance: contact closes where \
                  old_weight times the height at its start plus the rest times that at its end are \
                  the same for strip and wire";
    [
        Variable::constant("step_length", "s", step, step_length),
        Variable::constant("old_weight", "1", weight, old_weight),
    ]
}
