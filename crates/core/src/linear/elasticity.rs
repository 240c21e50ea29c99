//! Elasticity of a line at rest, of one wire or of several that are lifted together.
//!
//!   W f = e 1,   1ᵀf = 1,   so   e = 1/(1ᵀW⁻¹1)
//!
//! with W the lift of the wires under unit forces on them.

use crate::error::CoreError;
use crate::linalg::dense;
use crate::linear::static_response::{StaticSolver, StaticState};
use crate::slideline::Slideline;
use crate::slideline::point::SlidelinePoint;
use crate::slideline::residual_flexibility::LocalCompliance;

/// Lifts of several wires that differ by less than this share are the same.
const ALIKE: f64 = 1e-9;
/// Share of the force over which W is found: lifts are linear but for links that become slack.
const NEARBY: f64 = 1e-4;
/// Each round fixes which links are slack; a few do.
const ROUNDS: usize = 60;

impl<const DIM: usize, const D: usize> StaticSolver<'_, DIM, D> {
    /// Elasticity e = u/p in m/N at coordinates `x`, for a force `p` in N that lifts all wires there
    /// together; with p = 0 the limit of a small force, which neither slackens a link nor takes up
    /// the slack of one.
    ///
    /// # Errors
    /// [`CoreError::Input`] when the force is impossible or wires side by side yield as one,
    /// [`CoreError::OffWire`], or those of [`StaticSolver::solve`].
    pub fn elasticity(
        &mut self,
        lanes: &[Slideline<DIM>],
        x: &[f64],
        force: f64,
    ) -> Result<Vec<f64>, CoreError> {
        if !(force.is_finite() && force >= 0.0) {
            return Err(CoreError::Input {
                array: "force",
                reason: format!("{force} N"),
            });
        }
        let mut hints = vec![0; lanes.len()];
        let rest = self.press(&[], &[])?;
        x.iter()
            .enumerate()
            .map(|(i, &position)| {
                let mut places = Vec::with_capacity(lanes.len());
                for (lane, hint) in lanes.iter().zip(&mut hints) {
                    if let Some(place) = lane.locate(position, *hint) {
                        *hint = place.element;
                        places.push((place, lane.yield_at(&place)));
                    }
                }
                match places[..] {
                    [] => Err(CoreError::OffWire {
                        rider: i,
                        position,
                        step: 0,
                    }),
                    [place] if force > 0.0 => Ok(self.rises(&[place], &[force], &rest)?[0] / force),
                    _ if force > 0.0 => self.together(&places, force, &rest),
                    _ => {
                        let w = self.lifts_with_own(&places);
                        if places.len() == 1 {
                            return Ok(w[0]);
                        }
                        Ok(shares(&w, places.len()).ok_or_else(yield_as_one)?.1)
                    }
                }
            })
            .collect()
    }

    /// Lift of each wire under a unit force on each: W, row by row.
    fn lifts_with_own(&self, places: &[(SlidelinePoint<DIM>, LocalCompliance)]) -> Vec<f64> {
        let n = places.len();
        let mut w = self.lifts(places);
        for (i, (_, yields)) in places.iter().enumerate() {
            w[i * n + i] += yields.own;
        }
        w
    }

    fn rises(
        &mut self,
        places: &[(SlidelinePoint<DIM>, LocalCompliance)],
        forces: &[f64],
        rest: &StaticState<D>,
    ) -> Result<Vec<f64>, CoreError> {
        let state = self.press(places, forces)?;
        let rise = |((place, yields), force): (&(SlidelinePoint<DIM>, LocalCompliance), &f64)| {
            let moved =
                place.displacement(&state.u, DIM - 1) - place.displacement(&rest.u, DIM - 1);
            let pulled = state.raised(self.line, yields) - rest.raised(self.line, yields);
            moved + pulled + yields.own * force
        };
        Ok(places.iter().zip(forces).map(rise).collect())
    }

    /// Common rise per force of several wires: Newton's method on how the force is shared.
    fn together(
        &mut self,
        places: &[(SlidelinePoint<DIM>, LocalCompliance)],
        force: f64,
        rest: &StaticState<D>,
    ) -> Result<f64, CoreError> {
        let n = places.len();
        let alone = shares(&self.lifts_with_own(places), n);
        let mut forces = alone.ok_or_else(yield_as_one)?.0;
        forces.iter_mut().for_each(|f| *f *= force);
        for round in 0..ROUNDS {
            let rises = self.rises(places, &forces, rest)?;
            // Which links are slack changes from round to round, and W with it.
            let mut w = vec![0.0; n * n];
            for j in 0..n {
                let mut more = forces.clone();
                more[j] += NEARBY * force;
                let moved = self.rises(places, &more, rest)?;
                for i in 0..n {
                    w[i * n + j] = (moved[i] - rises[i]) / (NEARBY * force);
                }
            }
            let (share, _) = shares(&w, n).ok_or_else(yield_as_one)?;
            let mean = inner(&share, &rises);
            let mut change: Vec<f64> = rises.iter().map(|rise| mean - rise).collect();
            if change.iter().all(|c| c.abs() <= ALIKE * mean.abs()) {
                return Ok(mean / force);
            }
            if !dense::solve_in_place(&mut w, &mut change) {
                return Err(yield_as_one());
            }
            // Full steps may go to and fro between two sets of slack links.
            let step = if round < ROUNDS / 4 { 1.0 } else { 0.5 };
            let pairs = forces.iter_mut().zip(&change);
            pairs.for_each(|(f, change)| *f += step * change);
        }
        Err(CoreError::SlackSet { step: 0, time: 0.0 })
    }
}

/// Shares of a unit force with which all wires rise alike, and that rise; `None` when W is singular.
fn shares(w: &[f64], n: usize) -> Option<(Vec<f64>, f64)> {
    let (mut a, mut f) = (w.to_vec(), vec![1.0; n]);
    if !dense::solve_in_place(&mut a, &mut f) {
        return None;
    }
    let sum: f64 = f.iter().sum();
    f.iter_mut().for_each(|f| *f /= sum);
    (1.0 / sum).is_finite().then_some((f, 1.0 / sum))
}

fn yield_as_one() -> CoreError {
    CoreError::Input {
        array: "lanes",
        reason: "wires side by side that do not yield each on its own".into(),
    }
}

fn inner(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
