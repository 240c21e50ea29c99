//! Mass matrix of wires and point masses.
//!
//! The mass of a wire element does not depend on direction: each block is a 2×2 matrix of
//! numbers (position–position, position–slope, slope–slope) times the identity of space.
//! Storing the numbers alone makes the product six to nine times lighter than full blocks. Where
//! nodes have no slopes (chains of point masses) only the first number counts.

use std::ops::Range;

/// Couplings of a node with another one, or with itself: rows and columns (position, slope).
type Entry = [[f64; 2]; 2];

/// An entry ready for lanes: what each component takes from itself, and what from its partner in
/// the other half (position from slope, slope from position).
type Lanes<const D: usize> = [[f64; D]; 2];

/// Structured mass matrix; position components, then (with `D = 2·DIM`) slope components. Rows are
/// complete (both triangles), so a product writes every node once.
#[derive(Debug, Clone)]
pub struct MassMatrix<const DIM: usize, const D: usize> {
    rows: Vec<Vec<(u32, Entry)>>,
    start: Vec<u32>,
    entries: Vec<(u32, Lanes<D>)>,
    stretches: Vec<Stretch>,
}

/// Consecutive rows that have as many entries.
#[derive(Debug, Clone)]
struct Stretch {
    rows: Range<usize>,
    width: usize,
}

/// Entries of a row inside a wire: the node and its two neighbours.
const INSIDE: usize = 3;

impl<const DIM: usize, const D: usize> MassMatrix<DIM, D> {
    /// Vectors of a node: its position, and its slope or not.
    const SLOTS: usize = D / DIM;

    /// No mass anywhere.
    #[must_use]
    pub fn zero(nodes: usize) -> Self {
        let rows = (0..nodes)
            .map(|i| vec![(i as u32, [[0.0; 2]; 2])])
            .collect();
        Self {
            rows,
            start: vec![0; nodes + 1],
            entries: Vec::new(),
            stretches: Vec::new(),
        }
    }

    /// Put the rows one after the other in memory, once all masses have been added.
    pub fn pack(&mut self) {
        self.entries.clear();
        self.stretches.clear();
        for (i, row) in self.rows.iter_mut().enumerate() {
            row.sort_by_key(|entry| entry.0);
            self.entries
                .extend(row.iter().map(|(j, m)| (*j, Self::lanes(m))));
            self.start[i + 1] = self.entries.len() as u32;
            match self.stretches.last_mut() {
                Some(last) if last.width == row.len() => last.rows.end = i + 1,
                _ => self.stretches.push(Stretch {
                    rows: i..i + 1,
                    width: row.len(),
                }),
            }
        }
    }

    fn lanes(m: &Entry) -> Lanes<D> {
        [
            std::array::from_fn(|c| m[c / DIM][c / DIM]),
            std::array::from_fn(|c| m[c / DIM][1 - c / DIM]),
        ]
    }

    fn entry(&mut self, i: usize, j: usize) -> &mut Entry {
        let row = &mut self.rows[i];
        let place = row
            .iter()
            .position(|entry| entry.0 == j as u32)
            .unwrap_or_else(|| {
                row.push((j as u32, [[0.0; 2]; 2]));
                row.len() - 1
            });
        &mut row[place].1
    }

    /// Add a mass in kg at the position of a node.
    pub fn add_point(&mut self, node: usize, mass: f64) {
        self.entry(node, node)[0][0] += mass;
    }

    /// Add the consistent mass of a Hermite element, `m` in kg per metre of rest length `l`,
    /// multiplied by `factor` (used for mass-proportional damping). `places` tells node and slot
    /// (0 position, 1 slope) of r₁, r₁′, r₂, r₂′.
    /// Source: cubic Hermite shape functions, ∫ NᵢNⱼ ds (Przemieniecki 1968, beam element).
    pub fn add_hermite(&mut self, places: [(usize, usize); 4], m: f64, l: f64, factor: f64) {
        let c = factor * m * l / 420.0;
        let entries = [
            [156.0, 22.0 * l, 54.0, -13.0 * l],
            [22.0 * l, 4.0 * l * l, 13.0 * l, -3.0 * l * l],
            [54.0, 13.0 * l, 156.0, -22.0 * l],
            [-13.0 * l, -3.0 * l * l, -22.0 * l, 4.0 * l * l],
        ];
        self.add_element(places, &entries, c);
    }

    /// Add `factor` times ∫ Nᵢ′Nⱼ′ ds of a Hermite element of length `l`, the matrix that tension is
    /// multiplied by in its stiffness.
    pub fn add_hermite_slopes(&mut self, places: [(usize, usize); 4], l: f64, factor: f64) {
        let c = factor / (30.0 * l);
        let entries = [
            [36.0, 3.0 * l, -36.0, 3.0 * l],
            [3.0 * l, 4.0 * l * l, -3.0 * l, -l * l],
            [-36.0, -3.0 * l, 36.0, -3.0 * l],
            [3.0 * l, -l * l, -3.0 * l, 4.0 * l * l],
        ];
        self.add_element(places, &entries, c);
    }

    fn add_element(&mut self, places: [(usize, usize); 4], entries: &[[f64; 4]; 4], factor: f64) {
        for (row, &(i, p)) in entries.iter().zip(&places) {
            for (value, &(j, q)) in row.iter().zip(&places) {
                self.entry(i, j)[p][q] += factor * value;
            }
        }
    }

    /// `y = M x`; the matrix must be packed.
    pub fn product(&self, x: &[[f64; D]], y: &mut [[f64; D]]) {
        self.product_at(0..y.len(), x, y);
    }

    /// The same for some of the rows; others of `y` are left as they are.
    pub fn product_at(&self, rows: Range<usize>, x: &[[f64; D]], y: &mut [[f64; D]]) {
        super::widest(Product {
            mass: self,
            rows,
            x,
            y,
        });
    }

    /// xᵀ M x
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

    /// Some rows of `y = M x`, for use inside a kernel. Nearly all rows lie inside a wire and have three
    /// entries: a loop that knows so takes half the instructions.
    #[inline(always)]
    pub(crate) fn multiply(&self, rows: Range<usize>, x: &[[f64; D]], y: &mut [[f64; D]]) {
        let first = self.stretches.partition_point(|s| s.rows.end <= rows.start);
        for stretch in &self.stretches[first..] {
            if stretch.rows.start >= rows.end {
                break;
            }
            let own = stretch.rows.start.max(rows.start)..stretch.rows.end.min(rows.end);
            let entries = self.start[own.start] as usize..self.start[own.end] as usize;
            if stretch.width == INSIDE {
                let (chunks, _) = self.entries[entries].as_chunks::<INSIDE>();
                for (y, entries) in y[own].iter_mut().zip(chunks) {
                    *y = Self::sum(entries, x);
                }
            } else {
                for (y, i) in y[own.clone()].iter_mut().zip(own) {
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

    #[inline(always)]
    fn sum(entries: &[(u32, Lanes<D>)], x: &[[f64; D]]) -> [f64; D] {
        let mut sum = [0.0; D];
        for (j, lanes) in entries {
            let x = x[*j as usize];
            for c in 0..D {
                sum[c] += lanes[0][c] * x[c];
            }
            if Self::SLOTS == 1 {
                continue;
            }
            for c in 0..D {
                sum[c] += lanes[1][c] * x[(c + DIM) % D];
            }
        }
        sum
    }

    /// Add `factor · M` to a matrix whose pattern holds all wire neighbours.
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
