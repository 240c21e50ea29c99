//! Energy of the contacts and their work in a step.
//!
//! With F at the place x of the time of balance, h the height of the wire under the contact and
//! s = e(y)ᵀu that of the strip, both at the end of a step and of the one before,
//!
//!   traction  = F Sᵀ(x) Δu − F Δh + F (Δs − eᵀΔu)
//!   switching = F Δs − F Δh − ΔE_contact
//!
//! Where the wire yields beyond the mesh ([yields](crate::slideline::residual_flexibility)), S is s, the compliance C of a contact is
//! 1/k_c + R̃, and as that changes along the wire the traction has −½ F² ΔC, the switching too. What
//! two strips have in common of R̃, and corrections of links in the height, count as switching.
//!
//! The first two terms of the traction are the contact that moves along the slope of the wire. The
//! last, (e − e of the step before)ᵀu, is the wire that slides sideways over a strip which is not level.

use crate::constraint::contacts::{Contact, Contacts};
use crate::integrator::WireState;
use crate::integrator::energy::implicit::{ImplicitBalance, StepForces};
use crate::integrator::prepared::WireModel;
use crate::pantograph::system::{PantographState, inner};
use crate::slideline::point::SlidelinePoint;
use crate::slideline::residual_flexibility::LocalCompliance;

impl<const D: usize> ImplicitBalance<D> {
    pub(crate) fn book_contacts<const DIM: usize>(
        &mut self,
        p: &WireModel<DIM, D>,
        state: &WireState<D>,
        riders: &[PantographState],
        f: &StepForces<'_, DIM>,
    ) {
        for (i, contact) in f.contacts.all.iter().enumerate().filter(|(_, c)| c.meets) {
            let force = f.unilateral.force[i];
            let (place, [before, after]) = (&contact.place, &contact.ends);
            let lane = &p.lanes[contact.of[2]];
            let [felt_before, felt_after] = [before, after].map(|end| lane.yield_at(end));
            let on_line = force * p.felt(place, &contact.yields, &state.delta);
            let on_rider = -force * inner(&contact.vector, &riders[contact.rider()].delta);
            let aside = force * contact.slid;
            // Height of the wire under the contact, before and after the step.
            let height = |q: &SlidelinePoint<DIM>, y: &LocalCompliance, back: f64| {
                let height = q.height + y.rise + p.felt(q, y, &state.u);
                height - back * p.felt(q, y, &state.delta)
            };
            let rise = height(after, &felt_after, 0.0) - height(before, &felt_before, 1.0);
            // Of the contact that moves while the wire does, the scheme keeps a share (½ − α_f).
            let moved = p.felt(after, &felt_after, &state.delta)
                - p.felt(before, &felt_before, &state.delta);
            let by_scheme = (0.5 - p.coefficients.old) * force * moved;
            self.scheme_elastic -= by_scheme;
            // Where the wire rises ahead it pushes the strip on: the rider gains, traction is
            // negative.
            self.entries.work_traction += on_line - by_scheme - force * rise + aside;
            self.entries.switching -= force * rise + on_rider - aside;
            // A contact that moves on to where the wire yields more: dE = F dp − ½ F² dC.
            let yields = |y: &LocalCompliance| y.own - p.carried(y, y);
            let softened = 0.5 * force * force * (yields(&felt_after) - yields(&felt_before));
            self.entries.work_traction -= softened;
            self.entries.switching -= softened;
            let along = place.displacement(&state.delta, 0);
            self.entries.work_friction += f.friction[i] * along;
        }
        let energy = contact_energy(p, state, riders, f.contacts, f.datum);
        self.entries.switching -= energy - self.start.contact - self.entries.contact;
        self.entries.contact = energy - self.start.contact;
    }
}

/// Energy ½ p²/k_c of the contact compliances, p the overlap of strip and wire, and of the stops.
pub(crate) fn contact_energy<const DIM: usize, const D: usize>(
    p: &WireModel<DIM, D>,
    state: &WireState<D>,
    riders: &[PantographState],
    contacts: &Contacts<DIM>,
    datum: f64,
) -> f64 {
    let stops: f64 = riders.iter().map(PantographState::stop_energy).sum();
    // Both are one, 1/k_c, where nothing yields beyond the mesh.
    let scale = if p.contact_flexibility > 0.0 {
        p.contact_flexibility
    } else {
        1.0
    };
    let of = |contact: &Contact<DIM>| {
        let end = &contact.ends[1];
        let yields = p.lanes[contact.of[2]].yield_at(end);
        let compliance = p.contact_flexibility + yields.own - p.carried(&yields, &yields);
        let wire = end.height + yields.rise + p.felt(end, &yields, &state.u);
        let strip = datum + inner(&contact.vector, &riders[contact.rider()].u);
        if compliance > 0.0 {
            (strip - wire).max(0.0).powi(2) * (scale / compliance)
        } else {
            0.0
        }
    };
    0.5 / scale * contacts.active().map(of).sum::<f64>() + stops
}
