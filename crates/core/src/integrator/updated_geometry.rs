//! Updated kinematics: node coordinates and stiffness are formed anew in every step.
//!
//! The published method does this (seed method, "the whole algorithm", step 5). With the position
//! r = r₀ + u at the start of the step, internal minus external forces g(r) and their tangent K(r),
//! the balance of the scheme, linear in the increment, is
//!
//!   M a_m + C v_f + g(r) + (1 − α_f) K(r) Δu = C λ − G (r − …)
//!
//! With constant K and g = K u this is the linearised step; here no force is carried over from step
//! to step, so what the tangent misses in one step is put right in the next. Links keep their own
//! direction, contacts their place on the moved wire, and C = α M + β K follows K.

use crate::constraint::contacts::Contacts;
use crate::constraint::link_table::LinkTable;
use crate::error::CoreError;
use crate::integrator::implicit::Implicit;
use crate::integrator::prepared::WireModel;
use crate::integrator::{Integrator, Stepping, WireState};
use crate::linalg::{HeldEntry, Refactoring, SymmetricBlocks};
use crate::linear::model::LinearModel;
use crate::linear::static_response::StaticState;
use crate::scheme::Scheme;
use crate::slideline::Slideline;
use crate::statics::assembly::{Geometry, LinkLaw, Shape, largest};

/// Bound on the approximations of the first equilibrium; the contact moves by less each time.
const MOST_APPROXIMATIONS: usize = 50;

/// What a run with updated kinematics needs beside the prepared line.
#[derive(Debug, Clone)]
pub struct UpdatedGeometry<const DIM: usize, const D: usize> {
    geometry: Geometry<DIM, D>,
    /// Static shape r₀, from which u is measured.
    rest: Shape<D>,
    /// Positions r = r₀ + u at the start of the step.
    shape: Shape<D>,
    /// g(r), N.
    pub(in crate::integrator) residual: Shape<D>,
    /// Matrix of the scheme, and the part of it that never changes.
    matrix: SymmetricBlocks<D>,
    constant: SymmetricBlocks<D>,
    held: Vec<HeldEntry>,
    refactoring: Refactoring<D>,
    scratch: SymmetricBlocks<D>,
}

impl<const DIM: usize, const D: usize> WireModel<DIM, D> {
    /// Prepare runs with updated kinematics; `line` is `geometry` linearised about its equilibrium.
    ///
    /// # Errors
    /// [`CoreError::Input`] or [`CoreError::Singular`].
    pub fn updated(
        geometry: &Geometry<DIM, D>,
        line: LinearModel<DIM, D>,
        lanes: Vec<Slideline<DIM>>,
        scheme: Scheme,
        h: f64,
        contact_stiffness: f64,
    ) -> Result<Self, CoreError> {
        let shape = &line.shape;
        let c = scheme.coefficients(h);
        let mut constant = line.inertia(c.mass, c.damping);
        geometry.add_fixed_tangent(line.stiffness_factor(c.damping, c.stiffness), &mut constant);
        let now = UpdatedGeometry {
            geometry: geometry.clone(),
            rest: shape.clone(),
            shape: shape.clone(),
            residual: vec![[0.0; D]; shape.len()],
            held: constant.held(&line.free),
            refactoring: Refactoring::new(&constant),
            scratch: geometry.empty_matrix(),
            matrix: constant.clone(),
            constant,
        };
        Self::assemble(
            line,
            lanes,
            (scheme, h),
            contact_stiffness,
            |line, c, fixed| {
                // The forces of the present position are given: no product K u.
                let own = Implicit::new(line, c, fixed, 0.0)?;
                Ok(Integrator::UpdatedGeometry(Box::new(own), Box::new(now)))
            },
        )
    }

    /// Copy that a state owns and forms at its present position, on lanes that have moved; `None` where
    /// the line stays as it is.
    pub(crate) fn present(&self, lanes: &[Slideline<DIM>]) -> Option<Box<Self>> {
        let Integrator::UpdatedGeometry(..) = self.integrator else {
            return None;
        };
        let mut own = self.clone();
        own.lanes = lanes.to_vec();
        Some(Box::new(own))
    }

