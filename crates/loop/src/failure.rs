//! Failures, each with a message that names the variable and the time.

use arcless_core::CoreError;
use std::fmt;

/// Kind of a failure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A file or a saved state cannot be used; nothing has changed.
    Data,
    /// A variable does not exist, cannot be set, or was given a value that it cannot have; nothing
    /// has changed.
    Value,
    /// A step was asked for at another time, or of a length that is no whole number of steps;
    /// nothing has changed.
    Time,
    /// A step could not be taken; the steps before it have been.
    Step,
    /// Something is not offered; nothing has changed.
    NotOffered,
}

/// Failure with its message.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Failure {
    /// Kind.
    pub kind: Kind,
    /// Message: what, at which time, what was given and what is expected.
    pub message: String,
}

impl Failure {
    /// Failure of a kind with a message.
    #[must_use]
    pub fn new(kind: Kind, message: impl Into<String>) -> Self {
        Self {
            kind,
            message: message.into(),
        }
    }

    /// Failure to read a file or a saved state.
    #[must_use]
    pub fn data(message: impl Into<String>) -> Self {
        Self::new(Kind::Data, message)
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Failure {}

/// Refusal of an array, as the core refuses.
pub(crate) fn invalid(array: &'static str, reason: &str) -> CoreError {
    CoreError::Input {
        array,
        reason: reason.into(),
    }
}
