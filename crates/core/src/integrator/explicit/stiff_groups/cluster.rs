//! Links, struts and springs: implicit, on the few points that they couple.
//!
//! The forces q on the points of a cluster obey q = −K u − C v at the end of the step, where u and v
//! across contain q itself: u = u° + β P q, h v = h v° + ½ P q, with P the response h²/m of a point to a
//! force on it. Along the wire, where masses are those of metres of it, u and v are those of the predictor.
//!
//!   q = −W (K u° + C v°),   W = (1 + (β K + C/2h) P)⁻¹

use crate::error::CoreError;
use crate::integrator::explicit::Along;
use crate::linalg::dense::inverse;

/// Share of the largest entry of a matrix that is rounding of the tangent of a link.
const ROUNDING: f64 = 1e-13;
/// Components of the largest cluster.
pub(in crate::integrator::explicit) const WIDEST: usize = 48;

/// A point of a cluster.
#[derive(Debug, Clone)]
pub(in crate::integrator::explicit) struct Member {
    pub point: usize,
    pub node: usize,
    pub along: Along,
    /// h²/m across, s²/kg.
    pub inverse: [f64; 2],
    /// P across, s²/kg.
    pub response: [f64; 2],
    /// q/h² of the segments before and behind, kg/s².
    pub filter: [f64; 2],
    /// r/h² of the points before and behind and of its own, kg/s², in their order.
    pub second: [f64; 3],
    /// β/h of the wire.
    pub lag: f64,
}

impl Member {
    /// P, component by component, along the track first.
    fn responses(&self, across: usize) -> impl Iterator<Item = f64> {
        std::iter::once(0.0).chain(self.response.into_iter().take(across))
    }
}

/// Matrices of a cluster: one row and column for each component of each point, along the track first.
#[derive(Debug, Clone)]
pub(in crate::integrator::explicit) struct Cluster {
    pub members: Vec<Member>,
    /// Rows.
    pub size: usize,
    /// K, N/m, and C, N·s/m.
    pub stiffness: Vec<f64>,
    pub damping: Vec<f64>,
    /// −W K, N/m, and −W C/h, N/m: what q is for u°, and for h v°.
    pub of_place: Vec<f64>,
    pub of_speed: Vec<f64>,
    /// β W K + ½ W C/h: what a change of the acceleration without q, times h², changes in −q.
    pub of_change: Vec<f64>,
    /// What it is as a pair, if it is one.
    pub pair: Option<Pair>,
}

/// The same for two points of which nothing but their difference Δ = u₂ − u₁ counts, as with a single link:
/// K = [k −k; −k k], and C likewise, so q₂ = −q₁ = −w (k Δu° + c Δv°), w = (1 + (β k + c/2h) (P₁ + P₂))⁻¹.
#[derive(Debug, Clone)]
pub(in crate::integrator::explicit) struct Pair {
    /// Rows.
    pub size: usize,
    /// −w k and −w c/h, N/m.
    pub of_place: Vec<f64>,
    pub of_speed: Vec<f64>,
}

impl Cluster {
    /// From K, C and P, row by row.
    pub fn new(members: Vec<Member>, (k, c): (&[f64], &[f64]), h: f64) -> Result<Self, CoreError> {
        let n = k.len().isqrt();
        if n > WIDEST {
            let many = members.len();
            return Err(crate::integrator::explicit::refuse(&format!(
                "{many} points linked with each other"
            )));
        }
        let across = n / members.len() - 1;
        let response: Vec<f64> = members.iter().flat_map(|m| m.responses(across)).collect();
        let [of_place, of_speed] = forces((k, c), &response, h)?;
        let pair = Pair::new(&members, (k, c), h)?;
        let both = of_place.iter().zip(&of_speed);
        let of_change = both
            .map(|(k, c)| -(crate::integrator::explicit::BETA * k + 0.5 * c))
            .collect();
        Ok(Self {
            members,
            size: n,
            stiffness: k.to_vec(),
            damping: c.to_vec(),
            of_place,
            of_speed,
            of_change,
            pair,
        })
    }
}

impl Pair {
    fn new(
        members: &[Member],
        (k, c): (&[f64], &[f64]),
        h: f64,
    ) -> Result<Option<Self>, CoreError> {
        let [first, second] = members else {
            return Ok(None);
        };
        let n = k.len().isqrt() / 2;
        let is_relative = |m: &[f64]| {
            let at = |row: usize, column: usize| m[row * 2 * n + column];
            let most = ROUNDING * m.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
            let of = |(i, j): (usize, usize)| {
                let (own, across) = (at(i, j), [at(n + i, j), at(i, n + j)]);
                let apart = across.map(|other| own + other);
                let apart = apart.into_iter().chain([own - at(n + i, n + j)]);
                apart.fold(0.0_f64, |all, v| all.max(v.abs())) <= most
            };
            (0..n * n).all(|place| of((place / n, place % n)))
        };
        if !is_relative(k) || !is_relative(c) {
            return Ok(None);
        }
        let of_difference = |m: &[f64]| -> Vec<f64> {
            let entry = |place: usize| m[place / n * 2 * n + place % n];
            (0..n * n).map(entry).collect()
        };
        let both = first.responses(n - 1).zip(second.responses(n - 1));
        let response: Vec<f64> = both.map(|(a, b)| a + b).collect();
        let [of_place, of_speed] = forces((&of_difference(k), &of_difference(c)), &response, h)?;
        Ok(Some(Self {
            size: n,
            of_place,
            of_speed,
        }))
    }
}

/// −W K and −W C/h with W = (1 + (β K + C/2h) P)⁻¹, row by row, for P of each component.
fn forces((k, c): (&[f64], &[f64]), response: &[f64], h: f64) -> Result<[Vec<f64>; 2], CoreError> {
    let n = response.len();
    let step = |k: f64, c: f64| crate::integrator::explicit::BETA * k + 0.5 / h * c;
    let matrix: Vec<f64> = (0..n * n)
        .map(|at| {
            let one = f64::from(u8::from(at / n == at % n));
            one + step(k[at], c[at]) * response[at % n]
        })
        .collect();
    let w = inverse(&matrix, n)
        .ok_or_else(|| crate::integrator::explicit::refuse("links that nothing moves"))?;
    let times = |m: &[f64], factor: f64| -> Vec<f64> {
        let entry = |at: usize| {
            let products = (0..n).map(|j| w[at / n * n + j] * m[j * n + at % n]);
            factor * products.sum::<f64>()
        };
        (0..n * n).map(entry).collect()
    };
    Ok([times(k, -1.0), times(c, -1.0 / h)])
}
