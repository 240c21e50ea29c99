//! Energy stored by the wires of an island, and energy lost in a step.

use crate::integrator::explicit::energy::filtered_mass::{FilteredMass, energy};
use crate::integrator::explicit::energy::island_field::{IslandField, Workspace, total};
use crate::integrator::explicit::energy::stiff::{FEW, StiffEnergy};
use crate::integrator::explicit::energy::{StepLosses, StoredEnergy};
use crate::integrator::explicit::simd::packed::SIMD_LANES;
use crate::integrator::explicit::stiff_groups::stiff_group::WIDEST;
use crate::integrator::explicit::{ChainState, Explicit};
use std::ops::Range;

/// Axial element with the numbers of its island: masters, first and last point, stiffness in N/m.
#[derive(Debug, Clone, Copy)]
pub(in crate::integrator::explicit::energy) struct IslandElement {
    pub masters: [usize; 2],
    pub points: [usize; 2],
    pub stiffness: f64,
    /// Shortening per motion of both ends to the side, in curves, rad.
    pub half_turn: f64,
}

/// Constant numbers of an island, point by point along its wires.
#[derive(Debug, Clone)]
pub(in crate::integrator::explicit) struct EnergyForm {
    /// Position of the points: ranges of packed rows, each with its SIMD lane.
    pub(in crate::integrator::explicit::energy) stretches: Vec<(Range<usize>, usize)>,
    pub(in crate::integrator::explicit::energy) masters: Range<usize>,
    /// 1/L of the segment behind each point, 1/m; EI*/ℓ̄ of the point, N·m.
    pub(in crate::integrator::explicit::energy) per_length: Vec<f64>,
    pub(in crate::integrator::explicit::energy) bending: Vec<f64>,
    pub(in crate::integrator::explicit::energy) tension: [Vec<f64>; 2],
    pub(in crate::integrator::explicit::energy) slope: [Vec<f64>; 2],
    /// Mass m/h², kg/s²; zero where held, and of tied ends.
    pub(in crate::integrator::explicit::energy) weight: [Vec<f64>; 2],
    /// Damping α h and β/h.
    pub(in crate::integrator::explicit::energy) alpha: Vec<f64>,
    pub(in crate::integrator::explicit::energy) lag: Vec<f64>,
    pub(in crate::integrator::explicit::energy) elements: Vec<IslandElement>,
    pub(in crate::integrator::explicit::energy) stiff_groups: Vec<StiffEnergy>,
    pub(in crate::integrator::explicit::energy) filtered: [FilteredMass; 2],
}

impl EnergyForm {
    /// Returns a workspace of zeros.
    pub(in crate::integrator::explicit::energy) fn workspace(
        &self,
        directions: usize,
    ) -> Workspace {
        let zeros = IslandField::zeros(self.lag.len(), self.masters.len(), directions);
        Workspace {
            y: zeros.clone(),
            d: zeros.clone(),
            old: zeros.clone(),
            work: zeros,
        }
    }

    /// Reads predictor y and increment d.
    #[inline(always)]
    pub(in crate::integrator::explicit::energy) fn read(
        &self,
        chain: &ChainState,
        workspace: &mut Workspace,
    ) {
        for (c, rows) in chain.moving.iter().enumerate() {
            let (mut y, mut d) = (
                &mut workspace.y.transverse[c][..],
                &mut workspace.d.transverse[c][..],
            );
            let mut lag = &self.lag[..];
            for (which, simd_lane) in &self.stretches {
                let (rows, simd_lane) = (&rows[which.clone()], *simd_lane % SIMD_LANES);
                let (here_y, next_y) = y.split_at_mut(rows.len());
                let (here_d, next_d) = d.split_at_mut(rows.len());
                let (here_lag, next_lag) = lag.split_at(rows.len());
                for (k, row) in rows.iter().enumerate() {
                    here_d[k] = row.d[simd_lane];
                    here_y[k] = row.s[simd_lane] - here_lag[k] * row.d[simd_lane];
                }
                (y, d, lag) = (next_y, next_d, next_lag);
            }
        }
        let [x, d] = [0, 1].map(|k| &chain.x[k][self.masters.clone()]);
        workspace.y.axial.copy_from_slice(x);
        workspace.d.axial.copy_from_slice(d);
    }

