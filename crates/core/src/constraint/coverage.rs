//! Whether every rider has a wire in reach.

use crate::constraint::contacts::{Contact, Contacts};
use crate::error::CoreError;
use crate::pantograph::system::Pantograph;
use crate::slideline::Slideline;

impl<const DIM: usize> Contacts<DIM> {
    /// Every strip has wire before and behind the step, every rider a contact.
    pub(crate) fn check(
        &self,
        riders: &[Pantograph],
        lanes: &[Slideline<DIM>],
        [_, _, end]: [f64; 3],
        step: usize,
    ) -> Result<(), CoreError> {
        for of_strip in self.all.chunks(self.lanes) {
            let position = of_strip[0].along(end);
            let is_on = |c: &Contact<DIM>| {
                let near = c.ends[1].element;
                c.meets || lanes[c.of[2]].locate(position, near).is_some()
            };
            if !of_strip.iter().any(|c| c.has_wire) || !of_strip.iter().any(is_on) {
                return Err(CoreError::OffWire {
                    rider: of_strip[0].rider(),
                    position,
                    step,
                });
            }
        }
        for (j, rider) in riders.iter().enumerate() {
            let mut own = self.all.iter().filter(|c| c.rider() == j);
            if own.clone().any(|c| c.meets) {
                continue;
            }
            // The wire that is least far out.
            let out = |c: &&Contact<DIM>| c.lateral.abs() - rider.strips[c.of[1]].half_width;
            let least = own.clone().filter(|c| c.has_wire);
            let least = least.min_by(|a, b| out(a).total_cmp(&out(b)));
            if let Some(contact) = least.or_else(|| own.next()) {
                return Err(CoreError::OutOfReach {
                    rider: j,
                    position: contact.along(end),
                    lateral: contact.lateral,
                    half_width: rider.strips[contact.of[1]].half_width,
                    step,
                });
            }
        }
        Ok(())
    }
}
