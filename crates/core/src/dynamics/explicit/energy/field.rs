//! Numbers of all points of an island, and sums over them.

/// Displacements or increments of an island: point by point in each direction across, and of its masters along.
#[derive(Debug, Clone, Default)]
pub(super) struct Field {
    pub across: [Vec<f64>; 2],
    pub along: Vec<f64>,
}

impl Field {
    /// Number by number of two others.
    pub fn set(&mut self, a: &Self, b: &Self, of: impl Fn(f64, f64) -> f64) {
        let lists = self.across.iter_mut().chain([&mut self.along]);
        let [a, b] = [a, b].map(|f| f.across.iter().chain([&f.along]));
        for (to, (a, b)) in lists.zip(a.zip(b)) {
            to.clear();
            to.extend(a.iter().zip(b).map(|(a, b)| of(*a, *b)));
        }
    }
}

/// Sum of a term of the numbers of some lists, as far as all of them go. Side by side: one after the other sums
/// would wait for each other.
#[inline(always)]
pub(super) fn total<const K: usize>(lists: [&[f64]; K], term: impl Fn([f64; K]) -> f64) -> f64 {
    const SIDES: usize = 8;
    let n = lists.iter().fold(usize::MAX, |n, list| n.min(list.len()));
    let chunks = lists.map(|list| list[..n].as_chunks::<SIDES>());
    let mut sums = [0.0; SIDES];
    for k in 0..n / SIDES {
        let rows: [&[f64; SIDES]; K] = std::array::from_fn(|i| &chunks[i].0[k]);
        for l in 0..SIDES {
            sums[l] += term(std::array::from_fn(|i| rows[i][l]));
        }
    }
    let rest = (n - n % SIDES..n).map(|k| term(std::array::from_fn(|i| lists[i][k])));
    sums.iter().sum::<f64>() + rest.sum::<f64>()
}
