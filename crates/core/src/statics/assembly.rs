//! Internal forces, weight and tangent stiffness of a structure in a given shape.

use super::relaxation::Pace;
use crate::element::bar::BarState;
use crate::element::frame::{self, Frame};
use crate::element::hermite::{self, Coordinates};
use crate::element::tangent::{self, Tangent};
use crate::error::CoreError;
use crate::linalg::SymmetricBlocks;
use crate::structure::{Link, Structure, Wire};

/// Positions and slopes (`D = 2·DIM` numbers a node), or positions alone (`D = DIM`), of all nodes.
pub type Shape<const D: usize> = Vec<[f64; D]>;

/// Structure with the operations that need its dimension at compile time: `D = 2·DIM`
/// for wires of Hermite elements, `D = DIM` for chains of point masses.
#[derive(Debug, Clone)]
pub struct Geometry<const DIM: usize, const D: usize> {
    /// Structure; the design calculation completes its unknown lengths.
    pub structure: Structure,
    /// Pace at which the design calculation found them.
    pub(super) pace: Pace,
}

/// Number of iterations after which an equilibrium changes by rounding alone; a line takes 10 to
/// 60.
const LONG_CONVERGED: usize = 100;

/// Force law of unilateral links in forces and tangents.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LinkLaw {
    /// Tension only: a slack link has no stiffness.
    Unilateral,
    /// Linear, as if it could push: the dynamics correct it in the complementarity problem.
    Linear,
}

impl<const DIM: usize, const D: usize> Geometry<DIM, D> {
    /// Component that points up.
    pub const UP: usize = DIM - 1;

    /// Wraps a structure whose `dim` is `DIM` and whose wires are of the model that `D` means.
    ///
    /// # Errors
    /// [`CoreError::Input`] when indices, signs or numbers are impossible.
    pub fn new(structure: Structure) -> Result<Self, CoreError> {
        crate::structure_check::check(&structure, DIM, D / DIM)?;
        Ok(Self {
            structure,
            pace: Pace::Uniform(1.0),
        })
    }

    /// Number of nodes.
    #[must_use]
    pub fn nodes(&self) -> usize {
        self.structure.positions.len()
    }

    /// Shape described by the positions and slopes of the structure.
    #[must_use]
    pub fn initial_shape(&self) -> Shape<D> {
        let s = &self.structure;
        s.positions
            .iter()
            .zip(&s.slopes)
            .map(|(r, t)| {
                let mut node = [0.0; D];
                node[..DIM].copy_from_slice(&r[..DIM]);
                node[DIM..].copy_from_slice(&t[..D - DIM]);
                node
            })
            .collect()
    }

    /// Position of a node.
    #[must_use]
    pub fn position(shape: &Shape<D>, node: usize) -> [f64; DIM] {
        let mut r = [0.0; DIM];
        r.copy_from_slice(&shape[node][..DIM]);
        r
    }

    /// Coordinates of a wire element.
    #[must_use]
    pub fn coordinates(shape: &Shape<D>, wire: &Wire) -> Coordinates<DIM> {
        wire.coordinate_slots().map(|(node, slot)| {
            let mut r = [0.0; DIM];
            r.copy_from_slice(&shape[node][slot * DIM..(slot + 1) * DIM]);
            r
        })
    }

    /// Coordinates of a wire element in its frame, in which it stretches and bends: see
    /// [`frame`](crate::element::frame).
    #[must_use]
    pub fn frame_coordinates(shape: &Shape<D>, wire: &Wire) -> Coordinates<DIM> {
        let mut e = Self::coordinates(shape, wire);
        if let Some(frame) = Frame::new::<DIM>(wire.turn) {
            for (k, r) in e.iter_mut().enumerate() {
                *r = frame::to_frame(&frame.matrix(k / 2, k % 2 == 1), r);
            }
        }
        e
    }

    /// Internal forces of a wire element, without its weight.
    pub(super) fn wire_force(shape: &Shape<D>, wire: &Wire) -> Coordinates<DIM> {
        let mut force = [[0.0; DIM]; 4];
        let e = Self::frame_coordinates(shape, wire);
        hermite::add_force(&wire.section, &e, &mut force);
        if let Some(frame) = Frame::new::<DIM>(wire.turn) {
            for (k, f) in force.iter_mut().enumerate() {
                *f = frame::from_frame(&frame.matrix(k / 2, k % 2 == 1), f);
            }
        }
        force
    }

    /// State of a link.
    #[must_use]
    pub fn link_state(shape: &Shape<D>, link: &Link) -> BarState<DIM> {
        let [a, b] = link.nodes.map(|n| Self::position(shape, n));
        BarState::new(&a, &b, link.rest_length, link.stiffness)
    }

    /// State of the bar from a strut's node to its ground point.
    #[must_use]
    pub fn strut_state(shape: &Shape<D>, strut: &crate::structure::Strut) -> BarState<DIM> {
        let mut anchor = [0.0; DIM];
        anchor.copy_from_slice(&strut.anchor[..DIM]);
        let node = Self::position(shape, strut.node);
        BarState::new(&node, &anchor, strut.rest_length, strut.stiffness)
    }

