//! Forces and tangents of chains of point masses.

use super::assembly::{Geometry, Shape, add_pair};
use super::relaxation::{LengthRelaxation, length_change};
use crate::element::bar::BarState;
use crate::element::chain::BendElement;
use crate::element::frame::{self, Frame};
use crate::linalg::SymmetricBlocks;
use crate::structure::{Bend, Segment};

/// Argument x below which x coth x is 1 to rounding.
const SMALL: f64 = 1e-8;

impl<const DIM: usize, const D: usize> Geometry<DIM, D> {
    /// State of a segment.
    #[must_use]
    pub fn segment_state(shape: &Shape<D>, segment: &Segment) -> BarState<DIM> {
        let [a, b] = segment.nodes.map(|n| Self::position(shape, n));
        segment.state([&a, &b])
    }

    /// Bending element of a bend.
    pub(crate) fn bend_element(&self, bend: &Bend) -> BendElement {
        let segments = &self.structure.segments;
        let lengths = bend.segments.map(|k| segments[k].rest_length);
        BendElement::new(self.bending(bend), lengths)
    }

    /// Stiffness of a bend, N·m²: EI of the wire, or with fitted bends
    ///
    ///   EI* = EI x coth x,   x = (ℓ/2) √(T/EI)
    ///
    /// A wire under tension T and a point force has a corner that is rounded over √(EI/T), a chain
    /// with EI one that is rounded over its elements of ℓ: its points are too compliant, and
    /// corners at rest are too sharp. With EI* forces on points displace points as they do on the
    /// wire (docs/theory/dynamics.md#explicit-steps).
    #[must_use]
    pub fn bending(&self, bend: &Bend) -> f64 {
        let s = &self.structure;
        let [before, behind] = bend.segments.map(|k| &s.segments[k]);
        let tension = 0.5 * (before.design_tension + behind.design_tension);
        let length = 0.5 * (before.rest_length + behind.rest_length);
        let x = 0.5 * length * (tension / bend.stiffness).sqrt();
        // Without tension, or bending stiffness, there is nothing to fit; x coth x is 1 + x²/3.
        if s.fitted_bends && x.is_finite() && x > SMALL {
            bend.stiffness * x / x.tanh()
        } else {
            bend.stiffness
        }
    }

    /// Nodes of a bend and the forces on them, N.
    fn bend_forces(&self, shape: &Shape<D>, bend: &Bend) -> ([usize; 3], [[f64; DIM]; 3]) {
        let nodes = self.structure.bend_nodes(bend);
        let positions = nodes.map(|n| Self::position(shape, n));
        let forces = self.bend_element(bend).force(positions.each_ref());
        (nodes, forces)
    }

    /// Adds internal forces and weight of all chains to the residual, N.
    pub(super) fn add_chain_forces(&self, shape: &Shape<D>, residual: &mut Shape<D>) {
        let s = &self.structure;
        for segment in &s.segments {
            let state = Self::segment_state(shape, segment);
            let half = 0.5 * segment.mass * segment.rest_length * s.gravity;
            for node in segment.nodes {
                residual[node][Self::UP] += half;
            }
            let tension = state.linear_tension;
            match Frame::new::<DIM>(segment.turn) {
                None => add_pair(residual, segment.nodes, &state.direction, tension),
                Some(frame) => {
                    for (end, sign) in [(0, -tension), (1, tension)] {
                        let force = frame::from_frame(&frame.matrix(end, false), &state.direction);
                        let node = &mut residual[segment.nodes[end]];
                        (0..DIM).for_each(|c| node[c] += sign * force[c]);
                    }
                }
            }
        }
        for bend in &s.bends {
            let (nodes, forces) = self.bend_forces(shape, bend);
            for (node, force) in nodes.into_iter().zip(forces) {
                for c in 0..DIM {
                    residual[node][c] += force[c];
                }
            }
        }
    }

    /// Node pairs that segments and bends couple.
    pub(super) fn chain_pairs(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let s = &self.structure;
        let neighbours = s.segments.iter().map(|k| (k.nodes[0], k.nodes[1]));
        let outer = s.bends.iter().map(|b| {
            let [a, _, c] = s.bend_nodes(b);
            (a, c)
        });
        neighbours.chain(outer)
    }

    /// Adds the tangent of one segment, times `factor`.
    pub fn add_segment(
        k: &mut SymmetricBlocks<D>,
        shape: &Shape<D>,
        segment: &Segment,
        factor: f64,
    ) {
        let state = Self::segment_state(shape, segment);
        let tangent = state.tangent(factor * segment.stiffness(), factor * state.linear_tension);
        Self::add_segment_matrix(k, segment, &tangent);
    }

