//! Alteration of a structure after its design: lengths, sections, masses, removed links, positions
//! of springs and struts, steady loads along the wires, fixing of the ends of wires.
//!
//! Elements are counted as wires, or as segments where wires are chains of point masses. Where the
//! new equilibrium is too far from the design to be found at once, half of every change is applied
//! first, or half of that, and the rest in equal parts from there.

use super::assembly::{Geometry, Shape};
use crate::error::CoreError;
use crate::structure::Structure;

/// Alteration of a structure whose lengths are known.
#[derive(Debug, Clone, Default)]
pub struct Alteration {
    /// Factor on the rest length of each element.
    pub length_factor: Vec<f64>,
    /// Factor on the axial stiffness EA of each element.
    pub axial_factor: Vec<f64>,
    /// Factor on the bending stiffness EI of each wire element, or of each bend of chains.
    pub bending_factor: Vec<f64>,
    /// Mass per metre of rest length of each element, kg/m, in place of the former one.
    pub mass: Vec<f64>,
    /// Steady force per metre of rest length on each element, N/m, in place of the former one.
    pub load: Vec<[f64; 3]>,
    /// Factor on the rest length of each link.
    pub link_factor: Vec<f64>,
    /// Offset added to the rest length of each link after that, m.
    pub link_offset: Vec<f64>,
    /// Offset added to the coordinate at which each spring is free of force, m.
    pub spring_offset: Vec<f64>,
    /// Offset added to the last component of the ground point of each strut, m.
    pub strut_offset: Vec<f64>,
    /// Force along the track on each free end, N; `None` fixes it where the design left it.
    pub end_force: Vec<Option<f64>>,
    /// Removed links, in ascending order; the lists above still count them.
    pub removed: Vec<usize>,
}

/// Smallest part of a change that is tried; below it the distance is not the cause of a failure.
const SMALLEST_PART: f64 = 1.0 / 64.0;

impl Alteration {
    /// Checks the lengths of all lists.
    ///
    /// # Errors
    /// [`CoreError::Input`] when a list does not fit the structure.
    fn check(&self, s: &Structure) -> Result<(), CoreError> {
        let elements = s.wires.len() + s.segments.len();
        let bending = s.wires.len() + s.bends.len();
        let links = s.links.len();
        for (array, count, expected) in [
            ("length_factor", self.length_factor.len(), elements),
            ("axial_factor", self.axial_factor.len(), elements),
            ("bending_factor", self.bending_factor.len(), bending),
            ("mass", self.mass.len(), elements),
            ("load", self.load.len(), elements),
            ("link_factor", self.link_factor.len(), links),
            ("link_offset", self.link_offset.len(), links),
            ("spring_offset", self.spring_offset.len(), s.springs.len()),
            ("strut_offset", self.strut_offset.len(), s.struts.len()),
            ("end_force", self.end_force.len(), s.ends.len()),
        ] {
            if count != expected {
                let reason = format!("has {count} entries, expected {expected}");
                return Err(CoreError::invalid(array, reason));
            }
        }
        let ascends = self.removed.windows(2).all(|pair| pair[0] < pair[1]);
        if !ascends || self.removed.last().is_some_and(|&last| last >= links) {
            let reason = format!("not ascending, or beyond the {links} links");
            return Err(CoreError::invalid("removed", reason));
        }
        Ok(())
    }

    /// Structure with a share of every change; links are removed with the first share.
    fn applied(&self, given: &Structure, share: f64) -> Structure {
        let factor = |f: f64| 1.0 + share * (f - 1.0);
        let mut s = given.clone();
        let wires = s.wires.len();
        for (k, wire) in s.wires.iter_mut().enumerate() {
            wire.section.rest_length *= factor(self.length_factor[k]);
            wire.section.axial_stiffness *= factor(self.axial_factor[k]);
            wire.section.bending_stiffness *= factor(self.bending_factor[k]);
            wire.mass += share * (self.mass[k] - wire.mass);
        }
        for (k, segment) in s.segments.iter_mut().enumerate() {
            segment.rest_length *= factor(self.length_factor[wires + k]);
            segment.axial_stiffness *= factor(self.axial_factor[wires + k]);
            segment.mass += share * (self.mass[wires + k] - segment.mass);
        }
        for (k, bend) in s.bends.iter_mut().enumerate() {
            bend.stiffness *= factor(self.bending_factor[wires + k]);
        }
        for (k, link) in s.links.iter_mut().enumerate() {
            let length = link.rest_length * factor(self.link_factor[k]);
            link.rest_length = length + share * self.link_offset[k];
        }
        for (spring, offset) in s.springs.iter_mut().zip(&self.spring_offset) {
            spring.rest += share * offset;
        }
        for (strut, offset) in s.struts.iter_mut().zip(&self.strut_offset) {
            strut.anchor[s.dim - 1] += share * offset;
        }
        for (end, force) in s.ends.iter_mut().zip(&self.end_force) {
            end.released = force.is_some();
            end.force += share * (force.unwrap_or(end.force) - end.force);
        }
        for &link in self.removed.iter().rev() {
            s.links.remove(link);
            if let Some(residual) = &mut s.residual {
                residual.links.remove(link);
            }
        }
        if s.wire_loads.is_empty() {
            s.wire_loads = vec![[0.0; 3]; self.load.len()];
        }
        for (load, new) in s.wire_loads.iter_mut().zip(&self.load) {
            (0..3).for_each(|c| load[c] += share * (new[c] - load[c]));
        }
        s
    }
}

impl<const DIM: usize, const D: usize> Geometry<DIM, D> {
    /// Altered structure and its equilibrium, reached from the equilibrium `shape` of this one.
    ///
    /// # Errors
    /// [`CoreError::Input`], or errors of [`Geometry::find_equilibrium`].
    pub fn altered(
        &self,
        shape: &Shape<D>,
        change: &Alteration,
    ) -> Result<(Self, Shape<D>), CoreError> {
        change.check(&self.structure)?;
        let (mut geometry, mut equilibrium) = (self.clone(), shape.clone());
        let (mut done, mut part): (f64, f64) = (0.0, 1.0);
        while done < 1.0 {
            let share = (done + part).min(1.0);
            let next = Self::new(change.applied(&self.structure, share))?;
            match next.find_equilibrium(&equilibrium) {
                Ok(found) => (geometry, equilibrium, done) = (next, found, share),
                Err(error) if is_not_found(&error) && part > SMALLEST_PART => part *= 0.5,
                Err(error) => return Err(error),
            }
        }
        equilibrium = geometry.refine_residual_flexibility(equilibrium)?;
        Ok((geometry, equilibrium))
    }
}

/// Tells whether a smaller change may have an equilibrium that is found.
fn is_not_found(error: &CoreError) -> bool {
    matches!(
        error,
        CoreError::NoEquilibrium { .. } | CoreError::Singular { .. } | CoreError::Unstable { .. }
    )
}