    /// Computes the residual, internal minus external forces, N, without the forces of links,
    /// struts and springs.
    pub fn wire_and_weight_residual(&self, shape: &Shape<D>, residual: &mut Shape<D>) {
        let s = &self.structure;
        residual.iter_mut().for_each(|r| *r = [0.0; D]);
        for wire in &s.wires {
            let mut force = Self::wire_force(shape, wire);
            add_weight(wire, s.gravity, &mut force);
            for ((node, slot), f) in wire.coordinate_slots().into_iter().zip(&force) {
                for c in 0..DIM {
                    residual[node][slot * DIM + c] += f[c];
                }
            }
        }
        self.add_chain_forces(shape, residual);
        self.add_wire_loads(residual);
        for m in &s.masses {
            residual[m.node][Self::UP] += m.mass * s.gravity;
        }
        for link in &s.links {
            let weight = link.mass * Self::link_state(shape, link).length * s.gravity;
            for node in link.nodes {
                residual[node][Self::UP] += 0.5 * weight;
            }
        }
        for strut in &s.struts {
            residual[strut.node][Self::UP] += strut.hanging_mass * s.gravity;
        }
        for &(node, component, force) in &s.loads {
            residual[node][component] -= force;
        }
    }

    /// Adds the forces of links, struts and springs to the residual, N.
    pub fn add_link_and_support_forces(
        &self,
        shape: &Shape<D>,
        law: LinkLaw,
        residual: &mut Shape<D>,
    ) {
        let s = &self.structure;
        for link in &s.links {
            let state = Self::link_state(shape, link);
            let tension = match law {
                LinkLaw::Unilateral => link_tension(link, &state),
                LinkLaw::Linear => state.linear_tension,
            };
            add_pair(residual, link.nodes, &state.direction, tension);
        }
        for strut in &s.struts {
            let state = Self::strut_state(shape, strut);
            for c in 0..DIM {
                residual[strut.node][c] -= state.linear_tension * state.direction[c];
            }
        }
        for spring in &s.springs {
            residual[spring.node][spring.component] +=
                spring.stiffness * (shape[spring.node][spring.component] - spring.rest);
        }
    }

    /// Matrix of zeros with the pattern of all elements of the structure.
    #[must_use]
    pub fn empty_matrix(&self) -> SymmetricBlocks<D> {
        let wires = self.structure.wires.iter().flat_map(|w| {
            let ([a, b], [c, d]) = (w.nodes, w.slope_nodes);
            [(a, b), (a, c), (a, d), (b, c), (b, d), (c, d)]
        });
        let links = self
            .structure
            .links
            .iter()
            .map(|l| (l.nodes[0], l.nodes[1]));
        let chains = self.chain_pairs();
        SymmetricBlocks::with_pattern(self.nodes(), wires.chain(chains).chain(links))
    }

    /// Adds the tangent of one wire element, times `factor`.
    pub fn add_wire(k: &mut SymmetricBlocks<D>, shape: &Shape<D>, wire: &Wire, factor: f64) {
        let tangent = tangent::tangent(&wire.section, &Self::frame_coordinates(shape, wire));
        Self::add_element(k, wire, &tangent, factor);
    }

    /// Adds a matrix of one wire element in its frame, times `factor`.
    pub(super) fn add_element(
        k: &mut SymmetricBlocks<D>,
        wire: &Wire,
        tangent: &Tangent<DIM>,
        factor: f64,
    ) {
        let (slots, frame) = (wire.coordinate_slots(), Frame::new::<DIM>(wire.turn));
        for (m, &(i, p)) in slots.iter().enumerate() {
            for (n, &(j, q)) in slots.iter().enumerate().filter(|&(_, &(j, _))| i >= j) {
                let mut part = tangent[m][n].map(|row| row.map(|value| factor * value));
                if let Some(frame) = &frame {
                    let [left, right] = [m, n].map(|k| frame.matrix(k / 2, k % 2 == 1));
                    part = frame::congruence(&left, &part, &right);
                }
                k.add_part((i, j), (p * DIM, q * DIM), &part);
            }
        }
    }

    /// Adds a stiffness between the positions of two nodes, N/m.
    pub fn add_between(
        k: &mut SymmetricBlocks<D>,
        nodes: [usize; 2],
        stiffness: &[[f64; DIM]; DIM],
    ) {
        let [i, j] = nodes;
        k.add_part((i, i), (0, 0), stiffness);
        k.add_part((j, j), (0, 0), stiffness);
        let other = stiffness.map(|row| row.map(|value| -value));
        k.add_part((i.max(j), i.min(j)), (0, 0), &other);
    }

    /// Computes the tangent stiffness of the whole structure in service.
    pub fn tangent(&self, shape: &Shape<D>, law: LinkLaw, k: &mut SymmetricBlocks<D>) {
        k.clear();
        self.add_fixed_tangent(1.0, k);
        self.add_moving_tangent(shape, law, 1.0, k);
    }

