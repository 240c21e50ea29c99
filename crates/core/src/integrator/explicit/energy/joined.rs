//! Energies of links, struts and springs, cluster by cluster.

use crate::integrator::explicit::energy::Lost;
use crate::integrator::explicit::energy::field::Field;
use crate::integrator::explicit::energy::form::Room;
use crate::integrator::explicit::stiff_groups::cluster::Cluster;
use crate::integrator::explicit::{Along, Explicit};

/// Components of most clusters: two points.
pub(in crate::integrator::explicit::energy) const FEW: usize = 6;

/// A point of a cluster: number on the island, and where it lies along the wire.
#[derive(Debug, Clone, Copy)]
pub(in crate::integrator::explicit::energy) struct Joint {
    pub point: usize,
    pub along: Along,
}

/// A cluster, by its number among all, and its points.
#[derive(Debug, Clone)]
pub(in crate::integrator::explicit::energy) struct Joined {
    pub number: usize,
    pub joints: Vec<Joint>,
}

impl Joined {
    /// Components of its points, along the track first.
    #[inline(always)]
    fn read<const DIM: usize, const N: usize>(&self, field: &Field) -> [f64; N] {
        let mut found = [0.0; N];
        for (joint, at) in self.joints.iter().zip(found.chunks_exact_mut(DIM)) {
            at[0] = joint.along.read(&field.along);
            for c in 1..DIM {
                at[c] = field.across[c - 1][joint.point];
            }
        }
        found
    }

    /// For no more than `N` components.
    #[inline(always)]
    pub fn stored<const DIM: usize, const N: usize>(
        &self,
        steps: &Explicit<DIM>,
        room: &Room,
    ) -> f64 {
        let cluster = &steps.clusters[self.number];
        let mut z = self.read::<DIM, N>(&room.y);
        let mut d = self.read::<DIM, N>(&room.d);
        for k in 0..N {
            z[k] -= 0.5 * d[k];
            d[k] = if k % DIM == 0 { d[k] } else { 0.0 };
        }
        let k = &cluster.stiffness;
        0.5 * cluster.form(k, &z, &z) - 0.125 * cluster.form(k, &d, &d)
    }

    /// With increments before and after the step.
    #[inline(always)]
    pub fn lost<const DIM: usize, const N: usize>(
        &self,
        steps: &Explicit<DIM>,
        room: &Room,
    ) -> Lost {
        let cluster = &steps.clusters[self.number];
        let old = self.read::<DIM, N>(&room.old);
        let new = self.read::<DIM, N>(&room.d);
        let [mut moved, mut seen, mut aside, mut pulled] = [[0.0; N]; 4];
        for k in 0..N {
            moved[k] = 0.5 * (old[k] + new[k]);
            if k % DIM == 0 {
                (seen[k], pulled[k]) = (old[k], new[k] - old[k]);
            } else {
                (seen[k], aside[k]) = (moved[k], moved[k]);
            }
        }
        Lost {
            damped: cluster.form(&cluster.damping, &seen, &moved) * steps.per_step,
            scheme: -0.25 * cluster.form(&cluster.stiffness, &pulled, &aside),
        }
    }
}

impl Cluster {
    /// xᵀ A z
    #[inline(always)]
    fn form(&self, a: &[f64], x: &[f64], z: &[f64]) -> f64 {
        let rows = a.chunks_exact(self.size).zip(x);
        let of_row =
            |(row, x): (&[f64], &f64)| x * row.iter().zip(z).map(|(a, z)| a * z).sum::<f64>();
        rows.map(of_row).sum()
    }
}
