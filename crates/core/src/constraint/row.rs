//! Rows of the complementarity problem: contacts, links, and breakpoints of pantographs alike.
//!
//! Row i has a force xᵢ ≥ 0 and an opening yᵢ ≥ 0. Its Jacobian Jᵢ gives the opening of a motion of
//! wires and pantographs, and sᵢ Jᵢᵀ the forces of a unit of xᵢ on them:
//!
//! | row                  | x                   | y             | J         | s  | divisor |
//! | -------------------- | ------------------- | ------------- | --------- | -- | ------- |
//! | contact of a strip   | contact force λ     | gap d + λ/k_c | Cᵀ, −eᵀ   | +1 | a       |
//! | link (dropper)       | correction r        | tension T     | κ Gᵀ      | −1 | κ       |
//! | bump stop, hardening | its force σ         | s + σ/Δ       | dᵀ        | +1 | c       |
//! | softening breakpoint | the force σ missing | s + σ/Δ       | dᵀ        | −1 | c       |
//!
//! a = 1 − α_f, κ = a k + (a γ/β h) c of the link, Δ the change of slope, c = a or
//! a γ/β h for springs and dampers. A row
//! divided by its own number has the matrix H = J A⁻¹ (s J)ᵀ + compliance on the diagonal, the
//! Delassus operator of a step: see [`problem`](crate::constraint::problem) for why it has one
//! solution.

use crate::constraint::contacts::Contact;
use crate::constraint::wires::Wires;
use crate::linalg::small::inner;
use crate::pantograph::breakpoint::Breakpoint;

/// Number of a row's contact, link or breakpoint in the lists of a run.
#[derive(Debug, Clone, Copy)]
pub(crate) enum RowId {
    /// Among all contacts.
    Contact(usize),
    /// Among all links.
    Link(usize),
    /// Among the breakpoints of a pantograph.
    Breakpoint { pantograph: usize, number: usize },
}

/// Part of the wires that a row acts on.
#[derive(Debug, Clone, Copy)]
pub(crate) enum OnWires<'a, const DIM: usize> {
    /// A point of a slideline.
    Contact(&'a Contact<DIM>),
    /// Both ends of a link.
    Link(usize),
    /// Nothing.
    Nothing,
}

/// Coordinate of a pantograph that a row acts on.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OnPantograph<'a> {
    /// Number of the pantograph.
    pub number: usize,
    /// Vector e of a contact, d of a breakpoint.
    pub direction: &'a [f64],
    /// A⁻¹ times the direction.
    pub column: &'a [f64],
    /// True when the opening grows against the direction: a strip that rises closes its gap.
    pub is_strip: bool,
}

/// One row of the problem, divided by its own number.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Row<'a, const DIM: usize> {
    pub wires: OnWires<'a, DIM>,
    pub pantograph: Option<OnPantograph<'a>>,
    /// Sign s: −1 for forces that cancel forces of the linear model.
    pub sign: f64,
    /// Compliance of the row itself, opening per force beyond J A⁻¹ Jᵀ.
    pub compliance: f64,
    /// Opening without the forces of the problem.
    pub free: f64,
    /// Force of the step before, N: rows with a positive one start in the active set.
    pub force: f64,
}

impl<'a, const DIM: usize> Row<'a, DIM> {
    /// Returns the row of a contact with `gap_free`, its gap without contact forces, m.
    pub fn contact<const D: usize>(
        wires: &Wires<DIM, D>,
        contact: &'a Contact<DIM>,
        (gap_free, force): (f64, f64),
    ) -> Self {
        Self {
            wires: OnWires::Contact(contact),
            pantograph: Some(OnPantograph {
                number: contact.pantograph(),
                direction: &contact.vector,
                column: &contact.column,
                is_strip: true,
            }),
            sign: 1.0,
            compliance: wires.contact_compliance,
            free: gap_free / wires.coefficients.stiffness,
            force,
        }
    }

