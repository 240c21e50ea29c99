//! Complementarity problem of one step: contacts, slack links, bump stops and breakpoints together.
//!
//! Its unknowns are the forces of [rows](crate::constraint::row). For contacts j (a strip on a
//! slideline) and links i, with Δu = Δu₀ + A⁻¹(C λ − G r) at the time of balance,
//!
//!   [ d/a ]   [ CᵀA⁻¹C + eᵀA_p⁻¹e + 1/(a k_c)   −CᵀA⁻¹G        ] [ λ ]   [ d₀/a ]
//!   [ T/κ ] = [ GᵀA⁻¹C                           1/κ − GᵀA⁻¹G   ] [ r ] + [ T₀/κ ]
//!
//! eᵀA_p⁻¹e couples the contacts of one pantograph; k_c is infinite for rigid contact. The divisors
//! a and κ make the diagonal blocks symmetric and the coupling skew, so the matrix is positive
//! definite and the solution unique.
//!
//! Where wires have [local compliance](crate::slideline::local_compliance) beyond the mesh, C is
//! that of s, the contacts have R̃/a as well, and the coupling to link d has −R_d k/κ in its row,
//! +R_d/a in its column. That is skew except for damping of the link, κ > a k. The matrix stays
//! positive definite: with D = R_d (1/a − k/κ) ≤ R_d/a, ¼D² is small against R̃/a + 1/(a k_c) times
//! 1/κ, as R_d² ≤ R/k.
//!
//! A bump stop moves its pantograph alone, so it joins the contacts: dᵀA_p⁻¹d + 1/(a k_s), coupled
//! to the contacts of the same pantograph by −dᵀA_p⁻¹e in both directions, and to no link. The
//! block stays symmetric and positive definite. A hardening
//! [breakpoint](crate::pantograph::breakpoint) of a spring or damper likewise; a softening one
//! joins the links.

use crate::constraint::contacts::Contacts;
use crate::constraint::link_table::LinkTable;
use crate::constraint::links::LinkMotion;
use crate::constraint::row::{Row, RowId};
use crate::constraint::wires::Wires;
use crate::lcp::{LcpFailure, LcpSolver, LcpStats};
use crate::pantograph::state::PantographState;
use std::ops::Range;

/// Unknowns and workspace of the complementarity problem; nothing is allocated during a run
/// once the vectors have grown.
#[derive(Debug, Clone, Default)]
pub struct ConstraintProblem {
    /// Contact forces λ, N; zero where a contact does not take part.
    pub force: Vec<f64>,
    /// Gaps d + λ/k_c, m: zero when closed, infinite where a contact does not take part.
    pub gap: Vec<f64>,
    /// Corrections r of all links, N.
    pub correction: Vec<f64>,
    /// Links in the problem of this step.
    pub links: Vec<usize>,
    /// Part of `force` already contained in the increments of this step.
    pub(crate) applied_force: Vec<f64>,
    /// Part of `correction` already contained in the increments of this step.
    pub(crate) applied_correction: Vec<f64>,
    in_working_set: Vec<bool>,
    rows: Vec<RowId>,
    h: Vec<f64>,
    w: Vec<f64>,
    x: Vec<f64>,
    y: Vec<f64>,
    warm: Vec<bool>,
    solver: LcpSolver,
}

impl ConstraintProblem {
    /// Creates the problem for a number of contacts and the initial corrections of all links, N.
    #[must_use]
    pub fn new(contacts: usize, correction: Vec<f64>) -> Self {
        Self {
            gap: vec![f64::INFINITY; contacts],
            applied_force: vec![0.0; contacts],
            applied_correction: vec![0.0; correction.len()],
            in_working_set: vec![false; correction.len()],
            force: vec![0.0; contacts],
            correction,
            ..Self::default()
        }
    }

    /// Reserves memory for problems of up to `rows` rows, so that a step allocates none.
    pub(crate) fn reserve(&mut self, rows: usize) {
        self.h.reserve(rows * rows);
        for vector in [&mut self.w, &mut self.x, &mut self.y] {
            vector.reserve(rows);
        }
        self.warm.reserve(rows);
        self.rows.reserve(rows);
        self.links.reserve(self.correction.len());
        self.solver.reserve(rows);
    }

