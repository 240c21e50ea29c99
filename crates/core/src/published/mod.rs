//! The time step of the paper this project is founded on, formula by formula, dense and literal.
//!
//! G. N. Kolesnikov, D. A. Kuvshinov, "Numerical modelling of the semi-coercive mechanical interaction
//! of a pantograph and an overhead contact line at high locomotive speed" (in Russian), Petrozavodsk
//! State University, about 2009. The text we have carries no equation numbers. The numbers here count
//! its formulas in the order in which `docs/theory/published-method.md` lists them: "model 2" is the
//! second of the mathematical model, "step 5" the fifth of one time step.
//!
//! | paper | here | meaning | unit |
//! |---|---|---|---|
//! | U | `u` | displacements | m |
//! | M | `mass` | mass matrix | kg |
//! | K | `damping`, C_d | damping matrix | N·s/m |
//! | r | `stiffness`, K | stiffness matrix | N/m |
//! | P | `load`, p | nodal loads | N |
//! | N | `force`, n | contact forces | N |
//! | D, D_0 | `gap`, `initial_gap`, d, d0 | gaps; gaps at u = 0 | m |
//! | C | `contact_map`, C | contact map, d = Cᵀu + d0 | 1 |
//! | R | – | reactions of the fictitious links, zero at the end of a step | N |
//!
//! It serves any system given by these matrices. Runs of a line take the same step in a form that is
//! as fast as the sparse matrices allow; the page above sets both side by side.
//!
//! * **Model 1** `R = M ü + C_d u̇ + K u − p − C n = 0`
//! * **Model 2** `d = Cᵀ u + d0`
//! * **Model 3** `dᵀ n = 0,  d ≥ 0,  n ≥ 0`

mod matrix;
mod table;

pub use matrix::Matrix;
pub use table::{BlockTable, exchange_row, table_1};

use crate::error::CoreError;
use crate::lcp::{LcpFailure, LcpSolver, LcpStats};
use matrix::{finite, refuse, square, symmetric};

/// **Step 1** `u̇_i = (u_i − u_{i−1}) / τ`
#[must_use]
pub fn velocity(u: &[f64], u_1: &[f64], tau: f64) -> Vec<f64> {
    u.iter().zip(u_1).map(|(u, u_1)| (u - u_1) / tau).collect()
}

/// **Step 2** `ü_i = (u_i − 2 u_{i−1} + u_{i−2}) / τ²`
#[must_use]
pub fn acceleration(u: &[f64], u_1: &[f64], u_2: &[f64], tau: f64) -> Vec<f64> {
    (0..u.len())
        .map(|k| (u[k] - 2.0 * u_1[k] + u_2[k]) / (tau * tau))
        .collect()
}

/// **Step 3** `A = M/τ² + C_d/τ + K`
#[must_use]
pub fn matrix_a(mass: &Matrix, damping: &Matrix, stiffness: &Matrix, tau: f64) -> Matrix {
    Matrix::filled(mass.rows, mass.rows, |i, j| {
        mass.at(i, j) / (tau * tau) + damping.at(i, j) / tau + stiffness.at(i, j)
    })
}

/// **Step 4** `B = 2 M/τ² + C_d/τ`
#[must_use]
pub fn matrix_b(mass: &Matrix, damping: &Matrix, tau: f64) -> Matrix {
    Matrix::filled(mass.rows, mass.rows, |i, j| {
        2.0 * mass.at(i, j) / (tau * tau) + damping.at(i, j) / tau
    })
}

/// **Step 5** `p̂_i = M u_{i−2}/τ² − B u_{i−1} − p_i`
#[must_use]
pub fn load_p_hat(
    mass: &Matrix,
    b: &Matrix,
    [u_1, u_2]: [&[f64]; 2],
    load: &[f64],
    tau: f64,
) -> Vec<f64> {
    let (m_u, b_u) = (mass.times(u_2), b.times(u_1));
    (0..load.len())
        .map(|k| m_u[k] / (tau * tau) - b_u[k] - load[k])
        .collect()
}

/// **Algorithm 4**, Amontons–Coulomb: `T_i = f n_{i−1}`, with the normal forces of the step before.
#[must_use]
pub fn friction(f: f64, force_1: &[f64]) -> Vec<f64> {
    force_1.iter().map(|n| f * n).collect()
}

/// What is known at the start of step i, besides the matrices.
#[derive(Debug, Clone, Copy)]
pub struct Known<'a> {
    /// u_{i−1}.
    pub u_1: &'a [f64],
    /// u_{i−2}.
    pub u_2: &'a [f64],
    /// p_i; friction `T_i` belongs in it, on the degrees of freedom along the surface.
    pub load: &'a [f64],
    /// C: column j tells where and in which direction the force of contact j pushes.
    pub contact_map: &'a Matrix,
    /// d0.
    pub initial_gap: &'a [f64],
}

