//! What a loop reads of the wire beyond the mesh: see [`yields`](super::yields).

use super::live::{Live, lost};
use super::live_parts::Parts;
use super::path::Path;
use super::place::Place;
use super::yields::Yield;
use crate::error::CoreError;

/// Half of the way over which slopes are taken, m: kinks are rounded over a tenth of a metre, so the
/// square of this is nothing; and nothing is what rounding of a place adds.
const NEARBY: f64 = 1e-4;

impl<const DIM: usize, const D: usize> Live<DIM, D> {
    /// Add to the heights and their rates what the wires are higher than the mesh.
    pub(super) fn add_raised(&mut self) -> Result<(), CoreError> {
        if self.p.lanes.iter().all(Path::is_rigid) {
            return Ok(());
        }
        let parts = self.parts.as_ref().ok_or_else(lost)?;
        let (_, speed) = self.place();
        for number in 0..self.reading.height.len() {
            let Some((lane, place, yields)) = self.spot(parts, number, 0.0) else {
                continue;
            };
            let here = self.raised(parts, (lane, &place, &yields), 0.0);
            let [mut slope, mut way] = [0.0; 2];
            for shift in [NEARBY, -NEARBY] {
                let moved = self.spot(parts, number, shift);
                if let Some((lane, place, yields)) = moved {
                    let there = self.raised(parts, (lane, &place, &yields), shift);
                    slope += (there - here) * shift.signum();
                    way += NEARBY;
                }
            }
            let rates = &parts.state.links.rate;
            let pulled = yields
                .pulls()
                .map(|(l, rise)| self.p.eased(l, rise) * rates[l]);
            let rate = pulled.sum::<f64>() + if way > 0.0 { speed * slope / way } else { 0.0 };
            self.reading.height[number] += here;
            self.reading.rate[number] += rate;
        }
        Ok(())
    }

    /// Lane, place and yield of what presses against the wire, moved along by a little.
    fn spot(
        &self,
        parts: &Parts<DIM, D>,
        number: usize,
        shift: f64,
    ) -> Option<(usize, Place<DIM>, Yield)> {
        let (position, _) = self.place();
        let (lane, x, near) = match self.collectors.get(number) {
            Some(c) => (0, position - c.behind, self.places[number].element),
            None => {
                let contact = &parts.contacts.all[number];
                (
                    contact.of[2],
                    contact.along(position),
                    contact.ends[1].element,
                )
            }
        };
        let place = self.p.lanes[lane].locate(x + shift, near)?;
        Some((lane, place, self.p.lanes[lane].yield_at(&place)))
    }

    /// Height above the mesh at the end of the step, with the forces and corrections of the step, when all
    /// that presses has moved along by a little.
    fn raised(
        &self,
        parts: &Parts<DIM, D>,
        (lane, place, yields): (usize, &Place<DIM>, &Yield),
        shift: f64,
    ) -> f64 {
        let (p, correction) = (&self.p, &parts.unilateral.correction);
        let by_link = |(l, rise): (usize, f64)| {
            let slack = correction[l] - p.line.links[l].rest_correction();
            p.eased(l, rise) * parts.state.links.elongation[l] + rise * slack
        };
        let mut height = yields.rise + yields.pulls().map(by_link).sum::<f64>();
        for (number, force) in self
            .reading
            .force
            .iter()
            .enumerate()
            .filter(|(_, f)| **f != 0.0)
        {
            if let Some((other, at, of)) = self.spot(parts, number, shift) {
                let missing = if other == lane {
                    p.lanes[lane].between(place, &at)
                } else {
                    0.0
                };
                height += force * (missing - p.carried(yields, &of));
            }
        }
        height
    }
}
