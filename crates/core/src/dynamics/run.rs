//! A whole run: start in equilibrium, step, record.

use super::actuator::{Ask, Sample};
use super::contact::Unilateral;
use super::ledger::{Ledger, StepForces};
use super::loads::{self, Load, Loads};
use super::path::Path;
use super::place::Place;
use super::record::{Record, RecordPlan};
use super::rider::{Rider, RiderState};
use super::stepper::{LineState, Prepared};
use super::still::Still;
use super::updated::follow;
use crate::error::CoreError;
use crate::lcp::LcpStats;
use std::borrow::Cow;

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
const OBSERVE_EVERY: usize = 256;

/// A run in progress.
pub(super) struct Run<'a, const DIM: usize, const D: usize> {
    /// A copy of its own with updated kinematics, where every step changes it.
    pub(super) p: Cow<'a, Prepared<DIM, D>>,
    pub(super) travel: &'a Travel,
    plan: &'a RecordPlan,
    pub(super) state: LineState<D>,
    pub(super) riders: Vec<RiderState>,
    pub(super) start_u: Vec<Vec<f64>>,
    pub(super) unilateral: Unilateral,
    datum: f64,
    at_end: Vec<Place<DIM>>,
    at_start: Vec<Place<DIM>>,
    pub(super) at_balance: Vec<Place<DIM>>,
    points: Vec<Place<DIM>>,
    pub(super) gaps: Vec<f64>,
    friction: Vec<f64>,
    loads: Loads<'a>,
    record: Record,
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
        check(
            riders,
            travel,
            plan,
            self.updating.is_some(),
            self.lanes.len(),
        )?;
        loads::check::<D>(&travel.loads, self.line.nodes(), travel.positions.len())?;
        let mut run = Run::start(self, riders, travel, plan)?;
        let mut ledger = plan
            .ledger
            .then(|| Ledger::new(self, &run.state, &run.riders, &run.at_end, run.datum));
        for step in 0..travel.positions.len() - 1 {
            if step % OBSERVE_EVERY == 0 {
                if !observe(step) {
                    return Err(CoreError::Cancelled { step });
                }
                run.check_finite(step)?;
            }
            run.control(step, ask)?;
            run.step(step, ledger.as_mut())?;
        }
        run.record.law_ranges = run.riders.iter().flat_map(RiderState::law_ranges).collect();
        Ok(run.record)
    }
}

fn check(
    riders: &[Rider],
    travel: &Travel,
    plan: &RecordPlan,
    updates: bool,
    lanes: usize,
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
    if lanes > 1 {
        return refuse("lanes", "riders run along one lane");
    }
    if plan.contact_every == 0 || plan.line_every == 0 {
        return refuse("plan", "a recording interval of zero steps");
    }
    Ok(())
}

/// Places at coordinates along the track, m.
fn locate_all<const DIM: usize>(path: &Path<DIM>, x: &[f64]) -> Result<Vec<Place<DIM>>, CoreError> {
    let locate = |(contact, &position): (usize, &f64)| {
        let place = path.locate(position, 0);
        place.ok_or(CoreError::OffWire {
            contact,
            position,
            step: 0,
        })
    };
    x.iter().enumerate().map(locate).collect()
}

impl<'a, const DIM: usize, const D: usize> Run<'a, DIM, D> {
    /// Static equilibrium with the riders in place.
    fn start(
        p: &'a Prepared<DIM, D>,
        riders: &[Rider],
        travel: &'a Travel,
        plan: &'a RecordPlan,
    ) -> Result<Self, CoreError> {
        let start = |distance: &f64| travel.positions[0] - distance;
        let contacts: Vec<f64> = travel.distances.iter().map(start).collect();
        let forces: Vec<f64> = riders.iter().map(|r| r.start_force).collect();
        let points = locate_all(&p.lanes[0], &plan.points)?;
        let (p, still) = match &p.updating {
            None => {
                let places = locate_all(&p.lanes[0], &contacts)?;
                let still = Still::new(&p.line)?.solve(&places, &forces)?;
                (Cow::Borrowed(p), still)
            }
            Some(now) => {
                let still = p.settle(now, &contacts, &forces)?;
                let mut own = p.clone();
                follow(&mut own.lanes, &still.u);
                (Cow::Owned(own), still)
            }
        };
        let places = locate_all(&p.lanes[0], &contacts)?;
        let datum = places[0].height;
        let states = riders
            .iter()
            .zip(&places)
            .enumerate()
            .map(|(j, (rider, place))| {
                let wire = place.height + place.displacement(&still.u, DIM - 1);
                let z = wire - datum + rider.start_force * p.contact_flexibility;
                let state = RiderState::new(rider.clone(), &p.coefficients, z, travel.speeds[0]);
                state.map_err(|error| error.of_rider(j))
            });
        let states = states.collect::<Result<Vec<_>, _>>()?;
        let links = p.line.links.len();
        Ok(Self {
            start_u: states.iter().map(|r| r.u.clone()).collect(),
            riders: states,
            unilateral: Unilateral::new(forces, still.correction),
            state: p.at_rest(still.u),
            gaps: vec![0.0; riders.len()],
            friction: vec![0.0; riders.len()],
            loads: Loads::new(&travel.loads),
            at_start: places.clone(),
            at_balance: places.clone(),
            at_end: places,
            record: Record {
                link_min: vec![f64::INFINITY; links],
                link_max: vec![f64::NEG_INFINITY; links],
                uplift_max: vec![f64::NEG_INFINITY; plan.nodes.len()],
                stop_max: vec![0.0; riders.len()],
                ..Record::default()
            },
            datum,
            points,
            p,
            travel,
            plan,
        })
    }

