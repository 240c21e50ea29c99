//! Energy ledger of a run: what is stored, dissipated and supplied, step by step.
//!
//! Multiplying the balance of the scheme by Δu gives, exactly,
//!
//!   Δu·(M a_m) + Δu·(C v_f) + Δu·(K u_f) = Δu·f
//!
//! The first term is ΔE_kin plus what the scheme dissipates in inertia, the third is ΔE_el plus
//! (½ − α_f) ΔuᵀK Δu (both extras are zero for the trapezoidal rule), the second is real
//! dissipation. What a unilateral law loses because it opens or closes between two instants
//! (including the impact of a rigid contact) is the `switching` entry:
//!
//! * contact:  switching = work of the moving contact − ΔE_contact − work done on line and rider,
//!   where a contact that appears or goes at the end of a wire brings or takes its E_contact
//! * stop:     as for a contact; what a moving ground takes of its force is work of the ground
//! * kink:     as for a stop, of a spring; of a damper nothing is stored and all is dissipated
//! * link:     switching = −(change of stored energy and of dissipation by going slack) − work of r
//!
//! The residual is what does not add up. It is independent of the solver: energies come from
//! products with K and M, the solver never forms the product with K. Stored energies are taken
//! from the state itself whenever the ledger is settled.

use crate::checkpoint::Archive;
use crate::constraint::contacts::Contacts;
use crate::constraint::problem::ConstraintProblem;
use crate::error::CoreError;
use crate::integrator::WireState;
use crate::integrator::energy::contact_energy::contact_energy;
pub use crate::integrator::energy::entries::EnergyTerms;
use crate::integrator::prepared::WireModel;
use crate::linalg::{Kernel, widest};
use crate::linear::loads::Loads;
use crate::pantograph::energy::RiderWork;
use crate::pantograph::system::PantographState;

/// Running ledger and its work space.
#[derive(Debug, Clone)]
pub struct ImplicitBalance<const D: usize> {
    /// Entries so far.
    pub entries: EnergyTerms,
    pub(crate) start: EnergyTerms,
    rate: Vec<[f64; D]>,
    work: Vec<[f64; D]>,
    link_work: Vec<f64>,
    pub(crate) inertia: f64,
    pub(crate) scheme_elastic: f64,
    pub(crate) scheme_riders: f64,
    pub(crate) start_linear: f64,
    pub(crate) start_slack: f64,
    pub(crate) slack_energy: f64,
    rider_work: Vec<RiderWork>,
    /// Energy of the riders since the start but for what tables add, and that.
    pub(crate) rider_energy: f64,
    pub(crate) law_energy: f64,
    pub(crate) start_laws: f64,
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

/// Δu·(M a_m), Δu·(K Δu), v_f·(M Δu), v_f·(K Δu).
#[derive(Debug, Default)]
struct Sums([f64; 4]);

/// The products of one step, in one pass over the matrices.
struct StepWork<'a, const DIM: usize, const D: usize> {
    p: &'a WireModel<DIM, D>,
    state: &'a WireState<D>,
    /// v_f of every node.
    rate: &'a mut [[f64; D]],
    sums: &'a mut Sums,
}

impl<const DIM: usize, const D: usize> Kernel for StepWork<'_, DIM, D> {
    #[inline(always)]
    fn run(self) {
        let Self {
            p,
            state,
            rate,
            sums,
        } = self;
        let c = p.coefficients;
        let [mut inertia, mut own, mut by_mass, mut by_stiffness] = [[0.0; D]; 4];
        let rows = state.delta.iter().zip(&state.v).zip(state.acceleration());
        for (i, ((d, v), a)) in rows.enumerate() {
            let mass = p.line.mass.row(i, &state.delta);
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
            let k = &p.line.stiffness;
            k.add_row_of_forms(i, &state.delta, rate, &mut own, &mut by_stiffness);
        }
        sums.0 = [inertia, own, by_mass, by_stiffness].map(|lanes| lanes.iter().sum());
    }
}

/// What the ledger needs to know of one step, beyond the states before and after.
#[derive(Debug)]
pub struct StepForces<'a, const DIM: usize> {
    /// Contacts.
    pub contacts: &'a Contacts<DIM>,
    /// Forces and corrections found.
    pub unilateral: &'a ConstraintProblem,
    /// Friction force along the wire at each contact, N.
    pub friction: &'a [f64],
    /// Loads on the line at the time of balance.
    pub(crate) loads: Loads<'a>,
    /// Height strips count from, m.
    pub datum: f64,
}

