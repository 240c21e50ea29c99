//! Static response of the linearised line to vertical forces, and its compliance; see `elasticity`
//! for wires that are lifted together.
//!
//!   K u = C p − G (r − r₀),   T = T₀ + k gᵀu + r ≥ 0,   r ≥ 0,   T r = 0
//!
//! The correction r of unilateral links is found by the same complementarity solver as in the
//! steps, with H = 1/k − GᵀK⁻¹G.

use crate::error::CoreError;
use crate::lcp::LcpSolver;
use crate::linalg::BlockLdl;
use crate::linear::model::LinearModel;
use crate::slideline::local_compliance::LocalCompliance;
use crate::slideline::point::SlidelinePoint;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// Factors of the stiffness of a line.
#[derive(Debug, Clone)]
pub struct StaticFactors<const D: usize> {
    /// Factor of K with every link linear: the corrections r are on the right-hand side.
    pub linear: BlockLdl<D>,
    /// Factor of the stiffness at rest, without the links that are slack there; `None` when there
    /// are none: `linear` is used then.
    at_rest: Option<BlockLdl<D>>,
}

impl<const D: usize> StaticFactors<D> {
    /// Factorises the stiffness of a line.
    ///
    /// # Errors
    /// [`CoreError::Singular`] when the line is loose.
    pub(crate) fn new<const DIM: usize>(line: &LinearModel<DIM, D>) -> Result<Self, CoreError> {
        let at_rest = line.stiffness_at_rest().map(|k| BlockLdl::new(&k));
        Ok(Self {
            linear: BlockLdl::new(&line.combine(0.0, 0.0, 1.0))?,
            at_rest: at_rest.transpose()?,
        })
    }
}

/// Static solver of a linearised line.
#[derive(Debug)]
pub struct StaticSolver<'a, const DIM: usize, const D: usize> {
    pub(crate) line: &'a LinearModel<DIM, D>,
    factors: Cow<'a, StaticFactors<D>>,
    influence_vectors: BTreeMap<usize, Vec<[f64; D]>>,
    solver: LcpSolver,
    scratch: Vec<[f64; D]>,
}

/// Displacement under static forces.
#[derive(Debug, Clone)]
pub struct StaticState<const D: usize> {
    /// Displacement, m.
    pub u: Vec<[f64; D]>,
    /// Corrections of the links, N: positive where slack.
    pub correction: Vec<f64>,
    /// Tensions of the links, N; empty with updated kinematics.
    pub(crate) tension: Vec<f64>,
}

impl<const D: usize> StaticState<D> {
    /// Returns the height of a point above the mesh by its links, relative to the line at rest: Σ
    /// R_d ΔT, m.
    pub(crate) fn rise_by_links<const DIM: usize>(
        &self,
        line: &LinearModel<DIM, D>,
        compliance: &LocalCompliance,
    ) -> f64 {
        let rises = compliance.links().map(|(link, rise)| {
            let at_rest = &line.links[link];
            let tension_change =
                self.tension[link] - at_rest.rest_tension - at_rest.rest_correction();
            rise * tension_change
        });
        rises.sum()
    }
}

impl<'a, const DIM: usize, const D: usize> StaticSolver<'a, DIM, D> {
    /// Factorises the stiffness.
    ///
    /// # Errors
    /// [`CoreError::Singular`] when the line is loose.
    pub fn new(line: &'a LinearModel<DIM, D>) -> Result<Self, CoreError> {
        Ok(Self::from_factors(
            line,
            Cow::Owned(StaticFactors::new(line)?),
        ))
    }

    /// Returns a static solver with borrowed factors.
    pub(crate) fn with_factors(
        line: &'a LinearModel<DIM, D>,
        factors: &'a StaticFactors<D>,
    ) -> Self {
        Self::from_factors(line, Cow::Borrowed(factors))
    }

    fn from_factors(line: &'a LinearModel<DIM, D>, factors: Cow<'a, StaticFactors<D>>) -> Self {
        Self {
            line,
            factors,
            influence_vectors: BTreeMap::new(),
            solver: LcpSolver::new(),
            scratch: vec![[0.0; D]; line.nodes()],
        }
    }

    /// Finds the displacement under vertical forces (N, upwards) at points of the mesh, without
    /// residual flexibility.
    ///
    /// # Errors
    /// [`CoreError::Lcp`] or [`CoreError::SlackSet`], as of step 0.
    pub fn solve(
        &mut self,
        points: &[SlidelinePoint<DIM>],
        forces: &[f64],
    ) -> Result<StaticState<D>, CoreError> {
        let points = points
            .iter()
            .map(|point| (*point, LocalCompliance::default()));
        self.solve_with_compliance(&points.collect::<Vec<_>>(), forces)
    }

