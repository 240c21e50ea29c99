//! Instance of an FMU: a device, where it stands in the life that the FMI prescribes, and messages.

use crate::location::model_path;
use crate::pointers::without_panic;
use arcless_device::file::token;
use arcless_device::{Failure, Kind, Stepper};

/// Status of a function of the FMI, in both versions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[repr(i32)]
pub enum Status {
    /// All well.
    Ok = 0,
    /// Not used: there are no warnings.
    Warning = 1,
    /// Done in part: the steps before the one that failed are taken.
    Discard = 2,
    /// Not done; a state can be restored, or the instance reset.
    Error = 3,
    /// Fault of the library.
    Fatal = 4,
}

impl Status {
    /// Category of its messages.
    #[must_use]
    pub fn category(self) -> &'static str {
        match self {
            Self::Discard => "logStatusDiscard",
            Self::Fatal => "logStatusFatal",
            _ => "logStatusError",
        }
    }
}

/// Phase of the life of an instance.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// Made; start values may be set.
    Instantiated,
    /// Initialized.
    Initialization,
    /// Steps are taken.
    Stepping,
    /// Ended.
    Terminated,
    /// An error has occurred.
    Failed,
    /// The library has failed; nothing can be done but to free the instance.
    Broken,
}

impl Phase {
    fn words(self) -> &'static str {
        match self {
            Self::Instantiated => "before the initialization has begun",
            Self::Initialization => "before the initialization has ended",
            Self::Stepping => "while steps are taken",
            Self::Terminated => "after the end",
            Self::Failed => "after an error: restore a state, or reset",
            Self::Broken => "after a fault of the library",
        }
    }

    fn of(number: u8) -> Option<Self> {
        let all = [
            Self::Instantiated,
            Self::Initialization,
            Self::Stepping,
            Self::Terminated,
        ];
        all.get(usize::from(number)).copied()
    }
}

/// Where messages go.
pub trait Log {
    /// Passes a message on.
    fn message(&self, status: Status, message: &str);
}

/// Instance of an FMU.
pub struct Instance<L: Log> {
    /// Device.
    pub stepper: Stepper,
    /// Phase.
    pub phase: Phase,
    log: L,
}

/// Saved state of an instance: its phase, then that of the device.
pub type Saved = Vec<u8>;

impl<L: Log> Instance<L> {
    /// Instance from the resources of an FMU, whose description has a token. `None` after a message
    /// to the log.
    pub fn open(location: &str, expected: &str, log: L) -> Option<Self> {
        let opened = without_panic(|| open(location, expected));
        match opened.and_then(|found| found) {
            Ok(stepper) => Some(Self {
                stepper,
                phase: Phase::Instantiated,
                log,
            }),
            Err(message) => {
                log.message(Status::Error, &message);
                None
            }
        }
    }

    /// Does something with the instance; a failure becomes a status and a message.
    pub fn attempt(&mut self, work: impl FnOnce(&mut Self) -> Result<(), Failure>) -> Status {
        if self.phase == Phase::Broken {
            return Status::Fatal;
        }
        match without_panic(|| work(self)) {
            Ok(Ok(())) => Status::Ok,
            Ok(Err(failure)) => {
                // Steps that were taken stay, and inputs may be changed: the others are as before.
                let status = match failure.kind {
                    Kind::Step => Status::Discard,
                    _ => Status::Error,
                };
                if status == Status::Error && failure.kind != Kind::NotOffered {
                    self.phase = Phase::Failed;
                }
                self.log.message(status, &failure.message);
                status
            }
            Err(message) => {
                self.phase = Phase::Broken;
                self.log.message(Status::Fatal, &message);
                Status::Fatal
            }
        }
    }

    /// Refuses what is not done in the present phase.
    ///
    /// # Errors
    /// [`Failure`] with what was asked for and when it may be.
    pub fn expect(&self, what: &str, phases: &[Phase]) -> Result<(), Failure> {
        if phases.contains(&self.phase) {
            return Ok(());
        }
        let (time, when) = (self.stepper.time(), self.phase.words());
        let message = format!("{what} at t = {time} s, {when}");
        Err(Failure::new(Kind::Time, message))
    }

    /// Values of variables.
    ///
    /// # Errors
    /// [`Kind::Value`].
    pub fn get(&mut self, numbers: &[u32], values: &mut [f64]) -> Result<(), Failure> {
        self.same_length(numbers.len(), values.len())?;
        let mut pairs = numbers.iter().zip(values);
        pairs.try_for_each(|(&number, value)| {
            *value = self.stepper.get(number as usize)?;
            Ok(())
        })
    }

