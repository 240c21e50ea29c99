//! Updated kinematics: node coordinates and stiffness are formed again in every step.
//!
//! The published method does this (seed method, "the whole algorithm", step 5). With the position
//! r = r₀ + u at the start of the step, internal minus external forces g(r) and their tangent K(r),
//! the balance of the scheme, linear in the increment, is
//!
//!   M a_m + C v_f + g(r) + (1 − α_f) K(r) Δu = C λ − G (r − …)
//!
//! With constant K and g = K u this is the linearised step; here no force is carried over from step
//! to step, so the error of the tangent in one step is corrected in the next. Links keep their own
//! direction, contacts their point on the moved wire, and C = α M + β K follows K.

use crate::constraint::contacts::Contacts;
use crate::constraint::link_table::LinkTable;
use crate::constraint::wires::Wires;
use crate::error::CoreError;
use crate::integrator::implicit::Implicit;
use crate::integrator::state::{Stepping, WireState};
use crate::linalg::{HeldEntry, Refactoring, SymmetricBlocks};
use crate::linear::model::LinearModel;
use crate::linear::static_response::StaticState;
use crate::scheme::Coefficients;
use crate::slideline::Slideline;
use crate::statics::assembly::{Geometry, LinkLaw, Shape, largest_residual};

/// Bound on the approximations of the first equilibrium; the contact moves by less each time.
const MOST_APPROXIMATIONS: usize = 50;

/// Geometry of a run with updated kinematics: coordinates, forces and matrix at the current
/// position.
#[derive(Debug, Clone)]
pub struct UpdatedGeometry<const DIM: usize, const D: usize> {
    geometry: Geometry<DIM, D>,
    /// Static shape r₀, from which u is measured.
    rest: Shape<D>,
    /// Positions r = r₀ + u at the start of the step.
    shape: Shape<D>,
    /// g(r), N.
    pub(in crate::integrator) residual: Shape<D>,
    /// Matrix of the scheme, and its constant part.
    matrix: SymmetricBlocks<D>,
    constant: SymmetricBlocks<D>,
    held: Vec<HeldEntry>,
    refactoring: Refactoring<D>,
    scratch: SymmetricBlocks<D>,
}

impl<const DIM: usize, const D: usize> UpdatedGeometry<DIM, D> {
    /// Geometry at rest; `line` is `geometry` linearised about its equilibrium.
    pub(in crate::integrator) fn new(
        geometry: &Geometry<DIM, D>,
        line: &LinearModel<DIM, D>,
        c: &Coefficients,
    ) -> Self {
        let shape = &line.shape;
        let mut constant = line.inertia(c.mass, c.damping);
        geometry.add_fixed_tangent(line.stiffness_factor(c.damping, c.stiffness), &mut constant);
        Self {
            geometry: geometry.clone(),
            rest: shape.clone(),
            shape: shape.clone(),
            residual: vec![[0.0; D]; shape.len()],
            held: constant.held(&line.free),
            refactoring: Refactoring::new(&constant),
            scratch: geometry.empty_matrix(),
            matrix: constant.clone(),
            constant,
        }
    }

    /// Forms coordinates, forces, stiffness and links at the current position.
    ///
    /// # Errors
    /// [`CoreError::Singular`], or [`CoreError::Folded`] when the motion has grown out of bounds.
    pub(in crate::integrator) fn reform(
        &mut self,
        wires: &mut Wires<DIM, D>,
        implicit: &mut Implicit<D>,
        state: &mut WireState<D>,
        step: usize,
    ) -> Result<(), CoreError> {
        if !move_slidelines(&mut wires.slidelines, &state.u) {
            return Err(CoreError::Folded { step });
        }
        for ((r, rest), u) in self.shape.iter_mut().zip(&self.rest).zip(&state.u) {
            for c in 0..D {
                r[c] = rest[c] + u[c];
            }
        }
        let (shape, c) = (&self.shape, &wires.coefficients);
        let geometry = &self.geometry;
        geometry.service_residual(shape, LinkLaw::Linear, &mut self.residual);
        wires.line.reform(geometry, shape, &mut self.scratch);
        self.matrix.blocks.copy_from_slice(&self.constant.blocks);
        let factor = wires.line.stiffness_factor(c.damping, c.stiffness);
        geometry.add_moving_tangent(shape, LinkLaw::Linear, factor, &mut self.matrix);
        wires
            .line
            .add_damping_rest_matrix(c.damping, &mut self.matrix);
        self.matrix.hold(&self.held);
        implicit
            .factor
            .refactorise(&mut self.refactoring, &self.matrix)?;
        wires.columns.forget();
        wires.table = LinkTable::new(&wires.line.links, &wires.coefficients);
        if let Stepping::Implicit(vectors) = &state.stepping {
            state
                .links
                .reset_reference(&wires.line.links, &state.v, &vectors.a);
        }
        Ok(())
    }

