//! Forces on single points, with the simultaneous response of adjacent stiff groups.

use crate::constraint::columns::ComplianceColumns;
use crate::integrator::explicit::simd::packed::{SIMD_LANES, row_and_lane};
use crate::integrator::explicit::{BETA, ChainState, Explicit};

impl<const DIM: usize> Explicit<DIM> {
    /// Adds a force, N, on a component of a node, with the response of stiff groups.
    pub(crate) fn add_force(
        &self,
        chain: &mut ChainState,
        node: usize,
        component: usize,
        force: f64,
    ) {
        let packed_index = self.points[node];
        if component == 0 {
            self.axial_positions[packed_index].add(force, &mut chain.master_force);
            return;
        }
        let direction = component - 1;
        let inverse = |packed_index: usize| {
            let (row, simd_lane) = row_and_lane(packed_index);
            self.transverse[direction][row].inverse[simd_lane]
        };
        let (row, simd_lane) = row_and_lane(packed_index);
        let change = inverse(packed_index) * force;
        chain.moving[direction][row].w[simd_lane] += change;
        let rows_near = &self.common[row - 1..=row + 1];
        let [before, behind, _] = [0, 1, 2].map(|k| rows_near[k].filter[simd_lane]);
        let [left, middle, right] = [0, 1, 2].map(|k| rows_near[k].second[simd_lane]);
        // One column of the matrix in `Explicit::acceleration`.
        let influence = [
            left,
            -before - 2.0 * (left + middle),
            before + behind + left + 4.0 * middle + right,
            -behind - 2.0 * (middle + right),
            right,
        ];
        for (k, influence) in influence.into_iter().enumerate() {
            let neighbour = packed_index + SIMD_LANES * k - 2 * SIMD_LANES;
            let influence = f64::from(u8::from(k == 2)) + inverse(neighbour) * influence;
            if let Some((number, place)) = self.in_stiff_group[neighbour] {
                self.add_stiff_response(chain, number, place * DIM + component, influence * change);
            }
        }
    }

    /// Adds the response of a stiff group to the acceleration of one of its points, m (times h²).
    fn add_stiff_response(
        &self,
        chain: &mut ChainState,
        number: usize,
        column: usize,
        acceleration: f64,
    ) {
        let stiff_group = &self.stiff_groups[number];
        let n = stiff_group.size;
        for row in 0..n {
            let force = -stiff_group.response_to_acceleration[row * n + column] * acceleration;
            self.add_point_force(
                chain,
                stiff_group.members[row / DIM].point,
                row % DIM,
                force,
            );
        }
    }

    /// Adds a force, N, on a point, without the response of stiff groups.
    #[inline(always)]
    pub(in crate::integrator::explicit) fn add_point_force(
        &self,
        chain: &mut ChainState,
        packed_index: usize,
        component: usize,
        force: f64,
    ) {
        match component.checked_sub(1) {
            None => self.axial_positions[packed_index].add(force, &mut chain.master_force),
            Some(direction) => {
                let (row, simd_lane) = row_and_lane(packed_index);
                let inverse = self.transverse[direction][row].inverse[simd_lane];
                chain.moving[direction][row].w[simd_lane] += inverse * force;
            }
        }
    }

    /// Sets a compliance column: the increment of the coming step, m, for unit loads (node,
    /// component, force). `chain` is empty before and after.
    pub(crate) fn set_column<const D: usize>(
        &self,
        columns: &mut ComplianceColumns<D>,
        number: usize,
        load: impl Iterator<Item = (usize, usize, f64)>,
        chain: &mut ChainState,
    ) {
        let mut touched = Vec::new();
        for (node, component, force) in load {
            self.add_force(chain, node, component, force);
            for neighbour in self.stencil(self.points[node]) {
                touched.push(neighbour);
                if let Some((number, _)) = self.in_stiff_group[neighbour] {
                    let members = &self.stiff_groups[number].members;
                    touched.extend(members.iter().flat_map(|m| self.stencil(m.point)));
                }
            }
        }
        let mut increments = std::collections::BTreeMap::<usize, [f64; D]>::new();
        for &packed_index in &touched {
            let node = self.nodes[packed_index];
            if node == usize::MAX || self.points[node] != packed_index {
                continue;
            }
            let row = increments.entry(node).or_insert([0.0; D]);
            for (direction, rows) in chain.moving.iter().enumerate() {
                row[direction + 1] = BETA * self.acceleration(direction, packed_index, rows);
            }
        }
        for packed_index in touched {
            let (row, simd_lane) = row_and_lane(packed_index);
            chain
                .moving
                .iter_mut()
                .for_each(|rows| rows[row].w[simd_lane] = 0.0);
            let [a, b] = self.axial_positions[packed_index].masters;
            (chain.master_force[a], chain.master_force[b]) = (0.0, 0.0);
        }
        columns.keep(number, &increments);
    }
}