    /// Sets inputs.
    ///
    /// # Errors
    /// [`Kind::Value`], or a phase in which nothing is set.
    pub fn set(&mut self, numbers: &[u32], values: &[f64]) -> Result<(), Failure> {
        use Phase::{Initialization, Instantiated, Stepping};
        self.expect("an input is set", &[Instantiated, Initialization, Stepping])?;
        self.same_length(numbers.len(), values.len())?;
        let mut pairs = numbers.iter().zip(values);
        pairs.try_for_each(|(&number, &value)| self.stepper.set(number as usize, value))
    }

    fn same_length(&self, numbers: usize, values: usize) -> Result<(), Failure> {
        if numbers == values {
            return Ok(());
        }
        let time = self.stepper.time();
        let message = format!("{values} values for {numbers} variables at t = {time} s");
        Err(Failure::new(Kind::Value, message))
    }

    /// Begins, at a time, s, where one is given.
    ///
    /// # Errors
    /// [`Kind::Time`] for one that is not finite, or when the instance has begun.
    pub fn begin(&mut self, start_time: Option<f64>) -> Result<(), Failure> {
        self.expect("the initialization begins", &[Phase::Instantiated])?;
        start_time.map_or(Ok(()), |time| self.stepper.begin(time))?;
        self.phase = Phase::Initialization;
        Ok(())
    }

    /// Ends the initialization.
    ///
    /// # Errors
    /// [`Kind::Time`] when it has not begun.
    pub fn end_initialization(&mut self) -> Result<(), Failure> {
        self.expect("the initialization ends", &[Phase::Initialization])?;
        self.phase = Phase::Stepping;
        Ok(())
    }

    /// Ends the simulation.
    ///
    /// # Errors
    /// [`Kind::Time`] when no step could be taken.
    pub fn terminate(&mut self) -> Result<(), Failure> {
        self.expect("the simulation ends", &[Phase::Stepping, Phase::Failed])?;
        self.phase = Phase::Terminated;
        Ok(())
    }

    /// Takes a communication step.
    ///
    /// # Errors
    /// [`Kind::Time`], [`Kind::Step`].
    pub fn advance(&mut self, from: f64, length: f64) -> Result<(), Failure> {
        self.expect("a step is asked for", &[Phase::Stepping])?;
        self.stepper.advance(from, length)
    }

    /// Returns to the start.
    ///
    /// # Errors
    /// [`Failure`] of the device.
    pub fn reset(&mut self) -> Result<(), Failure> {
        self.stepper.reset()?;
        self.phase = Phase::Instantiated;
        Ok(())
    }

    /// State, with the phase.
    ///
    /// # Errors
    /// A phase that is not kept, [`Failure`] of the device.
    pub fn save(&mut self) -> Result<Saved, Failure> {
        use Phase::{Initialization, Instantiated, Stepping, Terminated};
        let kept = [Instantiated, Initialization, Stepping, Terminated];
        self.expect("a state is saved", &kept)?;
        let mut saved = self.stepper.save()?;
        saved.push(self.phase as u8);
        Ok(saved)
    }

    /// Restores a state.
    ///
    /// # Errors
    /// [`Kind::Data`]; the present state is then kept.
    pub fn restore(&mut self, saved: &[u8]) -> Result<(), Failure> {
        let split = saved.split_last();
        let known = split.and_then(|(number, device)| Some((Phase::of(*number)?, device)));
        let Some((phase, device)) = known else {
            let time = self.stepper.time();
            let message = format!("a state is restored at t = {time} s: it is damaged, or none");
            return Err(Failure::data(message));
        };
        self.stepper.restore(device)?;
        self.phase = phase;
        Ok(())
    }
}

/// Failure of a function that has to exist but does nothing.
#[must_use]
pub fn not_offered(function: &str) -> Failure {
    let message = format!("{function} is not offered: see the flags of the description");
    Failure::new(Kind::NotOffered, message)
}

/// Values of a type that no variable has: fine when none are asked for.
///
/// # Errors
/// [`Kind::NotOffered`].
pub fn none_of(function: &str, count: usize) -> Result<(), Failure> {
    if count == 0 {
        return Ok(());
    }
    let message = format!("{function}: no variable has this type, all are real numbers");
    Err(Failure::new(Kind::NotOffered, message))
}

/// Device in the resources of an FMU.
fn open(location: &str, expected: &str) -> Result<Stepper, String> {
    let path = model_path(location)?;
    let bytes = std::fs::read(&path).map_err(|error| {
        let name = path.display();
        format!("the model of the FMU cannot be read: `{name}`: {error}")
    })?;
    let stepper = Stepper::open(&bytes).map_err(|failure| failure.message)?;
    let own = token(stepper.digest());
    if own != expected {
        return Err(format!(
            "the description is of the model {expected}, the resources have {own}: one of them was \
             changed after the export"
        ));
    }
    Ok(stepper)
}
