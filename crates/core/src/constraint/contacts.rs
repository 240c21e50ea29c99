//! Contacts of a run: every strip of every pantograph on every slideline.
//!
//! A contact takes part in a step when its slideline has wire at the position of the strip at the
//! time of balance, and that wire lies within the half width of the strip. The lateral position of
//! the wire, and with it e(y) of the [strip](crate::pantograph::strip), is taken at the start of
//! the step.

use crate::error::CoreError;
use crate::linalg::small::inner;
use crate::pantograph::model::Pantograph;
use crate::pantograph::state::PantographState;
use crate::pantograph::strip::Strip;
use crate::slideline::Slideline;
use crate::slideline::local_compliance::LocalCompliance;
use crate::slideline::point::{Nodal, SlidelinePoint};

/// Contact of a strip of a pantograph with a slideline.
#[derive(Debug, Clone)]
pub struct Contact<const DIM: usize> {
    /// Numbers of pantograph, strip and slideline.
    pub(crate) indices: [usize; 3],
    /// Distance of the pantograph behind the first one, and of the strip behind its reference
    /// point, m.
    behind: [f64; 2],
    /// True when the contact takes part in the present step.
    pub(crate) is_active: bool,
    /// True when the contact did not take part in the step before.
    is_new: bool,
    /// True when the slideline has wire at the strip; only then `point` is of this step.
    pub(crate) has_wire: bool,
    /// Point of the slideline at the time of balance.
    pub(crate) point: SlidelinePoint<DIM>,
    /// Local compliance of the wire at `point`, beyond the mesh.
    pub(crate) compliance: LocalCompliance,
    /// Points of the slideline before and after the step.
    pub(crate) ends: [SlidelinePoint<DIM>; 2],
    /// Lateral position of the wire at the start of the step, m.
    pub(crate) lateral: f64,
    /// Vector e(y) of the strip: its height is eᵀu.
    pub(crate) vector: Vec<f64>,
    /// Column A⁻¹e: increment of the pantograph under a unit force on the strip.
    pub(crate) column: Vec<f64>,
    /// Columns A⁻¹e at each knot of the strip.
    columns: Vec<Vec<f64>>,
    /// Rise of the strip under a wire that slides sideways, m: (e − e of the step before)ᵀu.
    pub(crate) lateral_rise: f64,
}

impl<const DIM: usize> Contact<DIM> {
    /// Returns a contact at a point of the first slideline, given by its number, without a strip.
    pub(crate) fn at_point(number: usize, point: SlidelinePoint<DIM>) -> Self {
        Self {
            indices: [number, 0, 0],
            behind: [0.0; 2],
            is_active: true,
            is_new: false,
            has_wire: true,
            point,
            compliance: LocalCompliance::default(),
            ends: [point; 2],
            lateral: 0.0,
            vector: Vec::new(),
            column: Vec::new(),
            columns: Vec::new(),
            lateral_rise: 0.0,
        }
    }

    /// Returns the number of the pantograph.
    pub(crate) fn pantograph(&self) -> usize {
        self.indices[0]
    }

    fn strip<'a>(&self, pantographs: &'a [Pantograph]) -> &'a Strip {
        &pantographs[self.indices[0]].strips[self.indices[1]]
    }

    /// Returns the coordinate along the track when the first pantograph is at `position`, m.
    pub(crate) fn along(&self, position: f64) -> f64 {
        position - self.behind[0] - self.behind[1]
    }

    /// Returns the lateral position of the wire before the step, m.
    fn lateral_position<const D: usize>(&self, u: &(impl Nodal<D> + ?Sized)) -> f64 {
        if DIM < 3 {
            return 0.0;
        }
        self.point.lateral + self.point.displacement(u, 1)
    }
}

/// All contacts: pantograph by pantograph, strip by strip, slideline by slideline.
#[derive(Debug, Clone)]
pub struct Contacts<const DIM: usize> {
    pub(crate) all: Vec<Contact<DIM>>,
    /// Numbers of the contacts that take part in the present step.
    pub(crate) active: Vec<usize>,
    pub(crate) slidelines: usize,
}

impl<const DIM: usize> Contacts<DIM> {
    /// Returns the contacts of `pantographs`, which follow the first one at `distances` (m), at the
    /// start of a run.
    ///
    /// # Errors
    /// As [`Contacts::search`].
    pub(crate) fn new<const D: usize>(
        pantographs: &[Pantograph],
        distances: &[f64],
        slidelines: &[Slideline<DIM>],
        position: f64,
        u: &(impl Nodal<D> + ?Sized),
    ) -> Result<Self, CoreError> {
        let mut contacts = Self::unplaced(pantographs, distances, slidelines.len());
        contacts.search(pantographs, slidelines, u, [position; 3], 0)?;
        for contact in &mut contacts.all {
            let strip = &pantographs[contact.indices[0]].strips[contact.indices[1]];
            strip.interpolate(&strip.vectors, contact.lateral, &mut contact.vector);
        }
        Ok(contacts)
    }

    /// Returns the contacts of `pantographs` without points on the wire.
    pub(crate) fn unplaced(
        pantographs: &[Pantograph],
        distances: &[f64],
        slidelines: usize,
    ) -> Self {
        let mut all = Vec::new();
        for (j, (pantograph, &distance)) in pantographs.iter().zip(distances).enumerate() {
            for (s, strip) in pantograph.strips.iter().enumerate() {
                all.extend((0..slidelines).map(|slideline| Contact {
                    indices: [j, s, slideline],
                    behind: [distance, strip.offset],
                    is_active: false,
                    is_new: true,
                    has_wire: false,
                    point: SlidelinePoint::default(),
                    compliance: LocalCompliance::default(),
                    ends: [SlidelinePoint::default(); 2],
                    lateral: 0.0,
                    vector: strip.vectors[0].clone(),
                    column: Vec::new(),
                    columns: Vec::new(),
                    lateral_rise: 0.0,
                }));
            }
        }
        Self {
            active: Vec::with_capacity(all.len()),
            all,
            slidelines,
        }
    }

