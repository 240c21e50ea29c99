//! The energy ledger of a run, whatever its steps are, and when it ends the run.

use crate::checkpoint::Archive;
use crate::error::CoreError;
use crate::integrator::energy::entries::EnergyTerms;
use crate::integrator::energy::explicit::ExplicitBalance;
use crate::integrator::energy::implicit::{ImplicitBalance, StepForces};
use crate::simulation::inputs::Inputs;
use crate::simulation::model::Model;
use crate::simulation::recording::record::Record;
use crate::simulation::state::Motion;

/// Residual that is allowed, as a share of the energy turned over. Rounding is 1e-13 to 1e-12 of it; a force in the wrong
/// place, or a damper that takes a hundredth too much, is 1e-5 and more.
const BALANCE: f64 = 1e-9;
/// Energy that wires may give between two measured steps in the place of taking some, as a share of what is turned over.
/// Damping reads a velocity that is half a step old, so in a single window of a line that is hardly damped it may
/// give a little.
const GIVEN: f64 = 1e-5;

/// Energy that compliant contacts and links may take or give by opening and closing within steps, as a share of the energy
/// turned over. It falls with the step; at 1 ms it is some thousandths, and more where contact is lost often.
/// Gaps that are measured elsewhere than where the contact presses go beyond it.
const SWITCHING: f64 = 0.05;

/// A ledger of either kind.
#[derive(Debug, Clone)]
pub(crate) enum EnergyBalance<const DIM: usize, const D: usize> {
    Solved(Box<ImplicitBalance<D>>),
    Explicit(Box<ExplicitBalance<DIM, D>>),
}

impl<const DIM: usize, const D: usize> EnergyBalance<DIM, D> {
    /// Open the ledger of a run at its start; explicit steps measure what wires dissipate every so
    /// many of them.
    pub(crate) fn open(model: &Model<'_, DIM, D>, motion: &Motion<DIM, D>, every: usize) -> Self {
        let (p, state, riders) = (model.line, &motion.line, &motion.riders);
        let (contacts, datum) = (&motion.contacts, motion.datum);
        match p.explicit_state(state) {
            Some((steps, grid)) => {
                let with = (datum, every);
                let new = ExplicitBalance::new(p, (steps, grid), state, riders, contacts, with);
                Self::Explicit(Box::new(new))
            }
            None => Self::Solved(Box::new(ImplicitBalance::new(
                p, state, riders, contacts, datum,
            ))),
        }
    }

    fn entries(&self) -> &EnergyTerms {
        match self {
            Self::Solved(ledger) => &ledger.entries,
            Self::Explicit(balance) => &balance.entries,
        }
    }

    /// Residual, the least that wires have dissipated in a while, what contacts and links have by opening and
    /// closing, and the energy of the line, J.
    fn off(&self) -> [f64; 4] {
        match self {
            Self::Solved(ledger) => {
                let stored = ledger.start_linear.abs();
                [ledger.entries.residual(), 0.0, 0.0, stored]
            }
            Self::Explicit(b) => [b.residual(), b.least(), b.switched(), b.largest()],
        }
    }

    /// Whether every island must be stepped for the ledger to close.
    pub(crate) fn needs_all_islands(&self) -> bool {
        matches!(self, Self::Solved(_))
    }

    /// Book an island that is about to be laid to rest.
    pub(crate) fn leave(
        &mut self,
        model: &Model<'_, DIM, D>,
        motion: &Motion<DIM, D>,
        island: usize,
    ) {
        if let (Self::Explicit(own), Some(at)) = (self, model.line.explicit_state(&motion.line)) {
            own.leave(model.line, at, island);
        }
    }

    /// Find again what follows from a state that was put back.
    pub(crate) fn resume(&mut self, model: &Model<'_, DIM, D>, motion: &Motion<DIM, D>) {
        if let Self::Explicit(own) = self {
            own.go_on(model.line, &motion.riders);
        }
    }

    /// Save or put back the sums so far.
    ///
    /// # Errors
    /// [`CoreError::Input`] for numbers that do not fit.
    pub(crate) fn walk(&mut self, walk: &mut Archive<'_>) -> Result<(), CoreError> {
        match self {
            Self::Solved(own) => own.walk(walk),
            Self::Explicit(own) => own.walk(walk),
        }
    }

    /// Take the step and book its energies; tells whether the ledger is settled, which it is when due.
    pub(crate) fn take(
        &mut self,
        model: &Model<'_, DIM, D>,
        inputs: &Inputs<'_>,
        motion: &mut Motion<DIM, D>,
        is_due: bool,
    ) -> bool {
        let (p, step, speed) = (model.line, motion.steps, inputs.speed);
        match self {
            Self::Solved(ledger) => {
                ledger.before(p, &motion.line, &motion.riders, speed);
                motion.advance(model);
                let forces = motion.forces(inputs);
                ledger.after(p, &motion.line, &motion.riders, &forces);
                if is_due {
                    ledger.settle(p, &motion.line);
                }
                is_due
            }
            Self::Explicit(balance) => {
                let (at, forces) = ((step, speed), motion.forces(inputs));
                balance.before(p, &motion.line, &motion.riders, at, &forces);
                motion.advance(model);
                let (state, riders) = (&motion.line, &motion.riders);
                balance.after(p, state, riders, (step, is_due), &motion.unilateral)
            }
        }
    }

    /// Check a settled ledger, and note how far it is off; returns its entries.
    ///
    /// # Errors
    /// [`CoreError::Balance`] when energies do not add up.
    pub(crate) fn check(
        &self,
        model: &Model<'_, DIM, D>,
        r: &mut Record,
        step: usize,
    ) -> Result<EnergyTerms, CoreError> {
        let [residual, least, switched, stored] = self.off();
        let entries = *self.entries();
        r.energy_residual = r.energy_residual.max(residual.abs());
        r.energy_turnover = r.energy_turnover.max(entries.turnover());
        r.energy_switching = r.energy_switching.max(entries.switching.abs());
        let scale = r.energy_turnover.max(stored);
        let is_rigid = model.line.contact_flexibility == 0.0;
        // What is not a number is not within.
        let within = |value: f64, share: f64| value.abs() <= share * scale;
        let (what, off) = if !within(residual, BALANCE) {
            ("residual", residual)
        } else if !within(least.min(0.0), GIVEN) {
            ("damping", least)
        } else if !is_rigid && !within(switched, SWITCHING) {
            ("switching", switched)
        } else {
            return Ok(entries);
        };
        Err(CoreError::Balance {
            what,
            step,
            time: (step + 1) as f64 * model.line.h,
            off,
            turnover: scale,
        })
    }
}

impl<const DIM: usize, const D: usize> Motion<DIM, D> {
    fn forces<'a>(&'a self, inputs: &'a Inputs<'_>) -> StepForces<'a, DIM> {
        StepForces {
            contacts: &self.contacts,
            unilateral: &self.unilateral,
            friction: &self.friction,
            loads: inputs.loads,
            datum: self.datum,
        }
    }
}
