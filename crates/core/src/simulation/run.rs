//! Run, or part of one: from its start or a saved state, to a step at which its state is saved.
//!
//! Parts one after the other are the whole run, bit for bit. The series of a record are those of
//! the part, its extremes and counts those of the run so far. The series of a long run may be
//! passed to a sink in pieces during the run: one after the other they are the whole series. A
//! piece has the extremes and counts of the run so far.

use crate::checkpoint::{Checkpoint, refuse};
use crate::error::CoreError;
use crate::integrator::wire_model::WireModel;
use crate::pantograph::actuator::{Controller, Sample};
use crate::pantograph::external::Nobody;
use crate::pantograph::model::Pantograph;
use crate::simulation::callbacks::Callbacks;
use crate::simulation::external::ExternalPantographs;
use crate::simulation::inputs::{Histories, Trajectory};
use crate::simulation::model::Model;
use crate::simulation::recording::record::{Record, RecordPlan};
use crate::simulation::recording::recorder::Recorder;
use crate::simulation::state::State;
use crate::simulation::step::{complete, solve};

/// Range of steps to do.
#[derive(Debug, Clone, Copy, Default)]
pub struct Part<'a> {
    /// Saved state to continue from; `None` to begin at the start.
    pub from: Option<&'a Checkpoint>,
    /// Number of steps, counted from the start of the run, after which to stop; `None` for the end.
    pub until: Option<usize>,
}

impl Part<'_> {
    fn steps(&self, trajectory: &Trajectory) -> Result<std::ops::Range<usize>, CoreError> {
        let all = trajectory.positions.len() - 1;
        let (first, last) = (self.from.map_or(0, |s| s.step), self.until.unwrap_or(all));
        if first < last && last <= all {
            return Ok(first..last);
        }
        let reason = format!("does not lie between step {first} and step {all}");
        Err(refuse(&format!("step {last}"), &reason))
    }
}

/// Steps between two calls of the observer: often enough to stop within a fraction of a second.
pub(crate) const OBSERVE_EVERY: usize = 256;

impl<const DIM: usize, const D: usize> WireModel<DIM, D> {
    /// Runs all steps of `trajectory`. `observe` is called at intervals with the number of steps
    /// done; the run ends with [`CoreError::Cancelled`] when it returns `false`.
    ///
    /// # Errors
    /// Any [`CoreError`] that a step can raise.
    pub fn run(
        &self,
        pantographs: &[Pantograph],
        trajectory: &Trajectory,
        plan: &RecordPlan,
        observe: &mut dyn FnMut(usize) -> bool,
    ) -> Result<Record, CoreError> {
        let mut nobody = |_: usize, _: &Sample| Err("nobody controls it".into());
        self.run_controlled(pantographs, trajectory, plan, observe, &mut nobody)
    }

    /// Runs all steps of `trajectory` with a controller of the actuators.
    ///
    /// # Errors
    /// Any [`CoreError`] that a step can raise, [`CoreError::Control`] among them.
    pub fn run_controlled(
        &self,
        pantographs: &[Pantograph],
        trajectory: &Trajectory,
        plan: &RecordPlan,
        observe: &mut dyn FnMut(usize) -> bool,
        ask: Controller<'_>,
    ) -> Result<Record, CoreError> {
        let whole = Part::default();
        let result = self.run_part(pantographs, trajectory, plan, whole, observe, ask);
        result.map(|(record, _)| record)
    }

    /// Does a part of the steps of `trajectory`; see [`WireModel::run_controlled`] for the rest.
    ///
    /// # Errors
    /// Any [`CoreError`] that a step can raise; [`CoreError::Input`] for a state of another run.
    pub fn run_part(
        &self,
        pantographs: &[Pantograph],
        trajectory: &Trajectory,
        plan: &RecordPlan,
        part: Part<'_>,
        observe: &mut dyn FnMut(usize) -> bool,
        ask: Controller<'_>,
    ) -> Result<(Record, Checkpoint), CoreError> {
        let take = None;
        self.run_pieces(
            pantographs,
            trajectory,
            plan,
            part,
            Callbacks {
                observe,
                ask,
                outside: &mut Nobody,
                take,
            },
        )
    }

    /// Does a part of the steps, with the series passed to a sink in pieces; those of the record
    /// returned are the last one.
    ///
    /// # Errors
    /// As [`WireModel::run_part`].
    pub fn run_pieces(
        &self,
        pantographs: &[Pantograph],
        trajectory: &Trajectory,
        plan: &RecordPlan,
        part: Part<'_>,
        mut callbacks: Callbacks<'_>,
    ) -> Result<(Record, Checkpoint), CoreError> {
        check(pantographs, trajectory, plan, self.has_energy_balance())?;
        check_nodes(&plan.nodes, self.line.nodes())?;
        if let Some(near) = &plan.near {
            near.check(self.line.links.len(), self.line.nodes())?;
        }
        if let Some(recorded) = &plan.motion {
            recorded.check(self.line.links.len(), self.line.nodes())?;
        }
        plan.check_supports(self.line.springs.len(), self.line.struts.len())?;
        crate::linear::loads::check::<D>(
            &trajectory.loads,
            self.line.nodes(),
            trajectory.positions.len(),
        )?;
        let steps = part.steps(trajectory)?;
        let model = Model {
            wires: self,
            pantographs,
            distances: &trajectory.distances,
            friction: trajectory.friction,
        };
        if part.from.is_some() && pantographs.iter().any(|p| p.is_external) {
            let reason = "is of a run with an external pantograph, whose state is outside";
            return Err(refuse("step", reason));
        }
        let mut state = State::start_or_resume(&model, trajectory, plan, part.from)?;
        let stepped = state.take_steps(&model, trajectory, steps, &mut callbacks);
        if let Err(error) = stepped {
            if !matches!(error, CoreError::Cancelled { .. }) {
                callbacks.pass_rest(&mut state);
            }
            return Err(error);
        }
        state.finish(&model)
    }
}

