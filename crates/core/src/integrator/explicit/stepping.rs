//! Stages of an explicit step: stiff groups; then, with contact forces known, the motion, and the
//! wire forces for the next step.

use crate::integrator::explicit::simd::packed::{
    SIMD_LANES, SimdVector, TransverseMotion, row_and_lane,
};
use crate::integrator::explicit::simd::sweep::{ChainSweep, WireForces};
use crate::integrator::explicit::stiff_groups::apply::ApplyStiffForces;
use crate::integrator::explicit::{BETA, ChainState, Explicit, IslandModel, StripedBlock};
use crate::linalg::widest;

/// Copies rows' vectors from points into their ghosts.
#[inline(always)]
fn copy_to_ghosts<const N: usize>(
    ghosts: &[[u32; 2]],
    chain: &mut ChainState,
    vectors: impl Fn(&mut TransverseMotion) -> [&mut SimdVector; N],
) {
    for rows in &mut chain.moving {
        let rows = &mut rows[..];
        for ghost_and_home in ghosts {
            let [(to, simd_lane), (from, home_lane)] =
                ghost_and_home.map(|packed_index| row_and_lane(packed_index as usize));
            let home = vectors(&mut rows[from]).map(|wide| wide[home_lane]);
            for (wide, home) in vectors(&mut rows[to]).into_iter().zip(home) {
                wide[simd_lane] = home;
            }
        }
    }
}

/// Returns the filtered acceleration of a point times h², m, from w of its stencil and the weights
/// of adjacent segments and points.
#[inline(always)]
pub(in crate::integrator::explicit) fn filtered_acceleration(
    w: [f64; 5],
    filter: [f64; 2],
    second: [f64; 3],
    inverse: f64,
) -> f64 {
    let difference: [f64; 4] = std::array::from_fn(|k| w[k + 1] - w[k]);
    let second_difference: [f64; 3] =
        std::array::from_fn(|k| second[k] * (difference[k + 1] - difference[k]));
    let left = filter[0] * difference[1] - (second_difference[1] - second_difference[0]);
    let right = filter[1] * difference[2] - (second_difference[2] - second_difference[1]);
    w[2] - inverse * (right - left)
}

impl ChainState {
    /// Reserves space for the nodes read at a number of points: those of five elements each.
    pub(crate) fn reserve(&mut self, places: usize) {
        self.requested.reserve(10 * places);
    }
}

/// Step number after all others, for nodes whose motion is known in every step.
const ALWAYS: u64 = u64::MAX;

impl<const DIM: usize> Explicit<DIM> {
    /// Returns the initial `known_until` of each node; nodes of stiff groups are always known.
    fn initial_known_until(&self) -> Vec<u64> {
        let mut known_until = vec![0; self.points.len()];
        let stiff_nodes = self
            .islands
            .iter()
            .flat_map(|island_model| &island_model.stiff_nodes);
        stiff_nodes.for_each(|&node| known_until[node] = ALWAYS);
        known_until
    }

    /// Returns a state of zeros.
    pub(crate) fn zero_state(&self) -> ChainState {
        let along = vec![0.0; self.masters.lag.len()];
        ChainState {
            moving: vec![vec![TransverseMotion::default(); self.common.len()]; DIM - 1],
            axial_force_jump: vec![SimdVector::default(); self.common.len()],
            x: [along.clone(), along.clone()],
            lagged: along.clone(),
            master_force: along,
            axial_force: vec![0.0; self.axial_elements.len() + 1],
            requested: Vec::new(),
            always_requested: Vec::new(),
            steps: 0,
            known_until: self.initial_known_until(),
            finite_check: SimdVector::default(),
        }
    }

    /// Requests nodes to be read in every step, in addition to those of stiff groups.
    pub(crate) fn request_nodes_always(
        &self,
        chain: &mut ChainState,
        nodes: impl Iterator<Item = usize>,
    ) {
        let points = nodes.map(|node| self.points[node]);
        chain.always_requested = points
            .filter(|&p| self.in_stiff_group[p].is_none())
            .collect();
        chain.always_requested.sort_unstable();
        chain.always_requested.dedup();
        for &point in &chain.always_requested {
            chain.known_until[self.nodes[point]] = ALWAYS;
        }
    }

    /// Requests nodes to be read in the coming step.
    pub(crate) fn request_nodes(&self, chain: &mut ChainState, nodes: impl Iterator<Item = usize>) {
        chain.requested.clear();
        for node in nodes {
            chain.requested.push(self.points[node]);
            chain.known_until[node] = chain.known_until[node].max(chain.steps + 1);
        }
    }

    /// Finds the forces of wires on the points and masters of an island at their present positions.
    /// Every step leaves them.
    pub(crate) fn wire_forces(&self, island: usize, chain: &mut ChainState) {
        let island_model = &self.islands[island];
        widest(WireForces(ChainSweep {
            steps: self,
            island: island_model,
            chain,
        }));
        self.add_curve_forces(island_model, chain);
        self.transfer_tied_forces(island_model, chain);
    }

