//! Design calculation: heights, lateral positions and tensions are given, unstretched lengths are
//! found.
//!
//! Components that the drawing fixes are held at their target; the reaction that this needs is
//! the force of the element that will hold them in service:
//!
//! * link: tension T = R_z / m_z along the line between its clamps, and −T on its upper node;
//! * strut: tension T = R_y / n_y along its given direction;
//! * spring: rest coordinate = position + R / k.
//!
//! Nodes are held where they were drawn along the track, and the element lengths are corrected
//! until every element carries its horizontal tension T. With the vertical load given, z′ ∝ 1/H,
//! so H = EA ½ (x′² + z′² − 1) gives L ← L (1 + (H − T) (1/EA + z′²/T)). Each correction is local,
//! so long lines need no more iterations than short ones. A beam without tension carries its load
//! by bending: z′ does not follow H, which leaves L ← L (1 + H/EA). The forces of links lag one
//! iteration behind, which changes the speed of convergence, not its limit.
//! (Tur et al. 2014 put all of these unknowns into one Newton system; the staged form needs no
//! unsymmetric matrix and no more than a few iterations more.)

use super::assembly::{Geometry, Shape, add_pair, largest_residual};
use super::newton::Newton;
use super::relaxation::{LengthRelaxation, Pace, length_change};
use crate::element::hermite;
use crate::error::CoreError;
use crate::linalg::SymmetricBlocks;
use crate::structure::{SpringMode, Structure, Wire};

/// Relaxation factors tried when full corrections do not converge: wires that sag far, or that
/// hardly stretch.
const RELAXATIONS: [f64; 2] = [0.4, 0.15];

/// Share of the imbalance that an iteration may leave with the factor of an earlier tangent; exact
/// ones leave a third to two thirds. Smaller, the tangent is factorised where that is of no use;
/// larger, more iterations are taken than factorising would.
const STALE: f64 = 0.8;

/// Tolerance of the change of a held height, m: forces of the tolerance times R, a few 1e-6 m/N,
/// stay below it.
const HEIGHT_TOLERANCE: f64 = 1e-9;

impl<const DIM: usize, const D: usize> Geometry<DIM, D> {
    /// Finds the unstretched lengths and completes the structure with them; returns the shape.
    ///
    /// # Errors
    /// [`CoreError::NoEquilibrium`], [`CoreError::Singular`], or [`CoreError::PushingLink`] when
    /// a tension-only link would have to push.
    pub fn design(&mut self) -> Result<Shape<D>, CoreError> {
        let given = self.structure.clone();
        let start = self.initial_shape();
        let mut result = self.design_with(Pace::Uniform(1.0), start.clone(), false);
        let slower = RELAXATIONS.map(Pace::Uniform);
        for pace in slower.into_iter().chain([Pace::PerElement]) {
            if is_not_found(&result) {
                self.structure = given.clone();
                result = self.design_with(pace, start.clone(), false);
            }
        }
        result
    }

    /// Finds the same as [`design`](Self::design), sooner where a line like it is known: from the
    /// shape and lengths of `other`, at its pace, with a tangent that is kept as long as the
    /// balance becomes better with it. It ends by the same bounds of forces and heights, so that
    /// both results differ by rounding alone. A line of other elements, or so different that this
    /// fails, is found as without `other`.
    ///
    /// # Errors
    /// As [`design`](Self::design).
    pub fn design_near(
        &mut self,
        other: &Self,
        shape_of_other: &Shape<D>,
    ) -> Result<Shape<D>, CoreError> {
        if !self.is_alike(other) {
            return self.design();
        }
        let given = self.structure.clone();
        let (free, mut start) = (self.design_mask(), self.initial_shape());
        for ((node, mask), near) in start.iter_mut().zip(&free).zip(shape_of_other) {
            (0..D).filter(|&c| mask[c]).for_each(|c| node[c] = near[c]);
        }
        self.take_lengths(other);
        let result = self.design_with(other.pace, start, true);
        if is_not_found(&result) {
            self.structure = given;
            return self.design();
        }
        result
    }

