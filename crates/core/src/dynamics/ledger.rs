//! Energy ledger of a run: what is stored, dissipated and supplied, step by step.
//!
//! Multiplying the balance of the scheme by Δu gives, exactly,
//!
//!   Δu·(M a_m) + Δu·(C v_f) + Δu·(K u_f) = Δu·f
//!
//! The first term is ΔE_kin plus what the scheme dissipates in inertia, the third ΔE_el plus what
//! it dissipates in stiffness (both zero for the trapezoidal rule), the second is real
//! dissipation. What a unilateral law loses because it opens or closes between two instants
//! (including the impact of a rigid contact) is the `switching` entry:
//!
//! * contact:  switching = work of the moving contact − ΔE_contact − work done on line and rider
//! * link:     switching = −(change of stored energy and of dissipation by going slack) − work of r
//!
//! The residual is what does not add up. It is independent of the solver: energies come from
//! products with K and M, the solver never forms the product with K.

use super::contact::Unilateral;
use super::path::Place;
use super::rider::{RiderState, RiderWork};
use super::stepper::{LineState, Prepared};

/// Entries in J, summed since the start of the run (stored energies: their change).
#[derive(Debug, Clone, Copy, Default)]
pub struct Entries {
    /// Kinetic energy of the line.
    pub kinetic: f64,
    /// Elastic energy of the line about its equilibrium (gravity and prestress included).
    pub elastic: f64,
    /// Energy in the contact compliances.
    pub contact: f64,
    /// Kinetic and elastic energy of the riders.
    pub riders: f64,
    /// Dissipated in wires and struts.
    pub dissipated_line: f64,
    /// Dissipated in links.
    pub dissipated_links: f64,
    /// Dissipated in springs to ground.
    pub dissipated_springs: f64,
    /// Dissipated in riders.
    pub dissipated_riders: f64,
    /// Taken out (or put in, when negative) by the time-stepping scheme.
    pub dissipated_scheme: f64,
    /// Lost when contacts and links open or close, impacts included.
    pub switching: f64,
    /// Work of preload and lift on the riders.
    pub work_uplift: f64,
    /// Work of the traction that moves the contact along the sloping wire.
    pub work_traction: f64,
    /// Work of friction along the wire.
    pub work_friction: f64,
}

impl Entries {
    /// Stored + dissipated + lost − supplied: zero but for rounding.
    #[must_use]
    pub fn residual(&self) -> f64 {
        self.kinetic
            + self.elastic
            + self.contact
            + self.riders
            + self.dissipated_line
            + self.dissipated_links
            + self.dissipated_springs
            + self.dissipated_riders
            + self.dissipated_scheme
            + self.switching
            - self.work_uplift
            - self.work_traction
            - self.work_friction
    }

    /// Energy turned over: the scale a residual is compared with.
    #[must_use]
    pub fn turnover(&self) -> f64 {
        let supplied = self.work_uplift.abs() + self.work_traction.abs() + self.work_friction.abs();
        supplied.max(self.kinetic.abs() + self.elastic.abs() + self.riders.abs())
    }
}

/// Running ledger and its work space.
#[derive(Debug)]
pub struct Ledger<const D: usize> {
    /// Entries so far.
    pub entries: Entries,
    start: Entries,
    ku: Vec<[f64; D]>,
    new_ku: Vec<[f64; D]>,
    product: Vec<[f64; D]>,
    rate: Vec<[f64; D]>,
    mass_product: Vec<[f64; D]>,
    damping_product: Vec<[f64; D]>,
    slack_energy: f64,
    rider_work: Vec<RiderWork>,
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

/// What the ledger needs to know of one step, beyond the states before and after.
#[derive(Debug)]
pub struct StepForces<'a> {
    /// Contacts at the time of balance.
    pub places: &'a [Place],
    /// Contacts before and after the step.
    pub ends: [&'a [Place]; 2],
    /// Forces and corrections found.
    pub unilateral: &'a Unilateral,
    /// Friction force along the wire at each contact, N.
    pub friction: &'a [f64],
    /// Height strips count from, m.
    pub datum: f64,
}

impl<const D: usize> Ledger<D> {
    /// Open the ledger at the starting state.
    #[must_use]
    pub fn new<const DIM: usize>(
        p: &Prepared<DIM, D>,
        state: &LineState<D>,
        riders: &[RiderState],
        places: &[Place],
        datum: f64,
    ) -> Self {
        let zero = vec![[0.0; D]; state.u.len()];
        let mut ledger = Self {
            entries: Entries::default(),
            start: Entries::default(),
            ku: zero.clone(),
            new_ku: zero.clone(),
            product: zero.clone(),
            rate: zero.clone(),
            mass_product: zero.clone(),
            damping_product: zero,
            slack_energy: 0.0,
            rider_work: Vec::with_capacity(riders.len()),
        };
        p.line.stiffness.add_product(&state.u, &mut ledger.ku);
        ledger.slack_energy = slack_energy(p, state);
        ledger.start.elastic = 0.5 * dot(&state.u, &ledger.ku) + ledger.slack_energy;
        ledger.start.contact = contact_energy(p, state, riders, places, datum);
        ledger.start.riders = riders.iter().map(RiderState::energy).sum();
        ledger
    }

