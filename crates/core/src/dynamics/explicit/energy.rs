//! Energy of a line that is stepped explicitly, and what its steps take of it.
//!
//! The steps (module documentation of [`explicit`](super)) are, with d = yₙ₊₁ − yₙ the last increment of the predictor and
//! Δz = h vₙ₊₁ = ½ (yₙ₊₂ − yₙ) what multiplies their balance,
//!
//!   M* aₙ₊₁ + C_I ṽ + K_I ũ + K_E (yₙ₊₁ + B d) + (α/h) M d = f,     h² aₙ₊₁ = yₙ₊₂ − 2 yₙ₊₁ + yₙ
//!
//! M* is the inverse of M⁻¹ + M⁻¹ E M⁻¹, B = β/h of the wires. Since
//!
//!   Δz·M* a    = ½ |dₙ₊₂|²/h² − ½ |dₙ₊₁|²/h²                    (norm of M*)
//!   Δz·K_E y   = ½ yₙ₊₂ᵀK_E yₙ₊₁ − ½ yₙ₊₁ᵀK_E yₙ
//!   Δz·K_I u   = ½ zᵀK_I z |ₙ₊½^ₙ₊₃⁄₂,      zₙ₊½ = ½ (yₙ + yₙ₊₁),   uₙ₊₁ = ½ (zₙ₊½ + zₙ₊₃⁄₂)
//!
//! there is an energy half-way between two steps that obeys its balance exactly,
//!
//!   E = ½ (d/h)ᵀM*(d/h) + ½ yₙ₊₁ᵀK_E yₙ + ½ zᵀK_I z
//!   ΔE = Δz·f − (B d)ᵀK_E Δz − (α/h) dᵀM Δz − ṽᵀC_I Δz − S
//!
//! (central differences: Krenk, Comput. Methods Appl. Mech. Eng. 195 (2006) 6110; the split: Hughes & Liu,
//! J. Appl. Mech. 45 (1978) 371; both from memory, the sums above are derived here.) E is positive for ω h < 2, as
//! yₙ₊₁ᵀK yₙ = zᵀK z − ¼ dᵀK d.
//!
//! Along the wire clusters read the predictor, ũ_x = y_x and h ṽ_x = d_x; across h ṽ = Δz. So their K_xx has the form of K_E,
//! and what couples along with across leaves S = −¼ (h² a_x)ᵀK_xr Δz_r, which the scheme takes or gives.
//!
//! Nothing here uses forces of the steps: forms go along the wires, from point to point, and know no strands but
//! for where each point lies.

use super::cluster::{Cluster, Member, WIDEST};
use super::rows::{LANES, place};
use super::{Along, Explicit, Grid};
use std::ops::Range;

/// Components of most clusters: two points.
const FEW: usize = 6;

/// Displacements or increments of an island: point by point in each direction across, and of its masters along.
#[derive(Debug, Clone, Default)]
struct Field {
    across: [Vec<f64>; 2],
    along: Vec<f64>,
}

/// A piece between two masters: their numbers on the island, its first and last point, N/m.
#[derive(Debug, Clone, Copy)]
struct Piece {
    masters: [usize; 2],
    points: [usize; 2],
    stiffness: f64,
    /// What it is shorter by for a motion of both ends to the side, in curves.
    lean: f64,
}

/// The factor L D Lᵀ of M/h² + E in one direction across, both below the diagonal, and 1/D.
#[derive(Debug, Clone, Default)]
struct Filtered {
    below: Vec<[f64; 2]>,
    inverse: Vec<f64>,
}

/// A point of a cluster: number on the island, and where it lies along the wire.
#[derive(Debug, Clone, Copy)]
struct Joint {
    point: usize,
    along: Along,
}

/// A cluster, by its number among all, and its points.
#[derive(Debug, Clone)]
struct Joined {
    number: usize,
    joints: Vec<Joint>,
}

