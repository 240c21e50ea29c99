//! Lowest natural frequencies: Lanczos on K⁻¹M in the inner product of M.
//!
//! K φ = ω² M φ  ⇔  K⁻¹M φ = ω⁻² φ, and K⁻¹M is self-adjoint for ⟨x, y⟩ = xᵀM y.
//! Full reorthogonalisation: the basis stays small (a few hundred vectors) and no ghost values
//! appear. Source: Golub & Van Loan, Matrix Computations, sections 10.3 and 10.1.
//!
//! Of modes with equal or nearly equal frequencies one start vector contains one combination: the
//! others arise from rounding and come late. So modes are counted: K − σM has as many negative
//! pivots as there are squares ω² below σ (Sylvester's law of inertia).
//!
//! Started with x₀ = K⁻¹b instead, the process finds the modes that a force b excites, in
//! proportion: x₀ has the part φᵀb/ω² of mode φ. So the eigenvalues θ of the tridiagonal matrix,
//! with squares τ of the first components of its eigenvectors, are a Gauss rule of the flexibility,
//!
//!   bᵀ(K − σM)⁻¹b = Σ (φᵀb)²/(ω² − σ) ≈ |x₀|² Σ (τ/θ)/(1 − θσ),   |x₀|² = x₀ᵀM x₀
//!
//! Source: Golub & Meurant, Matrices, Moments and Quadrature, chapters 6 and 7.

use super::{BlockLdl, MassMatrix, dense};

/// Number of steps for each frequency required, at first; six give the lowest ones to rounding when
/// no two are equal.
const FIRST_STEPS: usize = 6;
/// Bound on the rounds, each with half as many steps more: thirty steps for each frequency in the
/// last.
const MOST_ROUNDS: usize = 5;
/// Tolerance of the change of values in the last steps, relative.
const CONVERGED: f64 = 1e-10;
/// Margin above the last frequency required within which its modes are counted, relative in ω².
const MARGIN: f64 = 1e-7;
/// Remainder of a vector that the basis already spans, relative.
const SPANNED: f64 = 1e-8;
/// Number of steps between two calls of `keep_going`: some milliseconds of a long line, and no call
/// for the usual ten frequencies of a short one.
const STEPS_PER_CALL: usize = 128;

fn dot<const D: usize>(x: &[[f64; D]], y: &[[f64; D]]) -> f64 {
    x.iter()
        .flatten()
        .zip(y.iter().flatten())
        .map(|(a, b)| a * b)
        .sum()
}

fn axpy<const D: usize>(y: &mut [[f64; D]], factor: f64, x: &[[f64; D]]) {
    y.iter_mut()
        .flatten()
        .zip(x.iter().flatten())
        .for_each(|(a, b)| *a += factor * b);
}

/// Lowest `count` natural frequencies, Hz, ascending, each with its multiplicity; fewer when the
/// structure has fewer.
///
/// `free(node, component)` tells whether a degree of freedom can move, `below` how many modes have
/// ω² below a value, `None` where that is not known. After the last round the values found are
/// returned. `keep_going` is called now and then; the result is `None` when it returns false.
pub fn lowest_frequencies<const DIM: usize, const D: usize>(
    stiffness: &BlockLdl<D>,
    mass: &MassMatrix<DIM, D>,
    nodes: usize,
    free: impl Fn(usize, usize) -> bool,
    count: usize,
    below: impl Fn(f64) -> Option<usize>,
    keep_going: &mut dyn FnMut() -> bool,
) -> Option<Vec<f64>> {
    let mut process = Process::new(stiffness, mass, nodes, free);
    // No structure has more modes than coordinates.
    let count = count.min(process.dimension);
    let mut steps = FIRST_STEPS * count;
    let mut values = Vec::new();
    for _ in 0..MOST_ROUNDS {
        while process.basis.len() < steps && !process.exhausted {
            process.extend(steps.min(process.basis.len() + STEPS_PER_CALL));
            if process.basis.len() < steps && !process.exhausted && !keep_going() {
                return None;
            }
        }
        values = process.values(process.basis.len());
        if process.exhausted || count == 0 || is_complete(&process, &values, count, &below) {
            break;
        }
        steps += steps / 2;
    }
    let positive = values.iter().take(count).filter(|&&v| v > 0.0);
    Some(
        positive
            .map(|v| 1.0 / (v.sqrt() * std::f64::consts::TAU))
            .collect(),
    )
}