    /// Adds the forces of links, struts and springs, and sets the increments of their nodes, with
    /// `u` before the step, m.
    pub(in crate::integrator::explicit) fn apply_stiff_forces<const D: usize>(
        &self,
        island: usize,
        chain: &mut ChainState,
        (u, delta): (&[[f64; D]], &mut [[f64; D]]),
    ) {
        let island_model = &self.islands[island];
        copy_to_ghosts(&island_model.read_ghosts, chain, |row| [&mut row.w]);
        widest(ApplyStiffForces {
            island: island_model,
            chain,
            u,
            delta,
        });
    }

    /// Copies s and d into the ghost points. d as well: stripes differ in length, and the rows of a
    /// longer one move the ghosts of the others.
    #[inline(always)]
    pub(in crate::integrator::explicit) fn copy_ghost_positions(
        &self,
        island_model: &StripedBlock,
        chain: &mut ChainState,
    ) {
        copy_to_ghosts(&island_model.ghosts, chain, |row| [&mut row.s, &mut row.d]);
    }

    /// Copies accelerations w into the ghost points of all blocks.
    pub(in crate::integrator::explicit) fn copy_ghost_forces(
        &self,
        island_model: &IslandModel,
        chain: &mut ChainState,
    ) {
        for block in &island_model.blocks {
            copy_to_ghosts(&block.ghosts, chain, |row| [&mut row.w]);
        }
    }

    /// Returns the point and its two neighbours on both sides, as points, not ghosts.
    #[inline(always)]
    pub(in crate::integrator::explicit) fn stencil(&self, packed_index: usize) -> [usize; 5] {
        std::array::from_fn(|k| self.home[packed_index + SIMD_LANES * k - 2 * SIMD_LANES])
    }

    /// Extends the rise to the ghosts of points behind seams.
    #[inline(always)]
    pub(in crate::integrator::explicit) fn rise_to_ghosts(
        &self,
        island_model: &StripedBlock,
        chain: &mut ChainState,
    ) {
        for seam in &island_model.seams {
            let (row, simd_lane) = row_and_lane(seam.ghost_behind);
            let mut rise = chain.moving[0][row - 1].w[simd_lane];
            for (direction, rows) in self.transverse.iter().zip(&chain.moving) {
                let increment = rows[row].s[simd_lane] - rows[row - 1].s[simd_lane];
                rise += direction[row - 1].slope[simd_lane] * increment;
            }
            chain.moving[0][row].w[simd_lane] = rise;
        }
    }

    /// Returns the transverse acceleration of a point times h², m, from w.
    #[inline(always)]
    pub(in crate::integrator::explicit) fn acceleration(
        &self,
        direction: usize,
        packed_index: usize,
        rows: &[TransverseMotion],
    ) -> f64 {
        let (row, simd_lane) = row_and_lane(packed_index);
        let around = self.stencil(packed_index);
        let w: [f64; 5] = std::array::from_fn(|k| {
            let (row, simd_lane) = row_and_lane(around[k]);
            rows[row].w[simd_lane]
        });
        let coefficients = &self.common[row - 1..=row + 1];
        let filter = std::array::from_fn(|k| coefficients[k].filter[simd_lane]);
        let second = std::array::from_fn(|k| coefficients[k].second[simd_lane]);
        filtered_acceleration(
            w,
            filter,
            second,
            self.transverse[direction][row].inverse[simd_lane],
        )
    }

    /// Sets the increments of requested nodes, with `u` before the step, m.
    pub(in crate::integrator::explicit) fn gather_increments<const D: usize>(
        &self,
        chain: &ChainState,
        (u, delta): (&[[f64; D]], &mut [[f64; D]]),
    ) {
        for &packed_index in chain.always_requested.iter().chain(&chain.requested) {
            let (node, new) = (
                self.nodes[packed_index],
                self.motion_at(chain, packed_index),
            );
            for c in 0..DIM {
                delta[node][c] = new[c][0] - u[node][c];
            }
        }
    }

    /// Commits the increments of stiff nodes, and displacements and velocities of requested ones.
    pub(in crate::integrator::explicit) fn commit_nodes<const D: usize>(
        &self,
        chain: &ChainState,
        awake: &[usize],
        delta: &[[f64; D]],
        (u, v): (&mut [[f64; D]], &mut [[f64; D]]),
    ) {
        // Nested loops: a flattened iterator would test both levels for each node.
        for &island in awake {
            for &node in &self.islands[island].stiff_nodes {
                let (u, delta) = (&mut u[node], &delta[node]);
                for c in 0..DIM {
                    u[c] += delta[c];
                }
            }
        }
        for &packed_index in chain.always_requested.iter().chain(&chain.requested) {
            let node = self.nodes[packed_index];
            for (c, [place, speed]) in self.motion_at(chain, packed_index).into_iter().enumerate() {
                (u[node][c], v[node][c]) = (place, speed);
            }
        }
    }