    /// Tells whether a line has the same nodes and elements as another one.
    fn is_alike(&self, other: &Self) -> bool {
        let (a, b) = (&self.structure, &other.structure);
        fn wires(s: &Structure) -> impl Iterator<Item = ([usize; 2], [usize; 2])> {
            s.wires.iter().map(|w| (w.nodes, w.slope_nodes))
        }
        let segments = |s: &Structure| -> Vec<_> { s.segments.iter().map(|k| k.nodes).collect() };
        a.positions.len() == b.positions.len()
            && wires(a).eq(wires(b))
            && segments(a) == segments(b)
    }

    /// Takes the lengths of elements from a line that is alike, as long as it lies along the track.
    fn take_lengths(&mut self, other: &Self) {
        let (own, theirs) = (&self.structure.positions, &other.structure.positions);
        let longer = |[a, b]: [usize; 2]| {
            let ratio = (own[b][0] - own[a][0]) / (theirs[b][0] - theirs[a][0]);
            // Of a bridle that hangs down, both may be zero.
            if ratio.is_finite() && ratio > 0.0 {
                ratio
            } else {
                1.0
            }
        };
        let pairs = self.structure.wires.iter_mut().zip(&other.structure.wires);
        for (wire, known) in pairs {
            wire.section.rest_length = known.section.rest_length * longer(wire.nodes);
        }
        let pairs = self.structure.segments.iter_mut();
        for (segment, known) in pairs.zip(&other.structure.segments) {
            segment.rest_length = known.rest_length * longer(segment.nodes);
        }
    }

    /// Attempts the design calculation from a shape, at a pace of the length corrections; with
    /// `keeps_tangent` one tangent serves several steps.
    fn design_with(
        &mut self,
        pace: Pace,
        mut shape: Shape<D>,
        keeps_tangent: bool,
    ) -> Result<Shape<D>, CoreError> {
        let elements = self.structure.wires.len() + self.structure.segments.len();
        let mut relaxation = LengthRelaxation::new(pace, elements);
        let free = self.design_mask();
        let mut residual = vec![[0.0; D]; self.nodes()];
        let mut tensions = vec![0.0; self.structure.links.len()];
        let mut k = self.empty_matrix();
        let mut newton = Newton::new(&k, &free);
        let tolerance = self.force_rounding();
        let mut worst = (f64::INFINITY, 0);
        let (mut iterations, mut imbalance) = (0, 0.0);
        for iteration in 0..relaxation.most_iterations() {
            iterations = iteration + 1;
            let rounding = Self::rounding_after(iteration, tolerance);
            let tension_error = self.correct_lengths(&mut shape, &mut relaxation);
            let held = self.design_residual(&shape, &mut residual, &mut tensions);
            worst = largest_residual(&residual, &free);
            if !worst.0.is_finite() {
                break;
            }
            let moved = self.hold_real_heights(&mut shape);
            if worst.0 <= rounding && tension_error <= rounding && moved <= HEIGHT_TOLERANCE {
                self.store_lengths(&shape, &held, &tensions)?;
                self.pace = pace;
                return Ok(shape);
            }
            let before = std::mem::replace(&mut imbalance, worst.0.max(tension_error));
            if keeps_tangent && imbalance <= STALE * before {
                newton.step_again(&residual, &mut shape);
            } else {
                self.design_tangent(&shape, &tensions, &mut k);
                newton.step(&mut k, &residual, &mut shape)?;
            }
        }
        Err(CoreError::NoEquilibrium {
            iterations,
            residual: worst.0,
            node: worst.1,
            tolerance,
        })
    }

