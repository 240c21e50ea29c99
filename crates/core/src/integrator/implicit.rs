//! Implicit steps: one solve with the factor of the scheme's matrix.
//!
//! The balance of the scheme gives A Δu = f − M a* − C v* − K uₙ with a*, v* the parts of a_m, v_f
//! that do not contain Δu. Since A itself contains K, the products with K and C need not be
//! computed: with s = uₙ + β v* (β the common stiffness-proportional damping) and
//! κ = a_K + a_C β,
//!
//!   K s = (A s − a_M M s − a_C (C − βK) s) / κ
//!   A (Δu + s/κ) = f − M (a* − (a_M/κ) s) − (C − βK) (v* − (a_C/κ) s)
//!
//! so a step costs one product with the (structured) mass matrix and one solve.

use crate::constraint::wires::Wires;
use crate::error::CoreError;
use crate::integrator::state::{ImplicitState, Stepping, WireState};
use crate::linalg::{BlockLdl, Kernel, widest};
use crate::linear::island::Island;
use crate::linear::model::LinearModel;
use crate::scheme::Coefficients;

/// Matrix of the scheme, factorised, and the numbers that form its right-hand side.
#[derive(Debug, Clone)]
pub(crate) struct Implicit<const D: usize> {
    pub factor: BlockLdl<D>,
    /// Components that cannot move: node, component.
    fixed: Vec<(u32, u32)>,
    from_mass: [f64; 3],
    from_damping: [f64; 3],
    shift: [f64; 3],
}

impl<const D: usize> Implicit<D> {
    /// Factorises the matrix of the scheme. `from_u` is 1, or 0 where the forces at the current
    /// position are computed and no product K u is needed.
    ///
    /// # Errors
    /// [`CoreError::Singular`].
    pub fn new<const DIM: usize>(
        line: &LinearModel<DIM, D>,
        c: &Coefficients,
        from_u: f64,
    ) -> Result<Self, CoreError> {
        let matrix = line.combine(c.mass, c.damping, c.stiffness);
        let beta = line.common.beta;
        let kappa = c.stiffness + c.damping * beta;
        // Each vector below is a combination of (u, v, a) with constant numbers.
        let old_v = [0.0, c.velocity_from_v, c.velocity_from_a];
        let old_a = [0.0, c.acceleration_from_v, c.acceleration_from_a];
        let s = [from_u, beta * old_v[1], beta * old_v[2]];
        let alpha = line.common.alpha;
        let combine =
            |k: usize| old_a[k] + alpha * old_v[k] - (c.mass + c.damping * alpha) / kappa * s[k];
        Ok(Self {
            factor: BlockLdl::new(&matrix)?,
            fixed: line.fixed(),
            from_mass: [0, 1, 2].map(combine),
            from_damping: [0, 1, 2].map(|k| old_v[k] - c.damping / kappa * s[k]),
            shift: s.map(|v| v / kappa),
        })
    }

    /// Computes the increment without contact forces and corrections, m. `load` adds prescribed
    /// forces (N) to the vector it gets; `residual` are internal less external forces at the
    /// current position where these are formed, N.
    pub fn predict<const DIM: usize>(
        &self,
        wires: &Wires<DIM, D>,
        residual: Option<&[[f64; D]]>,
        state: &mut WireState<D>,
        load: impl FnOnce(&mut [[f64; D]]) -> bool,
    ) {
        widest(Inertia { wires, state });
        let WireState {
            u,
            v,
            delta,
            work,
            awake,
            stepping: Stepping::Implicit(vectors),
            ..
        } = state
        else {
            return;
        };
        let ImplicitState {
            a, shift, scratch, ..
        } = vectors;
        for island in wires.awake(awake) {
            self.subtract_damping_rest(&wires.line, island, [u, v, a], [work, scratch], delta);
        }
        load(delta);
        if let Some(residual) = residual {
            for (force, residual) in delta.iter_mut().zip(residual) {
                for c in 0..D {
                    force[c] -= residual[c];
                }
            }
        }
        for island in wires.awake(awake) {
            if residual.is_none() {
                wires.line.add_rest_corrections(island.links.clone(), delta);
            }
            for &(node, component) in &self.fixed[island.fixed.clone()] {
                delta[node as usize][component as usize] = 0.0;
            }
        }
        let nodes = wires.awake(awake).map(|island| island.nodes.clone());
        self.factor.solve_minus(nodes, delta, shift, work);
    }