impl<const DIM: usize, const D: usize> State<DIM, D> {
    /// Returns the state of a recorded run: at its start, or restored from a saved one.
    fn start_or_resume(
        model: &Model<'_, DIM, D>,
        trajectory: &Trajectory,
        plan: &RecordPlan,
        from: Option<&Checkpoint>,
    ) -> Result<Self, CoreError> {
        let may_sleep = trajectory.loads.is_empty();
        let mut state = match from {
            None => Self::in_equilibrium(
                model,
                (trajectory.positions[0], trajectory.speeds[0]),
                may_sleep,
            )?,
            Some(_) => Self::blank(model, may_sleep)?,
        };
        let steps = trajectory.positions.len() - 1;
        let mut recorder = Recorder::new(model, plan, steps, &mut state.motion)?;
        match from {
            None => {
                state.recorder = Some(recorder);
                state.sleep_untouched(model);
                if let Some(recorder) = &mut state.recorder {
                    recorder.open_books(model, &state.motion);
                }
            }
            Some(saved) => {
                recorder.open_books(model, &state.motion);
                state.recorder = Some(recorder);
                state.restore(model, saved)?;
            }
        }
        Ok(state)
    }

    /// Takes the steps of a part, and checks where they have led to.
    fn take_steps(
        &mut self,
        model: &Model<'_, DIM, D>,
        trajectory: &Trajectory,
        steps: std::ops::Range<usize>,
        callbacks: &mut Callbacks<'_>,
    ) -> Result<(), CoreError> {
        let at_start = |number: usize| (trajectory.positions[number], trajectory.speeds[number]);
        let mut histories = Histories::new(trajectory, model.pantographs);
        let mut external = ExternalPantographs::new(model);
        if !external.is_empty() {
            external.begin(model, &mut self.motion, at_start(0), callbacks.outside)?;
        }
        for number in steps {
            let is_due = number.is_multiple_of(OBSERVE_EVERY);
            if is_due {
                callbacks.report_progress(self)?;
            }
            let at = at_start(number);
            self.motion.control(model, at, callbacks.ask)?;
            external.predict(model, &mut self.motion, at, callbacks.outside)?;
            let inputs = histories.at(number, model.wires.coefficients.old);
            let stats = solve(model, &inputs, self)?;
            external.advance(model, &mut self.motion, at, callbacks.outside)?;
            complete(model, &inputs, self, &stats)?;
            if is_due {
                self.sleep_passed(model, trajectory.positions[number + 1]);
            }
        }
        self.motion.check_finite()?;
        let recorder = self.recorder.as_ref();
        recorder.map_or(Ok(()), |r| r.record.check_energy(self.motion.steps))
    }

    /// Returns record and saved state at the end of a part.
    fn finish(mut self, model: &Model<'_, DIM, D>) -> Result<(Record, Checkpoint), CoreError> {
        let saved = self.save(model)?;
        let mut record = Record::default();
        if let Some(mut recorder) = self.recorder {
            recorder.read_laws(&self.motion);
            record = recorder.record;
        }
        Ok((record, saved))
    }
}

/// Checks the inputs of a run.
///
/// # Errors
/// [`CoreError::Input`].
pub(crate) fn check(
    pantographs: &[Pantograph],
    trajectory: &Trajectory,
    plan: &RecordPlan,
    has_energy_balance: bool,
) -> Result<(), CoreError> {
    let refuse = |array, reason: &str| {
        Err(CoreError::Input {
            array,
            reason: reason.into(),
        })
    };
    if pantographs.is_empty() || trajectory.distances.len() != pantographs.len() {
        return refuse("pantographs", "none, or not one distance for each");
    }
    if trajectory.positions.len() < 2 || trajectory.speeds.len() != trajectory.positions.len() {
        return refuse("positions", "fewer than two, or not one speed for each");
    }
    let all = [
        &trajectory.positions,
        &trajectory.speeds,
        &trajectory.distances,
    ];
    if all.iter().any(|a| a.iter().any(|v| !v.is_finite())) || !trajectory.friction.is_finite() {
        return refuse("positions", "not finite");
    }
    for pantograph in pantographs {
        pantograph
            .excitation
            .check_instants(trajectory.positions.len())?;
    }
    if plan.ledger && !has_energy_balance {
        return refuse("plan", "an energy balance with updated kinematics");
    }
    if plan.contact_every == 0 || plan.line_every == 0 || plan.ledger_every == 0 {
        return refuse("plan", "a recording interval of zero steps");
    }
    Ok(())
}

/// Refuses nodes that do not exist.
///
/// # Errors
/// [`CoreError::Input`].
pub(crate) fn check_nodes(watched: &[usize], nodes: usize) -> Result<(), CoreError> {
    match watched.iter().find(|&&node| node >= nodes) {
        None => Ok(()),
        Some(node) => Err(CoreError::Input {
            array: "plan",
            reason: format!("node {node} of {nodes} is watched"),
        }),
    }
}
