//! Line and collectors of a session between two steps, as they are read.

use crate::integrator::wire_model::WireModel;
use crate::session::collectors::Collectors;
use crate::simulation::motion::Motion;
use crate::slideline::local_compliance::LocalCompliance;
use crate::slideline::point::SlidelinePoint;

/// Line, contacts and collectors where the last step has left them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Snapshot<'a, const DIM: usize, const D: usize> {
    pub(crate) line: &'a WireModel<DIM, D>,
    pub(crate) motion: &'a Motion<DIM, D>,
    pub(crate) collectors: &'a Collectors<DIM>,
    /// Position along the track, m.
    pub(crate) position: f64,
    /// Speed, m/s.
    pub(crate) speed: f64,
}

/// Point at which a contact or a collector touches the wire.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TouchPoint<const DIM: usize> {
    /// Index of the slideline.
    pub(crate) slideline: usize,
    pub(crate) point: SlidelinePoint<DIM>,
    pub(crate) compliance: LocalCompliance,
}

impl<const DIM: usize, const D: usize> Snapshot<'_, DIM, D> {
    /// Point of the wire at contact or collector `number`, moved along the track by `shift`, m;
    /// none where there is no wire.
    pub(crate) fn touch_point(&self, number: usize, shift: f64) -> Option<TouchPoint<DIM>> {
        let (slideline, x, near) = match self.collectors.all.get(number) {
            Some(collector) => (
                0,
                self.position - collector.behind,
                self.collectors.points[number].element,
            ),
            None => {
                let contact = &self.motion.contacts.all[number];
                let x = contact.along(self.position);
                (contact.indices[2], x, contact.ends[1].element)
            }
        };
        let point = self.line.slidelines[slideline].locate(x + shift, near)?;
        Some(TouchPoint {
            slideline,
            point,
            compliance: self.line.slidelines[slideline].compliance_at(&point),
        })
    }
}