    /// Returns position, m, and velocity, m/s, of a point at the end of the step, by component.
    #[inline(always)]
    fn motion_at(&self, chain: &ChainState, packed_index: usize) -> [[f64; 2]; DIM] {
        let (along, (row, simd_lane)) = (
            &self.axial_positions[packed_index],
            row_and_lane(packed_index),
        );
        let mut motion = [[0.0; 2]; DIM];
        motion[0] = [
            along.read(&chain.x[0]),
            self.per_step * along.read(&chain.x[1]),
        ];
        for (direction, rows) in chain.moving.iter().enumerate() {
            let a = self.acceleration(direction, packed_index, rows);
            let (s, d) = (rows[row].s[simd_lane], rows[row].d[simd_lane]);
            let y = s - self.damping[row].lag[simd_lane] * d;
            motion[direction + 1] = [y + BETA * a, self.per_step * (d + 0.5 * a)];
        }
        motion
    }

    /// Returns the displacement of a node across the track at the end of the step, m: of component
    /// 1 or more.
    ///
    /// That of `motion_at`, except that β h² a, less than a tenth of a millimetre, is taken before
    /// the dispersion filter: the neighbours of thousands of nodes would cost as much as the steps
    /// between two rows of motion.
    #[inline(always)]
    pub(crate) fn displacement_at_balance(
        &self,
        chain: &ChainState,
        node: usize,
        component: usize,
    ) -> f64 {
        let (row, simd_lane) = row_and_lane(self.points[node]);
        let point = &chain.moving[component - 1][row];
        point.s[simd_lane] - self.damping[row].lag[simd_lane] * point.d[simd_lane]
            + BETA * point.w[simd_lane]
    }

    /// Returns the displacement of a node after a step, m, by component; `None` of one in a stiff
    /// group, whose displacement the state holds.
    ///
    /// The state holds the predictor y of the coming step and its increment d, so that the
    /// predictor of the step done is y − d; β h² a of that step, less than a tenth of a millimetre,
    /// is not known any more.
    pub(crate) fn displacement_between_steps(
        &self,
        chain: &ChainState,
        node: usize,
    ) -> Option<[f64; DIM]> {
        let packed_index = self.points[node];
        if self.in_stiff_group[packed_index].is_some() {
            return None;
        }
        let (row, simd_lane) = row_and_lane(packed_index);
        let lag = self.damping[row].lag[simd_lane];
        let along = &self.axial_positions[packed_index];
        let mut found = [0.0; DIM];
        found[0] = along.read(&chain.x[0]) - along.read(&chain.x[1]);
        for (place, rows) in found[1..].iter_mut().zip(&chain.moving) {
            *place = rows[row].s[simd_lane] - (1.0 + lag) * rows[row].d[simd_lane];
        }
        Some(found)
    }

    /// Returns the velocity of a node at the end of the step, m/s, by component.
    pub(crate) fn velocity(&self, chain: &ChainState, node: usize) -> [f64; DIM] {
        self.motion_at(chain, self.points[node])
            .map(|[_, velocity]| velocity)
    }

    /// Advances an island by one step, and finds the forces of its wires for the next one.
    pub(in crate::integrator::explicit) fn advance_island(
        &self,
        island: usize,
        chain: &mut ChainState,
    ) {
        let island_model = &self.islands[island];
        self.accelerate_tied_ends(island_model, chain);
        self.copy_ghost_forces(island_model, chain);
        widest(ChainSweep {
            steps: self,
            island: island_model,
            chain,
        });
        self.add_curve_forces(island_model, chain);
        self.transfer_tied_forces(island_model, chain);
    }

    /// Returns true if an island is at rest in its static position.
    pub(crate) fn is_at_rest(&self, island: usize, chain: &ChainState) -> bool {
        let island_model = &self.islands[island];
        let rows = chain
            .moving
            .iter()
            .flat_map(|all| &all[island_model.rows.clone()]);
        let transverse = rows.flat_map(|row| row.s.iter().chain(row.d.iter()));
        let along = chain
            .x
            .iter()
            .flat_map(|list| &list[island_model.masters.clone()]);
        transverse.chain(along).all(|v| *v == 0.0)
    }

    /// Resets an island to rest.
    pub(crate) fn reset(&self, island: usize, chain: &mut ChainState) {
        let island_model = &self.islands[island];
        for rows in &mut chain.moving {
            rows[island_model.rows.clone()].fill(TransverseMotion::default());
        }
        chain.axial_force_jump[island_model.rows.clone()].fill(SimdVector::default());
        for list in chain.x.iter_mut().chain([&mut chain.master_force]) {
            list[island_model.masters.clone()].fill(0.0);
        }
    }
}
