//! Energy balance of explicit steps: the [`balance`](crate::integrator::energy::implicit) of their
//! own discrete energy.
//!
//! Energies belong to half a step after the last one, z = u + ½ h v, and every balance is
//! multiplied by Δz = h vₙ₊₁: see [`explicit::energy`](crate::integrator::explicit::energy) for the
//! line. Pantographs step by Newmark's β = ¼, γ = ½, which is the same scheme with all of K
//! implicit: ½ (d/h)ᵀM(d/h) + ½ zᵀK z, d = h v + ½ h² a.
//!
//! A contact with overlap p and compliance C = 1/k_c + R̃ stores ½ max(p, 0)²/C. It moves to its
//! new point x with the line at z, then the line moves with the contact there:
//!
//!   traction  = E_c(z⁻, x) − E_c(z⁻, x⁻)
//!   switching = λ Δp − (E_c(z⁺, x) − E_c(z⁻, x))
//!
//! λ = p(uₙ₊₁)/C and u = ½ (z⁻ + z⁺) make the switching zero unless the contact opens or closes
//! within the step. A rigid one stores nothing: traction = λ (p(z⁻, x) − p(z⁻, x⁻)). Points are
//! those of the end of a step, not those where the step has applied its forces. Stops, breakpoints
//! and base motions of pantographs likewise; links as in the implicit balance.
//!
//! **Measured steps.** The dissipation of wires is a sum over all points of every step, which costs
//! half as much as the step. So it may be measured in some steps only. In these everything is
//! known: the balance must close by itself, and its residual, times the number of steps it stands
//! for, counts. Between them `dissipated_line` is the remainder of the balance, which must not be
//! negative.

use crate::checkpoint::Archive;
use crate::constraint::contacts::Contacts;
use crate::constraint::problem::ConstraintProblem;
use crate::energy_terms::EnergyTerms;
use crate::error::CoreError;
use crate::integrator::energy::step_forces::StepForces;
use crate::integrator::explicit::energy::{IslandEnergies, StepLosses, StoredEnergy};
use crate::integrator::explicit::{ChainState, Explicit};
use crate::integrator::state::WireState;
use crate::integrator::wire_model::WireModel;
use crate::pantograph::half_steps::HalfStepEnergy;
use crate::pantograph::state::PantographState;

/// Contact at the end of the last step: activity, overlap (m), energy (J).
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct ContactState {
    pub is_active: bool,
    pub overlap: f64,
    pub energy: f64,
}

/// Damper to ground: node, component, N·s/m, and h v of the node, m.
#[derive(Debug, Clone, Copy)]
pub(crate) struct GroundDamper {
    pub node: usize,
    pub component: usize,
    pub viscosity: f64,
    pub rate: f64,
}

/// Energy balance of explicit steps during a run, and its workspace.
#[derive(Debug, Clone)]
pub struct ExplicitBalance<const DIM: usize, const D: usize> {
    /// Terms so far, J.
    pub terms: EnergyTerms,
    /// Number of steps from one measurement of the dissipation of wires to the next.
    pub(crate) every: usize,
    pub(crate) forms: IslandEnergies,
    /// Displacements z⁻ and increments Δz of nodes that forces act on, m.
    pub(crate) z: Vec<[f64; D]>,
    pub(crate) increment: Vec<[f64; D]>,
    pub(crate) pantographs: Vec<HalfStepEnergy>,
    pub(crate) contact_states: Vec<ContactState>,
    pub(crate) ground_dampers: Vec<GroundDamper>,
    /// Energies at the start: line, contacts, pantographs, piecewise forces, J.
    pub(crate) start: [f64; 4],
    pub(crate) slack: f64,
    /// Work so far on the line by all except wires, linear links, springs and struts, and the
    /// energy that links and springs have dissipated, J.
    pub(crate) work: f64,
    pub(crate) dissipated: f64,
    /// Line energy, work and dissipation at the last evaluation of the balance, J.
    pub(crate) last_balance: [f64; 3],
    /// Energy of the islands that were put back to rest, J.
    pub(crate) removed: f64,
    /// Dissipation of links and springs in the current step, J.
    pub(crate) step_dissipation: f64,
    /// Imbalance of the line, summed over evaluations, J.
    pub(crate) imbalance: f64,
    /// Largest energy of the line, J.
    pub(crate) max_line_energy: f64,
    /// Smallest dissipation of wires between measured steps, J.
    pub(crate) min_dissipation: f64,
    /// Switching of contacts and links, without stops and piecewise forces of pantographs, J.
    pub(crate) contact_and_link_switching: f64,
}

