//! Forward and backward substitution with a block factor, laid out in the order they read it.
//!
//!   L y = b,   D z = y,   Lᵀ x = z
//!
//! Both sweeps are bound by loads and by their chain of dependent operations: blocks are stored one
//! behind the other, and the values computed last are used last.

use super::block::{self, Block, zero};
use super::{Kernel, widest};

/// Fraction of the largest value below which a value is negligible: influence decays by so much
/// within a few hundred metres, and the part of a column that is kept is 13 orders of magnitude
/// larger.
const NEGLIGIBLE: f64 = 1e-30;

/// Row or column of the factor: its node, and the number of its blocks off the diagonal.
#[derive(Debug, Clone, Copy)]
struct Row {
    node: u32,
    length: u32,
}

/// Block of the factor with the node whose value it multiplies.
#[derive(Debug, Clone, Copy)]
struct Entry<const D: usize> {
    block: Block<D>,
    node: usize,
}

/// Sweep of a substitution, forward or backward: rows in their order, and their entries.
#[derive(Debug, Clone, Default)]
struct Sweep<const D: usize> {
    rows: Vec<Row>,
    /// Index of the first entry of each row.
    start: Vec<u32>,
    entries: Vec<Entry<D>>,
}

impl<const D: usize> Sweep<D> {
    /// Appends a row with the nodes that it reads.
    fn push(&mut self, node: u32, partners: impl ExactSizeIterator<Item = u32>) {
        self.start.push(self.entries.len() as u32);
        let length = partners.len() as u32;
        self.rows.push(Row { node, length });
        let entry = |node| Entry {
            block: zero(),
            node: node as usize,
        };
        self.entries.extend(partners.map(entry));
    }

    /// Rows by their numbers: the node of each, and its entries.
    #[inline(always)]
    fn rows(&self, which: std::ops::Range<usize>) -> impl Iterator<Item = (usize, &[Entry<D>])> {
        let all = self.entries.len();
        let start = self.start.get(which.start).map_or(all, |&s| s as usize);
        let mut entries = &self.entries[start..];
        self.rows[which].iter().map(move |row| {
            let (of_row, behind) = entries.split_at(row.length as usize);
            entries = behind;
            (row.node as usize, of_row)
        })
    }
}

/// Reduced value `value − Σ blockᵀ x` of a row.
#[inline(always)]
fn reduce<const D: usize>(mut value: [f64; D], row: &[Entry<D>], x: &[[f64; D]]) -> [f64; D] {
    for e in row {
        block::subtract_transposed_product(&mut value, &e.block, &x[e.node]);
    }
    value
}

/// Factor in the layout of the substitutions.
#[derive(Debug, Clone, Default)]
pub(super) struct Substitution<const D: usize> {
    /// Rows of L; their blocks are transposed, as each sweep needs contiguous SIMD lanes.
    forward: Sweep<D>,
    /// Columns of L from the last to the first.
    backward: Sweep<D>,
    /// Indices in L of the blocks of `backward`.
    lower_index: Vec<u32>,
    inverse: Vec<Block<D>>,
    /// Position of each node in the elimination.
    position: Vec<u32>,
    /// Bandwidth: largest distance, in positions, of a row from one that it reads.
    bandwidth: usize,
}

impl<const D: usize> Substitution<D> {
    /// Lays out a factor of the given pattern (rows of L, in the order of elimination).
    pub(super) fn new(order: &[u32], row_start: &[usize], columns: &[u32]) -> Self {
        let n = order.len();
        let mut s = Self {
            inverse: vec![zero(); n],
            position: vec![0; n],
            ..Self::default()
        };
        let mut below = vec![Vec::new(); n];
        for (i, ends) in row_start.windows(2).enumerate() {
            s.position[order[i] as usize] = i as u32;
            let row = &columns[ends[0]..ends[1]];
            s.bandwidth = row.iter().fold(s.bandwidth, |r, &j| r.max(i - j as usize));
            let partners = row.iter().map(|&j| order[j as usize]);
            s.forward.push(order[i], partners);
            for index in ends[0]..ends[1] {
                below[columns[index] as usize].push((i, index as u32));
            }
        }
        for (&node, column) in order.iter().zip(&below).rev() {
            // The value computed last comes last: the others do not have to wait for it.
            let column = column.iter().rev();
            s.backward
                .push(node, column.clone().map(|&(i, _)| order[i]));
            s.lower_index.extend(column.map(|&(_, index)| index));
        }
        s
    }

