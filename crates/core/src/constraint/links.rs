//! Motion of the links of a line during a run.
//!
//! Tension at the time of balance, of a link taken as linear, with κ = a k + (a γ / β h) c:
//!
//!   T = T₀ + k e_f + c ė_f = [T₀ + k e + c (velocity terms of the old state)] + κ Δe

use crate::constraint::link_table::LinkTable;
use crate::linalg::{Kernel, widest};
use crate::linear::link::LinearLink;
use crate::scheme::Coefficients;
use std::ops::Range;

/// Number of links tested together in the search for candidates.
const GROUP: usize = 8;

/// Elongations and tensions of all links.
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
    /// Tension at the time of balance without the contact forces and corrections of the step, N.
    pub tension_free: Vec<f64>,
    /// Part of the tension that does not depend on the increment, N.
    old_tension: Vec<f64>,
    /// Reductions of the tension of links by forces prescribed for the step: number of the link, N.
    pub(crate) known_reductions: Vec<(usize, f64)>,
}

impl LinkMotion {
    /// Returns links at rest in a displaced position.
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
            old_tension: zero,
            known_reductions: Vec::new(),
        }
    }

    /// Sets the current position as the reference of elongations, along the current directions.
    pub fn reset_reference<const DIM: usize, const D: usize>(
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

    /// Puts links back to rest.
    pub(crate) fn reset(&mut self, which: Range<usize>) {
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

    /// Returns elongation, rate and second rate, link by link.
    pub(crate) fn archived_values(&mut self) -> impl Iterator<Item = &mut f64> {
        let rates = self.rate.iter_mut().zip(&mut self.second);
        let all = self.elongation.iter_mut().zip(rates);
        all.flat_map(|(elongation, (rate, second))| [elongation, rate, second])
    }

    /// Computes increments and tensions of links from the predicted increments of their nodes, m.
    pub(crate) fn predict<const DIM: usize, const D: usize>(
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
        widest(PredictTensions {
            motion: self,
            which: which.clone(),
            table,
            c,
        });
        for k in 0..self.known_reductions.len() {
            let (link, reduction) = self.known_reductions[k];
            if which.contains(&link) {
                self.subtract_tension(link, reduction);
                self.update_tension(link, table);
                self.tension_free[link] = self.tension[link];
            }
        }
    }

    /// Subtracts from the tension of a link the reduction (N) by a force on the wire near it.
    #[inline(always)]
    pub(crate) fn subtract_tension(&mut self, link: usize, reduction: f64) {
        self.old_tension[link] -= reduction;
    }

    /// Updates the tension from the increment.
    #[inline(always)]
    fn update_tension(&mut self, link: usize, table: &LinkTable) {
        self.tension[link] = self.old_tension[link] + table.step_stiffness[link] * self.delta[link];
    }

    /// Updates increments and tensions of links near the given nodes.
    pub(crate) fn update_increments<const DIM: usize, const D: usize>(
        &mut self,
        nodes: Range<usize>,
        (links, table): (&[LinearLink<DIM>], &LinkTable),
        delta: &[[f64; D]],
    ) {
        for link in table.near_nodes(nodes) {
            self.delta[link] = links[link].elongation(delta);
            self.update_tension(link, table);
        }
    }

    /// Moves links to the end of the step.
    pub(crate) fn commit(&mut self, which: Range<usize>, c: &Coefficients) {
        widest(CommitLinks {
            motion: self,
            which,
            c,
        });
    }

    /// Visits the links that would push, or have a correction.
    #[inline]
    pub(crate) fn for_each_candidate(
        &self,
        which: Range<usize>,
        (table, correction): (&LinkTable, &[f64]),
        mut visit: impl FnMut(usize),
    ) {
        let lists =
            [&self.tension[..], &table.min_tension, correction].map(|list| part(list, &which));
        let is_candidate = |&i: &usize| {
            let [tension, min_tension, correction] = lists.map(|list| list[i]);
            tension < min_tension || correction > 0.0
        };
        let mut visit_group = |group: Range<usize>| {
            let candidates = group.filter(is_candidate);
            candidates.for_each(|i| visit(which.start + i));
        };
        let groups = lists.map(|list| list.as_chunks::<GROUP>().0);
        for k in 0..groups[0].len() {
            let [tension, min_tension, correction] = groups.map(|groups| &groups[k]);
            let mut any = false;
            for i in 0..GROUP {
                any |= (tension[i] < min_tension[i]) | (correction[i] > 0.0);
            }
            if any {
                visit_group(GROUP * k..GROUP * (k + 1));
            }
        }
        visit_group(GROUP * groups[0].len()..which.len());
    }
}

struct PredictTensions<'a> {
    motion: &'a mut LinkMotion,
    which: Range<usize>,
    table: &'a LinkTable,
    c: &'a Coefficients,
}

impl Kernel for PredictTensions<'_> {
    #[inline(always)]
    fn run(self) {
        let (which, table, c) = (self.which, self.table, self.c);
        let values = |list| part(list, &which);
        let LinkMotion {
            elongation,
            rate,
            second,
            delta,
            tension,
            tension_free,
            old_tension,
            ..
        } = self.motion;
        let [e, rate, second, delta] = [elongation, rate, second, delta].map(|list| values(list));
        let [rest, k] = [&table.rest_tension, &table.stiffness].map(|list| values(list));
        let [viscosity, kappa] = [&table.viscosity, &table.step_stiffness].map(|list| values(list));
        let old = &mut old_tension[which.clone()][..e.len()];
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

struct CommitLinks<'a> {
    motion: &'a mut LinkMotion,
    which: Range<usize>,
    c: &'a Coefficients,
}

impl Kernel for CommitLinks<'_> {
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

/// Returns part of a list, with a length that the compiler knows to be equal for all lists.
#[inline(always)]
fn part<'a>(list: &'a [f64], which: &Range<usize>) -> &'a [f64] {
    &list[which.clone()][..which.len()]
}