    /// Finds the displacement under vertical forces (N, upwards) at points with local compliance
    /// beyond the mesh.
    pub(crate) fn solve_with_compliance(
        &mut self,
        points: &[(SlidelinePoint<DIM>, LocalCompliance)],
        forces: &[f64],
    ) -> Result<StaticState<D>, CoreError> {
        let links = &self.line.links;
        let mut free = vec![[0.0; D]; self.line.nodes()];
        let mut rest: Vec<f64> = links.iter().map(|l| l.rest_tension).collect();
        for ((point, compliance), &force) in points.iter().zip(forces) {
            point.add_force(force, DIM - 1, &mut free);
            for (link, rise) in compliance.links() {
                let tension_relief = links[link].stiffness * rise * force;
                links[link].add_to(tension_relief, &mut free);
                rest[link] -= tension_relief;
            }
        }
        links
            .iter()
            .for_each(|l| l.add_to(l.rest_correction(), &mut free));
        self.line.mask(&mut free);
        self.factors.linear.solve(&mut free, &mut self.scratch);
        let mut correction = vec![0.0; links.len()];
        let mut active: Vec<usize> = Vec::new();
        let mut u = free.clone();
        // Every round adds at least one link, so there are at most as many rounds as links.
        for _ in 0..=links.len() {
            let would_push = |i: usize| {
                let l = &links[i];
                l.unilateral && rest[i] + l.stiffness * l.elongation(&u) < 0.0
            };
            let entering: Vec<usize> = (0..links.len())
                .filter(|i| !active.contains(i) && would_push(*i))
                .collect();
            if entering.is_empty() {
                let tension = |(i, r): (usize, &f64)| {
                    rest[i] + links[i].stiffness * links[i].elongation(&u) + r
                };
                return Ok(StaticState {
                    tension: correction.iter().enumerate().map(tension).collect(),
                    u,
                    correction,
                });
            }
            active.extend(entering);
            self.solve_corrections((&active, &rest), &free, &mut u, &mut correction)?;
        }
        Err(CoreError::SlackSet { step: 0, time: 0.0 })
    }

    fn solve_corrections(
        &mut self,
        (active, rest): (&[usize], &[f64]),
        free: &[[f64; D]],
        u: &mut [[f64; D]],
        correction: &mut [f64],
    ) -> Result<(), CoreError> {
        let n = active.len();
        for &i in active {
            self.compute_influence_vector(i);
        }
        let links = &self.line.links;
        let (mut h, mut w) = (vec![0.0; n * n], vec![0.0; n]);
        for (a, &i) in active.iter().enumerate() {
            let l = &links[i];
            for (b, j) in active.iter().enumerate() {
                h[a * n + b] = -self
                    .influence_vectors
                    .get(j)
                    .map_or(0.0, |influence| l.elongation(influence));
            }
            h[a * n + a] += 1.0 / l.stiffness;
            w[a] = rest[i] / l.stiffness + l.elongation(free);
        }
        let (mut x, mut y) = (vec![0.0; n], vec![0.0; n]);
        self.solver
            .solve(&h, &w, &mut x, &mut y, &[])
            .map_err(|failure| CoreError::Lcp {
                step: 0,
                time: 0.0,
                contacts: Vec::new(),
                links: active.to_vec(),
                stops: Vec::new(),
                failure: Box::new(failure),
            })?;
        u.copy_from_slice(free);
        for (&i, &r) in active.iter().zip(&x) {
            correction[i] = r;
            let Some(influence) = self.influence_vectors.get(&i) else {
                continue;
            };
            for (target, value) in u.iter_mut().zip(influence) {
                for c in 0..D {
                    target[c] -= r * value[c];
                }
            }
        }
        Ok(())
    }

    /// Computes the influence vector K⁻¹g of a link, unless it is known.
    fn compute_influence_vector(&mut self, link: usize) {
        if !self.influence_vectors.contains_key(&link) {
            let mut influence = vec![[0.0; D]; self.line.nodes()];
            self.line.links[link].add_to(1.0, &mut influence);
            self.line.mask(&mut influence);
            self.factors.linear.solve(&mut influence, &mut self.scratch);
            self.influence_vectors.insert(link, influence);
        }
    }

    /// Returns the vertical displacements of points under unit vertical forces on them, m/N, row by
    /// row, for small motion about the state at rest: links that are slack there are left out. R
    /// between points is not contained.
    pub(crate) fn compliance_matrix(
        &self,
        points: &[(SlidelinePoint<DIM>, LocalCompliance)],
    ) -> Vec<f64> {
        let factors = &self.factors;
        let factor = factors.at_rest.as_ref().unwrap_or(&factors.linear);
        let links = &self.line.links;
        compliance_matrix(self.line, factor, points, |link| {
            links[link].rest_correction() > 0.0
        })
    }
}

/// Returns the displacement of point i under a unit force at point k, m/N, row by row, without R
/// between them. `factor` is that of the stiffness without slack links.
pub(crate) fn compliance_matrix<const DIM: usize, const D: usize>(
    line: &LinearModel<DIM, D>,
    factor: &BlockLdl<D>,
    points: &[(SlidelinePoint<DIM>, LocalCompliance)],
    is_slack: impl Fn(usize) -> bool,
) -> Vec<f64> {
    let n = points.len();
    let (mut matrix, mut scratch) = (vec![0.0; n * n], vec![[0.0; D]; line.nodes()]);
    let taut_links = |y: &LocalCompliance| {
        y.links()
            .filter(|(link, _)| !is_slack(*link))
            .collect::<Vec<_>>()
    };
    // Forces act there, and displacements are read there.
    let touched = points.iter().flat_map(|(point, compliance)| {
        let of_links = taut_links(compliance).into_iter();
        let of_links = of_links.flat_map(|(link, _)| line.links[link].nodes);
        point.nodes.into_iter().chain(of_links)
    });
    let touched: Vec<usize> = touched.collect();
    for (k, (source, source_compliance)) in points.iter().enumerate() {
        let mut u = vec![[0.0; D]; line.nodes()];
        source.add_force(1.0, DIM - 1, &mut u);
        for (link, rise) in taut_links(source_compliance) {
            let link = &line.links[link];
            link.add_to(link.stiffness * rise, &mut u);
        }
        line.mask(&mut u);
        factor.solve_at(&mut u, &touched, &mut scratch);
        for (i, (target, target_compliance)) in points.iter().enumerate() {
            let mut displacement = target.displacement(&u, DIM - 1);
            for (link, rise) in taut_links(target_compliance) {
                let elongation = line.links[link].elongation(&u) - source_compliance.of_link(link);
                displacement += line.links[link].stiffness * rise * elongation;
            }
            matrix[i * n + k] = displacement;
        }
    }
    matrix
}
