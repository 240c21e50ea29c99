//! Forces σ of the stops and breakpoints of a pantograph by itself.
//!
//!   0 ≤ σ ⊥ H σ + s/f − Σ (dᵀA⁻¹e) λ ≥ 0
//!
//! with the predicted opening s and the factor f of each active one
//! ([`breakpoint`](crate::pantograph::breakpoint)), under known contact forces λ.

use crate::lcp::{LcpFailure, LcpSolver};
use crate::linalg::dense;
use crate::linalg::small::inner;
use crate::pantograph::breakpoint::Breakpoint;
use crate::session::alone::strip_now::StripNow;

/// Complementarity problem of the active breakpoints, with its memory.
#[derive(Debug, Clone, Default)]
pub(super) struct BreakpointProblem {
    rows: Vec<usize>,
    h: Vec<f64>,
    w: Vec<f64>,
    x: Vec<f64>,
    y: Vec<f64>,
    warm: Vec<bool>,
    solver: LcpSolver,
}

impl BreakpointProblem {
    pub(super) fn with_room(rows: usize) -> Self {
        let mut made = Self::default();
        made.rows.reserve(rows);
        made.h.reserve(rows * rows);
        for list in [&mut made.w, &mut made.x, &mut made.y] {
            list.reserve(rows);
        }
        made.warm.reserve(rows);
        if rows > 0 {
            made.solver.reserve(rows);
        }
        made
    }

    /// Number of breakpoints that were active in the last solution.
    pub(super) fn active(&self) -> usize {
        self.rows.len()
    }

    /// Finds the forces of the active breakpoints under contact forces, N.
    ///
    /// # Errors
    /// [`LcpFailure`].
    pub(super) fn solve(
        &mut self,
        all: &mut [Breakpoint],
        strips: &[StripNow],
        forces: &[f64],
    ) -> Result<(), LcpFailure> {
        self.rows.clear();
        let active = all.iter().enumerate().filter(|(_, b)| b.active);
        self.rows.extend(active.map(|(number, _)| number));
        let n = self.rows.len();
        if n == 0 {
            return Ok(());
        }
        self.set_matrix(all);
        self.w.clear();
        self.warm.clear();
        for &row in &self.rows {
            let b = &all[row];
            let pressed = strips.iter().zip(forces);
            let by_contacts: f64 = pressed
                .map(|(strip, force)| inner(&b.coordinate.direction, &strip.column) * force)
                .sum();
            self.w.push(b.predicted_opening / b.factor - by_contacts);
            self.warm.push(b.force > 0.0);
        }
        for list in [&mut self.x, &mut self.y] {
            list.resize(n, 0.0);
        }
        self.solver
            .solve(&self.h, &self.w, &mut self.x, &mut self.y, &self.warm)?;
        for (&row, force) in self.rows.iter().zip(&self.x) {
            all[row].force = *force;
        }
        Ok(())
    }

    /// Leaves only the breakpoints that are closed in the last solution.
    pub(super) fn keep_closed(&mut self, all: &[Breakpoint]) {
        self.rows
            .retain(|&row| all[row].active && all[row].force > 0.0);
    }

    /// Finds how much more force the closed breakpoints have for 1 N that moves a column A⁻¹e.
    pub(super) fn load(&mut self, all: &[Breakpoint], column: &[f64]) {
        self.x.clear();
        let rows = self.rows.iter().map(|&row| &all[row]);
        self.x
            .extend(rows.map(|b| inner(&b.coordinate.direction, column)));
        self.set_matrix(all);
        let is_regular = dense::solve_in_place(&mut self.h, &mut self.x);
        debug_assert!(is_regular, "a principal block of a P-matrix");
    }

    /// Returns by how much these forces hold back the coordinate of a vector e, m.
    pub(super) fn held(&self, all: &[Breakpoint], vector: &[f64]) -> f64 {
        let pairs = self.rows.iter().zip(&self.x);
        pairs
            .map(|(&row, force)| all[row].sign * force * inner(vector, &all[row].column))
            .sum()
    }

    /// Sets H of the rows: see [`breakpoint`](crate::pantograph::breakpoint).
    fn set_matrix(&mut self, all: &[Breakpoint]) {
        self.h.clear();
        for &i in &self.rows {
            let row = self.rows.iter();
            self.h
                .extend(row.map(|&j| all[i].response(&all[j], i == j)));
        }
    }
}
