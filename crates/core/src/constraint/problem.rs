//! The complementarity problem of one step: contacts, slack links and stops together.
//!
//! Contact j (a strip on a lane): force λ ≥ 0 against gap d + λ/k_c ≥ 0 (k_c infinite when rigid).
//! Link i:    correction r ≥ 0 against tension T ≥ 0; r cancels what the linear link would push.
//! Both laws hold at the time of balance. With Δu = Δu₀ + A⁻¹(C λ − G r),
//!
//!   [ d/a ]   [ CᵀA⁻¹C + eᵀA_p⁻¹e + 1/(a k_c)   −CᵀA⁻¹G        ] [ λ ]   [ d₀/a ]
//!   [ T/κ ] = [ GᵀA⁻¹C                           1/κ − GᵀA⁻¹G   ] [ r ] + [ T₀/κ ]
//!
//! eᵀA_p⁻¹e couples the contacts of one rider. a = 1 − α_f, κ = a k + (a γ / β h) c of the link. Dividing by a and κ makes the diagonal blocks
//! symmetric and the coupling skew, so the matrix is positive definite and the solution unique.
//!
//! Where wires yield beyond the mesh ([yields](crate::slideline::residual_flexibility)), C is that of s, the contacts have R̃/a as well, and
//! the coupling to link d has −R_d k/κ in its row, +R_d/a in its column. That is skew but for damping of the
//! link, κ > a k. The matrix stays positive definite: with D = R_d (1/a − k/κ) ≤ R_d/a, ¼D² is small
//! against R̃/a + 1/(a k_c) times 1/κ, as R_d² ≤ R/k.
//!
//! Stop s of a rider: force σ ≥ 0 against opening s + σ/k_s ≥ 0. It moves its rider alone, so divided
//! by a it joins the contacts: dᵀA_p⁻¹d + 1/(a k_s), coupled to the contacts of the same rider
//! by −dᵀA_p⁻¹e in both directions, and to no link. The block stays symmetric and positive definite.
//! So does a hardening [kink](crate::pantograph::breakpoint) of a spring or damper; a softening one joins the links.

use crate::constraint::contacts::Contacts;
use crate::constraint::link_table::LinkTable;
use crate::constraint::links::LinkMotion;
use crate::integrator::prepared::WireModel;
use crate::lcp::{LcpFailure, LcpSolver, LcpStats};
use crate::pantograph::system::{PantographState, inner};
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
    is_in: Vec<bool>,
    h: Vec<f64>,
    w: Vec<f64>,
    x: Vec<f64>,
    y: Vec<f64>,
    warm: Vec<bool>,
    solver: LcpSolver,
}

impl ConstraintProblem {
    /// For the given numbers of contacts and links, with the corrections at the start.
    #[must_use]
    pub fn new(contacts: usize, correction: Vec<f64>) -> Self {
        Self {
            gap: vec![f64::INFINITY; contacts],
            applied_force: vec![0.0; contacts],
            applied_correction: vec![0.0; correction.len()],
            is_in: vec![false; correction.len()],
            force: vec![0.0; contacts],
            correction,
            ..Self::default()
        }
    }

    /// Make room for problems of up to `rows` rows, so that none is made in a step.
    pub(crate) fn reserve(&mut self, rows: usize) {
        self.h.reserve(rows * rows);
        for vector in [&mut self.w, &mut self.x, &mut self.y] {
            vector.reserve(rows);
        }
        self.warm.reserve(rows);
        self.links.reserve(self.correction.len());
        self.solver.reserve(rows);
    }

    /// Forget the contacts that do not take part.
    pub fn choose<const DIM: usize>(&mut self, contacts: &Contacts<DIM>) {
        for (i, _) in contacts.all.iter().enumerate().filter(|(_, c)| !c.meets) {
            (self.force[i], self.gap[i]) = (0.0, f64::INFINITY);
        }
    }

    /// Forget what entered in the step before.
    pub(crate) fn clear(&mut self) {
        self.applied_force.fill(0.0);
        for i in self.links.drain(..) {
            self.applied_correction[i] = 0.0;
            self.is_in[i] = false;
        }
    }

    /// Let those of the given links enter that would push, and those slack a step ago, if they have not yet; tells
    /// whether there were any.
    pub(crate) fn collect(
        &mut self,
        among: impl Iterator<Item = Range<usize>>,
        (motion, table): (&LinkMotion, &LinkTable),
    ) -> bool {
        let before = self.links.len();
        let Self {
            links,
            is_in,
            correction,
            ..
        } = self;
        for which in among {
            motion.unusual(which, (table, correction), |i| {
                if !std::mem::replace(&mut is_in[i], true) {
                    links.push(i);
                }
            });
        }
        self.links.len() > before
    }

