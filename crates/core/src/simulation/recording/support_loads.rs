//! Forces of what holds the wires at supports, at the time of balance: see
//! [`supports`](crate::linear::supports).

use crate::integrator::wire_model::Integrator;
use crate::linear::supports::LinearSpring;
use crate::simulation::model::Model;
use crate::simulation::motion::Motion;
use crate::simulation::recording::record::Record;
use crate::simulation::recording::support_parts::SupportParts;
use crate::slideline::point::Nodal;

/// Adds the row of a support to the record; NaN for a part that is not there.
pub(crate) fn record<const DIM: usize, const D: usize>(
    parts: &SupportParts,
    model: &Model<'_, DIM, D>,
    motion: &Motion<DIM, D>,
    record: &mut Record,
) {
    let line = &model.wires.line;
    let vertical = parts.vertical.map(|row| &line.springs[row]);
    let lateral = parts.lateral.map(|row| &line.springs[row]);
    let force = |spring: &LinearSpring| motion.spring_force(model, spring);
    let or_none = |value: Option<f64>| value.unwrap_or(f64::NAN);
    record.support_force.push(or_none(vertical.map(force)));
    // Of the wires on the support: the opposite of what holds the wires.
    let pulled = lateral.map(|spring| -force(spring));
    record.support_lateral.push(or_none(pulled));
    let lifted = |spring: &LinearSpring| {
        spring.real_share * motion.moved::<DIM>(model, spring.node)[spring.component]
    };
    record.held_uplift.push(or_none(vertical.map(lifted)));
    let arm = parts.arm.map(|row| {
        let strut = &line.struts[row];
        let u = motion.moved::<DIM>(model, strut.node);
        let tension = match model.wires.integrator {
            Integrator::UpdatedGeometry(..) => strut.tension(&u),
            _ => strut.linear_tension(&u),
        };
        (tension, strut.angle(&u))
    });
    record.arm_force.push(or_none(arm.map(|(force, _)| force)));
    record.arm_angle.push(or_none(arm.map(|(_, angle)| angle)));
}

impl<const DIM: usize, const D: usize> Motion<DIM, D> {
    /// Displacement of a node at the time of balance, m.
    fn moved<const N: usize>(&self, model: &Model<'_, DIM, D>, node: usize) -> [f64; N] {
        let ([u, delta], keep) = (self.wires.at_balance(), model.wires.coefficients.stiffness);
        std::array::from_fn(|c| u.at(node)[c] + keep * delta.at(node)[c])
    }

    /// Force of a spring and its damper on the wire along its component, N.
    fn spring_force(&self, model: &Model<'_, DIM, D>, spring: &LinearSpring) -> f64 {
        let LinearSpring {
            node, component, ..
        } = *spring;
        let moved = self.moved::<D>(model, node)[component];
        let elastic = spring.rest_force - spring.stiffness * moved;
        if spring.viscosity == 0.0 {
            return elastic;
        }
        let rate = model
            .wires
            .velocity_at_balance(&self.wires, node, component);
        elastic - spring.viscosity * rate
    }
}
