//! Links, struts and springs: implicit, on the few points that they couple.
//!
//! The forces q on the points of a cluster obey q = −K u − C v at the end of the step, where u and v
//! across contain q itself: u = u° + β h² P q, v = v° + ½ h P q, with P the response of a point to a
//! force on it. Along the wire, where masses are those of metres of it, u and v are those of the predictor.
//!
//!   q = −W (K u° + C v°),   W = (1 + (β h² K + ½ h C) P)⁻¹

use crate::error::CoreError;
use crate::linalg::dense::inverse;

/// Matrices of a cluster: one row and column for each component of each point, along the track first.
#[derive(Debug, Clone)]
pub(super) struct Cluster {
    pub points: Vec<usize>,
    /// K, N/m.
    pub stiffness: Vec<f64>,
    /// W K and W C.
    pub of_place: Vec<f64>,
    pub of_speed: Vec<f64>,
    /// β h² W K + ½ h W C: what a change of the acceleration without q changes in −q.
    pub of_change: Vec<f64>,
}

impl Cluster {
    /// From K, C and P, row by row.
    pub fn new(
        points: Vec<usize>,
        k: &[f64],
        c: &[f64],
        response: &[f64],
        h: f64,
    ) -> Result<Self, CoreError> {
        let n = response.len();
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
        Ok(Self {
            points,
            stiffness: k.to_vec(),
            of_change: of_change.collect(),
            of_place,
            of_speed,
        })
    }
}
