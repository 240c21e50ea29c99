//! Contacts in the [`balance`](crate::integrator::energy::explicit) of explicit steps.

use crate::constraint::contacts::{Contact, Contacts};
use crate::integrator::energy::explicit::{ContactState, ExplicitBalance};
use crate::integrator::energy::step_forces::StepForces;
use crate::integrator::explicit::{ChainState, Explicit};
use crate::integrator::wire_model::WireModel;
use crate::linalg::small::inner;
use crate::pantograph::state::PantographState;
use crate::slideline::local_compliance::LocalCompliance;

fn overlap_energy(overlap: f64, compliance: f64) -> f64 {
    if compliance > 0.0 {
        0.5 * overlap.max(0.0).powi(2) / compliance
    } else {
        0.0
    }
}

impl<const DIM: usize, const D: usize> ExplicitBalance<DIM, D> {
    /// Returns a contact at the start, where z = u.
    pub(crate) fn contact_at_rest(
        &self,
        wires: &WireModel<DIM, D>,
        contacts: &Contacts<DIM>,
        i: usize,
        (pantographs, datum): (&[PantographState], f64),
    ) -> ContactState {
        let contact = &contacts.all[i];
        let (end, slideline) = (&contact.ends[1], &wires.slidelines[contact.indices[2]]);
        let compliance = slideline.compliance_at(end);
        let total_compliance = wires.contact_flexibility + compliance.flexibility
            - wires.flexibility_through_links(&compliance, &compliance);
        let wire = end.height
            + compliance.static_height
            + wires.vertical_displacement(end, &compliance, &self.z);
        let overlap = datum + inner(&contact.vector, &pantographs[contact.pantograph()].u) - wire;
        ContactState {
            is_active: true,
            overlap,
            energy: overlap_energy(overlap, total_compliance),
        }
    }

    pub(crate) fn add_contacts(
        &mut self,
        wires: &WireModel<DIM, D>,
        (steps, chain): (&Explicit<DIM>, &ChainState),
        f: &StepForces<'_, DIM>,
    ) {
        for (i, contact) in f.contacts.all.iter().enumerate() {
            let before = std::mem::take(&mut self.contact_states[i]);
            if !contact.is_active {
                self.terms.switching += before.energy;
                self.contact_and_link_switching -= before.energy;
                continue;
            }
            let (end, slideline) = (&contact.ends[1], &wires.slidelines[contact.indices[2]]);
            // The compliance of the same point is known.
            let is_same =
                end.element == contact.point.element && end.weights == contact.point.weights;
            let compliance = match is_same {
                true => contact.compliance,
                false => slideline.compliance_at(end),
            };
            for node in &end.nodes[..end.count] {
                self.update_node(steps, chain, *node);
            }
            for (link, _) in compliance.links() {
                let nodes = wires.line.links[link].nodes;
                nodes
                    .iter()
                    .for_each(|&node| self.update_node(steps, chain, node));
            }
            self.contact_states[i] =
                self.add_contact(wires, (i, contact), (before, &compliance), f);
        }
    }

    /// Adds the terms of an active contact; returns its state at the end of the step.
    fn add_contact(
        &mut self,
        wires: &WireModel<DIM, D>,
        (i, contact): (usize, &Contact<DIM>),
        (before, compliance): (ContactState, &LocalCompliance),
        f: &StepForces<'_, DIM>,
    ) -> ContactState {
        let (end, force) = (&contact.ends[1], f.problem.force[i]);
        let total_compliance = wires.contact_flexibility + compliance.flexibility
            - wires.flexibility_through_links(compliance, compliance);
        let height_above_mesh = Self::height_above_mesh(wires, (i, contact), compliance, f);
        let wire =
            end.height + height_above_mesh + wires.vertical_displacement(end, compliance, &self.z);
        let pantograph = &self.pantographs[contact.pantograph()];
        let now = f.datum + inner(&contact.vector, &pantograph.z) - wire;
        let lifted = inner(&contact.vector, &pantograph.increment);
        let risen = wires.vertical_displacement(end, compliance, &self.increment);
        let after = now + lifted - risen;
        let [energy, ended] = [now, after].map(|o| overlap_energy(o, total_compliance));
        let traction = match before.is_active {
            true if total_compliance > 0.0 => energy - before.energy,
            true => force * (now - before.overlap),
            false => 0.0,
        };
        if !before.is_active {
            // Energy that appears or disappears at the end of a wire does not depend on the step
            // length.
            self.contact_and_link_switching += energy;
        }
        self.terms.work_traction += traction;
        self.terms.switching += traction - (ended - before.energy) + force * (lifted - risen);
        self.work += force * risen;
        if f.friction[i] != 0.0 {
            let work = f.friction[i] * end.displacement(&self.increment, 0);
            self.terms.work_friction += work;
            self.work += work;
        }
        ContactState {
            is_active: true,
            overlap: after,
            energy: ended,
        }
    }

    /// Returns the height of the wire above the mesh at a contact by corrections of links and other
    /// contacts, m.
    fn height_above_mesh(
        wires: &WireModel<DIM, D>,
        (i, contact): (usize, &Contact<DIM>),
        compliance: &LocalCompliance,
        f: &StepForces<'_, DIM>,
    ) -> f64 {
        let corrected = |(link, rise): (usize, f64)| {
            rise * (f.problem.correction[link] - wires.line.links[link].rest_correction())
        };
        let others = f.contacts.active.iter().filter(|&&j| j != i);
        let pressed = others.map(|&j| {
            let other = &f.contacts.all[j];
            wires.residual_compliance(contact, other) * f.problem.force[j]
        });
        compliance.static_height
            + compliance.links().map(corrected).sum::<f64>()
            + pressed.sum::<f64>()
    }
}
