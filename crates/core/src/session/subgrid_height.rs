//! Height of the real wire above the mesh in a session: see
//! [`local_compliance`](crate::slideline::local_compliance).

use crate::session::outputs::Outputs;
use crate::session::snapshot::{Snapshot, TouchPoint};
use crate::slideline::Slideline;

/// Half of the distance over which slopes are taken, m. Kinks are rounded over a tenth of a metre,
/// so the error, its square, does not count; nor does the rounding of positions.
const SLOPE_DISTANCE: f64 = 1e-4;

/// Adds the heights of the real wires above the mesh, and their rates, to the outputs of a session.
pub(crate) fn add_subgrid_heights<const DIM: usize, const D: usize>(
    outputs: &mut Outputs,
    snapshot: &Snapshot<'_, DIM, D>,
) {
    if snapshot.line.slidelines.iter().all(Slideline::is_rigid) {
        return;
    }
    for number in 0..outputs.height.len() {
        let Some(touch) = snapshot.touch_point(number, 0.0) else {
            continue;
        };
        let here = height_above_mesh(snapshot, &outputs.force, &touch, 0.0);
        let [mut slope, mut distance] = [0.0; 2];
        for shift in [SLOPE_DISTANCE, -SLOPE_DISTANCE] {
            if let Some(touch) = snapshot.touch_point(number, shift) {
                let there = height_above_mesh(snapshot, &outputs.force, &touch, shift);
                slope += (there - here) * shift.signum();
                distance += SLOPE_DISTANCE;
            }
        }
        let elongation_rates = &snapshot.motion.wires.links.rate;
        let by_links = touch
            .compliance
            .links()
            .map(|(l, r)| snapshot.line.tension_relief(l, r) * elongation_rates[l]);
        let by_travel = if distance > 0.0 {
            snapshot.speed * slope / distance
        } else {
            0.0
        };
        let rate = by_links.sum::<f64>() + by_travel;
        outputs.height[number] += here;
        outputs.rate[number] += rate;
    }
}

/// Height of the real wire above the mesh at the end of the step, m, under the contact forces, N,
/// and the link corrections of the step, when all contacts have moved along the track by `shift`,
/// m.
pub(crate) fn height_above_mesh<const DIM: usize, const D: usize>(
    snapshot: &Snapshot<'_, DIM, D>,
    forces: &[f64],
    touch: &TouchPoint<DIM>,
    shift: f64,
) -> f64 {
    let (line, motion) = (snapshot.line, snapshot.motion);
    let correction = &motion.problem.correction;
    let by_link = |(l, r): (usize, f64)| {
        let slack = correction[l] - line.line.links[l].rest_correction();
        line.tension_relief(l, r) * motion.wires.links.elongation[l] + r * slack
    };
    let compliance = &touch.compliance;
    let mut height = compliance.static_height + compliance.links().map(by_link).sum::<f64>();
    for (number, force) in forces.iter().enumerate().filter(|(_, f)| **f != 0.0) {
        if let Some(other) = snapshot.touch_point(number, shift) {
            let residual = if other.slideline == touch.slideline {
                line.slidelines[touch.slideline].residual_flexibility(&touch.point, &other.point)
            } else {
                0.0
            };
            height +=
                force * (residual - line.flexibility_through_links(compliance, &other.compliance));
        }
    }
    height
}
