//! Constants of the energy forms of an island, taken from its steps.

use crate::integrator::explicit::energy::filtered_mass::FilteredMass;
use crate::integrator::explicit::energy::form::{EnergyForm, IslandElement};
use crate::integrator::explicit::energy::stiff::{StiffEnergy, StiffPoint};
use crate::integrator::explicit::simd::packed::{SIMD_LANES, row_and_lane};
use crate::integrator::explicit::stiff_groups::stiff_group::Member;
use crate::integrator::explicit::{AxialElement, AxialPosition, Explicit, IslandModel};
use std::collections::BTreeSet;
use std::ops::Range;

impl EnergyForm {
    pub(in crate::integrator::explicit::energy) fn new<const DIM: usize>(
        steps: &Explicit<DIM>,
        island: usize,
    ) -> Self {
        let island = &steps.islands[island];
        let stretches = stretches(steps, island);
        let points = IslandPoints::new(steps, island, &stretches);
        let weight = points.collect_directions(|c, packed_index| points.weight(c, packed_index));
        let filter = points.collect(|row, simd_lane| steps.common[row].filter[simd_lane]);
        let second = points.collect(|row, simd_lane| steps.common[row].second[simd_lane]);
        let transverse = |c: usize, packed_index: usize| {
            (
                &steps.transverse[c][packed_index / SIMD_LANES],
                packed_index % SIMD_LANES,
            )
        };
        Self {
            masters: island.masters.clone(),
            per_length: points.collect(|row, simd_lane| steps.common[row].per_length[simd_lane]),
            bending: points.collect(|row, simd_lane| steps.common[row].bending[simd_lane]),
            tension: points.collect_directions(|c, packed_index| {
                let (transverse, simd_lane) = transverse(c, packed_index);
                transverse.tension[simd_lane]
            }),
            slope: points.collect_directions(|c, packed_index| {
                let (transverse, simd_lane) = transverse(c, packed_index);
                transverse.slope[simd_lane]
            }),
            filtered: [0, 1].map(|c| FilteredMass::new(&weight[c], &filter, &second)),
            alpha: points.collect(|row, simd_lane| steps.damping[row].alpha[simd_lane]),
            lag: points.collect(|row, simd_lane| steps.damping[row].lag[simd_lane]),
            elements: points.elements(),
            stiff_groups: points.stiff_groups(),
            weight,
            stretches,
        }
    }
}

/// Returns the positions of the points of an island, in their order along the wires: ranges of rows
/// of a SIMD lane.
fn stretches<const DIM: usize>(
    steps: &Explicit<DIM>,
    island: &IslandModel,
) -> Vec<(Range<usize>, usize)> {
    let mut stretches: Vec<(Range<usize>, usize)> = Vec::new();
    for block in &island.blocks {
        for simd_lane in 0..SIMD_LANES {
            let is_there = |row: &usize| steps.nodes[SIMD_LANES * row + simd_lane] != usize::MAX;
            for row in block.rows.clone().filter(is_there) {
                match stretches.last_mut() {
                    Some((rows, last)) if *last == simd_lane && rows.end == row => rows.end += 1,
                    _ => stretches.push((row..row + 1, simd_lane)),
                }
            }
        }
    }
    stretches
}

/// Points of an island in their order along the wires.
struct IslandPoints<'a, const DIM: usize> {
    steps: &'a Explicit<DIM>,
    island: &'a IslandModel,
    packed_indices: Vec<usize>,
    /// Number of each packed index.
    number: Vec<usize>,
}

impl<'a, const DIM: usize> IslandPoints<'a, DIM> {
    fn new(
        steps: &'a Explicit<DIM>,
        island: &'a IslandModel,
        stretches: &[(Range<usize>, usize)],
    ) -> Self {
        let indices = |(rows, simd_lane): &(Range<usize>, usize)| {
            let simd_lane = *simd_lane;
            rows.clone().map(move |row| SIMD_LANES * row + simd_lane)
        };
        let packed_indices: Vec<usize> = stretches.iter().flat_map(indices).collect();
        let mut number = vec![usize::MAX; steps.nodes.len()];
        for (k, &packed_index) in packed_indices.iter().enumerate() {
            number[packed_index] = k;
        }
        Self {
            steps,
            island,
            packed_indices,
            number,
        }
    }

    /// Returns a quantity of each point, read at its row and SIMD lane.
    fn collect(&self, read: impl Fn(usize, usize) -> f64) -> Vec<f64> {
        let read = |&packed_index: &usize| {
            let (row, simd_lane) = row_and_lane(packed_index);
            read(row, simd_lane)
        };
        self.packed_indices.iter().map(read).collect()
    }

    /// Returns a quantity of each point in each transverse direction.
    fn collect_directions(&self, read: impl Fn(usize, usize) -> f64) -> [Vec<f64>; 2] {
        let direction = |c: usize| {
            self.packed_indices
                .iter()
                .map(|&packed_index| read(c, packed_index))
                .collect()
        };
        [0, 1].map(|c| {
            if c + 1 < DIM {
                direction(c)
            } else {
                Vec::new()
            }
        })
    }

    /// Returns m/h² of a point, kg/s²; zero where it is held, and of tied ends.
    fn weight(&self, transverse: usize, packed_index: usize) -> f64 {
        let (row, simd_lane) = row_and_lane(packed_index);
        let inverse = self.steps.transverse[transverse][row].inverse[simd_lane];
        let is_tied = self.steps.points[self.steps.nodes[packed_index]] != packed_index;
        if inverse > 0.0 && !is_tied {
            1.0 / inverse
        } else {
            0.0
        }
    }

    fn elements(&self) -> Vec<IslandElement> {
        let blocks = self.island.blocks.iter();
        let axial_elements =
            blocks.flat_map(|b| &self.steps.axial_elements[b.axial_elements.clone()]);
        let element = |axial_element: &AxialElement| IslandElement {
            masters: axial_element
                .masters
                .map(|m| m as usize - self.island.masters.start),
            points: axial_element
                .ends
                .map(|packed_index| self.number[packed_index as usize]),
            stiffness: axial_element.stiffness,
            half_turn: axial_element.half_turn,
        };
        axial_elements.map(element).collect()
    }

    fn stiff_groups(&self) -> Vec<StiffEnergy> {
        let numbers = self
            .packed_indices
            .iter()
            .filter_map(|&s| self.steps.in_stiff_group[s]);
        let numbers: BTreeSet<usize> = numbers.map(|(number, _)| number).collect();
        let stiff_point = |member: &Member| StiffPoint {
            point: self.number[member.point],
            axial_position: AxialPosition {
                masters: member
                    .axial_position
                    .masters
                    .map(|m| m - self.island.masters.start),
                share: member.axial_position.share,
            },
        };
        let members = |number: usize| self.steps.stiff_groups[number].members.iter();
        let joined = |number: usize| StiffEnergy {
            number,
            points: members(number).map(stiff_point).collect(),
        };
        numbers.into_iter().map(joined).collect()
    }
}
