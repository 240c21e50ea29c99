//! Lanes of chains on which contacts meet curves: what their elements need to know of the structure.

use super::path::Path;
use super::path_element::PathElement;
use super::rounded::{Rounded, Taut};
use super::yields::Yields;
use crate::statics::assembly::{Geometry, Shape};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// What the elements of lanes need to know of a structure.
struct Structured<'a, const DIM: usize, const D: usize> {
    geometry: &'a Geometry<DIM, D>,
    shape: &'a Shape<D>,
    /// Segment between two nodes.
    segments: BTreeMap<[usize; 2], usize>,
    /// EI at a node, N·m².
    bending: BTreeMap<usize, f64>,
    held: BTreeSet<usize>,
}

impl<'a, const DIM: usize, const D: usize> Structured<'a, DIM, D> {
    fn new(geometry: &'a Geometry<DIM, D>, shape: &'a Shape<D>) -> Self {
        let s = &geometry.structure;
        let segments = s.segments.iter().enumerate();
        let node = |k: usize| s.segments[k].nodes[1];
        Self {
            geometry,
            shape,
            segments: segments.map(|(k, segment)| (segment.nodes, k)).collect(),
            bending: s
                .bends
                .iter()
                .map(|b| (node(b.segments[0]), b.stiffness))
                .collect(),
            held: geometry.loaded(),
        }
    }

    /// Of the segment between two nodes; none without tension.
    fn taut(&self, nodes: &[usize; 2]) -> Option<Taut> {
        let segment = &self.geometry.structure.segments[*self.segments.get(nodes)?];
        let tension = Geometry::<DIM, D>::segment_state(self.shape, segment).linear_tension;
        let bending = nodes.map(|node| self.bending.get(&node).copied().unwrap_or(0.0));
        (tension > 0.0).then(|| Taut {
            tension,
            // A wire that ends at a node does not bend there.
            radius: (bending[0].max(bending[1]) / tension).sqrt(),
        })
    }
}

impl<const DIM: usize> Path<DIM> {
    /// Lanes of chains on which contacts meet curves in the place of chords.
    #[must_use]
    pub fn rounded<const D: usize>(
        mut lanes: Vec<Self>,
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
    ) -> Vec<Self> {
        let of = Structured::new(geometry, shape);
        for lane in &mut lanes {
            lane.yields = Yields::OfChains;
            let chords: Vec<_> = lane.elements.iter().map(PathElement::chord).collect();
            for k in 0..chords.len() {
                if let (Some(chord), Some(taut)) = (chords[k], of.taut(&lane.ends[k])) {
                    let held = lane.ends[k].map(|node| of.held.contains(&node));
                    let beside = |other: usize| {
                        let is_one = lane.wires.get(other) == Some(&lane.wires[k]);
                        chords.get(other).copied().flatten().filter(|_| is_one)
                    };
                    let before = k.checked_sub(1).and_then(beside).map(|c| c[0]);
                    let points = before.into_iter().chain(chord);
                    let points: Vec<_> = points.chain(beside(k + 1).map(|c| c[1])).collect();
                    let first = usize::from(before.is_some());
                    let rounded = Rounded::new(taut, &points, first, held);
                    lane.elements[k] = PathElement::Rounded(Arc::new(rounded));
                }
            }
        }
        lanes
    }
}