    /// Degrees of freedom that move in the design calculation.
    fn design_mask(&self) -> Vec<[bool; D]> {
        let s = &self.structure;
        let mut free = vec![[true; D]; self.nodes()];
        s.fixed.iter().for_each(|&(node, c)| free[node][c] = false);
        free.iter_mut().for_each(|mask| mask[0] = false);
        for link in s.links.iter().filter(|l| l.adjust) {
            free[link.nodes[1]][Self::UP] = false;
        }
        s.struts
            .iter()
            .filter(|t| t.adjust)
            .for_each(|t| free[t.node][1] = false);
        let held = s.springs.iter().filter(|p| p.mode == SpringMode::Held);
        held.for_each(|p| free[p.node][p.component] = false);
        self.fix_unused(&mut free);
        free
    }

    /// Corrects element lengths towards their horizontal tension; returns the largest error
    /// before the correction, N. The slopes follow their elements (r′ ∝ 1/L between held nodes),
    /// or every other iteration would only repair them.
    fn correct_lengths(&mut self, shape: &mut Shape<D>, relaxation: &mut LengthRelaxation) -> f64 {
        let mut worst: f64 = 0.0;
        let mut changes = vec![(0.0, 0.0); shape.len()];
        for (k, wire) in self.structure.wires.iter_mut().enumerate() {
            let along =
                hermite::end_force_along(&wire.section, &Self::frame_coordinates(shape, wire));
            let error = along - wire.design_tension;
            let steep = Self::squared_slope(shape, wire);
            let (tension, axial) = (wire.design_tension, wire.section.axial_stiffness);
            let flexibility = if tension > 0.0 {
                1.0 / axial + steep / tension
            } else {
                1.0 / axial
            };
            let factor = relaxation.factor(k, error);
            let change = factor * length_change(error, flexibility, tension / axial);
            wire.section.rest_length *= 1.0 + change;
            worst = worst.max(error.abs());
            for node in wire.slope_nodes {
                changes[node].0 += change;
                changes[node].1 += 1.0;
            }
        }
        for (node, (sum, count)) in shape.iter_mut().zip(changes).filter(|(_, c)| c.1 > 0.0) {
            node[DIM..]
                .iter_mut()
                .for_each(|slope| *slope /= 1.0 + sum / count);
        }
        worst.max(self.correct_segment_lengths(shape, relaxation))
    }

    /// Mean of y′² + z′² over an element (in a curve of z′²), by Simpson's rule.
    fn squared_slope(shape: &Shape<D>, wire: &Wire) -> f64 {
        let e = Self::coordinates(shape, wire);
        // The part of y due to a curve is independent of the tension.
        let first = if wire.turn == 0.0 { 1 } else { DIM - 1 };
        let across = |xi: f64| {
            let slope = hermite::shape_slope(xi, wire.section.rest_length);
            let r = hermite::interpolate(&slope, &e);
            r[first..].iter().map(|c| c * c).sum::<f64>()
        };
        (across(0.0) + 4.0 * across(0.5) + across(1.0)) / 6.0
    }

    /// Computes the residual with the reactions of held components turned into element forces, N.
    /// Returns the residual before they were applied: at held components, the reaction.
    fn design_residual(
        &self,
        shape: &Shape<D>,
        residual: &mut Shape<D>,
        tensions: &mut [f64],
    ) -> Shape<D> {
        let s = &self.structure;
        self.wire_and_weight_residual(shape, residual);
        s.ends
            .iter()
            .for_each(|end| residual[end.node][0] -= end.force);
        for spring in s.springs.iter().filter(|p| p.mode == SpringMode::Given) {
            residual[spring.node][spring.component] +=
                spring.stiffness * (shape[spring.node][spring.component] - spring.rest);
        }
        for (link, tension) in s.links.iter().zip(tensions.iter_mut()) {
            let state = Self::link_state(shape, link);
            *tension = if link.adjust {
                // `direction` points down, towards the held node, which the link pulls up.
                -residual[link.nodes[1]][Self::UP] / state.direction[Self::UP]
            } else {
                super::assembly::link_tension(link, &state)
            };
            add_pair(residual, link.nodes, &state.direction, *tension);
        }
        let held = residual.clone();
        for strut in &s.struts {
            let (tension, direction) = self.strut_force(shape, strut, &held);
            for c in 0..DIM {
                residual[strut.node][c] -= tension * direction[c];
            }
        }
        held
    }

