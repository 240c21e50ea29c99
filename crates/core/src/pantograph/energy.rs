//! Energy of a pantograph and the work done on it in a step.
//!
//! A spring given by a table stores ∫ f dq: ½ k q² of its steepest slope with k (in K), the
//! constant force of its steepest line, and ± ½ Δ p² of each breakpoint passed by p. A damper
//! dissipates f(q̇_f) Δq, which for the trapezoidal rule is h f(q̇_f) q̇_f ≥ 0.

use crate::linalg::small::{inner, matrix_vector};
use crate::pantograph::breakpoint::{Breakpoint, ForceKind, RelativeCoordinate};
use crate::pantograph::state::PantographState;
use crate::scheme::Coefficients;

/// Work in one step of a pantograph, J.
#[derive(Debug, Clone, Copy, Default)]
pub struct PantographWork {
    /// Work of preload, lift, given forces and the moving base, and of what moves an external
    /// pantograph.
    pub uplift: f64,
    /// Work of the actuator.
    pub control: f64,
    /// Work against the dampers.
    pub dissipated: f64,
    /// Work against inertia and springs: energy stored, and energy that the scheme dissipates.
    pub stored: f64,
    /// Work of stops and of the tables of springs on the pantograph relative to its base.
    pub springs: f64,
}

impl PantographState {
    /// Kinetic and elastic energy, J.
    #[must_use]
    pub fn energy(&self) -> f64 {
        let kinetic = inner(&self.v, &matrix_vector(&self.model.mass, &self.v));
        let strain = self.relative(&self.u, self.excitation.displacement);
        let elastic = inner(&strain, &matrix_vector(&self.model.stiffness, &strain));
        0.5 * (kinetic + elastic)
    }

    /// Energy in the stops, J.
    #[must_use]
    pub fn stop_energy(&self) -> f64 {
        let stops = self.breakpoints.iter().filter(|b| b.branch_of.is_none());
        stops
            .map(|s| s.energy(&self.u, self.excitation.displacement))
            .sum()
    }

    /// Energy that tables add to that of the springs in K, J.
    #[must_use]
    pub fn piecewise_force_energy(&self) -> f64 {
        let is_spring =
            |b: &&Breakpoint| b.branch_of.is_some() && b.coordinate.kind == ForceKind::Spring;
        let breakpoints = self.breakpoints.iter().filter(is_spring);
        let lines = self.piecewise_forces.iter();
        breakpoints
            .map(|b| b.energy(&self.u, self.excitation.displacement))
            .chain(lines.map(|l| l.energy(&self.u, self.excitation.displacement)))
            .sum()
    }

    /// Forces of stops, breakpoints and steepest lines on the pantograph, N, with their
    /// coordinates.
    fn nonlinear_forces(&self) -> impl Iterator<Item = (&RelativeCoordinate, f64)> {
        let breakpoints = self.active_breakpoints();
        let breakpoints = breakpoints.map(|b| (&b.coordinate, b.signed_force()));
        let lines = self.piecewise_forces.iter();
        breakpoints.chain(lines.map(|l| (&l.coordinate, -l.intercept)))
    }

    /// Work done in the step by the completed increment. Precedes [`PantographState::commit`].
    #[must_use]
    pub fn work(&self, c: &Coefficients, speed: f64) -> PantographWork {
        let (r, excitation) = (&self.model, &self.excitation);
        let n = r.size();
        let base_increment = excitation.end_displacement - excitation.displacement;
        let relative_increment = self.relative(&self.delta, base_increment);
        let combine = |from_delta: f64, from_v: f64, from_a: f64| -> Vec<f64> {
            let component =
                |k: usize| from_delta * self.delta[k] + from_v * self.v[k] + from_a * self.a[k];
            (0..n).map(component).collect()
        };
        let inertia = combine(c.mass, c.acceleration_from_v, c.acceleration_from_a);
        let rate = combine(c.damping, c.velocity_from_v, c.velocity_from_a);
        let displacement: Vec<f64> = (0..n)
            .map(|k| c.stiffness * self.delta[k] + self.u[k])
            .collect();
        let damping = matrix_vector(&r.damping, &self.relative(&rate, excitation.balance[1]));
        let springs = matrix_vector(
            &r.stiffness,
            &self.relative(&displacement, excitation.balance[0]),
        );
        let force = |i: usize| {
            r.preload[i] * self.preload + r.lift[i] * speed * speed + excitation.force[i]
        };
        let supplied: f64 = (0..n).map(|i| force(i) * self.delta[i]).sum();
        let from_outside = inner(&self.external.load, &self.delta);
        // The base bears the reaction of springs, dampers and stops.
        let nonlinear = self
            .nonlinear_forces()
            .map(|(x, force)| force * x.influence);
        let nonlinear = nonlinear.sum::<f64>();
        let reaction = inner(&excitation.influence, &springs)
            + inner(&excitation.influence, &damping)
            - nonlinear;
        let nonlinear_work = |kind: ForceKind| -> f64 {
            let forces = self.nonlinear_forces().filter(|(x, _)| x.kind == kind);
            forces
                .map(|(x, force)| force * inner(&x.direction, &relative_increment))
                .sum()
        };
        PantographWork {
            uplift: supplied + from_outside - base_increment * reaction,
            control: self
                .actuator_force()
                .map_or(0.0, |(d, force)| force * inner(d, &self.delta)),
            dissipated: inner(&relative_increment, &damping) - nonlinear_work(ForceKind::Damper),
            stored: inner(&self.delta, &matrix_vector(&r.mass, &inertia))
                + inner(&relative_increment, &springs),
            springs: nonlinear_work(ForceKind::Spring),
        }
    }

    /// Displacements w = u − r z relative to the base, m, for its displacement z, m.
    fn relative(&self, u: &[f64], base: f64) -> Vec<f64> {
        let pairs = u.iter().zip(&self.excitation.influence);
        pairs.map(|(u, r)| u - r * base).collect()
    }
}
