//! Kinetic energy of points with filtered forces.

/// Factor L D Lᵀ of M/h² + E in one transverse direction: both subdiagonals of L, and 1/D.
#[derive(Debug, Clone, Default)]
pub(in crate::integrator::explicit::energy) struct FilteredMass {
    below: Vec<[f64; 2]>,
    inverse: Vec<f64>,
}

impl FilteredMass {
    pub fn new(weight: &[f64], filter: &[f64], second: &[f64]) -> Self {
        let n = weight.len();
        let mut a = vec![[0.0; 3]; n + 2];
        for (k, weight) in weight.iter().enumerate() {
            a[k][0] += if *weight > 0.0 { *weight } else { 1.0 };
        }
        // Rows of held points are those of the unit matrix.
        let is_free = |k: usize| k < n && weight[k] > 0.0;
        let mut add = |i: usize, j: usize, value: f64| {
            if is_free(i) && is_free(j) {
                a[i.min(j)][i.abs_diff(j)] += if i == j { value } else { 0.5 * value };
            }
        };
        for k in 0..n {
            for (i, x) in [(k, 1.0), (k + 1, -1.0)] {
                for (j, z) in [(k, 1.0), (k + 1, -1.0)] {
                    add(i, j, filter[k] * x * z);
                }
            }
            if second[k] == 0.0 {
                continue;
            }
            let around = [(k - 1, 1.0), (k, -2.0), (k + 1, 1.0)];
            for (i, x) in around {
                for (j, z) in around {
                    add(i, j, second[k] * x * z);
                }
            }
        }
        let (mut below, mut pivots) = (vec![[0.0; 2]; n], vec![0.0; n]);
        for k in 0..n {
            let (mut near, mut far) = (0.0, 0.0);
            let mut pivot = a[k][0];
            if k > 1 {
                far = a[k - 2][2] / pivots[k - 2];
                pivot -= far * far * pivots[k - 2];
            }
            if k > 0 {
                let from_far = if k > 1 {
                    far * pivots[k - 2] * below[k - 1][0]
                } else {
                    0.0
                };
                near = (a[k - 1][1] - from_far) / pivots[k - 1];
                pivot -= near * near * pivots[k - 1];
            }
            (below[k], pivots[k]) = ([near, far], pivot);
        }
        Self {
            below,
            inverse: pivots.into_iter().map(|pivot| 1.0 / pivot).collect(),
        }
    }
}

/// Returns the kinetic energy ½ dᵀ M* d/h², J, of all directions. With (M/h² + E) x = M d/h² and M*
/// d/h² = M x/h² it is half of bᵀ (L D Lᵀ)⁻¹ b.
///
/// Both directions share a loop: each number depends on the one before it.
#[inline(always)]
pub(in crate::integrator::explicit::energy) fn energy(
    filtered: &[FilteredMass; 2],
    weight: &[Vec<f64>; 2],
    d: &[Vec<f64>; 2],
) -> f64 {
    let (mut sums, mut previous) = ([0.0; 2], [[0.0; 2]; 2]);
    let mut eliminate = |c: usize, k: usize| {
        let [near, far] = filtered[c].below[k];
        let b = weight[c][k] * d[c][k] - far * previous[c][1] - near * previous[c][0];
        sums[c] += b * b * filtered[c].inverse[k];
        previous[c] = [b, previous[c][0]];
    };
    let both = d[0].len().min(d[1].len());
    for k in 0..both {
        eliminate(0, k);
        eliminate(1, k);
    }
    (both..d[0].len()).for_each(|k| eliminate(0, k));
    0.5 * (sums[0] + sums[1])
}
