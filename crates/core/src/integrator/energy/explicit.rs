//! Energy ledger of explicit steps: the [`ledger`](crate::integrator::energy::implicit) of their own discrete energy.
//!
//! Energies belong to half a step after the last one, z = u + ½ h v, and every balance is multiplied by
//! Δz = h vₙ₊₁: see [`explicit::energy`](crate::integrator::explicit::energy) for the line. Riders step by Newmark's β = ¼,
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

use crate::checkpoint::Archive;
use crate::constraint::contacts::Contacts;
use crate::constraint::problem::ConstraintProblem;
use crate::error::CoreError;
use crate::integrator::WireState;
use crate::integrator::energy::entries::EnergyTerms;
use crate::integrator::energy::explicit_contacts::Pressed;
use crate::integrator::energy::explicit_links::{Damper, dampers};
use crate::integrator::energy::implicit::StepForces;
use crate::integrator::explicit::energy::{Forms, Lost, Stored};
use crate::integrator::explicit::{Explicit, Grid};
use crate::integrator::prepared::WireModel;
use crate::pantograph::half_steps::Halves;
use crate::pantograph::system::PantographState;

/// Running ledger of explicit steps, and its work space.
#[derive(Debug, Clone)]
pub struct ExplicitBalance<const DIM: usize, const D: usize> {
    /// Entries so far.
    pub entries: EnergyTerms,
    /// Every how many steps the dissipation of wires is measured.
    pub(crate) every: usize,
    pub(crate) forms: Forms,
    /// z⁻ and Δz of the nodes that something acts on.
    pub(crate) z: Vec<[f64; D]>,
    pub(crate) moved: Vec<[f64; D]>,
    pub(crate) riders: Vec<Halves>,
    pub(crate) pressed: Vec<Pressed>,
    pub(crate) dampers: Vec<Damper>,
    /// Stored at the start by line, contacts and riders.
    pub(crate) start: [f64; 4],
    pub(crate) slack: f64,
    /// Work of all that is not a wire, a linear link, spring or strut on the line so far, and what links and springs have
    /// dissipated of it.
    pub(crate) work: f64,
    pub(crate) spent: f64,
    /// Line, work and spent when they were settled last.
    pub(crate) settled: [f64; 3],
    /// What the islands had that were laid to rest.
    pub(crate) left: f64,
    /// What links and springs dissipate in the present step.
    pub(crate) of_step: f64,
    /// What did not add up of the line where it was settled.
    pub(crate) off: f64,
    /// Largest amount of energy the line had.
    pub(crate) largest: f64,
    /// Least that the wires have dissipated between measured steps.
    pub(crate) least: f64,
    /// Switching of contacts and links, without stops and tables of riders.
    pub(crate) switched: f64,
}

