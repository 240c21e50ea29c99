//! Newton steps on the free degrees of freedom, K Δ = −R, with one pattern.
//!
//! The fill of the factor and the held entries are found once and kept.

use super::assembly::Shape;
use crate::error::CoreError;
use crate::linalg::{BlockLdl, HeldEntry, Refactoring, SymmetricBlocks};

/// Newton solver: data kept from one step to the next.
pub(super) struct Newton<'a, const D: usize> {
    free: &'a [[bool; D]],
    held: Vec<HeldEntry>,
    factor: Option<(BlockLdl<D>, Refactoring<D>)>,
    correction: Shape<D>,
    scratch: Shape<D>,
}

impl<'a, const D: usize> Newton<'a, D> {
    /// Solver for matrices with the pattern of `k`, and the degrees of freedom that can move.
    pub(super) fn new(k: &SymmetricBlocks<D>, free: &'a [[bool; D]]) -> Self {
        let vector = vec![[0.0; D]; free.len()];
        Self {
            free,
            held: k.held(free),
            factor: None,
            correction: vector.clone(),
            scratch: vector,
        }
    }

    /// Fixes the held degrees of freedom, and factorises.
    pub(super) fn factorise(
        &mut self,
        k: &mut SymmetricBlocks<D>,
    ) -> Result<&BlockLdl<D>, CoreError> {
        k.hold(&self.held);
        let (factor, refactoring) = match self.factor.take() {
            Some((mut factor, mut refactoring)) => {
                factor.refactorise(&mut refactoring, k)?;
                (factor, refactoring)
            }
            None => (BlockLdl::new(k)?, Refactoring::new(k)),
        };
        Ok(&self.factor.insert((factor, refactoring)).0)
    }

    /// Takes one step from `shape`, which has the given residual and tangent.
    pub(super) fn step(
        &mut self,
        k: &mut SymmetricBlocks<D>,
        residual: &Shape<D>,
        shape: &mut Shape<D>,
    ) -> Result<(), CoreError> {
        self.factorise(k)?;
        self.step_again(residual, shape);
        Ok(())
    }

    /// Takes one step from `shape`, which has the given residual, with the factor of the step
    /// before.
    pub(super) fn step_again(&mut self, residual: &Shape<D>, shape: &mut Shape<D>) {
        let free = residual.iter().zip(self.free);
        for (value, (force, mask)) in self.correction.iter_mut().zip(free) {
            (0..D).for_each(|c| value[c] = if mask[c] { force[c] } else { 0.0 });
        }
        if let Some((factor, _)) = &self.factor {
            factor.solve(&mut self.correction, &mut self.scratch);
        }
        for (node, delta) in shape.iter_mut().zip(&self.correction) {
            (0..D).for_each(|c| node[c] -= delta[c]);
        }
    }
}
