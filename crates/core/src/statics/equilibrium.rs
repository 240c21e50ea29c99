//! Equilibrium as built: unstretched lengths are given, positions are found by Newton's method
//! with the exact tangent. Unilateral links are slack or taut as the shape says (semismooth
//! Newton); a step that makes the balance worse is halved.

use super::assembly::{Geometry, LinkLaw, Shape, largest_residual};
use super::newton::Newton;
use crate::error::CoreError;

/// Bound on Newton iterations; from a design shape one or two suffice, from straight wires about
/// 15.
const MOST_ITERATIONS: usize = 200;

/// Bound on halvings of one step: 2⁻¹⁰ of a step is no progress any more.
const MOST_HALVINGS: usize = 10;

impl<const DIM: usize, const D: usize> Geometry<DIM, D> {
    /// Degrees of freedom that move in service.
    #[must_use]
    pub fn service_mask(&self) -> Vec<[bool; D]> {
        let s = &self.structure;
        let mut free = vec![[true; D]; self.nodes()];
        s.fixed.iter().for_each(|&(node, c)| free[node][c] = false);
        s.ends
            .iter()
            .for_each(|end| free[end.node][0] = end.released);
        self.fix_unused(&mut free);
        free
    }

    /// Fixes the positions of nodes that only hold a slope.
    pub(super) fn fix_unused(&self, free: &mut [[bool; D]]) {
        let mut used = vec![[false; 2]; free.len()];
        let s = &self.structure;
        let slots = s
            .wires
            .iter()
            .flat_map(crate::structure::Wire::coordinate_slots);
        slots.for_each(|(node, slot)| used[node][slot] = true);
        let chains = s.segments.iter().flat_map(|k| k.nodes);
        chains.for_each(|node| used[node][0] = true);
        for (mask, used) in free.iter_mut().zip(used) {
            for c in 0..D {
                mask[c] &= used[c / DIM];
            }
        }
    }

    /// Computes the residual in service: internal minus external forces, N.
    pub fn service_residual(&self, shape: &Shape<D>, law: LinkLaw, residual: &mut Shape<D>) {
        self.wire_and_weight_residual(shape, residual);
        self.add_link_and_support_forces(shape, law, residual);
        for end in self.structure.ends.iter().filter(|e| e.released) {
            residual[end.node][0] -= end.force;
        }
    }

    /// Finds the equilibrium near `start`.
    ///
    /// # Errors
    /// [`CoreError::NoEquilibrium`], [`CoreError::Singular`] or [`CoreError::Unstable`].
    pub fn find_equilibrium(&self, start: &Shape<D>) -> Result<Shape<D>, CoreError> {
        let free = self.service_mask();
        let tolerance = self.force_rounding();
        let mut shape = start.clone();
        let mut residual = vec![[0.0; D]; self.nodes()];
        let mut k = self.empty_matrix();
        let mut newton = Newton::new(&k, &free);
        self.service_residual(&shape, LinkLaw::Unilateral, &mut residual);
        let mut worst = largest_residual(&residual, &free);
        let mut iterations = 0;
        for iteration in 0..MOST_ITERATIONS {
            iterations = iteration + 1;
            self.tangent(&shape, LinkLaw::Unilateral, &mut k);
            if worst.0 <= Self::rounding_after(iteration, tolerance) {
                return match newton.factorise(&mut k)?.negative_pivots() {
                    0 => Ok(shape),
                    directions => Err(CoreError::Unstable { directions }),
                };
            }
            let mut target = shape.clone();
            newton.step(&mut k, &residual, &mut target)?;
            worst = self.line_search(&mut shape, &target, &free, &mut residual);
            if !worst.0.is_finite() {
                break;
            }
        }
        Err(CoreError::NoEquilibrium {
            iterations,
            residual: worst.0,
            node: worst.1,
            tolerance,
        })
    }

    /// Moves towards `target`, with halved steps while the sum of squares of the residual grows;
    /// returns the largest residual, N, and its node.
    fn line_search(
        &self,
        shape: &mut Shape<D>,
        target: &Shape<D>,
        free: &[[bool; D]],
        residual: &mut Shape<D>,
    ) -> (f64, usize) {
        let before = sum_of_squares(residual, free);
        let start = shape.clone();
        let mut fraction = 1.0;
        for _ in 0..=MOST_HALVINGS {
            for (node, (a, b)) in shape.iter_mut().zip(start.iter().zip(target)) {
                for c in 0..D {
                    node[c] = a[c] + fraction * (b[c] - a[c]);
                }
            }
            self.service_residual(shape, LinkLaw::Unilateral, residual);
            if sum_of_squares(residual, free) <= before {
                break;
            }
            fraction *= 0.5;
        }
        largest_residual(residual, free)
    }
}

fn sum_of_squares<const D: usize>(residual: &Shape<D>, free: &[[bool; D]]) -> f64 {
    let pairs = residual.iter().flatten().zip(free.iter().flatten());
    pairs.map(|(r, &f)| if f { r * r } else { 0.0 }).sum()
}