    /// Copies the values of L and of the inverse of D.
    pub(super) fn fill(&mut self, lower: &[Block<D>], inverse: &[Block<D>]) {
        for (entry, l) in self.forward.entries.iter_mut().zip(lower) {
            entry.block = block::transpose(l);
        }
        let backward = self.backward.entries.iter_mut();
        for (entry, &index) in backward.zip(&self.lower_index) {
            entry.block = lower[index as usize];
        }
        self.inverse.copy_from_slice(inverse);
    }

    /// Solves `x ← A⁻¹ x − minus` on the nodes of one or more islands (nothing is subtracted where
    /// `minus` is empty). The positions of an island in the elimination are the indices of its
    /// nodes.
    pub(super) fn solve(
        &self,
        nodes: std::ops::Range<usize>,
        x: &mut [[f64; D]],
        minus: &[[f64; D]],
        work: &mut [[f64; D]],
    ) {
        widest(IslandSolve {
            factor: self,
            nodes,
            x,
            minus,
            work,
        });
    }

    /// Solves `x ← A⁻¹ x` where x is zero except at `loaded`, at nodes that are not eliminated
    /// before all of these; x stays zero at the others. The values are those of
    /// [`solve`](Self::solve), bit for bit: rows that only hold zeros, or that nobody reads, are
    /// passed over.
    pub(super) fn solve_behind(&self, x: &mut [[f64; D]], loaded: &[usize], work: &mut [[f64; D]]) {
        let positions = loaded.iter().map(|&node| self.position[node] as usize);
        let first = positions.min().unwrap_or(self.inverse.len());
        widest(LastRows {
            factor: self,
            x,
            work,
            first,
        });
    }

    /// Solves `x ← A⁻¹ x` where x is zero except at `loaded`, as far as the solution is not
    /// negligible; `work` is zero before and after. Returns the range of nodes outside of which x
    /// is zero.
    pub(super) fn solve_near(
        &self,
        x: &mut [[f64; D]],
        loaded: &[usize],
        work: &mut [[f64; D]],
    ) -> std::ops::Range<usize> {
        let positions = loaded.iter().map(|&node| self.position[node] as usize);
        let (first, last) = positions.fold((usize::MAX, 0), |(a, b), p| (a.min(p), b.max(p)));
        let mut reached = [usize::MAX, 0];
        widest(LocalSolve {
            factor: self,
            x,
            work,
            loaded: [first, last],
            reached: &mut reached,
        });
        reached[0].min(reached[1])..reached[1]
    }

    /// Computes rows of both `y = L⁻¹ x`, which replaces x, and `z = D⁻¹ y`: no row waits for the
    /// second. Ends behind the row for which `ends` returns true; returns the number of the row
    /// behind the last one.
    #[inline(always)]
    fn sweep_forward(
        &self,
        which: std::ops::Range<usize>,
        x: &mut [[f64; D]],
        z: &mut [[f64; D]],
        mut ends: impl FnMut(usize, &[f64; D]) -> bool,
    ) -> usize {
        let inverses = &self.inverse[which.clone()];
        let rows = self.forward.rows(which.clone()).zip(inverses);
        for (i, ((node, row), inverse)) in rows.enumerate() {
            let y = reduce(x[node], row, x);
            x[node] = y;
            // The inverse is symmetric.
            z[node] = block::transposed_product(inverse, &y);
            if ends(which.start + i, &y) {
                return which.start + i + 1;
            }
        }
        which.end
    }

    /// Computes columns, counted from the last, of `x = L⁻ᵀ z`, which replaces z.
    #[inline(always)]
    fn sweep_backward(
        &self,
        which: std::ops::Range<usize>,
        z: &mut [[f64; D]],
        mut ends: impl FnMut(usize, &[f64; D]) -> bool,
    ) -> usize {
        for (k, (node, row)) in self.backward.rows(which.clone()).enumerate() {
            z[node] = reduce(z[node], row, z);
            if ends(which.start + k, &z[node]) {
                return which.start + k + 1;
            }
        }
        which.end
    }
}

