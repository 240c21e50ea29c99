//! Excitation of a pantograph, given for the whole run: forces, and the motion of its base.
//!
//! Springs and dampers act on displacements relative to the base, w = u − r z:
//!
//!   m ü + c (u̇ − r ż) + k (u − r z) = forces
//!
//! z is the displacement of the base, r the influence vector: the displacement of the pantograph
//! under a unit displacement of the base that strains nothing. A history has a value for the start
//! and one after each step; at the time of balance the scheme weighs old and new as it does
//! everywhere.

use crate::error::CoreError;
use crate::linalg::small::{add_scaled, matrix_vector};

/// History of a force of constant direction.
#[derive(Debug, Clone, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ForceHistory {
    /// Direction: force on the coordinates = direction · value.
    pub direction: Vec<f64>,
    /// Values, N, at the start and after each step.
    pub values: Vec<f64>,
}

/// Motion of the base of a pantograph.
#[derive(Debug, Clone, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct BaseMotion {
    /// Influence vector r: displacement of the pantograph for a unit displacement of the base that
    /// strains nothing.
    pub influence: Vec<f64>,
    /// Displacement z, m, at the start and after each step.
    pub displacement: Vec<f64>,
    /// Rate ż, m/s, at the same instants.
    pub rate: Vec<f64>,
}

/// Excitation of a pantograph; none by default.
#[derive(Debug, Clone, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Excitation {
    /// Forces.
    pub forces: Vec<ForceHistory>,
    /// Motion of the base; `None` when it is fixed.
    pub base: Option<BaseMotion>,
}

impl Excitation {
    /// Tells whether sizes and numbers fit a pantograph of `n` coordinates.
    pub(crate) fn is_valid(&self, n: usize) -> bool {
        let forces = self.forces.iter().map(|f| (&f.direction, [&f.values; 2]));
        let base = self.base.iter();
        let base = base.map(|b| (&b.influence, [&b.displacement, &b.rate]));
        forces.chain(base).all(|(direction, [a, b])| {
            let finite = |x: &[f64]| x.iter().all(|v| v.is_finite());
            let sized = direction.len() == n && !a.is_empty() && a.len() == b.len();
            sized && finite(direction) && finite(a) && finite(b)
        })
    }

    /// Checks that there is a value for each of `count` instants.
    ///
    /// # Errors
    /// [`CoreError::Input`].
    pub(crate) fn check_instants(&self, count: usize) -> Result<(), CoreError> {
        let forces = self.forces.iter().map(|f| f.values.len());
        let base = self.base.iter().map(|b| b.displacement.len());
        if forces.chain(base).all(|length| length == count) {
            return Ok(());
        }
        let reason = "not one given value for each instant of the travel";
        Err(CoreError::invalid("pantographs", reason))
    }

    /// Reads the excitation of a step; `old` is the weight of its start in the balance.
    pub fn read(&self, step: usize, old: f64, now: &mut ExcitationNow) {
        let between = |a: &[f64]| (1.0 - old) * a[step + 1] + old * a[step];
        now.force.fill(0.0);
        for history in &self.forces {
            add_scaled(between(&history.values), &history.direction, &mut now.force);
        }
        now.base = self.base.as_ref().map(|base| {
            [
                base.displacement[step + 1],
                between(&base.displacement),
                between(&base.rate),
            ]
        });
    }

    /// Force on each coordinate at the start, N, that of the displaced base included.
    pub(crate) fn start_forces(&self, stiffness: &[f64], n: usize) -> Vec<f64> {
        let mut force = vec![0.0; n];
        for history in &self.forces {
            add_scaled(history.values[0], &history.direction, &mut force);
        }
        if let Some(base) = &self.base {
            let per_displacement = matrix_vector(stiffness, &base.influence);
            add_scaled(base.displacement[0], &per_displacement, &mut force);
        }
        force
    }
}

/// Excitation of a pantograph in one step.
#[derive(Debug, Clone)]
pub struct ExcitationNow {
    /// Force on each coordinate at the time of balance, N.
    pub force: Vec<f64>,
    /// Displacement of the base at the end of the step and at the time of balance, m, and its
    /// rate at the time of balance, m/s; `None` when the base is fixed.
    pub base: Option<[f64; 3]>,
}

impl ExcitationNow {
    /// No force and no motion, for a pantograph of `n` coordinates.
    #[must_use]
    pub fn zero(n: usize) -> Self {
        Self {
            force: vec![0.0; n],
            base: None,
        }
    }
}

/// Excitation of a pantograph in the present step, and the displacement of its base.
#[derive(Debug, Clone)]
pub(crate) struct ExcitationState {
    /// Influence vector r, zero when the base is fixed.
    pub(crate) influence: Vec<f64>,
    /// Forces k r and c r per displacement and per rate of the base, N/m and N·s/m.
    base_forces: [Vec<f64>; 2],
    /// Displacement of the base at the start of the step, m; after it was committed at its end.
    pub(crate) displacement: f64,
    /// Displacement of the base at the end of the step, m.
    pub(crate) end_displacement: f64,
    /// Displacement and rate of the base at the time of balance, m and m/s.
    pub(crate) balance: [f64; 2],
    /// Given forces at the time of balance, N.
    pub(crate) force: Vec<f64>,
}

impl ExcitationState {
    /// Excitation at the start of a run, with the matrices k and c of the pantograph.
    pub(crate) fn new(
        excitation: &Excitation,
        stiffness: &[f64],
        damping: &[f64],
        n: usize,
    ) -> Self {
        let zero = vec![0.0; n];
        let base = excitation.base.as_ref();
        let influence = base.map_or(zero.clone(), |b| b.influence.clone());
        let displacement = base.map_or(0.0, |b| b.displacement[0]);
        Self {
            base_forces: [stiffness, damping].map(|matrix| matrix_vector(matrix, &influence)),
            influence,
            displacement,
            end_displacement: displacement,
            balance: [displacement, 0.0],
            force: zero,
        }
    }

    /// Sets the excitation of a step.
    pub(crate) fn set(&mut self, now: &ExcitationNow) {
        self.force.copy_from_slice(&now.force);
        if let Some([end, displacement, rate]) = now.base {
            self.end_displacement = end;
            self.balance = [displacement, rate];
        }
    }

    /// Adds given forces and the forces of the moving base to `f`, N.
    pub(crate) fn add_to(&self, f: &mut [f64]) {
        add_scaled(1.0, &self.force, f);
        for (force, motion) in self.base_forces.iter().zip(self.balance) {
            add_scaled(motion, force, f);
        }
    }
}