    /// Returns the row of a link with `tension_free`, its tension without the forces of the
    /// problem, N.
    pub fn link<const D: usize>(
        wires: &Wires<DIM, D>,
        link: usize,
        (tension_free, correction): (f64, f64),
    ) -> Self {
        let kappa = wires.table.step_stiffness[link];
        Self {
            wires: OnWires::Link(link),
            pantograph: None,
            sign: -1.0,
            compliance: 1.0 / kappa,
            free: tension_free / kappa,
            force: correction,
        }
    }

    /// Returns the row of a bump stop or breakpoint of a pantograph.
    pub fn breakpoint(pantograph: usize, breakpoint: &'a Breakpoint) -> Self {
        Self {
            wires: OnWires::Nothing,
            pantograph: Some(OnPantograph {
                number: pantograph,
                direction: &breakpoint.coordinate.direction,
                column: &breakpoint.column,
                is_strip: false,
            }),
            sign: breakpoint.sign,
            compliance: breakpoint.flexibility / breakpoint.factor,
            free: breakpoint.predicted_opening / breakpoint.factor,
            force: breakpoint.force,
        }
    }

    /// Returns the diagonal entry of H of this row.
    pub fn diagonal<const D: usize>(&self, wires: &Wires<DIM, D>) -> f64 {
        let by_wires = wires.response(self, self);
        match &self.pantograph {
            Some(on_pantograph) => {
                by_wires
                    + (inner(on_pantograph.direction, on_pantograph.column) * self.sign
                        + self.compliance)
            }
            None => by_wires + self.compliance,
        }
    }

    /// Returns the entries of H of this row and another one: opening of this row for a unit force
    /// of the other one, and the reverse.
    pub fn coupling<const D: usize>(&self, other: &Self, wires: &Wires<DIM, D>) -> [f64; 2] {
        let mut h = match (self.wires, other.wires) {
            // Computed once, as A is symmetric: it is the costly one.
            (OnWires::Link(link), OnWires::Contact(contact)) => wires.link_coupling(contact, link),
            _ => [wires.response(self, other), wires.response(other, self)],
        };
        if let (Some(a), Some(b)) = (&self.pantograph, &other.pantograph)
            && a.number == b.number
        {
            if a.is_strip == b.is_strip {
                h[0] += inner(a.direction, b.column) * other.sign;
                h[1] += inner(b.direction, a.column) * self.sign;
            } else {
                let strip_coupling = -inner(b.direction, a.column);
                h[0] += strip_coupling * other.sign;
                h[1] += strip_coupling * self.sign;
            }
        }
        h
    }
}

impl<const DIM: usize, const D: usize> Wires<DIM, D> {
    /// Returns the opening of row `a` through the wires for a unit force of row `b`.
    fn response(&self, a: &Row<'_, DIM>, b: &Row<'_, DIM>) -> f64 {
        match (a.wires, b.wires) {
            (OnWires::Contact(target), OnWires::Contact(source)) => {
                let residual_compliance =
                    self.residual_compliance(source, target) / self.coefficients.stiffness;
                self.contact_on_contact(source, target) + residual_compliance
            }
            (OnWires::Link(target), OnWires::Link(source)) => {
                b.sign * self.link_on_link(source, target)
            }
            (OnWires::Link(link), OnWires::Contact(contact)) => {
                self.link_coupling(contact, link)[0]
            }
            (OnWires::Contact(contact), OnWires::Link(link)) => {
                self.link_coupling(contact, link)[1]
            }
            _ => 0.0,
        }
    }

    /// Returns the opening of a link for a unit contact force, and of the contact for a unit
    /// correction.
    fn link_coupling(&self, contact: &Contact<DIM>, link: usize) -> [f64; 2] {
        let (elongation, rise) = (
            self.contact_on_link(contact, link),
            contact.compliance.of_link(link),
        );
        let relief = self.tension_relief(link, rise) / self.table.step_stiffness[link];
        [
            elongation - relief,
            rise / self.coefficients.stiffness - elongation,
        ]
    }
}