impl<const DIM: usize, const D: usize> ExplicitBalance<DIM, D> {
    /// Opens the balance at the initial state.
    pub(crate) fn new(
        wires: &WireModel<DIM, D>,
        (steps, chain): (&Explicit<DIM>, &ChainState),
        state: &WireState<D>,
        pantographs: &[PantographState],
        contacts: &Contacts<DIM>,
        (datum, every): (f64, usize),
    ) -> Self {
        let halves = pantographs
            .iter()
            .map(|pantograph| HalfStepEnergy::new(pantograph, wires.h));
        let mut balance = Self {
            terms: EnergyTerms::default(),
            every: every.max(1),
            forms: IslandEnergies::new(steps),
            z: state.u.clone(),
            increment: vec![[0.0; D]; state.u.len()],
            pantographs: halves.collect(),
            ground_dampers: Self::ground_dampers(wires),
            contact_states: vec![ContactState::default(); contacts.all.len()],
            start: [0.0; 4],
            slack: 0.0,
            work: 0.0,
            dissipated: 0.0,
            last_balance: [0.0; 3],
            removed: 0.0,
            step_dissipation: 0.0,
            imbalance: 0.0,
            max_line_energy: 0.0,
            min_dissipation: 0.0,
            contact_and_link_switching: 0.0,
        };
        balance.slack = balance.slack_energy_at_rest(wires, state);
        for &i in &contacts.active {
            balance.contact_states[i] =
                balance.contact_at_rest(wires, contacts, i, (pantographs, datum));
        }
        let pressed = balance.contact_states.iter().map(|c| c.energy).sum::<f64>();
        let [stored, piecewise_force_energy, stops] = pantograph_energies(&balance.pantographs);
        balance.read_forms(steps, state, chain);
        let line = balance.stored(steps, state);
        balance.start = [
            line.elastic + balance.slack,
            pressed + stops,
            stored,
            piecewise_force_energy,
        ];
        balance.last_balance[0] = line.all();
        balance.max_line_energy = line.all().abs();
        balance
    }

    /// Returns whether the dissipation of wires is measured in a step.
    fn measures(&self, step: usize) -> bool {
        step.is_multiple_of(self.every)
    }

    /// Adds the terms that need the state before the commit of a step, when its forces are known.
    pub(crate) fn before(
        &mut self,
        wires: &WireModel<DIM, D>,
        state: &WireState<D>,
        pantographs: &[PantographState],
        (step, speed): (usize, f64),
        f: &StepForces<'_, DIM>,
    ) {
        let Some((steps, chain)) = wires.explicit_state(state) else {
            return;
        };
        // Read before any term of this step is added.
        if self.measures(step) {
            self.read_forms(steps, state, chain);
        }
        if self.measures(step) && self.every > 1 {
            let line = self.stored(steps, state).all();
            self.assign_dissipation(line);
        }
        for (halves, pantograph) in self.pantographs.iter_mut().zip(pantographs) {
            halves.update_increment(pantograph, &wires.coefficients, wires.h);
        }
        self.step_dissipation = 0.0;
        let before = self.terms.switching;
        self.add_contacts(wires, (steps, chain), f);
        self.add_links(wires, (steps, chain), f.problem);
        self.contact_and_link_switching += self.terms.switching - before;
        self.add_ground_dampers(wires.h, (steps, chain), state);
        if !f.loads.is_empty() {
            for node in f.loads.nodes() {
                self.update_node(steps, chain, node);
            }
            let work = f.loads.work(&self.increment);
            self.terms.work_loads += work;
            self.work += work;
        }
        for (halves, pantograph) in self.pantographs.iter().zip(pantographs) {
            halves.add_work(pantograph, (wires.h, speed), &mut self.terms);
        }
        if !self.measures(step) {
            return;
        }
        for &island in &state.awake {
            self.forms.remember(island);
        }
    }