    /// Form coordinates, forces, stiffness and links at the present position.
    ///
    /// # Errors
    /// [`CoreError::Singular`], or [`CoreError::Folded`] when the motion has grown out of bounds.
    pub(crate) fn reform(
        &mut self,
        state: &mut WireState<D>,
        step: usize,
    ) -> Result<(), CoreError> {
        let Integrator::UpdatedGeometry(own, now) = &mut self.integrator else {
            return Ok(());
        };
        if !follow(&mut self.lanes, &state.u) {
            return Err(CoreError::Folded { step });
        }
        for ((r, rest), u) in now.shape.iter_mut().zip(&now.rest).zip(&state.u) {
            for c in 0..D {
                r[c] = rest[c] + u[c];
            }
        }
        let (shape, c) = (&now.shape, &self.coefficients);
        let geometry = &now.geometry;
        geometry.service_residual(shape, LinkLaw::Linear, &mut now.residual);
        self.line.reform(geometry, shape, &mut now.scratch);
        now.matrix.blocks.copy_from_slice(&now.constant.blocks);
        let factor = self.line.stiffness_factor(c.damping, c.stiffness);
        geometry.add_moving_tangent(shape, LinkLaw::Linear, factor, &mut now.matrix);
        self.line.add_dampers(c.damping, &mut now.matrix);
        now.matrix.hold(&now.held);
        own.factor.refactorise(&mut now.refactoring, &now.matrix)?;
        self.columns.forget();
        self.table = LinkTable::new(&self.line.links, &self.coefficients);
        if let Stepping::Implicit(own) = &state.stepping {
            state.links.restart(&self.line.links, &state.v, &own.a);
        }
        Ok(())
    }

    /// Compute the influence columns that contacts and the given links need, unless they
    /// are there already.
    pub(crate) fn provide(&mut self, contacts: &Contacts<DIM>, links: &[usize]) {
        let of_contacts = contacts.active().flat_map(|c| c.place.columns::<D>());
        let of_links = links.iter().map(|&link| self.link_column(link));
        let needed = of_contacts.chain(of_links);
        let missing: Vec<usize> = needed.filter(|&n| !self.columns.has(n)).collect();
        if missing.is_empty() {
            return;
        }
        let mut space = self.space();
        for number in missing {
            if !self.columns.has(number) {
                self.set_column(number, &mut space);
            }
        }
    }
}

impl<const DIM: usize, const D: usize> UpdatedGeometry<DIM, D> {
    /// Equilibrium under vertical forces of the active contacts, the first rider at `position`, by
    /// successive approximations: the forces move the
    /// wire along the track, and so the places where they act.
    ///
    /// # Errors
    /// Those of [`Geometry::settle`].
    pub(in crate::integrator) fn equilibrium(
        &self,
        lanes: &[Slideline<DIM>],
        contacts: &Contacts<DIM>,
        position: f64,
        forces: &[f64],
    ) -> Result<StaticState<D>, CoreError> {
        let mut lanes = lanes.to_vec();
        let mut geometry = self.geometry.clone();
        let given = geometry.structure.loads.len();
        let mut shape = self.rest.clone();
        let mut u = vec![[0.0; D]; shape.len()];
        for _ in 0..MOST_APPROXIMATIONS {
            geometry.structure.loads.truncate(given);
            for (contact, force) in contacts.active().zip(forces) {
                let (rider, lane) = (contact.rider(), &lanes[contact.of[2]]);
                let position = contact.along(position);
                let place = lane.locate(position, 0).ok_or(CoreError::OffWire {
                    rider,
                    position,
                    step: 0,
                })?;
                let shares = place.shares::<D>(DIM - 1);
                let loads = shares.map(|(node, c, share)| (node, c, share * force));
                geometry.structure.loads.extend(loads);
            }
            shape = geometry.settle(&shape)?;
            let mut moved: f64 = 0.0;
            for ((u, r), rest) in u.iter_mut().zip(&shape).zip(&self.rest) {
                for c in 0..D {
                    let new = r[c] - rest[c];
                    moved = moved.max((new - u[c]).abs());
                    u[c] = new;
                }
            }
            if !follow(&mut lanes, &u) {
                return Err(CoreError::Folded { step: 0 });
            }
            // Settling leaves a shape that balances as it is.
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
        let (residual, node) = largest(&residual, &geometry.service_mask());
        Err(CoreError::NoEquilibrium {
            iterations: MOST_APPROXIMATIONS,
            residual,
            node,
            tolerance: geometry.force_rounding(),
        })
    }
}

/// Find places on the displaced wires from now on; tells whether all run along the track.
pub(in crate::integrator) fn follow<const DIM: usize, const D: usize>(
    lanes: &mut [Slideline<DIM>],
    u: &[[f64; D]],
) -> bool {
    // Every lane follows, also behind one that folds.
    let mut runs_forwards = true;
    for lane in lanes {
        runs_forwards &= lane.follow(u);
    }
    runs_forwards
}

/// What cancels the compression of links that are slack in a shape, N.
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
