//! Energy of a pantograph half-way between two steps, and the work done on it in a step: see
//! [`balance`](crate::integrator::energy::explicit).
//!
//! With z = u + ½ h v, Δz = h vₙ₊₁, d = h v + ½ h² a, w = z − r g and the base at g(tₙ₊₁) from the
//! start of the step on:
//!
//!   ½ (d/h)ᵀM(d/h) + ½ wᵀK w
//!
//! changes by
//!
//!   Δz·(all other forces) − wₕᵀC Δz/h + work of the base at z⁻
//!
//! wₕ = Δz − h r ġ. The table of a spring stores energy as the spring does; a rigid stop stores
//! none, and a moving base does work against its force.

use crate::energy_terms::EnergyTerms;
use crate::linalg::small::inner;
use crate::pantograph::breakpoint::{ForceKind, RelativeCoordinate};
use crate::pantograph::state::PantographState;
use crate::scheme::Coefficients;

/// Pantograph half-way between steps: displacements z⁻, their increment, and energies.
#[derive(Debug, Clone, Default)]
pub(crate) struct HalfStepEnergy {
    /// Displacements z⁻, m.
    pub z: Vec<f64>,
    /// Increment Δz, m.
    pub increment: Vec<f64>,
    /// Vectors d before and after the step, m.
    steps: [Vec<f64>; 2],
    /// Energies at the end of the step, J: kinetic and of springs in K, of tables, of stops.
    pub stored: [f64; 3],
}

/// Bilinear form xᵀ A y.
fn form(a: &[f64], x: &[f64], y: &[f64]) -> f64 {
    let rows = a.chunks_exact(x.len()).zip(x);
    rows.map(|(row, x)| x * inner(row, y)).sum()
}

impl HalfStepEnergy {
    /// Energies of a pantograph at rest at the start, for the time step `h`, s.
    pub fn new(pantograph: &PantographState, h: f64) -> Self {
        let n = pantograph.model.size();
        let mut new = Self {
            z: vec![0.0; n],
            increment: vec![0.0; n],
            steps: [vec![0.0; n], vec![0.0; n]],
            stored: [0.0; 3],
        };
        new.update_stored(pantograph, h);
        new
    }

    /// Updates z⁻ and Δz for the completed increment. Precedes [`PantographState::commit`].
    pub fn update_increment(&mut self, pantograph: &PantographState, c: &Coefficients, h: f64) {
        for k in 0..self.z.len() {
            let (v, a) = (pantograph.v[k], pantograph.a[k]);
            let (new_v, new_a) = c.advance(pantograph.delta[k], v, a);
            self.z[k] = pantograph.u[k] + 0.5 * h * v;
            self.increment[k] = if pantograph.model.is_external {
                // z⁺ − z⁻ with the velocity Δu/h at the end of the step.
                pantograph.delta[k] + 0.5 * (pantograph.delta[k] - h * v)
            } else {
                h * new_v
            };
            self.steps[0][k] = h * v + 0.5 * h * h * a;
            self.steps[1][k] = h * new_v + 0.5 * h * h * new_a;
        }
    }

