//! Properties of links, list by list, for loops over all links of an island in every step.

use crate::linear::link::LinearLink;
use crate::scheme::Coefficients;
use std::ops::Range;

/// Constant properties of all links, one list for each.
#[derive(Debug, Clone, Default)]
pub(crate) struct LinkTable {
    /// Tension T₀ at equilibrium, N.
    pub rest_tension: Vec<f64>,
    /// Stiffness k, N/m.
    pub stiffness: Vec<f64>,
    /// Damping c, N·s/m.
    pub viscosity: Vec<f64>,
    /// Step stiffness κ = a k + (a γ/β h) c, N/m.
    pub step_stiffness: Vec<f64>,
    /// Tension below which a link would push, N: zero, or −∞ for links that may push.
    pub min_tension: Vec<f64>,
    /// Corrections r₀ at rest that are not zero: number of the link, N.
    pub rest_corrections: Vec<(usize, f64)>,
    /// Smaller node and number of each link, sorted; `span` is the largest difference of the nodes
    /// of a link.
    first_nodes: Vec<(usize, usize)>,
    span: usize,
}

impl LinkTable {
    pub fn new<const DIM: usize>(links: &[LinearLink<DIM>], c: &Coefficients) -> Self {
        let column = |property: fn(&LinearLink<DIM>) -> f64| links.iter().map(property).collect();
        let ends = |link: &LinearLink<DIM>| {
            let [a, b] = link.nodes;
            (a.min(b), a.max(b))
        };
        let mut first_nodes: Vec<_> = links.iter().map(|l| ends(l).0).zip(0..).collect();
        first_nodes.sort_unstable();
        let corrections = links.iter().map(LinearLink::rest_correction).enumerate();
        Self {
            rest_tension: column(|l| l.rest_tension),
            stiffness: column(|l| l.stiffness),
            viscosity: column(|l| l.viscosity),
            step_stiffness: links
                .iter()
                .map(|l| c.stiffness * l.stiffness + c.damping * l.viscosity)
                .collect(),
            min_tension: column(|l| if l.unilateral { 0.0 } else { f64::NEG_INFINITY }),
            rest_corrections: corrections.filter(|(_, force)| *force > 0.0).collect(),
            first_nodes,
            span: links
                .iter()
                .map(|l| ends(l).1 - ends(l).0)
                .max()
                .unwrap_or(0),
        }
    }

    /// Returns the links that have a node in a range, and some others nearby.
    pub fn near_nodes(&self, nodes: Range<usize>) -> impl Iterator<Item = usize> {
        let from = nodes.start.saturating_sub(self.span);
        let begin = self.first_nodes.partition_point(|(node, _)| *node < from);
        let end = self
            .first_nodes
            .partition_point(|(node, _)| *node < nodes.end);
        self.first_nodes[begin..end.max(begin)]
            .iter()
            .map(|(_, link)| *link)
    }
}
