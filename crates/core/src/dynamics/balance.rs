//! Energy ledger of explicit steps: the [`ledger`](super::ledger) of their own discrete energy.
//!
//! Energies belong to half a step after the last one, z = u + ½ h v, and every balance is multiplied by
//! Δz = h vₙ₊₁: see [`explicit::energy`](super::explicit::energy) for the line. Riders step by Newmark's β = ¼,
//! γ = ½, which is the same scheme with all of K implicit: ½ (d/h)ᵀM(d/h) + ½ zᵀK z, d = h v + ½ h² a.
//!
//! A contact with overlap p and compliance C = 1/k_c + R̃ stores ½ max(p, 0)²/C. It moves on with the line at z, then the line
//! moves with the contact in its new place x:
//!
//!   traction  = E_c(z⁻, x) − E_c(z⁻, x⁻)
//!   switching = λ Δp − (E_c(z⁺, x) − E_c(z⁻, x))
//!
//! λ = p(uₙ₊₁)/C and u = ½ (z⁻ + z⁺) make the switching zero unless the contact opens or closes within the step. A
//! rigid one stores nothing: traction = λ (p(z⁻, x) − p(z⁻, x⁻)). Places are those found for the end of a step,
//! not those where the step has put its forces. Stops, kinks and moving grounds of riders likewise; links as in the ledger.
//!
//! **Measured steps.** What wires dissipate is a sum over all points of every step, which costs half as much as the
//! step. So it may be measured in some steps only. In these everything is known: the balance must close by
//! itself, and its residual, times the number of steps it stands for, counts. Between them `dissipated_line` is what the balance
//! leaves, which must not be negative.

use super::contact::Unilateral;
use super::contacts::Contacts;
use super::entries::Entries;
use super::explicit::energy::{Forms, Lost, Stored};
use super::explicit::{Explicit, Grid};
use super::ledger::StepForces;
use super::line::LinearLink;
use super::rider::{RiderState, inner};
use super::rider_halves::Halves;
use super::stepper::{LineState, Prepared};

/// A contact at the end of the last step.
#[derive(Debug, Clone, Copy, Default)]
struct Pressed {
    meets: bool,
    overlap: f64,
    energy: f64,
}

/// A damper to ground: node, component, N·s/m, and h v of the node, m.
#[derive(Debug, Clone, Copy)]
struct Damper {
    node: usize,
    component: usize,
    viscosity: f64,
    rate: f64,
}

/// Running ledger of explicit steps, and its work space.
#[derive(Debug)]
pub struct Balance<const DIM: usize, const D: usize> {
    /// Entries so far.
    pub entries: Entries,
    /// Every how many steps the dissipation of wires is measured.
    every: usize,
    forms: Forms,
    /// z⁻ and Δz of the nodes that something acts on.
    z: Vec<[f64; D]>,
    moved: Vec<[f64; D]>,
    riders: Vec<Halves>,
    pressed: Vec<Pressed>,
    dampers: Vec<Damper>,
    /// Stored at the start by line, contacts and riders.
    start: [f64; 4],
    slack: f64,
    /// Work of all that is not a wire, a linear link, spring or strut on the line so far, and what links and springs have
    /// dissipated of it.
    work: f64,
    spent: f64,
    /// Line, work and spent when they were settled last.
    settled: [f64; 3],
    /// What the islands had that were laid to rest.
    left: f64,
    /// What links and springs dissipate in the present step.
    of_step: f64,
    /// What did not add up of the line where it was settled.
    off: f64,
    /// Largest amount of energy the line had.
    largest: f64,
    /// Least that the wires have dissipated between measured steps.
    least: f64,
    /// Switching of contacts and links, without stops and tables of riders.
    switched: f64,
}

fn overlap_energy(overlap: f64, compliance: f64) -> f64 {
    if compliance > 0.0 {
        0.5 * overlap.max(0.0).powi(2) / compliance
    } else {
        0.0
    }
}

