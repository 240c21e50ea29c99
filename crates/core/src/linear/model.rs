//! The structure linearised about its equilibrium.
//!
//!   M ü + C u̇ + K u = f,   C = Σ α M + β K (per part) + dampers
//!
//! With `across_only` nothing moves along the track and the tensions stay those at rest, as in
//! programs with transverse motion alone. With x fixed the strain of a wire still is ½ r′·r′ + …,
//! so a motion w on a slope z′ would stretch it by z′w′, which on a real wire the motion along it
//! cancels. So that stretch is neglected as well, ∂H = 0, and a wire of horizontal force H is a
//! string, or beam:
//!
//!   μ ẅ = ∂/∂x (H ∂w/∂x) − ∂²/∂x² (EI ∂²w/∂x²),    K = ∫ H (∂w/∂x)² + EI (∂²w/∂x²)² dx
//!
//! K and C contain unilateral links as if they could push; [`LinearLink`] keeps the data that
//! cancel their compression in the complementarity problem. Slack links keep the small lateral
//! stiffness T/ℓ of their equilibrium: that is the limit of linearised kinematics.

use crate::linalg::{Block, MassMatrix, SymmetricBlocks};
use crate::linear::island::{Island, Lists};
use crate::linear::masses;
use crate::slideline::point::Nodal;
use crate::statics::assembly::{Geometry, LinkLaw, Shape};
use crate::structure::{Link, Rayleigh};
use std::ops::Range;

/// Link about equilibrium: elongation e = n·(u₂ − u₁).
#[derive(Debug, Clone, Copy)]
pub struct LinearLink<const DIM: usize> {
    /// Upper and lower node.
    pub nodes: [usize; 2],
    /// Unit vector n from the upper to the lower node.
    pub direction: [f64; DIM],
    /// Stiffness, N/m.
    pub stiffness: f64,
    /// Damping along the link, with its proportional part, N·s/m.
    pub viscosity: f64,
    /// Tension k (ℓ − ℓ₀) at equilibrium, N; negative when it is slack at equilibrium.
    pub rest_tension: f64,
    /// True for a link that carries tension only.
    pub unilateral: bool,
}

impl<const DIM: usize> LinearLink<DIM> {
    fn new<const D: usize>(link: &Link, shape: &Shape<D>) -> Self {
        let state = Geometry::<DIM, D>::link_state(shape, link);
        Self {
            nodes: link.nodes,
            direction: state.direction,
            stiffness: link.stiffness,
            viscosity: link.viscosity + link.damping.beta * link.stiffness,
            rest_tension: state.linear_tension,
            unilateral: link.unilateral,
        }
    }

    /// Returns the correction r₀ that acts at equilibrium, N: positive for a link that is slack
    /// there.
    #[must_use]
    pub fn rest_correction(&self) -> f64 {
        if self.unilateral {
            (-self.rest_tension).max(0.0)
        } else {
            0.0
        }
    }

    /// Returns the elongation e = gᵀx in a displacement field x, m.
    #[inline(always)]
    #[must_use]
    pub fn elongation<const D: usize>(&self, x: &(impl Nodal<D> + ?Sized)) -> f64 {
        let [a, b] = self.nodes.map(|node| x.at(node));
        let mut e = 0.0;
        for c in 0..DIM {
            e += self.direction[c] * (b[c] - a[c]);
        }
        e
    }

    /// Returns g, node by node: the forces of a unit tension.
    #[must_use]
    pub fn unit_pull<const D: usize>(&self) -> [(usize, [f64; D]); 2] {
        let [a, b] = self.nodes;
        let (mut upper, mut lower) = ([0.0; D], [0.0; D]);
        for c in 0..DIM {
            upper[c] = -self.direction[c];
            lower[c] = self.direction[c];
        }
        [(a, upper), (b, lower)]
    }

    /// Returns `factor` · g, entry by entry: node, component, force.
    pub(crate) fn shares(&self, factor: f64) -> impl Iterator<Item = (usize, usize, f64)> {
        let ([a, b], n) = (self.nodes, self.direction);
        let ends = [(a, -factor), (b, factor)].into_iter();
        ends.flat_map(move |(node, force)| (0..DIM).map(move |c| (node, c, force * n[c])))
    }

