//! Sparse LDLᵀ factorisation by node blocks, in the order the nodes are given.
//!
//! With the nodes ordered station by station along the track the factor stays as narrow as the
//! line has wires. Row form: with `A = L D Lᵀ`,
//!
//!   Wᵢⱼ = Aᵢⱼ − Σ₍ₖ﹤ⱼ₎ Wᵢₖ Lⱼₖᵀ,   Lᵢⱼ = Wᵢⱼ Dⱼ⁻¹,   Dᵢ = Aᵢᵢ − Σₖ Wᵢₖ Lᵢₖᵀ.
//!
//! A solve is bound by its chain of dependent operations, so the nodes of each
//! [island](super::islands) are eliminated from both ends in turn: two chains that do not depend on
//! each other run side by side and meet in the middle, where the only extra fill is.

use super::block::{self, Block, zero};
use super::islands::islands;
use super::substitution::Substitution;
use super::symmetric::SymmetricBlocks;
use crate::error::CoreError;
use std::ops::Range;

/// Factor of a symmetric block matrix.
#[derive(Debug, Clone)]
pub struct BlockLdl<const D: usize> {
    /// Node eliminated at each position.
    order: Vec<u32>,
    row_start: Vec<usize>,
    columns: Vec<u32>,
    /// Pairs of blocks whose product is subtracted from each block of the factor: one of the same
    /// row (counted from the start of the row) and one of the row of its column.
    pair_start: Vec<usize>,
    pairs: Vec<(u32, u32)>,
    lower: Vec<Block<D>>,
    diagonal_inverse: Vec<Block<D>>,
    substitution: Substitution<D>,
    negative_pivots: usize,
}

/// Order of elimination island by island: first, last, second, last but one, …
fn from_both_ends<const D: usize>(a: &SymmetricBlocks<D>) -> Vec<u32> {
    let inwards = |nodes: Range<usize>| {
        (0..nodes.len()).map(move |i| {
            let node = if i % 2 == 0 {
                nodes.start + i / 2
            } else {
                nodes.end - 1 - i / 2
            };
            node as u32
        })
    };
    islands(a).into_iter().flat_map(inwards).collect()
}

/// Matrix in the order of elimination, to be factorised repeatedly with other values.
#[derive(Debug, Clone)]
pub struct Refactoring<const D: usize> {
    /// Node eliminated at each position.
    order: Vec<u32>,
    reordered: SymmetricBlocks<D>,
    /// Index of each block of the given matrix in the reordered one, and whether it is transposed.
    indices: Vec<(usize, bool)>,
}

impl<const D: usize> Refactoring<D> {
    /// Reordering for matrices with the pattern of `a`.
    #[must_use]
    pub fn new(a: &SymmetricBlocks<D>) -> Self {
        let order = from_both_ends(a);
        let mut position = vec![0; order.len()];
        order
            .iter()
            .enumerate()
            .for_each(|(i, &node)| position[node as usize] = i);
        let entries = || {
            (0..a.rows()).flat_map(|i| (a.row_start[i]..a.row_start[i + 1]).map(move |k| (i, k)))
        };
        let pairs = entries().map(|(i, k)| (position[i], position[a.columns[k]]));
        let reordered = SymmetricBlocks::with_pattern(a.rows(), pairs);
        let index = |(i, k): (usize, usize)| {
            let (row, column) = (position[i], position[a.columns[k]]);
            let index = reordered.index_of(row.max(column), row.min(column));
            // Every pair was put into the pattern above.
            (index.unwrap_or_default(), row < column)
        };
        let indices = entries().map(index).collect();
        Self {
            order,
            reordered,
            indices,
        }
    }

    /// Copies the values of a matrix.
    fn copy_from(&mut self, a: &SymmetricBlocks<D>) {
        for (block, &(index, transposed)) in a.blocks.iter().zip(&self.indices) {
            self.reordered.blocks[index] = if transposed {
                block::transpose(block)
            } else {
                *block
            };
        }
    }
}

impl<const D: usize> BlockLdl<D> {
    /// Analyses the pattern (fill-in) and factorises.
    ///
    /// # Errors
    /// [`CoreError::Singular`] when a pivot block has no inverse.
    pub fn new(a: &SymmetricBlocks<D>) -> Result<Self, CoreError> {
        let mut refactoring = Refactoring::new(a);
        let (row_start, columns) = fill_pattern(&refactoring.reordered);
        let (pair_start, pairs) = common_columns(&row_start, &columns);
        let order = refactoring.order.clone();
        let mut factor = Self {
            substitution: Substitution::new(&order, &row_start, &columns),
            pair_start,
            pairs,
            lower: vec![zero(); columns.len()],
            diagonal_inverse: vec![zero(); a.rows()],
            negative_pivots: 0,
            order,
            row_start,
            columns,
        };
        factor.refactorise(&mut refactoring, a)?;
        Ok(factor)
    }

    /// Factorises a matrix of equal pattern, which replaces the old one.
    ///
    /// # Errors
    /// [`CoreError::Singular`] when a pivot block has no inverse.
    pub fn refactorise(
        &mut self,
        refactoring: &mut Refactoring<D>,
        a: &SymmetricBlocks<D>,
    ) -> Result<(), CoreError> {
        refactoring.copy_from(a);
        self.negative_pivots = 0;
        self.factorise(&refactoring.reordered)?;
        self.substitution.fill(&self.lower, &self.diagonal_inverse);
        Ok(())
    }

