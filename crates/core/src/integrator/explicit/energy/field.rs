//! Numbers of all points of an island, and sums over them.

/// Displacements or increments of an island: point by point in each direction across, and of its masters along.
#[derive(Debug, Clone, Default)]
pub(in crate::integrator::explicit::energy) struct Field {
    pub across: [Vec<f64>; 2],
    pub along: Vec<f64>,
}

impl Field {
    /// Zeros for so many points and masters; `directions` across.
    pub fn still(points: usize, masters: usize, directions: usize) -> Self {
        let across = |c: usize| vec![0.0; if c < directions { points } else { 0 }];
        Self {
            across: [0, 1].map(across),
            along: vec![0.0; masters],
        }
    }

    /// Number by number of two others.
    #[inline(always)]
    pub fn set(&mut self, a: &Self, b: &Self, of: impl Fn(f64, f64) -> f64) {
        for c in 0..2 {
            set(&mut self.across[c], &a.across[c], &b.across[c], &of);
        }
        set(&mut self.along, &a.along, &b.along, &of);
    }
}

/// A loop of its own: what the library extends lists with may not be compiled for wide lanes.
#[inline(always)]
fn set(to: &mut [f64], a: &[f64], b: &[f64], of: impl Fn(f64, f64) -> f64) {
    let n = to.len();
    let (a, b) = (&a[..n], &b[..n]);
    for k in 0..n {
        to[k] = of(a[k], b[k]);
    }
}

/// Sum of a term of the numbers of some lists, as far as all of them go. Side by side: one after the other sums
/// would wait for each other.
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
        // Loops: what the library fills arrays with may not be compiled for wide lanes.
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