impl<const DIM: usize, const D: usize> Balance<DIM, D> {
    /// Open the ledger at the starting state.
    pub(super) fn new(
        p: &Prepared<DIM, D>,
        (steps, grid): (&Explicit<DIM>, &Grid),
        state: &LineState<D>,
        riders: &[RiderState],
        contacts: &Contacts<DIM>,
        (datum, every): (f64, usize),
    ) -> Self {
        let halves = riders.iter().map(|rider| Halves::new(rider, p.h));
        let mut new = Self {
            entries: Entries::default(),
            every: every.max(1),
            forms: Forms::new(steps),
            z: state.u.clone(),
            moved: vec![[0.0; D]; state.u.len()],
            riders: halves.collect(),
            dampers: dampers(p),
            pressed: vec![Pressed::default(); contacts.all.len()],
            start: [0.0; 4],
            slack: 0.0,
            work: 0.0,
            spent: 0.0,
            settled: [0.0; 3],
            left: 0.0,
            of_step: 0.0,
            off: 0.0,
            largest: 0.0,
            least: 0.0,
            switched: 0.0,
        };
        new.slack = new.slack_at_rest(p, state);
        for &i in &contacts.active {
            new.pressed[i] = new.press(p, contacts, i, (riders, datum));
        }
        let pressed = new.pressed.iter().map(|c| c.energy).sum::<f64>();
        let [stored, laws, stops] = sums(&new.riders);
        let line = new.stored(steps, state, grid);
        new.start = [line.elastic + new.slack, pressed + stops, stored, laws];
        new.settled[0] = line.all();
        new.largest = line.all().abs();
        new
    }

    /// Of links that are slack in a state at rest: −r₀ e, and what they do not store, −½ min(T, 0)²/k.
    fn slack_at_rest(&self, p: &Prepared<DIM, D>, state: &LineState<D>) -> f64 {
        let slack = p.line.links.iter().filter(|link| link.unilateral);
        let of = |link: &LinearLink<DIM>| {
            let elongation = link.elongation(&state.u);
            let tension = link.rest_tension + link.stiffness * elongation;
            -link.rest_correction() * elongation - 0.5 * tension.min(0.0).powi(2) / link.stiffness
        };
        slack.map(of).sum()
    }

    /// A contact at the start, where z is u.
    fn press(
        &self,
        p: &Prepared<DIM, D>,
        contacts: &Contacts<DIM>,
        i: usize,
        (riders, datum): (&[RiderState], f64),
    ) -> Pressed {
        let contact = &contacts.all[i];
        let (end, lane) = (&contact.ends[1], &p.lanes[contact.of[2]]);
        let yields = lane.yield_at(end);
        let compliance = p.contact_flexibility + yields.own - p.carried(&yields, &yields);
        let wire = end.height + yields.rise + p.felt(end, &yields, &self.z);
        let overlap = datum + inner(&contact.vector, &riders[contact.rider()].u) - wire;
        Pressed {
            meets: true,
            overlap,
            energy: overlap_energy(overlap, compliance),
        }
    }

    /// Whether wires are measured in a step.
    fn measures(&self, step: usize) -> bool {
        step.is_multiple_of(self.every)
    }

    /// Everything that needs the state before the step is taken, when its forces are known.
    pub(super) fn before(
        &mut self,
        p: &Prepared<DIM, D>,
        state: &LineState<D>,
        riders: &[RiderState],
        (step, speed): (usize, f64),
        f: &StepForces<'_, DIM>,
    ) {
        let (Some(steps), Some(grid)) = (p.explicit_steps(), &state.grid) else {
            return;
        };
        // Before anything of this step is booked.
        if self.measures(step) && self.every > 1 {
            let line = self.stored(steps, state, grid).all();
            self.close(line);
        }
        for (halves, rider) in self.riders.iter_mut().zip(riders) {
            halves.find(rider, &p.coefficients, p.h);
        }
        self.of_step = 0.0;
        let before = self.entries.switching;
        self.book_contacts(p, (steps, grid), f);
        self.book_links(p, (steps, grid), f.unilateral);
        self.switched += self.entries.switching - before;
        self.book_dampers(p.h, (steps, grid), state);
        if !f.loads.is_empty() {
            for node in f.loads.nodes() {
                self.look(steps, grid, node);
            }
            let work = f.loads.work(&self.moved);
            self.entries.work_loads += work;
            self.work += work;
        }
        for (halves, rider) in self.riders.iter().zip(riders) {
            halves.book(rider, (p.h, speed), &mut self.entries);
        }
        if !self.measures(step) {
            return;
        }
        for &island in &state.awake {
            self.forms.remember(island, grid);
        }
    }

