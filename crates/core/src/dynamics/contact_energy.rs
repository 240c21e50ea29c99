//! Energy of the contacts and their work in a step.
//!
//! With F at the place x of the time of balance, h the height of the wire under the contact and
//! s = e(y)ᵀu that of the strip, both at the end of a step and of the one before,
//!
//!   traction  = F Sᵀ(x) Δu − F Δh + F (Δs − eᵀΔu)
//!   switching = F Δs − F Δh − ΔE_contact
//!
//! The first two terms of the traction are the contact that moves along the slope of the wire. The
//! last, (e − e of the step before)ᵀu, is the wire that slides sideways over a strip which is not level.

use super::contacts::Contacts;
use super::ledger::{Ledger, StepForces};
use super::place::Place;
use super::rider::{RiderState, inner};
use super::stepper::{LineState, Prepared};

impl<const D: usize> Ledger<D> {
    pub(super) fn book_contacts<const DIM: usize>(
        &mut self,
        p: &Prepared<DIM, D>,
        state: &LineState<D>,
        riders: &[RiderState],
        f: &StepForces<'_, DIM>,
    ) {
        let up = DIM - 1;
        for (i, contact) in f.contacts.all.iter().enumerate().filter(|(_, c)| c.meets) {
            let force = f.unilateral.force[i];
            let (place, [before, after]) = (&contact.place, &contact.ends);
            let on_line = force * place.displacement(&state.delta, up);
            let on_rider = -force * inner(&contact.vector, &riders[contact.rider()].delta);
            let aside = force * contact.slid;
            // Height of the wire under the contact, before and after the step.
            let height = |q: &Place<DIM>, back: f64| {
                q.height + q.displacement(&state.u, up) - back * q.displacement(&state.delta, up)
            };
            let rise = height(after, 0.0) - height(before, 1.0);
            // Of the contact that moves while the wire does, the scheme keeps a share (½ − α_f).
            let moved =
                after.displacement(&state.delta, up) - before.displacement(&state.delta, up);
            let by_scheme = (0.5 - p.coefficients.old) * force * moved;
            self.scheme_elastic -= by_scheme;
            // Where the wire rises ahead it pushes the strip on: the rider gains, traction is
            // negative.
            self.entries.work_traction += on_line - by_scheme - force * rise + aside;
            self.entries.switching -= force * rise + on_rider - aside;
            let along = place.displacement(&state.delta, 0);
            self.entries.work_friction += f.friction[i] * along;
        }
        let energy = contact_energy(p, state, riders, f.contacts, f.datum);
        self.entries.switching -= energy - self.start.contact - self.entries.contact;
        self.entries.contact = energy - self.start.contact;
    }
}

/// Energy ½ p²/k_c of the contact compliances, p the overlap of strip and wire, and of the stops.
pub(super) fn contact_energy<const DIM: usize, const D: usize>(
    p: &Prepared<DIM, D>,
    state: &LineState<D>,
    riders: &[RiderState],
    contacts: &Contacts<DIM>,
    datum: f64,
) -> f64 {
    let stops: f64 = riders.iter().map(RiderState::stop_energy).sum();
    if p.contact_flexibility == 0.0 {
        return stops;
    }
    let squares = contacts.active().map(|contact| {
        let end = &contact.ends[1];
        let wire = end.height + end.displacement(&state.u, DIM - 1);
        let strip = datum + inner(&contact.vector, &riders[contact.rider()].u);
        (strip - wire).max(0.0).powi(2)
    });
    0.5 / p.contact_flexibility * squares.sum::<f64>() + stops
}
