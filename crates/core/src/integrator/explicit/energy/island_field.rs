//! Nodal fields of an island, and sums over them.

/// Displacements or increments of an island: of its points in each transverse direction, and of its
/// masters along the track.
#[derive(Debug, Clone, Default)]
pub(in crate::integrator::explicit::energy) struct IslandField {
    pub transverse: [Vec<f64>; 2],
    pub axial: Vec<f64>,
}

impl IslandField {
    /// Returns zeros for a number of points and masters, with `directions` transverse ones.
    pub fn zeros(points: usize, masters: usize, directions: usize) -> Self {
        let transverse = |c: usize| vec![0.0; if c < directions { points } else { 0 }];
        Self {
            transverse: [0, 1].map(transverse),
            axial: vec![0.0; masters],
        }
    }

    /// Sets every number to a function of those of two other fields.
    #[inline(always)]
    pub fn combine(&mut self, a: &Self, b: &Self, of: impl Fn(f64, f64) -> f64) {
        for c in 0..2 {
            combine(
                &mut self.transverse[c],
                &a.transverse[c],
                &b.transverse[c],
                &of,
            );
        }
        combine(&mut self.axial, &a.axial, &b.axial, &of);
    }
}

/// Motion of an island.
#[derive(Debug, Clone)]
pub(in crate::integrator::explicit::energy) struct Workspace {
    /// Predictor and increment, increment before the measured step, and scratch space.
    pub y: IslandField,
    pub d: IslandField,
    pub old: IslandField,
    pub work: IslandField,
}

/// Sets one list. Written as a loop: iterator adapters may not be compiled for wide vectors.
#[inline(always)]
fn combine(to: &mut [f64], a: &[f64], b: &[f64], of: impl Fn(f64, f64) -> f64) {
    let n = to.len();
    let (a, b) = (&a[..n], &b[..n]);
    for k in 0..n {
        to[k] = of(a[k], b[k]);
    }
}

/// Returns the sum of a term over lists, up to the end of the shortest. Several partial sums: a
/// single one would wait for each addition.
#[inline(always)]
pub(in crate::integrator::explicit::energy) fn total<const K: usize>(
    lists: [&[f64]; K],
    term: impl Fn([f64; K]) -> f64,
) -> f64 {
    const SIDES: usize = 8;
    let n = lists.iter().fold(usize::MAX, |n, list| n.min(list.len()));
    let chunks = lists.map(|list| list[..n].as_chunks::<SIDES>().0);
    let mut sums = [0.0; SIDES];
    for k in 0..n / SIDES {
        // Loops: array initialisers of the library may not be compiled for wide vectors.
        let mut rows = [&[0.0; SIDES]; K];
        for i in 0..K {
            rows[i] = &chunks[i][k];
        }
        for l in 0..SIDES {
            let mut numbers = [0.0; K];
            for i in 0..K {
                numbers[i] = rows[i][l];
            }
            sums[l] += term(numbers);
        }
    }
    let rest = (n - n % SIDES..n).map(|k| term(std::array::from_fn(|i| lists[i][k])));
    sums.iter().sum::<f64>() + rest.sum::<f64>()
}
