//! A run, or a part of one: from its start or a saved state, to a step at which its state is taken
//! down.
//!
//! Parts one after the other are the whole run, bit for bit. The series of a record are those of the
//! part, its extremes and counts those of the run so far. The series of a long run may be handed on in
//! pieces while it goes on: one after the other they are the whole series. A piece has the extremes and
//! counts of the run so far.

use crate::checkpoint::{Checkpoint, refuse};
use crate::error::CoreError;
use crate::integrator::prepared::WireModel;
use crate::linear::loads::Load;
use crate::pantograph::actuator::{Ask, Sample};
use crate::pantograph::system::Pantograph;
use crate::simulation::inputs::Histories;
use crate::simulation::model::Model;
use crate::simulation::recording::record::{Record, RecordPlan};
use crate::simulation::recording::recorder::Recorder;
use crate::simulation::state::State;
use crate::simulation::step::step;

/// Motion along the track and laws of the contact.
#[derive(Debug, Clone)]
pub struct Trajectory {
    /// Position of the first rider at the start and after each step, m.
    pub positions: Vec<f64>,
    /// Speed at the same instants, m/s.
    pub speeds: Vec<f64>,
    /// Distance of each rider behind the first, m.
    pub distances: Vec<f64>,
    /// Coefficient of friction along the wire.
    pub friction: f64,
    /// Forces on the line, given at the same instants.
    pub loads: Vec<Load>,
}

/// Which steps to do.
#[derive(Debug, Clone, Copy, Default)]
pub struct Part<'a> {
    /// State to go on from; `None` to begin at the start.
    pub from: Option<&'a Checkpoint>,
    /// Number of steps, counted from the start of the run, to stop after; `None` to go to the end.
    pub until: Option<usize>,
}

/// Takes the next piece of the series; answers whether to go on.
pub type Sink<'a> = &'a mut dyn FnMut(Record) -> bool;

/// Who is called during a run.
pub struct Callbacks<'a> {
    /// Called now and then with the number of steps done; answers whether to go on.
    pub observe: &'a mut dyn FnMut(usize) -> bool,
    /// Asked for the forces of actuators.
    pub ask: Ask<'a>,
    /// Takes the series as soon as they hold so many numbers; `None` leaves them in the record.
    pub take: Option<(usize, Sink<'a>)>,
}

impl Callbacks<'_> {
    /// Tell how many steps are done, and hand on what has been recorded.
    fn call<const DIM: usize, const D: usize>(
        &mut self,
        state: &mut State<DIM, D>,
    ) -> Result<(), CoreError> {
        let step = state.motion.steps;
        if !(self.observe)(step) {
            return Err(CoreError::Cancelled { step });
        }
        state.motion.check_finite()?;
        let (Some((enough, take)), Some(recorder)) = (&mut self.take, &mut state.recorder) else {
            return Ok(());
        };
        if recorder.record.held() < *enough {
            return Ok(());
        }
        recorder.record.check_energy(step)?;
        recorder.read_laws(&state.motion);
        let go_on = take(recorder.record.take_series());
        go_on.then_some(()).ok_or(CoreError::Cancelled { step })
    }
}

