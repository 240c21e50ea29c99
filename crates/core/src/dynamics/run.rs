//! A whole run: start in equilibrium, step, record.

use super::actuator::{Ask, Sample};
use super::books::Books;
use super::contact::Unilateral;
use super::contacts::Contacts;
use super::loads::{Load, Loads};
use super::part::Part;
use super::place::Place;
use super::raised::Spot;
use super::record::{Record, RecordPlan};
use super::rider::{Rider, RiderState, inner};
use super::stepper::{LineState, Prepared};
use crate::error::CoreError;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// Motion along the track and laws of the contact.
#[derive(Debug, Clone)]
pub struct Travel {
    /// Position of the first rider at the start and after each step, m.
    pub positions: Vec<f64>,
    /// Speed at the same instants, m/s.
    pub speeds: Vec<f64>,
    /// Distance of each rider behind the first, m.
    pub distances: Vec<f64>,
    /// Coefficient of friction along the wire.
    pub friction: f64,
    /// Forces on the line, given at the same instants.
    pub loads: Vec<Load>,
}

/// Steps between two calls of the observer: often enough to stop within a fraction of a second.
pub(super) const OBSERVE_EVERY: usize = 256;

/// A run in progress.
pub(super) struct Run<'a, const DIM: usize, const D: usize> {
    /// A copy of its own with updated kinematics, where every step changes it.
    pub(super) p: Cow<'a, Prepared<DIM, D>>,
    pub(super) travel: &'a Travel,
    pub(super) plan: &'a RecordPlan,
    /// Riders as they were given.
    pub(super) described: &'a [Rider],
    pub(super) state: LineState<D>,
    pub(super) riders: Vec<RiderState>,
    pub(super) start_u: Vec<Vec<f64>>,
    pub(super) unilateral: Unilateral,
    pub(super) datum: f64,
    pub(super) contacts: Contacts<DIM>,
    pub(super) points: Vec<Place<DIM>>,
    /// Watched nodes on lanes, where wires yield beyond the mesh.
    pub(super) spots: BTreeMap<usize, Spot<DIM>>,
    /// For each island, which of the watched nodes of the plan lie on it.
    pub(super) watched: Vec<Vec<usize>>,
    pub(super) gaps: Vec<f64>,
    pub(super) friction: Vec<f64>,
    pub(super) loads: Loads<'a>,
    pub(super) record: Record,
}

impl<const DIM: usize, const D: usize> Prepared<DIM, D> {
    /// Run all steps of `travel`. `observe` is called now and then with the number of steps done;
    /// the run ends with [`CoreError::Cancelled`] when it returns `false`.
    ///
    /// # Errors
    /// Any [`CoreError`] that a step can raise.
    pub fn run(
        &self,
        riders: &[Rider],
        travel: &Travel,
        plan: &RecordPlan,
        observe: &mut dyn FnMut(usize) -> bool,
    ) -> Result<Record, CoreError> {
        let mut nobody = |_: usize, _: &Sample| Err("nobody controls it".into());
        self.run_controlled(riders, travel, plan, observe, &mut nobody)
    }

    /// The same, with someone to ask for the forces of actuators.
    ///
    /// # Errors
    /// Any [`CoreError`] that a step can raise, [`CoreError::Control`] among them.
    pub fn run_controlled(
        &self,
        riders: &[Rider],
        travel: &Travel,
        plan: &RecordPlan,
        observe: &mut dyn FnMut(usize) -> bool,
        ask: Ask<'_>,
    ) -> Result<Record, CoreError> {
        let whole = Part::default();
        let done = self.run_part(riders, travel, plan, whole, observe, ask);
        done.map(|(record, _)| record)
    }
}

/// Check what a run is given.
///
/// # Errors
/// [`CoreError::Input`].
pub(super) fn check(
    riders: &[Rider],
    travel: &Travel,
    plan: &RecordPlan,
    updates: bool,
) -> Result<(), CoreError> {
    let refuse = |array, reason: &str| {
        Err(CoreError::Input {
            array,
            reason: reason.into(),
        })
    };
    if riders.is_empty() || travel.distances.len() != riders.len() {
        return refuse("riders", "none, or not one distance for each");
    }
    if travel.positions.len() < 2 || travel.speeds.len() != travel.positions.len() {
        return refuse("positions", "fewer than two, or not one speed for each");
    }
    let all = [&travel.positions, &travel.speeds, &travel.distances];
    if all.iter().any(|a| a.iter().any(|v| !v.is_finite())) || !travel.friction.is_finite() {
        return refuse("positions", "not finite");
    }
    for rider in riders {
        rider.given.check_instants(travel.positions.len())?;
    }
    if plan.ledger && updates {
        return refuse("plan", "an energy ledger with updated kinematics");
    }
    if plan.contact_every == 0 || plan.line_every == 0 || plan.ledger_every == 0 {
        return refuse("plan", "a recording interval of zero steps");
    }
    Ok(())
}