    /// Set up H for the chosen links and solve. `gap_free` and `tension_free` are d₀ and T₀.
    ///
    /// # Errors
    /// [`LcpFailure`] with the problem in it.
    pub fn solve<const DIM: usize, const D: usize>(
        &mut self,
        p: &WireModel<DIM, D>,
        contacts: &Contacts<DIM>,
        riders: &mut [PantographState],
        gap_free: &[f64],
        tension_free: &[f64],
    ) -> Result<LcpStats, Box<LcpFailure>> {
        let m = contacts.active.len();
        let first_stop = m + self.links.len();
        let n = first_stop + riders.iter().map(|r| r.entered().count()).sum::<usize>();
        self.h.resize(n * n, 0.0);
        for v in [&mut self.w, &mut self.x, &mut self.y] {
            v.resize(n, 0.0);
        }
        self.warm.resize(n, false);
        self.enter_contacts(p, contacts, gap_free);
        for (k, &link) in self.links.iter().enumerate() {
            for (l, &other) in self.links.iter().enumerate() {
                self.h[(m + k) * n + m + l] = -p.link_on_link(other, link);
            }
            self.h[(m + k) * n + m + k] += 1.0 / p.table.of_increment[link];
            self.w[m + k] = tension_free[link] / p.table.of_increment[link];
            self.warm[m + k] = self.correction[link] > 0.0;
        }
        self.enter_kinks(contacts, riders, first_stop);
        let stats = self
            .solver
            .solve(&self.h, &self.w, &mut self.x, &mut self.y, &self.warm);
        let stats = stats.map_err(Box::new)?;
        for (j, &i) in contacts.active.iter().enumerate() {
            self.force[i] = self.x[j];
            self.gap[i] = self.y[j] * p.coefficients.stiffness;
        }
        for (k, &link) in self.links.iter().enumerate() {
            self.correction[link] = self.x[m + k];
        }
        let kinks = riders.iter_mut().flat_map(PantographState::entered_mut);
        for (kink, &force) in kinks.zip(&self.x[first_stop..]) {
            kink.force = force;
        }
        Ok(stats)
    }

    /// Rows and columns of the contacts, and their coupling to the links.
    fn enter_contacts<const DIM: usize, const D: usize>(
        &mut self,
        p: &WireModel<DIM, D>,
        contacts: &Contacts<DIM>,
        gap_free: &[f64],
    ) {
        let (n, m) = (self.w.len(), contacts.active.len());
        for (j, contact) in contacts.active().enumerate() {
            for (i, other) in contacts.active().enumerate() {
                let residual = p.residual(contact, other) / p.coefficients.stiffness;
                let mut response = p.contact_on_contact(contact, other) + residual;
                if other.rider() == contact.rider() {
                    let compliance = f64::from(u8::from(i == j)) * p.contact_compliance;
                    response += inner(&other.vector, &contact.column) + compliance;
                }
                self.h[i * n + j] = response;
            }
            for (k, &link) in self.links.iter().enumerate() {
                let (pulled, rise) = (p.contact_on_link(contact, link), contact.yields.of(link));
                let eased = p.eased(link, rise) / p.table.of_increment[link];
                self.h[(m + k) * n + j] = pulled - eased;
                self.h[j * n + m + k] = rise / p.coefficients.stiffness - pulled;
            }
        }
        for (j, &i) in contacts.active.iter().enumerate() {
            self.w[j] = gap_free[i] / p.coefficients.stiffness;
            self.warm[j] = self.force[i] > 0.0;
        }
    }

    /// Rows and columns of stops and other kinks, behind those of contacts and links.
    fn enter_kinks<const DIM: usize>(
        &mut self,
        contacts: &Contacts<DIM>,
        riders: &[PantographState],
        first: usize,
    ) {
        let n = self.w.len();
        for row in first..n {
            self.h[row * n..(row + 1) * n].fill(0.0);
            (0..first).for_each(|i| self.h[i * n + row] = 0.0);
        }
        let mut base = first;
        for (number, rider) in riders.iter().enumerate() {
            for (k, kink) in rider.entered().enumerate() {
                let row = base + k;
                let own = contacts.active().enumerate();
                for (j, contact) in own.filter(|(_, c)| c.rider() == number) {
                    let coupling = -inner(&contact.vector, &kink.column);
                    self.h[row * n + j] = coupling;
                    self.h[j * n + row] = coupling * kink.sign;
                }
                for (l, other) in rider.entered().enumerate() {
                    self.h[row * n + base + l] = kink.response(other, k == l);
                }
                self.w[row] = kink.free / kink.factor;
                self.warm[row] = kink.force > 0.0;
            }
            base += rider.entered().count();
        }
    }
}
