//! Everything that changes during a run, on the one [walk](super::state) that takes it down and puts it back.
//!
//! Not on it is what every step makes anew before it is read: increments, tensions, gaps, right-hand
//! sides, and all that updated kinematics form.

use super::actuator::ActuatorState;
use super::balance::Balance;
use super::books::Books;
use super::contacts::Contacts;
use super::law::Side;
use super::ledger::Ledger;
use super::path::Path;
use super::record::Record;
use super::rider::{Rider, RiderState};
use super::run::Run;
use super::state::{State, Walk, count, refuse};
use crate::error::CoreError;

type Done = Result<(), CoreError>;

impl<const DIM: usize, const D: usize> Run<'_, DIM, D> {
    /// The state after `step` steps.
    pub(super) fn take_down(
        &mut self,
        step: usize,
        books: Option<&mut Books<DIM, D>>,
    ) -> Result<State, CoreError> {
        let mut walk = Walk::taking_down();
        self.walk(&mut walk, books)?;
        Ok(walk.state(step))
    }

    /// Go on from a state.
    pub(super) fn put_back(
        &mut self,
        state: &State,
        mut books: Option<&mut Books<DIM, D>>,
    ) -> Done {
        let mut walk = Walk::putting_back(state);
        self.walk(&mut walk, books.as_deref_mut())?;
        walk.finish()?;
        if let Some(Books::Explicit(balance)) = books {
            balance.go_on(&self.p, &self.riders);
        }
        self.record.steps = state.step;
        self.contacts.go_on(self.described);
        self.p.go_on(&mut self.state);
        self.state.awake = (0..self.p.islands.len()).collect();
        self.let_sleep();
        Ok(())
    }

    fn walk(&mut self, walk: &mut Walk<'_>, books: Option<&mut Books<DIM, D>>) -> Done {
        let line = &mut self.state;
        walk.numbers("line_displacement", line.u.as_flattened_mut().iter_mut())?;
        walk.numbers("line_velocity", line.v.as_flattened_mut().iter_mut())?;
        walk.numbers("line_acceleration", line.a.as_flattened_mut().iter_mut())?;
        if let Some(grid) = &mut line.grid {
            walk.numbers("grid_across", grid.across())?;
            walk.numbers("grid_along", grid.x.iter_mut().flatten())?;
        }
        walk.numbers("link_elongation", line.links.numbers())?;
        walk.numbers("link_correction", self.unilateral.correction.iter_mut())?;
        walk.numbers("contact_force", self.unilateral.force.iter_mut())?;
        walk.numbers("datum", std::iter::once(&mut self.datum))?;
        walk_contacts(&mut self.contacts, walk, &self.p.lanes)?;
        let riders = self.riders.iter_mut().zip(&mut self.start_u);
        for (number, (rider, start)) in riders.enumerate() {
            walk_rider(rider, start, walk, &format!("rider_{number}"))?;
        }
        walk_record(&mut self.record, walk)?;
        match books {
            Some(Books::Solved(ledger)) => walk_ledger(ledger, walk),
            Some(Books::Explicit(balance)) => walk_balance(balance, walk),
            None => Ok(()),
        }
    }
}

fn walk_contacts<const DIM: usize>(
    contacts: &mut Contacts<DIM>,
    walk: &mut Walk<'_>,
    lanes: &[Path<DIM>],
) -> Done {
    let all = &mut contacts.all;
    walk.flags("contact_meets", all.iter_mut().map(|c| &mut c.meets))?;
    walk.numbers("contact_lateral", all.iter_mut().map(|c| &mut c.lateral))?;
    // A place follows from its element and its shape functions.
    let elements = all.iter_mut().map(|c| &mut c.ends[1].element);
    walk.counts("contact_element", elements)?;
    let weights = all.iter_mut().flat_map(|c| &mut c.ends[1].weights);
    walk.numbers("contact_weights", weights)?;
    for contact in all {
        let end = &mut contact.ends[1];
        let place = lanes[contact.of[2]].at(end.element, end.weights);
        *end = place.ok_or_else(|| refuse("contact_element", "is no element"))?;
    }
    Ok(())
}

