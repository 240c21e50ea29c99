//! Stiff group: links, struts and springs, implicit, on the few points that they couple.
//!
//! The forces q on the points of a group obey q = −K u − C v at the end of the step, where u and v
//! across contain q itself: u = u° + β P q, h v = h v° + ½ P q, with P the response h²/m of a point
//! to a force on it. Along the wire, where each master has the mass of metres of it, u and v are
//! those of the predictor.
//!
//!   q = −W (K u° + C v°),   W = (1 + (β K + C/2h) P)⁻¹

use crate::error::CoreError;
use crate::integrator::explicit::AxialPosition;
use crate::linalg::dense::inverse;

/// Relative rounding of the entries of a link's tangent.
const ROUNDING: f64 = 1e-13;
/// Number of components of the largest stiff group.
pub(in crate::integrator::explicit) const WIDEST: usize = 48;

/// Point of a stiff group.
#[derive(Debug, Clone)]
pub(in crate::integrator::explicit) struct Member {
    pub point: usize,
    pub node: usize,
    pub axial_position: AxialPosition,
    /// Inverse mass h²/m across, s²/kg.
    pub inverse: [f64; 2],
    /// Response P across, s²/kg.
    pub response: [f64; 2],
    /// Filter weights q/h² of the segments before and behind, kg/s².
    pub filter: [f64; 2],
    /// Second filter weights r/h² of the preceding point, the point itself and the next one, kg/s².
    pub second: [f64; 3],
    /// Stiffness-proportional damping β/h of the wire.
    pub lag: f64,
}

impl Member {
    /// Returns P by component, s²/kg, along the track first.
    fn responses(&self, across: usize) -> impl Iterator<Item = f64> {
        std::iter::once(0.0).chain(self.response.into_iter().take(across))
    }
}

/// Stiff group and its matrices: one row and column for each component of each point, along the
/// track first.
#[derive(Debug, Clone)]
pub(in crate::integrator::explicit) struct StiffGroup {
    pub members: Vec<Member>,
    /// Number of rows.
    pub size: usize,
    /// Stiffness K, N/m, and damping C, N·s/m.
    pub stiffness: Vec<f64>,
    pub damping: Vec<f64>,
    /// Matrices −W K and −W C/h, N/m: q per u°, and per h v°.
    pub position_columns: Vec<f64>,
    pub velocity_columns: Vec<f64>,
    /// Response β W K + ½ W C/h, N/m: change of −q per change of the acceleration without q, times
    /// h².
    pub response_to_acceleration: Vec<f64>,
    /// Reduced form for a pair of points, if it is one.
    pub pair: Option<RelativeGroup>,
}

/// Pair of points of which only the difference Δ = u₂ − u₁ counts, as with a single link:
/// K = \[k −k; −k k\], and C likewise, so
/// q₂ = −q₁ = −w (k Δu° + c Δv°), w = (1 + (β k + c/2h) (P₁ + P₂))⁻¹.
#[derive(Debug, Clone)]
pub(in crate::integrator::explicit) struct RelativeGroup {
    /// Number of rows.
    pub size: usize,
    /// Matrices −w k and −w c/h, N/m.
    pub position_columns: Vec<f64>,
    pub velocity_columns: Vec<f64>,
}

impl StiffGroup {
    /// Builds the matrices of a group from K and C, row by row.
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
        let [position_columns, velocity_columns] = force_columns((k, c), &response, h)?;
        let pair = RelativeGroup::new(&members, (k, c), h)?;
        let both = position_columns.iter().zip(&velocity_columns);
        let response_to_acceleration = both
            .map(|(k, c)| -(crate::integrator::explicit::BETA * k + 0.5 * c))
            .collect();
        Ok(Self {
            members,
            size: n,
            stiffness: k.to_vec(),
            damping: c.to_vec(),
            position_columns,
            velocity_columns,
            response_to_acceleration,
            pair,
        })
    }
}

impl RelativeGroup {
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
            let entry = |row: usize, column: usize| m[row * 2 * n + column];
            let most = ROUNDING * m.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
            let deviates_little = |(i, j): (usize, usize)| {
                let (diagonal, others) = (entry(i, j), [entry(n + i, j), entry(i, n + j)]);
                let deviations = others.map(|other| diagonal + other);
                let deviations = deviations
                    .into_iter()
                    .chain([diagonal - entry(n + i, n + j)]);
                deviations.fold(0.0_f64, |all, v| all.max(v.abs())) <= most
            };
            (0..n * n).all(|place| deviates_little((place / n, place % n)))
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
        let [position_columns, velocity_columns] =
            force_columns((&of_difference(k), &of_difference(c)), &response, h)?;
        Ok(Some(Self {
            size: n,
            position_columns,
            velocity_columns,
        }))
    }
}

/// Returns −W K and −W C/h, N/m, with W = (1 + (β K + C/2h) P)⁻¹, row by row, for P of each
/// component.
fn force_columns(
    (k, c): (&[f64], &[f64]),
    response: &[f64],
    h: f64,
) -> Result<[Vec<f64>; 2], CoreError> {
    let n = response.len();
    let step = |k: f64, c: f64| crate::integrator::explicit::BETA * k + 0.5 / h * c;
    let matrix: Vec<f64> = (0..n * n)
        .map(|index| {
            let one = f64::from(u8::from(index / n == index % n));
            one + step(k[index], c[index]) * response[index % n]
        })
        .collect();
    let w = inverse(&matrix, n)
        .ok_or_else(|| crate::integrator::explicit::refuse("links that nothing moves"))?;
    let times = |m: &[f64], factor: f64| -> Vec<f64> {
        let entry = |index: usize| {
            let products = (0..n).map(|j| w[index / n * n + j] * m[j * n + index % n]);
            factor * products.sum::<f64>()
        };
        (0..n * n).map(entry).collect()
    };
    Ok([times(k, -1.0), times(c, -1.0 / h)])
}
