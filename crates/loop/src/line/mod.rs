//! Line as a device, with what presses against it.
//!
//! * contact force: the force of each strip is an input; outputs are the wire at it, and for the
//!   coming step its free height and its compliance;
//! * strip height: height and velocity of each strip, or its free height and its compliance, are
//!   inputs; outputs are contact force, wire, and the height reached;
//! * control force: the force of each actuator is an input; outputs are contact force, wire, and
//!   the motion of the simulated pantographs.
//!
//! In all of them position or speed of the first pantograph is an input, uplift at supports an
//! output.

pub mod names;
pub mod variables;

use crate::failure::invalid;
use crate::line::names::LineNames;
use crate::stepper::{Device, Substep};
use crate::variable::Variable;
use arcless_core::CoreError;
use arcless_core::checkpoint::Checkpoint;
use arcless_core::session::prepared::{Drive, Prepared};
use arcless_core::session::{AnySession, Outputs};
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Input that moves the pantographs along the track.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Travel {
    /// Position of the first pantograph.
    Position,
    /// Speed.
    Speed,
}

/// Exported line.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct LineModel {
    /// Line, what presses against it, and the start.
    pub prepared: Prepared,
    /// Input of the travel.
    pub travel: Travel,
    /// Pantographs, in the order along the track.
    pub pantographs: Vec<OnLine>,
    /// Names of the supports whose uplift is read.
    pub supports: Vec<String>,
}

/// Pantograph on a line, or what presses in its place.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct OnLine {
    /// Name.
    pub name: String,
    /// Number of its strips.
    pub strips: usize,
    /// Coordinates that are heights, with the names of what they are of; none where it is not
    /// simulated.
    pub heights: Vec<(usize, String)>,
}

/// Line as a device.
#[derive(Debug)]
pub struct LineDevice {
    session: AnySession,
    kind: Kind,
    names: LineNames,
    travel: Travel,
    step_length: f64,
    variables: Vec<Variable>,
    /// Contacts of each strip, and strips of each pantograph.
    contacts: Vec<Range<usize>>,
    strips: Vec<Range<usize>>,
    /// Coordinates that are heights, among those of all pantographs.
    coordinates: Vec<usize>,
    /// Forces of a step, N: of collectors, or of the actuators of all pantographs.
    forces: Vec<f64>,
    /// Pantographs that have an actuator.
    driven: Vec<usize>,
    /// Heights of strips of a step, m.
    heights: Vec<f64>,
}

/// Kind of a line as a device.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Contact forces are given.
    ContactForce,
    /// Heights of strips are given.
    StripHeight,
    /// Forces of actuators are given.
    ControlForce,
}

impl LineDevice {
    /// Device at its start.
    ///
    /// # Errors
    /// Any [`CoreError`] of the start of a session, [`CoreError::Input`] for names that do not fit.
    pub fn new(model: LineModel) -> Result<Self, CoreError> {
        let session = model.prepared.session()?;
        let outputs = session.outputs();
        let (kind, driven, sizes) = of_drive(&model.prepared.drive);
        let strips = consecutive(model.pantographs.iter().map(|p| p.strips));
        let count = strips.last().map_or(0, |last| last.end);
        let lanes = if kind == Kind::ContactForce {
            1
        } else {
            model.prepared.lanes.len()
        };
        let offsets = consecutive(sizes.iter().copied());
        let fits =
            |(p, own): (&OnLine, &Range<usize>)| p.heights.iter().all(|(i, _)| *i < own.len());
        let has_names = match kind {
            Kind::ControlForce => {
                offsets.len() == model.pantographs.len()
                    && model.pantographs.iter().zip(&offsets).all(fits)
            }
            _ => model.pantographs.iter().all(|p| p.heights.is_empty()),
        };
        let is_watched = outputs.uplift.len() == model.supports.len();
        if count == 0 || count * lanes != outputs.force.len() || !has_names || !is_watched {
            return Err(invalid("names", "they do not fit the line"));
        }
        let of_pantographs = model.pantographs.iter().zip(&offsets);
        let coordinates = of_pantographs
            .flat_map(|(p, own)| p.heights.iter().map(|(i, _)| own.start + i))
            .collect();
        let mut names = LineNames::new(&model.pantographs, &model.supports, &driven);
        names.is_spatial = model.prepared.structure.dim == 3;
        let mut made = Self {
            contacts: (0..count).map(|s| s * lanes..(s + 1) * lanes).collect(),
            step_length: session.step_length(),
            forces: vec![0.0; session.inputs()],
            heights: vec![0.0; outputs.strip_height.len()],
            variables: Vec::new(),
            travel: model.travel,
            strips,
            coordinates,
            driven,
            names,
            kind,
            session,
        };
        made.variables = variables::of(&made, &model.prepared);
        Ok(made)
    }

    /// Position and speed at the end of a step, m and m/s.
    fn end(&self, inputs: &[f64], place: Substep) -> (f64, f64) {
        let (position, speed) = self.session.position_and_speed();
        let h = self.step_length;
        match self.travel {
            Travel::Position => {
                let end = place.towards(position, inputs[0]);
                (end, (end - position) / h)
            }
            Travel::Speed => {
                let end = place.towards(speed, inputs[0]);
                (position + 0.5 * h * (speed + end), end)
            }
        }
    }

