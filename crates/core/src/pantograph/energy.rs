//! Energy of a rider and the work done on it in a step.
//!
//! A spring given by a table stores ∫ f dq: ½ k q² of its steepest slope with k (in K), the constant force of
//! its steepest line, and ± ½ Δ p² of each kink passed by p. A damper dissipates f(q̇_f) Δq, which for
//! the trapezoidal rule is h f(q̇_f) q̇_f ≥ 0.

use crate::pantograph::breakpoint::{Breakpoint, ForceKind, RelativeCoordinate};
use crate::pantograph::system::{PantographState, inner, multiply};
use crate::scheme::Coefficients;

/// Work in one step of a rider, J.
#[derive(Debug, Clone, Copy, Default)]
pub struct RiderWork {
    /// Of preload, lift, given forces and the moving ground.
    pub uplift: f64,
    /// Of the actuator.
    pub control: f64,
    /// Against the dampers.
    pub dissipated: f64,
    /// Against inertia and springs: what is stored, and what the scheme takes.
    pub stored: f64,
    /// Of stops, and of what tables add to the springs, on the rider relative to its ground.
    pub springs: f64,
}

impl PantographState {
    /// Kinetic and elastic energy, J.
    #[must_use]
    pub fn energy(&self) -> f64 {
        let kinetic = inner(&self.v, &multiply(&self.rider.mass, &self.v));
        let strain = self.strained(&self.u, self.drive.now);
        let elastic = inner(&strain, &multiply(&self.rider.stiffness, &strain));
        0.5 * (kinetic + elastic)
    }

    /// Energy in the stops, J.
    #[must_use]
    pub fn stop_energy(&self) -> f64 {
        let stops = self.kinks.iter().filter(|k| k.law.is_none());
        stops.map(|s| s.energy(&self.u, self.drive.now)).sum()
    }

    /// What tables add to the energy of the springs, J.
    #[must_use]
    pub fn law_energy(&self) -> f64 {
        let is_spring = |k: &&Breakpoint| k.law.is_some() && k.gauge.motion == ForceKind::Spring;
        let kinks = self.kinks.iter().filter(is_spring);
        let lines = self.laws.iter();
        kinks
            .map(|k| k.energy(&self.u, self.drive.now))
            .chain(lines.map(|l| l.energy(&self.u, self.drive.now)))
            .sum()
    }

    /// Forces of stops, kinks and steepest lines on the rider, each with its direction, N.
    fn pushes(&self) -> impl Iterator<Item = (&RelativeCoordinate, f64)> {
        let kinks = self.entered().map(|k| (&k.gauge, k.push()));
        kinks.chain(self.laws.iter().map(|l| (&l.gauge, -l.intercept)))
    }

    /// Work done in the step, by the completed increment. Call before [`PantographState::advance`].
    #[must_use]
    pub fn work(&self, c: &Coefficients, speed: f64) -> RiderWork {
        let (r, drive) = (&self.rider, &self.drive);
        let n = r.size();
        let rise = drive.end - drive.now;
        let moved = self.strained(&self.delta, rise);
        let field = |own: f64, from_v: f64, from_a: f64| -> Vec<f64> {
            let at = |k: usize| own * self.delta[k] + from_v * self.v[k] + from_a * self.a[k];
            (0..n).map(at).collect()
        };
        let inertia = field(c.mass, c.acceleration_from_v, c.acceleration_from_a);
        let rate = field(c.damping, c.velocity_from_v, c.velocity_from_a);
        let place: Vec<f64> = (0..n)
            .map(|k| c.stiffness * self.delta[k] + self.u[k])
            .collect();
        let damping = multiply(&r.damping, &self.strained(&rate, drive.balance[1]));
        let springs = multiply(&r.stiffness, &self.strained(&place, drive.balance[0]));
        let force =
            |i: usize| r.preload[i] * self.preload + r.lift[i] * speed * speed + drive.force[i];
        let supplied: f64 = (0..n).map(|i| force(i) * self.delta[i]).sum();
        // The ground bears the reaction of springs, dampers and stops.
        let pushed = self.pushes().map(|(g, force)| force * g.carried);
        let pushed = pushed.sum::<f64>();
        let borne = inner(&drive.carried, &springs) + inner(&drive.carried, &damping) - pushed;
        let done = |motion: ForceKind| -> f64 {
            let pushes = self.pushes().filter(|(g, _)| g.motion == motion);
            pushes
                .map(|(g, force)| force * inner(&g.direction, &moved))
                .sum()
        };
        RiderWork {
            uplift: supplied - rise * borne,
            control: self
                .controlled()
                .map_or(0.0, |(d, force)| force * inner(d, &self.delta)),
            dissipated: inner(&moved, &damping) - done(ForceKind::Damper),
            stored: inner(&self.delta, &multiply(&r.mass, &inertia)) + inner(&moved, &springs),
            springs: done(ForceKind::Spring),
        }
    }

    /// w = u − r z.
    fn strained(&self, u: &[f64], ground: f64) -> Vec<f64> {
        let pairs = u.iter().zip(&self.drive.carried);
        pairs.map(|(u, r)| u - r * ground).collect()
    }
}
