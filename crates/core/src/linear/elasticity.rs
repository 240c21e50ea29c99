//! Elasticity of a line at rest, of one wire or of several that are lifted together.
//!
//!   W f = e 1,   1ᵀf = 1,   so   e = 1/(1ᵀW⁻¹1)
//!
//! with W the compliance matrix of the wires, m/N, and f the shares of a unit force.

use crate::error::CoreError;
use crate::linalg::dense;
use crate::linear::static_response::{StaticSolver, StaticState};
use crate::slideline::Slideline;
use crate::slideline::local_compliance::LocalCompliance;
use crate::slideline::point::SlidelinePoint;

/// Displacements of several wires that differ by less than this share count as equal.
const EQUAL_DISPLACEMENTS: f64 = 1e-9;
/// Share of the force over which W is differenced: displacements are linear except where links
/// become slack.
const LOAD_INCREMENT: f64 = 1e-4;
/// Bound on Newton iterations. Each one fixes which links are slack; a few are enough.
const MAX_ITERATIONS: usize = 60;

impl<const DIM: usize, const D: usize> StaticSolver<'_, DIM, D> {
    /// Elasticity e = u/p in m/N at coordinates `x`, for a force `p` in N that lifts all wires
    /// there together. With p = 0 it is the limit of a small force, which neither slackens a link
    /// nor takes up the slack of one.
    ///
    /// # Errors
    /// [`CoreError::Input`] when the force is impossible or the compliance matrix of wires side by
    /// side is singular, [`CoreError::OffWire`], or those of [`StaticSolver::solve`].
    pub fn elasticity(
        &mut self,
        slidelines: &[Slideline<DIM>],
        x: &[f64],
        force: f64,
    ) -> Result<Vec<f64>, CoreError> {
        if !(force.is_finite() && force >= 0.0) {
            return Err(CoreError::Input {
                array: "force",
                reason: format!("{force} N"),
            });
        }
        let mut hints = vec![0; slidelines.len()];
        let rest = self.solve_with_compliance(&[], &[])?;
        x.iter()
            .enumerate()
            .map(|(i, &position)| {
                let mut points = Vec::with_capacity(slidelines.len());
                for (slideline, hint) in slidelines.iter().zip(&mut hints) {
                    if let Some(point) = slideline.locate(position, *hint) {
                        *hint = point.element;
                        points.push((point, slideline.compliance_at(&point)));
                    }
                }
                match points[..] {
                    [] => Err(CoreError::OffWire {
                        pantograph: i,
                        position,
                        step: 0,
                    }),
                    [point] if force > 0.0 => {
                        Ok(self.displacements(&[point], &[force], &rest)?[0] / force)
                    }
                    _ if force > 0.0 => self.common_elasticity(&points, force, &rest),
                    _ => {
                        let w = self.total_compliance_matrix(&points);
                        if points.len() == 1 {
                            return Ok(w[0]);
                        }
                        Ok(load_shares(&w, points.len()).ok_or_else(dependent_wires)?.1)
                    }
                }
            })
            .collect()
    }

    /// Returns W, the compliance matrix with the residual flexibility of each point on its
    /// diagonal, m/N, row by row.
    fn total_compliance_matrix(
        &self,
        points: &[(SlidelinePoint<DIM>, LocalCompliance)],
    ) -> Vec<f64> {
        let n = points.len();
        let mut w = self.compliance_matrix(points);
        for (i, (_, compliance)) in points.iter().enumerate() {
            w[i * n + i] += compliance.flexibility;
        }
        w
    }

    fn displacements(
        &mut self,
        points: &[(SlidelinePoint<DIM>, LocalCompliance)],
        forces: &[f64],
        rest: &StaticState<D>,
    ) -> Result<Vec<f64>, CoreError> {
        let state = self.solve_with_compliance(points, forces)?;
        let displacement_of =
            |((point, compliance), force): (&(SlidelinePoint<DIM>, LocalCompliance), &f64)| {
                let by_mesh =
                    point.displacement(&state.u, DIM - 1) - point.displacement(&rest.u, DIM - 1);
                let by_links = state.rise_by_links(self.line, compliance)
                    - rest.rise_by_links(self.line, compliance);
                by_mesh + by_links + compliance.flexibility * force
            };
        Ok(points.iter().zip(forces).map(displacement_of).collect())
    }

    /// Finds the common displacement per force of several wires, m/N, by Newton's method for the
    /// shares of the force.
    fn common_elasticity(
        &mut self,
        points: &[(SlidelinePoint<DIM>, LocalCompliance)],
        force: f64,
        rest: &StaticState<D>,
    ) -> Result<f64, CoreError> {
        let n = points.len();
        let initial_shares = load_shares(&self.total_compliance_matrix(points), n);
        let mut forces = initial_shares.ok_or_else(dependent_wires)?.0;
        forces.iter_mut().for_each(|f| *f *= force);
        for iteration in 0..MAX_ITERATIONS {
            let displacements = self.displacements(points, &forces, rest)?;
            // The set of slack links changes between iterations, and W with it.
            let mut w = vec![0.0; n * n];
            for j in 0..n {
                let mut perturbed = forces.clone();
                perturbed[j] += LOAD_INCREMENT * force;
                let perturbed_displacements = self.displacements(points, &perturbed, rest)?;
                for i in 0..n {
                    w[i * n + j] =
                        (perturbed_displacements[i] - displacements[i]) / (LOAD_INCREMENT * force);
                }
            }
            let (share, _) = load_shares(&w, n).ok_or_else(dependent_wires)?;
            let mean = inner(&share, &displacements);
            let mut correction: Vec<f64> = displacements
                .iter()
                .map(|displacement| mean - displacement)
                .collect();
            if correction
                .iter()
                .all(|c| c.abs() <= EQUAL_DISPLACEMENTS * mean.abs())
            {
                return Ok(mean / force);
            }
            if !dense::solve_in_place(&mut w, &mut correction) {
                return Err(dependent_wires());
            }
            // Full steps may go to and fro between two sets of slack links.
            let step = if iteration < MAX_ITERATIONS / 4 {
                1.0
            } else {
                0.5
            };
            let pairs = forces.iter_mut().zip(&correction);
            pairs.for_each(|(f, correction)| *f += step * correction);
        }
        Err(CoreError::SlackSet { step: 0, time: 0.0 })
    }
}

/// Finds the shares of a unit force under which all wires have one displacement, and that
/// displacement, m/N; `None` when W is singular.
fn load_shares(w: &[f64], n: usize) -> Option<(Vec<f64>, f64)> {
    let (mut a, mut f) = (w.to_vec(), vec![1.0; n]);
    if !dense::solve_in_place(&mut a, &mut f) {
        return None;
    }
    let sum: f64 = f.iter().sum();
    f.iter_mut().for_each(|f| *f /= sum);
    (1.0 / sum).is_finite().then_some((f, 1.0 / sum))
}

fn dependent_wires() -> CoreError {
    CoreError::Input {
        array: "lanes",
        reason: "wires side by side that do not yield each on its own".into(),
    }
}

fn inner(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