    /// Finds the equilibrium under vertical forces (N) of the active contacts, the first pantograph
    /// at `position`, by successive approximations: the forces move the wire along the track, and
    /// with it the points where they act.
    ///
    /// # Errors
    /// Those of [`Geometry::find_equilibrium`].
    pub(in crate::integrator) fn find_equilibrium(
        &self,
        slidelines: &[Slideline<DIM>],
        contacts: &Contacts<DIM>,
        position: f64,
        forces: &[f64],
    ) -> Result<StaticState<D>, CoreError> {
        let mut slidelines = slidelines.to_vec();
        let mut geometry = self.geometry.clone();
        let given_loads = geometry.structure.loads.len();
        let mut shape = self.rest.clone();
        let mut u = vec![[0.0; D]; shape.len()];
        for _ in 0..MOST_APPROXIMATIONS {
            geometry.structure.loads.truncate(given_loads);
            for (contact, force) in contacts.active().zip(forces) {
                let (pantograph, slideline) =
                    (contact.pantograph(), &slidelines[contact.indices[2]]);
                let position = contact.along(position);
                let point = slideline.locate(position, 0).ok_or(CoreError::OffWire {
                    pantograph,
                    position,
                    step: 0,
                })?;
                let shares = point.shares::<D>(DIM - 1);
                let loads = shares.map(|(node, c, share)| (node, c, share * force));
                geometry.structure.loads.extend(loads);
            }
            shape = geometry.find_equilibrium(&shape)?;
            let mut moved: f64 = 0.0;
            for ((u, r), rest) in u.iter_mut().zip(&shape).zip(&self.rest) {
                for c in 0..D {
                    let new = r[c] - rest[c];
                    moved = moved.max((new - u[c]).abs());
                    u[c] = new;
                }
            }
            if !move_slidelines(&mut slidelines, &u) {
                return Err(CoreError::Folded { step: 0 });
            }
            // The equilibrium of a shape in equilibrium is that shape.
            if moved == 0.0 {
                return Ok(StaticState {
                    correction: corrections(&geometry, &shape),
                    tension: Vec::new(),
                    u,
                });
            }
        }
        let mut residual = vec![[0.0; D]; shape.len()];
        geometry.service_residual(&shape, LinkLaw::Unilateral, &mut residual);
        let (residual, node) = largest_residual(&residual, &geometry.service_mask());
        Err(CoreError::NoEquilibrium {
            iterations: MOST_APPROXIMATIONS,
            residual,
            node,
            tolerance: geometry.force_rounding(),
        })
    }
}

/// Moves the slidelines to the displaced wires; returns whether all of them run along the track.
pub(in crate::integrator) fn move_slidelines<const DIM: usize, const D: usize>(
    slidelines: &mut [Slideline<DIM>],
    u: &[[f64; D]],
) -> bool {
    // Every slideline is moved, also after one that folds.
    let mut runs_forwards = true;
    for slideline in slidelines {
        runs_forwards &= slideline.update_geometry(u);
    }
    runs_forwards
}

/// Returns the corrections that cancel the compression of links that are slack in a shape, N.
fn corrections<const DIM: usize, const D: usize>(
    geometry: &Geometry<DIM, D>,
    shape: &Shape<D>,
) -> Vec<f64> {
    let links = geometry.structure.links.iter();
    let correction = links.map(|l| {
        let tension = Geometry::<DIM, D>::link_state(shape, l).linear_tension;
        if l.unilateral {
            (-tension).max(0.0)
        } else {
            0.0
        }
    });
    correction.collect()
}