    /// Takes a step with given strips.
    fn step_strips(&mut self, given: &[f64], place: Substep) -> Result<(), CoreError> {
        let count = self.heights.len();
        let (position, speed) = self.end(given, place);
        let given = &given[1..];
        let elapsed = (place.number + 1) as f64 * self.step_length;
        let moved = given.iter().zip(&given[count..]);
        for (height, (start, velocity)) in self.heights.iter_mut().zip(moved) {
            *height = start + elapsed * velocity;
        }
        let compliance = &given[2 * count..];
        self.session
            .step_strips(&self.heights, compliance, position, speed)
    }

    /// Contact of a strip whose wire is the lowest one there.
    fn lowest(&self, strip: usize) -> usize {
        let height = &self.session.outputs().height;
        let of_strip = self.contacts[strip].clone();
        let first = of_strip.start;
        of_strip.fold(first, |best, contact| {
            let is_lower = height[contact] < height[best] || !height[best].is_finite();
            if is_lower { contact } else { best }
        })
    }

    /// Contact forces of each pantograph with several strips in all, N.
    fn sums(&self) -> impl Iterator<Item = f64> {
        let several = self.strips.iter().filter(|strips| strips.len() > 1);
        several.map(|strips| {
            let contacts = self.contacts[strips.start].start..self.contacts[strips.end - 1].end;
            self.session.outputs().force[contacts].iter().sum()
        })
    }
}

/// Kind of the device, pantographs with an actuator, and numbers of coordinates.
fn of_drive(drive: &Drive) -> (Kind, Vec<usize>, Vec<usize>) {
    match drive {
        Drive::Forces { .. } => (Kind::ContactForce, Vec::new(), Vec::new()),
        Drive::Strips { .. } => (Kind::StripHeight, Vec::new(), Vec::new()),
        Drive::Pantographs { pantographs, .. } => {
            let all = pantographs.iter().enumerate();
            let driven = all.filter(|(_, p)| p.actuator.is_some());
            let sizes = pantographs.iter().map(|p| p.size());
            let driven = driven.map(|(number, _)| number).collect();
            (Kind::ControlForce, driven, sizes.collect())
        }
    }
}

/// Ranges of lists of so many parts that follow one another.
fn consecutive(counts: impl Iterator<Item = usize>) -> Vec<Range<usize>> {
    let mut next = 0;
    let ranges = counts.map(|count| {
        next += count;
        next - count..next
    });
    ranges.collect()
}

impl Device for LineDevice {
    fn variables(&self) -> Vec<Variable> {
        self.variables.clone()
    }

    fn step_length(&self) -> f64 {
        self.step_length
    }

    fn step(&mut self, inputs: &[f64], place: Substep) -> Result<(), CoreError> {
        if self.kind == Kind::StripHeight {
            return self.step_strips(inputs, place);
        }
        let (position, speed) = self.end(inputs, place);
        match self.kind {
            Kind::ControlForce => {
                for (&number, force) in self.driven.iter().zip(&inputs[1..]) {
                    self.forces[number] = *force;
                }
            }
            _ => self.forces.copy_from_slice(&inputs[1..]),
        }
        self.session.step(&self.forces, position, speed)
    }

    fn read(&self, outputs: &mut [f64]) {
        let found = self.session.outputs();
        let Outputs {
            force,
            height,
            lateral,
            rate,
            ..
        } = found;
        let strips = 0..self.contacts.len();
        let wires = strips.clone().map(|strip| self.lowest(strip));
        let (position, speed) = self.session.position_and_speed();
        let travel = match self.travel {
            Travel::Position => speed,
            Travel::Speed => position,
        };
        let is_given = self.kind == Kind::ContactForce;
        let forces = strips.filter(|_| !is_given);
        let forces = forces.map(|strip| force[self.contacts[strip].clone()].iter().sum::<f64>());
        let sums = self.sums().filter(|_| !is_given);
        let laterals = wires.clone().filter(|_| self.names.is_spatial);
        let coordinates = self.coordinates.iter();
        let all = std::iter::once(travel)
            .chain(forces)
            .chain(sums)
            .chain(wires.clone().map(|contact| height[contact]))
            .chain(wires.map(|contact| rate[contact]))
            .chain(laterals.map(|contact| lateral[contact]))
            .chain(found.strip_height.iter().copied())
            .chain(coordinates.clone().map(|&index| found.displacement[index]))
            .chain(coordinates.map(|&index| found.velocity[index]))
            .chain(found.uplift.iter().copied());
        outputs
            .iter_mut()
            .zip(all)
            .for_each(|(out, value)| *out = value);
    }

    fn predict(&mut self, inputs: &[f64], outputs: &mut [f64]) -> Result<(), CoreError> {
        let (position, speed) = self.end(inputs, Substep::WHOLE);
        let found = self
            .session
            .compliance_about(&inputs[1..], position, speed)?;
        let count = found.free_height.len();
        let stiffness = (0..count).map(|i| 1.0 / found.matrix[i * count + i]);
        let all = found.free_height.iter().chain(&found.matrix).copied();
        let all = all.chain(stiffness);
        outputs
            .iter_mut()
            .zip(all)
            .for_each(|(out, value)| *out = value);
        Ok(())
    }

    fn explain(&self, error: &CoreError) -> String {
        let by_strip = self.kind == Kind::ContactForce;
        self.names.explain(error, by_strip)
    }

    fn save(&mut self) -> Result<Checkpoint, CoreError> {
        self.session.save()
    }

    fn restore(&mut self, saved: &Checkpoint) -> Result<(), CoreError> {
        self.session.restore(saved)
    }
}
