//! Smoothing of slidelines of chains: the data of the structure that their elements need.

use crate::slideline::Slideline;
use crate::slideline::element::SlidelineElement;
use crate::slideline::local_compliance::LocalCompliances;
use crate::slideline::smoothed_segment::{CornerShapes, SmoothedSegment};
use crate::statics::assembly::{Geometry, Shape};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// Data of a structure for the smoothed elements of slidelines.
struct ChainData<'a, const DIM: usize, const D: usize> {
    geometry: &'a Geometry<DIM, D>,
    shape: &'a Shape<D>,
    /// Segment between two nodes.
    segments: BTreeMap<[usize; 2], usize>,
    /// EI of the wire and EI* of the chain at a node, N·m².
    bending: BTreeMap<usize, [f64; 2]>,
    /// Nodes at which a point force may act.
    loaded: BTreeSet<usize>,
}

impl<'a, const DIM: usize, const D: usize> ChainData<'a, DIM, D> {
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
                .map(|b| (node(b.segments[0]), [b.stiffness, geometry.bending(b)]))
                .collect(),
            loaded: geometry.loaded_nodes(),
        }
    }

    /// Tension of the segment between two nodes, N, and its length, m; none without tension.
    fn segment(&self, nodes: &[usize; 2]) -> Option<[f64; 2]> {
        let segment = &self.geometry.structure.segments[*self.segments.get(nodes)?];
        let state = Geometry::<DIM, D>::segment_state(self.shape, segment);
        (state.linear_tension > 0.0).then_some([state.linear_tension, state.length])
    }

    /// Corner shapes of the segment between two nodes; none without tension.
    fn corners(&self, nodes: &[usize; 2]) -> Option<CornerShapes> {
        let [tension, length] = self.segment(nodes)?;
        // A wire that ends at a node does not bend there.
        let bending = nodes.map(|node| self.bending.get(&node).copied().unwrap_or_default());
        let [first, second] = bending;
        let stiffest = std::array::from_fn(|k| first[k].max(second[k]));
        Some(CornerShapes::new(tension, stiffest, length))
    }

    /// Corner shapes at a loaded node between two segments, common to both.
    fn corners_at(&self, node: usize, neighbours: [&[usize; 2]; 2]) -> Option<CornerShapes> {
        let [first, second] = neighbours.map(|nodes| self.segment(nodes));
        let ([a, b], [c, d]) = (first?, second?);
        let bending = self.bending.get(&node).copied().unwrap_or_default();
        self.loaded
            .contains(&node)
            .then(|| CornerShapes::new(0.5 * (a + c), bending, 0.5 * (b + d)))
    }
}

impl<const DIM: usize> Slideline<DIM> {
    /// Slidelines of chains with curves instead of chords.
    #[must_use]
    pub fn smoothed<const D: usize>(
        mut slidelines: Vec<Self>,
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
    ) -> Vec<Self> {
        let data = ChainData::new(geometry, shape);
        for slideline in &mut slidelines {
            slideline.compliances = LocalCompliances::OfChains;
            let chords: Vec<_> = slideline
                .elements
                .iter()
                .map(SlidelineElement::chord)
                .collect();
            for k in 0..chords.len() {
                if let (Some(chord), Some(corners)) = (chords[k], data.corners(&slideline.ends[k]))
                {
                    let end_corners = std::array::from_fn(|end| {
                        let next = (k + end).checked_sub(1)?;
                        let pair = [slideline.ends.get(next)?, slideline.ends.get(next + 1)?];
                        data.corners_at(slideline.ends[k][end], pair)
                    });
                    let neighbour = |other: usize| {
                        let is_same_wire = slideline.wires.get(other) == Some(&slideline.wires[k]);
                        chords
                            .get(other)
                            .copied()
                            .flatten()
                            .filter(|_| is_same_wire)
                    };
                    let before = k.checked_sub(1).and_then(neighbour).map(|c| c[0]);
                    let points = before.into_iter().chain(chord);
                    let points: Vec<_> = points.chain(neighbour(k + 1).map(|c| c[1])).collect();
                    let first = usize::from(before.is_some());
                    let segment = SmoothedSegment::new(corners, &points, first, end_corners);
                    slideline.elements[k] = SlidelineElement::Smoothed(Arc::new(segment));
                }
            }
        }
        slidelines
    }
}