    /// Factorises the reordered matrix.
    fn factorise(&mut self, a: &SymmetricBlocks<D>) -> Result<(), CoreError> {
        let mut work: Vec<Block<D>> = Vec::new();
        for i in 0..a.rows() {
            let start = self.row_start[i];
            let row = start..self.row_start[i + 1];
            work.clear();
            let mut next = a.row_start[i];
            for p in row.clone() {
                let j = self.columns[p] as usize;
                let mut w = zero();
                if a.columns[next] == j {
                    w = a.blocks[next];
                    next += 1;
                }
                for &(of_row, other) in &self.pairs[self.pair_start[p]..self.pair_start[p + 1]] {
                    let other = &self.lower[other as usize];
                    block::subtract_product_transposed(&mut w, &work[of_row as usize], other);
                }
                self.lower[p] = block::product(&w, &self.diagonal_inverse[j]);
                work.push(w);
            }
            let mut d = a.blocks[next];
            for (p, w) in row.zip(&work) {
                block::subtract_product_transposed(&mut d, w, &self.lower[p]);
            }
            let node = self.order[i] as usize;
            let (inverse, negative) = block::inverse(&d).ok_or(CoreError::Singular { node })?;
            self.diagonal_inverse[i] = inverse;
            self.negative_pivots += negative;
        }
        Ok(())
    }

    /// Number of negative pivots: zero exactly when the matrix is positive definite.
    #[must_use]
    pub fn negative_pivots(&self) -> usize {
        self.negative_pivots
    }

    /// Number of blocks stored below the diagonal; the work of a solve is proportional to it.
    #[must_use]
    pub fn fill(&self) -> usize {
        self.lower.len()
    }

    /// Solves `A x = b` in place; `work` is scratch space of equal length.
    pub fn solve(&self, x: &mut [[f64; D]], work: &mut [[f64; D]]) {
        self.substitution.solve(0..x.len(), x, &[], work);
    }

    /// Solves for an `x` that is zero except at the nodes `loaded`, and is wanted there alone: the
    /// values are those of [`solve`](Self::solve). `work` is scratch space of equal length.
    pub fn solve_at(&self, x: &mut [[f64; D]], loaded: &[usize], work: &mut [[f64; D]]) {
        self.substitution.solve_behind(x, loaded, work);
    }

    /// Solves and subtracts, `x ← A⁻¹ x − minus`, on some islands, without another pass over the
    /// vectors. The values of other nodes are neither read nor written.
    pub fn solve_minus(
        &self,
        islands: impl Iterator<Item = Range<usize>>,
        x: &mut [[f64; D]],
        minus: &[[f64; D]],
        work: &mut [[f64; D]],
    ) {
        for nodes in islands {
            self.substitution.solve(nodes, x, minus, work);
        }
    }

    /// Solves for an `x` that is zero except at the nodes `loaded`, as far as the solution is not
    /// negligible (1e-30 of the largest value is taken as zero). Returns the nodes outside of which
    /// the solution is zero. `work`, of equal length, is zero before and after.
    pub fn solve_near(
        &self,
        x: &mut [[f64; D]],
        loaded: &[usize],
        work: &mut [[f64; D]],
    ) -> std::ops::Range<usize> {
        self.substitution.solve_near(x, loaded, work)
    }
}

/// Columns of the strictly lower rows of L, the row pattern from the elimination tree.
/// Source: Davis, Direct Methods for Sparse Linear Systems (2006), section 4.1 (`cs_ereach`).
fn fill_pattern<const D: usize>(a: &SymmetricBlocks<D>) -> (Vec<usize>, Vec<u32>) {
    let n = a.rows();
    let mut parent = vec![usize::MAX; n];
    let mut mark = vec![usize::MAX; n];
    let mut row_start = vec![0];
    let mut columns = Vec::new();
    for i in 0..n {
        mark[i] = i;
        let begin = columns.len();
        for k in a.row_start[i]..a.row_start[i + 1] - 1 {
            let mut j = a.columns[k];
            while mark[j] != i {
                mark[j] = i;
                columns.push(j as u32);
                if parent[j] == usize::MAX {
                    parent[j] = i;
                }
                j = parent[j];
            }
        }
        columns[begin..].sort_unstable();
        row_start.push(columns.len());
    }
    (row_start, columns)
}

/// Common columns k of the rows i and j of each block (i, j), over which Σ Wᵢₖ Lⱼₖᵀ runs: indices
/// of the blocks.
fn common_columns(row_start: &[usize], columns: &[u32]) -> (Vec<usize>, Vec<(u32, u32)>) {
    let (mut start, mut pairs) = (vec![0], Vec::new());
    for row in row_start.windows(2) {
        for p in row[0]..row[1] {
            let j = columns[p] as usize;
            let mut q = row_start[j];
            for (of_row, k) in columns[row[0]..p].iter().enumerate() {
                while q < row_start[j + 1] && columns[q] < *k {
                    q += 1;
                }
                if q < row_start[j + 1] && columns[q] == *k {
                    pairs.push((of_row as u32, q as u32));
                }
            }
            start.push(pairs.len());
        }
    }
    (start, pairs)
}
