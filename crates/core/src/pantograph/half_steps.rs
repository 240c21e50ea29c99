//! Energy of a rider half-way between two steps, and the work done on it in a step: see [`balance`](crate::integrator::energy::explicit).
//!
//! With z = u + ½ h v, Δz = h vₙ₊₁, d = h v + ½ h² a, w = z − r g and the ground at g(tₙ₊₁) from the begin of the
//! step on:
//!
//!   ½ (d/h)ᵀM(d/h) + ½ wᵀK w  changes by  Δz·(all other forces) − wₕᵀC Δz/h + work of the ground at z⁻
//!
//! wₕ = Δz − h r ġ. What a table adds to a spring stores energy as the spring does; a stop that is rigid stores none, and a moving
//! ground works against its force.

use crate::integrator::energy::entries::EnergyTerms;
use crate::pantograph::breakpoint::{ForceKind, RelativeCoordinate};
use crate::pantograph::system::{PantographState, inner};
use crate::scheme::Coefficients;

/// A rider at z⁻, and how it moves to z⁺.
#[derive(Debug, Clone, Default)]
pub(crate) struct Halves {
    /// z⁻ and Δz, m.
    pub z: Vec<f64>,
    pub moved: Vec<f64>,
    /// d before and after the step, m.
    steps: [Vec<f64>; 2],
    /// Energies at the end: kinetic and of springs, what tables add, of stops.
    pub stored: [f64; 3],
}

/// xᵀ A y
fn form(a: &[f64], x: &[f64], y: &[f64]) -> f64 {
    let rows = a.chunks_exact(x.len()).zip(x);
    rows.map(|(row, x)| x * inner(row, y)).sum()
}

impl Halves {
    /// At rest at the start.
    pub fn new(rider: &PantographState, h: f64) -> Self {
        let n = rider.rider.size();
        let mut new = Self {
            z: vec![0.0; n],
            moved: vec![0.0; n],
            steps: [vec![0.0; n], vec![0.0; n]],
            stored: [0.0; 3],
        };
        new.end(rider, h);
        new
    }

    /// z⁻ and Δz of the step that has been found. Call before [`PantographState::advance`].
    pub fn find(&mut self, rider: &PantographState, c: &Coefficients, h: f64) {
        for k in 0..self.z.len() {
            let (v, a) = (rider.v[k], rider.a[k]);
            let (new_v, new_a) = c.advance(rider.delta[k], v, a);
            self.z[k] = rider.u[k] + 0.5 * h * v;
            self.moved[k] = h * new_v;
            self.steps[0][k] = h * v + 0.5 * h * h * a;
            self.steps[1][k] = h * new_v + 0.5 * h * h * new_a;
        }
    }

    /// Book the work of the step but for contacts. Call before [`PantographState::advance`].
    pub fn book(&self, rider: &PantographState, (h, speed): (f64, f64), e: &mut EnergyTerms) {
        let (r, drive, dz) = (&rider.rider, &rider.drive, &self.moved);
        let force =
            |i: usize| r.preload[i] * rider.preload + r.lift[i] * speed * speed + drive.force[i];
        e.work_uplift += (0..dz.len()).map(|i| force(i) * dz[i]).sum::<f64>();
        e.work_control += rider
            .controlled()
            .map_or(0.0, |(d, force)| force * inner(d, dz));
        // The ground moves first, then the rider.
        let at = |ground: f64| Self::springs(rider, &self.z, ground).iter().sum::<f64>();
        if drive.end != drive.now {
            e.work_uplift += at(drive.end) - at(drive.now);
        }
        let lifted = h * drive.balance[1];
        let mut dissipated = 0.0;
        for (i, row) in r.damping.chunks_exact(dz.len()).enumerate() {
            let of = |k: usize| row[k] * (dz[k] - drive.carried[k] * lifted);
            let force = (0..dz.len()).map(of).sum::<f64>() / h;
            let carried = drive.carried[i] * lifted;
            dissipated += force * (dz[i] - carried);
            e.work_uplift -= force * carried;
        }
        let rise = drive.end - drive.now;
        for (gauge, force, is_rigid) in rider.pushes_with_stiffness() {
            let moved = inner(&gauge.direction, dz);
            let borne = match gauge.motion {
                ForceKind::Damper => gauge.carried * lifted,
                ForceKind::Spring if is_rigid => gauge.carried * rise,
                ForceKind::Spring => 0.0,
            };
            e.work_uplift += force * borne;
            match gauge.motion {
                ForceKind::Damper => dissipated -= force * (moved - borne),
                ForceKind::Spring => e.switching -= force * (moved - borne),
            }
        }
        e.dissipated_riders += dissipated;
        let [_, laws, stops] = Self::springs(rider, &self.z, drive.end);
        // What was stored at z⁻ with the ground in its new place; the end is booked there.
        e.switching += laws + stops;
    }

    /// Take the energies at the end of the step. Call after [`PantographState::advance`].
    pub fn end(&mut self, rider: &PantographState, h: f64) {
        let place = |k: usize| rider.u[k] + 0.5 * h * rider.v[k];
        for k in 0..self.z.len() {
            self.z[k] = place(k);
            self.steps[1][k] = h * rider.v[k] + 0.5 * h * h * rider.a[k];
        }
        let d = &self.steps[1];
        let [springs, laws, stops] = Self::springs(rider, &self.z, rider.drive.now);
        let kinetic = 0.5 * form(&rider.rider.mass, d, d) / (h * h);
        self.stored = [kinetic + springs, laws, stops];
    }

    /// Energy of springs, of what tables add, and of stops.
    fn springs(rider: &PantographState, z: &[f64], ground: f64) -> [f64; 3] {
        let (carried, k) = (&rider.drive.carried, &rider.rider.stiffness);
        let n = z.len();
        let w = |i: usize| z[i] - carried[i] * ground;
        let row = |i: usize| w(i) * (0..n).map(|j| k[i * n + j] * w(j)).sum::<f64>();
        let [mut laws, mut stops] = [0.0; 2];
        for kink in &rider.kinks {
            match kink.law {
                None => stops += kink.energy(z, ground),
                Some(_) if kink.gauge.motion == ForceKind::Spring => laws += kink.energy(z, ground),
                Some(_) => {}
            }
        }
        laws += rider.laws.iter().map(|l| l.energy(z, ground)).sum::<f64>();
        [0.5 * (0..n).map(row).sum::<f64>(), laws, stops]
    }
}

impl PantographState {
    /// Forces of stops, kinks and steepest lines on the rider, N, each with its direction and whether it is of a
    /// rigid stop.
    fn pushes_with_stiffness(&self) -> impl Iterator<Item = (&RelativeCoordinate, f64, bool)> {
        let kinks = self
            .entered()
            .map(|k| (&k.gauge, k.push(), k.flexibility == 0.0));
        kinks.chain(self.laws.iter().map(|l| (&l.gauge, -l.intercept, false)))
    }
}
