//! Energy of the contacts and their work in a step.
//!
//! With F at the point x of the time of balance, h the height of the wire under the contact and
//! s = e(y)ᵀu that of the strip, both at the end of a step and of the one before,
//!
//!   traction  = F Sᵀ(x) Δu − F Δh + F (Δs − eᵀΔu)
//!   switching = F Δs − F Δh − ΔE_contact
//!
//! Where the wire has compliance beyond the mesh, see
//! [local compliance](crate::slideline::local_compliance), S is s, the compliance of a contact is C
//! = 1/k_c + R̃, and as that changes along the wire the traction has −½ F² ΔC, the switching too.
//! The R̃ between two strips, and corrections of links in the height, count as switching.
//!
//! The first two terms of the traction are the contact that moves along the slope of the wire. The
//! last, (e − e of the step before)ᵀu, is the wire that slides sideways over a strip that is not
//! level.

use crate::constraint::contacts::{Contact, Contacts};
use crate::energy_terms::EnergyTerms;
use crate::integrator::energy::step_forces::StepForces;
use crate::integrator::state::WireState;
use crate::integrator::wire_model::WireModel;
use crate::linalg::small::inner;
use crate::pantograph::state::PantographState;
use crate::slideline::local_compliance::LocalCompliance;
use crate::slideline::point::SlidelinePoint;

/// Terms of the balance that contacts change in a step.
pub(crate) struct ContactEnergies<'a> {
    /// Sums so far, J.
    pub terms: &'a mut EnergyTerms,
    /// Part of the elastic work that the scheme dissipates, J.
    pub scheme: &'a mut f64,
    /// Energy of the contacts at the start of the run, J.
    pub at_start: f64,
}

impl ContactEnergies<'_> {
    /// Adds traction, friction and switching of a step after its commit.
    pub(crate) fn add<const DIM: usize, const D: usize>(
        self,
        wires: &WireModel<DIM, D>,
        state: &WireState<D>,
        pantographs: &[PantographState],
        f: &StepForces<'_, DIM>,
    ) {
        for (i, contact) in f
            .contacts
            .all
            .iter()
            .enumerate()
            .filter(|(_, c)| c.is_active)
        {
            let force = f.problem.force[i];
            let (point, [before, after]) = (&contact.point, &contact.ends);
            let slideline = &wires.slidelines[contact.indices[2]];
            let [compliance_before, compliance_after] =
                [before, after].map(|end| slideline.compliance_at(end));
            let work_on_line =
                force * wires.vertical_displacement(point, &contact.compliance, &state.delta);
            let work_on_pantograph =
                -force * inner(&contact.vector, &pantographs[contact.pantograph()].delta);
            let lateral_work = force * contact.lateral_rise;
            // Height of the wire under the contact, before and after the step.
            let height = |point_at: &SlidelinePoint<DIM>,
                          local: &LocalCompliance,
                          share_of_increment: f64| {
                let height = point_at.height
                    + local.static_height
                    + wires.vertical_displacement(point_at, local, &state.u);
                height
                    - share_of_increment
                        * wires.vertical_displacement(point_at, local, &state.delta)
            };
            let rise =
                height(after, &compliance_after, 0.0) - height(before, &compliance_before, 1.0);
            // Work of a contact that moves with the wire, of which the scheme dissipates the share
            // ½ − α_f.
            let advance_of_contact =
                wires.vertical_displacement(after, &compliance_after, &state.delta)
                    - wires.vertical_displacement(before, &compliance_before, &state.delta);
            let by_scheme = (0.5 - wires.coefficients.old) * force * advance_of_contact;
            *self.scheme -= by_scheme;
            // Where the wire rises ahead it does work on the strip, and traction is negative.
            self.terms.work_traction += work_on_line - by_scheme - force * rise + lateral_work;
            self.terms.switching -= force * rise + work_on_pantograph - lateral_work;
            // A contact that moves to a point of larger compliance: dE = F dp − ½ F² dC.
            let flexibility = |local: &LocalCompliance| {
                local.flexibility - wires.flexibility_through_links(local, local)
            };
            let softened = 0.5
                * force
                * force
                * (flexibility(&compliance_after) - flexibility(&compliance_before));
            self.terms.work_traction -= softened;
            self.terms.switching -= softened;
            let along = point.displacement(&state.delta, 0);
            self.terms.work_friction += f.friction[i] * along;
        }
        let energy = contact_energy(wires, state, pantographs, f.contacts, f.datum);
        self.terms.switching -= energy - self.at_start - self.terms.contact;
        self.terms.contact = energy - self.at_start;
    }
}

/// Returns the energy ½ p²/k_c of the contact compliances, J, p the overlap of strip and wire, and
/// of the bump stops.
pub(crate) fn contact_energy<const DIM: usize, const D: usize>(
    wires: &WireModel<DIM, D>,
    state: &WireState<D>,
    pantographs: &[PantographState],
    contacts: &Contacts<DIM>,
    datum: f64,
) -> f64 {
    let stops: f64 = pantographs.iter().map(PantographState::stop_energy).sum();
    // The scale equals the compliance 1/k_c where the wire has none beyond the mesh.
    let scale = if wires.contact_flexibility > 0.0 {
        wires.contact_flexibility
    } else {
        1.0
    };
    let energy_of = |contact: &Contact<DIM>| {
        let end = &contact.ends[1];
        let compliance = wires.slidelines[contact.indices[2]].compliance_at(end);
        let total_compliance = wires.contact_flexibility + compliance.flexibility
            - wires.flexibility_through_links(&compliance, &compliance);
        let wire = end.height
            + compliance.static_height
            + wires.vertical_displacement(end, &compliance, &state.u);
        let strip = datum + inner(&contact.vector, &pantographs[contact.pantograph()].u);
        if total_compliance > 0.0 {
            (strip - wire).max(0.0).powi(2) * (scale / total_compliance)
        } else {
            0.0
        }
    };
    0.5 / scale * contacts.active().map(energy_of).sum::<f64>() + stops
}
