//! Packs the chain model into SIMD vectors: see
//! [`packed`](crate::integrator::explicit::simd::packed).

use crate::integrator::explicit::chain_model::builder::ChainBuilder;
use crate::integrator::explicit::simd::packed::{
    DampingCoefficients, SIMD_LANES, SharedCoefficients, TransverseCoefficients, per_lane,
    row_and_lane,
};
use crate::integrator::explicit::simd::plan::{Plan, Span};
use crate::integrator::explicit::simd::stripes::Stripes;
use crate::integrator::explicit::stiff_groups::batches::StiffBatches;
use crate::integrator::explicit::{
    AxialElement, AxialPosition, Explicit, IslandModel, Masters, Seam, StripedBlock, TiedEnd,
};
use std::collections::BTreeSet;
use std::ops::Range;
use std::sync::OnceLock;

/// Relative rounding of a mean of equal numbers.
const ROUNDING: f64 = 1e-12;

impl ChainBuilder {
    /// Packs the chain model into SIMD vectors.
    pub fn packed<const DIM: usize>(mut self) -> Explicit<DIM> {
        let (all, packed_indices) = (
            std::mem::take(&mut self.stripes),
            std::mem::take(&mut self.packed_indices),
        );
        let stiff_groups = self.stiff_groups.iter_mut().flat_map(|c| &mut c.members);
        stiff_groups.for_each(|m| m.point = packed_indices[m.point]);
        let mut new = self.empty(&packed_indices, all.last().map_or(0, |s| s.rows().end));
        let mut all = all.iter();
        for island in &self.islands {
            let first = new.islands.last().map_or(0, |island| island.rows.end);
            let stripes = all.by_ref().zip(&island.blocks);
            let pack = |(stripes, axial_elements): (&Stripes, &Range<usize>)| {
                self.pack_block(stripes, axial_elements.clone(), &packed_indices, &mut new)
            };
            let blocks: Vec<StripedBlock> = stripes.map(pack).collect();
            let rows = first..blocks.last().map_or(first, |block| block.rows.end);
            new.islands.push(IslandModel {
                blocks,
                rows,
                masters: island.masters.clone(),
                tied_ends: new
                    .tied_ends(&self.tied_ends[island.tied_ends.clone()], &packed_indices),
                batches: StiffBatches::new(&new.stiff_groups[island.stiff_groups.clone()]),
                read_ghosts: Vec::new(),
                stiff_nodes: new.stiff_nodes(island.stiff_groups.clone()),
            });
            let number = new.islands.len() - 1;
            new.islands[number].read_ghosts =
                new.ghosts_read_by_groups(number, island.stiff_groups.clone());
        }
        new
    }

    /// Packs the points and axial elements of a block.
    fn pack_block<const DIM: usize>(
        &self,
        stripes: &Stripes,
        axial_elements: Range<usize>,
        packed_indices: &[usize],
        to: &mut Explicit<DIM>,
    ) -> StripedBlock {
        for point in stripes.points.clone() {
            let packed_index = packed_indices[point];
            self.pack_point(point, packed_index, to);
            to.nodes[packed_index] = self.nodes[point];
        }
        let ghosts = stripes.ghosts().into_iter().map(|[copy, point]| {
            self.pack_point(point, copy, to);
            to.home[copy] = packed_indices[point];
            [copy, packed_indices[point]].map(|packed_index| packed_index as u32)
        });
        let ghosts: Vec<[u32; 2]> = ghosts.collect();
        let (seams, plan) = self.pack_axial_elements(
            axial_elements.clone(),
            stripes,
            packed_indices,
            &mut to.axial_elements,
        );
        let is_curved = |number: &usize| to.axial_elements[*number].half_turn != 0.0;
        StripedBlock {
            rows: stripes.rows(),
            ghosts,
            seams,
            plan,
            curved: axial_elements
                .clone()
                .filter(is_curved)
                .map(|k| k as u32)
                .collect(),
            axial_elements,
            is_uniform: self.equalize_damping(stripes, &mut to.damping[stripes.rows()]),
        }
    }

    /// Sets the same damping in all rows of a block, if its points agree up to rounding; returns
    /// true if they do.
    fn equalize_damping(&self, stripes: &Stripes, rows: &mut [DampingCoefficients]) -> bool {
        let is_uniform = |list: &[f64]| {
            let list = &list[stripes.points.clone()];
            let largest = list.iter().fold(0.0_f64, |all, v| all.max(v.abs()));
            let apart = list.iter().map(|v| (v - list[0]).abs());
            apart.fold(0.0_f64, f64::max) <= ROUNDING * largest
        };
        let is_uniform = is_uniform(&self.damping) && is_uniform(&self.lag);
        if is_uniform {
            let first = stripes.points.start;
            let [alpha, lag] = [self.damping[first], self.lag[first]].map(|v| per_lane(|_| v));
            rows.fill(DampingCoefficients { alpha, lag });
        }
        is_uniform
    }

