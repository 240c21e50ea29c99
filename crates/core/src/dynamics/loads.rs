//! Forces on the line that are given for the whole run.
//!
//!   f(t) = Σ sᵢ(t) pᵢ
//!
//! A pattern p of forces on nodes stays, its size s has a value for the start and one after each
//! step; at the time of balance the scheme weighs old and new as it does everywhere. The work of a
//! step is Δu·f at that time, so it closes the ledger as the balance itself does.

use crate::error::CoreError;

/// Forces on nodes over time: a pattern, and how much of it.
#[derive(Debug, Clone, Default)]
pub struct Load {
    /// Node, component of its coordinates, force for the size 1.
    pub pattern: Vec<(usize, usize, f64)>,
    /// Size at the start and after each step.
    pub sizes: Vec<f64>,
}

/// Check patterns for nodes of `D` coordinates, and that there is a size for each instant.
///
/// # Errors
/// [`CoreError::Input`].
pub(super) fn check<const D: usize>(
    loads: &[Load],
    nodes: usize,
    instants: usize,
) -> Result<(), CoreError> {
    let sound = |load: &Load| {
        let inside =
            |&(node, c, share): &(usize, usize, f64)| node < nodes && c < D && share.is_finite();
        load.sizes.len() == instants
            && load.sizes.iter().all(|size| size.is_finite())
            && load.pattern.iter().all(inside)
    };
    match loads.iter().position(|load| !sound(load)) {
        None => Ok(()),
        Some(index) => {
            let reason = format!("load {index}: not one size for each instant, or not finite");
            let array = "loads";
            Err(CoreError::Input { array, reason })
        }
    }
}

/// Loads with their sizes at the time of balance of a step.
#[derive(Debug, Clone, Copy)]
pub struct Loads<'a> {
    given: &'a [Load],
    sizes: &'a [f64],
}

impl<'a> Loads<'a> {
    /// Loads, and the size of each of them.
    #[must_use]
    pub fn new(given: &'a [Load], sizes: &'a [f64]) -> Self {
        Self { given, sizes }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.given.is_empty()
    }

    /// Add the forces; a load of size zero adds nothing, not even to a negative zero.
    pub(super) fn add_to<const D: usize>(&self, f: &mut [[f64; D]]) {
        for (load, size) in self.acting() {
            for &(node, c, share) in &load.pattern {
                f[node][c] += size * share;
            }
        }
    }

    /// Work of a step on the increment of the line, J.
    pub(super) fn work<const D: usize>(&self, delta: &[[f64; D]]) -> f64 {
        let of = |(load, size): (&Load, f64)| {
            let moved = load
                .pattern
                .iter()
                .map(|&(node, c, share)| share * delta[node][c]);
            size * moved.sum::<f64>()
        };
        self.acting().map(of).sum()
    }

    /// Nodes that a force acts on in this step, some of them more than once.
    pub(super) fn nodes(&self) -> impl Iterator<Item = usize> + '_ {
        let patterns = self.acting().flat_map(|(load, _)| &load.pattern);
        patterns.map(|&(node, _, _)| node)
    }

    fn acting(&self) -> impl Iterator<Item = (&'a Load, f64)> + '_ {
        let pairs = self.given.iter().zip(self.sizes.iter().copied());
        pairs.filter(|(_, size)| *size != 0.0)
    }
}
