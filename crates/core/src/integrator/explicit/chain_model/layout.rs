//! Layout of a structure as lists of points, wire after wire.

use crate::error::CoreError;
use crate::integrator::explicit::chain_model::bends::FittedBend;
use crate::integrator::explicit::chain_model::builder::{ChainBuilder, PAD, segment_stiffness};
use crate::integrator::explicit::chain_model::dispersion::DispersionTerms;
use crate::integrator::explicit::chain_model::parts::WireRun;
use crate::integrator::explicit::{AxialPosition, Explicit, refuse};
use crate::linalg::islands::islands;
use crate::linear::masses;
use crate::linear::model::LinearModel;
use crate::statics::assembly::{Geometry, Shape};

/// Returns the wires as lists of segments, end to end; segments joined by a bend stay together.
fn wires<const DIM: usize, const D: usize>(geometry: &Geometry<DIM, D>) -> Vec<Vec<usize>> {
    let s = &geometry.structure;
    let (mut from, mut to) = (
        vec![Vec::new(); geometry.nodes()],
        vec![0; geometry.nodes()],
    );
    for (k, segment) in s.segments.iter().enumerate() {
        from[segment.nodes[0]].push(k);
        to[segment.nodes[1]] += 1;
    }
    let mut next: Vec<Option<usize>> = s
        .segments
        .iter()
        .map(
            |segment| match (&from[segment.nodes[1]][..], to[segment.nodes[1]]) {
                ([k], 1) => Some(*k),
                _ => None,
            },
        )
        .collect();
    for bend in &s.bends {
        next[bend.segments[0]] = Some(bend.segments[1]);
    }
    let mut begins = vec![true; s.segments.len()];
    next.iter().flatten().for_each(|&k| begins[k] = false);
    let first = (0..s.segments.len()).filter(|&k| begins[k]);
    first
        .map(|k| std::iter::successors(Some(k), |&k| next[k]).collect())
        .collect()
}

/// Returns the nodes of a wire in their order.
fn nodes_of<const DIM: usize, const D: usize>(
    geometry: &Geometry<DIM, D>,
    wire: &[usize],
) -> Vec<usize> {
    let segments = &geometry.structure.segments;
    let first = segments[wire[0]].nodes[0];
    std::iter::once(first)
        .chain(wire.iter().map(|&k| segments[k].nodes[1]))
        .collect()
}

fn wire_runs<const DIM: usize, const D: usize>(
    geometry: &Geometry<DIM, D>,
    line: &LinearModel<DIM, D>,
) -> (Vec<WireRun>, usize) {
    let ranges = islands(&line.stiffness);
    let island = |node: usize| ranges.partition_point(|r| r.end <= node);
    let wires = wires(geometry);
    let mut alone = vec![true; geometry.nodes()];
    let mut all: Vec<WireRun> = wires
        .into_iter()
        .map(|segments| {
            let nodes = nodes_of(geometry, &segments);
            nodes.iter().for_each(|&node| alone[node] = false);
            WireRun {
                island: island(nodes[0]),
                segments,
                nodes,
                first: 0,
            }
        })
        .collect();
    let alone = (0..geometry.nodes()).filter(|&node| alone[node]);
    all.extend(alone.map(|node| WireRun {
        island: island(node),
        segments: Vec::new(),
        nodes: vec![node],
        first: 0,
    }));
    all.sort_by_key(|run| (run.island, !run.is_long()));
    let mut next_point = PAD;
    for run in &mut all {
        run.first = next_point;
        next_point += run.nodes.len();
    }
    (all, ranges.len())
}

/// Returns the mass of each node, kg, and Σ α m, kg/s.
fn node_masses<const DIM: usize, const D: usize>(
    geometry: &Geometry<DIM, D>,
    shape: &Shape<D>,
    common_alpha: f64,
) -> Vec<[f64; 2]> {
    let mut all = vec![[0.0; 2]; geometry.nodes()];
    let on_wires = masses::on_wires(geometry, shape, common_alpha);
    for point in masses::of_segments(geometry).chain(on_wires) {
        all[point.node][0] += point.mass;
        all[point.node][1] += point.alpha * point.mass;
    }
    all
}

impl<const DIM: usize> Explicit<DIM> {
    /// Prepares a structure whose wires are chains, about `shape`, for steps of `h`, s.
    ///
    /// # Errors
    /// [`CoreError::Input`]: cubic elements, points without mass, or a step too long for the
    /// segments.
    pub fn new<const D: usize>(
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        line: &LinearModel<DIM, D>,
        h: f64,
    ) -> Result<Self, CoreError> {
        let packed_with = |h| Ok(ChainBuilder::new(geometry, shape, line, h)?.packed());
        let new: Self = packed_with(h)?;
        new.check_step(packed_with)?;
        Ok(new)
    }
}

