//! Energies of links, struts and springs, group by group.

use crate::integrator::explicit::energy::StepLosses;
use crate::integrator::explicit::energy::island_field::{IslandField, Workspace};
use crate::integrator::explicit::stiff_groups::stiff_group::StiffGroup;
use crate::integrator::explicit::{AxialPosition, Explicit};

/// Number of components of most stiff groups: two points.
pub(in crate::integrator::explicit::energy) const FEW: usize = 6;

/// Point of a stiff group: its number on the island, and its axial position.
#[derive(Debug, Clone, Copy)]
pub(in crate::integrator::explicit::energy) struct StiffPoint {
    pub point: usize,
    pub axial_position: AxialPosition,
}

/// Stiff group, by its number in the chain model, and its points.
#[derive(Debug, Clone)]
pub(in crate::integrator::explicit::energy) struct StiffEnergy {
    pub number: usize,
    pub points: Vec<StiffPoint>,
}

impl StiffEnergy {
    /// Returns the components of its points, along the track first.
    #[inline(always)]
    fn read<const DIM: usize, const N: usize>(&self, field: &IslandField) -> [f64; N] {
        let mut values = [0.0; N];
        for (stiff_point, at) in self.points.iter().zip(values.chunks_exact_mut(DIM)) {
            at[0] = stiff_point.axial_position.read(&field.axial);
            for c in 1..DIM {
                at[c] = field.transverse[c - 1][stiff_point.point];
            }
        }
        values
    }

    /// Returns the stored energy, J, of a group with at most `N` components.
    #[inline(always)]
    pub fn stored<const DIM: usize, const N: usize>(
        &self,
        steps: &Explicit<DIM>,
        workspace: &Workspace,
    ) -> f64 {
        let stiff_group = &steps.stiff_groups[self.number];
        let mut z = self.read::<DIM, N>(&workspace.y);
        let mut d = self.read::<DIM, N>(&workspace.d);
        for k in 0..N {
            z[k] -= 0.5 * d[k];
            d[k] = if k % DIM == 0 { d[k] } else { 0.0 };
        }
        let k = &stiff_group.stiffness;
        0.5 * stiff_group.form(k, &z, &z) - 0.125 * stiff_group.form(k, &d, &d)
    }

    /// Returns the energy lost in a step, J, from the increments before and after it.
    #[inline(always)]
    pub fn losses<const DIM: usize, const N: usize>(
        &self,
        steps: &Explicit<DIM>,
        workspace: &Workspace,
    ) -> StepLosses {
        let stiff_group = &steps.stiff_groups[self.number];
        let old = self.read::<DIM, N>(&workspace.old);
        let new = self.read::<DIM, N>(&workspace.d);
        let [mut increment, mut read, mut transverse, mut axial_change] = [[0.0; N]; 4];
        for k in 0..N {
            increment[k] = 0.5 * (old[k] + new[k]);
            if k % DIM == 0 {
                (read[k], axial_change[k]) = (old[k], new[k] - old[k]);
            } else {
                (read[k], transverse[k]) = (increment[k], increment[k]);
            }
        }
        StepLosses {
            damped: stiff_group.form(&stiff_group.damping, &read, &increment) * steps.per_step,
            scheme: -0.25 * stiff_group.form(&stiff_group.stiffness, &axial_change, &transverse),
        }
    }
}

impl StiffGroup {
    /// Returns the bilinear form xᵀ A z.
    #[inline(always)]
    fn form(&self, a: &[f64], x: &[f64], z: &[f64]) -> f64 {
        let rows = a.chunks_exact(self.size).zip(x);
        let of_row =
            |(row, x): (&[f64], &f64)| x * row.iter().zip(z).map(|(a, z)| a * z).sum::<f64>();
        rows.map(of_row).sum()
    }
}
