//! From the structure to the lists of points.

use super::cluster::{Cluster, Member};
use super::{Along, Explicit, Own, PAD, Reach, refuse};
use crate::dynamics::line::Line;
use crate::element::bar::BarState;
use crate::error::CoreError;
use crate::linalg::SymmetricBlocks;
use crate::linalg::islands::islands;
use crate::statics::assembly::{Geometry, Shape, link_tension};
use crate::structure::Segment;
use std::ops::Range;

/// Shortest reach along the wire, in those that are just stable; the frequency of a reach is then still
/// above 100 Hz at 1 ms.
const REACH: f64 = 1.2;

/// Wires as lists of segments, end to end; all that go through a bend stay together.
fn wires<const DIM: usize, const D: usize>(geometry: &Geometry<DIM, D>) -> Vec<Vec<usize>> {
    let s = &geometry.structure;
    let (mut from, mut to) = (vec![Vec::new(); geometry.nodes()], vec![0; geometry.nodes()]);
    for (k, segment) in s.segments.iter().enumerate() {
        from[segment.nodes[0]].push(k);
        to[segment.nodes[1]] += 1;
    }
    let mut next: Vec<Option<usize>> = s
        .segments
        .iter()
        .map(|segment| match (&from[segment.nodes[1]][..], to[segment.nodes[1]]) {
            ([k], 1) => Some(*k),
            _ => None,
        })
        .collect();
    for bend in &s.bends {
        next[bend.segments[0]] = Some(bend.segments[1]);
    }
    let mut begins = vec![true; s.segments.len()];
    next.iter().flatten().for_each(|&k| begins[k] = false);
    let first = (0..s.segments.len()).filter(|&k| begins[k]);
    first.map(|k| std::iter::successors(Some(k), |&k| next[k]).collect()).collect()
}

/// Nodes of a wire.
fn nodes_of<const DIM: usize, const D: usize>(
    geometry: &Geometry<DIM, D>,
    wire: &[usize],
) -> Vec<usize> {
    let segments = &geometry.structure.segments;
    let first = segments[wire[0]].nodes[0];
    std::iter::once(first).chain(wire.iter().map(|&k| segments[k].nodes[1])).collect()
}

/// A wire, or a node of none, with the island it is in.
struct Run {
    island: usize,
    segments: Vec<usize>,
    nodes: Vec<usize>,
    first: usize,
}

fn runs<const DIM: usize, const D: usize>(geometry: &Geometry<DIM, D>, line: &Line<DIM, D>) -> (Vec<Run>, usize) {
    let ranges = islands(&line.stiffness);
    let island = |node: usize| ranges.partition_point(|r| r.end <= node);
    let wires = wires(geometry);
    let mut alone = vec![true; geometry.nodes()];
    let mut all: Vec<Run> = wires
        .into_iter()
        .map(|segments| {
            let nodes = nodes_of(geometry, &segments);
            nodes.iter().for_each(|&node| alone[node] = false);
            Run { island: island(nodes[0]), segments, nodes, first: 0 }
        })
        .collect();
    let alone = (0..geometry.nodes()).filter(|&node| alone[node]);
    all.extend(alone.map(|node| Run {
        island: island(node),
        segments: Vec::new(),
        nodes: vec![node],
        first: 0,
    }));
    all.sort_by_key(|run| run.island);
    let mut at = PAD;
    for run in &mut all {
        run.first = at;
        at += run.nodes.len();
    }
    (all, ranges.len())
}

/// Mass of each node and α times it.
fn masses<const DIM: usize, const D: usize>(geometry: &Geometry<DIM, D>, shape: &Shape<D>, common: f64) -> Vec<[f64; 2]> {
    let s = &geometry.structure;
    let mut all = vec![[0.0; 2]; geometry.nodes()];
    let mut add = |node: usize, mass: f64, alpha: f64| {
        all[node][0] += mass;
        all[node][1] += alpha * mass;
    };
    for k in &s.segments {
        let half = 0.5 * k.mass * k.rest_length;
        k.nodes.iter().for_each(|&node| add(node, half, k.damping.alpha));
    }
    s.masses.iter().for_each(|m| add(m.node, m.mass, m.alpha));
    for link in &s.links {
        let half = 0.5 * link.mass * Geometry::<DIM, D>::link_state(shape, link).length;
        link.nodes.iter().for_each(|&node| add(node, half, link.damping.alpha));
    }
    s.struts.iter().for_each(|strut| add(strut.node, strut.moving_mass, common));
    all
}

