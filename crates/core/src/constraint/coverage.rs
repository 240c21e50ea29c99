//! Check that every pantograph has a wire in reach.

use crate::constraint::contacts::{Contact, Contacts};
use crate::error::CoreError;
use crate::pantograph::model::Pantograph;
use crate::slideline::Slideline;

impl<const DIM: usize> Contacts<DIM> {
    /// Checks that every strip has wire before and after the step, and every pantograph a contact.
    pub(crate) fn check_coverage(
        &self,
        pantographs: &[Pantograph],
        slidelines: &[Slideline<DIM>],
        [_, _, end]: [f64; 3],
        step: usize,
    ) -> Result<(), CoreError> {
        for contacts_of_strip in self.all.chunks(self.slidelines) {
            let position = contacts_of_strip[0].along(end);
            let is_on = |c: &Contact<DIM>| {
                let nearby_element = c.ends[1].element;
                c.is_active
                    || slidelines[c.indices[2]]
                        .locate(position, nearby_element)
                        .is_some()
            };
            if !contacts_of_strip.iter().any(|c| c.has_wire) || !contacts_of_strip.iter().any(is_on)
            {
                return Err(CoreError::OffWire {
                    pantograph: contacts_of_strip[0].pantograph(),
                    position,
                    step,
                });
            }
        }
        for (j, pantograph) in pantographs.iter().enumerate() {
            let mut contacts = self.all.iter().filter(|c| c.pantograph() == j);
            if contacts.clone().any(|c| c.is_active) {
                continue;
            }
            // The wire nearest to the strip.
            let distance_outside =
                |c: &&Contact<DIM>| c.lateral.abs() - pantograph.strips[c.indices[1]].half_width;
            let nearest = contacts.clone().filter(|c| c.has_wire);
            let nearest =
                nearest.min_by(|a, b| distance_outside(a).total_cmp(&distance_outside(b)));
            if let Some(contact) = nearest.or_else(|| contacts.next()) {
                return Err(CoreError::OutOfReach {
                    pantograph: j,
                    position: contact.along(end),
                    lateral: contact.lateral,
                    half_width: pantograph.strips[contact.indices[1]].half_width,
                    step,
                });
            }
        }
        Ok(())
    }
}
