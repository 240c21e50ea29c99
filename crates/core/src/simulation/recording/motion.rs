//! Motion of the wires near the pantographs, in single precision: what a picture of it needs.
//!
//! A row holds, of each wire, a fixed number of nodes in their order along the wire, from the first
//! one behind the last pantograph on: displacements upwards of all wires, then those to the left
//! where the line is spatial, then tensions of links near the pantographs.

use crate::simulation::model::Model;
use crate::simulation::motion::Motion;
use crate::simulation::recording::record::Record;
use crate::simulation::recording::window::MotionPlan;

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
