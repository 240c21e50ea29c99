//! Forces from outside put on for a step of a loop, and the wires that they act on.

use super::live::{Live, STEP, lost};
use super::loads::Load;
use super::path::Path;
use super::place::Place;
use crate::error::CoreError;

impl<const DIM: usize, const D: usize> Live<DIM, D> {
    /// Put on the forces of the step.
    pub(super) fn push(&mut self, forces: &[f64]) -> Result<(), CoreError> {
        let Some(parts) = &mut self.parts else {
            return Err(lost());
        };
        for (rider, force) in parts.riders.iter_mut().zip(forces) {
            rider.actuator.force = *force;
        }
        parts.check_end(&self.p.lanes, self.travel.positions[STEP + 1])?;
        parts.state.links.given.clear();
        let old = self.p.coefficients.old;
        let x = &self.travel.positions;
        let balance = (1.0 - old) * x[STEP + 1] + old * x[STEP];
        for (number, collector) in self.collectors.iter().enumerate() {
            let (lane, near) = (&self.p.lanes[0], self.places[number].element);
            let along = balance - collector.behind;
            let place = locate(lane, along, near, number)?;
            // The step must not carry it off the wire either.
            locate(lane, x[STEP + 1] - collector.behind, place.element, number)?;
            let lateral = place.lateral + aside::<DIM, D>(&place, &parts.state.u);
            if lateral.abs() > collector.half_width {
                return Err(CoreError::OutOfReach {
                    rider: number,
                    position: along,
                    lateral,
                    half_width: collector.half_width,
                    step: STEP,
                });
            }
            let (yields, load) = (lane.yield_at(&place), &mut self.travel.loads[number]);
            let links = || yields.pulls().map(|(l, rise)| (l, self.p.eased(l, rise)));
            let eased = links().map(|(link, share)| (link, share * forces[number]));
            parts.state.links.given.extend(eased);
            let pulled = links().flat_map(|(link, share)| self.p.line.links[link].shares(share));
            press::<DIM, D>(load, &place, self.travel.friction, forces[number], pulled);
        }
        self.look(balance)
    }

    /// Tell an explicit line where it is read.
    fn look(&mut self, balance: f64) -> Result<(), CoreError> {
        let grid = self
            .parts
            .as_mut()
            .and_then(|parts| parts.state.grid.as_mut());
        let (Some(steps), Some(grid)) = (self.p.explicit_steps(), grid) else {
            return Ok(());
        };
        if self.collectors.is_empty() {
            return Ok(());
        }
        let lane = &self.p.lanes[0];
        let found = self.places.iter_mut().zip(&self.collectors).enumerate();
        for (number, (place, collector)) in found {
            *place = locate(lane, balance - collector.behind, place.element, number)?;
        }
        steps.look_at(
            grid,
            self.places.iter().flat_map(|place| lane.around(place)),
        );
        Ok(())
    }
}

/// The wire at a collector, by its number.
pub(super) fn locate<const DIM: usize>(
    lane: &Path<DIM>,
    position: f64,
    near: usize,
    number: usize,
) -> Result<Place<DIM>, CoreError> {
    lane.locate(position, near).ok_or(CoreError::OffWire {
        rider: number,
        position,
        step: STEP,
    })
}

/// Displacement of the wire to the side, m.
pub(super) fn aside<const DIM: usize, const D: usize>(place: &Place<DIM>, u: &[[f64; D]]) -> f64 {
    if DIM < 3 {
        0.0
    } else {
        place.displacement(u, 1)
    }
}

/// Let a load be a force F upwards at a place, with the friction μ F along, and what it takes from links.
fn press<const DIM: usize, const D: usize>(
    load: &mut Load,
    place: &Place<DIM>,
    friction: f64,
    force: f64,
    pulled: impl Iterator<Item = (usize, usize, f64)>,
) {
    load.sizes.fill(force);
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