    /// Adds `factor` · g to `f`.
    pub fn add_to<const D: usize>(&self, factor: f64, f: &mut [[f64; D]]) {
        let [a, b] = self.nodes;
        for c in 0..DIM {
            f[a][c] -= factor * self.direction[c];
            f[b][c] += factor * self.direction[c];
        }
    }
}

/// Matrices and links of the linearised structure.
#[derive(Debug, Clone)]
pub struct LinearModel<const DIM: usize, const D: usize> {
    /// Static shape from which motion is measured, m.
    pub shape: Shape<D>,
    /// Components of each node that can move.
    pub free: Vec<[bool; D]>,
    /// Tangent stiffness K, all links linear.
    pub stiffness: SymmetricBlocks<D>,
    /// Mass matrix M.
    pub mass: MassMatrix<DIM, D>,
    /// α and β shared by most of the structure.
    pub common: Rayleigh,
    /// Σ (α − α_common) M over the parts that differ; `None` when none does.
    pub mass_damping_rest: Option<MassMatrix<DIM, D>>,
    /// Blocks (row ≥ column) of C − α M − β K that are not zero.
    pub damping_rest: Vec<(usize, usize, Block<D>)>,
    /// Links.
    pub links: Vec<LinearLink<DIM>>,
    /// Dampers to ground: node, component, N·s/m.
    pub ground_dampers: Vec<(usize, usize, f64)>,
    /// True when nothing moves along the track.
    pub across_only: bool,
}

impl<const DIM: usize, const D: usize> LinearModel<DIM, D> {
    /// Linearises about `shape`, an equilibrium of `geometry`.
    #[must_use]
    pub fn new(geometry: &Geometry<DIM, D>, shape: Shape<D>) -> Self {
        let s = &geometry.structure;
        let n = geometry.nodes();
        let mut stiffness = geometry.empty_matrix();
        geometry.tangent(&shape, LinkLaw::Linear, &mut stiffness);
        if s.across_only {
            subtract_stretching(geometry, &shape, |_| 1.0, &mut stiffness);
        }
        let hermite = s.wires.iter().map(|w| w.damping);
        let chains = s.segments.iter().map(|k| k.damping);
        let common = hermite.chain(chains).next().unwrap_or_default();
        let mut mass = MassMatrix::zero(n);
        let mut mass_rest = MassMatrix::zero(n);
        let mut uniform = true;
        let on_wires = masses::on_wires(geometry, &shape, common.alpha);
        for point in on_wires.chain(masses::of_segments(geometry)) {
            mass.add_point(point.node, point.mass);
            if point.alpha != common.alpha && point.mass > 0.0 {
                mass_rest.add_point(point.node, (point.alpha - common.alpha) * point.mass);
                uniform = false;
            }
        }
        for w in &s.wires {
            mass.add_hermite(w.coordinate_slots(), w.mass, w.section.rest_length, 1.0);
            let difference = w.damping.alpha - common.alpha;
            if difference != 0.0 {
                mass_rest.add_hermite(
                    w.coordinate_slots(),
                    w.mass,
                    w.section.rest_length,
                    difference,
                );
                uniform = false;
            }
        }
        mass.pack();
        mass_rest.pack();
        Self {
            free: free_components(geometry),
            across_only: s.across_only,
            damping_rest: damping_rest(geometry, &shape, common.beta, &mut geometry.empty_matrix()),
            ground_dampers: s
                .springs
                .iter()
                .map(|p| (p.node, p.component, p.viscosity))
                .collect(),
            links: s.links.iter().map(|l| LinearLink::new(l, &shape)).collect(),
            mass_damping_rest: (!uniform).then_some(mass_rest),
            shape,
            stiffness,
            mass,
            common,
        }
    }

    /// Number of nodes.
    #[must_use]
    pub fn nodes(&self) -> usize {
        self.shape.len()
    }

    /// Forms links and dampers about another position. Masses stay as they are, and so does
    /// `stiffness`, which updated kinematics form elsewhere. `scratch` is a matrix of the
    /// structure's pattern.
    pub fn reform(
        &mut self,
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        scratch: &mut SymmetricBlocks<D>,
    ) {
        // The pattern of this damping does not depend on the position.
        if !self.damping_rest.is_empty() {
            self.damping_rest = damping_rest(geometry, shape, self.common.beta, scratch);
        }
        for (linear, link) in self.links.iter_mut().zip(&geometry.structure.links) {
            *linear = LinearLink::new(link, shape);
        }
    }