fn walk_rider(
    rider: &mut RiderState,
    start: &mut [f64],
    walk: &mut Walk<'_>,
    prefix: &str,
) -> Done {
    let name = |part: &str| format!("{prefix}_{part}");
    walk.numbers(&name("displacement"), rider.u.iter_mut())?;
    walk.numbers(&name("velocity"), rider.v.iter_mut())?;
    walk.numbers(&name("acceleration"), rider.a.iter_mut())?;
    walk.numbers(&name("start"), start.iter_mut())?;
    let rest = [
        &mut rider.preload,
        &mut rider.drive.now,
        &mut rider.actuator.force,
    ];
    walk.numbers(&name("preload_ground_actuator"), rest.into_iter())?;
    walk_waiting(&mut rider.actuator, walk, &name("waiting"))?;
    // Stops are measured from the start.
    let closed = rider.kinks.iter_mut().map(|k| &mut k.closed);
    walk.numbers(&name("kink_closed"), closed)?;
    let force = rider.kinks.iter_mut().map(|k| &mut k.force);
    walk.numbers(&name("kink_force"), force)?;
    let ranges = rider.laws.iter_mut().flat_map(|l| &mut l.range);
    walk.numbers(&name("law_range"), ranges)?;
    let mut right: Vec<bool> = rider.laws.iter().map(|l| l.side == Side::Right).collect();
    walk.flags(&name("law_right"), right.iter_mut())?;
    for (law, right) in right.into_iter().enumerate() {
        rider.enter(law, if right { Side::Right } else { Side::Left });
    }
    Ok(())
}

/// Forces that wait: step and force of each, one after the other.
fn walk_waiting(actuator: &mut ActuatorState, walk: &mut Walk<'_>, name: &str) -> Done {
    let waiting = &mut actuator.waiting;
    let pairs = waiting.iter().flat_map(|&(due, force)| [due as f64, force]);
    let mut list = pairs.collect();
    walk.list(name, &mut list)?;
    if list.len() % 2 == 1 {
        return Err(refuse(name, "has a step without a force"));
    }
    waiting.clear();
    for pair in list.chunks_exact(2) {
        waiting.push_back((count(name, pair[0])?, pair[1]));
    }
    Ok(())
}

fn walk_record(record: &mut Record, walk: &mut Walk<'_>) -> Done {
    walk.numbers("link_min", record.link_min.iter_mut())?;
    walk.numbers("link_max", record.link_max.iter_mut())?;
    walk.numbers("uplift_max", record.uplift_max.iter_mut())?;
    walk.numbers("stop_max", record.stop_max.iter_mut())?;
    let counts = [
        &mut record.slack_max,
        &mut record.pivots,
        &mut record.pivots_max,
        &mut record.fallbacks,
    ];
    walk.counts("slack_pivots_fallbacks", counts.into_iter())?;
    let largest = [
        &mut record.lcp_residual,
        &mut record.energy_residual,
        &mut record.energy_turnover,
        &mut record.energy_switching,
    ];
    walk.numbers("residuals_turnover", largest.into_iter())?;
    let mut pivots: Vec<f64> = record.pivot_counts.iter().map(|&n| n as f64).collect();
    walk.list("pivot_counts", &mut pivots)?;
    let counts = pivots.into_iter().map(|n| count("pivot_counts", n));
    record.pivot_counts = counts.collect::<Result<_, _>>()?;
    Ok(())
}

fn walk_ledger<const D: usize>(ledger: &mut Ledger<D>, walk: &mut Walk<'_>) -> Done {
    walk.numbers("energy", ledger.entries.all_mut().into_iter())?;
    let start = [
        &mut ledger.start.contact,
        &mut ledger.start.riders,
        &mut ledger.start_linear,
        &mut ledger.start_slack,
        &mut ledger.start_laws,
    ];
    walk.numbers("energy_start", start.into_iter())?;
    let sums = [
        &mut ledger.inertia,
        &mut ledger.scheme_elastic,
        &mut ledger.scheme_riders,
        &mut ledger.slack_energy,
        &mut ledger.rider_energy,
        &mut ledger.law_energy,
    ];
    walk.numbers("energy_sums", sums.into_iter())
}

fn walk_balance<const DIM: usize, const D: usize>(
    balance: &mut Balance<DIM, D>,
    walk: &mut Walk<'_>,
) -> Done {
    walk.numbers("energy", balance.entries.all_mut().into_iter())?;
    walk.numbers("energy_sums", balance.numbers())?;
    walk.flags("energy_contact_meets", balance.meets())
}

impl<const DIM: usize> Contacts<DIM> {
    /// Read the strips where the wires lay in the last step.
    fn go_on(&mut self, riders: &[Rider]) {
        for contact in &mut self.all {
            let strip = &riders[contact.of[0]].strips[contact.of[1]];
            contact.read(strip);
        }
    }
}