    /// Adds a stiffness for the vector between the ends of a segment in its frame, N/m.
    pub(super) fn add_segment_matrix(
        k: &mut SymmetricBlocks<D>,
        segment: &Segment,
        stiffness: &[[f64; DIM]; DIM],
    ) {
        let Some(frame) = Frame::new::<DIM>(segment.turn) else {
            return Self::add_between(k, segment.nodes, stiffness);
        };
        let pairs = [(0, 0), (0, 1), (1, 0), (1, 1)].into_iter();
        for (m, n) in pairs.filter(|&(m, n)| segment.nodes[m] >= segment.nodes[n]) {
            let [left, right] = [m, n].map(|end| frame.matrix(end, false));
            let mut part = frame::congruence(&left, stiffness, &right);
            if m != n {
                part.iter_mut().flatten().for_each(|v| *v = -*v);
            }
            k.add_part((segment.nodes[m], segment.nodes[n]), (0, 0), &part);
        }
    }

    /// Adds the stiffness of one bend, times `factor`.
    pub fn add_bend(&self, k: &mut SymmetricBlocks<D>, bend: &Bend, factor: f64) {
        let (nodes, element) = (self.structure.bend_nodes(bend), self.bend_element(bend));
        for (i, &row) in nodes.iter().enumerate() {
            for (j, &column) in nodes.iter().enumerate() {
                let mut block = [[0.0; D]; D];
                for c in 0..DIM {
                    block[c][c] = factor * element.stiffness(i, j);
                }
                k.add(row, column, &block);
            }
        }
    }

    /// Horizontal force through each segment, N: the horizontal component of its tension, and the
    /// shear of its bends. Where these are equal along a wire, nothing pulls its nodes along the
    /// track.
    fn horizontal_forces(&self, shape: &Shape<D>) -> Vec<f64> {
        let s = &self.structure;
        let axial = |k: &Segment| {
            let state = Self::segment_state(shape, k);
            state.linear_tension * state.direction[0]
        };
        let mut horizontal: Vec<f64> = s.segments.iter().map(axial).collect();
        for bend in &s.bends {
            let (_, [first, _, last]) = self.bend_forces(shape, bend);
            horizontal[bend.segments[0]] -= first[0];
            horizontal[bend.segments[1]] += last[0];
        }
        horizontal
    }

    /// Corrects segment lengths towards their horizontal tension, as the design calculation does
    /// with Hermite elements; returns the largest error before the correction, N.
    pub(super) fn correct_segment_lengths(
        &mut self,
        shape: &Shape<D>,
        relaxation: &mut LengthRelaxation,
    ) -> f64 {
        let mut worst: f64 = 0.0;
        let horizontal = self.horizontal_forces(shape);
        let mut bending = vec![0.0_f64; horizontal.len()];
        for bend in &self.structure.bends {
            for k in bend.segments {
                bending[k] = bending[k].max(bend.stiffness);
            }
        }
        let forces = horizontal.into_iter().zip(bending);
        let wires = self.structure.wires.len();
        let segments = self.structure.segments.iter_mut().enumerate();
        for ((k, segment), (force, bending)) in segments.zip(forces) {
            let (tension, axial) = (segment.design_tension, segment.axial_stiffness);
            let error = force - tension;
            let flexibility = flexibility(&Self::segment_state(shape, segment), segment, bending);
            let factor = relaxation.factor(wires + k, error);
            let change = factor * length_change(error, flexibility, tension / axial);
            segment.rest_length *= 1.0 + change;
            worst = worst.max(error.abs());
        }
        worst
    }

    /// Largest stiffness of a chain between coordinates, N/m.
    pub(super) fn stiffest_chain(&self) -> f64 {
        let s = &self.structure;
        let bends = s.bends.iter().map(|b| self.bend_element(b).stiffness(1, 1));
        let segments = s.segments.iter().map(Segment::stiffness);
        segments.chain(bends).fold(0.0, f64::max)
    }
}

/// Relative change of length for a change of horizontal force, 1/N. Where neighbours have equal
/// errors, slopes follow the force and it is (1 + s)/EA with s = EA z′²/T, as for Hermite elements.
/// Where errors alternate, bends resist: a zigzag has curvature 4/L² for each unit of height, and
/// slopes follow by the share T/(T + 4 EI/L²) alone. The harmonic mean of both corrects them
/// equally fast; without it, segments shorter than √(EI/T) diverge. Without tension, slopes do not
/// follow.
fn flexibility<const DIM: usize>(state: &BarState<DIM>, segment: &Segment, bending: f64) -> f64 {
    let (tension, axial) = (segment.design_tension, segment.axial_stiffness);
    if tension == 0.0 {
        return 1.0 / axial;
    }
    // The part of y due to a curve is independent of the tension.
    let first = if segment.turn == 0.0 { 1 } else { DIM - 1 };
    let across: f64 = state.direction[first..].iter().map(|n| n * n).sum();
    let steep = across * (state.length / segment.rest_length).powi(2);
    let smooth = 1.0 + axial * steep / tension;
    let share = tension / (tension + 4.0 * bending / segment.rest_length.powi(2));
    let zigzag = 1.0 + share * axial * steep / tension;
    2.0 / (1.0 / smooth + 1.0 / zigzag) / axial
}
