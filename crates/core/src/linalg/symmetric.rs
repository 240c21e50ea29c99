//! Symmetric matrix of node blocks; only the lower triangle is stored, row by row.

use super::block::{Block, zero};

/// Symmetric block matrix. Row `i` holds its blocks of columns `j ≤ i`, sorted, the diagonal last.
#[derive(Debug, Clone, Default)]
pub struct SymmetricBlocks<const D: usize> {
    /// Start of each row in `columns` and `blocks`; one entry more than there are rows.
    pub row_start: Vec<usize>,
    /// Column of each block.
    pub columns: Vec<usize>,
    /// Blocks of the lower triangle.
    pub blocks: Vec<Block<D>>,
}

/// Entry of a matrix at a held degree of freedom: block, row and column in it, and its value, zero
/// or one.
#[derive(Debug, Clone, Copy)]
pub struct HeldEntry {
    block: usize,
    a: usize,
    b: usize,
    value: f64,
}

impl<const D: usize> SymmetricBlocks<D> {
    /// Matrix of zeros with the given node pairs, and all diagonals, in its pattern.
    #[must_use]
    pub fn with_pattern(n: usize, pairs: impl IntoIterator<Item = (usize, usize)>) -> Self {
        let mut entries: Vec<(usize, usize)> = (0..n).map(|i| (i, i)).collect();
        entries.extend(pairs.into_iter().map(|(i, j)| (i.max(j), i.min(j))));
        entries.sort_unstable();
        entries.dedup();
        let mut row_start = vec![0; n + 1];
        entries.iter().for_each(|&(i, _)| row_start[i + 1] += 1);
        (0..n).for_each(|i| row_start[i + 1] += row_start[i]);
        let columns: Vec<usize> = entries.into_iter().map(|(_, j)| j).collect();
        let blocks = vec![zero(); columns.len()];
        Self {
            row_start,
            columns,
            blocks,
        }
    }

