//! From the structure to lists of points, wire behind wire.

use crate::element::bar::BarState;
use crate::error::CoreError;
use crate::integrator::explicit::chain_model::along::Reach;
use crate::integrator::explicit::chain_model::bends::Fit;
use crate::integrator::explicit::chain_model::blocks::{Ranges, Run};
use crate::integrator::explicit::chain_model::waves::Waves;
use crate::integrator::explicit::simd::strands::Strands;
use crate::integrator::explicit::stiff_groups::cluster::Cluster;
use crate::integrator::explicit::{Along, Explicit, refuse};
use crate::linalg::islands::islands;
use crate::linear::model::LinearModel;
use crate::statics::assembly::{Geometry, Shape};
use crate::structure::Segment;
use std::ops::Range;

/// Points of no wire before the first and behind the last.
const PAD: usize = 2;

/// Wires as lists of segments, end to end; all that go through a bend stay together.
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

/// Nodes of a wire.
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

fn runs<const DIM: usize, const D: usize>(
    geometry: &Geometry<DIM, D>,
    line: &LinearModel<DIM, D>,
) -> (Vec<Run>, usize) {
    let ranges = islands(&line.stiffness);
    let island = |node: usize| ranges.partition_point(|r| r.end <= node);
    let wires = wires(geometry);
    let mut alone = vec![true; geometry.nodes()];
    let mut all: Vec<Run> = wires
        .into_iter()
        .map(|segments| {
            let nodes = nodes_of(geometry, &segments);
            nodes.iter().for_each(|&node| alone[node] = false);
            Run {
                island: island(nodes[0]),
                segments,
                nodes,
                first: 0,
            }
        })
        .collect();
    let alone = (0..geometry.nodes()).filter(|&node| alone[node]);
    all.extend(alone.map(|node| Run {
        island: island(node),
        segments: Vec::new(),
        nodes: vec![node],
        first: 0,
    }));
    all.sort_by_key(|run| (run.island, !run.is_long()));
    let mut at = PAD;
    for run in &mut all {
        run.first = at;
        at += run.nodes.len();
    }
    (all, ranges.len())
}

/// Mass of each node and α times it.
fn masses<const DIM: usize, const D: usize>(
    geometry: &Geometry<DIM, D>,
    shape: &Shape<D>,
    common: f64,
) -> Vec<[f64; 2]> {
    let s = &geometry.structure;
    let mut all = vec![[0.0; 2]; geometry.nodes()];
    let mut add = |node: usize, mass: f64, alpha: f64| {
        all[node][0] += mass;
        all[node][1] += alpha * mass;
    };
    for k in &s.segments {
        let half = 0.5 * k.mass * k.rest_length;
        k.nodes
            .iter()
            .for_each(|&node| add(node, half, k.damping.alpha));
    }
    s.masses.iter().for_each(|m| add(m.node, m.mass, m.alpha));
    for link in &s.links {
        let half = 0.5 * link.mass * Geometry::<DIM, D>::link_state(shape, link).length;
        link.nodes
            .iter()
            .for_each(|&node| add(node, half, link.damping.alpha));
    }
    s.struts
        .iter()
        .for_each(|strut| add(strut.node, strut.moving_mass, common));
    all
}

/// A line of chains, point by point. Segment j lies between points j and j + 1; where two wires meet in
/// the numbering, its numbers are zero. Lists of lists hold one for each direction across.
pub(in crate::integrator::explicit) struct Chains {
    /// Step, s.
    pub h: f64,
    /// Node of each point.
    pub nodes: Vec<usize>,
    /// Point of each node.
    pub points: Vec<usize>,
    pub own: Vec<Ranges>,
    /// h²/m of each point, s²/kg; zero where held; one for a guest.
    pub inverse: Vec<Vec<f64>>,
    /// α h of each point.
    pub damping: Vec<f64>,
    /// β/h of each point.
    pub lag: Vec<f64>,
    /// Stiffness of a segment under tension, N/m.
    pub tension: Vec<Vec<f64>>,
    /// 1/L of a segment, 1/m.
    pub per_length: Vec<f64>,
    /// EI/ℓ̄ of a point, N·m.
    pub bending: Vec<f64>,
    /// tan φ of a segment.
    pub slope: Vec<Vec<f64>>,
    /// q/h² of a segment, kg/s².
    pub filter: Vec<f64>,
    /// r/h² of a point, kg/s².
    pub second: Vec<f64>,
    pub reaches: Vec<Reach>,
    pub along: Vec<Along>,
    /// h²/m of each master along the wire, s²/kg; α h; β/h.
    pub masters: Vec<[f64; 3]>,
    pub clusters: Vec<Cluster>,
    /// Cluster of each point, and which of its points it is.
    pub in_cluster: Vec<Option<(usize, usize)>>,
    /// Ends of wires at a point of another: guest, owner.
    pub guests: Vec<(usize, usize)>,
    /// How each block is cut, and the slot of each point.
    pub strands: Vec<Strands>,
    pub slots: Vec<usize>,
}

