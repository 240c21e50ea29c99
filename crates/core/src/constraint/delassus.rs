//! Delassus operator J A⁻¹Jᵀ of contacts and links, from the compliance columns A⁻¹c.

use crate::constraint::contacts::Contact;
use crate::constraint::wires::Wires;
use crate::linalg::small::inner;
use crate::linear::model::LinearModel;
use crate::slideline::local_compliance::LocalCompliance;
use crate::slideline::point::{Nodal, SlidelinePoint, slots};

/// Largest share of the compliance of contact and strip in a step that a negative R may take, so
/// that the matrix of a step stays positive definite: R of chains is some −0.3 µm/N, and a contact
/// of 50 kN/m has 20 µm/N.
const MAX_NEGATIVE_SHARE: f64 = 0.5;

impl<const DIM: usize, const D: usize> Wires<DIM, D> {
    /// Returns the displacement of a node under a unit contact force at `source`, m/N.
    #[inline(always)]
    fn contact_field(&self, source: &Contact<DIM>, node: usize) -> [f64; D] {
        let mut field = [0.0; D];
        let mut add = |column: usize, weight: f64| {
            let value = self.columns.at(column, node);
            for c in 0..D {
                field[c] += weight * value[c];
            }
        };
        for (column, weight) in source.point.columns::<D>().zip(&source.point.weights) {
            add(column, *weight);
        }
        for (link, rise) in source.compliance.links() {
            add(self.link_column(link), self.tension_relief(link, rise));
        }
        field
    }

    /// Returns R_d k, no unit: reduction of the tension of a link by a unit contact force.
    #[inline(always)]
    pub(crate) fn tension_relief(&self, link: usize, rise: f64) -> f64 {
        rise * self.line.links[link].stiffness
    }

    /// Returns the compliance of contact and strip in a step, m/N.
    fn strip_and_contact_compliance(&self, contact: &Contact<DIM>) -> f64 {
        let strip_compliance = inner(&contact.vector, &contact.column);
        self.contact_flexibility + self.coefficients.stiffness * strip_compliance
    }

    /// Returns the residual flexibility R between two contacts, m/N.
    pub(crate) fn residual_flexibility(&self, a: &Contact<DIM>, b: &Contact<DIM>) -> f64 {
        if a.indices == b.indices {
            a.compliance
                .flexibility
                .max(-MAX_NEGATIVE_SHARE * self.strip_and_contact_compliance(a))
        } else if a.indices[2] == b.indices[2] {
            self.slidelines[a.indices[2]].residual_flexibility(&a.point, &b.point)
        } else {
            0.0
        }
    }

    /// Returns the part of R between two points that acts through links, Σ R_d k R_d, m/N.
    pub(crate) fn flexibility_through_links(
        &self,
        a: &LocalCompliance,
        b: &LocalCompliance,
    ) -> f64 {
        let per_link = a
            .links()
            .map(|(link, rise)| self.tension_relief(link, rise) * b.of_link(link));
        per_link.sum()
    }

    /// Returns the residual compliance R̃ between two contacts, m/N: see
    /// [local compliance](crate::slideline::local_compliance).
    pub(crate) fn residual_compliance(&self, a: &Contact<DIM>, b: &Contact<DIM>) -> f64 {
        self.residual_flexibility(a, b)
            - self.flexibility_through_links(&a.compliance, &b.compliance)
    }

    /// Returns sᵀx at a point, m: vertical displacement of the wire in a field x, without the parts
    /// of contact forces and corrections.
    #[inline(always)]
    pub(crate) fn vertical_displacement(
        &self,
        point: &SlidelinePoint<DIM>,
        compliance: &LocalCompliance,
        x: &(impl Nodal<D> + ?Sized),
    ) -> f64 {
        let mut height = point.displacement(x, DIM - 1);
        for (link, rise) in compliance.links() {
            height += self.tension_relief(link, rise) * self.line.links[link].elongation(x);
        }
        height
    }

    /// Returns the vertical displacement of the wire at `target` under a unit force at `source`,
    /// m/N, without R̃.
    pub(crate) fn contact_on_contact(&self, source: &Contact<DIM>, target: &Contact<DIM>) -> f64 {
        let slots = slots::<DIM, D>();
        let mut sum = 0.0;
        for side in 0..target.point.count {
            let field = self.contact_field(source, target.point.nodes[side]);
            let weights = &target.point.weights;
            let share = |slot: usize| weights[slots * side + slot] * field[slot * DIM + DIM - 1];
            sum += (0..slots).map(share).sum::<f64>();
        }
        for (link, rise) in target.compliance.links() {
            sum += self.tension_relief(link, rise) * self.contact_on_link(source, link);
        }
        sum
    }

    /// Returns the elongation of a link in the mesh under a unit force at `source`, m/N.
    pub(crate) fn contact_on_link(&self, source: &Contact<DIM>, link: usize) -> f64 {
        let line: &LinearModel<DIM, D> = &self.line;
        let linear = &line.links[link];
        let upper = self.contact_field(source, linear.nodes[0]);
        let lower = self.contact_field(source, linear.nodes[1]);
        (0..DIM)
            .map(|c| linear.direction[c] * (lower[c] - upper[c]))
            .sum()
    }

    /// Returns the elongation of link `target` under a unit tension of link `source`, m/N.
    pub(crate) fn link_on_link(&self, source: usize, target: usize) -> f64 {
        let linear = &self.line.links[target];
        let column = self.link_column(source);
        let upper = self.columns.at(column, linear.nodes[0]);
        let lower = self.columns.at(column, linear.nodes[1]);
        (0..DIM)
            .map(|c| linear.direction[c] * (lower[c] - upper[c]))
            .sum()
    }
}
