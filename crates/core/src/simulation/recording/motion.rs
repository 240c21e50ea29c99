//! Motion of the wires near the pantographs, in single precision: what a picture of it needs.
//!
//! A row holds, of each wire, a fixed number of nodes in their order along the wire, from the first
//! one behind the last pantograph on: displacements upwards of all wires, then those to the left
//! where the line is spatial, then tensions of links near the pantographs.

use crate::error::CoreError;
use crate::simulation::model::Model;
use crate::simulation::motion::Motion;
use crate::simulation::recording::record::Record;
use crate::simulation::recording::window::SortedStations;

/// Selection of recorded motion.
#[derive(Debug, Clone)]
pub struct MotionPlan {
    /// Every how many steps a row is recorded.
    pub every: usize,
    /// Distance behind the last pantograph at which a row begins, m.
    pub behind: f64,
    /// Nodes of each wire in the order along it.
    pub wires: Vec<SortedStations>,
    /// Links in the order along the track.
    pub links: SortedStations,
}

impl MotionPlan {
    /// # Errors
    /// [`CoreError::Input`] for coordinates out of order, or what is not there.
    pub(crate) fn check(&self, links: usize, nodes: usize) -> Result<(), CoreError> {
        let fits = self.wires.iter().all(|wire| wire.fits(nodes)) && self.links.fits(links);
        if self.every > 0 && self.behind.is_finite() && fits {
            return Ok(());
        }
        Err(CoreError::Input {
            array: "plan",
            reason: "the motion to record is not there, or not in the order along the track".into(),
        })
    }
}

/// Records the motion at the time of balance, s, with the first pantograph at a position, m.
pub(crate) fn record<const DIM: usize, const D: usize>(
    plan: &MotionPlan,
    model: &Model<'_, DIM, D>,
    motion: &Motion<DIM, D>,
    (time, position): (f64, f64),
    record: &mut Record,
) {
    let last = model.distances.iter().fold(0.0_f64, |d, v| d.max(*v));
    let from = position - last - plan.behind;
    record.motion_time.push(time);
    for wire in &plan.wires {
        record.motion_first.push(wire.first(from) as f64);
    }
    for component in (1..DIM).rev() {
        for wire in &plan.wires {
            let nodes = wire.row(wire.first(from));
            let (wires, out) = (model.wires, &mut record.motion);
            wires.add_displacements(&motion.wires, nodes, component, out);
        }
    }
    let first = plan.links.first(from);
    record.motion_first.push(first as f64);
    let links = plan.links.row(first).iter();
    record
        .motion
        .extend(links.map(|&link| motion.tension(link) as f32));
}
