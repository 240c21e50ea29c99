//! Checkpoint: a state between two steps as plain numbers with plain names, for files.
//!
//! A checkpoint contains the state of the motion alone. Data that follow from line, pantographs and
//! trajectory are computed again when a run is continued, from the same line, pantographs and
//! trajectory.

use crate::error::CoreError;
use std::collections::BTreeMap;

/// Numbers from which a run continues as if it had never stopped.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Checkpoint {
    /// Number of steps done.
    pub step: usize,
    /// Numbers by name, SI; counts and flags are whole numbers.
    pub numbers: BTreeMap<String, Vec<f64>>,
}

/// Refuses a state.
pub(crate) fn refuse(name: &str, reason: &str) -> CoreError {
    CoreError::Input {
        array: "state",
        reason: format!("`{name}` {reason}"),
    }
}

/// Archive of everything that changes during a run. One function saves a state and restores it, so
/// that both handle the same fields.
pub(crate) struct Archive<'a> {
    /// Numbers that are restored; `None` while a state is saved.
    saved: Option<&'a BTreeMap<String, Vec<f64>>>,
    /// Numbers saved so far.
    collected: BTreeMap<String, Vec<f64>>,
    /// Number of lists visited.
    visited: usize,
}

/// Largest whole number below which all are exact.
const LARGEST_EXACT: f64 = 9_007_199_254_740_992.0;

impl<'a> Archive<'a> {
    /// Archive that saves a state.
    pub(crate) fn saving() -> Self {
        Self {
            saved: None,
            collected: BTreeMap::new(),
            visited: 0,
        }
    }

    /// Archive that restores a state.
    pub(crate) fn restoring(saved: &'a Checkpoint) -> Self {
        Self {
            saved: Some(&saved.numbers),
            collected: BTreeMap::new(),
            visited: 0,
        }
    }

    /// Checkpoint after `step` steps.
    pub(crate) fn checkpoint(self, step: usize) -> Checkpoint {
        Checkpoint {
            step,
            numbers: self.collected,
        }
    }

    /// Refuses numbers that were not visited: they belong to another run.
    pub(crate) fn finish(&self) -> Result<(), CoreError> {
        match self.saved {
            Some(saved) if saved.len() != self.visited => {
                Err(refuse("numbers", "has parts that this run does not have"))
            }
            _ => Ok(()),
        }
    }

    /// Saves or restores a list of any length.
    pub(crate) fn list(&mut self, name: &str, values: &mut Vec<f64>) -> Result<(), CoreError> {
        self.visited += 1;
        let Some(saved) = self.saved else {
            self.collected.insert(name.into(), values.clone());
            return Ok(());
        };
        let saved = saved.get(name).ok_or_else(|| refuse(name, "is missing"))?;
        if !saved.iter().all(|v| v.is_finite()) {
            return Err(refuse(name, "is not finite"));
        }
        values.clone_from(saved);
        Ok(())
    }

    /// Saves or restores as many numbers as there are.
    pub(crate) fn numbers<'v>(
        &mut self,
        name: &str,
        values: impl Iterator<Item = &'v mut f64>,
    ) -> Result<(), CoreError> {
        let targets: Vec<&mut f64> = values.collect();
        let mut list = targets.iter().map(|v| **v).collect();
        self.list(name, &mut list)?;
        if list.len() != targets.len() {
            let reason = format!("has {} numbers, not {}", list.len(), targets.len());
            return Err(refuse(name, &reason));
        }
        targets.into_iter().zip(list).for_each(|(v, new)| *v = new);
        Ok(())
    }

    /// Saves or restores as many counts as there are.
    pub(crate) fn counts<'v>(
        &mut self,
        name: &str,
        values: impl Iterator<Item = &'v mut usize>,
    ) -> Result<(), CoreError> {
        let targets: Vec<&mut usize> = values.collect();
        let mut list: Vec<f64> = targets.iter().map(|v| **v as f64).collect();
        self.numbers(name, list.iter_mut())?;
        for (target, number) in targets.into_iter().zip(list) {
            *target = count(name, number)?;
        }
        Ok(())
    }

    /// Saves or restores as many flags as there are.
    pub(crate) fn flags<'v>(
        &mut self,
        name: &str,
        values: impl Iterator<Item = &'v mut bool>,
    ) -> Result<(), CoreError> {
        let targets: Vec<&mut bool> = values.collect();
        let mut list: Vec<usize> = targets.iter().map(|v| usize::from(**v)).collect();
        self.counts(name, list.iter_mut())?;
        if list.iter().any(|&v| v > 1) {
            return Err(refuse(name, "is neither 0 nor 1"));
        }
        targets
            .into_iter()
            .zip(list)
            .for_each(|(v, new)| *v = new == 1);
        Ok(())
    }
}

/// Count from a number, which has to be whole.
pub(crate) fn count(name: &str, number: f64) -> Result<usize, CoreError> {
    if number.fract() == 0.0 && (0.0..LARGEST_EXACT).contains(&number) {
        return Ok(number as usize);
    }
    Err(refuse(name, "is no count"))
}