    /// Products that need the state before the step is taken. Call after the increments are
    /// complete and before `advance`.
    pub fn before<const DIM: usize>(
        &mut self,
        p: &Prepared<DIM, D>,
        state: &LineState<D>,
        riders: &[RiderState],
        speed: f64,
    ) {
        let c = &p.coefficients;
        self.rider_work.clear();
        self.rider_work.extend(riders.iter().map(|rider| rider.work(c, speed)));
        for (i, rate) in self.rate.iter_mut().enumerate() {
            for k in 0..D {
                let (d, v, a) = (state.delta[i][k], state.v[i][k], state.a[i][k]);
                rate[k] = c.damping * d + c.velocity_from_v * v + c.velocity_from_a * a;
                self.product[i][k] =
                    c.mass * d + c.acceleration_from_v * v + c.acceleration_from_a * a;
            }
        }
        self.mass_product.fill([0.0; D]);
        p.line.mass.add_product(&self.product, &mut self.mass_product);
    }

    /// Book the step after `advance`.
    pub fn after<const DIM: usize>(
        &mut self,
        p: &Prepared<DIM, D>,
        state: &LineState<D>,
        riders: &[RiderState],
        f: &StepForces<'_>,
    ) {
        self.book_line(p, state);
        self.book_links(p, state, f.unilateral);
        self.book_riders(riders);
        self.book_contacts(p, state, riders, f);
    }

    fn book_line<const DIM: usize>(&mut self, p: &Prepared<DIM, D>, state: &LineState<D>) {
        let c = &p.coefficients;
        self.new_ku.fill([0.0; D]);
        self.damping_product.fill([0.0; D]);
        p.line.stiffness.add_products(
            [&state.u, &self.rate],
            [&mut self.new_ku, &mut self.damping_product],
        );
        let beta = p.line.common.beta;
        self.damping_product.iter_mut().flatten().for_each(|v| *v *= beta);
        let inertia = dot(&state.delta, &self.mass_product);
        let (keep, old) = (c.stiffness, c.old);
        let elastic = keep * dot(&state.delta, &self.new_ku) + old * dot(&state.delta, &self.ku);
        p.line.add_damping_rest(&self.rate, &mut self.damping_product);
        let mut dissipated = dot(&state.delta, &self.damping_product);
        if p.line.common.alpha != 0.0 {
            self.product.fill([0.0; D]);
            p.line.mass.add_product(&self.rate, &mut self.product);
            dissipated += p.line.common.alpha * dot(&state.delta, &self.product);
        }
        self.product.fill([0.0; D]);
        p.line.mass.add_product(&state.v, &mut self.product);
        let kinetic = 0.5 * dot(&state.v, &self.product);
        let linear_before = self.entries.elastic + self.start.elastic - self.slack_energy;
        let linear = 0.5 * dot(&state.u, &self.new_ku);
        self.entries.dissipated_scheme += inertia - (kinetic - self.entries.kinetic);
        self.entries.dissipated_scheme += elastic - (linear - linear_before);
        self.entries.dissipated_line += dissipated;
        self.entries.kinetic = kinetic;
        self.entries.elastic = linear + self.slack_energy - self.start.elastic;
        std::mem::swap(&mut self.ku, &mut self.new_ku);
    }

