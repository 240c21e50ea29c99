//! What a run records, and the extremes it keeps.

use super::contacts::Contact;
use super::near::Near;
use super::run::Run;
use crate::lcp::LcpStats;
use crate::linalg::{Kernel, widest};

impl<const DIM: usize, const D: usize> Run<'_, DIM, D> {
    /// Coordinate `c` of the wire at a contact, at the time of balance with the current increment.
    pub(super) fn wire_at(&self, contact: &Contact<DIM>, c: usize) -> f64 {
        let place = &contact.place;
        let rest = if c == DIM - 1 {
            place.height
        } else {
            place.lateral
        };
        rest + place.displacement(&self.state.u, c)
            + self.p.coefficients.stiffness * place.displacement(&self.state.delta, c)
    }

    pub(super) fn count(&mut self, stats: &LcpStats) {
        let r = &mut self.record;
        r.pivots += stats.pivots;
        r.pivots_max = r.pivots_max.max(stats.pivots);
        if r.pivot_counts.len() <= stats.pivots {
            r.pivot_counts.resize(stats.pivots + 1, 0);
        }
        r.pivot_counts[stats.pivots] += 1;
        r.fallbacks += usize::from(stats.fallback_used);
        r.lcp_residual = r.lcp_residual.max(stats.residual);
        let slack = self.unilateral.links.iter();
        let slack = slack
            .filter(|&&i| self.unilateral.correction[i] > 0.0)
            .count();
        r.slack_max = r.slack_max.max(slack);
    }

    /// Tension of a link at the time of balance.
    #[inline(always)]
    fn tension(&self, i: usize) -> f64 {
        if self.unilateral.correction[i] > 0.0 {
            return 0.0;
        }
        self.state.links.tension[i]
    }

    /// Uplift of a node at the time of balance.
    fn node_uplift(&self, node: usize) -> f64 {
        let keep = self.p.coefficients.stiffness;
        let moved = self.state.u[node][DIM - 1] + keep * self.state.delta[node][DIM - 1];
        moved + self.node_raised(node)
    }

    /// Update the extremes of some links.
    pub(super) fn watch_links(&mut self, which: std::ops::Range<usize>) {
        widest(Extremes {
            tension: &self.state.links.tension[which.clone()],
            correction: &self.unilateral.correction[which.clone()],
            min: &mut self.record.link_min[which.clone()],
            max: &mut self.record.link_max[which],
        });
    }

    /// Update the extremes of the watched nodes of an island.
    pub(super) fn watch_nodes(&mut self, island: usize) {
        for k in &self.watched[island] {
            let uplift = self.node_uplift(self.plan.nodes[*k]);
            self.record.uplift_max[*k] = self.record.uplift_max[*k].max(uplift);
        }
    }

    /// Record the instant of balance and update the extremes.
    pub(super) fn watch(&mut self, step: usize, speed: f64, position: f64) {
        let time = (step as f64 + 1.0 - self.p.coefficients.old) * self.p.h;
        for k in 0..self.state.awake.len() {
            let number = self.state.awake[k];
            self.watch_links(self.p.islands[number].links.clone());
            self.watch_nodes(number);
        }
        for (largest, rider) in self.record.stop_max.iter_mut().zip(&self.riders) {
            *largest = largest.max(rider.stop_force());
        }
        for rider in &mut self.riders {
            rider.watch_laws(&self.p.coefficients);
        }
        if step.is_multiple_of(self.plan.contact_every) {
            self.record_contacts(time, speed, position);
        }
        if step.is_multiple_of(self.plan.line_every) {
            self.record_line(time, position);
        }
    }

    fn record_contacts(&mut self, time: f64, speed: f64, position: f64) {
        let keep = self.p.coefficients.stiffness;
        self.record.time.push(time);
        self.record.speed.push(speed);
        for (i, contact) in self.contacts.all.iter().enumerate() {
            let (mut height, mut lateral) = (f64::NAN, f64::NAN);
            if contact.has_wire {
                height = self.wire_at(contact, DIM - 1) + self.raised_at(contact, keep);
                lateral = if DIM < 3 {
                    0.0
                } else {
                    self.wire_at(contact, 1)
                };
            }
            let r = &mut self.record;
            r.force.push(self.unilateral.force[i]);
            r.gap.push(self.unilateral.gap[i]);
            r.height.push(height);
            r.lateral.push(lateral);
        }
        for (j, rider) in self.riders.iter().enumerate() {
            let r = &mut self.record;
            r.position.push(position - self.travel.distances[j]);
            r.control.push(rider.actuator.force);
            for ((u, d), start) in rider.u.iter().zip(&rider.delta).zip(&self.start_u[j]) {
                r.masses.push(u + keep * d - start);
            }
        }
    }

    fn record_line(&mut self, time: f64, position: f64) {
        self.record.line_time.push(time);
        let plan = self.plan;
        match &plan.near {
            Some(near) => self.record_near(near, near.from(position, self.travel)),
            None => self.record_all(),
        }
        let keep = self.p.coefficients.stiffness;
        for place in &self.points {
            let moved = |c: usize| {
                place.displacement(&self.state.u, c)
                    + keep * place.displacement(&self.state.delta, c)
            };
            let raised = self.place_raised(place);
            self.record.point_uplift.push(moved(DIM - 1) + raised);
            self.record.point_along.push(moved(0));
        }
        let slack = self
            .unilateral
            .correction
            .iter()
            .filter(|r| **r > 0.0)
            .count();
        self.record.slack.push(slack as f64);
    }

    /// Links and nodes near the riders, in a row that begins at a coordinate.
    fn record_near(&mut self, near: &Near, from: f64) {
        if self.plan.links {
            let first = near.links.first(from);
            self.record.link_first.push(first as f64);
            for &i in near.links.row(first) {
                let tension = self.tension(i);
                self.record.link_force.push(tension);
            }
        }
        let first = near.nodes.first(from);
        self.record.uplift_first.push(first as f64);
        for &node in near.nodes.row(first) {
            let uplift = self.node_uplift(node);
            self.record.uplift.push(uplift);
        }
    }

    fn record_all(&mut self) {
        if self.plan.links {
            for i in 0..self.p.line.links.len() {
                let tension = self.tension(i);
                self.record.link_force.push(tension);
            }
        }
        for &node in &self.plan.nodes {
            let uplift = self.node_uplift(node);
            self.record.uplift.push(uplift);
        }
    }
}

/// Extremes of the tensions of links, which slack ones do not have.
struct Extremes<'a> {
    tension: &'a [f64],
    correction: &'a [f64],
    min: &'a mut [f64],
    max: &'a mut [f64],
}

impl Kernel for Extremes<'_> {
    #[inline(always)]
    fn run(self) {
        let both = self.tension.iter().zip(self.correction);
        let extremes = self.min.iter_mut().zip(self.max);
        for ((tension, correction), (min, max)) in both.zip(extremes) {
            let tension = if *correction > 0.0 { 0.0 } else { *tension };
            *min = if tension < *min { tension } else { *min };
            *max = if tension > *max { tension } else { *max };
        }
    }
}