/// Numbers of an island, point by point along its wires.
#[derive(Debug, Clone)]
struct Form {
    slots: Vec<usize>,
    masters: Range<usize>,
    /// 1/L of the segment behind each point; EI*/ℓ̄ of the point.
    per_length: Vec<f64>,
    bending: Vec<f64>,
    tension: [Vec<f64>; 2],
    slope: [Vec<f64>; 2],
    /// m/h²; zero where held, and of guests.
    weight: [Vec<f64>; 2],
    /// α h and β/h.
    alpha: Vec<f64>,
    lag: Vec<f64>,
    pieces: Vec<Piece>,
    clusters: Vec<Joined>,
    filtered: [Filtered; 2],
    /// Predictor and increment, increment before the step that is measured, and work space.
    y: Field,
    d: Field,
    old: Field,
    work: Field,
}

/// What the line has stored, J.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::dynamics) struct Stored {
    pub kinetic: f64,
    pub elastic: f64,
}

impl Stored {
    pub fn all(self) -> f64 {
        self.kinetic + self.elastic
    }
}

/// What a step takes, J.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::dynamics) struct Lost {
    /// By all dampers, those of links and springs included.
    pub damped: f64,
    /// S, by the scheme.
    pub scheme: f64,
}

/// Energies of all islands.
#[derive(Debug, Clone)]
pub(in crate::dynamics) struct Forms {
    islands: Vec<Form>,
}

impl Forms {
    pub fn new<const DIM: usize>(steps: &Explicit<DIM>) -> Self {
        let all = 0..steps.own.len();
        Self {
            islands: all.map(|island| Form::new(steps, island)).collect(),
        }
    }

    /// What an island has stored half a step after the last one.
    pub fn stored<const DIM: usize>(
        &mut self,
        steps: &Explicit<DIM>,
        island: usize,
        grid: &Grid,
    ) -> Stored {
        let form = &mut self.islands[island];
        form.read(grid);
        form.stored(steps)
    }

    /// Keep the increments before a step.
    pub fn remember(&mut self, island: usize, grid: &Grid) {
        let form = &mut self.islands[island];
        form.read(grid);
        std::mem::swap(&mut form.old, &mut form.d);
    }

    /// What the step since has taken.
    pub fn lost<const DIM: usize>(
        &mut self,
        steps: &Explicit<DIM>,
        island: usize,
        grid: &Grid,
    ) -> Lost {
        let form = &mut self.islands[island];
        form.read(grid);
        form.lost(steps)
    }
}

impl Form {
    fn new<const DIM: usize>(steps: &Explicit<DIM>, island: usize) -> Self {
        let own = &steps.own[island];
        let slots = along_wires(steps, island);
        let mut number = vec![usize::MAX; steps.nodes.len()];
        slots
            .iter()
            .enumerate()
            .for_each(|(k, &slot)| number[slot] = k);
        let is_guest = |slot: usize| steps.points[steps.nodes[slot]] != slot;
        let of = |read: &dyn Fn(usize, usize) -> f64| -> Vec<f64> {
            let read = |&slot: &usize| {
                let (row, lane) = place(slot);
                read(row, lane)
            };
            slots.iter().map(read).collect()
        };
        let both = |read: &dyn Fn(usize, usize, usize) -> f64| {
            [0, 1].map(|c| {
                if c + 1 < DIM {
                    of(&|r, l| read(c, r, l))
                } else {
                    Vec::new()
                }
            })
        };
        let weight = both(&|c, row, lane| {
            let inverse = steps.across[c][row].inverse[lane];
            let moves = inverse > 0.0 && !is_guest(LANES * row + lane);
            if moves { 1.0 / inverse } else { 0.0 }
        });
        let filter = of(&|r, l| steps.common[r].filter[l]);
        let second = of(&|r, l| steps.common[r].second[l]);
        let reaches = own
            .blocks
            .iter()
            .flat_map(|b| &steps.reaches[b.reaches.clone()]);
        let piece = |reach: &super::Reach| Piece {
            masters: reach.masters.map(|m| m as usize - own.masters.start),
            points: reach.ends.map(|slot| number[slot as usize]),
            stiffness: reach.stiffness,
            lean: reach.lean,
        };
        let mut clusters: Vec<usize> = slots
            .iter()
            .filter_map(|&s| steps.in_cluster[s])
            .map(|c| c.0)
            .collect();
        clusters.sort_unstable();
        clusters.dedup();
        let joint = |member: &Member| Joint {
            point: number[member.point],
            along: Along {
                masters: member.along.masters.map(|m| m - own.masters.start),
                share: member.along.share,
            },
        };
        let joined = |number: usize| Joined {
            number,
            joints: steps.clusters[number].members.iter().map(joint).collect(),
        };
        Self {
            masters: own.masters.clone(),
            per_length: of(&|r, l| steps.common[r].per_length[l]),
            bending: of(&|r, l| steps.common[r].bending[l]),
            tension: both(&|c, r, l| steps.across[c][r].tension[l]),
            slope: both(&|c, r, l| steps.across[c][r].slope[l]),
            filtered: [0, 1].map(|c| Filtered::new(&weight[c], &filter, &second)),
            alpha: of(&|r, l| steps.damped[r].alpha[l]),
            lag: of(&|r, l| steps.damped[r].lag[l]),
            pieces: reaches.map(piece).collect(),
            clusters: clusters.into_iter().map(joined).collect(),
            y: Field::default(),
            d: Field::default(),
            old: Field::default(),
            work: Field::default(),
            weight,
            slots,
        }
    }

