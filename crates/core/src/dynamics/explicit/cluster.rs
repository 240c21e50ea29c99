//! Links, struts and springs: implicit, on the few points that they couple.
//!
//! The forces q on the points of a cluster obey q = −K u − C v at the end of the step, where u and v
//! across contain q itself: u = u° + β h² P q, v = v° + ½ h P q, with P the response of a point to a
//! force on it. Along the wire, where masses are those of metres of it, u and v are those of the predictor.
//!
//!   q = −W (K u° + C v°),   W = (1 + (β h² K + ½ h C) P)⁻¹

use super::Along;
use crate::error::CoreError;
use crate::linalg::dense::inverse;

/// Numbers in a column of the largest cluster.
pub(super) const WIDEST: usize = 48;

/// A point of a cluster, with what a step needs of it in one place.
#[derive(Debug, Clone)]
pub(super) struct Member {
    pub point: usize,
    pub node: usize,
    pub along: Along,
    /// 1/m across, 1/kg.
    pub inverse: [f64; 2],
    /// P across, 1/kg.
    pub response: [f64; 2],
    /// q of the segments before and behind, kg.
    pub filter: [f64; 2],
}

impl Member {
    /// Acceleration across, from w.
    #[inline(always)]
    pub fn acceleration(&self, across: usize, w: &[f64]) -> f64 {
        let w = &w[self.point - 1..][..3];
        let (left, right) = (
            self.filter[0] * (w[1] - w[0]),
            self.filter[1] * (w[2] - w[1]),
        );
        w[1] - self.inverse[across] * (right - left)
    }
}

/// Matrices of a cluster: one row and column for each component of each point, along the track first.
#[derive(Debug, Clone)]
pub(super) struct Cluster {
    pub members: Vec<Member>,
    /// K, N/m.
    pub stiffness: Vec<f64>,
    /// Numbers in each column below: those of the cluster, and zeros that fill the lanes.
    pub width: usize,
    /// −W K and −W C, column by column: of each the numbers for u°, then those for v°.
    pub columns: Vec<f64>,
    /// β h² W K + ½ h W C: what a change of the acceleration without q changes in −q.
    pub of_change: Vec<f64>,
}

impl Cluster {
    /// From K, C and P, row by row.
    pub fn new(members: Vec<Member>, (k, c): (&[f64], &[f64]), h: f64) -> Result<Self, CoreError> {
        let response = members.iter().flat_map(|m| {
            let across = (k.len().isqrt() / members.len()) - 1;
            std::iter::once(0.0).chain(m.response.into_iter().take(across))
        });
        let response: Vec<f64> = response.collect();
        let n = response.len();
        let width = [4, 8, WIDEST].into_iter().find(|&w| n <= w);
        let width = width.ok_or_else(|| {
            super::refuse(&format!("{} points linked with each other", members.len()))
        })?;
        let matrix: Vec<f64> = (0..n * n)
            .map(|at| {
                let one = f64::from(u8::from(at / n == at % n));
                one + (super::BETA * h * h * k[at] + 0.5 * h * c[at]) * response[at % n]
            })
            .collect();
        let w = inverse(&matrix, n).ok_or_else(|| super::refuse("links that nothing moves"))?;
        let times = |m: &[f64]| -> Vec<f64> {
            let entry = |at: usize| (0..n).map(|j| w[at / n * n + j] * m[j * n + at % n]).sum();
            (0..n * n).map(entry).collect()
        };
        let (of_place, of_speed) = (times(k), times(c));
        let both = of_place.iter().zip(&of_speed);
        let of_change = both.map(|(k, c)| super::BETA * h * h * k + 0.5 * h * c);
        let of_change = of_change.collect();
        let column = |j: usize| {
            let of = |m: &[f64]| {
                let mut column: Vec<f64> = (0..n).map(|i| -m[i * n + j]).collect();
                column.resize(width, 0.0);
                column
            };
            [of(&of_place), of(&of_speed)].concat()
        };
        Ok(Self {
            members,
            width,
            stiffness: k.to_vec(),
            columns: (0..n).flat_map(column).collect(),
            of_change,
        })
    }
}
