//! A linear mechanical system that travels along the wire and presses against it.
//!
//!   m ü + c u̇ + k u = b p + g V(t)² + f(t) − e λ + Σ d σ
//!
//! f is what is [given](super::given) (the ground may move as well), σ the forces of its
//! [stops](super::stop). `e` picks the height of the contact strip, `b` where the constant preload p acts, `g` the
//! forces proportional to the square of speed. Heights are measured from the height of the wire
//! where the run starts. The preload follows from the contact force asked for at the start, in
//! static equilibrium there; a spring between the first mass and the vehicle is thereby at rest
//! at the working height.

use super::given::{Drive, Given};
use super::stop::{Stop, StopState, check_independent};
use crate::error::CoreError;
use crate::linalg::dense;
use crate::scheme::Coefficients;

/// Description of a rider. Matrices are n × n, row by row; SI units.
#[derive(Debug, Clone)]
pub struct Rider {
    /// Mass matrix, kg.
    pub mass: Vec<f64>,
    /// Damping matrix, N·s/m.
    pub damping: Vec<f64>,
    /// Stiffness matrix, N/m.
    pub stiffness: Vec<f64>,
    /// Strip height = eᵀ u.
    pub strip: Vec<f64>,
    /// Direction of the preload.
    pub preload: Vec<f64>,
    /// Force per squared speed, N/(m/s)².
    pub lift: Vec<f64>,
    /// Contact force at the start, N, at the speed of the start.
    pub start_force: f64,
    /// Forces and motion of the ground, given for the whole run.
    pub given: Given,
    /// One-sided stops.
    pub stops: Vec<Stop>,
}

impl Rider {
    /// Number of degrees of freedom.
    #[must_use]
    pub fn size(&self) -> usize {
        self.strip.len()
    }

    /// Check sizes and numbers.
    ///
    /// # Errors
    /// [`CoreError::Input`].
    pub fn check(&self) -> Result<(), CoreError> {
        let n = self.size();
        let matrices = [&self.mass, &self.damping, &self.stiffness];
        let vectors = [&self.strip, &self.preload, &self.lift];
        let sized =
            matrices.iter().all(|m| m.len() == n * n) && vectors.iter().all(|v| v.len() == n);
        let finite = matrices
            .iter()
            .chain(&vectors)
            .all(|m| m.iter().all(|v| v.is_finite()));
        let extras = self.given.is_sound(n) && self.stops.iter().all(|s| s.is_sound(n));
        if n == 0 || !sized || !finite || !extras || !self.start_force.is_finite() {
            let reason = "sizes disagree or a number is not finite".into();
            return Err(CoreError::Input {
                array: "riders",
                reason,
            });
        }
        Ok(())
    }

    /// Static equilibrium under contact force λ with the strip at height `z`: displacements and
    /// preload from  k u − b p = g V² + f − e λ,  eᵀ u = z, with f as given for the start.
    ///
    /// # Errors
    /// [`CoreError::Input`] when the chain has no such equilibrium.
    pub fn equilibrium(
        &self,
        force: f64,
        z: f64,
        speed: f64,
    ) -> Result<(Vec<f64>, f64), CoreError> {
        let n = self.size();
        let m = n + 1;
        let mut a = vec![0.0; m * m];
        let mut rhs = vec![0.0; m];
        let given = self.given.at_start(&self.stiffness, n);
        for i in 0..n {
            for j in 0..n {
                a[i * m + j] = self.stiffness[i * n + j];
            }
            a[i * m + n] = -self.preload[i];
            a[n * m + i] = self.strip[i];
            rhs[i] = self.lift[i] * speed * speed + given[i] - self.strip[i] * force;
        }
        rhs[n] = z;
        if !dense::solve_in_place(&mut a, &mut rhs) {
            let reason = "the preload cannot balance the contact force".into();
            return Err(CoreError::Input {
                array: "riders",
                reason,
            });
        }
        let preload = rhs[n];
        rhs.truncate(n);
        Ok((rhs, preload))
    }
}

/// State and prepared matrices of a rider during a run.
#[derive(Debug, Clone)]
pub struct RiderState {
    /// What it is.
    pub rider: Rider,
    inverse: Vec<f64>,
    /// A⁻¹ e, the response of the increment to a unit pull on the strip.
    pub column: Vec<f64>,
    /// Constant preload, N.
    pub preload: f64,
    /// Displacement, m.
    pub u: Vec<f64>,
    /// Velocity, m/s.
    pub v: Vec<f64>,
    /// Acceleration, m/s².
    pub a: Vec<f64>,
    /// Increment of the current step without contact force, then with it.
    pub delta: Vec<f64>,
    /// Its stops.
    pub stops: Vec<StopState>,
    pub(super) drive: Drive,
    rhs: Vec<f64>,
}