impl<const D: usize> ImplicitBalance<D> {
    /// Open the ledger at the starting state.
    #[must_use]
    pub fn new<const DIM: usize>(
        p: &WireModel<DIM, D>,
        state: &WireState<D>,
        riders: &[PantographState],
        contacts: &Contacts<DIM>,
        datum: f64,
    ) -> Self {
        let zero = vec![[0.0; D]; state.u.len()];
        let mut ledger = Self {
            entries: EnergyTerms::default(),
            start: EnergyTerms::default(),
            rate: zero.clone(),
            work: zero,
            link_work: vec![0.0; p.line.links.len()],
            inertia: 0.0,
            scheme_elastic: 0.0,
            scheme_riders: 0.0,
            start_linear: 0.0,
            start_slack: slack_energy(p, state),
            slack_energy: slack_energy(p, state),
            rider_work: Vec::with_capacity(riders.len()),
            rider_energy: 0.0,
            law_energy: 0.0,
            start_laws: riders.iter().map(PantographState::law_energy).sum(),
        };
        ledger.start_linear = 0.5 * p.line.stiffness.quadratic(&state.u);
        ledger.start.contact = contact_energy(p, state, riders, contacts, datum);
        ledger.start.riders = riders.iter().map(PantographState::energy).sum();
        ledger
    }

    /// Everything that needs the state before the step is taken. Call after the increments are
    /// complete and before `advance`.
    pub fn before<const DIM: usize>(
        &mut self,
        p: &WireModel<DIM, D>,
        state: &WireState<D>,
        riders: &[PantographState],
        speed: f64,
    ) {
        let c = &p.coefficients;
        self.rider_work.clear();
        self.rider_work
            .extend(riders.iter().map(|rider| rider.work(c, speed)));
        let mut sums = Sums::default();
        widest(StepWork {
            p,
            state,
            rate: &mut self.rate,
            sums: &mut sums,
        });
        let [inertia, own, by_mass, by_stiffness] = sums.0;
        let common = &p.line.common;
        self.inertia += inertia;
        self.scheme_elastic += (0.5 - c.old) * own;
        self.entries.dissipated_line += common.alpha * by_mass + common.beta * by_stiffness;
        self.entries.dissipated_line += self.rest_form(p, state);
        let links = &state.links;
        for (i, link) in p.line.links.iter().enumerate() {
            let (d, old) = (links.delta[i], [links.rate[i], links.second[i]]);
            let rate = c.damping * d + c.velocity_from_v * old[0] + c.velocity_from_a * old[1];
            self.link_work[i] = link.viscosity * rate * d;
        }
    }

