//! Lanes of chains on which contacts meet curves: what their elements need to know of the structure.

use crate::slideline::Slideline;
use crate::slideline::element::SlidelineElement;
use crate::slideline::residual_flexibility::LocalCompliances;
use crate::slideline::smoothed_segment::{SmoothedSegment, Taut};
use crate::statics::assembly::{Geometry, Shape};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// What the elements of lanes need to know of a structure.
struct Structured<'a, const DIM: usize, const D: usize> {
    geometry: &'a Geometry<DIM, D>,
    shape: &'a Shape<D>,
    /// Segment between two nodes.
    segments: BTreeMap<[usize; 2], usize>,
    /// EI of the wire and EI* of the chain at a node, N·m².
    bending: BTreeMap<usize, [f64; 2]>,
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
                .map(|b| (node(b.segments[0]), [b.stiffness, geometry.bending(b)]))
                .collect(),
            held: geometry.loaded(),
        }
    }

    /// Tension of the segment between two nodes, N, and its length, m; none without tension.
    fn segment(&self, nodes: &[usize; 2]) -> Option<[f64; 2]> {
        let segment = &self.geometry.structure.segments[*self.segments.get(nodes)?];
        let state = Geometry::<DIM, D>::segment_state(self.shape, segment);
        (state.linear_tension > 0.0).then_some([state.linear_tension, state.length])
    }

    /// Of the segment between two nodes; none without tension.
    fn taut(&self, nodes: &[usize; 2]) -> Option<Taut> {
        let [tension, length] = self.segment(nodes)?;
        // A wire that ends at a node does not bend there.
        let bending = nodes.map(|node| self.bending.get(&node).copied().unwrap_or_default());
        let [first, second] = bending;
        let most = std::array::from_fn(|k| first[k].max(second[k]));
        Some(Taut::new(tension, most, length))
    }

    /// At a node that something holds, between two segments: the same for both.
    fn taut_at(&self, node: usize, beside: [&[usize; 2]; 2]) -> Option<Taut> {
        let [first, second] = beside.map(|nodes| self.segment(nodes));
        let ([a, b], [c, d]) = (first?, second?);
        let bending = self.bending.get(&node).copied().unwrap_or_default();
        self.held
            .contains(&node)
            .then(|| Taut::new(0.5 * (a + c), bending, 0.5 * (b + d)))
    }
}

impl<const DIM: usize> Slideline<DIM> {
    /// Lanes of chains on which contacts meet curves in the place of chords.
    #[must_use]
    pub fn rounded<const D: usize>(
        mut lanes: Vec<Self>,
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
    ) -> Vec<Self> {
        let of = Structured::new(geometry, shape);
        for lane in &mut lanes {
            lane.yields = LocalCompliances::OfChains;
            let chords: Vec<_> = lane.elements.iter().map(SlidelineElement::chord).collect();
            for k in 0..chords.len() {
                if let (Some(chord), Some(taut)) = (chords[k], of.taut(&lane.ends[k])) {
                    let held = std::array::from_fn(|end| {
                        let next = (k + end).checked_sub(1)?;
                        let pair = [lane.ends.get(next)?, lane.ends.get(next + 1)?];
                        of.taut_at(lane.ends[k][end], pair)
                    });
                    let beside = |other: usize| {
                        let is_one = lane.wires.get(other) == Some(&lane.wires[k]);
                        chords.get(other).copied().flatten().filter(|_| is_one)
                    };
                    let before = k.checked_sub(1).and_then(beside).map(|c| c[0]);
                    let points = before.into_iter().chain(chord);
                    let points: Vec<_> = points.chain(beside(k + 1).map(|c| c[1])).collect();
                    let first = usize::from(before.is_some());
                    let rounded = SmoothedSegment::new(taut, &points, first, held);
                    lane.elements[k] = SlidelineElement::Smoothed(Arc::new(rounded));
                }
            }
        }
        lanes
    }
}