    /// Reads z⁻ and Δz of a node.
    pub(crate) fn update_node(&mut self, steps: &Explicit<DIM>, chain: &ChainState, node: usize) {
        for (c, [z, increment]) in steps.half_step_motion(chain, node).into_iter().enumerate() {
            (self.z[node][c], self.increment[node][c]) = (z, increment);
        }
    }

    /// Adds the terms of a step after its commit. Returns whether energies are those of the end of
    /// the step.
    pub(crate) fn after(
        &mut self,
        wires: &WireModel<DIM, D>,
        state: &WireState<D>,
        pantographs: &[PantographState],
        (step, is_row): (usize, bool),
        problem: &ConstraintProblem,
    ) -> bool {
        let Some((steps, chain)) = wires.explicit_state(state) else {
            return false;
        };
        self.add_linear_links(wires, state, problem);
        for (halves, pantograph) in self.pantographs.iter_mut().zip(pantographs) {
            halves.update_stored(pantograph, wires.h);
        }
        self.update_pantographs();
        self.dissipated += self.step_dissipation;
        if !self.measures(step) {
            return false;
        }
        self.read_forms(steps, state, chain);
        let mut lost = StepLosses::default();
        for &island in &state.awake {
            lost = lost.plus(self.forms.losses(steps, island));
        }
        self.terms.dissipated_scheme += lost.scheme;
        self.terms.dissipated_line += lost.damped - self.step_dissipation;
        self.dissipated += lost.damped - self.step_dissipation + lost.scheme;
        if self.every == 1 && !is_row {
            return false;
        }
        let line = self.stored(steps, state);
        self.terms.kinetic = line.kinetic;
        self.terms.elastic = line.elastic + self.slack - self.start[0];
        self.imbalance += line.all() + self.removed - self.last_balance[0];
        self.imbalance -=
            self.work - self.last_balance[1] - (self.dissipated - self.last_balance[2]);
        self.last_balance = [line.all() + self.removed, self.work, self.dissipated];
        self.max_line_energy = self.max_line_energy.max(line.all().abs());
        true
    }

    fn update_pantographs(&mut self) {
        let e = &mut self.terms;
        let [stored, piecewise_force_energy, stops] = pantograph_energies(&self.pantographs);
        e.switching -= piecewise_force_energy + stops;
        e.pantographs = stored + piecewise_force_energy - self.start[2] - self.start[3];
        let pressed = self.contact_states.iter().map(|c| c.energy).sum::<f64>();
        e.contact = pressed + stops - self.start[1];
    }

    fn read_forms(&mut self, steps: &Explicit<DIM>, state: &WireState<D>, chain: &ChainState) {
        for &island in &state.awake {
            self.forms.read(steps, island, chain);
        }
    }

    /// Returns the energies of the line between two steps, from its forms.
    fn stored(&mut self, steps: &Explicit<DIM>, state: &WireState<D>) -> StoredEnergy {
        let mut sum = StoredEnergy::default();
        for &island in &state.awake {
            let energy = self.forms.stored(steps, island);
            sum.kinetic += energy.kinetic;
            sum.elastic += energy.elastic;
        }
        sum
    }

