//! Saved states of a session.

use crate::checkpoint::Checkpoint;
use crate::error::CoreError;
use crate::session::Session;

/// Name of the watched nodes among the numbers of a saved state, where there are any.
const WATCHED: &str = "loop_watched";

/// Name of position and speed among the numbers of a saved state.
const POSITION_AND_SPEED: &str = "loop_position_speed";

impl<const DIM: usize, const D: usize> Session<DIM, D> {
    /// Saves the state between two steps.
    ///
    /// # Errors
    /// None for a state that steps have left.
    pub fn save(&mut self) -> Result<Checkpoint, CoreError> {
        let mut saved = self.state.save(&self.model.borrow())?;
        let numbers = vec![self.position, self.speed];
        saved.numbers.insert(POSITION_AND_SPEED.into(), numbers);
        if !self.watched.is_empty() {
            saved.numbers.insert(WATCHED.into(), self.watched_numbers());
        }
        Ok(saved)
    }

    /// Restores a saved state of this session, or of another one on the same line with as many
    /// pantographs.
    ///
    /// # Errors
    /// [`CoreError::Input`] for a state of another session; the present one is then kept.
    pub fn restore(&mut self, saved: &Checkpoint) -> Result<(), CoreError> {
        let mut saved = saved.clone();
        let numbers = saved.numbers.remove(POSITION_AND_SPEED).unwrap_or_default();
        let [position, speed] = numbers[..] else {
            return Err(CoreError::invalid("state", "it is not of a loop"));
        };
        let watched = saved.numbers.remove(WATCHED).unwrap_or_default();
        if watched != self.watched_numbers() {
            let reason = "it is of a loop that watches other nodes";
            return Err(CoreError::invalid("state", reason));
        }
        let mut state = self.state.clone();
        state.restore(&self.model.borrow(), &saved)?;
        let before = (self.position, self.speed);
        (self.position, self.speed) = (position, speed);
        let before_state = std::mem::replace(&mut self.state, state);
        let restored = self.read_outputs();
        if restored.is_err() {
            (self.position, self.speed) = before;
            self.state = before_state;
            self.read_outputs()?;
        }
        restored
    }
}
