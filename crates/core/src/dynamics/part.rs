//! A part of a run: from its start or a saved state, to a step at which its state is taken down.
//!
//! Parts one after the other are the whole run, bit for bit. The series of a record are those of the
//! part, its extremes and counts those of the run so far. The series of a long run may be handed on in
//! pieces while it goes on: one after the other they are the whole series. A piece has the extremes and
//! counts of the run so far.

use super::actuator::Ask;
use super::books::Books;
use super::record::{Record, RecordPlan};
use super::rider::{Rider, RiderState};
use super::run::{OBSERVE_EVERY, Run, Travel, check, check_nodes};
use super::state::{State, refuse};
use super::stepper::Prepared;
use crate::error::CoreError;

/// Which steps to do.
#[derive(Debug, Clone, Copy, Default)]
pub struct Part<'a> {
    /// State to go on from; `None` to begin at the start.
    pub from: Option<&'a State>,
    /// Number of steps, counted from the start of the run, to stop after; `None` to go to the end.
    pub until: Option<usize>,
}

/// Takes the next piece of the series; answers whether to go on.
pub type Take<'a> = &'a mut dyn FnMut(Record) -> bool;

/// Who is called during a run.
pub struct Callers<'a> {
    /// Called now and then with the number of steps done; answers whether to go on.
    pub observe: &'a mut dyn FnMut(usize) -> bool,
    /// Asked for the forces of actuators.
    pub ask: Ask<'a>,
    /// Takes the series as soon as they hold so many numbers; `None` leaves them in the record.
    pub take: Option<(usize, Take<'a>)>,
}

impl Callers<'_> {
    /// Tell that `step` steps are done, and hand on what has been recorded.
    fn call<const DIM: usize, const D: usize>(
        &mut self,
        run: &mut Run<'_, DIM, D>,
        step: usize,
    ) -> Result<(), CoreError> {
        if !(self.observe)(step) {
            return Err(CoreError::Cancelled { step });
        }
        run.check_finite(step)?;
        let Some((enough, take)) = &mut self.take else {
            return Ok(());
        };
        if run.record.held() < *enough {
            return Ok(());
        }
        run.record.check_energy(step)?;
        run.read_laws();
        let go_on = take(run.record.take_series());
        go_on.then_some(()).ok_or(CoreError::Cancelled { step })
    }
}

impl Part<'_> {
    fn steps(&self, travel: &Travel) -> Result<std::ops::Range<usize>, CoreError> {
        let all = travel.positions.len() - 1;
        let (first, last) = (self.from.map_or(0, |s| s.step), self.until.unwrap_or(all));
        if first < last && last <= all {
            return Ok(first..last);
        }
        let reason = format!("does not lie between step {first} and step {all}");
        Err(refuse(&format!("step {last}"), &reason))
    }
}

impl<const DIM: usize, const D: usize> Run<'_, DIM, D> {
    /// Record how far the laws of the riders have been moved.
    fn read_laws(&mut self) {
        self.record.law_ranges = self
            .riders
            .iter()
            .flat_map(RiderState::law_ranges)
            .collect();
    }
}

impl<const DIM: usize, const D: usize> Prepared<DIM, D> {
    /// Do a part of the steps of `travel`; see [`Prepared::run_controlled`] for the rest.
    ///
    /// # Errors
    /// Any [`CoreError`] that a step can raise; [`CoreError::Input`] for a state of another run.
    pub fn run_part(
        &self,
        riders: &[Rider],
        travel: &Travel,
        plan: &RecordPlan,
        part: Part<'_>,
        observe: &mut dyn FnMut(usize) -> bool,
        ask: Ask<'_>,
    ) -> Result<(Record, State), CoreError> {
        let take = None;
        self.run_pieces(riders, travel, plan, part, Callers { observe, ask, take })
    }

    /// The same, with the series handed on in pieces; those of the record returned are the last one.
    ///
    /// # Errors
    /// As [`Prepared::run_part`].
    pub fn run_pieces(
        &self,
        riders: &[Rider],
        travel: &Travel,
        plan: &RecordPlan,
        part: Part<'_>,
        mut callers: Callers<'_>,
    ) -> Result<(Record, State), CoreError> {
        check(riders, travel, plan, self.updating.is_some())?;
        check_nodes(&plan.nodes, self.line.nodes())?;
        if let Some(near) = &plan.near {
            near.check(self.line.links.len(), self.line.nodes())?;
        }
        super::loads::check::<D>(&travel.loads, self.line.nodes(), travel.positions.len())?;
        let steps = part.steps(travel)?;
        let until = steps.end;
        let mut run = match part.from {
            None => Run::start(self, riders, travel, plan)?,
            Some(_) => Run::blank(self, riders, travel, plan)?,
        };
        let mut books = Books::open(&run);
        if let Some(state) = part.from {
            run.put_back(state, books.as_mut())?;
        }
        for step in steps {
            if step % OBSERVE_EVERY == 0 {
                callers.call(&mut run, step)?;
            }
            run.control(step, callers.ask)?;
            run.step(step, books.as_mut())?;
            if step % OBSERVE_EVERY == 0 {
                run.leave_behind(travel.positions[step + 1], books.as_mut());
            }
        }
        run.check_finite(until)?;
        run.record.check_energy(until)?;
        let state = run.take_down(until, books.as_mut())?;
        run.read_laws();
        Ok((run.record, state))
    }
}
