//! The state of a loop between two steps, taken down and put back.

use super::live::{Live, STEP, lost, refuse};
use super::live_parts::Parts;
use super::state::State;
use crate::error::CoreError;

/// Name of position and speed among the numbers of a state.
const PLACE: &str = "loop_position_speed";

impl<const DIM: usize, const D: usize> Live<DIM, D> {
    /// The state between two steps.
    ///
    /// # Errors
    /// [`CoreError::Input`] after a step that did not return.
    pub fn take_down(&mut self) -> Result<State, CoreError> {
        let parts = self.parts.take().ok_or_else(lost)?;
        let mut run = parts.run(&self.p, &self.travel, &self.plan, &self.riders);
        let state = run.take_down(self.steps, None);
        self.parts = Some(Parts::of(run));
        let (position, speed) = self.place();
        let mut state = state?;
        state.numbers.insert(PLACE.into(), vec![position, speed]);
        Ok(state)
    }

    /// Go on from a state of this loop, or of another on the same line with as many riders.
    ///
    /// # Errors
    /// [`CoreError::Input`] for a state of another loop; the present one is then kept.
    pub fn put_back(&mut self, state: &State) -> Result<(), CoreError> {
        let before = self.take_down()?;
        let done = self.put(state);
        if done.is_err() {
            self.put(&before)?;
        }
        done
    }

    fn put(&mut self, state: &State) -> Result<(), CoreError> {
        let mut rest = state.clone();
        let place = rest.numbers.remove(PLACE).unwrap_or_default();
        let [position, speed] = place[..] else {
            return Err(refuse("state", "it is not of a loop"));
        };
        let parts = self.parts.take().ok_or_else(lost)?;
        let mut run = parts.run(&self.p, &self.travel, &self.plan, &self.riders);
        let done = run.put_back(&rest, None);
        self.parts = Some(Parts::of(run));
        done?;
        (self.travel.positions[STEP], self.travel.speeds[STEP]) = (position, speed);
        self.steps = state.step;
        self.read()
    }
}
