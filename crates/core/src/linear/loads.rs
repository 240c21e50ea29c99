//! Forces on the line that are prescribed for the whole run.
//!
//!   f(t) = Σ sᵢ(t) pᵢ
//!
//! A pattern p of forces on nodes is constant, its size s has a value for the start and one after
//! each step; at the time of balance the scheme weighs old and new values as it does for all
//! others. The work of a step is Δu·f at that time, so the energy balance closes with it.

use crate::error::CoreError;

/// Forces on nodes over time: a constant pattern times a size.
#[derive(Debug, Clone, Default)]
pub struct Load {
    /// Node, component of its coordinates, force for the size 1, N.
    pub pattern: Vec<(usize, usize, f64)>,
    /// Size at the start and after each step.
    pub sizes: Vec<f64>,
}

/// Checks patterns for nodes of `D` coordinates, and the number of sizes.
///
/// # Errors
/// [`CoreError::Input`].
pub(crate) fn check<const D: usize>(
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
    loads: &'a [Load],
    sizes: &'a [f64],
}

impl<'a> Loads<'a> {
    /// Loads, and their sizes at the time of balance.
    #[must_use]
    pub fn new(loads: &'a [Load], sizes: &'a [f64]) -> Self {
        Self { loads, sizes }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.loads.is_empty()
    }

    /// Adds the forces, N. A load of size zero is left out: it would turn a negative zero into a
    /// positive one.
    pub(crate) fn add_to<const D: usize>(&self, f: &mut [[f64; D]]) {
        for (load, size) in self.active() {
            for &(node, c, share) in &load.pattern {
                f[node][c] += size * share;
            }
        }
    }

    /// Returns the work of a step, Δu·f, J.
    pub(crate) fn work<const D: usize>(&self, delta: &[[f64; D]]) -> f64 {
        let work_of = |(load, size): (&Load, f64)| {
            let increment = load
                .pattern
                .iter()
                .map(|&(node, c, share)| share * delta[node][c]);
            size * increment.sum::<f64>()
        };
        self.active().map(work_of).sum()
    }

    /// Returns the nodes that a force acts on in this step, some of them more than once.
    pub(crate) fn nodes(&self) -> impl Iterator<Item = usize> + '_ {
        let patterns = self.active().flat_map(|(load, _)| &load.pattern);
        patterns.map(|&(node, _, _)| node)
    }

    fn active(&self) -> impl Iterator<Item = (&'a Load, f64)> + '_ {
        let pairs = self.loads.iter().zip(self.sizes.iter().copied());
        pairs.filter(|(_, size)| *size != 0.0)
    }
}
