//! Compliance of the line in the coming step of a session with given forces: with it a program
//! outside solves contact itself, as stiffly as it is solved inside.
//!
//! At the time of balance of a step the wire at the collectors is at
//!
//!   z_f = z₀ + W λ
//!
//! for contact forces λ that are constant in the step. Without slack links W is a times
//! CᵀA⁻¹C + R̃/a of the [problem](crate::constraint::problem) of a step, a = 1 − α_f. Links S that
//! are slack stay without tension, which makes the wire softer: from the rows T/κ = 0 of the
//! problem,
//!
//!   W = a (H_cc − H_cS H_SS⁻¹ H_Sc)
//!
//! z₀ and S are those of the step under given forces, at first those of the step before. So z_f is
//! exact as long as no link slackens or tightens because λ differs from these; a program that asks
//! again about the λ that it has found solves contact exactly once they stay. W leaves out friction
//! along the wire, which z₀ has from the same forces. It is symmetric, unless a slack link is
//! damped.

mod coming_step;

use crate::constraint::contacts::Contact;
use crate::slideline::point::SlidelinePoint;

/// Wire at the collectors at the time of balance of the coming step.
#[derive(Debug, Clone, Default)]
pub struct Compliance {
    /// Height at each collector if none pressed in the step, m.
    pub free_height: Vec<f64>,
    /// Height per force, m/N: one row for each collector whose height it is.
    pub matrix: Vec<f64>,
}

/// Compliance of the coming step and the workspace in which it is found.
#[derive(Debug, Default)]
pub(crate) struct ComplianceWork<const DIM: usize> {
    result: Compliance,
    /// Contacts at the collectors, at the time of balance.
    contacts: Vec<Contact<DIM>>,
    /// Forces about which the coming step is linear, N.
    about: Vec<f64>,
    /// Data of the step before, which are kept: forces (N), corrections (N), points.
    forces: Vec<f64>,
    correction: Vec<f64>,
    points: Vec<SlidelinePoint<DIM>>,
    /// Matrix H_SS, of which each solution takes a copy, and column of H_Sc.
    slack_matrix: Vec<f64>,
    copy: Vec<f64>,
    column: Vec<f64>,
}

impl<const DIM: usize> ComplianceWork<DIM> {
    /// Reserves memory for so many collectors and links, and for `rows` slack links.
    pub(crate) fn reserve(&mut self, collectors: usize, links: usize, rows: usize) {
        let result = &mut self.result;
        result.free_height.resize(collectors, 0.0);
        result.matrix.resize(collectors * collectors, 0.0);
        let contact = |number| Contact::at_point(number, SlidelinePoint::default());
        self.contacts = (0..collectors).map(contact).collect();
        self.about.resize(collectors, 0.0);
        self.forces.resize(collectors, 0.0);
        self.correction.resize(links, 0.0);
        self.points.resize(collectors, SlidelinePoint::default());
        self.slack_matrix.reserve(rows * rows);
        self.copy.reserve(rows * rows);
        self.column.reserve(rows);
    }
}
