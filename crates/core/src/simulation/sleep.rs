//! Islands of a line: wires side by side or one behind the other, which nothing couples.
//!
//! What no rider has reached stays at rest, exactly. So a step goes through the islands that are awake:
//! those that a rider touches or has touched. One that every rider has left, and of which nothing more is
//! recorded, is laid to rest again. A step then costs what one or two islands cost, however
//! long the line, and the forces are those of stepping everything, bit for bit.

use crate::integrator::prepared::WireModel;
use crate::linalg::islands::islands;
use crate::linear::model::LinearModel;
use crate::simulation::model::Model;
use crate::simulation::state::{Motion, State};
use std::ops::Range;

/// Where an island lies in the lists of a line.
#[derive(Debug, Clone)]
pub struct Island {
    /// Its nodes.
    pub nodes: Range<usize>,
    /// Its links.
    pub links: Range<usize>,
    /// Its blocks of the damping that is not common to all.
    pub damping: Range<usize>,
    /// Its components that cannot move.
    pub fixed: Range<usize>,
    /// Where it ends along the track, m.
    end: f64,
}

impl Island {
    /// The islands of a line, in the order of their nodes. A line whose links are not listed island by
    /// island is taken as one.
    pub(crate) fn all<const DIM: usize, const D: usize>(
        line: &LinearModel<DIM, D>,
        fixed: &[(u32, u32)],
    ) -> Vec<Self> {
        let nodes = islands(&line.stiffness);
        let ends = nodes.iter().map(|nodes| nodes.end).collect::<Vec<_>>();
        let of = |node: usize| ends.partition_point(|&end| end <= node);
        let of_links: Vec<usize> = line.links.iter().map(|link| of(link.nodes[0])).collect();
        if !of_links.is_sorted() {
            return vec![Self::whole(line, fixed)];
        }
        let own = |(number, nodes): (usize, Range<usize>)| {
            let link = |number: usize| of_links.partition_point(|&k| k < number);
            let block = |node: usize| line.damping_rest.partition_point(|b| b.0 < node);
            let held = |node: usize| fixed.partition_point(|f| (f.0 as usize) < node);
            Self {
                links: link(number)..link(number + 1),
                damping: block(nodes.start)..block(nodes.end),
                fixed: held(nodes.start)..held(nodes.end),
                end: end(line, nodes.clone()),
                nodes,
            }
        };
        nodes.into_iter().enumerate().map(own).collect()
    }

    fn whole<const DIM: usize, const D: usize>(
        line: &LinearModel<DIM, D>,
        fixed: &[(u32, u32)],
    ) -> Self {
        Self {
            nodes: 0..line.nodes(),
            links: 0..line.links.len(),
            damping: 0..line.damping_rest.len(),
            fixed: 0..fixed.len(),
            end: end(line, 0..line.nodes()),
        }
    }
}

/// Largest coordinate along the track of some nodes.
fn end<const DIM: usize, const D: usize>(line: &LinearModel<DIM, D>, nodes: Range<usize>) -> f64 {
    let along = line.shape[nodes].iter().map(|r| r[0]);
    along.fold(f64::NEG_INFINITY, f64::max)
}

impl<const DIM: usize, const D: usize> WireModel<DIM, D> {
    /// Islands by their numbers.
    pub(crate) fn awake<'a>(&'a self, numbers: &'a [usize]) -> impl Iterator<Item = &'a Island> {
        numbers.iter().map(|&number| &self.islands[number])
    }

    /// Number of the island of a node.
    pub(crate) fn island_of(&self, node: usize) -> usize {
        self.islands.partition_point(|one| one.nodes.end <= node)
    }
}

impl<const DIM: usize, const D: usize> State<DIM, D> {
    /// At the start, and when a state was put back: let sleep what has not moved and is not touched.
    pub(crate) fn let_sleep(&mut self, model: &Model<'_, DIM, D>) {
        if !self.motion.may_sleep {
            return;
        }
        for number in (0..model.line.islands.len()).rev() {
            let rests = model.line.is_at_rest(&self.motion.line, number);
            if rests && !self.motion.is_touched(model, number) {
                self.put_to_sleep(model, number);
            }
        }
    }

    /// Let sleep what all riders have left and what lies behind all that is recorded, with the first rider
    /// at a position.
    pub(crate) fn leave_behind(&mut self, model: &Model<'_, DIM, D>, position: f64) {
        let Some(recorder) = &self.recorder else {
            return;
        };
        if !self.motion.may_sleep {
            return;
        }
        let Some(from) = recorder.first_recorded(model, position) else {
            return;
        };
        for k in (0..self.motion.line.awake.len()).rev() {
            let number = self.motion.line.awake[k];
            let ends = model.line.islands[number].end < from;
            let Some(recorder) = &mut self.recorder else {
                return;
            };
            let nodes = &model.line.islands[number].nodes;
            if ends && !self.motion.is_touched(model, number) && !recorder.has_points(nodes) {
                recorder.leave(model, &self.motion, number);
                self.put_to_sleep(model, number);
            }
        }
    }

    /// What sleeps is as it was at rest, and stays so; that counts among the extremes.
    fn put_to_sleep(&mut self, model: &Model<'_, DIM, D>, number: usize) {
        self.motion.put_to_sleep(model, number);
        if let Some(recorder) = &mut self.recorder {
            recorder.watch_island(model, &self.motion, number);
        }
    }
}

impl<const DIM: usize, const D: usize> Motion<DIM, D> {
    /// Wake the islands that contacts of this step act on.
    pub(crate) fn wake(&mut self, model: &Model<'_, DIM, D>) {
        for &i in &self.contacts.active {
            let number = model.line.island_of(self.contacts.all[i].place.nodes[0]);
            if let Err(place) = self.line.awake.binary_search(&number) {
                self.line.awake.insert(place, number);
            }
        }
    }

    fn is_touched(&self, model: &Model<'_, DIM, D>, number: usize) -> bool {
        let nodes = &model.line.islands[number].nodes;
        let mut contacts = self.contacts.all.iter();
        contacts.any(|c| c.meets && nodes.contains(&c.ends[1].nodes[0]))
    }

    fn put_to_sleep(&mut self, model: &Model<'_, DIM, D>, number: usize) {
        let (line, state) = (model.line, &mut self.line);
        line.reset(state, number);
        for i in line.islands[number].links.clone() {
            let link = &line.line.links[i];
            self.unilateral.correction[i] = link.rest_correction();
            state.links.tension[i] = link.rest_tension;
        }
        state.awake.retain(|&other| other != number);
    }
}