/// Refuse to watch nodes that are not there.
///
/// # Errors
/// [`CoreError::Input`].
pub(super) fn check_nodes(watched: &[usize], nodes: usize) -> Result<(), CoreError> {
    match watched.iter().find(|&&node| node >= nodes) {
        None => Ok(()),
        Some(node) => Err(CoreError::Input {
            array: "plan",
            reason: format!("node {node} of {nodes} is watched"),
        }),
    }
}

impl<'a, const DIM: usize, const D: usize> Run<'a, DIM, D> {
    /// One step, readable from top to bottom.
    pub(super) fn step(
        &mut self,
        step: usize,
        books: Option<&mut Books<DIM, D>>,
    ) -> Result<(), CoreError> {
        if self.p.updating.is_some() {
            self.p.to_mut().reform(&mut self.state, step)?;
        }
        let old = self.p.coefficients.old;
        let between = |a: &[f64]| (1.0 - old) * a[step + 1] + old * a[step];
        let speed = between(&self.travel.speeds);
        let position = between(&self.travel.positions);
        self.move_contacts(step, position)?;

        // Friction of the force of the step before, T = f n (Amontons–Coulomb), drags the wire along.
        for (t, n) in self.friction.iter_mut().zip(&self.unilateral.force) {
            *t = self.travel.friction * n;
        }
        // Motion without contact forces.
        self.loads.begin(step, old);
        let (p, contacts, friction) = (&*self.p, &self.contacts, &self.friction);
        let loads = &self.loads;
        p.free_increment(&mut self.state, |f| {
            loads.add_to(f);
            for &i in contacts.active.iter().filter(|&&i| friction[i] != 0.0) {
                contacts.all[i].place.add_force(friction[i], 0, f);
            }
            !loads.is_empty() || friction.iter().any(|t| *t != 0.0)
        });
        for rider in &mut self.riders {
            rider.begin(&p.coefficients, step);
            rider.free_increment(&p.coefficients, speed);
        }
        self.measure_gaps();

        // Contacts and slack links together.
        let stats = self.close(step)?;
        self.count(&stats);
        self.watch(step, speed, position);
        self.take(books, step, speed)
    }

    /// Contacts of the step; `balance` is the position of the first rider at the time of balance.
    fn move_contacts(&mut self, step: usize, balance: f64) -> Result<(), CoreError> {
        let x = &self.travel.positions;
        let positions = [x[step], balance, x[step + 1]];
        let (lanes, u) = (&self.p.lanes, &self.state.u);
        self.contacts
            .find(self.described, lanes, u, positions, step)?;
        self.contacts.slide(&self.riders);
        self.unilateral.choose(&self.contacts);
        self.look();
        self.wake();
        Ok(())
    }

    /// Tell an explicit line where it is read.
    fn look(&mut self) {
        let (Some(steps), Some(grid)) = (self.p.explicit_steps(), &mut self.state.grid) else {
            return;
        };
        let lanes = &self.p.lanes;
        let with_wire = self.contacts.all.iter().filter(|c| c.has_wire);
        let nodes = with_wire.flat_map(|c| lanes[c.of[2]].around(&c.place));
        if !self.contacts.all.is_empty() {
            steps.look_at(grid, nodes);
        }
    }

    /// Gaps that the motion without contact forces would open (or, negative, close).
    fn measure_gaps(&mut self) {
        let keep = self.p.coefficients.stiffness;
        for &i in &self.contacts.active {
            let contact = &self.contacts.all[i];
            let (rider, e) = (&self.riders[contact.rider()], &contact.vector);
            let strip = self.datum + inner(e, &rider.u) + keep * inner(e, &rider.delta);
            let raised = contact.yields.rise + self.raised_by_links(&contact.yields, keep);
            self.gaps[i] = self.wire_at(contact, DIM - 1) + raised - strip;
        }
    }

    pub(super) fn check_finite(&self, step: usize) -> Result<(), CoreError> {
        let line = self.state.u.iter().flatten();
        let riders = self.riders.iter().flat_map(|r| &r.u);
        let finite = line.chain(riders).all(|v| v.is_finite());
        if finite && self.unilateral.force.iter().all(|v| v.is_finite()) {
            return Ok(());
        }
        Err(CoreError::NotFinite {
            what: "the motion",
            step,
        })
    }
}