    /// Assigns to the wires the loss of the line since the last evaluation that has no other cause.
    fn assign_dissipation(&mut self, line: f64) {
        let work = self.work - self.last_balance[1] - (self.dissipated - self.last_balance[2]);
        let by_wires = work - (line + self.removed - self.last_balance[0]);
        self.terms.dissipated_line += by_wires;
        self.min_dissipation = self.min_dissipation.min(by_wires);
        self.last_balance = [line + self.removed, self.work, self.dissipated];
    }

    /// Removes the energy of an island that is about to be put to rest.
    pub(crate) fn remove_island(
        &mut self,
        wires: &WireModel<DIM, D>,
        (steps, chain): (&Explicit<DIM>, &ChainState),
        island: usize,
    ) {
        let on_island = |damper: &&mut GroundDamper| wires.island_of(damper.node) == island;
        self.ground_dampers
            .iter_mut()
            .filter(on_island)
            .for_each(|d| d.rate = 0.0);
        self.forms.read(steps, island, chain);
        let line = self.forms.stored(steps, island).all();
        self.removed += line;
        self.terms.dissipated_scheme += line;
    }

    /// Returns the residual of the balance, J: that of each measured step times the steps it stands
    /// for.
    pub(crate) fn residual(&self) -> f64 {
        self.terms.residual() + (self.every - 1) as f64 * self.imbalance
    }

    /// Returns the smallest dissipation of wires between two measured steps, J.
    pub(crate) fn min_dissipation(&self) -> f64 {
        self.min_dissipation
    }

    /// Returns the switching of contacts and links, J.
    pub(crate) fn contact_and_link_switching(&self) -> f64 {
        self.contact_and_link_switching
    }

    /// Returns the largest energy of the line at an evaluation, J.
    pub(crate) fn max_line_energy(&self) -> f64 {
        self.max_line_energy
    }

    /// Computes the data that follow from a restored state.
    pub(crate) fn resume(&mut self, wires: &WireModel<DIM, D>, pantographs: &[PantographState]) {
        for (halves, pantograph) in self.pantographs.iter_mut().zip(pantographs) {
            halves.update_stored(pantograph, wires.h);
        }
    }

    /// Returns all values that a saved state contains.
    pub(crate) fn archived_values(&mut self) -> impl Iterator<Item = &mut f64> {
        let pressed = self.contact_states.iter_mut();
        let pressed = pressed.flat_map(|c| [&mut c.overlap, &mut c.energy]);
        let sums = [
            &mut self.slack,
            &mut self.work,
            &mut self.dissipated,
            &mut self.removed,
            &mut self.imbalance,
            &mut self.max_line_energy,
            &mut self.min_dissipation,
            &mut self.contact_and_link_switching,
        ];
        let rates = self
            .ground_dampers
            .iter_mut()
            .map(|damper| &mut damper.rate);
        let lists = self.start.iter_mut().chain(&mut self.last_balance);
        lists.chain(sums).chain(pressed).chain(rates)
    }

    pub(crate) fn contact_flags(&mut self) -> impl Iterator<Item = &mut bool> {
        self.contact_states.iter_mut().map(|c| &mut c.is_active)
    }

    /// Saves or restores the sums so far.
    pub(crate) fn archive(&mut self, archive: &mut Archive<'_>) -> Result<(), CoreError> {
        archive.numbers("energy", self.terms.all_mut().into_iter())?;
        archive.numbers("energy_sums", self.archived_values())?;
        archive.flags("energy_contact_meets", self.contact_flags())
    }
}

/// Returns the energies of all pantographs, J: kinetic and of springs, of piecewise forces, of
/// stops.
fn pantograph_energies(pantographs: &[HalfStepEnergy]) -> [f64; 3] {
    let sum_of = |k: usize| pantographs.iter().map(|r| r.stored[k]).sum();
    [sum_of(0), sum_of(1), sum_of(2)]
}