    /// Returns c M + d C + k K with the fixed components removed.
    #[must_use]
    pub fn combine(&self, c: f64, d: f64, k: f64) -> SymmetricBlocks<D> {
        let mut a = self.inertia(c, d);
        self.add_stiffness(d, k, &mut a);
        a
    }

    /// Returns c M and the mass-proportional part of d C.
    #[must_use]
    pub fn inertia(&self, c: f64, d: f64) -> SymmetricBlocks<D> {
        let mut a = self.stiffness.clone();
        a.clear();
        self.mass.add_to(c + d * self.common.alpha, &mut a);
        if let Some(rest) = &self.mass_damping_rest {
            rest.add_to(d, &mut a);
        }
        a
    }

    /// Adds k K and the rest of d C, then removes the fixed components.
    pub fn add_stiffness(&self, d: f64, k: f64, a: &mut SymmetricBlocks<D>) {
        let factor = self.stiffness_factor(d, k);
        let stiffness = self.stiffness.blocks.iter().flatten().flatten();
        for (a, k) in a.blocks.iter_mut().flatten().flatten().zip(stiffness) {
            *a += factor * k;
        }
        self.add_damping_rest_matrix(d, a);
        a.keep_free(&self.free);
    }

    /// Returns the factor k + d β of K in k K + d C, with β common to most of the structure.
    #[must_use]
    pub fn stiffness_factor(&self, d: f64, k: f64) -> f64 {
        k + d * self.common.beta
    }

    /// Adds d (C − α M − β K), the damping that is not common to all parts.
    pub fn add_damping_rest_matrix(&self, d: f64, a: &mut SymmetricBlocks<D>) {
        for (i, j, block) in &self.damping_rest {
            let mut scaled = *block;
            scaled.iter_mut().flatten().for_each(|v| *v *= d);
            a.add(*i, *j, &scaled);
        }
    }

    /// Adds the corrections r₀ of links that are slack at rest, N.
    pub fn add_rest_corrections(&self, links: Range<usize>, f: &mut [[f64; D]]) {
        for link in &self.links[links] {
            let correction = link.rest_correction();
            if correction > 0.0 {
                link.add_to(correction, f);
            }
        }
    }

    /// Returns K without the links that are slack at rest, fixed components removed; `None` when
    /// there is no such link.
    #[must_use]
    pub fn stiffness_at_rest(&self) -> Option<SymmetricBlocks<D>> {
        let is_slack = |i: usize| self.links[i].rest_correction() > 0.0;
        let any = (0..self.links.len()).any(is_slack);
        any.then(|| self.stiffness_without(is_slack))
    }

    /// Returns K without the links that are slack, fixed components removed.
    #[must_use]
    pub fn stiffness_without(&self, is_slack: impl Fn(usize) -> bool) -> SymmetricBlocks<D> {
        let mut k = self.stiffness.clone();
        for (_, link) in self.links.iter().enumerate().filter(|(i, _)| is_slack(*i)) {
            let n = &link.direction;
            let mut block = [[0.0; DIM]; DIM];
            for p in 0..DIM {
                for q in 0..DIM {
                    block[p][q] = -link.stiffness * n[p] * n[q];
                }
            }
            Geometry::<DIM, D>::add_between(&mut k, link.nodes, &block);
        }
        k.keep_free(&self.free);
        k
    }

    /// Adds (C − α M − β K) x to `y` on one island: the damping that is not common to all parts.
    /// `work` is scratch space.
    #[inline(always)]
    pub fn add_damping_rest(
        &self,
        island: &Island,
        x: &[[f64; D]],
        y: &mut [[f64; D]],
        work: &mut [[f64; D]],
    ) {
        if let Some(rest) = &self.mass_damping_rest {
            rest.product_at(island.nodes.clone(), x, work);
            let nodes = y[island.nodes.clone()].iter_mut();
            for (y, w) in nodes.zip(&work[island.nodes.clone()]) {
                for c in 0..D {
                    y[c] += w[c];
                }
            }
        }
        for (i, j, block) in &self.damping_rest[island.damping.clone()] {
            let (xi, xj) = (x[*i], x[*j]);
            crate::linalg::block::add_product(&mut y[*i], block, &xj);
            if i != j {
                for a in 0..D {
                    for b in 0..D {
                        y[*j][b] += block[a][b] * xi[a];
                    }
                }
            }
        }
    }