    /// Read y and d.
    fn read(&mut self, grid: &Grid) {
        for (c, rows) in grid.moving.iter().enumerate() {
            let (y, d) = (&mut self.y.across[c], &mut self.d.across[c]);
            y.clear();
            d.clear();
            for (&slot, &lag) in self.slots.iter().zip(&self.lag) {
                let (row, lane) = place(slot);
                let row = &rows[row];
                d.push(row.d[lane]);
                y.push(row.s[lane] - lag * row.d[lane]);
            }
        }
        let [x, d] = [0, 1].map(|k| &grid.x[k][self.masters.clone()]);
        for (to, from) in [(&mut self.y, x), (&mut self.d, d)] {
            to.along.clear();
            to.along.extend_from_slice(from);
        }
    }

    /// x·K_E z
    fn of_wires(&self, x: &Field, z: &Field) -> f64 {
        let mut sum = 0.0;
        for c in 0..2 {
            let (x, z) = (&x.across[c][..], &z.across[c][..]);
            let Some(last) = x.len().checked_sub(1) else {
                continue;
            };
            let (per, tension) = (&self.per_length[..], &self.tension[c][..]);
            let pairs = [tension, x, &x[1..], z, &z[1..]];
            sum += total(pairs, |[t, x0, x1, z0, z1]| t * (x1 - x0) * (z1 - z0));
            if last > 1 {
                let lists = [
                    &self.bending[1..],
                    per,
                    &per[1..],
                    x,
                    &x[1..],
                    &x[2..],
                    z,
                    &z[1..],
                    &z[2..],
                ];
                sum += total(lists, |[b, p0, p1, x0, x1, x2, z0, z1, z2]| {
                    let (x, z) = (
                        (x2 - x1) * p1 - (x1 - x0) * p0,
                        (z2 - z1) * p1 - (z1 - z0) * p0,
                    );
                    b * x * z
                });
            }
        }
        for piece in &self.pieces {
            let [a, b] = piece.masters;
            let [from, to] = piece.points;
            let stretched = |f: &Field| {
                let mut by = f.along[b] - f.along[a];
                if piece.lean != 0.0 {
                    by -= piece.lean * (f.across[0][from] + f.across[0][to]);
                }
                for (slope, r) in self.slope.iter().zip(&f.across) {
                    if let Some(r) = r.get(from..=to) {
                        let lists = [&slope[from..to], r, &r[1..]];
                        by += total(lists, |[slope, r0, r1]| slope * (r1 - r0));
                    }
                }
                by
            };
            sum += piece.stiffness * stretched(x) * stretched(z);
        }
        sum
    }

