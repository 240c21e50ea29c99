//! Influence columns A⁻¹c, kept only where they are not negligible.
//!
//! With a time step of a millisecond the influence of a force decays over a few nodes, so a
//! column is a short window of nodes. Values below [`CUT`] of its peak are cut.

use crate::linalg::{BlockLdl, Kernel, widest};
use std::ops::Range;

/// Fraction of a column's peak below which values are cut: rounding of one solve. A larger one
/// would unbalance the forces, a smaller one stores noise.
const CUT: f64 = 1e-17;

/// Compliance columns A⁻¹c, one after the other in one piece of memory.
#[derive(Debug, Clone)]
pub struct ComplianceColumns<const D: usize> {
    windows: Vec<Window>,
    values: Vec<[f64; D]>,
}

#[derive(Debug, Clone, Copy, Default)]
struct Window {
    first: usize,
    offset: usize,
    length: usize,
}

impl<const D: usize> ComplianceColumns<D> {
    /// Creates `count` columns of zeros.
    #[must_use]
    pub fn new(count: usize) -> Self {
        Self {
            windows: vec![Window::default(); count],
            values: Vec::new(),
        }
    }

    /// Returns the number of columns.
    #[must_use]
    pub fn count(&self) -> usize {
        self.windows.len()
    }

    /// Deletes all columns.
    pub fn forget(&mut self) {
        self.windows.fill(Window::default());
        self.values.clear();
    }

    /// Returns whether a column has been set.
    #[must_use]
    pub fn has(&self, column: usize) -> bool {
        self.windows[column].length > 0
    }

    /// Solves for a load, given node by node, and stores the column. `x` and `work` are zero before
    /// and after: two vectors of the size of the line.
    pub fn set(
        &mut self,
        column: usize,
        factor: &BlockLdl<D>,
        load: &[(usize, [f64; D])],
        [x, work]: [&mut [[f64; D]]; 2],
    ) {
        load.iter().for_each(|(node, force)| x[*node] = *force);
        let loaded: Vec<usize> = load.iter().map(|(node, _)| *node).collect();
        let nonzero = factor.solve_near(x, &loaded, work);
        let solution = &mut x[nonzero.clone()];
        let size = |v: &[f64; D]| v.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        let peak = solution.iter().map(size).fold(0.0, f64::max);
        let is_kept = |v: &[f64; D]| size(v) > CUT * peak;
        let first = solution.iter().position(is_kept).unwrap_or(0);
        let end = solution.iter().rposition(is_kept).map_or(first, |i| i + 1);
        self.windows[column] = Window {
            first: nonzero.start + first,
            offset: self.values.len(),
            length: end - first,
        };
        self.values.extend_from_slice(&solution[first..end]);
        solution.fill([0.0; D]);
    }

    /// Stores a column that is given node by node.
    pub fn keep(&mut self, column: usize, values: &std::collections::BTreeMap<usize, [f64; D]>) {
        let (Some((&first, _)), Some((&last, _))) = (values.iter().next(), values.iter().last())
        else {
            return;
        };
        self.windows[column] = Window {
            first,
            offset: self.values.len(),
            length: last + 1 - first,
        };
        let at = |node: usize| values.get(&node).copied().unwrap_or([0.0; D]);
        self.values.extend((first..=last).map(at));
    }

    /// Returns the value of a column at a node.
    #[inline(always)]
    #[must_use]
    pub fn at(&self, column: usize, node: usize) -> [f64; D] {
        let w = &self.windows[column];
        match node.checked_sub(w.first) {
            Some(k) if k < w.length => self.values[w.offset + k],
            _ => [0.0; D],
        }
    }

    /// Adds `factor` · column to `x`; returns the nodes that this changed.
    #[inline(always)]
    pub fn add(&self, column: usize, factor: f64, x: &mut [[f64; D]]) -> Range<usize> {
        let w = &self.windows[column];
        let nodes = w.first..w.first + w.length;
        widest(Add {
            target: x[nodes.clone()].as_flattened_mut(),
            values: self.values[w.offset..w.offset + w.length].as_flattened(),
            factor,
        });
        nodes
    }

    /// Returns the number of stored values.
    #[must_use]
    pub fn stored(&self) -> usize {
        self.values.len() * D
    }
}

struct Add<'a> {
    target: &'a mut [f64],
    values: &'a [f64],
    factor: f64,
}

impl Kernel for Add<'_> {
    #[inline(always)]
    fn run(self) {
        for (a, b) in self.target.iter_mut().zip(self.values) {
            *a += self.factor * b;
        }
    }
}
