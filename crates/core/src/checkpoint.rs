//! A state between two steps as plain numbers under plain names, for files.
//!
//! Only what the motion has made of the run is in it. What follows from line, riders and travel is
//! made anew by whoever goes on, from the same line, riders and travel.

use crate::error::CoreError;
use std::collections::BTreeMap;

/// Numbers with which a run goes on as if it had never stopped.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Checkpoint {
    /// Steps done.
    pub step: usize,
    /// Numbers by name, SI; counts and flags are whole numbers.
    pub numbers: BTreeMap<String, Vec<f64>>,
}

/// Refuse a state.
pub(crate) fn refuse(name: &str, reason: &str) -> CoreError {
    CoreError::Input {
        array: "state",
        reason: format!("`{name}` {reason}"),
    }
}

/// Goes through everything that changes during a run. One walk takes a state down and puts it
/// back, so that neither can forget what the other knows.
pub(crate) struct Archive<'a> {
    /// What is put back; `None` while a state is taken down.
    saved: Option<&'a BTreeMap<String, Vec<f64>>>,
    taken: BTreeMap<String, Vec<f64>>,
    met: usize,
}

/// Whole numbers up to this one are exact.
const MOST: f64 = 9_007_199_254_740_992.0;

impl<'a> Archive<'a> {
    pub(crate) fn taking_down() -> Self {
        Self {
            saved: None,
            taken: BTreeMap::new(),
            met: 0,
        }
    }

    pub(crate) fn putting_back(saved: &'a Checkpoint) -> Self {
        Self {
            saved: Some(&saved.numbers),
            taken: BTreeMap::new(),
            met: 0,
        }
    }

    /// Checkpoint after `step` steps.
    pub(crate) fn checkpoint(self, step: usize) -> Checkpoint {
        Checkpoint {
            step,
            numbers: self.taken,
        }
    }

    /// Nothing may be left over: it would belong to another run.
    pub(crate) fn finish(&self) -> Result<(), CoreError> {
        match self.saved {
            Some(saved) if saved.len() != self.met => {
                Err(refuse("numbers", "has parts that this run does not have"))
            }
            _ => Ok(()),
        }
    }

    /// A list of any length.
    pub(crate) fn list(&mut self, name: &str, values: &mut Vec<f64>) -> Result<(), CoreError> {
        self.met += 1;
        let Some(saved) = self.saved else {
            self.taken.insert(name.into(), values.clone());
            return Ok(());
        };
        let saved = saved.get(name).ok_or_else(|| refuse(name, "is missing"))?;
        if !saved.iter().all(|v| v.is_finite()) {
            return Err(refuse(name, "is not finite"));
        }
        values.clone_from(saved);
        Ok(())
    }

    /// As many numbers as there are.
    pub(crate) fn numbers<'v>(
        &mut self,
        name: &str,
        values: impl Iterator<Item = &'v mut f64>,
    ) -> Result<(), CoreError> {
        let places: Vec<&mut f64> = values.collect();
        let mut list = places.iter().map(|v| **v).collect();
        self.list(name, &mut list)?;
        if list.len() != places.len() {
            let reason = format!("has {} numbers, not {}", list.len(), places.len());
            return Err(refuse(name, &reason));
        }
        places.into_iter().zip(list).for_each(|(v, new)| *v = new);
        Ok(())
    }

    /// As many counts as there are.
    pub(crate) fn counts<'v>(
        &mut self,
        name: &str,
        values: impl Iterator<Item = &'v mut usize>,
    ) -> Result<(), CoreError> {
        let places: Vec<&mut usize> = values.collect();
        let mut list: Vec<f64> = places.iter().map(|v| **v as f64).collect();
        self.numbers(name, list.iter_mut())?;
        for (place, number) in places.into_iter().zip(list) {
            *place = count(name, number)?;
        }
        Ok(())
    }

    /// As many flags as there are.
    pub(crate) fn flags<'v>(
        &mut self,
        name: &str,
        values: impl Iterator<Item = &'v mut bool>,
    ) -> Result<(), CoreError> {
        let places: Vec<&mut bool> = values.collect();
        let mut list: Vec<usize> = places.iter().map(|v| usize::from(**v)).collect();
        self.counts(name, list.iter_mut())?;
        if list.iter().any(|&v| v > 1) {
            return Err(refuse(name, "is neither 0 nor 1"));
        }
        places
            .into_iter()
            .zip(list)
            .for_each(|(v, new)| *v = new == 1);
        Ok(())
    }
}

/// A whole number.
pub(crate) fn count(name: &str, number: f64) -> Result<usize, CoreError> {
    if number.fract() == 0.0 && (0.0..MOST).contains(&number) {
        return Ok(number as usize);
    }
    Err(refuse(name, "is no count"))
}
