//! Influence on one another of contacts and links, read from the columns A⁻¹c.

use crate::constraint::contacts::Contact;
use crate::integrator::prepared::WireModel;
use crate::linear::model::LinearModel;
use crate::pantograph::system::inner;
use crate::slideline::point::{Nodal, SlidelinePoint, slots};
use crate::slideline::residual_flexibility::LocalCompliance;

/// Share of what a contact and its rider yield in a step that a negative R takes at most, so that the matrix of a step
/// stays positive definite: R of chains is some −0.3 µm/N, and a contact of 50 kN/m has 20 µm/N.
const LEAST: f64 = 0.5;

impl<const DIM: usize, const D: usize> WireModel<DIM, D> {
    /// Field of a unit contact force, read at a node.
    #[inline(always)]
    fn contact_field(&self, source: &Contact<DIM>, node: usize) -> [f64; D] {
        let mut field = [0.0; D];
        let mut add = |column: usize, weight: f64| {
            let value = self.columns.at(column, node);
            for c in 0..D {
                field[c] += weight * value[c];
            }
        };
        for (column, weight) in source.place.columns::<D>().zip(&source.place.weights) {
            add(column, *weight);
        }
        for (link, rise) in source.yields.pulls() {
            add(self.link_column(link), self.eased(link, rise));
        }
        field
    }

    /// R_d k, no number: what a unit contact force takes from the tension of a link.
    #[inline(always)]
    pub(crate) fn eased(&self, link: usize, rise: f64) -> f64 {
        rise * self.line.links[link].stiffness
    }

    /// What the contact itself and its rider yield in a step, m/N.
    fn given_way(&self, contact: &Contact<DIM>) -> f64 {
        let by_rider = inner(&contact.vector, &contact.column);
        self.contact_flexibility + self.coefficients.stiffness * by_rider
    }

    /// R between two contacts, m/N.
    pub(crate) fn missing(&self, a: &Contact<DIM>, b: &Contact<DIM>) -> f64 {
        if a.of == b.of {
            a.yields.own.max(-LEAST * self.given_way(a))
        } else if a.of[2] == b.of[2] {
            self.lanes[a.of[2]].between(&a.place, &b.place)
        } else {
            0.0
        }
    }

    /// What links take of R between two places: Σ R_d k R_d, m/N.
    pub(crate) fn carried(&self, a: &LocalCompliance, b: &LocalCompliance) -> f64 {
        let by_link = a.pulls().map(|(l, rise)| self.eased(l, rise) * b.of(l));
        by_link.sum()
    }

    /// R̃ between two contacts, m/N: see [`yields`](crate::slideline::residual_flexibility).
    pub(crate) fn residual(&self, a: &Contact<DIM>, b: &Contact<DIM>) -> f64 {
        self.missing(a, b) - self.carried(&a.yields, &b.yields)
    }

    /// sᵀx at a place: height of the wire in a displacement field, but for contact forces and
    /// corrections.
    #[inline(always)]
    pub(crate) fn felt(
        &self,
        place: &SlidelinePoint<DIM>,
        yields: &LocalCompliance,
        x: &(impl Nodal<D> + ?Sized),
    ) -> f64 {
        let mut height = place.displacement(x, DIM - 1);
        for (link, rise) in yields.pulls() {
            height += self.eased(link, rise) * self.line.links[link].elongation(x);
        }
        height
    }

    /// What a unit force at `source` raises the wire at `target` by, but for R̃.
    pub(crate) fn contact_on_contact(&self, source: &Contact<DIM>, target: &Contact<DIM>) -> f64 {
        let slots = slots::<DIM, D>();
        let mut sum = 0.0;
        for side in 0..target.place.count {
            let field = self.contact_field(source, target.place.nodes[side]);
            let weights = &target.place.weights;
            let share = |slot: usize| weights[slots * side + slot] * field[slot * DIM + DIM - 1];
            sum += (0..slots).map(share).sum::<f64>();
        }
        for (link, rise) in target.yields.pulls() {
            sum += self.eased(link, rise) * self.contact_on_link(source, link);
        }
        sum
    }

    /// Elongation of a link for a unit force at `source`, of the mesh.
    pub(crate) fn contact_on_link(&self, source: &Contact<DIM>, link: usize) -> f64 {
        let line: &LinearModel<DIM, D> = &self.line;
        let l = &line.links[link];
        let upper = self.contact_field(source, l.nodes[0]);
        let lower = self.contact_field(source, l.nodes[1]);
        (0..DIM)
            .map(|c| l.direction[c] * (lower[c] - upper[c]))
            .sum()
    }

    /// Elongation of link `target` for a unit pull of link `source`.
    pub(crate) fn link_on_link(&self, source: usize, target: usize) -> f64 {
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
