//! Wires around places in which residual flexibility is found: lengths, tensions and bends of a
//! structure.

use super::assembly::{Geometry, Shape};
use crate::element::hermite;
use crate::residual_flexibility::patch::{BendStiffness, NetworkElement, WireNetwork};
use crate::residual_flexibility::string_beam::StringBeam;
use std::collections::BTreeMap;

impl<const DIM: usize, const D: usize> Geometry<DIM, D> {
    /// The wires in a shape; in an unknown one under the tension of their design.
    #[must_use]
    pub fn wire_network(&self, shape: Option<&Shape<D>>) -> WireNetwork {
        if self.structure.segments.is_empty() {
            self.network_of_cubics(shape)
        } else {
            self.network_of_chains(shape)
        }
    }

    fn network_of_cubics(&self, shape: Option<&Shape<D>>) -> WireNetwork {
        let wires = self.structure.wires.iter();
        let elements = wires.map(|wire| {
            let tension = shape.map_or(wire.design_tension, |shape| {
                let e = Self::frame_coordinates(shape, wire);
                hermite::tension(&wire.section, &e, 0.5)
            });
            let beam = StringBeam {
                length: wire.section.rest_length,
                tension: tension.max(0.0),
                bending: wire.section.bending_stiffness,
            };
            let coordinates = wire.coordinate_slots();
            NetworkElement { beam, coordinates }
        });
        WireNetwork::new(self.nodes(), elements.collect(), None)
    }

    fn network_of_chains(&self, shape: Option<&Shape<D>>) -> WireNetwork {
        let s = &self.structure;
        // Slopes of its own for every end of a segment, but where two bend together.
        let mut slopes: Vec<[(usize, usize); 2]> = (0..s.segments.len())
            .map(|k| [2 * k, 2 * k + 1].map(|own| (usize::MAX - own, 1)))
            .collect();
        let mut bending = vec![0.0_f64; s.segments.len()];
        let mut bends = BTreeMap::new();
        for bend in &s.bends {
            let (nodes, element) = (s.bend_nodes(bend), self.bend_element(bend));
            let stiffness =
                std::array::from_fn(|i| std::array::from_fn(|j| element.stiffness(i, j)));
            bends.insert(nodes[1], BendStiffness { nodes, stiffness });
            let [before, behind] = bend.segments;
            (slopes[before][1], slopes[behind][0]) = ((nodes[1], 1), (nodes[1], 1));
            for k in bend.segments {
                bending[k] = bending[k].max(bend.stiffness);
            }
        }
        let elements = s.segments.iter().enumerate().map(|(k, segment)| {
            let (tension, length) =
                shape.map_or((segment.design_tension, segment.rest_length), |shape| {
                    let state = Self::segment_state(shape, segment);
                    (state.linear_tension, state.length)
                });
            let beam = StringBeam {
                length,
                tension: tension.max(0.0),
                bending: bending[k],
            };
            let ([a, b], [c, d]) = (segment.nodes, slopes[k]);
            let coordinates = [(a, 0), c, (b, 0), d];
            NetworkElement { beam, coordinates }
        });
        WireNetwork::new(self.nodes(), elements.collect(), Some(bends))
    }
}