    /// Sets force 0 and gap ∞ of the contacts that do not take part.
    pub fn drop_inactive_contacts<const DIM: usize>(&mut self, contacts: &Contacts<DIM>) {
        for (i, _) in contacts
            .all
            .iter()
            .enumerate()
            .filter(|(_, c)| !c.is_active)
        {
            (self.force[i], self.gap[i]) = (0.0, f64::INFINITY);
        }
    }

    /// Clears the working set and the applied forces of the step before.
    pub(crate) fn clear_working_set(&mut self) {
        self.applied_force.fill(0.0);
        for i in self.links.drain(..) {
            self.applied_correction[i] = 0.0;
            self.in_working_set[i] = false;
        }
    }

    /// Adds to the working set the links among the given ones that would push or were slack a step
    /// ago; returns whether any was added.
    pub(crate) fn update_working_set(
        &mut self,
        among: impl Iterator<Item = Range<usize>>,
        (motion, table): (&LinkMotion, &LinkTable),
    ) -> bool {
        let before = self.links.len();
        let Self {
            links,
            in_working_set,
            correction,
            ..
        } = self;
        for which in among {
            motion.for_each_candidate(which, (table, correction), |i| {
                if !std::mem::replace(&mut in_working_set[i], true) {
                    links.push(i);
                }
            });
        }
        self.links.len() > before
    }

    /// Sets up the rows of the active contacts, links and breakpoints, and solves. `gap_free` (m)
    /// and `tension_free` (N) are openings without the forces of the problem.
    ///
    /// # Errors
    /// [`LcpFailure`] with the problem.
    pub fn solve<const DIM: usize, const D: usize>(
        &mut self,
        wires: &Wires<DIM, D>,
        contacts: &Contacts<DIM>,
        pantographs: &mut [PantographState],
        gap_free: &[f64],
        tension_free: &[f64],
    ) -> Result<LcpStats, Box<LcpFailure>> {
        self.number_rows(contacts, pantographs);
        let n = self.rows.len();
        self.h.resize(n * n, 0.0);
        for v in [&mut self.w, &mut self.x, &mut self.y] {
            v.resize(n, 0.0);
        }
        self.warm.resize(n, false);
        let force = &self.force;
        let correction = &self.correction;
        let row = |id: RowId| match id {
            RowId::Contact(i) => Row::contact(wires, &contacts.all[i], (gap_free[i], force[i])),
            RowId::Link(i) => Row::link(wires, i, (tension_free[i], correction[i])),
            RowId::Breakpoint { pantograph, number } => {
                Row::breakpoint(pantograph, &pantographs[pantograph].breakpoints[number])
            }
        };
        for i in 0..n {
            let current = row(self.rows[i]);
            self.h[i * n + i] = current.diagonal(wires);
            for j in 0..i {
                let [lower, upper] = current.coupling(&row(self.rows[j]), wires);
                (self.h[i * n + j], self.h[j * n + i]) = (lower, upper);
            }
            self.w[i] = current.free;
            self.warm[i] = current.force > 0.0;
        }
        let stats = self
            .solver
            .solve(&self.h, &self.w, &mut self.x, &mut self.y, &self.warm);
        let stats = stats.map_err(Box::new)?;
        for (id, (&x, &y)) in self.rows.iter().zip(self.x.iter().zip(&self.y)) {
            match *id {
                RowId::Contact(i) => {
                    (self.force[i], self.gap[i]) = (x, y * wires.coefficients.stiffness);
                }
                RowId::Link(i) => self.correction[i] = x,
                RowId::Breakpoint { pantograph, number } => {
                    pantographs[pantograph].breakpoints[number].force = x;
                }
            }
        }
        Ok(stats)
    }

    /// Lists the rows: contacts that take part, links of the working set, active breakpoints.
    fn number_rows<const DIM: usize>(
        &mut self,
        contacts: &Contacts<DIM>,
        pantographs: &[PantographState],
    ) {
        self.rows.clear();
        let of_contacts = contacts.active.iter().map(|&i| RowId::Contact(i));
        self.rows.extend(of_contacts);
        self.rows.extend(self.links.iter().map(|&i| RowId::Link(i)));
        for (pantograph, state) in pantographs.iter().enumerate() {
            let breakpoints = state
                .breakpoints
                .iter()
                .enumerate()
                .filter(|(_, b)| b.active);
            let id = |(number, _)| RowId::Breakpoint { pantograph, number };
            self.rows.extend(breakpoints.map(id));
        }
    }
}
