//! Forces from outside put on for a step of a loop, and the wires that they act on.

use crate::constraint::contacts::Contact;
use crate::error::CoreError;
use crate::linear::loads::Load;
use crate::session::Session;
use crate::slideline::Slideline;
use crate::slideline::point::{Nodal, SlidelinePoint};

impl<const DIM: usize, const D: usize> Session<DIM, D> {
    /// Put on the forces of the step, with the loop at the start of the step, at the time of balance,
    /// and at its end.
    pub(crate) fn push(
        &mut self,
        forces: &[f64],
        [_, balance, end]: [f64; 3],
    ) -> Result<(), CoreError> {
        self.check_end(end)?;
        let step = self.steps();
        let motion = &mut self.state.motion;
        for (rider, force) in motion.riders.iter_mut().zip(forces) {
            rider.actuator.force = *force;
        }
        motion.line.links.given.clear();
        let old = self.fixed.line.coefficients.old;
        for (number, collector) in self.collectors.iter().enumerate() {
            let (lane, near) = (&self.fixed.line.lanes[0], self.places[number].element);
            let along = balance - collector.behind;
            let place = locate(lane, along, near, (number, step))?;
            // The step must not carry it off the wire either.
            locate(lane, end - collector.behind, place.element, (number, step))?;
            let lateral = place.lateral + aside(&place, &motion.line.displacement());
            if lateral.abs() > collector.half_width {
                return Err(CoreError::OutOfReach {
                    rider: number,
                    position: along,
                    lateral,
                    half_width: collector.half_width,
                    step,
                });
            }
            let (yields, load) = (lane.yield_at(&place), &mut self.loads[number]);
            let links = || {
                yields
                    .pulls()
                    .map(|(l, rise)| (l, self.fixed.line.eased(l, rise)))
            };
            let eased = links().map(|(link, share)| (link, share * forces[number]));
            motion.line.links.given.extend(eased);
            let pulled =
                links().flat_map(|(link, share)| self.fixed.line.line.links[link].shares(share));
            press::<DIM, D>(load, &place, self.fixed.friction, pulled);
            // As histories are read: at the time of balance.
            let force = forces[number];
            self.forces[number] = force;
            self.sizes[number] = (1.0 - old) * force + old * force;
        }
        self.look(balance)
    }

    /// A step of a run may end beyond the wire, because none follows; a step of a loop may not.
    fn check_end(&self, position: f64) -> Result<(), CoreError> {
        let lanes = &self.fixed.line.lanes;
        for of_strip in self.state.motion.contacts.all.chunks(lanes.len()) {
            let has_wire = |c: &Contact<DIM>| {
                let lane = &lanes[c.of[2]];
                lane.locate(c.along(position), c.ends[1].element).is_some()
            };
            if !of_strip.iter().any(has_wire) {
                return Err(CoreError::OffWire {
                    rider: of_strip[0].rider(),
                    position: of_strip[0].along(position),
                    step: self.steps(),
                });
            }
        }
        Ok(())
    }

    /// Tell an explicit line where it is read.
    fn look(&mut self, balance: f64) -> Result<(), CoreError> {
        if self.collectors.is_empty() {
            return Ok(());
        }
        let (step, lane) = (self.steps(), &self.fixed.line.lanes[0]);
        let found = self.places.iter_mut().zip(&self.collectors).enumerate();
        for (number, (place, collector)) in found {
            let along = balance - collector.behind;
            *place = locate(lane, along, place.element, (number, step))?;
        }
        let nodes = self.places.iter().flat_map(|place| lane.around(place));
        self.fixed.line.look_at(&mut self.state.motion.line, nodes);
        Ok(())
    }
}

/// The wire at a collector, by its number, in a step.
pub(crate) fn locate<const DIM: usize>(
    lane: &Slideline<DIM>,
    position: f64,
    near: usize,
    (number, step): (usize, usize),
) -> Result<SlidelinePoint<DIM>, CoreError> {
    lane.locate(position, near).ok_or(CoreError::OffWire {
        rider: number,
        position,
        step,
    })
}

/// Displacement of the wire to the side, m.
pub(crate) fn aside<const DIM: usize, const D: usize>(
    place: &SlidelinePoint<DIM>,
    u: &(impl Nodal<D> + ?Sized),
) -> f64 {
    if DIM < 3 {
        0.0
    } else {
        place.displacement(u, 1)
    }
}

/// Let a load be a unit force upwards at a place, with the friction μ along, and what it takes from links.
fn press<const DIM: usize, const D: usize>(
    load: &mut Load,
    place: &SlidelinePoint<DIM>,
    friction: f64,
    pulled: impl Iterator<Item = (usize, usize, f64)>,
) {
    let up = place.shares::<D>(DIM - 1);
    let along = place
        .shares::<D>(0)
        .map(|(n, c, share)| (n, c, friction * share));
    let rest = std::iter::repeat((0, 0, 0.0));
    let all = up.chain(along).chain(pulled).chain(rest);
    for (part, new) in load.pattern.iter_mut().zip(all) {
        *part = new;
    }
}
