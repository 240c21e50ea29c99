//! Links and dampers in the [`balance`](crate::integrator::energy::explicit) of explicit steps.

use crate::constraint::problem::ConstraintProblem;
use crate::integrator::energy::explicit::{ExplicitBalance, GroundDamper};
use crate::integrator::explicit::{ChainState, Explicit};
use crate::integrator::state::WireState;
use crate::integrator::wire_model::WireModel;
use crate::linalg::{Kernel, widest};
use crate::linear::link::LinearLink;

impl<const DIM: usize, const D: usize> ExplicitBalance<DIM, D> {
    /// Returns the dampers of a line at rest; springs without damping are left out.
    pub(crate) fn ground_dampers(wires: &WireModel<DIM, D>) -> Vec<GroundDamper> {
        let dampers = wires.line.springs.iter().filter(|p| p.viscosity != 0.0);
        let at_rest = dampers.map(|spring| GroundDamper {
            node: spring.node,
            component: spring.component,
            viscosity: spring.viscosity,
            rate: 0.0,
        });
        at_rest.collect()
    }

    /// Returns the energy of slack links in a state at rest, J: −r₀ e, and −½ min(T, 0)²/k, which
    /// they do not store.
    pub(crate) fn slack_energy_at_rest(
        &self,
        wires: &WireModel<DIM, D>,
        state: &WireState<D>,
    ) -> f64 {
        let slack = wires.line.links.iter().filter(|link| link.unilateral);
        let value_of = |link: &LinearLink<DIM>| {
            let elongation = link.elongation(&state.u);
            let tension = link.rest_tension + link.stiffness * elongation;
            -link.rest_correction() * elongation - 0.5 * tension.min(0.0).powi(2) / link.stiffness
        };
        slack.map(value_of).sum()
    }

    /// Adds the energy that slack links do not store, and the work of their corrections.
    pub(crate) fn add_links(
        &mut self,
        wires: &WireModel<DIM, D>,
        (steps, chain): (&Explicit<DIM>, &ChainState),
        problem: &ConstraintProblem,
    ) {
        let (links, corrections) = (&wires.line.links, &problem.correction);
        let slack = problem.links.iter().filter(|&&l| corrections[l] > 0.0);
        let at_rest = wires.table.rest_corrections.iter().map(|(link, _)| link);
        let mut energy = 0.0;
        for (&l, is_rest) in slack.map(|l| (l, false)).chain(at_rest.map(|l| (l, true))) {
            let (link, r0) = (&links[l], links[l].rest_correction());
            link.nodes
                .iter()
                .for_each(|&node| self.update_node(steps, chain, node));
            let increment = link.elongation(&self.increment);
            let ended = link.elongation(&self.z) + increment;
            if is_rest {
                // r₀ acts always, and its work is stored.
                energy -= r0 * ended;
                self.terms.switching -= r0 * increment;
                self.work += r0 * increment;
                continue;
            }
            let tension = link.rest_tension + link.stiffness * ended;
            energy -= 0.5 * tension.min(0.0).powi(2) / link.stiffness;
            self.terms.switching += corrections[l] * increment;
            self.work -= corrections[l] * increment;
        }
        self.terms.switching -= energy - self.slack;
        self.slack = energy;
    }

    /// Adds the dissipation of dampers to ground. Across the wire nodes step by the trapezoidal
    /// rule, so h v follows from their increments.
    pub(crate) fn add_ground_dampers(
        &mut self,
        h: f64,
        (steps, chain): (&Explicit<DIM>, &ChainState),
        state: &WireState<D>,
    ) {
        for damper in &mut self.ground_dampers {
            let delta = state.delta[damper.node][damper.component];
            let (seen, moved) = if damper.component == 0 {
                (delta, steps.half_step_motion(chain, damper.node)[0][1])
            } else {
                damper.rate = 2.0 * delta - damper.rate;
                (damper.rate, damper.rate)
            };
            let lost = damper.viscosity / h * seen * moved;
            self.terms.dissipated_springs += lost;
            self.step_dissipation += lost;
        }
    }

    /// Adds the dissipation of links as if all were linear; the part of slack ones counts as
    /// switching.
    pub(crate) fn add_linear_links(
        &mut self,
        wires: &WireModel<DIM, D>,
        state: &WireState<D>,
        problem: &ConstraintProblem,
    ) {
        let rates = &state.links.rate;
        let mut sum = 0.0;
        for island in wires.awake(&state.awake) {
            let which = island.links.clone();
            widest(Squares {
                c: &wires.table.viscosity[which.clone()],
                v: &rates[which],
                sum: &mut sum,
            });
        }
        let slack = problem.links.iter();
        let slack = slack.filter(|&&l| problem.correction[l] > 0.0);
        let value_of = |&l: &usize| wires.table.viscosity[l] * rates[l] * rates[l];
        let undone = wires.h * slack.map(value_of).sum::<f64>();
        self.step_dissipation += wires.h * sum;
        self.terms.dissipated_links += wires.h * sum - undone;
        self.terms.switching += undone;
        self.contact_and_link_switching += undone;
    }
}

/// Kernel of Σ c v².
struct Squares<'a> {
    c: &'a [f64],
    v: &'a [f64],
    sum: &'a mut f64,
}

impl Kernel for Squares<'_> {
    /// Sums in eight accumulators: in a single one each addition would wait for the one before.
    #[inline(always)]
    fn run(self) {
        const SIDES: usize = 8;
        let (mut sums, (c, c_rest)) = ([0.0; SIDES], self.c.as_chunks::<SIDES>());
        let (v, v_rest) = self.v.as_chunks::<SIDES>();
        for (c, v) in c.iter().zip(v) {
            for k in 0..SIDES {
                sums[k] += c[k] * v[k] * v[k];
            }
        }
        let rest = c_rest.iter().zip(v_rest).map(|(c, v)| c * v * v);
        *self.sum += sums.iter().sum::<f64>() + rest.sum::<f64>();
    }
}