impl<const DIM: usize> Explicit<DIM> {
    /// From a structure whose wires are chains, about `shape`; steps of `h` seconds.
    ///
    /// # Errors
    /// [`CoreError::Input`]: cubic elements, points without mass, or a step too long for the segments.
    pub fn new<const D: usize>(
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        line: &LinearModel<DIM, D>,
        h: f64,
    ) -> Result<Self, CoreError> {
        let with = |h| Ok(Chains::new(geometry, shape, line, h)?.dealt());
        let new: Self = with(h)?;
        new.check_step(with)?;
        Ok(new)
    }
}

impl Chains {
    /// For steps of any length.
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
        let (runs, islands) = runs(geometry, line);
        let count = runs.iter().map(|run| run.nodes.len()).sum::<usize>() + 2 * PAD;
        let zero = vec![0.0; count];
        let across = || vec![zero.clone(); DIM - 1];
        let mut new = Self {
            h,
            nodes: vec![usize::MAX; count],
            points: vec![usize::MAX; geometry.nodes()],
            own: Vec::new(),
            inverse: across(),
            damping: zero.clone(),
            lag: zero.clone(),
            tension: across(),
            per_length: zero.clone(),
            bending: zero.clone(),
            slope: across(),
            filter: zero.clone(),
            second: zero.clone(),
            reaches: Vec::new(),
            along: vec![Along::default(); count],
            masters: Vec::new(),
            clusters: Vec::new(),
            in_cluster: vec![None; count],
            guests: Vec::new(),
            strands: Vec::new(),
            slots: vec![usize::MAX; count],
        };
        new.number(&runs);
        new.add_segments(geometry, shape, &runs);
        let masses = masses(geometry, shape, line.common.alpha);
        new.add_masses(line, &masses)?;
        new.cluster(geometry, shape, line)?;
        new.cut(&runs, islands);
        new.lay_along(geometry, shape, line, (&runs, islands), &masses)?;
        Ok(new)
    }

    /// Nodes and points; a node inside of a wire belongs there, one at several ends to the first.
    fn number(&mut self, runs: &[Run]) {
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
        for point in self.all() {
            let owner = self.points[self.nodes[point]];
            if owner != point {
                self.guests.push((point, owner));
            }
        }
    }

    fn add_segments<const DIM: usize, const D: usize>(
        &mut self,
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        runs: &[Run],
    ) {
        let s = &geometry.structure;
        let mut waves = Waves::none(self.nodes.len());
        for run in runs {
            for (k, &number) in run.segments.iter().enumerate() {
                let (j, segment) = (run.first + k, &s.segments[number]);
                let state = Geometry::<DIM, D>::segment_state(shape, segment);
                self.per_length[j] = 1.0 / segment.rest_length;
                let (mass, tension) = (segment.mass * segment.rest_length, state.linear_tension);
                let (stretch, turn, along) = along(segment, &state);
                for c in 1..DIM {
                    if s.across_only {
                        self.tension[c - 1][j] = turn;
                        continue;
                    }
                    let part = (stretch - turn) / along * state.direction[c];
                    self.slope[c - 1][j] = part * state.direction[0];
                    self.tension[c - 1][j] = turn * (1.0 + part * state.direction[c]);
                }
                let courant = tension / state.length * self.h * self.h / mass;
                (waves.mass[j], waves.courant[j]) = (mass, courant);
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
            let fit = Fit::new(geometry, shape, bend);
            let point = point_behind[bend.segments[0]];
            self.bending[point] = fit.bending / fit.length;
            waves.bend(point, &fit);
        }
        self.keep_speed(runs, &waves);
    }

    fn add_masses<const DIM: usize, const D: usize>(
        &mut self,
        line: &LinearModel<DIM, D>,
        masses: &[[f64; 2]],
    ) -> Result<(), CoreError> {
        for point in self.all() {
            let node = self.nodes[point];
            let ([mass, damped], is_guest) = (masses[node], self.points[node] != point);
            if mass > 0.0 && !is_guest {
                self.damping[point] = damped / mass * self.h;
            }
            for c in 1..DIM {
                let free = line.free[node][c];
                if free && mass <= 0.0 {
                    return Err(refuse(&format!("node {node} moves without mass")));
                }
                self.inverse[c - 1][point] = match (is_guest, free) {
                    (true, _) => 1.0,
                    (false, true) => self.h * self.h / mass,
                    (false, false) => 0.0,
                };
            }
        }
        for &(guest, _) in &self.guests {
            (self.filter[guest], self.filter[guest - 1]) = (0.0, 0.0);
            self.second[guest - 1..=guest + 1].fill(0.0);
        }
        let both = self.filter.iter_mut().chain(&mut self.second);
        both.for_each(|q| *q /= self.h * self.h);
        Ok(())
    }

    /// Points that are there, without those of no wire at both ends.
    pub fn all(&self) -> Range<usize> {
        PAD..self.nodes.len() - PAD
    }
}

/// Stiffness of a segment for stretching, A, and for turning, B, and for a motion along the track,
/// K = A cos² φ + B sin² φ, N/m. When H is given, what remains across is B (1 + (A − B) sin² φ/K), and
/// tan φ is (A − B) sin φ cos φ/K.
pub(in crate::integrator::explicit) fn along<const DIM: usize>(
    segment: &Segment,
    state: &BarState<DIM>,
) -> (f64, f64, f64) {
    let (stretch, turn) = (segment.stiffness(), state.linear_tension / state.length);
    let squared = state.direction[0] * state.direction[0];
    (stretch, turn, stretch * squared + turn * (1.0 - squared))
}
