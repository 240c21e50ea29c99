//! Kinks of a rider in a step: those that enter, how far open they are, and the side of each law.

use crate::pantograph::breakpoint::{Breakpoint, Instant};
use crate::pantograph::piecewise_force::{Branch, PiecewiseForceState};
use crate::pantograph::system::PantographState;
use crate::scheme::Coefficients;

impl PantographState {
    /// Kinks in the complementarity problem of the step.
    pub(crate) fn entered(&self) -> impl Iterator<Item = &Breakpoint> {
        self.kinks.iter().filter(|k| k.is_in)
    }

    /// The same, to write their forces.
    pub(crate) fn entered_mut(&mut self) -> impl Iterator<Item = &mut Breakpoint> {
        self.kinks.iter_mut().filter(|k| k.is_in)
    }

    /// Largest force of a stop, N.
    pub(crate) fn stop_force(&self) -> f64 {
        let stops = self.kinks.iter().filter(|k| k.law.is_none());
        stops.fold(0.0, |largest, stop| f64::max(largest, stop.force))
    }

    /// Add the response to the forces of the kinks.
    pub fn add_kinks(&mut self) {
        for kink in self.kinks.iter().filter(|k| k.is_in) {
            for (d, c) in self.delta.iter_mut().zip(&kink.column) {
                *d += kink.push() * c;
            }
        }
    }

    /// Openings at the time of balance for the increment without contact forces and kinks.
    pub(crate) fn open_kinks(&mut self, c: &Coefficients) {
        let Self {
            u,
            v,
            a,
            delta,
            kinks,
            drive,
            ..
        } = self;
        let at = Instant {
            u,
            v,
            a,
            ground: drive.now,
            balance: drive.balance,
        };
        for kink in kinks {
            kink.free = kink.gauge.beyond(kink.closed, c, &at, delta);
        }
    }

    /// Motions that the laws look at, at the time of balance, with the completed increment.
    pub(crate) fn law_motions(&self, c: &Coefficients) -> impl Iterator<Item = f64> {
        let at = Instant {
            u: &self.u,
            v: &self.v,
            a: &self.a,
            ground: self.drive.now,
            balance: self.drive.balance,
        };
        self.laws.iter().map(move |l| l.at(c, &at, &self.delta))
    }

    /// Let the first law whose motion lies on its other side turn; tells whether there was one.
    pub(crate) fn turn(&mut self, c: &Coefficients) -> bool {
        let motions = self.law_motions(c).zip(&self.laws).enumerate();
        let wrong =
            |(_, (q, law)): &(usize, (f64, &PiecewiseForceState))| law.side_of(*q) != law.side;
        let Some((number, (q, law))) = motions.into_iter().find(wrong) else {
            return false;
        };
        let side = law.side_of(q);
        self.enter(number, side);
        let own = |k: &&mut Breakpoint| k.law.is_some_and(|(of, _)| of == number);
        self.kinks
            .iter_mut()
            .filter(own)
            .for_each(|k| k.force = 0.0);
        true
    }

    /// Let the kinks of one side of a law into the problem.
    pub(crate) fn enter(&mut self, number: usize, side: Branch) {
        self.laws[number].side = side;
        for kink in &mut self.kinks {
            if let Some((_, own)) = kink.law.filter(|(of, _)| *of == number) {
                kink.is_in = own == side;
            }
        }
    }

    /// Take down how far the laws went.
    pub(crate) fn watch_laws(&mut self, c: &Coefficients) {
        let at = Instant {
            u: &self.u,
            v: &self.v,
            a: &self.a,
            ground: self.drive.now,
            balance: self.drive.balance,
        };
        for law in &mut self.laws {
            let q = law.at(c, &at, &self.delta);
            law.range = [law.range[0].min(q), law.range[1].max(q)];
        }
    }

    /// Smallest and largest motion of each law so far.
    pub(crate) fn law_ranges(&self) -> impl Iterator<Item = f64> {
        self.laws.iter().flat_map(|law| law.range)
    }
}
