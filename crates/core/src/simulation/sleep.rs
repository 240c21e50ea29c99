//! Sleep of islands: wires side by side or one behind the other, which nothing couples.
//!
//! Islands that no pantograph has reached stay exactly at rest. So a step moves the islands that
//! are awake: those that a pantograph touches or has touched. One that every pantograph has left,
//! and of which nothing more is recorded, is put back to rest. A step then has the cost of one or
//! two islands, however long the line is, and its forces are those of a step of all islands, bit
//! for bit.

use crate::simulation::model::Model;
use crate::simulation::motion::Motion;
use crate::simulation::state::State;

impl<const DIM: usize, const D: usize> State<DIM, D> {
    /// Puts to sleep the islands that have not moved and are not touched: at the start, and after a
    /// state was restored.
    pub(crate) fn sleep_untouched(&mut self, model: &Model<'_, DIM, D>) {
        if !self.motion.may_sleep {
            return;
        }
        for number in (0..model.wires.islands.len()).rev() {
            let is_at_rest = model.wires.is_at_rest(&self.motion.wires, number);
            if is_at_rest && !self.motion.is_touched(model, number) {
                self.sleep_island(model, number);
            }
        }
    }

    /// Puts to sleep the islands that all pantographs have left and that end before all recorded
    /// points, with the first pantograph at a position (m).
    pub(crate) fn sleep_passed(&mut self, model: &Model<'_, DIM, D>, position: f64) {
        let Some(recorder) = &self.recorder else {
            return;
        };
        if !self.motion.may_sleep {
            return;
        }
        let Some(from) = recorder.first_recorded(model, position) else {
            return;
        };
        for k in (0..self.motion.wires.awake.len()).rev() {
            let number = self.motion.wires.awake[k];
            let ends = model.wires.islands[number].end < from;
            let Some(recorder) = &mut self.recorder else {
                return;
            };
            let nodes = &model.wires.islands[number].nodes;
            if ends && !self.motion.is_touched(model, number) && !recorder.has_points(nodes) {
                recorder.leave(model, &self.motion, number);
                self.sleep_island(model, number);
            }
        }
    }

    /// Puts an island to sleep. Its state of rest counts among the extremes.
    fn sleep_island(&mut self, model: &Model<'_, DIM, D>, number: usize) {
        self.motion.sleep_island(model, number);
        if let Some(recorder) = &mut self.recorder {
            recorder.watch_island(model, &self.motion, number);
        }
    }
}

impl<const DIM: usize, const D: usize> Motion<DIM, D> {
    /// Wakes the islands that contacts of this step act on.
    pub(crate) fn wake(&mut self, model: &Model<'_, DIM, D>) {
        for &i in &self.contacts.active {
            let number = model.wires.island_of(self.contacts.all[i].point.nodes[0]);
            if let Err(index) = self.wires.awake.binary_search(&number) {
                self.wires.awake.insert(index, number);
            }
        }
    }

    fn is_touched(&self, model: &Model<'_, DIM, D>, number: usize) -> bool {
        let nodes = &model.wires.islands[number].nodes;
        let mut contacts = self.contacts.all.iter();
        contacts.any(|c| c.is_active && nodes.contains(&c.ends[1].nodes[0]))
    }

    fn sleep_island(&mut self, model: &Model<'_, DIM, D>, number: usize) {
        let (wires, state) = (model.wires, &mut self.wires);
        wires.reset(state, number);
        for i in wires.islands[number].links.clone() {
            let link = &wires.line.links[i];
            self.problem.correction[i] = link.rest_correction();
            state.links.tension[i] = link.rest_tension;
        }
        state.awake.retain(|&other| other != number);
    }
}
