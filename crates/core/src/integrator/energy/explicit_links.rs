//! Links and dampers in the [`balance`](crate::integrator::energy::explicit) of explicit steps.

use crate::constraint::problem::ConstraintProblem;
use crate::integrator::WireState;
use crate::integrator::energy::explicit::ExplicitBalance;
use crate::integrator::explicit::{Explicit, Grid};
use crate::integrator::prepared::WireModel;
use crate::linalg::{Kernel, widest};
use crate::linear::model::LinearLink;

/// A damper to ground: node, component, N·s/m, and h v of the node, m.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Damper {
    pub node: usize,
    pub component: usize,
    pub viscosity: f64,
    pub rate: f64,
}

impl<const DIM: usize, const D: usize> ExplicitBalance<DIM, D> {
    /// Of links that are slack in a state at rest: −r₀ e, and what they do not store, −½ min(T, 0)²/k.
    pub(crate) fn slack_at_rest(&self, p: &WireModel<DIM, D>, state: &WireState<D>) -> f64 {
        let slack = p.line.links.iter().filter(|link| link.unilateral);
        let of = |link: &LinearLink<DIM>| {
            let elongation = link.elongation(&state.u);
            let tension = link.rest_tension + link.stiffness * elongation;
            -link.rest_correction() * elongation - 0.5 * tension.min(0.0).powi(2) / link.stiffness
        };
        slack.map(of).sum()
    }

    /// What slack links do not store, and the work of their corrections.
    pub(crate) fn book_links(
        &mut self,
        p: &WireModel<DIM, D>,
        (steps, grid): (&Explicit<DIM>, &Grid),
        unilateral: &ConstraintProblem,
    ) {
        let (links, corrections) = (&p.line.links, &unilateral.correction);
        let slack = unilateral.links.iter().filter(|&&l| corrections[l] > 0.0);
        let at_rest = p.table.corrected.iter().map(|(link, _)| link);
        let mut energy = 0.0;
        for (&l, is_rest) in slack.map(|l| (l, false)).chain(at_rest.map(|l| (l, true))) {
            let (link, r0) = (&links[l], links[l].rest_correction());
            link.nodes
                .iter()
                .for_each(|&node| self.look(steps, grid, node));
            let moved = link.elongation(&self.moved);
            let ended = link.elongation(&self.z) + moved;
            if is_rest {
                // r₀ pushes always, and what it does is stored.
                energy -= r0 * ended;
                self.entries.switching -= r0 * moved;
                self.work += r0 * moved;
                continue;
            }
            let tension = link.rest_tension + link.stiffness * ended;
            energy -= 0.5 * tension.min(0.0).powi(2) / link.stiffness;
            self.entries.switching += corrections[l] * moved;
            self.work -= corrections[l] * moved;
        }
        self.entries.switching -= energy - self.slack;
        self.slack = energy;
    }

    /// Dampers to ground. Across the wire nodes step by the trapezoidal rule, so h v follows from their increments.
    pub(crate) fn book_dampers(
        &mut self,
        h: f64,
        (steps, grid): (&Explicit<DIM>, &Grid),
        state: &WireState<D>,
    ) {
        for damper in &mut self.dampers {
            let by = state.delta[damper.node][damper.component];
            let (seen, moved) = if damper.component == 0 {
                (by, steps.halves(grid, damper.node)[0][1])
            } else {
                damper.rate = 2.0 * by - damper.rate;
                (damper.rate, damper.rate)
            };
            let lost = damper.viscosity / h * seen * moved;
            self.entries.dissipated_springs += lost;
            self.of_step += lost;
        }
    }

    /// Dissipation of links as if all were linear; what slack ones have of it is no dissipation.
    pub(crate) fn book_linear_links(
        &mut self,
        p: &WireModel<DIM, D>,
        state: &WireState<D>,
        unilateral: &ConstraintProblem,
    ) {
        let rates = &state.links.rate;
        let mut sum = 0.0;
        for island in p.awake(&state.awake) {
            let which = island.links.clone();
            widest(Squares {
                c: &p.table.viscosity[which.clone()],
                v: &rates[which],
                sum: &mut sum,
            });
        }
        let slack = unilateral.links.iter();
        let slack = slack.filter(|&&l| unilateral.correction[l] > 0.0);
        let of = |&l: &usize| p.table.viscosity[l] * rates[l] * rates[l];
        let undone = p.h * slack.map(of).sum::<f64>();
        self.of_step += p.h * sum;
        self.entries.dissipated_links += p.h * sum - undone;
        self.entries.switching += undone;
        self.switched += undone;
    }
}

/// Σ c v².
struct Squares<'a> {
    c: &'a [f64],
    v: &'a [f64],
    sum: &'a mut f64,
}

impl Kernel for Squares<'_> {
    /// Summed side by side: one after the other they would wait for each other.
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

/// Dampers of a line at rest; springs alone are left out.
pub(crate) fn dampers<const DIM: usize, const D: usize>(p: &WireModel<DIM, D>) -> Vec<Damper> {
    let all = p.line.dampers.iter().filter(|damper| damper.2 != 0.0);
    let at_rest = all.map(|&(node, component, viscosity)| Damper {
        node,
        component,
        viscosity,
        rate: 0.0,
    });
    at_rest.collect()
}