impl<const DIM: usize> Explicit<DIM> {
    /// From a structure whose wires are chains, about `shape`; steps of `h` seconds.
    ///
    /// # Errors
    /// [`CoreError::Input`]: cubic elements, points without mass, or a step too long for the segments.
    pub fn new<const D: usize>(
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        line: &Line<DIM, D>,
        h: f64,
    ) -> Result<Self, CoreError> {
        let new = Self::laid(geometry, shape, line, h)?;
        new.check_step(|h| Self::laid(geometry, shape, line, h))?;
        Ok(new)
    }

    /// The same with steps of any length.
    fn laid<const D: usize>(
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        line: &Line<DIM, D>,
        h: f64,
    ) -> Result<Self, CoreError> {
        if D != DIM {
            return Err(refuse("wires of cubic elements: explicit steps need point masses"));
        }
        let (runs, islands) = runs(geometry, line);
        let count = runs.iter().map(|run| run.nodes.len()).sum::<usize>() + 2 * PAD;
        let zero = vec![0.0; count];
        let across = || vec![zero.clone(); DIM - 1];
        let mut new = Self {
            h,
            per_step: 1.0 / h,
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
            reaches: Vec::new(),
            along: vec![Along::default(); count],
            masters: Vec::new(),
            clusters: Vec::new(),
            in_cluster: vec![None; count],
            guests: Vec::new(),
        };
        new.number(&runs);
        new.add_segments(geometry, shape, &runs);
        new.add_masses(geometry, line, shape)?;
        new.cluster(geometry, shape, line)?;
        new.lay_along(geometry, shape, line, (&runs, islands))?;
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
        for point in PAD..self.nodes.len() - PAD {
            let owner = self.points[self.nodes[point]];
            if owner != point {
                self.guests.push((point, owner));
            }
        }
    }

    fn add_segments<const D: usize>(&mut self, geometry: &Geometry<DIM, D>, shape: &Shape<D>, runs: &[Run]) {
        let s = &geometry.structure;
        for run in runs {
            for (k, &number) in run.segments.iter().enumerate() {
                let (j, segment) = (run.first + k, &s.segments[number]);
                let state = Geometry::<DIM, D>::segment_state(shape, segment);
                self.per_length[j] = 1.0 / segment.rest_length;
                let (mass, tension) = (segment.mass * segment.rest_length, state.linear_tension);
                let (stretch, turn, along) = along(segment, &state);
                for c in 1..DIM {
                    let part = (stretch - turn) / along * state.direction[c];
                    self.slope[c - 1][j] = part * state.direction[0];
                    self.tension[c - 1][j] = turn * (1.0 + part * state.direction[c]);
                }
                let courant = tension / state.length * self.h * self.h / mass;
                self.filter[j] = mass / 12.0 * (1.0 - courant);
                for point in [j, j + 1] {
                    self.lag[point] = segment.damping.beta / self.h;
                }
            }
        }
        let mut point_behind = vec![0; s.segments.len()];
        for run in runs {
            run.segments.iter().enumerate().for_each(|(k, &n)| point_behind[n] = run.first + k + 1);
        }
        for bend in &s.bends {
            let [a, b] = bend.segments.map(|k| s.segments[k].rest_length);
            self.bending[point_behind[bend.segments[0]]] = 2.0 * bend.stiffness / (a + b);
        }
    }

    fn add_masses<const D: usize>(&mut self, geometry: &Geometry<DIM, D>, line: &Line<DIM, D>, shape: &Shape<D>) -> Result<(), CoreError> {
        let masses = masses(geometry, shape, line.common.alpha);
        for point in PAD..self.nodes.len() - PAD {
            let node = self.nodes[point];
            let ([mass, damped], is_guest) = (masses[node], self.points[node] != point);
            if mass > 0.0 && !is_guest {
                self.damping[point] = damped / mass / self.h;
            }
            for c in 1..DIM {
                let free = line.free[node][c];
                if free && mass <= 0.0 {
                    return Err(refuse(&format!("node {node} moves without mass")));
                }
                self.inverse[c - 1][point] = match (is_guest, free) {
                    (true, _) => 1.0,
                    (false, true) => 1.0 / mass,
                    (false, false) => 0.0,
                };
            }
        }
        for &(guest, _) in &self.guests {
            (self.filter[guest], self.filter[guest - 1]) = (0.0, 0.0);
        }
        Ok(())
    }

