//! Lengths, forces and positions of a line at rest, as lists by their names.

use crate::element::hermite;
use crate::line::at_rest::LineAtRest;
use crate::statics::{Geometry, assembly};
use crate::structure::Wire;

impl<const DIM: usize, const D: usize> LineAtRest<DIM, D> {
    /// Returns shape (m), lengths (m), masses (kg/m) and forces (N) by their names.
    #[must_use]
    pub fn arrays(&self) -> Vec<(&'static str, Vec<f64>)> {
        let (s, shape) = (&self.geometry.structure, &self.shape);
        let real = self.geometry.real_shape(shape);
        let length = |l| Geometry::<DIM, D>::link_state(&real, l).length;
        let tension = |l| assembly::link_tension(l, &Geometry::<DIM, D>::link_state(shape, l));
        let strut = |t| Geometry::<DIM, D>::strut_state(shape, t).linear_tension;
        let positions = real.iter().flat_map(|node| node[..DIM].to_vec());
        // None where nodes have no slopes.
        let slopes = shape.iter().flat_map(|node| node[DIM..].to_vec());
        let springs = s.springs.iter();
        let spring_forces = springs.map(|p| -p.stiffness * (shape[p.node][p.component] - p.rest));
        vec![
            ("positions", positions.collect()),
            ("slopes", slopes.collect()),
            ("wire_rest_length", self.rest_lengths()),
            ("wire_tension", self.tensions()),
            ("wire_mass", self.masses()),
            ("link_length", s.links.iter().map(length).collect()),
            (
                "link_rest_length",
                s.links.iter().map(|l| l.rest_length).collect(),
            ),
            ("link_tension", s.links.iter().map(tension).collect()),
            ("strut_tension", s.struts.iter().map(strut).collect()),
            (
                "strut_anchor",
                s.struts.iter().flat_map(|t| t.anchor).collect(),
            ),
            ("spring_force", spring_forces.collect()),
            ("spring_rest", s.springs.iter().map(|p| p.rest).collect()),
        ]
    }

    /// Unstretched length of each wire element or segment, m.
    fn rest_lengths(&self) -> Vec<f64> {
        let s = &self.geometry.structure;
        let segments = s.segments.iter().map(|k| k.rest_length);
        let wires = s.wires.iter().map(|w| w.section.rest_length);
        wires.chain(segments).collect()
    }

    /// Mass per metre of rest length of each wire element or segment, kg/m.
    fn masses(&self) -> Vec<f64> {
        let s = &self.geometry.structure;
        let segments = s.segments.iter().map(|k| k.mass);
        s.wires.iter().map(|w| w.mass).chain(segments).collect()
    }

    /// Tension in the middle of each wire element or segment, N.
    fn tensions(&self) -> Vec<f64> {
        let s = &self.geometry.structure;
        let middle = |w: &Wire| {
            let e = Geometry::<DIM, D>::frame_coordinates(&self.shape, w);
            hermite::tension(&w.section, &e, 0.5)
        };
        let segments = s
            .segments
            .iter()
            .map(|k| Geometry::<DIM, D>::segment_state(&self.shape, k).linear_tension);
        s.wires.iter().map(middle).chain(segments).collect()
    }
}