    /// From y and d.
    fn stored<const DIM: usize>(&mut self, steps: &Explicit<DIM>) -> Stored {
        let mut before = std::mem::take(&mut self.work);
        before.set(&self.y, &self.d, |y, d| y - d);
        let mut elastic = 0.5 * self.of_wires(&self.y, &before);
        for joined in &self.clusters {
            elastic += match steps.clusters[joined.number].size {
                ..=FEW => joined.stored::<DIM, FEW>(steps, self),
                _ => joined.stored::<DIM, WIDEST>(steps, self),
            };
        }
        self.work = before;
        let mut kinetic = energy(&self.filtered, &self.weight, &self.d.across);
        let inverse = &steps.masters.inverse[self.masters.clone()];
        for (d, inverse) in self.d.along.iter().zip(inverse).filter(|(_, i)| **i > 0.0) {
            kinetic += 0.5 * d * d / inverse;
        }
        Stored { kinetic, elastic }
    }

    /// From d and that before the step.
    fn lost<const DIM: usize>(&mut self, steps: &Explicit<DIM>) -> Lost {
        let mut lost = Lost::default();
        for joined in &self.clusters {
            lost = lost.and(match steps.clusters[joined.number].size {
                ..=FEW => joined.lost::<DIM, FEW>(steps, self),
                _ => joined.lost::<DIM, WIDEST>(steps, self),
            });
        }
        let mut moved = std::mem::take(&mut self.work);
        moved.set(&self.d, &self.old, |d, old| 0.5 * (d + old));
        for c in 0..DIM - 1 {
            let (old, moved) = (&mut self.old.across[c][..], &moved.across[c][..]);
            let lists = [&self.weight[c][..], &self.alpha, old, moved];
            lost.damped += total(lists, |[weight, alpha, d, z]| weight * alpha * d * z);
            old.iter_mut().zip(&self.lag).for_each(|(d, lag)| *d *= lag);
        }
        let masters = &steps.masters;
        for (m, (d, z)) in self
            .masters
            .clone()
            .zip(self.old.along.iter_mut().zip(&moved.along))
        {
            if masters.inverse[m] > 0.0 {
                lost.damped += masters.damping[m] / masters.inverse[m] * *d * *z;
            }
            *d *= masters.lag[m];
        }
        lost.damped += self.of_wires(&self.old, &moved);
        self.work = moved;
        lost
    }
}

