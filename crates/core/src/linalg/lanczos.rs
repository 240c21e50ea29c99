//! Lowest natural frequencies: Lanczos on K⁻¹M in the inner product of M.
//!
//! K φ = ω² M φ  ⇔  K⁻¹M φ = ω⁻² φ, and K⁻¹M is self-adjoint for ⟨x, y⟩ = xᵀM y.
//! Full reorthogonalisation: the basis stays small (a few hundred vectors) and no ghost values
//! appear. Source: Golub & Van Loan, Matrix Computations, sections 10.3 and 10.1.

use super::{BlockLdl, MassMatrix, dense};

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

/// The `count` lowest natural frequencies in Hz, ascending. `steps` Lanczos steps are made, and
/// the Ritz values below are accurate when `steps` is several times `count`.
///
/// `free(node, component)` tells whether a degree of freedom can move.
#[must_use]
pub fn lowest_frequencies<const DIM: usize, const D: usize>(
    stiffness: &BlockLdl<D>,
    mass: &MassMatrix<DIM, D>,
    nodes: usize,
    free: impl Fn(usize, usize) -> bool,
    count: usize,
    steps: usize,
) -> Vec<f64> {
    // A start vector without symmetry, the same in every run: it has a part of every mode. Of
    // modes with exactly the same frequency (two equal wires apart) one is found.
    let mut seed = 0x9E37_79B9_7F4A_7C15_u64;
    let mut start = vec![[0.0; D]; nodes];
    for (i, node) in start.iter_mut().enumerate() {
        for (c, value) in node.iter_mut().enumerate() {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            let random = (seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5;
            *value = if free(i, c) { random } else { 0.0 };
        }
    }
    let times_mass = |x: &[[f64; D]]| {
        let mut y = vec![[0.0; D]; nodes];
        mass.product(x, &mut y);
        // Fixed components couple through the mass; they take no part.
        for (i, node) in y.iter_mut().enumerate() {
            (0..D).filter(|&c| !free(i, c)).for_each(|c| node[c] = 0.0);
        }
        y
    };
    let mut basis: Vec<Vec<[f64; D]>> = Vec::new();
    let mut basis_mass: Vec<Vec<[f64; D]>> = Vec::new();
    let (mut diagonal, mut off) = (Vec::new(), Vec::new());
    let mut vector = start;
    let mut scratch = vec![[0.0; D]; nodes];
    for _ in 0..steps {
        let weighted = times_mass(&vector);
        let norm = dot(&vector, &weighted).sqrt();
        if norm.is_nan() || norm <= f64::MIN_POSITIVE {
            break;
        }
        if !basis.is_empty() {
            // An invariant subspace is exhausted: nothing new would follow.
            if norm < 1e-13 * diagonal.first().copied().unwrap_or(1.0) {
                break;
            }
            off.push(norm);
        }
        let scale = |x: Vec<[f64; D]>| -> Vec<[f64; D]> {
            x.into_iter().map(|v| v.map(|c| c / norm)).collect()
        };
        basis.push(scale(vector));
        basis_mass.push(scale(weighted));
        let last = basis.len() - 1;
        vector = basis_mass[last].clone();
        stiffness.solve(&mut vector, &mut scratch);
        diagonal.push(dot(&vector, &basis_mass[last]));
        // Twice is enough (Kahan, Parlett): removes all earlier directions to rounding.
        for _ in 0..2 {
            for k in 0..basis.len() {
                let along = dot(&vector, &basis_mass[k]);
                axpy(&mut vector, -along, &basis[k]);
            }
        }
    }
    let values =
        dense::tridiagonal_eigenvalues(&diagonal, &off[..diagonal.len().saturating_sub(1)]);
    values
        .iter()
        .rev()
        .take(count)
        .filter(|&&v| v > 0.0)
        .map(|v| 1.0 / (v.sqrt() * std::f64::consts::TAU))
        .collect()
}