/// Result of a step.
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    /// u_i.
    pub u: Vec<f64>,
    /// n_i.
    pub force: Vec<f64>,
    /// d_i.
    pub gap: Vec<f64>,
    /// Pivots and residual.
    pub stats: LcpStats,
}

/// Why a step was not taken.
#[derive(Debug, thiserror::Error)]
pub enum StepError {
    /// Arrays that do not fit the system.
    #[error(transparent)]
    Input(#[from] CoreError),
    /// The complementarity problem has no verified solution.
    #[error(transparent)]
    Lcp(#[from] Box<LcpFailure>),
}

/// A system with its matrices for one step length.
#[derive(Debug)]
pub struct PublishedStep {
    mass: Matrix,
    damping: Matrix,
    tau: f64,
    a: Matrix,
    a_inverse: Matrix,
    b: Matrix,
    solver: LcpSolver,
}

impl PublishedStep {
    /// Form A, its inverse and B.
    ///
    /// # Errors
    /// [`CoreError::Input`] when the step is not positive, sizes disagree, a matrix is not symmetric,
    /// or A is not positive definite.
    pub fn new(
        mass: Matrix,
        damping: Matrix,
        stiffness: &Matrix,
        tau: f64,
    ) -> Result<Self, CoreError> {
        if !(tau > 0.0 && tau.is_finite()) {
            return refuse("time_step", format!("{tau} s is not a positive number"));
        }
        let size = mass.rows;
        if size == 0 {
            return refuse("mass", "no degrees of freedom".into());
        }
        square("mass", &mass, size)?;
        square("damping", &damping, size)?;
        let (a, a_inverse) = form(&mass, &damping, stiffness, tau)?;
        Ok(Self {
            b: matrix_b(&mass, &damping, tau),
            mass,
            damping,
            tau,
            a,
            a_inverse,
            solver: LcpSolver::new(),
        })
    }

    /// Form A anew with another stiffness (**algorithm 5**); on an error the old one stays.
    ///
    /// # Errors
    /// As [`PublishedStep::new`].
    pub fn reform(&mut self, stiffness: &Matrix) -> Result<(), CoreError> {
        (self.a, self.a_inverse) = form(&self.mass, &self.damping, stiffness, self.tau)?;
        Ok(())
    }

    /// Tables 1 and 2 of a step (steps 5 to 7).
    ///
    /// # Errors
    /// [`CoreError::Input`] when an array does not fit, is not finite, or a contact acts on nothing.
    pub fn table_2(&self, known: &Known<'_>) -> Result<BlockTable, CoreError> {
        self.check(known)?;
        let displacements = [known.u_1, known.u_2];
        let p_hat = load_p_hat(&self.mass, &self.b, displacements, known.load, self.tau);
        let table = table_1(&self.a, known.contact_map, p_hat, known.initial_gap);
        Ok(table.exchange(&self.a_inverse))
    }

    /// One time step. **Step 8** `y = H x + w,  yᵀx = 0,  y ≥ 0,  x ≥ 0` with y = d_i, x = n_i is
    /// solved by principal pivoting with the energy criterion ([`crate::lcp`]).
    ///
    /// # Errors
    /// [`StepError`].
    pub fn step(&mut self, known: &Known<'_>) -> Result<Step, StepError> {
        let table = self.table_2(known)?;
        let (h, w) = (&table.h().values, table.w());
        let (mut force, mut gap) = (vec![0.0; w.len()], vec![0.0; w.len()]);
        let solved = self.solver.solve(h, w, &mut force, &mut gap, &[]);
        let stats = solved.map_err(Box::new)?;
        let u = table.displacements(&force);
        Ok(Step {
            u,
            force,
            gap,
            stats,
        })
    }

    fn check(&self, known: &Known<'_>) -> Result<(), CoreError> {
        let (size, map) = (self.mass.rows, known.contact_map);
        finite("u_1", known.u_1, size)?;
        finite("u_2", known.u_2, size)?;
        finite("load", known.load, size)?;
        finite("contact_map", &map.values, size * map.columns)?;
        finite("initial_gap", known.initial_gap, map.columns)?;
        let acts = |j: &usize| (0..size).any(|i| map.at(i, *j) != 0.0);
        match (0..map.columns).find(|j| !acts(j)) {
            None => Ok(()),
            Some(j) => refuse(
                "contact_map",
                format!("column {j} is zero: that contact acts on nothing"),
            ),
        }
    }
}

fn form(
    mass: &Matrix,
    damping: &Matrix,
    stiffness: &Matrix,
    tau: f64,
) -> Result<(Matrix, Matrix), CoreError> {
    square("stiffness", stiffness, mass.rows)?;
    let a = matrix_a(mass, damping, stiffness, tau);
    symmetric("mass", mass, 1.0 / (tau * tau), &a)?;
    symmetric("damping", damping, 1.0 / tau, &a)?;
    symmetric("stiffness", stiffness, 1.0, &a)?;
    let a_inverse = table::inverse(&a)?;
    Ok((a, a_inverse))
}