    /// One step, readable from top to bottom.
    fn step(&mut self, step: usize, ledger: Option<&mut Ledger<D>>) -> Result<(), CoreError> {
        if self.p.updating.is_some() {
            self.p.to_mut().reform(&mut self.state, step)?;
        }
        let old = self.p.coefficients.old;
        let between = |a: &[f64]| (1.0 - old) * a[step + 1] + old * a[step];
        let speed = between(&self.travel.speeds);
        self.move_contacts(step, between(&self.travel.positions))?;

        // Friction of the force of the step before, T = f n (Amontons–Coulomb), drags the wire along.
        for (t, n) in self.friction.iter_mut().zip(&self.unilateral.force) {
            *t = self.travel.friction * n;
        }
        // Motion without contact forces.
        self.loads.begin(step, old);
        let (p, places, friction) = (&*self.p, &self.at_balance, &self.friction);
        let loads = &self.loads;
        p.free_increment(&mut self.state, |f| {
            loads.add_to(f);
            for (place, &t) in places.iter().zip(friction).filter(|(_, t)| **t != 0.0) {
                place.add_force(t, 0, f);
            }
            if p.updating.is_none() {
                p.line.add_rest_corrections(f);
            }
        });
        for rider in &mut self.riders {
            rider.begin(&p.coefficients, step);
            rider.free_increment(&p.coefficients, speed);
        }
        self.measure_gaps();

        // Contacts and slack links together.
        let stats = self.close(step)?;
        self.count(&stats);
        self.watch(step, speed, between(&self.travel.positions));
        self.take(ledger, step, speed);
        Ok(())
    }

    /// Places of all contacts at the end of the step and at the time of balance.
    fn move_contacts(&mut self, step: usize, balance: f64) -> Result<(), CoreError> {
        std::mem::swap(&mut self.at_start, &mut self.at_end);
        for (j, distance) in self.travel.distances.iter().enumerate() {
            let near = self.at_start[j].element;
            let locate = |position: f64| {
                let place = self.p.lanes[0].locate(position, near);
                place.ok_or(CoreError::OffWire {
                    contact: j,
                    position,
                    step,
                })
            };
            self.at_end[j] = locate(self.travel.positions[step + 1] - distance)?;
            self.at_balance[j] = locate(balance - distance)?;
        }
        Ok(())
    }

    /// Height of the wire above the datum at the time of balance, with the current increment.
    fn wire_height(&self, j: usize) -> f64 {
        let (p, place) = (&*self.p, &self.at_balance[j]);
        place.height
            + place.displacement(&self.state.u, DIM - 1)
            + p.coefficients.stiffness * place.displacement(&self.state.delta, DIM - 1)
    }

    /// Lateral position of the wire at the time of balance; zero when planar.
    fn wire_lateral(&self, j: usize) -> f64 {
        let (p, place) = (&*self.p, &self.at_balance[j]);
        if DIM < 3 {
            return 0.0;
        }
        place.lateral
            + place.displacement(&self.state.u, 1)
            + p.coefficients.stiffness * place.displacement(&self.state.delta, 1)
    }

    /// Gaps that the motion without contact forces would open (or, negative, close).
    fn measure_gaps(&mut self) {
        let keep = self.p.coefficients.stiffness;
        for j in 0..self.gaps.len() {
            let rider = &self.riders[j];
            let strip = self.datum + rider.strip(&rider.u) + keep * rider.strip(&rider.delta);
            self.gaps[j] = self.wire_height(j) - strip;
        }
    }

    fn count(&mut self, stats: &LcpStats) {
        let r = &mut self.record;
        r.pivots += stats.pivots;
        r.pivots_max = r.pivots_max.max(stats.pivots);
        if r.pivot_counts.len() <= stats.pivots {
            r.pivot_counts.resize(stats.pivots + 1, 0);
        }
        r.pivot_counts[stats.pivots] += 1;
        r.fallbacks += usize::from(stats.fallback_used);
        r.lcp_residual = r.lcp_residual.max(stats.residual);
        let slack = self.unilateral.links.iter();
        let slack = slack
            .filter(|&&i| self.unilateral.correction[i] > 0.0)
            .count();
        r.slack_max = r.slack_max.max(slack);
    }

