//! Motion of the links of a line during a run.
//!
//! Tension at the time of balance, as if the link were linear, with κ = a k + (a γ / β h) c:
//!
//!   T = T₀ + k e_f + c ė_f = [T₀ + k e + c (velocity terms of the old state)] + κ Δe

use crate::constraint::link_table::LinkTable;
use crate::linalg::{Kernel, widest};
use crate::linear::model::LinearLink;
use crate::scheme::Coefficients;
use std::ops::Range;

/// Links looked at together when all are searched for a few.
const LOOK: usize = 8;

/// Elongations of all links, and the tensions that follow from them.
#[derive(Debug, Clone)]
pub struct LinkMotion {
    /// Elongation since the static shape in m, its rate, and its second rate.
    pub elongation: Vec<f64>,
    pub(crate) rate: Vec<f64>,
    pub(crate) second: Vec<f64>,
    /// Elongation increment of the current step, m.
    pub delta: Vec<f64>,
    /// Tension at the time of balance without correction, N; negative where the link would push.
    pub tension: Vec<f64>,
    /// The same without the contact forces and corrections of the current step.
    pub tension_free: Vec<f64>,
    /// Part of the tension that does not depend on the increment, N.
    old_part: Vec<f64>,
    /// What forces that are given for the step take from the tension of links: number, N.
    pub(crate) given: Vec<(usize, f64)>,
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
            elongation: links.iter().map(|l| l.elongation(u)).collect(),
            rate: zero.clone(),
            second: zero.clone(),
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
        for (i, link) in links.iter().enumerate() {
            self.elongation[i] = 0.0;
            (self.rate[i], self.second[i]) = (link.elongation(v), link.elongation(a));
        }
    }

    /// Put some links back to rest.
    pub(crate) fn lay(&mut self, which: Range<usize>) {
        let Self {
            elongation,
            rate,
            second,
            delta,
            ..
        } = self;
        for list in [elongation, rate, second, delta] {
            list[which.clone()].fill(0.0);
        }
    }

    /// Elongation, rate and second rate, link by link.
    pub(crate) fn numbers(&mut self) -> impl Iterator<Item = &mut f64> {
        let rates = self.rate.iter_mut().zip(&mut self.second);
        let all = self.elongation.iter_mut().zip(rates);
        all.flat_map(|(elongation, (rate, second))| [elongation, rate, second])
    }

    /// Begin a step with some links, with increments of their nodes but for contact forces and corrections.
    pub(crate) fn begin<const DIM: usize, const D: usize>(
        &mut self,
        which: Range<usize>,
        (links, table): (&[LinearLink<DIM>], &LinkTable),
        c: &Coefficients,
        delta: &[[f64; D]],
    ) {
        for (d, link) in self.delta[which.clone()]
            .iter_mut()
            .zip(&links[which.clone()])
        {
            *d = link.elongation(delta);
        }
        widest(Begin {
            motion: self,
            which: which.clone(),
            table,
            c,
        });
        for k in 0..self.given.len() {
            let (link, by) = self.given[k];
            if which.contains(&link) {
                self.ease(link, by);
                self.pull(link, table);
                self.tension_free[link] = self.tension[link];
            }
        }
    }

    /// Take from the tension of a link what a force on the wire beside it takes.
    #[inline(always)]
    pub(crate) fn ease(&mut self, link: usize, by: f64) {
        self.old_part[link] -= by;
    }

    /// Find the tension from the increment.
    #[inline(always)]
    fn pull(&mut self, link: usize, table: &LinkTable) {
        self.tension[link] = self.old_part[link] + table.of_increment[link] * self.delta[link];
    }

    /// Set the increments of links near some nodes anew, from those of the nodes.
    pub(crate) fn follow<const DIM: usize, const D: usize>(
        &mut self,
        nodes: Range<usize>,
        (links, table): (&[LinearLink<DIM>], &LinkTable),
        delta: &[[f64; D]],
    ) {
        for link in table.around(nodes) {
            self.delta[link] = links[link].elongation(delta);
            self.pull(link, table);
        }
    }

    /// Take the step with some links.
    pub(crate) fn advance(&mut self, which: Range<usize>, c: &Coefficients) {
        widest(Advance {
            motion: self,
            which,
            c,
        });
    }

    /// Find those of some links that would push, or have a correction.
    #[inline]
    pub(crate) fn unusual(
        &self,
        which: Range<usize>,
        (table, correction): (&LinkTable, &[f64]),
        mut found: impl FnMut(usize),
    ) {
        let lists = [&self.tension[..], &table.least, correction].map(|list| part(list, &which));
        let is_one = |&i: &usize| {
            let [tension, least, correction] = lists.map(|list| list[i]);
            tension < least || correction > 0.0
        };
        let mut look = |group: Range<usize>| {
            let them = group.filter(is_one);
            them.for_each(|i| found(which.start + i));
        };
        let groups = lists.map(|list| list.as_chunks::<LOOK>().0);
        for k in 0..groups[0].len() {
            let [tension, least, correction] = groups.map(|groups| &groups[k]);
            let mut any = false;
            for i in 0..LOOK {
                any |= (tension[i] < least[i]) | (correction[i] > 0.0);
            }
            if any {
                look(LOOK * k..LOOK * (k + 1));
            }
        }
        look(LOOK * groups[0].len()..which.len());
    }
}

struct Begin<'a> {
    motion: &'a mut LinkMotion,
    which: Range<usize>,
    table: &'a LinkTable,
    c: &'a Coefficients,
}

impl Kernel for Begin<'_> {
    #[inline(always)]
    fn run(self) {
        let (which, table, c) = (self.which, self.table, self.c);
        let of = |list| part(list, &which);
        let LinkMotion {
            elongation,
            rate,
            second,
            delta,
            tension,
            tension_free,
            old_part,
            ..
        } = self.motion;
        let [e, rate, second, delta] = [elongation, rate, second, delta].map(|list| of(list));
        let [rest, k] = [&table.rest_tension, &table.stiffness].map(|list| of(list));
        let [viscosity, kappa] = [&table.viscosity, &table.of_increment].map(|list| of(list));
        let old = &mut old_part[which.clone()][..e.len()];
        let tension = &mut tension[which.clone()][..e.len()];
        let free = &mut tension_free[which.clone()][..e.len()];
        for i in 0..e.len() {
            let rate = c.velocity_from_v * rate[i] + c.velocity_from_a * second[i];
            old[i] = rest[i] + k[i] * e[i] + viscosity[i] * rate;
            tension[i] = old[i] + kappa[i] * delta[i];
            free[i] = tension[i];
        }
    }
}

struct Advance<'a> {
    motion: &'a mut LinkMotion,
    which: Range<usize>,
    c: &'a Coefficients,
}

impl Kernel for Advance<'_> {
    #[inline(always)]
    fn run(self) {
        let (which, c) = (self.which, self.c);
        let delta = part(&self.motion.delta, &which);
        let e = &mut self.motion.elongation[which.clone()][..delta.len()];
        let rate = &mut self.motion.rate[which.clone()][..delta.len()];
        let second = &mut self.motion.second[which.clone()][..delta.len()];
        for i in 0..delta.len() {
            e[i] += delta[i];
            (rate[i], second[i]) = c.advance(delta[i], rate[i], second[i]);
        }
    }
}

/// Part of a list, of a length that the compiler sees to be the same for all lists.
#[inline(always)]
fn part<'a>(list: &'a [f64], which: &Range<usize>) -> &'a [f64] {
    &list[which.clone()][..which.len()]
}
