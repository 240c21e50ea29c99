//! Inputs of one step: where the riders travel, and the forces given from outside.

use crate::linear::loads::Loads;
use crate::pantograph::excitation::ExcitationNow;
use crate::pantograph::system::Pantograph;
use crate::simulation::run::Trajectory;

/// Inputs of one step. Forces of actuators are part of the state, which holds them from one
/// sample to the next.
#[derive(Debug, Clone, Copy)]
pub struct Inputs<'a> {
    /// Position of the first rider at the start of the step, at the time of balance, and at its
    /// end, m.
    pub positions: [f64; 3],
    /// Speed at the time of balance, m/s.
    pub speed: f64,
    /// Forces on nodes of the line.
    pub loads: Loads<'a>,
    /// Forces on each rider and motion of its ground; empty where there are none.
    pub given: &'a [ExcitationNow],
}

/// Inputs of a run, step by step, from its histories.
#[derive(Debug)]
pub(crate) struct Histories<'a> {
    travel: &'a Trajectory,
    riders: &'a [Pantograph],
    sizes: Vec<f64>,
    given: Vec<ExcitationNow>,
}

impl<'a> Histories<'a> {
    pub(crate) fn new(travel: &'a Trajectory, riders: &'a [Pantograph]) -> Self {
        let given = riders.iter().map(|rider| ExcitationNow::zero(rider.size()));
        Self {
            sizes: vec![0.0; travel.loads.len()],
            given: given.collect(),
            travel,
            riders,
        }
    }

    /// Inputs of a step; `old` is the weight of its start in the balance.
    pub(crate) fn at(&mut self, step: usize, old: f64) -> Inputs<'_> {
        let between = |a: &[f64]| (1.0 - old) * a[step + 1] + old * a[step];
        for (size, load) in self.sizes.iter_mut().zip(&self.travel.loads) {
            *size = between(&load.sizes);
        }
        for (now, rider) in self.given.iter_mut().zip(self.riders) {
            rider.given.read(step, old, now);
        }
        let x = &self.travel.positions;
        Inputs {
            positions: [x[step], between(x), x[step + 1]],
            speed: between(&self.travel.speeds),
            loads: Loads::new(&self.travel.loads, &self.sizes),
            given: &self.given,
        }
    }
}