    /// Number of node rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.row_start.len() - 1
    }

    /// Sets every entry to zero and keeps the pattern.
    pub fn clear(&mut self) {
        self.blocks.fill(zero());
    }

    /// Index of block (i, j), i ≥ j.
    pub(super) fn index_of(&self, i: usize, j: usize) -> Option<usize> {
        // Rows are short, and most blocks asked for are the diagonal or next to it.
        let (start, end) = (self.row_start[i], self.row_start[i + 1]);
        let index = self.columns[start..end].iter().rposition(|&k| k == j);
        index.map(|k| start + k)
    }

    /// Adds a block at nodes (i, j). Blocks above the diagonal mirror those below and are
    /// skipped, so an element may pass all of its blocks. The pair must be in the pattern.
    pub fn add(&mut self, i: usize, j: usize, block: &Block<D>) {
        if i < j {
            return;
        }
        let index = self.index_of(i, j);
        debug_assert!(index.is_some(), "pair ({i}, {j}) is not in the pattern");
        if let Some(index) = index {
            for a in 0..D {
                for b in 0..D {
                    self.blocks[index][a][b] += block[a][b];
                }
            }
        }
    }

    /// Adds a smaller block, at a row and a column of block (i, j), as [`Self::add`] does.
    pub fn add_part<const N: usize>(
        &mut self,
        (i, j): (usize, usize),
        (row, column): (usize, usize),
        part: &Block<N>,
    ) {
        if i < j {
            return;
        }
        let index = self.index_of(i, j);
        debug_assert!(index.is_some(), "pair ({i}, {j}) is not in the pattern");
        if let Some(index) = index {
            for a in 0..N {
                for b in 0..N {
                    self.blocks[index][row + a][column + b] += part[a][b];
                }
            }
        }
    }

    /// Removes the degrees of freedom that are not free: their rows and columns become those of
    /// the identity.
    pub fn keep_free(&mut self, free: &[[bool; D]]) {
        let held = self.held(free);
        self.hold(&held);
    }

    /// Entries that [`SymmetricBlocks::hold`] sets for the degrees of freedom that are not free.
    #[must_use]
    pub fn held(&self, free: &[[bool; D]]) -> Vec<HeldEntry> {
        let mut held = Vec::new();
        for (i, rows) in free.iter().enumerate() {
            for block in self.row_start[i]..self.row_start[i + 1] {
                let j = self.columns[block];
                for (a, b) in (0..D).flat_map(|a| (0..D).map(move |b| (a, b))) {
                    if !(rows[a] && free[j][b]) {
                        let value = f64::from(u8::from(i == j && a == b));
                        held.push(HeldEntry { block, a, b, value });
                    }
                }
            }
        }
        held
    }

    /// Sets the held entries, which come from a matrix of the same pattern.
    pub fn hold(&mut self, held: &[HeldEntry]) {
        for e in held {
            self.blocks[e.block][e.a][e.b] = e.value;
        }
    }

    /// Quadratic form xᵀ A x.
    #[must_use]
    pub fn quadratic(&self, x: &[[f64; D]]) -> f64 {
        let mut sums = [0.0; D];
        super::widest(Quadratic {
            matrix: self,
            x,
            sums: &mut sums,
        });
        sums.iter().sum()
    }

    /// Adds the terms of row `i` of xᵀ A x and of yᵀ A x to the components of `quadratic` and
    /// `mixed`: with all rows added, the components sum up to the forms. For use inside a kernel.
    #[inline(always)]
    pub fn add_row_of_forms(
        &self,
        i: usize,
        x: &[[f64; D]],
        y: &[[f64; D]],
        quadratic: &mut [f64; D],
        mixed: &mut [f64; D],
    ) {
        let (begin, diagonal) = (self.row_start[i], self.row_start[i + 1] - 1);
        let (xi, yi) = (&x[i], &y[i]);
        for (a, &j) in self.blocks[begin..diagonal]
            .iter()
            .zip(&self.columns[begin..diagonal])
        {
            let (xa, ya) = (left_product(xi, a), left_product(yi, a));
            let (xj, yj) = (&x[j], &y[j]);
            for q in 0..D {
                quadratic[q] += 2.0 * xa[q] * xj[q];
                mixed[q] += xa[q] * yj[q] + ya[q] * xj[q];
            }
        }
        let xa = left_product(xi, &self.blocks[diagonal]);
        for q in 0..D {
            quadratic[q] += xa[q] * xi[q];
            mixed[q] += xa[q] * yi[q];
        }
    }
}

/// Product `xᵀ a`, with independent SIMD lanes.
#[inline(always)]
fn left_product<const D: usize>(x: &[f64; D], a: &Block<D>) -> [f64; D] {
    let mut y = [0.0; D];
    for p in 0..D {
        for q in 0..D {
            y[q] += x[p] * a[p][q];
        }
    }
    y
}

struct Quadratic<'a, const D: usize> {
    matrix: &'a SymmetricBlocks<D>,
    x: &'a [[f64; D]],
    sums: &'a mut [f64; D],
}

impl<const D: usize> super::Kernel for Quadratic<'_, D> {
    #[inline(always)]
    fn run(self) {
        let m = self.matrix;
        for (i, xi) in self.x.iter().enumerate() {
            let (begin, diagonal) = (m.row_start[i], m.row_start[i + 1] - 1);
            for (a, &j) in m.blocks[begin..diagonal]
                .iter()
                .zip(&m.columns[begin..diagonal])
            {
                let (xa, xj) = (left_product(xi, a), &self.x[j]);
                for q in 0..D {
                    self.sums[q] += 2.0 * xa[q] * xj[q];
                }
            }
            let xa = left_product(xi, &m.blocks[diagonal]);
            for q in 0..D {
                self.sums[q] += xa[q] * xi[q];
            }
        }
    }
}