    /// Returns the bilinear form x·K_E z of the wires, J.
    #[inline(always)]
    fn form(&self, x: &IslandField, z: &IslandField) -> f64 {
        let mut sum = 0.0;
        for c in 0..2 {
            let (x, z) = (&x.transverse[c][..], &z.transverse[c][..]);
            if x.is_empty() {
                continue;
            }
            let pairs = [&self.tension[c][..], x, &x[1..], z, &z[1..]];
            sum += total(pairs, |[t, x0, x1, z0, z1]| t * (x1 - x0) * (z1 - z0));
            if x.len() > 2 {
                sum += self.bending_form(x, z);
            }
        }
        for element in &self.elements {
            sum += element.stiffness * self.elongation(element, x) * self.elongation(element, z);
        }
        sum
    }

    /// Returns the bilinear form of bending in one transverse direction, J.
    #[inline(always)]
    fn bending_form(&self, x: &[f64], z: &[f64]) -> f64 {
        let (b, p) = (&self.bending[1..], &self.per_length[..]);
        let lists = [b, p, &p[1..], x, &x[1..], &x[2..], z, &z[1..], &z[2..]];
        total(lists, |[b, p0, p1, x0, x1, x2, z0, z1, z2]| {
            let (x, z) = (
                (x2 - x1) * p1 - (x1 - x0) * p0,
                (z2 - z1) * p1 - (z1 - z0) * p0,
            );
            b * x * z
        })
    }

    /// Returns the elongation of an axial element, m.
    #[inline(always)]
    fn elongation(&self, element: &IslandElement, f: &IslandField) -> f64 {
        let ([a, b], [from, to]) = (element.masters, element.points);
        let mut elongation = f.axial[b] - f.axial[a];
        if element.half_turn != 0.0 {
            elongation -= element.half_turn * (f.transverse[0][from] + f.transverse[0][to]);
        }
        for (slope, r) in self.slope.iter().zip(&f.transverse) {
            if let Some(r) = r.get(from..=to) {
                let lists = [&slope[from..to], r, &r[1..]];
                elongation += total(lists, |[slope, r0, r1]| slope * (r1 - r0));
            }
        }
        elongation
    }

    /// Returns the stored energies, J, for y and d of the workspace.
    #[inline(always)]
    pub(in crate::integrator::explicit::energy) fn stored<const DIM: usize>(
        &self,
        steps: &Explicit<DIM>,
        workspace: &mut Workspace,
    ) -> StoredEnergy {
        workspace
            .work
            .combine(&workspace.y, &workspace.d, |y, d| y - d);
        let mut elastic = 0.5 * self.form(&workspace.y, &workspace.work);
        for stiff in &self.stiff_groups {
            elastic += match steps.stiff_groups[stiff.number].size {
                ..=FEW => stiff.stored::<DIM, FEW>(steps, workspace),
                _ => stiff.stored::<DIM, WIDEST>(steps, workspace),
            };
        }
        let mut kinetic = energy(&self.filtered, &self.weight, &workspace.d.transverse);
        let inverse = &steps.masters.inverse[self.masters.clone()];
        for (d, inverse) in workspace
            .d
            .axial
            .iter()
            .zip(inverse)
            .filter(|(_, i)| **i > 0.0)
        {
            kinetic += 0.5 * d * d / inverse;
        }
        StoredEnergy { kinetic, elastic }
    }

    /// Returns the energy lost in a step, J, from the increments before and after it.
    #[inline(always)]
    pub(in crate::integrator::explicit::energy) fn losses<const DIM: usize>(
        &self,
        steps: &Explicit<DIM>,
        workspace: &mut Workspace,
    ) -> StepLosses {
        let mut losses = StepLosses::default();
        for stiff in &self.stiff_groups {
            losses = losses.plus(match steps.stiff_groups[stiff.number].size {
                ..=FEW => stiff.losses::<DIM, FEW>(steps, workspace),
                _ => stiff.losses::<DIM, WIDEST>(steps, workspace),
            });
        }
        workspace
            .work
            .combine(&workspace.d, &workspace.old, |d, old| 0.5 * (d + old));
        let Workspace {
            old, work: moved, ..
        } = workspace;
        for c in 0..DIM - 1 {
            let (old, moved) = (&mut old.transverse[c][..], &moved.transverse[c][..]);
            let lists = [&self.weight[c][..], &self.alpha, old, moved];
            losses.damped += total(lists, |[weight, alpha, d, z]| weight * alpha * d * z);
            for (d, lag) in old.iter_mut().zip(&self.lag) {
                *d *= lag;
            }
        }
        let masters = &steps.masters;
        let axial = old.axial.iter_mut().zip(&moved.axial);
        for (m, (d, z)) in self.masters.clone().zip(axial) {
            if masters.inverse[m] > 0.0 {
                losses.damped += masters.damping[m] / masters.inverse[m] * *d * *z;
            }
            *d *= masters.lag[m];
        }
        losses.damped += self.form(old, moved);
        losses
    }
}