    /// Computes the columns A⁻¹e of all contacts.
    pub(crate) fn compute_columns(&mut self, pantographs: &[PantographState]) {
        for contact in &mut self.all {
            let pantograph = &pantographs[contact.indices[0]];
            let strip = &pantograph.model.strips[contact.indices[1]];
            let columns = strip.vectors.iter().map(|e| pantograph.response(e));
            contact.columns = columns.collect();
            contact.column = contact.columns[0].clone();
            strip.interpolate(&contact.columns, contact.lateral, &mut contact.column);
        }
    }

    /// Updates the columns A⁻¹e of the contacts of an external pantograph, given by its number.
    pub(crate) fn update_columns(&mut self, number: usize, pantograph: &PantographState) {
        let contacts = self.all.iter_mut().filter(|c| c.pantograph() == number);
        for contact in contacts {
            let strip = &pantograph.model.strips[contact.indices[1]];
            for (column, e) in contact.columns.iter_mut().zip(&strip.vectors) {
                pantograph.write_response(e, column);
            }
            strip.interpolate(&contact.columns, contact.lateral, &mut contact.column);
        }
    }

    /// Finds the points of the active contacts again on moved slidelines, before the first step.
    pub(crate) fn relocate(&mut self, slidelines: &[Slideline<DIM>], position: f64) {
        for &i in &self.active {
            let contact = &mut self.all[i];
            let slideline = &slidelines[contact.indices[2]];
            contact.point =
                slideline.nearest_on_wire(contact.along(position), contact.point.element);
            contact.ends = [contact.point; 2];
        }
    }

    /// Returns the contacts that take part in the step.
    pub(crate) fn active(&self) -> impl Iterator<Item = &Contact<DIM>> {
        self.active.iter().map(|&i| &self.all[i])
    }

    /// Finds the contacts of a step. `positions` of the first pantograph, m: at the start of the
    /// step, at the time of balance, at its end.
    ///
    /// # Errors
    /// [`CoreError::OffWire`], [`CoreError::OutOfReach`].
    pub(crate) fn search<const D: usize>(
        &mut self,
        pantographs: &[Pantograph],
        slidelines: &[Slideline<DIM>],
        u: &(impl Nodal<D> + ?Sized),
        positions: [f64; 3],
        step: usize,
    ) -> Result<(), CoreError> {
        self.active.clear();
        for (i, contact) in self.all.iter_mut().enumerate() {
            let slideline = &slidelines[contact.indices[2]];
            contact.locate_points(contact.strip(pantographs), slideline, u, positions);
            if contact.has_wire {
                contact.compliance = slideline.compliance_at(&contact.point);
            }
            if contact.is_active {
                self.active.push(i);
            }
        }
        self.check_coverage(pantographs, slidelines, positions, step)
    }

    /// Updates e(y) of the contacts whose wire has moved along the strip.
    pub(crate) fn update_vectors(&mut self, pantographs: &[PantographState]) {
        for &i in &self.active {
            let contact = &mut self.all[i];
            let pantograph = &pantographs[contact.indices[0]];
            let strip = &pantograph.model.strips[contact.indices[1]];
            contact.lateral_rise = 0.0;
            if strip.knots.len() > 1 {
                let before = inner(&contact.vector, &pantograph.u);
                contact.interpolate_vectors(strip);
                if !contact.is_new {
                    contact.lateral_rise = inner(&contact.vector, &pantograph.u) - before;
                }
            }
        }
    }
}

impl<const DIM: usize> Contact<DIM> {
    /// Interpolates e(y) and A⁻¹e at the lateral position of the wire.
    pub(crate) fn interpolate_vectors(&mut self, strip: &Strip) {
        strip.interpolate(&strip.vectors, self.lateral, &mut self.vector);
        strip.interpolate(&self.columns, self.lateral, &mut self.column);
    }

    /// Finds the points of the contact in a step, and whether it takes part.
    fn locate_points<const D: usize>(
        &mut self,
        strip: &Strip,
        slideline: &Slideline<DIM>,
        u: &(impl Nodal<D> + ?Sized),
        [start, balance, end]: [f64; 3],
    ) {
        self.is_new = !std::mem::take(&mut self.is_active);
        let nearby_element = self.ends[1].element;
        let located = slideline.locate(self.along(balance), nearby_element);
        self.has_wire = located.is_some();
        let Some(point) = located else {
            return;
        };
        self.point = point;
        if strip.depends_on_lateral_position() {
            self.lateral = self.lateral_position(u);
        }
        self.is_active = self.lateral.abs() <= strip.half_width;
        if self.is_new {
            self.ends[1] = slideline.nearest_on_wire(self.along(start), point.element);
        }
        self.ends[0] = self.ends[1];
        if self.is_active {
            self.ends[1] = match slideline.locate(self.along(end), nearby_element) {
                Some(end) if slideline.is_same_wire(&end, &point) => end,
                // The wire ends within the step.
                _ => slideline.nearest_on_wire(self.along(end), point.element),
            };
        }
    }
}
