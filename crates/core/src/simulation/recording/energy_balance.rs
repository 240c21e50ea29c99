//! Energy balance of a run, independent of its integrator, and the limits that end the run.

use crate::checkpoint::Archive;
use crate::energy_terms::EnergyTerms;
use crate::error::CoreError;
use crate::integrator::energy::explicit::ExplicitBalance;
use crate::integrator::energy::implicit::ImplicitBalance;
use crate::integrator::energy::step_forces::StepForces;
use crate::simulation::inputs::Inputs;
use crate::simulation::model::Model;
use crate::simulation::motion::Motion;
use crate::simulation::recording::record::Record;

/// Residual that is allowed, as a share of the energy turned over. Rounding is 1e-13 to 1e-12 of
/// it; a force in the wrong place, or a damper that takes a hundredth too much, is 1e-5 and more.
const BALANCE: f64 = 1e-9;
/// Energy that wires may supply between two measured steps instead of dissipating it, as a share of
/// the energy turned over. Damping reads a velocity that is half a step old, so in a single window
/// of a line that is hardly damped it may give a little.
const GIVEN: f64 = 1e-5;

/// Switching of compliant contacts and links within steps that is allowed, as a share of the energy
/// turned over. It falls with the step; at 1 ms it is some thousandths, and more where contact is
/// lost often. Gaps that are measured elsewhere than where the contact presses go beyond it.
const SWITCHING: f64 = 0.05;

/// Energy balance of either integrator.
#[derive(Debug, Clone)]
pub(crate) enum EnergyBalance<const DIM: usize, const D: usize> {
    Solved(Box<ImplicitBalance<D>>),
    Explicit(Box<ExplicitBalance<DIM, D>>),
}

impl<const DIM: usize, const D: usize> EnergyBalance<DIM, D> {
    /// Opens the balance of a run at its start; explicit steps measure the dissipation of wires
    /// every `every` steps.
    pub(crate) fn open(model: &Model<'_, DIM, D>, motion: &Motion<DIM, D>, every: usize) -> Self {
        let (p, state, pantographs) = (model.wires, &motion.wires, &motion.pantographs);
        let (contacts, datum) = (&motion.contacts, motion.datum);
        match p.explicit_state(state) {
            Some((steps, grid)) => {
                let with = (datum, every);
                let new =
                    ExplicitBalance::new(p, (steps, grid), state, pantographs, contacts, with);
                Self::Explicit(Box::new(new))
            }
            None => Self::Solved(Box::new(ImplicitBalance::new(
                p,
                state,
                pantographs,
                contacts,
                datum,
            ))),
        }
    }

    fn entries(&self) -> &EnergyTerms {
        match self {
            Self::Solved(ledger) => &ledger.terms,
            Self::Explicit(balance) => &balance.terms,
        }
    }

    /// Returns residual, smallest dissipation of wires between measured steps, switching of
    /// contacts and links, and energy of the line, J.
    fn off(&self) -> [f64; 4] {
        match self {
            Self::Solved(ledger) => {
                let stored = ledger.start_linear.abs();
                [ledger.terms.residual(), 0.0, 0.0, stored]
            }
            Self::Explicit(b) => [
                b.residual(),
                b.min_dissipation(),
                b.contact_and_link_switching(),
                b.max_line_energy(),
            ],
        }
    }

    /// Returns whether every island must be stepped for the balance to close.
    pub(crate) fn needs_all_islands(&self) -> bool {
        matches!(self, Self::Solved(_))
    }

    /// Removes the energy of an island that is about to be put to rest.
    pub(crate) fn leave(
        &mut self,
        model: &Model<'_, DIM, D>,
        motion: &Motion<DIM, D>,
        island: usize,
    ) {
        if let (Self::Explicit(own), Some(at)) = (self, model.wires.explicit_state(&motion.wires)) {
            own.remove_island(model.wires, at, island);
        }
    }

    /// Computes the data that follow from a restored state.
    pub(crate) fn resume(&mut self, model: &Model<'_, DIM, D>, motion: &Motion<DIM, D>) {
        if let Self::Explicit(own) = self {
            own.resume(model.wires, &motion.pantographs);
        }
    }

    /// Saves or restores the sums so far.
    ///
    /// # Errors
    /// [`CoreError::Input`] for numbers that do not fit.
    pub(crate) fn archive(&mut self, archive: &mut Archive<'_>) -> Result<(), CoreError> {
        match self {
            Self::Solved(own) => own.archive(archive),
            Self::Explicit(own) => own.archive(archive),
        }
    }

    /// Commits the step and adds its energies; returns whether the balance was evaluated, which it
    /// is when due.
    pub(crate) fn take(
        &mut self,
        model: &Model<'_, DIM, D>,
        inputs: &Inputs<'_>,
        motion: &mut Motion<DIM, D>,
        is_due: bool,
    ) -> bool {
        let (p, step, speed) = (model.wires, motion.steps, inputs.speed);
        match self {
            Self::Solved(ledger) => {
                ledger.before(p, &motion.wires, &motion.pantographs, speed);
                motion.commit(model);
                let forces = motion.forces(inputs);
                ledger.after(p, &motion.wires, &motion.pantographs, &forces);
                if is_due {
                    ledger.update_stored_energy(p, &motion.wires);
                }
                is_due
            }
            Self::Explicit(balance) => {
                let (at, forces) = ((step, speed), motion.forces(inputs));
                balance.before(p, &motion.wires, &motion.pantographs, at, &forces);
                motion.commit(model);
                let (state, pantographs) = (&motion.wires, &motion.pantographs);
                balance.after(p, state, pantographs, (step, is_due), &motion.problem)
            }
        }
    }

    /// Checks an evaluated balance, and records its residual; returns its terms.
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
        let is_rigid = model.wires.contact_flexibility == 0.0;
        // NaN is not within.
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
            time: (step + 1) as f64 * model.wires.h,
            off,
            turnover: scale,
        })
    }
}

impl<const DIM: usize, const D: usize> Motion<DIM, D> {
    fn forces<'a>(&'a self, inputs: &'a Inputs<'_>) -> StepForces<'a, DIM> {
        StepForces {
            contacts: &self.contacts,
            problem: &self.problem,
            friction: &self.friction,
            loads: inputs.loads,
            datum: self.datum,
        }
    }
}