impl<const DIM: usize, const D: usize> ExplicitBalance<DIM, D> {
    /// Open the ledger at the starting state.
    pub(crate) fn new(
        p: &WireModel<DIM, D>,
        (steps, grid): (&Explicit<DIM>, &Grid),
        state: &WireState<D>,
        riders: &[PantographState],
        contacts: &Contacts<DIM>,
        (datum, every): (f64, usize),
    ) -> Self {
        let halves = riders.iter().map(|rider| Halves::new(rider, p.h));
        let mut new = Self {
            entries: EnergyTerms::default(),
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
        new.read(steps, state, grid);
        let line = new.stored(steps, state);
        new.start = [line.elastic + new.slack, pressed + stops, stored, laws];
        new.settled[0] = line.all();
        new.largest = line.all().abs();
        new
    }

    /// Whether wires are measured in a step.
    fn measures(&self, step: usize) -> bool {
        step.is_multiple_of(self.every)
    }

    /// Everything that needs the state before the step is taken, when its forces are known.
    pub(crate) fn before(
        &mut self,
        p: &WireModel<DIM, D>,
        state: &WireState<D>,
        riders: &[PantographState],
        (step, speed): (usize, f64),
        f: &StepForces<'_, DIM>,
    ) {
        let Some((steps, grid)) = p.explicit_state(state) else {
            return;
        };
        // Before anything of this step is booked.
        if self.measures(step) {
            self.read(steps, state, grid);
        }
        if self.measures(step) && self.every > 1 {
            let line = self.stored(steps, state).all();
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
            self.forms.remember(island);
        }
    }

    /// Find z⁻ and Δz of a node.
    pub(crate) fn look(&mut self, steps: &Explicit<DIM>, grid: &Grid, node: usize) {
        for (c, [z, by]) in steps.halves(grid, node).into_iter().enumerate() {
            (self.z[node][c], self.moved[node][c]) = (z, by);
        }
    }

    /// Book the step after it was taken. Tells whether energies are those of the end of the step.
    pub(crate) fn after(
        &mut self,
        p: &WireModel<DIM, D>,
        state: &WireState<D>,
        riders: &[PantographState],
        (step, is_row): (usize, bool),
        unilateral: &ConstraintProblem,
    ) -> bool {
        let Some((steps, grid)) = p.explicit_state(state) else {
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
        self.read(steps, state, grid);
        let mut lost = Lost::default();
        for &island in &state.awake {
            lost = lost.and(self.forms.lost(steps, island));
        }
        self.entries.dissipated_scheme += lost.scheme;
        self.entries.dissipated_line += lost.damped - self.of_step;
        self.spent += lost.damped - self.of_step + lost.scheme;
        if self.every == 1 && !is_row {
            return false;
        }
        let line = self.stored(steps, state);
        self.entries.kinetic = line.kinetic;
        self.entries.elastic = line.elastic + self.slack - self.start[0];
        self.off += line.all() + self.left - self.settled[0];
        self.off -= self.work - self.settled[1] - (self.spent - self.settled[2]);
        self.settled = [line.all() + self.left, self.work, self.spent];
        self.largest = self.largest.max(line.all().abs());
        true
    }

    fn settle_riders(&mut self) {
        let e = &mut self.entries;
        let [stored, laws, stops] = sums(&self.riders);
        e.switching -= laws + stops;
        e.riders = stored + laws - self.start[2] - self.start[3];
        let pressed = self.pressed.iter().map(|c| c.energy).sum::<f64>();
        e.contact = pressed + stops - self.start[1];
    }

    fn read(&mut self, steps: &Explicit<DIM>, state: &WireState<D>, grid: &Grid) {
        for &island in &state.awake {
            self.forms.read(steps, island, grid);
        }
    }

    /// Energies of the line between two steps, as it was read.
    fn stored(&mut self, steps: &Explicit<DIM>, state: &WireState<D>) -> Stored {
        let mut sum = Stored::default();
        for &island in &state.awake {
            let own = self.forms.stored(steps, island);
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
    pub(crate) fn leave(
        &mut self,
        p: &WireModel<DIM, D>,
        (steps, grid): (&Explicit<DIM>, &Grid),
        island: usize,
    ) {
        let own = |damper: &&mut Damper| p.island_of(damper.node) == island;
        self.dampers
            .iter_mut()
            .filter(own)
            .for_each(|d| d.rate = 0.0);
        self.forms.read(steps, island, grid);
        let line = self.forms.stored(steps, island).all();
        self.left += line;
        self.entries.dissipated_scheme += line;
    }

    /// What does not add up: of measured steps as often as each stands for others.
    pub(crate) fn residual(&self) -> f64 {
        self.entries.residual() + (self.every - 1) as f64 * self.off
    }

    /// Least that the wires have dissipated between two measured steps, J.
    pub(crate) fn least(&self) -> f64 {
        self.least
    }

    /// What contacts and links have taken or given by opening and closing, J.
    pub(crate) fn switched(&self) -> f64 {
        self.switched
    }

    /// Largest energy that the line had when it was settled, J.
    pub(crate) fn largest(&self) -> f64 {
        self.largest
    }

    /// What follows from a state that was put back.
    pub(crate) fn go_on(&mut self, p: &WireModel<DIM, D>, riders: &[PantographState]) {
        for (halves, rider) in self.riders.iter_mut().zip(riders) {
            halves.end(rider, p.h);
        }
    }

    /// All that a later part of a run goes on with.
    pub(crate) fn numbers(&mut self) -> impl Iterator<Item = &mut f64> {
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

    pub(crate) fn meets(&mut self) -> impl Iterator<Item = &mut bool> {
        self.pressed.iter_mut().map(|c| &mut c.meets)
    }

    /// Save or put back the sums so far.
    pub(crate) fn walk(&mut self, walk: &mut Archive<'_>) -> Result<(), CoreError> {
        walk.numbers("energy", self.entries.all_mut().into_iter())?;
        walk.numbers("energy_sums", self.numbers())?;
        walk.flags("energy_contact_meets", self.meets())
    }
}

/// Energies of all riders: kinetic and of springs, what tables add, of stops.
fn sums(riders: &[Halves]) -> [f64; 3] {
    let of = |k: usize| riders.iter().map(|r| r.stored[k]).sum();
    [of(0), of(1), of(2)]
}