impl Part<'_> {
    fn steps(&self, travel: &Trajectory) -> Result<std::ops::Range<usize>, CoreError> {
        let all = travel.positions.len() - 1;
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
    /// Run all steps of `travel`. `observe` is called now and then with the number of steps done;
    /// the run ends with [`CoreError::Cancelled`] when it returns `false`.
    ///
    /// # Errors
    /// Any [`CoreError`] that a step can raise.
    pub fn run(
        &self,
        riders: &[Pantograph],
        travel: &Trajectory,
        plan: &RecordPlan,
        observe: &mut dyn FnMut(usize) -> bool,
    ) -> Result<Record, CoreError> {
        let mut nobody = |_: usize, _: &Sample| Err("nobody controls it".into());
        self.run_controlled(riders, travel, plan, observe, &mut nobody)
    }

    /// The same, with someone to ask for the forces of actuators.
    ///
    /// # Errors
    /// Any [`CoreError`] that a step can raise, [`CoreError::Control`] among them.
    pub fn run_controlled(
        &self,
        riders: &[Pantograph],
        travel: &Trajectory,
        plan: &RecordPlan,
        observe: &mut dyn FnMut(usize) -> bool,
        ask: Ask<'_>,
    ) -> Result<Record, CoreError> {
        let whole = Part::default();
        let done = self.run_part(riders, travel, plan, whole, observe, ask);
        done.map(|(record, _)| record)
    }

    /// Do a part of the steps of `travel`; see [`WireModel::run_controlled`] for the rest.
    ///
    /// # Errors
    /// Any [`CoreError`] that a step can raise; [`CoreError::Input`] for a state of another run.
    pub fn run_part(
        &self,
        riders: &[Pantograph],
        travel: &Trajectory,
        plan: &RecordPlan,
        part: Part<'_>,
        observe: &mut dyn FnMut(usize) -> bool,
        ask: Ask<'_>,
    ) -> Result<(Record, Checkpoint), CoreError> {
        let take = None;
        self.run_pieces(riders, travel, plan, part, Callbacks { observe, ask, take })
    }

    /// Do a part of the steps, with the series handed on in pieces; those of the record returned are
    /// the last one.
    ///
    /// # Errors
    /// As [`WireModel::run_part`].
    pub fn run_pieces(
        &self,
        riders: &[Pantograph],
        travel: &Trajectory,
        plan: &RecordPlan,
        part: Part<'_>,
        mut callers: Callbacks<'_>,
    ) -> Result<(Record, Checkpoint), CoreError> {
        check(riders, travel, plan, self.keeps_energy())?;
        check_nodes(&plan.nodes, self.line.nodes())?;
        if let Some(near) = &plan.near {
            near.check(self.line.links.len(), self.line.nodes())?;
        }
        crate::linear::loads::check::<D>(&travel.loads, self.line.nodes(), travel.positions.len())?;
        let steps = part.steps(travel)?;
        let model = Model {
            line: self,
            riders,
            distances: &travel.distances,
            friction: travel.friction,
        };
        let mut state = State::begin(&model, travel, plan, part.from)?;
        let mut histories = Histories::new(travel, riders);
        for number in steps {
            let is_due = number.is_multiple_of(OBSERVE_EVERY);
            if is_due {
                callers.call(&mut state)?;
            }
            let at_start = (travel.positions[number], travel.speeds[number]);
            state.motion.control(&model, at_start, callers.ask)?;
            let inputs = histories.at(number, self.coefficients.old);
            step(&model, &inputs, &mut state)?;
            if is_due {
                state.leave_behind(&model, travel.positions[number + 1]);
            }
        }
        state.end(&model)
    }
}

impl<const DIM: usize, const D: usize> State<DIM, D> {
    /// State of a run that is recorded: at its start, or where a saved one left it.
    fn begin(
        model: &Model<'_, DIM, D>,
        travel: &Trajectory,
        plan: &RecordPlan,
        from: Option<&Checkpoint>,
    ) -> Result<Self, CoreError> {
        let may_sleep = travel.loads.is_empty();
        let mut state = match from {
            None => Self::standing(model, (travel.positions[0], travel.speeds[0]), may_sleep)?,
            Some(_) => Self::blank(model, may_sleep)?,
        };
        let steps = travel.positions.len() - 1;
        let mut recorder = Recorder::new(model, plan, steps, &mut state.motion)?;
        match from {
            None => {
                state.recorder = Some(recorder);
                state.let_sleep(model);
                if let Some(recorder) = &mut state.recorder {
                    recorder.open_books(model, &state.motion);
                }
            }
            Some(saved) => {
                recorder.open_books(model, &state.motion);
                state.recorder = Some(recorder);
                state.put_back(model, saved)?;
            }
        }
        Ok(state)
    }

    /// Record and saved state at the end of a part.
    fn end(mut self, model: &Model<'_, DIM, D>) -> Result<(Record, Checkpoint), CoreError> {
        self.motion.check_finite()?;
        let saved = self.take_down(model)?;
        let mut record = Record::default();
        if let Some(mut recorder) = self.recorder {
            recorder.record.check_energy(self.motion.steps)?;
            recorder.read_laws(&self.motion);
            record = recorder.record;
        }
        Ok((record, saved))
    }
}

/// Check what a run is given.
///
/// # Errors
/// [`CoreError::Input`].
pub(crate) fn check(
    riders: &[Pantograph],
    travel: &Trajectory,
    plan: &RecordPlan,
    keeps_energy: bool,
) -> Result<(), CoreError> {
    let refuse = |array, reason: &str| {
        Err(CoreError::Input {
            array,
            reason: reason.into(),
        })
    };
    if riders.is_empty() || travel.distances.len() != riders.len() {
        return refuse("riders", "none, or not one distance for each");
    }
    if travel.positions.len() < 2 || travel.speeds.len() != travel.positions.len() {
        return refuse("positions", "fewer than two, or not one speed for each");
    }
    let all = [&travel.positions, &travel.speeds, &travel.distances];
    if all.iter().any(|a| a.iter().any(|v| !v.is_finite())) || !travel.friction.is_finite() {
        return refuse("positions", "not finite");
    }
    for rider in riders {
        rider.given.check_instants(travel.positions.len())?;
    }
    if plan.ledger && !keeps_energy {
        return refuse("plan", "an energy ledger with updated kinematics");
    }
    if plan.contact_every == 0 || plan.line_every == 0 || plan.ledger_every == 0 {
        return refuse("plan", "a recording interval of zero steps");
    }
    Ok(())
}

/// Refuse to watch nodes that are not there.
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
