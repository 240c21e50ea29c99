//! Sparse LDLᵀ factorisation by node blocks, in the order the nodes are given.
//!
//! With the nodes ordered station by station along the track the factor stays as narrow as the
//! line has wires. Row form: with `A = L D Lᵀ`,
//!
//!   Wᵢⱼ = Aᵢⱼ − Σₖ₍ₖ₍ⱼ₎ Wᵢₖ Lⱼₖᵀ,   Lᵢⱼ = Wᵢⱼ Dⱼ⁻¹,   Dᵢ = Aᵢᵢ − Σₖ Wᵢₖ Lᵢₖᵀ.

use super::block::{self, Block, zero};
use super::symmetric::SymmetricBlocks;
use crate::error::CoreError;

/// Factor of a symmetric block matrix.
#[derive(Debug, Clone)]
pub struct BlockLdl<const D: usize> {
    row_start: Vec<usize>,
    columns: Vec<u32>,
    lower: Vec<Block<D>>,
    diagonal_inverse: Vec<Block<D>>,
    negative_pivots: usize,
}

impl<const D: usize> BlockLdl<D> {
    /// Analyse the pattern (fill-in) and factorise.
    ///
    /// # Errors
    /// [`CoreError::Singular`] when a pivot block has no inverse.
    pub fn new(a: &SymmetricBlocks<D>) -> Result<Self, CoreError> {
        let (row_start, columns) = fill_pattern(a);
        let mut factor = Self {
            lower: vec![zero(); columns.len()],
            diagonal_inverse: vec![zero(); a.rows()],
            row_start,
            columns,
            negative_pivots: 0,
        };
        factor.refactor(a)?;
        Ok(factor)
    }

    /// Factorise a matrix of the pattern that was analysed.
    ///
    /// # Errors
    /// [`CoreError::Singular`] when a pivot block has no inverse.
    pub fn refactor(&mut self, a: &SymmetricBlocks<D>) -> Result<(), CoreError> {
        self.negative_pivots = 0;
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
                self.subtract_common(&mut w, &work, start..p, j);
                self.lower[p] = block::product(&w, &self.diagonal_inverse[j]);
                work.push(w);
            }
            let mut d = a.blocks[next];
            for (p, w) in row.zip(&work) {
                block::subtract_product_transposed(&mut d, w, &self.lower[p]);
            }
            let (inverse, negative) = block::inverse(&d).ok_or(CoreError::Singular { node: i })?;
            self.diagonal_inverse[i] = inverse;
            self.negative_pivots += negative;
        }
        Ok(())
    }

    /// `w −= Σ Wᵢₖ Lⱼₖᵀ` over the columns k that row i (so far) and row j share.
    fn subtract_common(
        &self,
        w: &mut Block<D>,
        work: &[Block<D>],
        row_i: std::ops::Range<usize>,
        j: usize,
    ) {
        let mut q = self.row_start[j];
        let end = self.row_start[j + 1];
        for (offset, p) in row_i.enumerate() {
            let k = self.columns[p];
            while q < end && self.columns[q] < k {
                q += 1;
            }
            if q < end && self.columns[q] == k {
                block::subtract_product_transposed(w, &work[offset], &self.lower[q]);
            }
        }
    }

    /// Number of negative pivots: zero exactly when the matrix is positive definite.
    #[must_use]
    pub fn negative_pivots(&self) -> usize {
        self.negative_pivots
    }

    /// Blocks stored below the diagonal; the work of a solve is proportional to it.
    #[must_use]
    pub fn fill(&self) -> usize {
        self.lower.len()
    }

    /// Solve `A x = b` in place: forward with L, D⁻¹, backward with Lᵀ.
    pub fn solve(&self, x: &mut [[f64; D]]) {
        let n = self.diagonal_inverse.len();
        for i in 0..n {
            let mut sum = x[i];
            for p in self.row_start[i]..self.row_start[i + 1] {
                let l = &self.lower[p];
                let xj = &x[self.columns[p] as usize];
                for a in 0..D {
                    let mut dot = 0.0;
                    for b in 0..D {
                        dot += l[a][b] * xj[b];
                    }
                    sum[a] -= dot;
                }
            }
            x[i] = sum;
        }
        for (value, inverse) in x.iter_mut().zip(&self.diagonal_inverse) {
            // Column form (the inverse is symmetric): the lanes of the sum are independent.
            let mut z = [0.0; D];
            for b in 0..D {
                for a in 0..D {
                    z[a] += inverse[b][a] * value[b];
                }
            }
            *value = z;
        }
        for i in (0..n).rev() {
            let xi = x[i];
            for p in self.row_start[i]..self.row_start[i + 1] {
                let xj = &mut x[self.columns[p] as usize];
                block::subtract_transposed_product(xj, &self.lower[p], &xi);
            }
        }
    }
}

/// Columns of the strictly lower rows of L: the row pattern from the elimination tree.
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
