//! Functions that are called during a run, and what is handed on to them.

use crate::error::CoreError;
use crate::pantograph::actuator::Controller;
use crate::pantograph::external::Outside;
use crate::simulation::recording::record::Record;
use crate::simulation::state::State;

/// Receiver of the next piece of the series; it returns whether to continue.
pub type Sink<'a> = &'a mut dyn FnMut(Record) -> bool;

/// Functions that are called during a run.
pub struct Callbacks<'a> {
    /// Observer, called at intervals with the number of steps done; it returns whether to continue.
    pub observe: &'a mut dyn FnMut(usize) -> bool,
    /// Controller that returns the forces of actuators, N.
    pub ask: Controller<'a>,
    /// Program that moves the external pantographs.
    pub outside: &'a mut dyn Outside,
    /// Sink of the series, and the number of values from which they are passed to it; `None` leaves
    /// them in the record.
    pub take: Option<(usize, Sink<'a>)>,
}

impl Callbacks<'_> {
    /// Reports the number of steps done, and flushes the recorded series to the sink.
    pub(crate) fn report_progress<const DIM: usize, const D: usize>(
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

    /// Passes the rows before a failure to the sink, so that they can be looked at.
    pub(crate) fn pass_rest<const DIM: usize, const D: usize>(
        &mut self,
        state: &mut State<DIM, D>,
    ) {
        let (Some((_, take)), Some(recorder)) = (&mut self.take, &mut state.recorder) else {
            return;
        };
        recorder.keep_finite();
        if recorder.record.held() > 0 {
            recorder.read_laws(&state.motion);
            take(recorder.record.take_series()); // the run has ended, whatever is returned
        }
    }
}
