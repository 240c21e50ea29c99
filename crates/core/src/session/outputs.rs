//! What a loop reads from the line after each step.

use crate::error::CoreError;
use crate::integrator::WireState;
use crate::session::Session;
use crate::session::forces::{aside, locate};
use crate::slideline::Slideline;
use crate::slideline::point::SlidelinePoint;

/// The wire where something touches it, and the riders. Where forces are given there is one value for
/// each collector; where riders are simulated, one for each contact (strip on a lane), and those of
/// the riders.
#[derive(Debug, Clone, Default)]
pub struct Outputs {
    /// Contacts: rider, strip and lane of each; empty where forces are given.
    pub contacts: Vec<[usize; 3]>,
    /// Contact force, N, at the time of balance of the step; the given one where forces are given.
    pub force: Vec<f64>,
    /// Height of the wire, m; this and the next two are NaN where a lane has no wire.
    pub height: Vec<f64>,
    /// Lateral position of the wire, m; zero when planar.
    pub lateral: Vec<f64>,
    /// Rate of the height of the wire at the place that moves along, m/s.
    pub rate: Vec<f64>,
    /// Displacement of all coordinates of all riders since the start, m.
    pub displacement: Vec<f64>,
    /// Their velocity, m/s.
    pub velocity: Vec<f64>,
}

impl Outputs {
    pub(crate) fn new(contacts: Vec<[usize; 3]>, count: usize, coordinates: usize) -> Self {
        let zero = vec![0.0; count];
        Self {
            contacts,
            force: zero.clone(),
            height: zero.clone(),
            lateral: zero.clone(),
            rate: zero,
            displacement: vec![0.0; coordinates],
            velocity: vec![0.0; coordinates],
        }
    }

    /// Take down the wire at a place that moves along it with `speed`; tells whether it is finite.
    fn wire<const DIM: usize, const D: usize>(
        &mut self,
        number: usize,
        (lane, x, place): (&Slideline<DIM>, f64, &SlidelinePoint<DIM>),
        line: &WireState<D>,
        speed: f64,
    ) -> bool {
        let (u, v) = (&line.displacement(), &line.velocity());
        self.height[number] = place.height + place.displacement(u, DIM - 1);
        self.lateral[number] = place.lateral + aside(place, u);
        self.rate[number] = place.displacement(v, DIM - 1) + speed * lane.slope(x, place, u);
        self.height[number].is_finite() && self.rate[number].is_finite()
    }

    fn nowhere(&mut self, number: usize) {
        for list in [&mut self.height, &mut self.lateral, &mut self.rate] {
            list[number] = f64::NAN;
        }
    }
}

impl<const DIM: usize, const D: usize> Session<DIM, D> {
    /// Read the line and the riders where they stand.
    pub(crate) fn read(&mut self) -> Result<(), CoreError> {
        self.read_mesh()?;
        self.add_raised();
        Ok(())
    }

    fn read_mesh(&mut self) -> Result<(), CoreError> {
        let (motion, out) = (&self.state.motion, &mut self.reading);
        let (position, speed, mut is_sound) = (self.position, self.speed, true);
        for (number, collector) in self.collectors.iter().enumerate() {
            let lane = &self.fixed.line.lanes[0];
            let x = position - collector.behind;
            let near = self.places[number].element;
            let place = locate(lane, x, near, (number, motion.steps))?;
            self.places[number] = place;
            out.force[number] = self.forces[number];
            is_sound &= out.wire(number, (lane, x, &place), &motion.line, speed);
        }
        for (number, contact) in motion.contacts.all.iter().enumerate() {
            let (lane, x) = (
                &self.fixed.line.lanes[contact.of[2]],
                contact.along(position),
            );
            out.force[number] = motion.unilateral.force[number];
            match lane.locate(x, contact.ends[1].element) {
                Some(place) => is_sound &= out.wire(number, (lane, x, &place), &motion.line, speed),
                None => out.nowhere(number),
            }
        }
        let riders = motion.riders.iter().zip(&motion.start_u);
        let moved = riders.flat_map(|(r, start)| r.u.iter().zip(start).map(|(u, s)| u - s));
        out.displacement
            .iter_mut()
            .zip(moved)
            .for_each(|(o, new)| *o = new);
        let velocities = motion.riders.iter().flat_map(|r| &r.v);
        out.velocity
            .iter_mut()
            .zip(velocities)
            .for_each(|(o, new)| *o = *new);
        let numbers = out.force.iter().chain(&out.displacement);
        if is_sound && numbers.chain(&out.velocity).all(|v| v.is_finite()) {
            return Ok(());
        }
        let (what, step) = ("the motion", motion.steps);
        Err(CoreError::NotFinite { what, step })
    }
}