struct IslandSolve<'a, const D: usize> {
    factor: &'a Substitution<D>,
    nodes: std::ops::Range<usize>,
    x: &'a mut [[f64; D]],
    minus: &'a [[f64; D]],
    work: &'a mut [[f64; D]],
}

impl<const D: usize> Kernel for IslandSolve<'_, D> {
    #[inline(always)]
    fn run(self) {
        let (factor, nodes, x, work) = (self.factor, self.nodes, self.x, self.work);
        let all = factor.inverse.len();
        factor.sweep_forward(nodes.clone(), x, work, |_, _| false);
        factor.sweep_backward(all - nodes.end..all - nodes.start, work, |_, _| false);
        let x = x[nodes.clone()].as_flattened_mut();
        let work = work[nodes.clone()].as_flattened();
        if self.minus.is_empty() {
            x.copy_from_slice(work);
            return;
        }
        let minus = self.minus[nodes].as_flattened();
        for ((x, value), minus) in x.iter_mut().zip(work).zip(minus) {
            *x = value - minus;
        }
    }
}

struct LastRows<'a, const D: usize> {
    factor: &'a Substitution<D>,
    x: &'a mut [[f64; D]],
    work: &'a mut [[f64; D]],
    /// Position of the first row.
    first: usize,
}

impl<const D: usize> Kernel for LastRows<'_, D> {
    #[inline(always)]
    fn run(self) {
        let (factor, first) = (self.factor, self.first);
        let all = factor.inverse.len();
        factor.sweep_forward(first..all, self.x, self.work, |_, _| false);
        factor.sweep_backward(0..all - first, self.work, |_, _| false);
        for row in &factor.forward.rows[first..] {
            self.x[row.node as usize] = self.work[row.node as usize];
        }
    }
}

struct LocalSolve<'a, const D: usize> {
    factor: &'a Substitution<D>,
    x: &'a mut [[f64; D]],
    work: &'a mut [[f64; D]],
    /// Positions of the first and the last loaded node.
    loaded: [usize; 2],
    /// First node of the solution, and the one behind the last.
    reached: &'a mut [usize; 2],
}

/// Test of decay: a sweep ends when all the rows that any later one reads are negligible.
struct DecayTest {
    bandwidth: usize,
    largest: f64,
    rows: usize,
}

impl DecayTest {
    fn new(bandwidth: usize) -> Self {
        Self {
            bandwidth,
            largest: 0.0,
            rows: 0,
        }
    }

    /// Adds a row; returns whether the sweep has decayed.
    #[inline(always)]
    fn has_decayed<const D: usize>(&mut self, row: &[f64; D]) -> bool {
        let size = row.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        self.largest = self.largest.max(size);
        self.rows = if size <= NEGLIGIBLE * self.largest {
            self.rows + 1
        } else {
            0
        };
        self.rows >= self.bandwidth
    }
}

impl<const D: usize> Kernel for LocalSolve<'_, D> {
    #[inline(always)]
    fn run(self) {
        let (factor, x, z) = (self.factor, self.x, self.work);
        let n = factor.forward.rows.len();
        let [first, last] = self.loaded;
        let mut decay = DecayTest::new(factor.bandwidth);
        let end = factor.sweep_forward(first..n, x, z, |i, y| decay.has_decayed(y) && i > last);
        for row in &factor.forward.rows[first..end] {
            x[row.node as usize] = [0.0; D];
        }
        let mut decay = DecayTest::new(factor.bandwidth);
        let done = factor.sweep_backward(n - end..n, z, |k, x| {
            decay.has_decayed(x) && n - 1 - k < first
        });
        for k in n - end..done {
            let node = factor.backward.rows[k].node as usize;
            x[node] = std::mem::replace(&mut z[node], [0.0; D]);
            let [start, end] = *self.reached;
            *self.reached = [start.min(node), end.max(node + 1)];
        }
    }
}