    /// Tension of a strut, N, and its direction from the node to the ground.
    fn strut_force(
        &self,
        shape: &Shape<D>,
        strut: &crate::structure::Strut,
        held: &Shape<D>,
    ) -> (f64, [f64; DIM]) {
        if strut.adjust {
            let mut direction = [0.0; DIM];
            direction.copy_from_slice(&strut.direction[..DIM]);
            return (held[strut.node][1] / direction[1], direction);
        }
        let state = Self::strut_state(shape, strut);
        (state.linear_tension, state.direction)
    }

    /// Computes the tangent of wires and of all elements of known length; adjusted links have their
    /// geometric stiffness only, adjusted struts and springs none.
    fn design_tangent(&self, shape: &Shape<D>, tensions: &[f64], k: &mut SymmetricBlocks<D>) {
        let s = &self.structure;
        k.clear();
        s.wires
            .iter()
            .for_each(|wire| Self::add_wire(k, shape, wire, 1.0));
        for segment in &s.segments {
            Self::add_segment(k, shape, segment, 1.0);
        }
        for bend in &s.bends {
            self.add_bend(k, bend, 1.0);
        }
        for (link, &tension) in s.links.iter().zip(tensions) {
            let state = Self::link_state(shape, link);
            let slack = link.unilateral && state.linear_tension < 0.0;
            let stiffness = if link.adjust || slack {
                0.0
            } else {
                link.stiffness
            };
            Self::add_between(k, link.nodes, &state.tangent(stiffness, tension.max(0.0)));
        }
        for strut in s.struts.iter().filter(|t| !t.adjust) {
            Self::add_strut(k, shape, strut, 1.0);
        }
        for spring in s.springs.iter().filter(|p| p.mode == SpringMode::Given) {
            Self::add_spring(k, spring, spring.stiffness);
        }
    }

    /// Stores the lengths, ground points and rest coordinates of the solution in the structure.
    fn store_lengths(
        &mut self,
        shape: &Shape<D>,
        held: &Shape<D>,
        tensions: &[f64],
    ) -> Result<(), CoreError> {
        let forces: Vec<f64> = self
            .structure
            .struts
            .iter()
            .map(|t| self.strut_force(shape, t, held).0)
            .collect();
        let s = &mut self.structure;
        for (index, (link, &tension)) in s.links.iter_mut().zip(tensions).enumerate() {
            if link.adjust {
                if link.unilateral && tension < 0.0 {
                    return Err(CoreError::PushingLink {
                        link: index,
                        force: tension,
                    });
                }
                link.rest_length = Self::link_state(shape, link).length - tension / link.stiffness;
            }
        }
        for (strut, force) in s.struts.iter_mut().zip(forces).filter(|(t, _)| t.adjust) {
            let length = strut.rest_length + force / strut.stiffness;
            for c in 0..DIM {
                strut.anchor[c] = shape[strut.node][c] + strut.direction[c] * length;
            }
        }
        for spring in s.springs.iter_mut().filter(|p| p.mode != SpringMode::Given) {
            let is_held = spring.mode == SpringMode::Held;
            let reaction = if is_held {
                held[spring.node][spring.component]
            } else {
                0.0
            };
            spring.rest = shape[spring.node][spring.component] + reaction / spring.stiffness;
        }
        Ok(())
    }
}

/// Tells whether an attempt ended without a shape.
fn is_not_found<T>(result: &Result<T, CoreError>) -> bool {
    matches!(
        result,
        Err(CoreError::NoEquilibrium { .. } | CoreError::Singular { .. })
    )
}
