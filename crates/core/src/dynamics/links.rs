//! Motion of the links of a line during a run.
//!
//! Tension at the time of balance, as if the link were linear, with κ = a k + (a γ / β h) c:
//!
//!   T = T₀ + k e_f + c ė_f = [T₀ + k e + c (velocity terms of the old state)] + κ Δe

use super::line::LinearLink;
use crate::scheme::Coefficients;
use std::ops::Range;

/// Elongations of all links, and the tensions that follow from them.
#[derive(Debug, Clone)]
pub struct LinkMotion {
    /// Elongation since the static shape in m, its rate and second rate.
    pub elongation: Vec<[f64; 3]>,
    /// Elongation increment of the current step, m.
    pub delta: Vec<f64>,
    /// Tension at the time of balance without correction, N; negative where the link would push.
    pub tension: Vec<f64>,
    /// The same without the contact forces and corrections of the current step.
    pub tension_free: Vec<f64>,
    /// Part of the tension that does not depend on the increment, N.
    old_part: Vec<f64>,
    /// What forces that are given for the step take from the tension of links: number, N.
    pub(super) given: Vec<(usize, f64)>,
}

impl LinkMotion {
    /// Links at rest in a displaced position.
    #[must_use]
    pub fn at_rest<const DIM: usize, const D: usize>(
        links: &[LinearLink<DIM>],
        u: &[[f64; D]],
    ) -> Self {
        let zero = vec![0.0; links.len()];
        Self {
            elongation: links.iter().map(|l| [l.elongation(u), 0.0, 0.0]).collect(),
            delta: zero.clone(),
            tension: zero.clone(),
            tension_free: zero.clone(),
            old_part: zero,
            given: Vec::new(),
        }
    }

    /// Measure elongations anew from the present position, along the present directions.
    pub fn restart<const DIM: usize, const D: usize>(
        &mut self,
        links: &[LinearLink<DIM>],
        v: &[[f64; D]],
        a: &[[f64; D]],
    ) {
        for (elongation, link) in self.elongation.iter_mut().zip(links) {
            *elongation = [0.0, link.elongation(v), link.elongation(a)];
        }
    }

    /// Put some links back to rest.
    pub(super) fn lay(&mut self, which: Range<usize>) {
        self.elongation[which.clone()].fill([0.0; 3]);
        self.delta[which].fill(0.0);
    }

    /// Prepare the next step of some links from their present elongations.
    pub fn begin<const DIM: usize>(
        &mut self,
        which: Range<usize>,
        links: &[LinearLink<DIM>],
        c: &Coefficients,
    ) {
        let old = self.old_part[which.clone()].iter_mut();
        let old = old.zip(&self.elongation[which.clone()]);
        for ((old, [e, rate, second]), l) in old.zip(&links[which.clone()]) {
            let rate = c.velocity_from_v * rate + c.velocity_from_a * second;
            *old = l.rest_tension + l.stiffness * e + l.viscosity * rate;
        }
        for (link, by) in self.given.iter().filter(|(link, _)| which.contains(link)) {
            self.old_part[*link] -= by;
        }
    }

    /// Take from the tension of a link what a force on the wire beside it takes.
    #[inline(always)]
    pub(super) fn ease(&mut self, link: usize, by: f64) {
        self.old_part[link] -= by;
    }

    /// Set the increment of those of some links that lie among the given nodes from a displacement
    /// increment; `stiffness` is κ of each link.
    pub fn follow<const DIM: usize, const D: usize>(
        &mut self,
        which: Range<usize>,
        links: &[LinearLink<DIM>],
        stiffness: &[f64],
        delta: &[[f64; D]],
        among: &Range<usize>,
    ) {
        for i in which {
            let link = &links[i];
            if among.contains(&link.nodes[0]) || among.contains(&link.nodes[1]) {
                let d = link.elongation(delta);
                self.delta[i] = d;
                self.tension[i] = self.old_part[i] + stiffness[i] * d;
            }
        }
    }

    /// Take the step with some links.
    pub fn advance(&mut self, which: Range<usize>, c: &Coefficients) {
        let increments = &self.delta[which.clone()];
        for ([e, rate, second], &d) in self.elongation[which].iter_mut().zip(increments) {
            let (new_rate, new_second) = c.advance(d, *rate, *second);
            *e += d;
            *rate = new_rate;
            *second = new_second;
        }
    }
}