impl RiderState {
    /// Prepare a rider that stands in equilibrium with its strip at height `z`.
    ///
    /// # Errors
    /// [`CoreError::Input`] when there is no equilibrium or a mass is missing.
    pub fn new(rider: Rider, c: &Coefficients, z: f64, speed: f64) -> Result<Self, CoreError> {
        rider.check()?;
        let n = rider.size();
        let (u, preload) = rider.equilibrium(rider.start_force, z, speed)?;
        let a: Vec<f64> = (0..n * n)
            .map(|i| {
                c.mass * rider.mass[i]
                    + c.damping * rider.damping[i]
                    + c.stiffness * rider.stiffness[i]
            })
            .collect();
        let inverse = dense::inverse(&a, n).ok_or_else(|| CoreError::Input {
            array: "riders",
            reason: "a mass without inertia or stiffness".into(),
        })?;
        let column = multiply(&inverse, &rider.strip);
        let zero = vec![0.0; n];
        let drive = Drive::new(&rider.given, &rider.stiffness, &rider.damping, n);
        let stop = |s: &Stop| {
            let response = multiply(&inverse, &s.direction);
            let ground = inner(&s.direction, &drive.carried) * drive.now;
            StopState::new(
                s,
                response,
                &drive.carried,
                inner(&s.direction, &u) - ground,
            )
        };
        let stops: Vec<StopState> = rider.stops.iter().map(stop).collect();
        check_independent(&stops, c)?;
        Ok(Self {
            stops,
            drive,
            inverse,
            column,
            preload,
            u,
            v: zero.clone(),
            a: zero.clone(),
            delta: zero.clone(),
            rhs: zero,
            rider,
        })
    }

    /// Strip height of a field of the rider.
    #[must_use]
    pub fn strip(&self, x: &[f64]) -> f64 {
        self.rider.strip.iter().zip(x).map(|(e, x)| e * x).sum()
    }

    /// Increment Δu without contact force, for the speed at the time of balance.
    pub fn free_increment(&mut self, c: &Coefficients, speed: f64) {
        let n = self.rider.size();
        let r = &self.rider;
        for i in 0..n {
            let mut f = r.preload[i] * self.preload + r.lift[i] * speed * speed;
            for j in 0..n {
                let am = c.acceleration_from_v * self.v[j] + c.acceleration_from_a * self.a[j];
                let vf = c.velocity_from_v * self.v[j] + c.velocity_from_a * self.a[j];
                let k = i * n + j;
                f -= r.mass[k] * am + r.damping[k] * vf + r.stiffness[k] * self.u[j];
            }
            self.rhs[i] = f;
        }
        self.drive.add_to(&mut self.rhs);
        for i in 0..n {
            self.delta[i] = (0..n).map(|j| self.inverse[i * n + j] * self.rhs[j]).sum();
        }
        let Drive { now, balance, .. } = self.drive;
        for stop in &mut self.stops {
            let moved = inner(&stop.direction, &self.delta);
            // The ground stands at z of the balance, the rider at u + (1 − α_f) Δu.
            let ground = stop.carried * (balance[0] - now);
            stop.free = stop.opening(&self.u, now) + c.stiffness * moved - ground;
        }
    }

    /// Read what is given in a step. Call before [`RiderState::free_increment`].
    pub fn begin(&mut self, c: &Coefficients, step: usize) {
        self.drive.begin(&self.rider.given, step, c.old);
    }

    /// Add the response to a contact force λ (which pushes the strip down).
    pub fn add_contact(&mut self, force: f64) {
        for (d, c) in self.delta.iter_mut().zip(&self.column) {
            *d -= force * c;
        }
    }

    /// Add the response to the forces of the stops.
    pub fn add_stops(&mut self) {
        for stop in &self.stops {
            for (d, c) in self.delta.iter_mut().zip(&stop.column) {
                *d += stop.force * c;
            }
        }
    }

    /// Take the step.
    pub fn advance(&mut self, c: &Coefficients) {
        for i in 0..self.u.len() {
            let (v, a) = c.advance(self.delta[i], self.v[i], self.a[i]);
            self.u[i] += self.delta[i];
            self.v[i] = v;
            self.a[i] = a;
        }
        self.drive.now = self.drive.end;
    }
}

/// Scalar product.
#[must_use]
pub fn inner(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(a, b)| a * b).sum()
}

/// Product of a square matrix and a vector.
#[must_use]
pub fn multiply(a: &[f64], x: &[f64]) -> Vec<f64> {
    let n = x.len();
    (0..n)
        .map(|i| (0..n).map(|j| a[i * n + j] * x[j]).sum())
        .collect()
}
