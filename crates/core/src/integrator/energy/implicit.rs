//! Energy balance of a run: stored, dissipated and supplied energy, step by step.
//!
//! Multiplying the balance of the scheme by Δu gives, exactly,
//!
//!   Δu·(M a_m) + Δu·(C v_f) + Δu·(K u_f) = Δu·f
//!
//! The first term is ΔE_kin plus what the scheme dissipates in inertia, the third is ΔE_el plus (½
//! − α_f) ΔuᵀK Δu (both extras are zero for the trapezoidal rule), the second is real dissipation.
//! The energy that a unilateral law loses because it opens or closes between two instants
//! (including the impact of a rigid contact) is the `switching` term:
//!
//! * contact: switching = work of the moving contact − ΔE_contact − work done on line and
//!   pantograph, where a contact that appears or goes at the end of a wire brings or takes its
//!   E_contact
//! * stop:     as for a contact; work of its force on a moving base is work of the base
//! * breakpoint: as for a stop, of a spring; of a damper nothing is stored and all is dissipated
//! * link:     switching = −(change of stored energy and of dissipation by going slack) − work of r
//!
//! The residual is stored + dissipated + lost − supplied energy. It is independent of the solver:
//! energies come from products with K and M, the solver never forms the product with K. Stored
//! energies are taken from the state itself whenever the balance is evaluated.

use crate::checkpoint::Archive;
use crate::constraint::contacts::Contacts;
use crate::constraint::problem::ConstraintProblem;
use crate::energy_terms::EnergyTerms;
use crate::error::CoreError;
use crate::integrator::energy::contact_energy::{ContactEnergies, contact_energy};
use crate::integrator::energy::step_forces::StepForces;
use crate::integrator::state::WireState;
use crate::integrator::wire_model::WireModel;
use crate::linalg::{Kernel, widest};
use crate::pantograph::energy::PantographWork;
use crate::pantograph::state::PantographState;

/// Energy balance of implicit steps during a run, and its workspace.
#[derive(Debug, Clone)]
pub struct ImplicitBalance<const D: usize> {
    /// Terms so far, J.
    pub terms: EnergyTerms,
    pub(crate) start: EnergyTerms,
    rate: Vec<[f64; D]>,
    work: Vec<[f64; D]>,
    link_work: Vec<f64>,
    pub(crate) inertia: f64,
    pub(crate) scheme_elastic: f64,
    pub(crate) scheme_pantographs: f64,
    pub(crate) start_linear: f64,
    pub(crate) start_slack: f64,
    pub(crate) slack_energy: f64,
    pantograph_work: Vec<PantographWork>,
    /// Energy of the pantographs since the start without piecewise forces, and that of piecewise
    /// forces, J.
    pub(crate) pantograph_energy: f64,
    pub(crate) piecewise_force_energy: f64,
    pub(crate) start_piecewise_force_energy: f64,
}

fn dot<const D: usize>(x: &[[f64; D]], y: &[[f64; D]]) -> f64 {
    let mut sums = [0.0; D];
    for (a, b) in x.iter().zip(y) {
        for k in 0..D {
            sums[k] += a[k] * b[k];
        }
    }
    sums.iter().sum()
}

/// Sums Δu·(M a_m), Δu·(K Δu), v_f·(M Δu), v_f·(K Δu).
#[derive(Debug, Default)]
struct Sums([f64; 4]);

/// Kernel of the products of one step, in one pass over the matrices.
struct StepWork<'a, const DIM: usize, const D: usize> {
    wires: &'a WireModel<DIM, D>,
    state: &'a WireState<D>,
    /// Velocity v_f of every node, m/s.
    rate: &'a mut [[f64; D]],
    sums: &'a mut Sums,
}

impl<const DIM: usize, const D: usize> Kernel for StepWork<'_, DIM, D> {
    #[inline(always)]
    fn run(self) {
        let Self {
            wires,
            state,
            rate,
            sums,
        } = self;
        let c = wires.coefficients;
        let [mut inertia, mut by_increment, mut by_mass, mut by_stiffness] = [[0.0; D]; 4];
        let rows = state.delta.iter().zip(&state.v).zip(state.acceleration());
        for (i, ((d, v), a)) in rows.enumerate() {
            let mass = wires.line.mass.row(i, &state.delta);
            let [mut velocity, mut force] = [[0.0; D]; 2];
            for k in 0..D {
                velocity[k] =
                    c.damping * d[k] + c.velocity_from_v * v[k] + c.velocity_from_a * a[k];
                force[k] =
                    c.mass * d[k] + c.acceleration_from_v * v[k] + c.acceleration_from_a * a[k];
                inertia[k] += force[k] * mass[k];
                by_mass[k] += velocity[k] * mass[k];
            }
            rate[i] = velocity;
            let k = &wires.line.stiffness;
            k.add_row_of_forms(i, &state.delta, rate, &mut by_increment, &mut by_stiffness);
        }
        sums.0 = [inertia, by_increment, by_mass, by_stiffness]
            .map(|components| components.iter().sum());
    }
}

