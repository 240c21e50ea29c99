//! The contacts of a run: every strip of every rider on every lane.
//!
//! A contact takes part in a step when its lane has wire at the place of the strip at the time of
//! balance, and that wire lies within the half width of the strip. The lateral place of the wire, and
//! with it e(y) of the [strip](crate::pantograph::strip), is taken at the start of the step.

use crate::error::CoreError;
use crate::pantograph::strip::Strip;
use crate::pantograph::system::{Pantograph, PantographState, inner};
use crate::slideline::Slideline;
use crate::slideline::point::{Nodal, SlidelinePoint};
use crate::slideline::residual_flexibility::LocalCompliance;

/// A strip of a rider on a lane.
#[derive(Debug, Clone)]
pub struct Contact<const DIM: usize> {
    /// Rider, strip of it, and lane, by their numbers.
    pub(crate) of: [usize; 3],
    /// Distance of the rider behind the first, and of the strip behind its reference point, m.
    behind: [f64; 2],
    /// Whether it takes part in the present step.
    pub(crate) meets: bool,
    /// Whether it did not in the step before.
    is_new: bool,
    /// Whether the lane has wire at the strip; only then `place` is of this step.
    pub(crate) has_wire: bool,
    /// Where it acts, at the time of balance.
    pub(crate) place: SlidelinePoint<DIM>,
    /// What the wire yields there beyond the mesh.
    pub(crate) yields: LocalCompliance,
    /// The same before and after the step.
    pub(crate) ends: [SlidelinePoint<DIM>; 2],
    /// Lateral place of the wire at the start of the step, m.
    pub(crate) lateral: f64,
    /// e(y).
    pub(crate) vector: Vec<f64>,
    /// A⁻¹ e, the response of the rider's increment to a unit pull on the strip.
    pub(crate) column: Vec<f64>,
    /// A⁻¹ e at each knot.
    columns: Vec<Vec<f64>>,
    /// How far the strip rises under the wire as that slides sideways, m: (e − e of the step before)ᵀu.
    pub(crate) slid: f64,
}

impl<const DIM: usize> Contact<DIM> {
    /// Number of its rider.
    pub(crate) fn rider(&self) -> usize {
        self.of[0]
    }

    fn strip<'a>(&self, riders: &'a [Pantograph]) -> &'a Strip {
        &riders[self.of[0]].strips[self.of[1]]
    }

    /// Coordinate along the track when the first rider is at `position`, m.
    pub(crate) fn along(&self, position: f64) -> f64 {
        position - self.behind[0] - self.behind[1]
    }

    /// Lateral place of the wire before the step.
    fn aside<const D: usize>(&self, u: &(impl Nodal<D> + ?Sized)) -> f64 {
        if DIM < 3 {
            return 0.0;
        }
        self.place.lateral + self.place.displacement(u, 1)
    }
}

/// All contacts: rider by rider, strip by strip, lane by lane.
#[derive(Debug, Clone)]
pub struct Contacts<const DIM: usize> {
    pub(crate) all: Vec<Contact<DIM>>,
    /// Those that take part in the present step.
    pub(crate) active: Vec<usize>,
    pub(crate) lanes: usize,
}

impl<const DIM: usize> Contacts<DIM> {
    /// Contacts of `riders`, which follow the first at `distances`, at the start of a run.
    ///
    /// # Errors
    /// Those of [`Contacts::find`].
    pub(crate) fn new<const D: usize>(
        riders: &[Pantograph],
        distances: &[f64],
        lanes: &[Slideline<DIM>],
        position: f64,
        u: &(impl Nodal<D> + ?Sized),
    ) -> Result<Self, CoreError> {
        let mut contacts = Self::blank(riders, distances, lanes.len());
        contacts.find(riders, lanes, u, [position; 3], 0)?;
        for contact in &mut contacts.all {
            let strip = &riders[contact.of[0]].strips[contact.of[1]];
            strip.read(&strip.vectors, contact.lateral, &mut contact.vector);
        }
        Ok(contacts)
    }

    /// The same, without a place.
    pub(crate) fn blank(riders: &[Pantograph], distances: &[f64], lanes: usize) -> Self {
        let mut all = Vec::new();
        for (j, (rider, &distance)) in riders.iter().zip(distances).enumerate() {
            for (s, strip) in rider.strips.iter().enumerate() {
                all.extend((0..lanes).map(|lane| Contact {
                    of: [j, s, lane],
                    behind: [distance, strip.offset],
                    meets: false,
                    is_new: true,
                    has_wire: false,
                    place: SlidelinePoint::default(),
                    yields: LocalCompliance::default(),
                    ends: [SlidelinePoint::default(); 2],
                    lateral: 0.0,
                    vector: strip.vectors[0].clone(),
                    column: Vec::new(),
                    columns: Vec::new(),
                    slid: 0.0,
                }));
            }
        }
        Self {
            active: Vec::with_capacity(all.len()),
            all,
            lanes,
        }
    }