    /// Find z⁻ and Δz of a node.
    fn look(&mut self, steps: &Explicit<DIM>, grid: &Grid, node: usize) {
        for (c, [z, by]) in steps.halves(grid, node).into_iter().enumerate() {
            (self.z[node][c], self.moved[node][c]) = (z, by);
        }
    }

    fn book_contacts(
        &mut self,
        p: &Prepared<DIM, D>,
        (steps, grid): (&Explicit<DIM>, &Grid),
        f: &StepForces<'_, DIM>,
    ) {
        let forces = &f.unilateral.force;
        for (i, contact) in f.contacts.all.iter().enumerate() {
            let before = self.pressed[i];
            self.pressed[i] = Pressed::default();
            if !contact.meets {
                self.entries.switching += before.energy;
                self.switched -= before.energy;
                continue;
            }
            let (end, lane) = (&contact.ends[1], &p.lanes[contact.of[2]]);
            // That of the same place has been found.
            let is_same =
                end.element == contact.place.element && end.weights == contact.place.weights;
            let yields = if is_same {
                contact.yields
            } else {
                lane.yield_at(end)
            };
            for node in &end.nodes[..end.count] {
                self.look(steps, grid, *node);
            }
            for (link, _) in yields.pulls() {
                let nodes = p.line.links[link].nodes;
                nodes.iter().for_each(|&node| self.look(steps, grid, node));
            }
            let compliance = p.contact_flexibility + yields.own - p.carried(&yields, &yields);
            let rider = &self.riders[contact.rider()];
            let corrected = |(link, rise): (usize, f64)| {
                rise * (f.unilateral.correction[link] - p.line.links[link].rest_correction())
            };
            let others = f.contacts.active.iter().filter(|&&j| j != i);
            let pressed = others.map(|&j| p.residual(contact, &f.contacts.all[j]) * forces[j]);
            let raised =
                yields.rise + yields.pulls().map(corrected).sum::<f64>() + pressed.sum::<f64>();
            let wire = end.height + raised + p.felt(end, &yields, &self.z);
            let now = f.datum + inner(&contact.vector, &rider.z) - wire;
            let (lifted, risen) = (
                inner(&contact.vector, &rider.moved),
                p.felt(end, &yields, &self.moved),
            );
            let after = now + lifted - risen;
            let [energy, ended] = [now, after].map(|o| overlap_energy(o, compliance));
            let force = forces[i];
            let traction = match before.meets {
                true if compliance > 0.0 => energy - before.energy,
                true => force * (now - before.overlap),
                false => 0.0,
            };
            if !before.meets {
                // What a contact brings or takes at the end of a wire is no matter of steps.
                self.switched += energy;
            }
            self.entries.work_traction += traction;
            self.entries.switching += traction - (ended - before.energy) + force * (lifted - risen);
            self.work += force * risen;
            if f.friction[i] != 0.0 {
                let work = f.friction[i] * end.displacement(&self.moved, 0);
                self.entries.work_friction += work;
                self.work += work;
            }
            self.pressed[i] = Pressed {
                meets: true,
                overlap: after,
                energy: ended,
            };
        }
    }

    /// What slack links do not store, and the work of their corrections.
    fn book_links(
        &mut self,
        p: &Prepared<DIM, D>,
        (steps, grid): (&Explicit<DIM>, &Grid),
        unilateral: &Unilateral,
    ) {
        let (links, corrections) = (&p.line.links, &unilateral.correction);
        let slack = unilateral.links.iter().filter(|&&l| corrections[l] > 0.0);
        let at_rest = p.table.corrected.iter().map(|(link, _)| link);
        let mut energy = 0.0;
        for (&l, is_rest) in slack.map(|l| (l, false)).chain(at_rest.map(|l| (l, true))) {
            let (link, r0) = (&links[l], links[l].rest_correction());
            link.nodes
                .iter()
                .for_each(|&node| self.look(steps, grid, node));
            let moved = link.elongation(&self.moved);
            let ended = link.elongation(&self.z) + moved;
            if is_rest {
                // r₀ pushes always, and what it does is stored.
                energy -= r0 * ended;
                self.entries.switching -= r0 * moved;
                self.work += r0 * moved;
                continue;
            }
            let tension = link.rest_tension + link.stiffness * ended;
            energy -= 0.5 * tension.min(0.0).powi(2) / link.stiffness;
            self.entries.switching += corrections[l] * moved;
            self.work -= corrections[l] * moved;
        }
        self.entries.switching -= energy - self.slack;
        self.slack = energy;
    }

