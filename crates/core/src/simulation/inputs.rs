//! Inputs of one step: positions of the pantographs, and prescribed forces.

use crate::linear::loads::{Load, Loads};
use crate::pantograph::excitation::ExcitationNow;
use crate::pantograph::model::Pantograph;

/// Motion along the track, friction, and prescribed loads.
#[derive(Debug, Clone)]
pub struct Trajectory {
    /// Position of the first pantograph at the start and after each step, m.
    pub positions: Vec<f64>,
    /// Speed at the same instants, m/s.
    pub speeds: Vec<f64>,
    /// Distance of each pantograph behind the first, m.
    pub distances: Vec<f64>,
    /// Coefficient of friction along the wire.
    pub friction: f64,
    /// Loads on the line, with sizes at the same instants.
    pub loads: Vec<Load>,
}

/// Inputs of one step. Forces of actuators are part of the state, which holds them from one
/// sample to the next.
#[derive(Debug, Clone, Copy)]
pub struct Inputs<'a> {
    /// Position of the first pantograph at the start of the step, at the time of balance, and at
    /// its end, m.
    pub positions: [f64; 3],
    /// Speed at the time of balance, m/s.
    pub speed: f64,
    /// Forces on nodes of the line.
    pub loads: Loads<'a>,
    /// Forces on each pantograph and its base motion; empty where there are none.
    pub excitations: &'a [ExcitationNow],
}

/// Inputs of a run, step by step, from its histories.
#[derive(Debug)]
pub(crate) struct Histories<'a> {
    trajectory: &'a Trajectory,
    pantographs: &'a [Pantograph],
    sizes: Vec<f64>,
    excitations: Vec<ExcitationNow>,
}

impl<'a> Histories<'a> {
    pub(crate) fn new(trajectory: &'a Trajectory, pantographs: &'a [Pantograph]) -> Self {
        let excitations = pantographs
            .iter()
            .map(|pantograph| ExcitationNow::zero(pantograph.size()));
        Self {
            sizes: vec![0.0; trajectory.loads.len()],
            excitations: excitations.collect(),
            trajectory,
            pantographs,
        }
    }

    /// Returns the inputs of a step; `old` is the weight of its start in the balance.
    pub(crate) fn at(&mut self, step: usize, old: f64) -> Inputs<'_> {
        let between = |a: &[f64]| (1.0 - old) * a[step + 1] + old * a[step];
        for (size, load) in self.sizes.iter_mut().zip(&self.trajectory.loads) {
            *size = between(&load.sizes);
        }
        for (now, pantograph) in self.excitations.iter_mut().zip(self.pantographs) {
            pantograph.excitation.read(step, old, now);
        }
        let x = &self.trajectory.positions;
        Inputs {
            positions: [x[step], between(x), x[step + 1]],
            speed: between(&self.trajectory.speeds),
            loads: Loads::new(&self.trajectory.loads, &self.sizes),
            excitations: &self.excitations,
        }
    }
}