    /// Tension of a link at the time of balance.
    #[inline(always)]
    fn tension(&self, i: usize) -> f64 {
        if self.unilateral.correction[i] > 0.0 {
            return 0.0;
        }
        self.state.links.tension[i]
    }

    /// Uplift of a node at the time of balance.
    fn node_uplift(&self, node: usize) -> f64 {
        let keep = self.p.coefficients.stiffness;
        self.state.u[node][DIM - 1] + keep * self.state.delta[node][DIM - 1]
    }

    /// Record the instant of balance and update the extremes.
    fn watch(&mut self, step: usize, speed: f64, position: f64) {
        let time = (step as f64 + 1.0 - self.p.coefficients.old) * self.p.h;
        for i in 0..self.p.line.links.len() {
            let tension = self.tension(i);
            self.record.link_min[i] = self.record.link_min[i].min(tension);
            self.record.link_max[i] = self.record.link_max[i].max(tension);
        }
        for (k, &node) in self.plan.nodes.iter().enumerate() {
            self.record.uplift_max[k] = self.record.uplift_max[k].max(self.node_uplift(node));
        }
        for (largest, rider) in self.record.stop_max.iter_mut().zip(&self.riders) {
            *largest = largest.max(rider.stop_force());
        }
        for rider in &mut self.riders {
            rider.watch_laws(&self.p.coefficients);
        }
        if step.is_multiple_of(self.plan.contact_every) {
            self.record_contacts(time, speed, position);
        }
        if step.is_multiple_of(self.plan.line_every) {
            self.record_line(time);
        }
    }

    fn record_contacts(&mut self, time: f64, speed: f64, position: f64) {
        let keep = self.p.coefficients.stiffness;
        self.record.time.push(time);
        self.record.speed.push(speed);
        for j in 0..self.riders.len() {
            let height = self.wire_height(j);
            let lateral = self.wire_lateral(j);
            let r = &mut self.record;
            r.force.push(self.unilateral.force[j]);
            r.gap.push(self.unilateral.gap[j]);
            r.height.push(height);
            r.lateral.push(lateral);
            r.position.push(position - self.travel.distances[j]);
            let rider = &self.riders[j];
            r.control.push(rider.actuator.force);
            for ((u, d), start) in rider.u.iter().zip(&rider.delta).zip(&self.start_u[j]) {
                r.masses.push(u + keep * d - start);
            }
        }
    }

    fn record_line(&mut self, time: f64) {
        self.record.line_time.push(time);
        if self.plan.links {
            for i in 0..self.p.line.links.len() {
                let tension = self.tension(i);
                self.record.link_force.push(tension);
            }
        }
        for &node in &self.plan.nodes {
            let uplift = self.node_uplift(node);
            self.record.uplift.push(uplift);
        }
        let keep = self.p.coefficients.stiffness;
        for place in &self.points {
            let moved = |c: usize| {
                place.displacement(&self.state.u, c)
                    + keep * place.displacement(&self.state.delta, c)
            };
            self.record.point_uplift.push(moved(DIM - 1));
            self.record.point_along.push(moved(0));
        }
        let slack = self
            .unilateral
            .correction
            .iter()
            .filter(|r| **r > 0.0)
            .count();
        self.record.slack.push(slack as f64);
    }

    /// Take the step, booking its energies when a ledger is kept.
    fn take(&mut self, ledger: Option<&mut Ledger<D>>, step: usize, speed: f64) {
        let p = &*self.p;
        self.record.steps = step + 1;
        let Some(ledger) = ledger else {
            p.advance(&mut self.state);
            self.riders
                .iter_mut()
                .for_each(|r| r.advance(&p.coefficients));
            return;
        };
        ledger.before(p, &self.state, &self.riders, speed);
        p.advance(&mut self.state);
        self.riders
            .iter_mut()
            .for_each(|r| r.advance(&p.coefficients));
        let forces = StepForces {
            places: &self.at_balance,
            ends: [&self.at_start, &self.at_end],
            unilateral: &self.unilateral,
            friction: &self.friction,
            loads: &self.loads,
            datum: self.datum,
        };
        ledger.after(p, &self.state, &self.riders, &forces);
        if !step.is_multiple_of(self.plan.line_every) && step + 2 != self.travel.positions.len() {
            return;
        }
        ledger.settle(p, &self.state);
        let e = &ledger.entries;
        self.record.energy_residual = self.record.energy_residual.max(e.residual().abs());
        self.record.energy_turnover = self.record.energy_turnover.max(e.turnover());
        if step.is_multiple_of(self.plan.line_every) {
            self.record.energy.push(*e);
        }
    }

    fn check_finite(&self, step: usize) -> Result<(), CoreError> {
        let finite = self.state.u.iter().flatten().all(|v| v.is_finite());
        if finite && self.unilateral.force.iter().all(|v| v.is_finite()) {
            return Ok(());
        }
        Err(CoreError::NotFinite {
            what: "the displacement of the line",
            step,
        })
    }
}