    /// Dampers to ground. Across the wire nodes step by the trapezoidal rule, so h v follows from their increments.
    fn book_dampers(
        &mut self,
        h: f64,
        (steps, grid): (&Explicit<DIM>, &Grid),
        state: &LineState<D>,
    ) {
        for damper in &mut self.dampers {
            let by = state.delta[damper.node][damper.component];
            let (seen, moved) = if damper.component == 0 {
                (by, steps.halves(grid, damper.node)[0][1])
            } else {
                damper.rate = 2.0 * by - damper.rate;
                (damper.rate, damper.rate)
            };
            let lost = damper.viscosity / h * seen * moved;
            self.entries.dissipated_springs += lost;
            self.of_step += lost;
        }
    }

    /// Book the step after it was taken. Tells whether energies are those of the end of the step.
    pub(super) fn after(
        &mut self,
        p: &Prepared<DIM, D>,
        state: &LineState<D>,
        riders: &[RiderState],
        (step, is_row): (usize, bool),
        unilateral: &Unilateral,
    ) -> bool {
        let (Some(steps), Some(grid)) = (p.explicit_steps(), &state.grid) else {
            return false;
        };
        self.book_linear_links(p, state, unilateral);
        for (halves, rider) in self.riders.iter_mut().zip(riders) {
            halves.end(rider, p.h);
        }
        self.settle_riders();
        self.spent += self.of_step;
        if !self.measures(step) {
            return false;
        }
        let mut lost = Lost::default();
        for &island in &state.awake {
            lost = lost.and(self.forms.lost(steps, island, grid));
        }
        self.entries.dissipated_scheme += lost.scheme;
        self.entries.dissipated_line += lost.damped - self.of_step;
        self.spent += lost.damped - self.of_step + lost.scheme;
        if self.every == 1 && !is_row {
            return false;
        }
        let line = self.stored(steps, state, grid);
        self.entries.kinetic = line.kinetic;
        self.entries.elastic = line.elastic + self.slack - self.start[0];
        self.off += line.all() + self.left - self.settled[0];
        self.off -= self.work - self.settled[1] - (self.spent - self.settled[2]);
        self.settled = [line.all() + self.left, self.work, self.spent];
        self.largest = self.largest.max(line.all().abs());
        true
    }

    /// Dissipation of links as if all were linear; what slack ones have of it is no dissipation.
    fn book_linear_links(
        &mut self,
        p: &Prepared<DIM, D>,
        state: &LineState<D>,
        unilateral: &Unilateral,
    ) {
        let rates = &state.links.rate;
        let mut sum = 0.0;
        for island in p.awake(&state.awake) {
            let which = island.links.clone();
            sum += squares(&p.table.viscosity[which.clone()], &rates[which]);
        }
        let slack = unilateral.links.iter();
        let slack = slack.filter(|&&l| unilateral.correction[l] > 0.0);
        let of = |&l: &usize| p.table.viscosity[l] * rates[l] * rates[l];
        let undone = p.h * slack.map(of).sum::<f64>();
        self.of_step += p.h * sum;
        self.entries.dissipated_links += p.h * sum - undone;
        self.entries.switching += undone;
        self.switched += undone;
    }

    fn settle_riders(&mut self) {
        let e = &mut self.entries;
        let [stored, laws, stops] = sums(&self.riders);
        e.switching -= laws + stops;
        e.riders = stored + laws - self.start[2] - self.start[3];
        let pressed = self.pressed.iter().map(|c| c.energy).sum::<f64>();
        e.contact = pressed + stops - self.start[1];
    }

    /// Energies of the line between two steps.
    fn stored(&mut self, steps: &Explicit<DIM>, state: &LineState<D>, grid: &Grid) -> Stored {
        let mut sum = Stored::default();
        for &island in &state.awake {
            let own = self.forms.stored(steps, island, grid);
            sum.kinetic += own.kinetic;
            sum.elastic += own.elastic;
        }
        sum
    }