impl ChainBuilder {
    /// Builds the chain for a step `h`, s, stable or not.
    fn new<const DIM: usize, const D: usize>(
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        line: &LinearModel<DIM, D>,
        h: f64,
    ) -> Result<Self, CoreError> {
        if D != DIM {
            return Err(refuse(
                "wires of cubic elements: explicit steps need point masses",
            ));
        }
        let (runs, islands) = wire_runs(geometry, line);
        let count = runs.iter().map(|run| run.nodes.len()).sum::<usize>() + 2 * PAD;
        let zeros = vec![0.0; count];
        let transverse = || vec![zeros.clone(); DIM - 1];
        let mut new = Self {
            h,
            nodes: vec![usize::MAX; count],
            points: vec![usize::MAX; geometry.nodes()],
            islands: Vec::new(),
            inverse: transverse(),
            damping: zeros.clone(),
            lag: zeros.clone(),
            tension: transverse(),
            per_length: zeros.clone(),
            bending: zeros.clone(),
            slope: transverse(),
            filter: zeros.clone(),
            second: zeros.clone(),
            axial_elements: Vec::new(),
            axial_positions: vec![AxialPosition::default(); count],
            masters: Vec::new(),
            stiff_groups: Vec::new(),
            in_stiff_group: vec![None; count],
            tied_ends: Vec::new(),
            stripes: Vec::new(),
            packed_indices: vec![usize::MAX; count],
        };
        new.number_points(&runs);
        new.add_segments(geometry, shape, &runs);
        let masses = node_masses(geometry, shape, line.common.alpha);
        new.add_masses(line, &masses)?;
        new.add_stiff_groups(geometry, shape, line)?;
        new.stripe_blocks(&runs, islands);
        new.build_axial(geometry, shape, line, (&runs, islands), &masses)?;
        Ok(new)
    }

    /// Assigns nodes to points; an inner node of a wire belongs to that wire, a common end to the
    /// first one.
    fn number_points(&mut self, runs: &[WireRun]) {
        for inside in [true, false] {
            for run in runs {
                let last = run.nodes.len() - 1;
                for (k, &node) in run.nodes.iter().enumerate() {
                    let point = run.first + k;
                    self.nodes[point] = node;
                    let is_end = k == 0 || k == last;
                    if inside != is_end && self.points[node] == usize::MAX {
                        self.points[node] = point;
                    }
                }
            }
        }
        for point in self.points_of_wires() {
            let tie_master = self.points[self.nodes[point]];
            if tie_master != point {
                self.tied_ends.push((point, tie_master));
            }
        }
    }

    fn add_segments<const DIM: usize, const D: usize>(
        &mut self,
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        runs: &[WireRun],
    ) {
        let s = &geometry.structure;
        let mut dispersion = DispersionTerms::zero(self.nodes.len());
        for run in runs {
            for (k, &number) in run.segments.iter().enumerate() {
                let (j, segment) = (run.first + k, &s.segments[number]);
                let state = Geometry::<DIM, D>::segment_state(shape, segment);
                self.per_length[j] = 1.0 / segment.rest_length;
                let (mass, tension) = (segment.mass * segment.rest_length, state.linear_tension);
                let (axial, geometric, along_track) = segment_stiffness(segment, &state);
                for c in 1..DIM {
                    if s.across_only {
                        self.tension[c - 1][j] = geometric;
                        continue;
                    }
                    let part = (axial - geometric) / along_track * state.direction[c];
                    self.slope[c - 1][j] = part * state.direction[0];
                    self.tension[c - 1][j] = geometric * (1.0 + part * state.direction[c]);
                }
                let courant = tension / state.length * self.h * self.h / mass;
                (dispersion.mass[j], dispersion.courant[j]) = (mass, courant);
                for point in [j, j + 1] {
                    self.lag[point] = segment.damping.beta / self.h;
                }
            }
        }
        let mut point_behind = vec![0; s.segments.len()];
        for run in runs {
            run.segments
                .iter()
                .enumerate()
                .for_each(|(k, &n)| point_behind[n] = run.first + k + 1);
        }
        for bend in &s.bends {
            let fit = FittedBend::new(geometry, shape, bend);
            let point = point_behind[bend.segments[0]];
            self.bending[point] = fit.bending / fit.length;
            dispersion.set_bend(point, &fit);
        }
        self.correct_dispersion(runs, &dispersion);
    }

    fn add_masses<const DIM: usize, const D: usize>(
        &mut self,
        line: &LinearModel<DIM, D>,
        masses: &[[f64; 2]],
    ) -> Result<(), CoreError> {
        for point in self.points_of_wires() {
            let node = self.nodes[point];
            let ([mass, damped], is_tied) = (masses[node], self.points[node] != point);
            if mass > 0.0 && !is_tied {
                self.damping[point] = damped / mass * self.h;
            }
            for c in 1..DIM {
                let free = line.free[node][c];
                if free && mass <= 0.0 {
                    return Err(refuse(&format!("node {node} moves without mass")));
                }
                self.inverse[c - 1][point] = match (is_tied, free) {
                    (true, _) => 1.0,
                    (false, true) => self.h * self.h / mass,
                    (false, false) => 0.0,
                };
            }
        }
        for &(tied, _) in &self.tied_ends {
            (self.filter[tied], self.filter[tied - 1]) = (0.0, 0.0);
            self.second[tied - 1..=tied + 1].fill(0.0);
        }
        let both = self.filter.iter_mut().chain(&mut self.second);
        both.for_each(|q| *q /= self.h * self.h);
        Ok(())
    }
}
