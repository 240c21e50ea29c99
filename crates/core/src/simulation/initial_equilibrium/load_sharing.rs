//! Sharing of a given force among contacts at rest.
//!
//!   0 ≤ λ  ⊥  q + H λ − a z ≥ 0,   Σ λ = F
//!
//! z is the level of the pantograph, H the compliance of wires, contacts and pantograph, q the gaps
//! at λ = 0 and z = 0. For given z this is a complementarity problem, and Σ λ grows with z along
//! straight pieces: on a piece with the contacts S closed by 1ᵀ H_SS⁻¹ a_S. So Newton's method in z
//! ends after some pieces; a step that leaves the bracket is replaced by half of it.

use crate::error::CoreError;
use crate::lcp::LcpSolver;
use crate::linalg::dense;

/// Bound on Newton steps: far more than there are pieces on the way.
const MOST_STEPS: usize = 200;
/// Rounding of the complementarity problems, as a share of the force.
const ROUNDING: f64 = 1e-12;

/// Returns λ and z; `None` when the contacts cannot carry the force.
pub(crate) fn share_load(h: &[f64], q: &[f64], a: &[f64], total: f64) -> Option<(Vec<f64>, f64)> {
    let n = q.len();
    let touching_height: Vec<f64> = q.iter().zip(a).map(|(q, a)| q / a).collect();
    let first = (0..n).min_by(|&i, &j| touching_height[i].total_cmp(&touching_height[j]))?;
    if a.iter().any(|&a| a <= 0.0) || total < 0.0 {
        return None;
    }
    let (mut z, mut bracket) = (
        touching_height[first],
        [touching_height[first], f64::INFINITY],
    );
    let (mut x, mut y, mut solver) = (vec![0.0; n], vec![0.0; n], LcpSolver::new());
    let mut closed = vec![first];
    for _ in 0..MOST_STEPS {
        let sum: f64 = x.iter().sum();
        if (sum - total).abs() <= ROUNDING * total {
            return Some((x, z));
        }
        bracket[usize::from(sum > total)] = z;
        let newton = z + (total - sum) / slope(h, a, &closed)?;
        let is_in_bracket = bracket[0] < newton && newton < bracket[1];
        z = if is_in_bracket {
            newton
        } else {
            0.5 * (bracket[0] + bracket[1])
        };
        let w: Vec<f64> = q.iter().zip(a).map(|(q, a)| q - a * z).collect();
        solver.solve(h, &w, &mut x, &mut y, &[]).ok()?;
        closed = (0..n).filter(|&i| x[i] > 0.0).collect();
        if closed.is_empty() {
            closed.push(first);
        }
    }
    None
}

/// Returns the slope 1ᵀ H_SS⁻¹ a_S of Σ λ over z, N/m.
fn slope(h: &[f64], a: &[f64], closed: &[usize]) -> Option<f64> {
    let row = |&i: &usize| closed.iter().map(move |&j| h[i * a.len() + j]);
    let mut matrix: Vec<f64> = closed.iter().flat_map(row).collect();
    let mut x: Vec<f64> = closed.iter().map(|&i| a[i]).collect();
    let is_regular = dense::solve_in_place(&mut matrix, &mut x);
    let slope: f64 = x.iter().sum();
    (is_regular && slope > 0.0).then_some(slope)
}

pub(crate) fn cannot_share() -> CoreError {
    CoreError::Input {
        array: "pantographs",
        reason: "contacts at rest cannot share the force".into(),
    }
}