    /// What the line has lost since it was settled, but for what is known, was dissipated by the wires.
    fn close(&mut self, line: f64) {
        let work = self.work - self.settled[1] - (self.spent - self.settled[2]);
        let dissipated = work - (line + self.left - self.settled[0]);
        self.entries.dissipated_line += dissipated;
        self.least = self.least.min(dissipated);
        self.settled = [line + self.left, self.work, self.spent];
    }

    /// An island is about to be laid to rest: what it has leaves the ledger with it.
    pub(super) fn leave(
        &mut self,
        p: &Prepared<DIM, D>,
        (steps, grid): (&Explicit<DIM>, &Grid),
        island: usize,
    ) {
        let own = |damper: &&mut Damper| p.island_of(damper.node) == island;
        self.dampers
            .iter_mut()
            .filter(own)
            .for_each(|d| d.rate = 0.0);
        let line = self.forms.stored(steps, island, grid).all();
        self.left += line;
        self.entries.dissipated_scheme += line;
    }

    /// What does not add up: of measured steps as often as each stands for others.
    pub(super) fn residual(&self) -> f64 {
        self.entries.residual() + (self.every - 1) as f64 * self.off
    }

    /// Least that the wires have dissipated between two measured steps, J.
    pub(super) fn least(&self) -> f64 {
        self.least
    }

    /// What contacts and links have taken or given by opening and closing, J.
    pub(super) fn switched(&self) -> f64 {
        self.switched
    }

    /// Largest energy that the line had when it was settled, J.
    pub(super) fn largest(&self) -> f64 {
        self.largest
    }

    /// What follows from a state that was put back.
    pub(super) fn go_on(&mut self, p: &Prepared<DIM, D>, riders: &[RiderState]) {
        for (halves, rider) in self.riders.iter_mut().zip(riders) {
            halves.end(rider, p.h);
        }
    }

    /// All that a later part of a run goes on with.
    pub(super) fn numbers(&mut self) -> impl Iterator<Item = &mut f64> {
        let pressed = self.pressed.iter_mut();
        let pressed = pressed.flat_map(|c| [&mut c.overlap, &mut c.energy]);
        let sums = [
            &mut self.slack,
            &mut self.work,
            &mut self.spent,
            &mut self.left,
            &mut self.off,
            &mut self.largest,
            &mut self.least,
            &mut self.switched,
        ];
        let rates = self.dampers.iter_mut().map(|damper| &mut damper.rate);
        let lists = self.start.iter_mut().chain(&mut self.settled);
        lists.chain(sums).chain(pressed).chain(rates)
    }

    pub(super) fn meets(&mut self) -> impl Iterator<Item = &mut bool> {
        self.pressed.iter_mut().map(|c| &mut c.meets)
    }
}

/// Σ c v², summed side by side: one after the other they would wait for each other.
fn squares(c: &[f64], v: &[f64]) -> f64 {
    const SIDES: usize = 8;
    let (mut sums, (c, c_rest)) = ([0.0; SIDES], c.as_chunks::<SIDES>());
    let (v, v_rest) = v.as_chunks::<SIDES>();
    for (c, v) in c.iter().zip(v) {
        for k in 0..SIDES {
            sums[k] += c[k] * v[k] * v[k];
        }
    }
    let rest = c_rest.iter().zip(v_rest).map(|(c, v)| c * v * v);
    sums.iter().sum::<f64>() + rest.sum::<f64>()
}

/// Dampers of a line at rest; springs alone are left out.
fn dampers<const DIM: usize, const D: usize>(p: &Prepared<DIM, D>) -> Vec<Damper> {
    let all = p.line.dampers.iter().filter(|damper| damper.2 != 0.0);
    let at_rest = all.map(|&(node, component, viscosity)| Damper {
        node,
        component,
        viscosity,
        rate: 0.0,
    });
    at_rest.collect()
}

/// Energies of all riders: kinetic and of springs, what tables add, of stops.
fn sums(riders: &[Halves]) -> [f64; 3] {
    let of = |k: usize| riders.iter().map(|r| r.stored[k]).sum();
    [of(0), of(1), of(2)]
}
