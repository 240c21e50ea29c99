//! Which points links, struts and springs couple, and how.

use crate::error::CoreError;
use crate::integrator::explicit::Along;
use crate::integrator::explicit::chain_model::layout::Chains;
use crate::integrator::explicit::stiff_groups::cluster::{Cluster, Member};
use crate::linalg::SymmetricBlocks;
use crate::linear::model::LinearModel;
use crate::statics::assembly::{Geometry, Shape, link_tension};

impl Chains {
    pub(in crate::integrator::explicit) fn cluster<const DIM: usize, const D: usize>(
        &mut self,
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        line: &LinearModel<DIM, D>,
    ) -> Result<(), CoreError> {
        let [k, c] = implicit(geometry, shape, line);
        let s = &geometry.structure;
        let mut group: Vec<usize> = (0..geometry.nodes()).collect();
        let mut takes_part = vec![false; geometry.nodes()];
        for link in &s.links {
            let [a, b] = link.nodes.map(|node| root(&mut group, node));
            link.nodes.iter().for_each(|&node| takes_part[node] = true);
            group[b] = a;
        }
        let single = s
            .struts
            .iter()
            .map(|t| t.node)
            .chain(s.springs.iter().map(|t| t.node));
        single.for_each(|node| takes_part[node] = true);
        let mut members = std::collections::BTreeMap::<usize, Vec<usize>>::new();
        for node in (0..geometry.nodes()).filter(|&node| takes_part[node]) {
            members
                .entry(root(&mut group, node))
                .or_default()
                .push(node);
        }
        let mut all: Vec<Vec<usize>> = members.into_values().collect();
        all.iter_mut()
            .for_each(|nodes| nodes.iter_mut().for_each(|n| *n = self.points[*n]));
        all.sort();
        for (number, points) in all.iter().enumerate() {
            for (k, &point) in points.iter().enumerate() {
                self.in_cluster[point] = Some((number, k));
            }
        }
        // What would couple two clusters within a step keeps its lumped mass.
        for j in self.all() {
            if self.in_cluster[j].is_some() && self.in_cluster[j + 1].is_some() {
                self.filter[j] = 0.0;
            }
            let near = [j - 1, j, j + 1].map(|j| usize::from(self.in_cluster[j].is_some()));
            if near.iter().sum::<usize>() > 1 {
                self.second[j] = 0.0;
            }
        }
        for points in all {
            let n = points.len() * DIM;
            let place = |at: usize| (self.nodes[points[at / DIM]], at % DIM);
            let dense = |m: &SymmetricBlocks<D>| -> Vec<f64> {
                let entry = |at: usize| {
                    let ((i, p), (j, q)) = (place(at / n), place(at % n));
                    entry(m, (i, p), (j, q))
                };
                (0..n * n).map(entry).collect()
            };
            let (k, c) = (dense(&k), dense(&c));
            let members = points.iter().map(|&point| self.member(point)).collect();
            self.clusters.push(Cluster::new(members, (&k, &c), self.h)?);
        }
        Ok(())
    }

    fn member(&self, point: usize) -> Member {
        let filter = [self.filter[point - 1], self.filter[point]];
        let second = [point - 1, point, point + 1].map(|j| self.second[j]);
        let felt = filter[0] + filter[1] + second[0] + 4.0 * second[1] + second[2];
        let mut inverse = [0.0; 2];
        self.inverse
            .iter()
            .zip(&mut inverse)
            .for_each(|(all, own)| *own = all[point]);
        Member {
            point,
            node: self.nodes[point],
            along: Along::default(),
            inverse,
            response: inverse.map(|own| own * (1.0 + own * felt)),
            filter,
            second,
            lag: self.lag[point],
        }
    }
}

/// The node that stands for all that are linked with one.
fn root(group: &mut [usize], mut node: usize) -> usize {
    while group[node] != node {
        group[node] = group[group[node]];
        node = group[node];
    }
    node
}

/// Entry of a symmetric matrix.
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
    let found = places.into_iter().find(|&k| m.columns[k] == column);
    found.map_or(0.0, |k| m.blocks[k][a][b])
}

/// K and C of links, struts and springs alone.
fn implicit<const DIM: usize, const D: usize>(
    geometry: &Geometry<DIM, D>,
    shape: &Shape<D>,
    line: &LinearModel<DIM, D>,
) -> [SymmetricBlocks<D>; 2] {
    let s = &geometry.structure;
    let (mut k, mut c) = (geometry.empty_matrix(), geometry.empty_matrix());
    for link in &s.links {
        let state = Geometry::<DIM, D>::link_state(shape, link);
        let tangent = state.tangent(link.stiffness, link_tension(link, &state));
        let along = |p: usize, q: usize| link.viscosity * state.direction[p] * state.direction[q];
        let damping = std::array::from_fn(|p| {
            std::array::from_fn(|q| link.damping.beta * tangent[p][q] + along(p, q))
        });
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