impl<const D: usize> ImplicitBalance<D> {
    /// Opens the balance at the initial state.
    #[must_use]
    pub fn new<const DIM: usize>(
        wires: &WireModel<DIM, D>,
        state: &WireState<D>,
        pantographs: &[PantographState],
        contacts: &Contacts<DIM>,
        datum: f64,
    ) -> Self {
        let zero = vec![[0.0; D]; state.u.len()];
        let mut balance = Self {
            terms: EnergyTerms::default(),
            start: EnergyTerms::default(),
            rate: zero.clone(),
            work: zero,
            link_work: vec![0.0; wires.line.links.len()],
            inertia: 0.0,
            scheme_elastic: 0.0,
            scheme_pantographs: 0.0,
            start_linear: 0.0,
            start_slack: slack_energy(wires, state),
            slack_energy: slack_energy(wires, state),
            pantograph_work: Vec::with_capacity(pantographs.len()),
            pantograph_energy: 0.0,
            piecewise_force_energy: 0.0,
            start_piecewise_force_energy: pantographs
                .iter()
                .map(PantographState::piecewise_force_energy)
                .sum(),
        };
        balance.start_linear = 0.5 * wires.line.stiffness.quadratic(&state.u);
        balance.start.contact = contact_energy(wires, state, pantographs, contacts, datum);
        balance.start.pantographs = pantographs.iter().map(PantographState::energy).sum();
        balance
    }

    /// Adds the terms that need the state before the step. Call it when the increments are
    /// complete, before `commit`.
    pub fn before<const DIM: usize>(
        &mut self,
        wires: &WireModel<DIM, D>,
        state: &WireState<D>,
        pantographs: &[PantographState],
        speed: f64,
    ) {
        let c = &wires.coefficients;
        self.pantograph_work.clear();
        self.pantograph_work.extend(
            pantographs
                .iter()
                .map(|pantograph| pantograph.work(c, speed)),
        );
        let mut sums = Sums::default();
        widest(StepWork {
            wires,
            state,
            rate: &mut self.rate,
            sums: &mut sums,
        });
        let [inertia, by_increment, by_mass, by_stiffness] = sums.0;
        let common = &wires.line.common;
        self.inertia += inertia;
        self.scheme_elastic += (0.5 - c.old) * by_increment;
        self.terms.dissipated_line += common.alpha * by_mass + common.beta * by_stiffness;
        self.terms.dissipated_line += self.remaining_dissipation(wires, state);
        let links = &state.links;
        for (i, link) in wires.line.links.iter().enumerate() {
            let (d, old) = (links.delta[i], [links.rate[i], links.second[i]]);
            let rate = c.damping * d + c.velocity_from_v * old[0] + c.velocity_from_a * old[1];
            self.link_work[i] = link.viscosity * rate * d;
        }
    }

    /// Returns Δuᵀ (C − αM − βK) v_f, J.
    fn remaining_dissipation<const DIM: usize>(
        &mut self,
        wires: &WireModel<DIM, D>,
        state: &WireState<D>,
    ) -> f64 {
        let mut sum = 0.0;
        if let Some(rest) = &wires.line.mass_damping_rest {
            rest.product(&self.rate, &mut self.work);
            sum += dot(&state.delta, &self.work);
        }
        for (i, j, block) in &wires.line.damping_rest {
            let mut form = |a: usize, b: usize, transposed: bool| {
                for row in 0..D {
                    for column in 0..D {
                        let value = if transposed {
                            block[column][row]
                        } else {
                            block[row][column]
                        };
                        sum += state.delta[a][row] * value * self.rate[b][column];
                    }
                }
            };
            form(*i, *j, false);
            if i != j {
                form(*j, *i, true);
            }
        }
        sum
    }

    /// Adds the terms of a step after `commit`.
    pub fn after<const DIM: usize>(
        &mut self,
        wires: &WireModel<DIM, D>,
        state: &WireState<D>,
        pantographs: &[PantographState],
        f: &StepForces<'_, DIM>,
    ) {
        self.separate_ground_dampers(wires, state);
        self.add_links(wires, state, f.problem);
        self.add_pantographs(pantographs);
        ContactEnergies {
            terms: &mut self.terms,
            scheme: &mut self.scheme_elastic,
            at_start: self.start.contact,
        }
        .add(wires, state, pantographs, f);
        self.terms.work_loads += f.loads.work(&state.delta);
    }