    fn cluster<const D: usize>(&mut self, geometry: &Geometry<DIM, D>, shape: &Shape<D>, line: &Line<DIM, D>) -> Result<(), CoreError> {
        let [k, c] = implicit(geometry, shape, line);
        let s = &geometry.structure;
        let mut group: Vec<usize> = (0..geometry.nodes()).collect();
        let mut takes_part = vec![false; geometry.nodes()];
        for link in &s.links {
            let [a, b] = link.nodes.map(|node| root(&mut group, node));
            link.nodes.iter().for_each(|&node| takes_part[node] = true);
            group[b] = a;
        }
        let single = s.struts.iter().map(|t| t.node).chain(s.springs.iter().map(|t| t.node));
        single.for_each(|node| takes_part[node] = true);
        let mut members = std::collections::BTreeMap::<usize, Vec<usize>>::new();
        for node in (0..geometry.nodes()).filter(|&node| takes_part[node]) {
            members.entry(root(&mut group, node)).or_default().push(node);
        }
        let mut all: Vec<Vec<usize>> = members.into_values().collect();
        all.iter_mut().for_each(|nodes| nodes.iter_mut().for_each(|n| *n = self.points[*n]));
        all.sort();
        for (number, points) in all.iter().enumerate() {
            for (k, &point) in points.iter().enumerate() {
                self.in_cluster[point] = Some((number, k));
            }
        }
        // What would couple two clusters within a step keeps its lumped mass.
        for j in PAD..self.nodes.len() - PAD {
            if self.in_cluster[j].is_some() && self.in_cluster[j + 1].is_some() {
                self.filter[j] = 0.0;
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
        let mut inverse = [0.0; 2];
        (0..DIM - 1).for_each(|c| inverse[c] = self.inverse[c][point]);
        Member {
            point,
            node: self.nodes[point],
            along: Along::default(),
            inverse,
            response: inverse.map(|own| own * (1.0 + own * (filter[0] + filter[1]))),
            filter,
        }
    }

    /// Masters, reaches, and where all points lie between them, island by island.
    fn lay_along<const D: usize>(
        &mut self,
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        line: &Line<DIM, D>,
        (runs, islands): (&[Run], usize),
    ) -> Result<(), CoreError> {
        let mut master = vec![usize::MAX; self.nodes.len()];
        let mut is_owner = vec![false; self.nodes.len()];
        self.guests.iter().for_each(|&(_, owner)| is_owner[owner] = true);
        let mut lengths: Vec<(usize, Vec<usize>)> = Vec::new();
        let mut own = Vec::new();
        let masses = masses(geometry, shape, line.common.alpha);
        for island in 0..islands {
            let of = || runs.iter().filter(|run| run.island == island);
            let (masters, reaches) = (self.masters.len(), self.reaches.len());
            for run in of() {
                for point in self.places_along(geometry, line, run, &is_owner) {
                    let owner = self.points[self.nodes[point]];
                    if master[owner] == usize::MAX {
                        master[owner] = self.masters.len();
                        self.masters.push([0.0, 0.0, self.lag[owner]]);
                    }
                    match lengths.last_mut() {
                        Some((first, points)) if *first == run.first => points.push(point),
                        _ => lengths.push((run.first, vec![point])),
                    }
                }
            }
            for run in of() {
                let at = lengths.partition_point(|(first, _)| *first < run.first);
                let places = lengths[at].1.clone();
                self.add_reaches(geometry, shape, run, &places, &master);
            }
            let first = of().map(|run| run.first).min();
            let last = of().map(|run| run.first + run.nodes.len()).max();
            let (Some(first), Some(last)) = (first, last) else {
                return Err(refuse("an island without points"));
            };
            own.push(Own {
                points: first..last,
                reaches: reaches..self.reaches.len(),
                masters: masters..self.masters.len(),
                clusters: self.among(|k| self.clusters[k].members[0].point, self.clusters.len(), first..last),
                guests: self.among(|k| self.guests[k].0, self.guests.len(), first..last),
            });
        }
        self.own = own;
        for member in self.clusters.iter_mut().flat_map(|c| &mut c.members) {
            member.along = self.along[member.point];
        }
        for (node, [mass, damped]) in masses.into_iter().enumerate() {
            let along = self.along[self.points[node]];
            for (m, share) in along.masters.into_iter().zip([1.0 - along.share, along.share]) {
                self.masters[m][0] += share * mass;
                self.masters[m][1] += share * damped;
            }
        }
        let mut held = vec![false; self.masters.len()];
        for point in PAD..self.nodes.len() - PAD {
            let owner = self.points[self.nodes[point]];
            if master[owner] != usize::MAX && !line.free[self.nodes[point]][0] {
                held[master[owner]] = true;
            }
        }
        for (numbers, held) in self.masters.iter_mut().zip(held) {
            let [mass, damped, lag] = *numbers;
            *numbers = if held || mass <= 0.0 {
                [0.0; 3]
            } else {
                [1.0 / mass, damped / mass / self.h, lag]
            };
        }
        Ok(())
    }

    fn among(&self, of: impl Fn(usize) -> usize, count: usize, range: Range<usize>) -> Range<usize> {
        let inside = |k: &usize| range.contains(&of(*k));
        let first = (0..count).find(inside).unwrap_or(0);
        first..first + (0..count).filter(inside).count()
    }

    /// Points of a wire that become masters: its ends, what is held or has guests, and between them so
    /// many that reaches are equally long and long enough.
    fn places_along<const D: usize>(&self, geometry: &Geometry<DIM, D>, line: &Line<DIM, D>, run: &Run, is_owner: &[bool]) -> Vec<usize> {
        let segments = &geometry.structure.segments;
        let last = run.nodes.len() - 1;
        let needed = |k: usize| {
            k == 0 || k == last || !line.free[run.nodes[k]][0] || is_owner[run.first + k]
        };
        let needed: Vec<usize> = (0..=last).filter(|&k| needed(k)).collect();
        let mut at = vec![0.0; last + 1];
        let mut fastest: f64 = 0.0;
        for (k, &number) in run.segments.iter().enumerate() {
            let segment = &segments[number];
            at[k + 1] = at[k] + segment.rest_length;
            // Damping shortens the longest step, see `stable`.
            let damped = 1.0 + 2.0 * segment.damping.beta / self.h;
            fastest = fastest.max((damped * segment.axial_stiffness / segment.mass).sqrt());
        }
        // Damping is read a step late: see `stable`.
        let late = 1.0 + 2.0 * self.lag[run.first + last / 2];
        let shortest = REACH * fastest * self.h * late.sqrt();
        let mut places = vec![run.first];
        for pair in needed.windows(2) {
            let (mut from, to) = (at[pair[0]], at[pair[1]]);
            let pieces = ((to - from) / shortest).floor().max(1.0);
            let wanted = ((to - from) / pieces).min(to - from);
            for k in pair[0] + 1..pair[1] {
                // Rounding must not make a piece longer by an element.
                if at[k] - from > wanted * (1.0 - 1e-9) && to - at[k] >= shortest {
                    places.push(run.first + k);
                    from = at[k];
                }
            }
            places.push(run.first + pair[1]);
        }
        places.dedup();
        places
    }

    fn add_reaches<const D: usize>(&mut self, geometry: &Geometry<DIM, D>, shape: &Shape<D>, run: &Run, places: &[usize], master: &[usize]) {
        let of = |point: usize| master[self.points[self.nodes[point]]];
        let all = &geometry.structure.segments;
        if let [only] = places {
            self.along[*only] = Along { masters: [of(*only); 2], share: 0.0 };
        }
        for pair in places.windows(2) {
            let ends = [of(pair[0]), of(pair[1])];
            let (mut flexibility, mut at) = (0.0, vec![0.0]);
            for j in pair[0]..pair[1] {
                let segment = &all[run.segments[j - run.first]];
                let state = Geometry::<DIM, D>::segment_state(shape, segment);
                flexibility += 1.0 / along(segment, &state).2;
                at.push(at[at.len() - 1] + segment.rest_length);
            }
            let length = at[at.len() - 1];
            for (k, place) in at.iter().enumerate() {
                self.along[pair[0] + k] = Along { masters: ends, share: place / length };
            }
            self.reaches.push(Reach { masters: ends, segments: pair[0]..pair[1], stiffness: 1.0 / flexibility });
        }
    }
}

/// Stiffness of a segment for stretching, A, and for turning, B, and for a motion along the track,
/// K = A cos² φ + B sin² φ, N/m. When H is given, what remains across is B (1 + (A − B) sin² φ/K), and
/// tan φ is (A − B) sin φ cos φ/K.
fn along<const DIM: usize>(segment: &Segment, state: &BarState<DIM>) -> (f64, f64, f64) {
    let (stretch, turn) = (segment.stiffness(), state.linear_tension / state.length);
    let squared = state.direction[0] * state.direction[0];
    (stretch, turn, stretch * squared + turn * (1.0 - squared))
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
fn entry<const D: usize>(m: &SymmetricBlocks<D>, (i, p): (usize, usize), (j, q): (usize, usize)) -> f64 {
    let ((row, a), (column, b)) = if i < j { ((j, q), (i, p)) } else { ((i, p), (j, q)) };
    let places = m.row_start[row]..m.row_start[row + 1];
    let found = places.into_iter().find(|&k| m.columns[k] == column);
    found.map_or(0.0, |k| m.blocks[k][a][b])
}

/// K and C of links, struts and springs alone.
fn implicit<const DIM: usize, const D: usize>(geometry: &Geometry<DIM, D>, shape: &Shape<D>, line: &Line<DIM, D>) -> [SymmetricBlocks<D>; 2] {
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