    /// Split the dissipation by its place, and correct what a slack link did not store.
    fn book_links<const DIM: usize>(
        &mut self,
        p: &Prepared<DIM, D>,
        state: &LineState<D>,
        unilateral: &Unilateral,
    ) {
        let mut switching = 0.0;
        let mut dissipated = 0.0;
        for (i, link) in p.line.links.iter().enumerate() {
            let d = state.link_delta[i];
            let linear = link.viscosity * link.elongation(&self.rate) * d;
            let correction = unilateral.correction[i];
            let is_slack = correction > 0.0;
            self.entries.dissipated_line -= linear;
            if is_slack {
                switching += linear;
            } else {
                dissipated += linear;
            }
            switching += (correction - link.rest_correction()) * d;
        }
        self.entries.dissipated_links += dissipated;
        let slack_energy = slack_energy(p, state);
        switching -= slack_energy - self.slack_energy;
        self.entries.elastic += slack_energy - self.slack_energy;
        self.slack_energy = slack_energy;
        self.entries.switching += switching;
    }

    fn book_riders(&mut self, riders: &[RiderState]) {
        let energy = riders.iter().map(RiderState::energy).sum::<f64>() - self.start.riders;
        for work in &self.rider_work {
            self.entries.work_uplift += work.uplift;
            self.entries.dissipated_riders += work.dissipated;
            self.entries.dissipated_scheme += work.stored;
        }
        self.entries.dissipated_scheme -= energy - self.entries.riders;
        self.entries.riders = energy;
    }

    fn book_contacts<const DIM: usize>(
        &mut self,
        p: &Prepared<DIM, D>,
        state: &LineState<D>,
        riders: &[RiderState],
        f: &StepForces<'_>,
    ) {
        let up = DIM - 1;
        let [before, after] = f.ends;
        for (j, place) in f.places.iter().enumerate() {
            let force = f.unilateral.force[j];
            let on_line = force * p.path.displacement(place, &state.delta, up);
            let on_rider = -force * riders[j].strip(&riders[j].delta);
            // Displacement of the balance, frozen while the contact moves along the wire.
            let frozen = |q: &Place| {
                let now = p.path.displacement(q, &state.u, up);
                let increment = p.path.displacement(q, &state.delta, up);
                q.height + now - p.coefficients.old * increment
            };
            let traction = force * (frozen(&after[j]) - frozen(&before[j]));
            self.entries.work_traction += traction;
            self.entries.switching += traction - on_line - on_rider;
            let along = p.path.displacement(place, &state.delta, 0);
            self.entries.work_friction += f.friction[j] * along;
        }
        let energy = contact_energy(p, state, riders, after, f.datum);
        self.entries.switching -= energy - self.start.contact - self.entries.contact;
        self.entries.contact = energy - self.start.contact;
    }
}

/// Energy ½ p²/k_c of the contact compliances, p the overlap of strip and wire.
fn contact_energy<const DIM: usize, const D: usize>(
    p: &Prepared<DIM, D>,
    state: &LineState<D>,
    riders: &[RiderState],
    places: &[Place],
    datum: f64,
) -> f64 {
    if p.contact_flexibility == 0.0 {
        return 0.0;
    }
    let overlap = |(place, rider): (&Place, &RiderState)| {
        let wire = place.height + p.path.displacement(place, &state.u, DIM - 1);
        (datum + rider.strip(&rider.u) - wire).max(0.0)
    };
    let squares = places.iter().zip(riders).map(|pair| overlap(pair).powi(2));
    0.5 / p.contact_flexibility * squares.sum::<f64>()
}

/// Energy that slack links do not store although K counts it. With T = T₀ + k e of the linear link:
/// −½ min(0, T)²/k, and −r₀ e for a link slack at rest, whose K is cancelled by r₀ from the start.
fn slack_energy<const DIM: usize, const D: usize>(
    p: &Prepared<DIM, D>,
    state: &LineState<D>,
) -> f64 {
    let mut energy = 0.0;
    for (link, [e, _, _]) in p.line.links.iter().zip(&state.links) {
        let tension = link.rest_tension + link.stiffness * e;
        if link.unilateral {
            energy -= 0.5 * tension.min(0.0).powi(2) / link.stiffness;
            energy -= link.rest_correction() * e;
        }
    }
    energy
}