impl Field {
    /// Number by number of two others.
    fn set(&mut self, a: &Self, b: &Self, of: impl Fn(f64, f64) -> f64) {
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
fn total<const K: usize>(lists: [&[f64]; K], term: impl Fn([f64; K]) -> f64) -> f64 {
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

impl Lost {
    pub fn and(self, other: Self) -> Self {
        Self {
            damped: self.damped + other.damped,
            scheme: self.scheme + other.scheme,
        }
    }
}

impl Joined {
    /// Components of its points, along the track first.
    #[inline(always)]
    fn read<const DIM: usize, const N: usize>(&self, field: &Field) -> [f64; N] {
        let mut found = [0.0; N];
        for (joint, at) in self.joints.iter().zip(found.chunks_exact_mut(DIM)) {
            at[0] = joint.along.read(&field.along);
            for c in 1..DIM {
                at[c] = field.across[c - 1][joint.point];
            }
        }
        found
    }

    /// For no more than `N` components.
    fn stored<const DIM: usize, const N: usize>(&self, steps: &Explicit<DIM>, form: &Form) -> f64 {
        let cluster = &steps.clusters[self.number];
        let mut z = self.read::<DIM, N>(&form.y);
        let mut d = self.read::<DIM, N>(&form.d);
        for k in 0..N {
            z[k] -= 0.5 * d[k];
            d[k] = if k % DIM == 0 { d[k] } else { 0.0 };
        }
        let k = &cluster.stiffness;
        0.5 * cluster.form(k, &z, &z) - 0.125 * cluster.form(k, &d, &d)
    }

    /// With increments before and after the step.
    fn lost<const DIM: usize, const N: usize>(&self, steps: &Explicit<DIM>, form: &Form) -> Lost {
        let cluster = &steps.clusters[self.number];
        let old = self.read::<DIM, N>(&form.old);
        let new = self.read::<DIM, N>(&form.d);
        let [mut moved, mut seen, mut aside, mut pulled] = [[0.0; N]; 4];
        for k in 0..N {
            moved[k] = 0.5 * (old[k] + new[k]);
            if k % DIM == 0 {
                (seen[k], pulled[k]) = (old[k], new[k] - old[k]);
            } else {
                (seen[k], aside[k]) = (moved[k], moved[k]);
            }
        }
        Lost {
            damped: cluster.form(&cluster.damping, &seen, &moved) * steps.per_step,
            scheme: -0.25 * cluster.form(&cluster.stiffness, &pulled, &aside),
        }
    }
}

impl Cluster {
    /// xᵀ A z
    fn form(&self, a: &[f64], x: &[f64], z: &[f64]) -> f64 {
        let rows = a.chunks_exact(self.size).zip(x);
        let of_row =
            |(row, x): (&[f64], &f64)| x * row.iter().zip(z).map(|(a, z)| a * z).sum::<f64>();
        rows.map(of_row).sum()
    }
}

impl Filtered {
    fn new(weight: &[f64], filter: &[f64], second: &[f64]) -> Self {
        let n = weight.len();
        let mut a = vec![[0.0; 3]; n + 2];
        for (k, weight) in weight.iter().enumerate() {
            a[k][0] += if *weight > 0.0 { *weight } else { 1.0 };
        }
        // Rows of what does not move are those of the unit matrix.
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
                let more = if k > 1 {
                    far * pivots[k - 2] * below[k - 1][0]
                } else {
                    0.0
                };
                near = (a[k - 1][1] - more) / pivots[k - 1];
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

/// ½ dᵀ M* d/h² of all directions, with (M/h² + E) x = M d/h² and M* d/h² = M x/h²: so it is half of bᵀ (L D Lᵀ)⁻¹ b.
///
/// Both directions in one loop: each number waits for the one before it.
fn energy(filtered: &[Filtered; 2], weight: &[Vec<f64>; 2], d: &[Vec<f64>; 2]) -> f64 {
    let (mut sums, mut last) = ([0.0; 2], [[0.0; 2]; 2]);
    let mut go = |c: usize, k: usize| {
        let [near, far] = filtered[c].below[k];
        let b = weight[c][k] * d[c][k] - far * last[c][1] - near * last[c][0];
        sums[c] += b * b * filtered[c].inverse[k];
        last[c] = [b, last[c][0]];
    };
    let both = d[0].len().min(d[1].len());
    for k in 0..both {
        go(0, k);
        go(1, k);
    }
    (both..d[0].len()).for_each(|k| go(0, k));
    0.5 * (sums[0] + sums[1])
}

/// Slots of an island, point by point along its wires.
fn along_wires<const DIM: usize>(steps: &Explicit<DIM>, island: usize) -> Vec<usize> {
    let mut found = Vec::new();
    for block in &steps.own[island].blocks {
        for lane in 0..LANES {
            let slots = block.rows.clone().map(|row| LANES * row + lane);
            found.extend(slots.filter(|&slot| steps.nodes[slot] != usize::MAX));
        }
    }
    found
}

impl<const DIM: usize> Explicit<DIM> {
    /// z of a node before the step that has been found, and how far it moves in it: see above.
    pub(in crate::dynamics) fn halves(&self, grid: &Grid, node: usize) -> [[f64; 2]; DIM] {
        let slot = self.points[node];
        let ((row, lane), [a, b]) = (place(slot), self.along[slot].masters);
        let mut found = [[0.0; 2]; DIM];
        let of = |m: usize| {
            let (x, d) = (grid.x[0][m], grid.x[1][m]);
            let more = self.masters.inverse[m] * grid.pull[m] - self.masters.damping[m] * d;
            [x - 0.5 * d, d + 0.5 * more]
        };
        let (first, second, share) = (of(a), of(b), self.along[slot].share);
        found[0] = [0, 1].map(|k| (1.0 - share) * first[k] + share * second[k]);
        for (across, rows) in grid.moving.iter().enumerate() {
            let a = self.acceleration(across, slot, rows);
            let (s, d) = (rows[row].s[lane], rows[row].d[lane]);
            let z = s - (self.damped[row].lag[lane] + 0.5) * d;
            found[across + 1] = [z, d + 0.5 * a];
        }
        found
    }
}