/// Recurrence of Lanczos' process started with one vector: its matrix, and the squared length of
/// the vector.
#[derive(Debug, Clone)]
pub struct Recurrence {
    /// Squared length |x₀|² = x₀ᵀM x₀.
    pub squared_length: f64,
    /// Diagonal of the tridiagonal matrix, s².
    pub diagonal: Vec<f64>,
    /// Off-diagonal entries of the tridiagonal matrix, s².
    pub off: Vec<f64>,
}

/// Recurrence of `steps` steps of the process started with `start`, m; fewer when there are fewer
/// modes, none for a start of zeros.
#[must_use]
pub fn recurrence_from<const DIM: usize, const D: usize>(
    stiffness: &BlockLdl<D>,
    mass: &MassMatrix<DIM, D>,
    free: impl Fn(usize, usize) -> bool,
    start: Vec<[f64; D]>,
    steps: usize,
) -> Recurrence {
    let mut process = Process::new(stiffness, mass, start.len(), free);
    process.vector = start;
    let squared_length = process.weighted().1.powi(2);
    process.extend(steps);
    let (mut diagonal, mut off) = (process.diagonal, process.off);
    // Beyond a coupling of zero are modes that the start has no part of.
    if let Some(end) = off.iter().position(|&coupling| coupling <= 0.0) {
        diagonal.truncate(end + 1);
        off.truncate(end);
    }
    Recurrence {
        squared_length,
        diagonal,
        off,
    }
}

/// Tells whether the first values have converged and none is missing among them.
fn is_complete<const DIM: usize, const D: usize, F: Fn(usize, usize) -> bool>(
    process: &Process<DIM, D, F>,
    values: &[f64],
    count: usize,
    below: impl Fn(f64) -> Option<usize>,
) -> bool {
    let earlier = process.values(values.len() - count);
    let pairs = values.iter().zip(&earlier).take(count);
    let converged = earlier.len() >= count && pairs.clone().all(|(v, e)| v - e <= CONVERGED * v);
    let edge = values[count - 1] / (1.0 + MARGIN);
    converged && below(1.0 / edge) == Some(values.iter().filter(|&&v| v > edge).count())
}

/// Lanczos process that can be extended.
struct Process<'a, const DIM: usize, const D: usize, F> {
    stiffness: &'a BlockLdl<D>,
    mass: &'a MassMatrix<DIM, D>,
    free: F,
    seed: u64,
    /// Number of coordinates that can move, an upper bound of the size of the basis.
    dimension: usize,
    basis: Vec<Vec<[f64; D]>>,
    basis_mass: Vec<Vec<[f64; D]>>,
    diagonal: Vec<f64>,
    off: Vec<f64>,
    vector: Vec<[f64; D]>,
    scratch: Vec<[f64; D]>,
    exhausted: bool,
}

impl<'a, const DIM: usize, const D: usize, F: Fn(usize, usize) -> bool> Process<'a, DIM, D, F> {
    fn new(
        stiffness: &'a BlockLdl<D>,
        mass: &'a MassMatrix<DIM, D>,
        nodes: usize,
        free: F,
    ) -> Self {
        let coordinates = (0..nodes).flat_map(|i| (0..D).map(move |c| (i, c)));
        let dimension = coordinates.filter(|&(i, c)| free(i, c)).count();
        let mut process = Self {
            dimension,
            stiffness,
            mass,
            free,
            seed: 0x9E37_79B9_7F4A_7C15,
            basis: Vec::new(),
            basis_mass: Vec::new(),
            diagonal: Vec::new(),
            off: Vec::new(),
            vector: vec![[0.0; D]; nodes],
            scratch: vec![[0.0; D]; nodes],
            exhausted: false,
        };
        process.restart();
        process
    }