    /// Subtracts (C − αM − βK) (v* − (a_C/κ) s) from `f` on an island.
    fn subtract_damping_rest<const DIM: usize>(
        &self,
        line: &LinearModel<DIM, D>,
        island: &Island,
        [u, v, a]: [&[[f64; D]]; 3],
        [work, scratch]: [&mut [[f64; D]]; 2],
        f: &mut [[f64; D]],
    ) {
        let [cu, cv, ca] = self.from_damping;
        let mut combine = |i: usize| {
            for k in 0..D {
                work[i][k] = -(cu * u[i][k] + cv * v[i][k] + ca * a[i][k]);
            }
        };
        if line.mass_damping_rest.is_some() {
            island.nodes.clone().for_each(combine);
        } else {
            for (i, j, _) in &line.damping_rest[island.damping.clone()] {
                combine(*i);
                combine(*j);
            }
        }
        line.add_damping_rest(island, work, f, scratch);
    }

    /// Computes the new displacement, velocity and acceleration.
    pub fn commit<const DIM: usize>(&self, wires: &Wires<DIM, D>, state: &mut WireState<D>) {
        widest(CommitNodes {
            wires,
            implicit: self,
            state,
        });
    }

    /// Computes the right-hand side of the next step of a restored state.
    pub fn resume(&self, state: &mut WireState<D>) {
        let WireState {
            u,
            v,
            stepping: Stepping::Implicit(vectors),
            ..
        } = state
        else {
            return;
        };
        for i in 0..u.len() {
            for k in 0..D {
                let motion = [u[i][k], v[i][k], vectors.a[i][k]];
                let next_step = next_step(self.from_mass, self.shift, motion);
                (vectors.prepared[i][k], vectors.shift[i][k]) = next_step;
            }
        }
    }
}

/// Returns inertia and shift of the next step from displacement, velocity and acceleration.
#[inline(always)]
fn next_step([mu, mv, ma]: [f64; 3], [su, sv, sa]: [f64; 3], [u, v, a]: [f64; 3]) -> (f64, f64) {
    (-(mu * u + mv * v + ma * a), su * u + sv * v + sa * a)
}

/// `delta = M · prepared`
struct Inertia<'a, const DIM: usize, const D: usize> {
    wires: &'a Wires<DIM, D>,
    state: &'a mut WireState<D>,
}

impl<const DIM: usize, const D: usize> Kernel for Inertia<'_, DIM, D> {
    #[inline(always)]
    fn run(self) {
        let WireState {
            delta,
            awake,
            stepping: Stepping::Implicit(vectors),
            ..
        } = self.state
        else {
            return;
        };
        for island in self.wires.awake(awake) {
            let mass = &self.wires.line.mass;
            mass.multiply(island.nodes.clone(), &vectors.prepared, delta);
        }
    }
}

/// New displacement, velocity and acceleration, and the combinations of them that the next step
/// starts from: one pass over the state.
struct CommitNodes<'a, const DIM: usize, const D: usize> {
    wires: &'a Wires<DIM, D>,
    implicit: &'a Implicit<D>,
    state: &'a mut WireState<D>,
}

impl<const DIM: usize, const D: usize> Kernel for CommitNodes<'_, DIM, D> {
    #[inline(always)]
    fn run(self) {
        let WireState {
            u,
            v,
            delta,
            awake,
            stepping: Stepping::Implicit(vectors),
            ..
        } = self.state
        else {
            return;
        };
        let ImplicitState {
            a,
            prepared,
            shift: shifts,
            ..
        } = vectors;
        let (c, from_mass) = (&self.wires.coefficients, self.implicit.from_mass);
        let shift = self.implicit.shift;
        for island in self.wires.awake(awake) {
            let nodes = || island.nodes.clone();
            // Entry by entry: over rows the compiler would gather four of them and transpose.
            let (u, v, a) = (
                u[nodes()].as_flattened_mut(),
                v[nodes()].as_flattened_mut(),
                a[nodes()].as_flattened_mut(),
            );
            let combined = prepared[nodes()].as_flattened_mut().iter_mut();
            let combined = combined.zip(shifts[nodes()].as_flattened_mut());
            let state = u.iter_mut().zip(v).zip(a);
            let state = state.zip(delta[nodes()].as_flattened());
            for ((((u, v), a), d), (w, s)) in state.zip(combined) {
                let new_u = *u + d;
                let (new_v, new_a) = c.advance(*d, *v, *a);
                (*w, *s) = next_step(from_mass, shift, [new_u, new_v, new_a]);
                (*u, *v, *a) = (new_u, new_v, new_a);
            }
        }
    }
}