    /// Returns the fixed components: node, component; by nodes.
    pub(crate) fn fixed(&self) -> Vec<(u32, u32)> {
        let of_node = |(node, free): (usize, &[bool; D])| {
            let fixed = free.iter().enumerate().filter(|(_, free)| !**free);
            let fixed = fixed.map(|(k, _)| (node as u32, k as u32));
            fixed.collect::<Vec<_>>()
        };
        self.free.iter().enumerate().flat_map(of_node).collect()
    }

    /// Returns the islands: parts of the line that nothing couples.
    pub(crate) fn islands(&self) -> Vec<Island> {
        let links: Vec<usize> = self.links.iter().map(|link| link.nodes[0]).collect();
        Island::all(&Lists {
            stiffness: &self.stiffness,
            links: &links,
            damping: &self.damping_rest,
            fixed: &self.fixed(),
            shape: &self.shape,
        })
    }

    /// Sets the fixed components to zero.
    pub fn mask(&self, x: &mut [[f64; D]]) {
        for (value, free) in x.iter_mut().zip(&self.free) {
            for c in 0..D {
                if !free[c] {
                    value[c] = 0.0;
                }
            }
        }
    }
}

/// Returns the components of each node that can move.
fn free_components<const DIM: usize, const D: usize>(
    geometry: &Geometry<DIM, D>,
) -> Vec<[bool; D]> {
    let mut free = geometry.service_mask();
    if geometry.structure.across_only {
        for node in &mut free {
            (0..D).step_by(DIM).for_each(|along| node[along] = false);
        }
    }
    free
}

/// Subtracts the axial part of the tangents of all wires, times a factor that depends on their
/// damping.
fn subtract_stretching<const DIM: usize, const D: usize>(
    geometry: &Geometry<DIM, D>,
    shape: &Shape<D>,
    factor: impl Fn(Rayleigh) -> f64,
    k: &mut SymmetricBlocks<D>,
) {
    for wire in &geometry.structure.wires {
        Geometry::<DIM, D>::add_wire_stretching(k, shape, wire, -factor(wire.damping));
    }
    for segment in &geometry.structure.segments {
        Geometry::<DIM, D>::add_segment_stretching(k, shape, segment, -factor(segment.damping));
    }
}

/// Returns the blocks of Σ (β − β₀) K over the parts whose β differs, plus all dampers.
fn damping_rest<const DIM: usize, const D: usize>(
    geometry: &Geometry<DIM, D>,
    shape: &Shape<D>,
    common: f64,
    c: &mut SymmetricBlocks<D>,
) -> Vec<(usize, usize, Block<D>)> {
    let s = &geometry.structure;
    c.clear();
    for wire in s.wires.iter().filter(|w| w.damping.beta != common) {
        Geometry::<DIM, D>::add_wire(c, shape, wire, wire.damping.beta - common);
    }
    for segment in s.segments.iter().filter(|k| k.damping.beta != common) {
        let difference = segment.damping.beta - common;
        Geometry::<DIM, D>::add_segment(c, shape, segment, difference);
    }
    if s.across_only {
        subtract_stretching(geometry, shape, |damping| damping.beta - common, c);
    }
    for bend in s.bends.iter().filter(|b| b.beta != common) {
        geometry.add_bend(c, bend, bend.beta - common);
    }
    for link in &s.links {
        let damping = Geometry::<DIM, D>::link_damping(shape, link, link.damping.beta - common);
        Geometry::<DIM, D>::add_between(c, link.nodes, &damping);
    }
    for strut in s.struts.iter().filter(|_| common != 0.0) {
        Geometry::<DIM, D>::add_strut(c, shape, strut, -common);
    }
    for spring in &s.springs {
        let value = spring.viscosity - common * spring.stiffness;
        Geometry::<DIM, D>::add_spring(c, spring, value);
    }
    let mut rest = Vec::new();
    for i in 0..c.rows() {
        for k in c.row_start[i]..c.row_start[i + 1] {
            if c.blocks[k].iter().flatten().any(|&v| v != 0.0) {
                rest.push((i, c.columns[k], c.blocks[k]));
            }
        }
    }
    rest
}