    /// Restarts with a vector without symmetry, equal in every run, which has a part of every mode.
    fn restart(&mut self) {
        for (i, node) in self.vector.iter_mut().enumerate() {
            for (c, value) in node.iter_mut().enumerate() {
                self.seed = self
                    .seed
                    .wrapping_mul(6_364_136_223_846_793_005)
                    .wrapping_add(1_442_695_040_888_963_407);
                let random = (self.seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5;
                *value = if (self.free)(i, c) { random } else { 0.0 };
            }
        }
    }

    /// Product M x over the free degrees of freedom.
    fn times_mass(&self, x: &[[f64; D]]) -> Vec<[f64; D]> {
        let mut y = vec![[0.0; D]; x.len()];
        self.mass.product(x, &mut y);
        // Fixed components couple through the mass; they take no part.
        for (i, node) in y.iter_mut().enumerate() {
            (0..D)
                .filter(|&c| !(self.free)(i, c))
                .for_each(|c| node[c] = 0.0);
        }
        y
    }

    /// Product of M and the vector, and the length of the vector.
    fn weighted(&self) -> (Vec<[f64; D]>, f64) {
        let weighted = self.times_mass(&self.vector);
        let norm = dot(&self.vector, &weighted).sqrt();
        (weighted, norm)
    }

    /// Extends the basis to `steps` vectors, or until it spans everything.
    fn extend(&mut self, steps: usize) {
        while self.basis.len() < steps && !self.exhausted {
            let (mut weighted, mut norm) = self.weighted();
            let mut coupling = norm;
            let least = 1e-13 * self.diagonal.first().copied().unwrap_or(0.0);
            if !self.basis.is_empty() && norm < least {
                // The space is invariant: the remainder of another vector starts a new one.
                self.restart();
                let before = self.weighted().1;
                self.remove_basis();
                (weighted, norm) = self.weighted();
                coupling = 0.0;
                self.exhausted = norm < SPANNED * before;
            }
            let spans_all = self.basis.len() == self.dimension;
            self.exhausted |= spans_all || norm.is_nan() || norm <= f64::MIN_POSITIVE;
            if !self.exhausted {
                if !self.basis.is_empty() {
                    self.off.push(coupling);
                }
                self.step(weighted, norm);
            }
        }
    }

    /// Adds a vector to the basis and finds the next one.
    fn step(&mut self, weighted: Vec<[f64; D]>, norm: f64) {
        let scale = |x: Vec<[f64; D]>| -> Vec<[f64; D]> {
            x.into_iter().map(|v| v.map(|c| c / norm)).collect()
        };
        self.basis.push(scale(std::mem::take(&mut self.vector)));
        self.basis_mass.push(scale(weighted));
        let last = self.basis.len() - 1;
        self.vector = self.basis_mass[last].clone();
        self.stiffness.solve(&mut self.vector, &mut self.scratch);
        self.diagonal
            .push(dot(&self.vector, &self.basis_mass[last]));
        self.remove_basis();
    }

    /// Removes all earlier directions to rounding; twice is enough (Kahan, Parlett).
    fn remove_basis(&mut self) {
        for _ in 0..2 {
            for (direction, weighted) in self.basis.iter().zip(&self.basis_mass) {
                let along = dot(&self.vector, weighted);
                axpy(&mut self.vector, -along, direction);
            }
        }
    }

    /// Ritz values 1/ω² of the first `size` vectors, s², largest first.
    fn values(&self, size: usize) -> Vec<f64> {
        let couplings = &self.off[..size.saturating_sub(1)];
        let mut values = dense::tridiagonal_eigenvalues(&self.diagonal[..size], couplings);
        values.reverse();
        values
    }
}