    /// Packs the axial elements of a block in the order of their ends; returns its seams and the
    /// plan of its sweep.
    fn pack_axial_elements(
        &self,
        numbers: Range<usize>,
        stripes: &Stripes,
        packed_indices: &[usize],
        to: &mut Vec<AxialElement>,
    ) -> (Vec<Seam>, Plan) {
        let (axial_elements, first) = (&self.axial_elements[numbers.clone()], numbers.start);
        let (order, none) = (stripes.order(axial_elements), self.axial_elements.len());
        let mut numbers = vec![none; axial_elements.len()];
        for (k, &old) in order.iter().enumerate() {
            numbers[old] = first + k;
        }
        let spans: Vec<Span> = order
            .iter()
            .map(|&k| stripes.span(&axial_elements[k]))
            .collect();
        for (&k, span) in order.iter().zip(&spans) {
            let previous = k.checked_sub(1);
            let previous =
                previous.filter(|&k| stripes.span(&axial_elements[k]).stripe == span.stripe);
            let Range { start, end } = axial_elements[k].segments;
            to.push(AxialElement {
                masters: axial_elements[k].masters.map(|m| m as u32),
                ends: [packed_indices[start] as u32, packed_indices[end] as u32],
                previous: previous.map_or(none, |k| numbers[k]) as u32,
                stiffness: axial_elements[k].stiffness,
                half_turn: axial_elements[k].half_turn,
                is_packed: false,
            });
        }
        let plan = Plan::new(&spans, stripes.counts(), first, none);
        mark_packed(&mut to[first..plan.within]);
        (stripes.seams(axial_elements, &numbers), plan)
    }

    /// Returns the model with empty rows and without islands.
    fn empty<const DIM: usize>(&mut self, packed_indices: &[usize], rows: usize) -> Explicit<DIM> {
        let numbers = SIMD_LANES * rows;
        let of_masters = |k: usize| self.masters.iter().map(|m| m[k]).collect();
        let points = self
            .points
            .iter()
            .map(|&point| packed_indices[point])
            .collect();
        Explicit {
            h: self.h,
            per_step: 1.0 / self.h,
            nodes: vec![usize::MAX; numbers],
            points,
            home: (0..numbers).collect(),
            islands: Vec::new(),
            common: vec![SharedCoefficients::default(); rows],
            damping: vec![DampingCoefficients::default(); rows],
            transverse: vec![vec![TransverseCoefficients::default(); rows]; DIM - 1],
            axial_positions: vec![AxialPosition::default(); numbers],
            axial_elements: Vec::new(),
            masters: Masters {
                inverse: of_masters(0),
                damping: of_masters(1),
                lag: of_masters(2),
            },
            stiff_groups: std::mem::take(&mut self.stiff_groups),
            in_stiff_group: vec![None; numbers],
            forms: OnceLock::new(),
        }
    }

    /// Packs the numbers of a point at a packed index.
    fn pack_point<const DIM: usize>(
        &self,
        point: usize,
        packed_index: usize,
        to: &mut Explicit<DIM>,
    ) {
        let (row, simd_lane) = row_and_lane(packed_index);
        let common = &mut to.common[row];
        common.filter[simd_lane] = self.filter[point];
        common.second[simd_lane] = self.second[point];
        common.per_length[simd_lane] = self.per_length[point];
        common.bending[simd_lane] = self.bending[point];
        to.damping[row].alpha[simd_lane] = self.damping[point];
        to.damping[row].lag[simd_lane] = self.lag[point];
        for (c, across) in to.transverse.iter_mut().enumerate() {
            across[row].inverse[simd_lane] = self.inverse[c][point];
            across[row].tension[simd_lane] = self.tension[c][point];
            across[row].slope[simd_lane] = self.slope[c][point];
        }
        to.axial_positions[packed_index] = self.axial_positions[point];
        to.in_stiff_group[packed_index] = self.in_stiff_group[point];
    }
}

impl<const DIM: usize> Explicit<DIM> {
    /// Returns the nodes of stiff groups.
    fn stiff_nodes(&self, numbers: Range<usize>) -> Vec<usize> {
        let members = self.stiff_groups[numbers].iter().flat_map(|c| &c.members);
        members.map(|m| m.node).collect()
    }

    /// Returns the ghosts in the stencils of the points of stiff groups.
    fn ghosts_read_by_groups(&self, island: usize, numbers: Range<usize>) -> Vec<[u32; 2]> {
        let members = self.stiff_groups[numbers].iter().flat_map(|c| &c.members);
        let stencils =
            members.flat_map(|m| (0..5).map(|k| m.point + SIMD_LANES * k - 2 * SIMD_LANES));
        let stencils: BTreeSet<usize> = stencils.collect();
        let ghosts = self.islands[island].blocks.iter().flat_map(|b| &b.ghosts);
        let read = ghosts.filter(|[copy, _]| stencils.contains(&(*copy as usize)));
        read.copied().collect()
    }

    /// Returns tied ends with the points they are tied to.
    fn tied_ends(&self, pairs: &[(usize, usize)], packed_indices: &[usize]) -> Vec<TiedEnd> {
        let pack = |&(tied, tie_master): &(usize, usize)| {
            TiedEnd::new(self, packed_indices[tied], packed_indices[tie_master])
        };
        pairs.iter().map(pack).collect()
    }
}

/// Marks groups of four axial elements whose data are adjacent.
fn mark_packed(axial_elements: &mut [AxialElement]) {
    let mut k = 0;
    while k + SIMD_LANES <= axial_elements.len() {
        let four = &axial_elements[k..k + SIMD_LANES];
        let first = four[0];
        let is_next = |(simd_lane, axial_element): (usize, &AxialElement)| {
            let beside = |a: u32, b: u32| b as usize == a as usize + simd_lane;
            let [masters, ends] = [
                (first.masters, axial_element.masters),
                (first.ends, axial_element.ends),
            ];
            (0..2).all(|k| beside(masters.0[k], masters.1[k]) && beside(ends.0[k], ends.1[k]))
                && beside(first.previous, axial_element.previous)
        };
        let is_packed =
            row_and_lane(first.ends[0] as usize).1 == 0 && four.iter().enumerate().all(is_next);
        axial_elements[k].is_packed = is_packed;
        k += if is_packed { SIMD_LANES } else { 1 };
    }
}