    /// Δuᵀ (C − αM − βK) v_f
    fn rest_form<const DIM: usize>(&mut self, p: &WireModel<DIM, D>, state: &WireState<D>) -> f64 {
        let mut sum = 0.0;
        if let Some(rest) = &p.line.mass_damping_rest {
            rest.product(&self.rate, &mut self.work);
            sum += dot(&state.delta, &self.work);
        }
        for (i, j, block) in &p.line.damping_rest {
            let mut form = |a: usize, b: usize, transposed: bool| {
                for p in 0..D {
                    for q in 0..D {
                        let value = if transposed { block[q][p] } else { block[p][q] };
                        sum += state.delta[a][p] * value * self.rate[b][q];
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

    /// Book the step after `advance`.
    pub fn after<const DIM: usize>(
        &mut self,
        p: &WireModel<DIM, D>,
        state: &WireState<D>,
        riders: &[PantographState],
        f: &StepForces<'_, DIM>,
    ) {
        self.book_springs(p, state);
        self.book_links(p, state, f.unilateral);
        self.book_riders(riders);
        self.book_contacts(p, state, riders, f);
        self.entries.work_loads += f.loads.work(&state.delta);
    }

    /// Stored energies of the state itself, ½ vᵀM v and ½ uᵀK u, and what the scheme has dissipated:
    /// the work against inertia that is not stored, and (½ − α_f) ΔuᵀK Δu of every step.
    pub fn settle<const DIM: usize>(&mut self, p: &WireModel<DIM, D>, state: &WireState<D>) {
        let e = &mut self.entries;
        e.kinetic = 0.5 * p.line.mass.quadratic(&state.v);
        let linear = 0.5 * p.line.stiffness.quadratic(&state.u) - self.start_linear;
        e.elastic = linear + self.slack_energy - self.start_slack;
        e.dissipated_scheme = self.scheme_riders + self.scheme_elastic + self.inertia - e.kinetic;
    }

    /// Take the dampers to ground out of the dissipation of the line.
    fn book_springs<const DIM: usize>(&mut self, p: &WireModel<DIM, D>, state: &WireState<D>) {
        for &(node, component, viscosity) in &p.line.dampers {
            let lost = viscosity * self.rate[node][component] * state.delta[node][component];
            self.entries.dissipated_springs += lost;
            self.entries.dissipated_line -= lost;
        }
    }

    /// Take the links out of the dissipation of the line, and correct what a slack link did not
    /// store.
    fn book_links<const DIM: usize>(
        &mut self,
        p: &WireModel<DIM, D>,
        state: &WireState<D>,
        unilateral: &ConstraintProblem,
    ) {
        let mut switching = 0.0;
        let mut dissipated = 0.0;
        for (i, link) in p.line.links.iter().enumerate() {
            let d = state.links.delta[i];
            let linear = self.link_work[i];
            let correction = unilateral.correction[i];
            let is_slack = correction > 0.0;
            self.entries.dissipated_line -= linear;
            if is_slack {
                // K counts the link as linear, so the scheme's share of it is not real either.
                let by_scheme = (0.5 - p.coefficients.old) * link.stiffness * d * d;
                self.scheme_elastic -= by_scheme;
                switching += linear + by_scheme;
            } else {
                dissipated += linear;
            }
            switching += (correction - link.rest_correction()) * d;
        }
        self.entries.dissipated_links += dissipated;
        let slack_energy = slack_energy(p, state);
        switching -= slack_energy - self.slack_energy;
        self.slack_energy = slack_energy;
        self.entries.switching += switching;
    }

    fn book_riders(&mut self, riders: &[PantographState]) {
        let energy = riders.iter().map(PantographState::energy).sum::<f64>() - self.start.riders;
        for work in &self.rider_work {
            self.entries.work_uplift += work.uplift;
            self.entries.work_control += work.control;
            self.entries.dissipated_riders += work.dissipated;
            self.scheme_riders += work.stored;
            self.entries.switching -= work.springs;
        }
        self.scheme_riders -= energy - self.rider_energy;
        self.rider_energy = energy;
        let laws = riders.iter().map(PantographState::law_energy).sum::<f64>() - self.start_laws;
        self.entries.switching -= laws - self.law_energy;
        self.law_energy = laws;
        self.entries.riders = energy + laws;
    }

    /// Save or put back the sums so far.
    pub(crate) fn walk(&mut self, walk: &mut Archive<'_>) -> Result<(), CoreError> {
        walk.numbers("energy", self.entries.all_mut().into_iter())?;
        let start = [
            &mut self.start.contact,
            &mut self.start.riders,
            &mut self.start_linear,
            &mut self.start_slack,
            &mut self.start_laws,
        ];
        walk.numbers("energy_start", start.into_iter())?;
        let sums = [
            &mut self.inertia,
            &mut self.scheme_elastic,
            &mut self.scheme_riders,
            &mut self.slack_energy,
            &mut self.rider_energy,
            &mut self.law_energy,
        ];
        walk.numbers("energy_sums", sums.into_iter())
    }
}

/// Energy that slack links do not store although K counts it. With T = T₀ + k e of the linear link:
/// −½ min(0, T)²/k, and −r₀ e for a link slack at rest, whose K is cancelled by r₀ from the start.
fn slack_energy<const DIM: usize, const D: usize>(
    p: &WireModel<DIM, D>,
    state: &WireState<D>,
) -> f64 {
    let mut energy = 0.0;
    for (link, e) in p.line.links.iter().zip(&state.links.elongation) {
        let tension = link.rest_tension + link.stiffness * e;
        if link.unilateral {
            energy -= 0.5 * tension.min(0.0).powi(2) / link.stiffness;
            energy -= link.rest_correction() * e;
        }
    }
    energy
}