    /// Computes the stored energies of the state itself, ½ vᵀM v and ½ uᵀK u, and the dissipation
    /// of the scheme: the work against inertia that is not stored, and (½ − α_f) ΔuᵀK Δu of every
    /// step.
    pub fn update_stored_energy<const DIM: usize>(
        &mut self,
        wires: &WireModel<DIM, D>,
        state: &WireState<D>,
    ) {
        let e = &mut self.terms;
        e.kinetic = 0.5 * wires.line.mass.quadratic(&state.v);
        let linear = 0.5 * wires.line.stiffness.quadratic(&state.u) - self.start_linear;
        e.elastic = linear + self.slack_energy - self.start_slack;
        e.dissipated_scheme =
            self.scheme_pantographs + self.scheme_elastic + self.inertia - e.kinetic;
    }

    /// Separates the dissipation of dampers to ground from that of the line.
    fn separate_ground_dampers<const DIM: usize>(
        &mut self,
        wires: &WireModel<DIM, D>,
        state: &WireState<D>,
    ) {
        for spring in &wires.line.springs {
            let (node, component) = (spring.node, spring.component);
            let lost = spring.viscosity * self.rate[node][component] * state.delta[node][component];
            self.terms.dissipated_springs += lost;
            self.terms.dissipated_line -= lost;
        }
    }

    /// Separates the dissipation of links from that of the line, and subtracts the energy that
    /// slack links do not store.
    fn add_links<const DIM: usize>(
        &mut self,
        wires: &WireModel<DIM, D>,
        state: &WireState<D>,
        problem: &ConstraintProblem,
    ) {
        let mut switching = 0.0;
        let mut dissipated = 0.0;
        for (i, link) in wires.line.links.iter().enumerate() {
            let d = state.links.delta[i];
            let linear = self.link_work[i];
            let correction = problem.correction[i];
            let is_slack = correction > 0.0;
            self.terms.dissipated_line -= linear;
            if is_slack {
                // K contains the link as linear, so its share in the dissipation of the scheme is
                // not real either.
                let by_scheme = (0.5 - wires.coefficients.old) * link.stiffness * d * d;
                self.scheme_elastic -= by_scheme;
                switching += linear + by_scheme;
            } else {
                dissipated += linear;
            }
            switching += (correction - link.rest_correction()) * d;
        }
        self.terms.dissipated_links += dissipated;
        let slack_energy = slack_energy(wires, state);
        switching -= slack_energy - self.slack_energy;
        self.slack_energy = slack_energy;
        self.terms.switching += switching;
    }

    fn add_pantographs(&mut self, pantographs: &[PantographState]) {
        let energy =
            pantographs.iter().map(PantographState::energy).sum::<f64>() - self.start.pantographs;
        for work in &self.pantograph_work {
            self.terms.work_uplift += work.uplift;
            self.terms.work_control += work.control;
            self.terms.dissipated_pantographs += work.dissipated;
            self.scheme_pantographs += work.stored;
            self.terms.switching -= work.springs;
        }
        self.scheme_pantographs -= energy - self.pantograph_energy;
        self.pantograph_energy = energy;
        let piecewise_force_energy = pantographs
            .iter()
            .map(PantographState::piecewise_force_energy)
            .sum::<f64>()
            - self.start_piecewise_force_energy;
        self.terms.switching -= piecewise_force_energy - self.piecewise_force_energy;
        self.piecewise_force_energy = piecewise_force_energy;
        self.terms.pantographs = energy + piecewise_force_energy;
    }

    /// Saves or restores the sums so far.
    pub(crate) fn archive(&mut self, archive: &mut Archive<'_>) -> Result<(), CoreError> {
        archive.numbers("energy", self.terms.all_mut().into_iter())?;
        let start = [
            &mut self.start.contact,
            &mut self.start.pantographs,
            &mut self.start_linear,
            &mut self.start_slack,
            &mut self.start_piecewise_force_energy,
        ];
        archive.numbers("energy_start", start.into_iter())?;
        let sums = [
            &mut self.inertia,
            &mut self.scheme_elastic,
            &mut self.scheme_pantographs,
            &mut self.slack_energy,
            &mut self.pantograph_energy,
            &mut self.piecewise_force_energy,
        ];
        archive.numbers("energy_sums", sums.into_iter())
    }
}

/// Returns the energy that slack links do not store although K contains it, J. With T = T₀ + k e of
/// the linear link: −½ min(0, T)²/k, and −r₀ e for a link slack at rest, whose K is cancelled by r₀
/// from the start.
fn slack_energy<const DIM: usize, const D: usize>(
    wires: &WireModel<DIM, D>,
    state: &WireState<D>,
) -> f64 {
    let mut energy = 0.0;
    for (link, e) in wires.line.links.iter().zip(&state.links.elongation) {
        let tension = link.rest_tension + link.stiffness * e;
        if link.unilateral {
            energy -= 0.5 * tension.min(0.0).powi(2) / link.stiffness;
            energy -= link.rest_correction() * e;
        }
    }
    energy
}