    /// Adds the tangent that does not change with the shape, of springs and bends, times `factor`.
    pub fn add_fixed_tangent(&self, factor: f64, k: &mut SymmetricBlocks<D>) {
        for spring in &self.structure.springs {
            Self::add_spring(k, spring, factor * spring.stiffness);
        }
        for bend in &self.structure.bends {
            self.add_bend(k, bend, factor);
        }
    }

    /// Adds the tangent that changes with the shape, of wires, links and struts, times `factor`.
    pub fn add_moving_tangent(
        &self,
        shape: &Shape<D>,
        law: LinkLaw,
        factor: f64,
        k: &mut SymmetricBlocks<D>,
    ) {
        let s = &self.structure;
        for wire in &s.wires {
            Self::add_wire(k, shape, wire, factor);
        }
        for segment in &s.segments {
            Self::add_segment(k, shape, segment, factor);
        }
        for link in &s.links {
            let tangent = Self::link_tangent(shape, link, law, factor);
            Self::add_between(k, link.nodes, &tangent);
        }
        for strut in &s.struts {
            Self::add_strut(k, shape, strut, factor);
        }
    }

    /// Adds the tangent of a strut, times `factor`.
    pub fn add_strut(
        k: &mut SymmetricBlocks<D>,
        shape: &Shape<D>,
        strut: &crate::structure::Strut,
        factor: f64,
    ) {
        let state = Self::strut_state(shape, strut);
        let tangent = state.tangent(strut.stiffness, state.linear_tension);
        let part = tangent.map(|row| row.map(|value| factor * value));
        k.add_part((strut.node, strut.node), (0, 0), &part);
    }

    /// Adds a coefficient at the component a spring acts on.
    pub fn add_spring(k: &mut SymmetricBlocks<D>, spring: &crate::structure::Spring, value: f64) {
        let mut block = [[0.0; D]; D];
        block[spring.component][spring.component] = value;
        k.add(spring.node, spring.node, &block);
    }

    /// Residual below which forces balance to rounding, N: the axial force is a difference of
    /// coordinates of size `extent`, so it carries an error EA · ε · extent / L. Eight such
    /// errors may meet at a node. Tighter cannot be reached; looser loses digits of the shape.
    #[must_use]
    pub fn force_rounding(&self) -> f64 {
        let stiffest = |w: &Wire| w.section.axial_stiffness / w.section.rest_length;
        let stiffest_wire_or_chain = self
            .structure
            .wires
            .iter()
            .map(stiffest)
            .fold(self.stiffest_chain(), f64::max);
        8.0 * f64::EPSILON * self.extent() * stiffest_wire_or_chain
    }

    /// Residual at which an iteration ends, N. Where many wires meet, more than eight errors may;
    /// an iteration that should have converged long ago then changes by rounding alone.
    #[must_use]
    pub fn rounding_after(iterations: usize, rounding: f64) -> f64 {
        if iterations < LONG_CONVERGED {
            rounding
        } else {
            2.0 * rounding
        }
    }

    /// Largest coordinate along the track, m, at least 1.
    fn extent(&self) -> f64 {
        self.structure
            .positions
            .iter()
            .map(|p| p[0].abs())
            .fold(1.0, f64::max)
    }
}

/// Tension of a link, N: none in compression when it is unilateral.
#[must_use]
pub fn link_tension<const DIM: usize>(link: &Link, state: &BarState<DIM>) -> f64 {
    if link.unilateral {
        state.linear_tension.max(0.0)
    } else {
        state.linear_tension
    }
}

/// Adds the internal force of a bar with tension `t`, N; `n` points from the first to the second
/// node.
pub fn add_pair<const DIM: usize, const D: usize>(
    residual: &mut Shape<D>,
    nodes: [usize; 2],
    n: &[f64; DIM],
    t: f64,
) {
    for c in 0..DIM {
        residual[nodes[0]][c] -= t * n[c];
        residual[nodes[1]][c] += t * n[c];
    }
}

/// Adds the weight of a wire element, ∫ Sₖ μ g ds, N, to internal forces (it points up in the
/// residual).
pub(super) fn add_weight<const DIM: usize>(
    wire: &Wire,
    gravity: f64,
    force: &mut Coordinates<DIM>,
) {
    let l = wire.section.rest_length;
    let w = wire.mass * gravity * l;
    for (k, factor) in [0.5, l / 12.0, 0.5, -l / 12.0].into_iter().enumerate() {
        force[k][DIM - 1] += w * factor;
    }
}

/// Largest component of a residual over the free degrees of freedom, N, and its node.
#[must_use]
pub fn largest_residual<const D: usize>(residual: &Shape<D>, free: &[[bool; D]]) -> (f64, usize) {
    let mut worst = (0.0, 0);
    for (node, (r, f)) in residual.iter().zip(free).enumerate() {
        for c in 0..D {
            if f[c] && (r[c].abs() > worst.0 || r[c].is_nan()) {
                worst = (r[c].abs(), node);
            }
        }
    }
    worst
}
