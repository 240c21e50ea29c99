//! Influence on one another of contacts and links, read from the columns A⁻¹c.

use super::line::Line;
use super::place::{Place, slots};
use super::stepper::Prepared;

impl<const DIM: usize, const D: usize> Prepared<DIM, D> {
    /// Field of a unit contact force at `place`, read at a node.
    #[inline(always)]
    fn contact_field(&self, place: &Place<DIM>, node: usize) -> [f64; D] {
        let mut field = [0.0; D];
        for (column, weight) in place.columns::<D>().zip(&place.weights) {
            let value = self.columns.at(column, node);
            for c in 0..D {
                field[c] += weight * value[c];
            }
        }
        field
    }

    /// What a unit force at `source` raises the wire at `target` by.
    pub(super) fn contact_on_contact(&self, source: &Place<DIM>, target: &Place<DIM>) -> f64 {
        let slots = slots::<DIM, D>();
        let mut sum = 0.0;
        for side in 0..2 {
            let field = self.contact_field(source, target.nodes[side]);
            let share =
                |slot: usize| target.weights[slots * side + slot] * field[slot * DIM + DIM - 1];
            sum += (0..slots).map(share).sum::<f64>();
        }
        sum
    }

    /// Elongation of a link for a unit force at `source`.
    pub(super) fn contact_on_link(&self, source: &Place<DIM>, link: usize) -> f64 {
        let line: &Line<DIM, D> = &self.line;
        let l = &line.links[link];
        let upper = self.contact_field(source, l.nodes[0]);
        let lower = self.contact_field(source, l.nodes[1]);
        (0..DIM)
            .map(|c| l.direction[c] * (lower[c] - upper[c]))
            .sum()
    }

    /// Elongation of link `target` for a unit pull of link `source`.
    pub(super) fn link_on_link(&self, source: usize, target: usize) -> f64 {
        let l = &self.line.links[target];
        let column = self.link_column(source);
        let upper = self.columns.at(column, l.nodes[0]);
        let lower = self.columns.at(column, l.nodes[1]);
        (0..DIM)
            .map(|c| l.direction[c] * (lower[c] - upper[c]))
            .sum()
    }

    /// Number of the column A⁻¹g of a link, after the columns of the nodes of all lanes.
    #[inline(always)]
    #[must_use]
    pub fn link_column(&self, link: usize) -> usize {
        self.lane_columns + link
    }
}