    /// Adds the work of the step, without that of contacts. Precedes [`PantographState::commit`].
    pub fn add_work(
        &self,
        pantograph: &PantographState,
        (h, speed): (f64, f64),
        e: &mut EnergyTerms,
    ) {
        let (r, excitation, dz) = (&pantograph.model, &pantograph.excitation, &self.increment);
        let (before, after) = (excitation.displacement, excitation.end_displacement);
        let force = |i: usize| {
            r.preload[i] * pantograph.preload + r.lift[i] * speed * speed + excitation.force[i]
        };
        e.work_uplift += (0..dz.len()).map(|i| force(i) * dz[i]).sum::<f64>();
        e.work_uplift += inner(&pantograph.external.load, dz);
        e.work_control += pantograph
            .actuator_force()
            .map_or(0.0, |(d, force)| force * inner(d, dz));
        // The base moves first, then the pantograph.
        let elastic = |base: f64| {
            Self::elastic_energies(pantograph, &self.z, base)
                .iter()
                .sum::<f64>()
        };
        if after != before {
            e.work_uplift += elastic(after) - elastic(before);
        }
        let base_travel = h * excitation.balance[1];
        let mut dissipated = 0.0;
        for (i, row) in r.damping.chunks_exact(dz.len()).enumerate() {
            let term = |k: usize| row[k] * (dz[k] - excitation.influence[k] * base_travel);
            let force = (0..dz.len()).map(term).sum::<f64>() / h;
            let with_base = excitation.influence[i] * base_travel;
            dissipated += force * (dz[i] - with_base);
            e.work_uplift -= force * with_base;
        }
        let base_increment = after - before;
        for (coordinate, force, is_rigid) in pantograph.forces_with_rigidity() {
            let increment = inner(&coordinate.direction, dz);
            let with_base = match coordinate.kind {
                ForceKind::Damper => coordinate.influence * base_travel,
                ForceKind::Spring if is_rigid => coordinate.influence * base_increment,
                ForceKind::Spring => 0.0,
            };
            e.work_uplift += force * with_base;
            match coordinate.kind {
                ForceKind::Damper => dissipated -= force * (increment - with_base),
                ForceKind::Spring => e.switching -= force * (increment - with_base),
            }
        }
        e.dissipated_pantographs += dissipated;
        let [_, tables, stops] = Self::elastic_energies(pantograph, &self.z, after);
        // Energy stored at z⁻ with the base at its new position; that at the end is added there.
        e.switching += tables + stops;
    }

    /// Updates the stored energies at the end of the step. Follows [`PantographState::commit`].
    pub fn update_stored(&mut self, pantograph: &PantographState, h: f64) {
        let displacement = |k: usize| pantograph.u[k] + 0.5 * h * pantograph.v[k];
        for k in 0..self.z.len() {
            self.z[k] = displacement(k);
            self.steps[1][k] = h * pantograph.v[k] + 0.5 * h * h * pantograph.a[k];
        }
        let d = &self.steps[1];
        let base = pantograph.excitation.displacement;
        let [springs, tables, stops] = Self::elastic_energies(pantograph, &self.z, base);
        let kinetic = 0.5 * form(&pantograph.model.mass, d, d) / (h * h);
        self.stored = [kinetic + springs, tables, stops];
    }

    /// Energies of springs in K, of tables, and of stops, J.
    fn elastic_energies(pantograph: &PantographState, z: &[f64], base: f64) -> [f64; 3] {
        let influence = &pantograph.excitation.influence;
        let stiffness = &pantograph.model.stiffness;
        let n = z.len();
        let w = |i: usize| z[i] - influence[i] * base;
        let row = |i: usize| w(i) * (0..n).map(|j| stiffness[i * n + j] * w(j)).sum::<f64>();
        let [mut tables, mut stops] = [0.0; 2];
        for b in &pantograph.breakpoints {
            match b.branch_of {
                None => stops += b.energy(z, base),
                Some(_) if b.coordinate.kind == ForceKind::Spring => tables += b.energy(z, base),
                Some(_) => {}
            }
        }
        let lines = pantograph.piecewise_forces.iter();
        tables += lines.map(|l| l.energy(z, base)).sum::<f64>();
        [0.5 * (0..n).map(row).sum::<f64>(), tables, stops]
    }
}

impl PantographState {
    /// Forces of stops, breakpoints and steepest lines on the pantograph, N, with their coordinates
    /// and whether they are those of a rigid stop.
    fn forces_with_rigidity(&self) -> impl Iterator<Item = (&RelativeCoordinate, f64, bool)> {
        let breakpoints = self
            .active_breakpoints()
            .map(|b| (&b.coordinate, b.signed_force(), b.flexibility == 0.0));
        let lines = self.piecewise_forces.iter();
        breakpoints.chain(lines.map(|l| (&l.coordinate, -l.intercept, false)))
    }
}
