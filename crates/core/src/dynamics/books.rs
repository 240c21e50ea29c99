//! The energy ledger of a run, whatever its steps are, and when it ends the run.

use super::balance::Balance;
use super::entries::Entries;
use super::ledger::{Ledger, StepForces};
use super::run::Run;
use crate::error::CoreError;

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
#[derive(Debug)]
pub(super) enum Books<const DIM: usize, const D: usize> {
    Solved(Box<Ledger<D>>),
    Explicit(Box<Balance<DIM, D>>),
}

impl<const DIM: usize, const D: usize> Books<DIM, D> {
    /// Open the ledger of a run at its start, if one is kept.
    pub fn open(run: &Run<'_, DIM, D>) -> Option<Self> {
        if !run.plan.ledger {
            return None;
        }
        let (p, state, riders) = (&run.p, &run.state, &run.riders);
        let solved = || Ledger::new(p, state, riders, &run.contacts, run.datum);
        Some(match (p.explicit_steps(), &state.grid) {
            (Some(steps), Some(grid)) => {
                let with = (run.datum, run.plan.ledger_every);
                let contacts = &run.contacts;
                let new = Balance::new(p, (steps, grid), state, riders, contacts, with);
                Self::Explicit(Box::new(new))
            }
            _ => Self::Solved(Box::new(solved())),
        })
    }

    fn entries(&self) -> &Entries {
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
}

impl<const DIM: usize, const D: usize> Run<'_, DIM, D> {
    /// Take the step, booking its energies when a ledger is kept.
    ///
    /// # Errors
    /// [`CoreError::Balance`] when they do not add up, [`CoreError::NotFinite`].
    pub(super) fn take(
        &mut self,
        books: Option<&mut Books<DIM, D>>,
        step: usize,
        speed: f64,
    ) -> Result<(), CoreError> {
        self.record.steps = step + 1;
        let is_row = step.is_multiple_of(self.plan.line_every);
        let is_end = step + 2 == self.travel.positions.len();
        let Some(books) = books else {
            self.advance();
            return self.check_sound(step);
        };
        let settled = self.book(books, (step, speed), is_row || is_end);
        self.check_sound(step)?;
        if settled {
            self.check_balance(books, step)?;
        }
        if is_row {
            let row = if settled {
                *books.entries()
            } else {
                Entries::unknown()
            };
            self.record.energy.push(row);
        }
        Ok(())
    }

    fn forces(&self) -> StepForces<'_, DIM> {
        StepForces {
            contacts: &self.contacts,
            unilateral: &self.unilateral,
            friction: &self.friction,
            loads: &self.loads,
            datum: self.datum,
        }
    }

    fn advance(&mut self) {
        let p = &*self.p;
        p.advance(&mut self.state);
        let riders = self.riders.iter_mut();
        riders.for_each(|r| r.advance(&p.coefficients));
    }

    /// Tells whether the ledger has been settled.
    fn book(
        &mut self,
        books: &mut Books<DIM, D>,
        (step, speed): (usize, f64),
        is_due: bool,
    ) -> bool {
        match books {
            Books::Solved(ledger) => {
                ledger.before(&self.p, &self.state, &self.riders, speed);
                self.advance();
                ledger.after(&self.p, &self.state, &self.riders, &self.forces());
                if is_due {
                    ledger.settle(&self.p, &self.state);
                }
                is_due
            }
            Books::Explicit(balance) => {
                let at = (step, speed);
                balance.before(&self.p, &self.state, &self.riders, at, &self.forces());
                self.advance();
                let (state, riders) = (&self.state, &self.riders);
                balance.after(&self.p, state, riders, (step, is_due), &self.unilateral)
            }
        }
    }

    fn check_balance(&mut self, books: &Books<DIM, D>, step: usize) -> Result<(), CoreError> {
        let [residual, least, switched, stored] = books.off();
        let r = &mut self.record;
        r.energy_residual = r.energy_residual.max(residual.abs());
        r.energy_turnover = r.energy_turnover.max(books.entries().turnover());
        r.energy_switching = r.energy_switching.max(books.entries().switching.abs());
        let scale = r.energy_turnover.max(stored);
        let is_rigid = self.p.contact_flexibility == 0.0;
        // What is not a number is not within.
        let within = |value: f64, share: f64| value.abs() <= share * scale;
        let (what, off) = if !within(residual, BALANCE) {
            ("residual", residual)
        } else if !within(least.min(0.0), GIVEN) {
            ("damping", least)
        } else if !is_rigid && !within(switched, SWITCHING) {
            ("switching", switched)
        } else {
            return Ok(());
        };
        Err(CoreError::Balance {
            what,
            step,
            time: (step + 1) as f64 * self.p.h,
            off,
            turnover: scale,
        })
    }

    /// Everything that explicit steps move, forces and riders: step by step, as nothing else sees all of it.
    fn check_sound(&self, step: usize) -> Result<(), CoreError> {
        let Some(grid) = &self.state.grid else {
            return Ok(());
        };
        let of_riders = self.riders.iter().flat_map(|r| &r.u);
        let mut all = of_riders.chain(&self.unilateral.force);
        if grid.is_sound() && all.all(|v| v.is_finite()) {
            return Ok(());
        }
        let what = "the motion";
        Err(CoreError::NotFinite { what, step })
    }
}
