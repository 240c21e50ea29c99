//! Grouping of points that links, struts and springs couple.

use crate::error::CoreError;
use crate::integrator::explicit::AxialPosition;
use crate::integrator::explicit::chain_model::builder::ChainBuilder;
use crate::integrator::explicit::stiff_groups::stiff_group::{Member, StiffGroup};
use crate::linalg::SymmetricBlocks;
use crate::linear::model::LinearModel;
use crate::statics::assembly::{Geometry, LinkLaw, Shape};

impl ChainBuilder {
    pub(in crate::integrator::explicit) fn add_stiff_groups<const DIM: usize, const D: usize>(
        &mut self,
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        line: &LinearModel<DIM, D>,
    ) -> Result<(), CoreError> {
        let [k, c] = stiff_matrices(geometry, shape, line);
        let s = &geometry.structure;
        let mut parent: Vec<usize> = (0..geometry.nodes()).collect();
        let mut is_stiff = vec![false; geometry.nodes()];
        for link in &s.links {
            let [a, b] = link.nodes.map(|node| root(&mut parent, node));
            link.nodes.iter().for_each(|&node| is_stiff[node] = true);
            parent[b] = a;
        }
        let single = s
            .struts
            .iter()
            .map(|t| t.node)
            .chain(s.springs.iter().map(|t| t.node));
        single.for_each(|node| is_stiff[node] = true);
        let mut members = std::collections::BTreeMap::<usize, Vec<usize>>::new();
        for node in (0..geometry.nodes()).filter(|&node| is_stiff[node]) {
            members
                .entry(root(&mut parent, node))
                .or_default()
                .push(node);
        }
        let mut all: Vec<Vec<usize>> = members.into_values().collect();
        all.iter_mut()
            .for_each(|nodes| nodes.iter_mut().for_each(|n| *n = self.points[*n]));
        all.sort();
        for (number, points) in all.iter().enumerate() {
            for (k, &point) in points.iter().enumerate() {
                self.in_stiff_group[point] = Some((number, k));
            }
        }
        // Terms that would couple two stiff groups within a step are dropped: lumped masses there.
        for j in self.points_of_wires() {
            if self.in_stiff_group[j].is_some() && self.in_stiff_group[j + 1].is_some() {
                self.filter[j] = 0.0;
            }
            let near = [j - 1, j, j + 1].map(|j| usize::from(self.in_stiff_group[j].is_some()));
            if near.iter().sum::<usize>() > 1 {
                self.second[j] = 0.0;
            }
        }
        for points in all {
            let n = points.len() * DIM;
            let place =
                |entry_index: usize| (self.nodes[points[entry_index / DIM]], entry_index % DIM);
            let dense = |m: &SymmetricBlocks<D>| -> Vec<f64> {
                let entry = |entry_index: usize| {
                    let ((i, p), (j, q)) = (place(entry_index / n), place(entry_index % n));
                    entry(m, (i, p), (j, q))
                };
                (0..n * n).map(entry).collect()
            };
            let (k, c) = (dense(&k), dense(&c));
            let members = points.iter().map(|&point| self.member(point)).collect();
            self.stiff_groups
                .push(StiffGroup::new(members, (&k, &c), self.h)?);
        }
        Ok(())
    }

    fn member(&self, point: usize) -> Member {
        let filter = [self.filter[point - 1], self.filter[point]];
        let second = [point - 1, point, point + 1].map(|j| self.second[j]);
        let influence = filter[0] + filter[1] + second[0] + 4.0 * second[1] + second[2];
        let mut inverse = [0.0; 2];
        self.inverse
            .iter()
            .zip(&mut inverse)
            .for_each(|(all, inverse)| *inverse = all[point]);
        Member {
            point,
            node: self.nodes[point],
            axial_position: AxialPosition::default(),
            inverse,
            response: inverse.map(|inverse| inverse * (1.0 + inverse * influence)),
            filter,
            second,
            lag: self.lag[point],
        }
    }
}

/// Returns the representative of all nodes linked with one (union-find).
fn root(parent: &mut [usize], mut node: usize) -> usize {
    while parent[node] != node {
        parent[node] = parent[parent[node]];
        node = parent[node];
    }
    node
}

/// Returns an entry of a symmetric matrix.
fn entry<const D: usize>(
    m: &SymmetricBlocks<D>,
    (i, p): (usize, usize),
    (j, q): (usize, usize),
) -> f64 {
    let ((row, a), (column, b)) = if i < j {
        ((j, q), (i, p))
    } else {
        ((i, p), (j, q))
    };
    let places = m.row_start[row]..m.row_start[row + 1];
    let entry = places.into_iter().find(|&k| m.columns[k] == column);
    entry.map_or(0.0, |k| m.blocks[k][a][b])
}

/// Returns K, N/m, and C, N·s/m, of links, struts and springs alone.
fn stiff_matrices<const DIM: usize, const D: usize>(
    geometry: &Geometry<DIM, D>,
    shape: &Shape<D>,
    line: &LinearModel<DIM, D>,
) -> [SymmetricBlocks<D>; 2] {
    let s = &geometry.structure;
    let (mut k, mut c) = (geometry.empty_matrix(), geometry.empty_matrix());
    for link in &s.links {
        let tangent = Geometry::<DIM, D>::link_tangent(shape, link, LinkLaw::Linear, 1.0);
        let damping = Geometry::<DIM, D>::link_damping(shape, link, link.damping.beta);
        Geometry::<DIM, D>::add_between(&mut k, link.nodes, &tangent);
        Geometry::<DIM, D>::add_between(&mut c, link.nodes, &damping);
    }
    for strut in &s.struts {
        Geometry::<DIM, D>::add_strut(&mut k, shape, strut, 1.0);
    }
    for spring in &s.springs {
        Geometry::<DIM, D>::add_spring(&mut k, spring, spring.stiffness);
        Geometry::<DIM, D>::add_spring(&mut c, spring, spring.viscosity);
    }
    for m in [&mut k, &mut c] {
        m.keep_free(&line.free);
    }
    [k, c]
}
