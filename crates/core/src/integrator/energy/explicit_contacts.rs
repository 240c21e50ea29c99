//! Contacts in the [`balance`](crate::integrator::energy::explicit) of explicit steps.

use crate::constraint::contacts::{Contact, Contacts};
use crate::integrator::energy::explicit::ExplicitBalance;
use crate::integrator::energy::implicit::StepForces;
use crate::integrator::explicit::{Explicit, Grid};
use crate::integrator::prepared::WireModel;
use crate::pantograph::system::{PantographState, inner};
use crate::slideline::residual_flexibility::LocalCompliance;

/// A contact at the end of the last step.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Pressed {
    pub meets: bool,
    pub overlap: f64,
    pub energy: f64,
}

fn overlap_energy(overlap: f64, compliance: f64) -> f64 {
    if compliance > 0.0 {
        0.5 * overlap.max(0.0).powi(2) / compliance
    } else {
        0.0
    }
}

impl<const DIM: usize, const D: usize> ExplicitBalance<DIM, D> {
    /// A contact at the start, where z is u.
    pub(crate) fn press(
        &self,
        p: &WireModel<DIM, D>,
        contacts: &Contacts<DIM>,
        i: usize,
        (riders, datum): (&[PantographState], f64),
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

    pub(crate) fn book_contacts(
        &mut self,
        p: &WireModel<DIM, D>,
        (steps, grid): (&Explicit<DIM>, &Grid),
        f: &StepForces<'_, DIM>,
    ) {
        for (i, contact) in f.contacts.all.iter().enumerate() {
            let before = std::mem::take(&mut self.pressed[i]);
            if !contact.meets {
                self.entries.switching += before.energy;
                self.switched -= before.energy;
                continue;
            }
            let (end, lane) = (&contact.ends[1], &p.lanes[contact.of[2]]);
            // That of the same place has been found.
            let is_same =
                end.element == contact.place.element && end.weights == contact.place.weights;
            let yields = match is_same {
                true => contact.yields,
                false => lane.yield_at(end),
            };
            for node in &end.nodes[..end.count] {
                self.look(steps, grid, *node);
            }
            for (link, _) in yields.pulls() {
                let nodes = p.line.links[link].nodes;
                nodes.iter().for_each(|&node| self.look(steps, grid, node));
            }
            self.pressed[i] = self.book_contact(p, (i, contact), (before, &yields), f);
        }
    }

    /// One that meets the wire, where that yields; tells how it is at the end.
    fn book_contact(
        &mut self,
        p: &WireModel<DIM, D>,
        (i, contact): (usize, &Contact<DIM>),
        (before, yields): (Pressed, &LocalCompliance),
        f: &StepForces<'_, DIM>,
    ) -> Pressed {
        let (end, force) = (&contact.ends[1], f.unilateral.force[i]);
        let compliance = p.contact_flexibility + yields.own - p.carried(yields, yields);
        let raised = Self::raised(p, (i, contact), yields, f);
        let wire = end.height + raised + p.felt(end, yields, &self.z);
        let rider = &self.riders[contact.rider()];
        let now = f.datum + inner(&contact.vector, &rider.z) - wire;
        let lifted = inner(&contact.vector, &rider.moved);
        let risen = p.felt(end, yields, &self.moved);
        let after = now + lifted - risen;
        let [energy, ended] = [now, after].map(|o| overlap_energy(o, compliance));
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
        Pressed {
            meets: true,
            overlap: after,
            energy: ended,
        }
    }

    /// What the wire is higher by at a contact than that of the mesh, by corrections of links and other contacts.
    fn raised(
        p: &WireModel<DIM, D>,
        (i, contact): (usize, &Contact<DIM>),
        yields: &LocalCompliance,
        f: &StepForces<'_, DIM>,
    ) -> f64 {
        let corrected = |(link, rise): (usize, f64)| {
            rise * (f.unilateral.correction[link] - p.line.links[link].rest_correction())
        };
        let others = f.contacts.active.iter().filter(|&&j| j != i);
        let pressed = others.map(|&j| {
            let other = &f.contacts.all[j];
            p.residual(contact, other) * f.unilateral.force[j]
        });
        yields.rise + yields.pulls().map(corrected).sum::<f64>() + pressed.sum::<f64>()
    }
}
