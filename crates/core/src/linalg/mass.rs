//! Mass matrix of wires and point masses.
//!
//! The mass of a wire element does not depend on direction: each block is a 2×2 matrix of
//! numbers (position–position, position–slope, slope–slope) times the identity of space.
//! Storing the numbers alone makes the product six to nine times lighter than full blocks. Where
//! nodes have no slopes (chains of point masses) only the first number counts.

use std::ops::Range;

/// Coupling of a node with another one, or with itself: rows and columns (position, slope).
type Entry = [[f64; 2]; 2];

/// Entry by SIMD lanes: factor of each component on itself, and on its partner in the other half
/// (position on slope, slope on position).
type PackedEntry<const D: usize> = [[f64; D]; 2];

/// Structured mass matrix; position components, then (with `D = 2·DIM`) slope components. Rows are
/// complete (both triangles), so a product writes every node once.
#[derive(Debug, Clone)]
pub struct MassMatrix<const DIM: usize, const D: usize> {
    rows: Vec<Vec<(u32, Entry)>>,
    start: Vec<u32>,
    entries: Vec<(u32, PackedEntry<D>)>,
    runs: Vec<RowRun>,
}

/// Consecutive rows with equal numbers of entries.
#[derive(Debug, Clone)]
struct RowRun {
    rows: Range<usize>,
    width: usize,
}

/// Number of entries of a row inside a wire: the node and its two neighbours.
const INNER_WIDTH: usize = 3;

impl<const DIM: usize, const D: usize> MassMatrix<DIM, D> {
    /// Number of vectors of a node: its position, and its slope or not.
    const SLOTS: usize = D / DIM;

    /// Zero matrix.
    #[must_use]
    pub fn zero(nodes: usize) -> Self {
        let rows = (0..nodes)
            .map(|i| vec![(i as u32, [[0.0; 2]; 2])])
            .collect();
        Self {
            rows,
            start: vec![0; nodes + 1],
            entries: Vec::new(),
            runs: Vec::new(),
        }
    }

    /// Packs the rows one after the other in memory, once all masses have been added.
    pub fn pack(&mut self) {
        self.entries.clear();
        self.runs.clear();
        for (i, row) in self.rows.iter_mut().enumerate() {
            row.sort_by_key(|entry| entry.0);
            self.entries
                .extend(row.iter().map(|(j, m)| (*j, Self::packed(m))));
            self.start[i + 1] = self.entries.len() as u32;
            match self.runs.last_mut() {
                Some(last) if last.width == row.len() => last.rows.end = i + 1,
                _ => self.runs.push(RowRun {
                    rows: i..i + 1,
                    width: row.len(),
                }),
            }
        }
    }

    /// Entry by SIMD lanes.
    fn packed(m: &Entry) -> PackedEntry<D> {
        [
            std::array::from_fn(|c| m[c / DIM][c / DIM]),
            std::array::from_fn(|c| m[c / DIM][1 - c / DIM]),
        ]
    }

    /// Entry of the coupling (i, j), created where there is none.
    fn entry(&mut self, i: usize, j: usize) -> &mut Entry {
        let row = &mut self.rows[i];
        let index = row
            .iter()
            .position(|entry| entry.0 == j as u32)
            .unwrap_or_else(|| {
                row.push((j as u32, [[0.0; 2]; 2]));
                row.len() - 1
            });
        &mut row[index].1
    }

    /// Adds a mass at the position of a node, kg.
    pub fn add_point(&mut self, node: usize, mass: f64) {
        self.entry(node, node)[0][0] += mass;
    }

    /// Adds the consistent mass of a Hermite element, `m` in kg per metre of rest length `l`,
    /// multiplied by `factor` (used for mass-proportional damping). `slots` are node and slot
    /// (0 position, 1 slope) of r₁, r₁′, r₂, r₂′.
    /// Source: cubic Hermite shape functions, ∫ NᵢNⱼ ds (Przemieniecki 1968, beam element).
    pub fn add_hermite(&mut self, slots: [(usize, usize); 4], m: f64, l: f64, factor: f64) {
        let c = factor * m * l / 420.0;
        let entries = [
            [156.0, 22.0 * l, 54.0, -13.0 * l],
            [22.0 * l, 4.0 * l * l, 13.0 * l, -3.0 * l * l],
            [54.0, 13.0 * l, 156.0, -22.0 * l],
            [-13.0 * l, -3.0 * l * l, -22.0 * l, 4.0 * l * l],
        ];
        self.add_element(slots, &entries, c);
    }

    /// Adds `factor` times ∫ Nᵢ′Nⱼ′ ds of a Hermite element of length `l`, the matrix that tension
    /// is multiplied by in its stiffness.
    pub fn add_hermite_slopes(&mut self, slots: [(usize, usize); 4], l: f64, factor: f64) {
        let c = factor / (30.0 * l);
        let entries = [
            [36.0, 3.0 * l, -36.0, 3.0 * l],
            [3.0 * l, 4.0 * l * l, -3.0 * l, -l * l],
            [-36.0, -3.0 * l, 36.0, -3.0 * l],
            [3.0 * l, -l * l, -3.0 * l, 4.0 * l * l],
        ];
        self.add_element(slots, &entries, c);
    }

