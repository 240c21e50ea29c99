//! A linear mechanical system that travels along the wire and presses against it.
//!
//!   m ü + c u̇ + k u = b p + g V(t)² − e λ
//!
//! `e` picks the height of the contact strip, `b` where the constant preload p acts, `g` the
//! forces proportional to the square of speed. Heights are measured from the height of the wire
//! where the run starts. The preload follows from the contact force asked for at the start, in
//! static equilibrium there; a spring between the first mass and the vehicle is thereby at rest
//! at the working height.

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
        if n == 0 || !sized || !finite || !self.start_force.is_finite() {
            let reason = "sizes disagree or a number is not finite".into();
            return Err(CoreError::Input {
                array: "riders",
                reason,
            });
        }
        Ok(())
    }

    /// Static equilibrium under contact force λ with the strip at height `z`: displacements and
    /// preload from  k u − b p = g V² − e λ,  eᵀ u = z.
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
        for i in 0..n {
            for j in 0..n {
                a[i * m + j] = self.stiffness[i * n + j];
            }
            a[i * m + n] = -self.preload[i];
            a[n * m + i] = self.strip[i];
            rhs[i] = self.lift[i] * speed * speed - self.strip[i] * force;
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
        Ok(Self {
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
        for i in 0..n {
            self.delta[i] = (0..n).map(|j| self.inverse[i * n + j] * self.rhs[j]).sum();
        }
    }

    /// Add the response to a contact force λ (which pushes the strip down).
    pub fn add_contact(&mut self, force: f64) {
        for (d, c) in self.delta.iter_mut().zip(&self.column) {
            *d -= force * c;
        }
    }

    /// Kinetic and elastic energy, J.
    #[must_use]
    pub fn energy(&self) -> f64 {
        let kinetic = inner(&self.v, &multiply(&self.rider.mass, &self.v));
        let elastic = inner(&self.u, &multiply(&self.rider.stiffness, &self.u));
        0.5 * (kinetic + elastic)
    }

    /// Work done in the step, by the completed increment. Call before [`RiderState::advance`].
    #[must_use]
    pub fn work(&self, c: &Coefficients, speed: f64) -> RiderWork {
        let r = &self.rider;
        let at = |k: usize| {
            let (d, v, a) = (self.delta[k], self.v[k], self.a[k]);
            [
                c.mass * d + c.acceleration_from_v * v + c.acceleration_from_a * a,
                c.damping * d + c.velocity_from_v * v + c.velocity_from_a * a,
                c.stiffness * d + self.u[k],
            ]
        };
        let field = |q: usize| -> Vec<f64> { (0..r.size()).map(|k| at(k)[q]).collect() };
        let along = |m: &[f64], q: usize| inner(&self.delta, &multiply(m, &field(q)));
        let force = |i: usize| r.preload[i] * self.preload + r.lift[i] * speed * speed;
        RiderWork {
            uplift: (0..r.size()).map(|i| force(i) * self.delta[i]).sum(),
            dissipated: along(&r.damping, 1),
            stored: along(&r.mass, 0) + along(&r.stiffness, 2),
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
    }
}

/// Work in one step of a rider, J.
#[derive(Debug, Clone, Copy, Default)]
pub struct RiderWork {
    /// Of preload and lift.
    pub uplift: f64,
    /// Against the dampers.
    pub dissipated: f64,
    /// Against inertia and springs: what is stored, and what the scheme takes.
    pub stored: f64,
}

fn inner(x: &[f64], y: &[f64]) -> f64 {
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
