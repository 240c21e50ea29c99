//! What acts on a rider from outside, given for the whole run: forces, and the motion of its ground.
//!
//! Springs and dampers feel the rider relative to its ground, w = u − r z:
//!
//!   m ü + c (u̇ − r ż) + k (u − r z) = forces
//!
//! z is the displacement of the ground, r the displacement of the rider that goes with a unit of it
//! and strains nothing. A history has a value for the start and one after each step; at the time of
//! balance the scheme weighs old and new as it does everywhere.

use crate::error::CoreError;
use crate::pantograph::system::multiply;

/// A force over time: the same direction always, its size given.
#[derive(Debug, Clone, Default)]
pub struct ForceHistory {
    /// Where it acts: force = direction · value.
    pub direction: Vec<f64>,
    /// N, at the start and after each step.
    pub values: Vec<f64>,
}

/// Motion of the ground that a rider stands on.
#[derive(Debug, Clone, Default)]
pub struct BaseMotion {
    /// r: displacement of the rider when the ground rises by one and nothing is strained.
    pub carried: Vec<f64>,
    /// z in m, at the start and after each step.
    pub displacement: Vec<f64>,
    /// ż in m/s at the same instants.
    pub rate: Vec<f64>,
}

/// All that is given for a rider; nothing by default.
#[derive(Debug, Clone, Default)]
pub struct Excitation {
    /// Forces.
    pub forces: Vec<ForceHistory>,
    /// Motion of the ground; `None` when it stands still.
    pub ground: Option<BaseMotion>,
}

impl Excitation {
    /// Check sizes and numbers for a rider of `n` coordinates.
    pub(crate) fn is_sound(&self, n: usize) -> bool {
        let forces = self.forces.iter().map(|f| (&f.direction, [&f.values; 2]));
        let ground = self.ground.iter();
        let ground = ground.map(|g| (&g.carried, [&g.displacement, &g.rate]));
        forces.chain(ground).all(|(direction, [a, b])| {
            let finite = |x: &[f64]| x.iter().all(|v| v.is_finite());
            let sized = direction.len() == n && !a.is_empty() && a.len() == b.len();
            sized && finite(direction) && finite(a) && finite(b)
        })
    }

    /// Check that there is a value for each of the given number of instants.
    ///
    /// # Errors
    /// [`CoreError::Input`].
    pub(crate) fn check_instants(&self, count: usize) -> Result<(), CoreError> {
        let forces = self.forces.iter().map(|f| f.values.len());
        let ground = self.ground.iter().map(|g| g.displacement.len());
        if forces.chain(ground).all(|length| length == count) {
            return Ok(());
        }
        let reason = "not one given value for each instant of the travel".into();
        Err(CoreError::Input {
            array: "riders",
            reason,
        })
    }

    /// Read the excitation of a step; `old` is the weight of its start in the balance.
    pub fn read(&self, step: usize, old: f64, now: &mut ExcitationNow) {
        let between = |a: &[f64]| (1.0 - old) * a[step + 1] + old * a[step];
        now.force.fill(0.0);
        for history in &self.forces {
            add(between(&history.values), &history.direction, &mut now.force);
        }
        now.ground = self.ground.as_ref().map(|ground| {
            [
                ground.displacement[step + 1],
                between(&ground.displacement),
                between(&ground.rate),
            ]
        });
    }

    /// Force on each coordinate at the start, with the ground where it is then; zero without any.
    pub(crate) fn at_start(&self, stiffness: &[f64], n: usize) -> Vec<f64> {
        let mut force = vec![0.0; n];
        for history in &self.forces {
            add(history.values[0], &history.direction, &mut force);
        }
        if let Some(ground) = &self.ground {
            let pull = multiply(stiffness, &ground.carried);
            add(ground.displacement[0], &pull, &mut force);
        }
        force
    }
}

/// Forces on a rider and motion of its ground in one step.
#[derive(Debug, Clone)]
pub struct ExcitationNow {
    /// Force on each coordinate at the time of balance, N.
    pub force: Vec<f64>,
    /// Displacement of the ground at the end of the step and at the time of balance in m, and its
    /// rate then in m/s; `None` when the ground stands still.
    pub ground: Option<[f64; 3]>,
}

impl ExcitationNow {
    /// No force and no motion, for a rider of `n` coordinates.
    #[must_use]
    pub fn zero(n: usize) -> Self {
        Self {
            force: vec![0.0; n],
            ground: None,
        }
    }
}

/// Excitation of a rider in the present step.
#[derive(Debug, Clone)]
pub(crate) struct ExcitationState {
    /// r, zero when the ground stands still.
    pub(crate) carried: Vec<f64>,
    /// k r and c r.
    pulls: [Vec<f64>; 2],
    /// Displacement of the ground now: at the start of the step, after it was taken at its end.
    pub(crate) now: f64,
    /// Displacement at the end of the step.
    pub(crate) end: f64,
    /// Displacement and rate at the time of balance.
    pub(crate) balance: [f64; 2],
    /// Given forces at the time of balance, N.
    pub(crate) force: Vec<f64>,
}

impl ExcitationState {
    pub(crate) fn new(given: &Excitation, stiffness: &[f64], damping: &[f64], n: usize) -> Self {
        let zero = vec![0.0; n];
        let ground = given.ground.as_ref();
        let carried = ground.map_or(zero.clone(), |g| g.carried.clone());
        let now = ground.map_or(0.0, |g| g.displacement[0]);
        Self {
            pulls: [stiffness, damping].map(|matrix| multiply(matrix, &carried)),
            carried,
            now,
            end: now,
            balance: [now, 0.0],
            force: zero,
        }
    }

    /// Take the excitation of a step.
    pub(crate) fn begin(&mut self, now: &ExcitationNow) {
        self.force.copy_from_slice(&now.force);
        if let Some([end, displacement, rate]) = now.ground {
            self.end = end;
            self.balance = [displacement, rate];
        }
    }

    /// Add given forces and the pull of the moving ground.
    pub(crate) fn add_to(&self, f: &mut [f64]) {
        add(1.0, &self.force, f);
        for (pull, motion) in self.pulls.iter().zip(self.balance) {
            add(motion, pull, f);
        }
    }
}

fn add(factor: f64, x: &[f64], sum: &mut [f64]) {
    for (sum, x) in sum.iter_mut().zip(x) {
        *sum += factor * x;
    }
}