    /// Take down the responses of the riders to their strips.
    pub(crate) fn respond(&mut self, riders: &[PantographState]) {
        for contact in &mut self.all {
            let rider = &riders[contact.of[0]];
            let strip = &rider.rider.strips[contact.of[1]];
            let columns = strip.vectors.iter().map(|e| rider.response(e));
            contact.columns = columns.collect();
            contact.column = contact.columns[0].clone();
            strip.read(&contact.columns, contact.lateral, &mut contact.column);
        }
    }

    /// Find the places of the active contacts anew, before the first step.
    pub(crate) fn follow(&mut self, lanes: &[Slideline<DIM>], position: f64) {
        for &i in &self.active {
            let contact = &mut self.all[i];
            let lane = &lanes[contact.of[2]];
            contact.place = lane.on_wire(contact.along(position), contact.place.element);
            contact.ends = [contact.place; 2];
        }
    }

    /// Those that take part.
    pub(crate) fn active(&self) -> impl Iterator<Item = &Contact<DIM>> {
        self.active.iter().map(|&i| &self.all[i])
    }

    /// Contacts of a step in which the first rider stands at the given positions: at its start, at the
    /// time of balance, at its end.
    ///
    /// # Errors
    /// [`CoreError::OffWire`], [`CoreError::OutOfReach`].
    pub(crate) fn find<const D: usize>(
        &mut self,
        riders: &[Pantograph],
        lanes: &[Slideline<DIM>],
        u: &(impl Nodal<D> + ?Sized),
        positions: [f64; 3],
        step: usize,
    ) -> Result<(), CoreError> {
        self.active.clear();
        for (i, contact) in self.all.iter_mut().enumerate() {
            let lane = &lanes[contact.of[2]];
            contact.seek(contact.strip(riders), lane, u, positions);
            if contact.has_wire {
                contact.yields = lane.yield_at(&contact.place);
            }
            if contact.meets {
                self.active.push(i);
            }
        }
        self.check(riders, lanes, positions, step)
    }

    /// Take e(y) of the contacts whose wire lies elsewhere on the strip than a step ago.
    pub(crate) fn slide(&mut self, riders: &[PantographState]) {
        for &i in &self.active {
            let contact = &mut self.all[i];
            let rider = &riders[contact.of[0]];
            let strip = &rider.rider.strips[contact.of[1]];
            contact.slid = 0.0;
            if strip.knots.len() > 1 {
                let before = inner(&contact.vector, &rider.u);
                contact.read(strip);
                if !contact.is_new {
                    contact.slid = inner(&contact.vector, &rider.u) - before;
                }
            }
        }
    }
}

impl<const DIM: usize> Contact<DIM> {
    /// Take e(y) and A⁻¹ e where the wire lies.
    pub(crate) fn read(&mut self, strip: &Strip) {
        strip.read(&strip.vectors, self.lateral, &mut self.vector);
        strip.read(&self.columns, self.lateral, &mut self.column);
    }

    /// Its places in a step, and whether it takes part.
    fn seek<const D: usize>(
        &mut self,
        strip: &Strip,
        lane: &Slideline<DIM>,
        u: &(impl Nodal<D> + ?Sized),
        [start, balance, end]: [f64; 3],
    ) {
        self.is_new = !std::mem::take(&mut self.meets);
        let near = self.ends[1].element;
        let found = lane.locate(self.along(balance), near);
        self.has_wire = found.is_some();
        let Some(place) = found else {
            return;
        };
        self.place = place;
        if strip.looks_aside() {
            self.lateral = self.aside(u);
        }
        self.meets = self.lateral.abs() <= strip.half_width;
        if self.is_new {
            self.ends[1] = lane.on_wire(self.along(start), place.element);
        }
        self.ends[0] = self.ends[1];
        if self.meets {
            self.ends[1] = match lane.locate(self.along(end), near) {
                Some(end) if lane.is_one_wire(&end, &place) => end,
                // The wire ends within the step.
                _ => lane.on_wire(self.along(end), place.element),
            };
        }
    }
}