    fn add_element(&mut self, slots: [(usize, usize); 4], entries: &[[f64; 4]; 4], factor: f64) {
        for (row, &(i, p)) in entries.iter().zip(&slots) {
            for (value, &(j, q)) in row.iter().zip(&slots) {
                self.entry(i, j)[p][q] += factor * value;
            }
        }
    }

    /// Product `y = M x`; the matrix must be packed.
    pub fn product(&self, x: &[[f64; D]], y: &mut [[f64; D]]) {
        self.product_at(0..y.len(), x, y);
    }

    /// Product `y = M x` for some of the rows; others of `y` are left as they are.
    pub fn product_at(&self, rows: Range<usize>, x: &[[f64; D]], y: &mut [[f64; D]]) {
        super::widest(Product {
            mass: self,
            rows,
            x,
            y,
        });
    }

    /// Quadratic form xᵀ M x.
    #[must_use]
    pub fn quadratic(&self, x: &[[f64; D]]) -> f64 {
        let mut sums = [0.0; D];
        super::widest(Quadratic {
            mass: self,
            x,
            sums: &mut sums,
        });
        sums.iter().sum()
    }

    /// Product `y = M x` for some of the rows, for use inside a kernel. Nearly all rows are inside
    /// a wire and have three entries: a loop of fixed length takes half the instructions.
    #[inline(always)]
    pub(crate) fn multiply(&self, rows: Range<usize>, x: &[[f64; D]], y: &mut [[f64; D]]) {
        let first = self.runs.partition_point(|s| s.rows.end <= rows.start);
        for run in &self.runs[first..] {
            if run.rows.start >= rows.end {
                break;
            }
            let part = run.rows.start.max(rows.start)..run.rows.end.min(rows.end);
            let entries = self.start[part.start] as usize..self.start[part.end] as usize;
            if run.width == INNER_WIDTH {
                let (chunks, _) = self.entries[entries].as_chunks::<INNER_WIDTH>();
                for (y, entries) in y[part].iter_mut().zip(chunks) {
                    *y = Self::sum(entries, x);
                }
            } else {
                for (y, i) in y[part.clone()].iter_mut().zip(part) {
                    *y = self.row(i, x);
                }
            }
        }
    }

    /// Row `i` of `M x`, for use inside a kernel.
    #[inline(always)]
    #[must_use]
    pub fn row(&self, i: usize, x: &[[f64; D]]) -> [f64; D] {
        Self::sum(
            &self.entries[self.start[i] as usize..self.start[i + 1] as usize],
            x,
        )
    }

    /// Sum of the entries of a row times `x`.
    #[inline(always)]
    fn sum(entries: &[(u32, PackedEntry<D>)], x: &[[f64; D]]) -> [f64; D] {
        let mut sum = [0.0; D];
        for (j, entry) in entries {
            let x = x[*j as usize];
            for c in 0..D {
                sum[c] += entry[0][c] * x[c];
            }
            if Self::SLOTS == 1 {
                continue;
            }
            for c in 0..D {
                sum[c] += entry[1][c] * x[(c + DIM) % D];
            }
        }
        sum
    }

    /// Adds `factor · M` to a matrix whose pattern contains all wire neighbours.
    pub fn add_to(&self, factor: f64, target: &mut super::SymmetricBlocks<D>) {
        let expand = |m: &Entry| {
            let mut block = super::block::zero::<D>();
            for p in 0..Self::SLOTS {
                for q in 0..Self::SLOTS {
                    for c in 0..DIM {
                        block[p * DIM + c][q * DIM + c] = factor * m[p][q];
                    }
                }
            }
            block
        };
        for (i, row) in self.rows.iter().enumerate() {
            for (j, m) in row {
                target.add(i, *j as usize, &expand(m));
            }
        }
    }
}

struct Product<'a, const DIM: usize, const D: usize> {
    mass: &'a MassMatrix<DIM, D>,
    rows: Range<usize>,
    x: &'a [[f64; D]],
    y: &'a mut [[f64; D]],
}

impl<const DIM: usize, const D: usize> super::Kernel for Product<'_, DIM, D> {
    #[inline(always)]
    fn run(self) {
        self.mass.multiply(self.rows, self.x, self.y);
    }
}

struct Quadratic<'a, const DIM: usize, const D: usize> {
    mass: &'a MassMatrix<DIM, D>,
    x: &'a [[f64; D]],
    sums: &'a mut [f64; D],
}

impl<const DIM: usize, const D: usize> super::Kernel for Quadratic<'_, DIM, D> {
    #[inline(always)]
    fn run(self) {
        for (i, xi) in self.x.iter().enumerate() {
            let row = self.mass.row(i, self.x);
            for k in 0..D {
                self.sums[k] += row[k] * xi[k];
            }
        }
    }
}
