//! What a loop reads of the wire beyond the mesh: see [`yields`](crate::slideline::residual_flexibility).

use crate::session::Session;
use crate::slideline::Slideline;
use crate::slideline::point::SlidelinePoint;
use crate::slideline::residual_flexibility::LocalCompliance;

/// Half of the way over which slopes are taken, m: kinks are rounded over a tenth of a metre, so the
/// square of this is nothing; and nothing is what rounding of a place adds.
const NEARBY: f64 = 1e-4;

impl<const DIM: usize, const D: usize> Session<DIM, D> {
    /// Add to the heights and their rates what the wires are higher than the mesh.
    pub(crate) fn add_raised(&mut self) {
        if self.fixed.line.lanes.iter().all(Slideline::is_rigid) {
            return;
        }
        let (_, speed) = self.place();
        for number in 0..self.reading.height.len() {
            let Some((lane, place, yields)) = self.spot(number, 0.0) else {
                continue;
            };
            let here = self.raised((lane, &place, &yields), 0.0);
            let [mut slope, mut way] = [0.0; 2];
            for shift in [NEARBY, -NEARBY] {
                let moved = self.spot(number, shift);
                if let Some((lane, place, yields)) = moved {
                    let there = self.raised((lane, &place, &yields), shift);
                    slope += (there - here) * shift.signum();
                    way += NEARBY;
                }
            }
            let rates = &self.state.motion.line.links.rate;
            let pulled = yields
                .pulls()
                .map(|(l, rise)| self.fixed.line.eased(l, rise) * rates[l]);
            let rate = pulled.sum::<f64>() + if way > 0.0 { speed * slope / way } else { 0.0 };
            self.reading.height[number] += here;
            self.reading.rate[number] += rate;
        }
    }

    /// Lane, place and yield of what presses against the wire, moved along by a little.
    fn spot(
        &self,
        number: usize,
        shift: f64,
    ) -> Option<(usize, SlidelinePoint<DIM>, LocalCompliance)> {
        let (position, _) = self.place();
        let (lane, x, near) = match self.collectors.get(number) {
            Some(c) => (0, position - c.behind, self.places[number].element),
            None => {
                let contact = &self.state.motion.contacts.all[number];
                (
                    contact.of[2],
                    contact.along(position),
                    contact.ends[1].element,
                )
            }
        };
        let place = self.fixed.line.lanes[lane].locate(x + shift, near)?;
        Some((lane, place, self.fixed.line.lanes[lane].yield_at(&place)))
    }

    /// Height above the mesh at the end of the step, with the forces and corrections of the step, when all
    /// that presses has moved along by a little.
    fn raised(
        &self,
        (lane, place, yields): (usize, &SlidelinePoint<DIM>, &LocalCompliance),
        shift: f64,
    ) -> f64 {
        let (p, motion) = (&self.fixed.line, &self.state.motion);
        let correction = &motion.unilateral.correction;
        let by_link = |(l, rise): (usize, f64)| {
            let slack = correction[l] - p.line.links[l].rest_correction();
            p.eased(l, rise) * motion.line.links.elongation[l] + rise * slack
        };
        let mut height = yields.rise + yields.pulls().map(by_link).sum::<f64>();
        for (number, force) in self
            .reading
            .force
            .iter()
            .enumerate()
            .filter(|(_, f)| **f != 0.0)
        {
            if let Some((other, at, of)) = self.spot(number, shift) {
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
