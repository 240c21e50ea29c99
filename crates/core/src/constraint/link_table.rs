//! Numbers of links side by side, for loops over all links of an island in every step.

use crate::linear::model::LinearLink;
use crate::scheme::Coefficients;
use std::ops::Range;

/// What stays the same of all links.
#[derive(Debug, Clone, Default)]
pub(crate) struct LinkTable {
    /// T₀, N.
    pub rest_tension: Vec<f64>,
    /// k, N/m.
    pub stiffness: Vec<f64>,
    /// c, N·s/m.
    pub viscosity: Vec<f64>,
    /// κ = a k + (a γ/β h) c, N/m.
    pub of_increment: Vec<f64>,
    /// Tension below which a link would push, N: zero, or beyond all numbers.
    pub least: Vec<f64>,
    /// Corrections that act at rest: number, N.
    pub corrected: Vec<(usize, f64)>,
    /// Their first nodes with their numbers, by nodes; and how far their other nodes are at most.
    first: Vec<(usize, usize)>,
    span: usize,
}

impl LinkTable {
    pub fn new<const DIM: usize>(links: &[LinearLink<DIM>], c: &Coefficients) -> Self {
        let of = |number: fn(&LinearLink<DIM>) -> f64| links.iter().map(number).collect();
        let ends = |link: &LinearLink<DIM>| {
            let [a, b] = link.nodes;
            (a.min(b), a.max(b))
        };
        let mut first: Vec<_> = links.iter().map(|l| ends(l).0).zip(0..).collect();
        first.sort_unstable();
        let corrections = links.iter().map(LinearLink::rest_correction).enumerate();
        Self {
            rest_tension: of(|l| l.rest_tension),
            stiffness: of(|l| l.stiffness),
            viscosity: of(|l| l.viscosity),
            of_increment: links
                .iter()
                .map(|l| c.stiffness * l.stiffness + c.damping * l.viscosity)
                .collect(),
            least: of(|l| if l.unilateral { 0.0 } else { f64::NEG_INFINITY }),
            corrected: corrections.filter(|(_, force)| *force > 0.0).collect(),
            first,
            span: links
                .iter()
                .map(|l| ends(l).1 - ends(l).0)
                .max()
                .unwrap_or(0),
        }
    }

    /// Links of which a node lies in a range, and some that lie around it.
    pub fn around(&self, nodes: Range<usize>) -> impl Iterator<Item = usize> {
        let from = nodes.start.saturating_sub(self.span);
        let begin = self.first.partition_point(|(node, _)| *node < from);
        let end = self.first.partition_point(|(node, _)| *node < nodes.end);
        self.first[begin..end.max(begin)]
            .iter()
            .map(|(_, link)| *link)
    }
}
