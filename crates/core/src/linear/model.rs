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
use crate::linear::damping_rest::{damping_rest, subtract_stretching};
use crate::linear::island::{Island, Lists};
use crate::linear::link::LinearLink;
use crate::linear::masses;
use crate::linear::supports::{LinearSpring, LinearStrut};
use crate::statics::assembly::{Geometry, LinkLaw, Shape};
use crate::structure::Rayleigh;
use std::ops::Range;

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
    /// Springs and dampers to ground.
    pub springs: Vec<LinearSpring>,
    /// Steady arms.
    pub struts: Vec<LinearStrut<DIM>>,
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
            springs: springs(geometry, &shape),
            struts: s
                .struts
                .iter()
                .map(|t| LinearStrut::new(t, &shape))
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

    /// Adds d (C − α M − β K), the damping that is not common to all parts.
    pub fn add_damping_rest_matrix(&self, d: f64, a: &mut SymmetricBlocks<D>) {
        for (i, j, block) in &self.damping_rest {
            let mut scaled = *block;
            scaled.iter_mut().flatten().for_each(|v| *v *= d);
            a.add(*i, *j, &scaled);
        }
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
}

/// Returns the springs about equilibrium.
fn springs<const DIM: usize, const D: usize>(
    geometry: &Geometry<DIM, D>,
    shape: &Shape<D>,
) -> Vec<LinearSpring> {
    let s = &geometry.structure;
    let all = s.springs.iter().enumerate();
    all.map(|(row, spring)| {
        let residual = s.residual.as_ref();
        let alone = residual.map_or(spring.stiffness, |r| r.springs[row]);
        LinearSpring::new(spring, alone, shape)
    })
    .collect()
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
