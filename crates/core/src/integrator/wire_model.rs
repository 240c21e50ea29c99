//! Wires with the integrator that steps them: one interface, three integrators behind it.

use crate::constraint::columns::ComplianceColumns;
use crate::constraint::contacts::Contacts;
use crate::constraint::problem::ConstraintProblem;
use crate::constraint::wires::Wires;
use crate::error::CoreError;
use crate::integrator::explicit::{ChainState, Explicit};
use crate::integrator::implicit::Implicit;
use crate::integrator::state::{ImplicitState, Stepping, WireState};
use crate::integrator::updated_geometry::UpdatedGeometry;
use crate::linear::island::Island;
use crate::linear::model::LinearModel;
use crate::scheme::Scheme;
use crate::slideline::Slideline;
use crate::statics::Geometry;
use std::ops::Deref;

/// Integrator of the wires.
#[derive(Debug, Clone)]
pub(crate) enum Integrator<const DIM: usize, const D: usize> {
    /// One solve a step with the factor of a constant matrix.
    Implicit(Box<Implicit<D>>),
    /// Central differences on chains of point masses.
    Explicit(Box<Explicit<DIM>>),
    /// Implicit steps with coordinates and stiffness formed at every position.
    UpdatedGeometry(Box<Implicit<D>>, Box<UpdatedGeometry<DIM, D>>),
}

/// Wires with their integrator: everything that is constant during a run, and may be shared by
/// many.
#[derive(Debug, Clone)]
pub struct WireModel<const DIM: usize, const D: usize> {
    wires: Wires<DIM, D>,
    pub(crate) integrator: Integrator<DIM, D>,
}

/// Access to the wires, which do not depend on the integrator.
impl<const DIM: usize, const D: usize> Deref for WireModel<DIM, D> {
    type Target = Wires<DIM, D>;

    #[inline(always)]
    fn deref(&self) -> &Self::Target {
        &self.wires
    }
}

impl<const DIM: usize, const D: usize> WireModel<DIM, D> {
    /// Creates wires stepped implicitly with a constant matrix, which is factorised here.
    /// `contact_stiffness` (N/m) is infinite for rigid contact.
    ///
    /// # Errors
    /// [`CoreError::Input`] or [`CoreError::Singular`].
    pub fn new(
        line: LinearModel<DIM, D>,
        slidelines: Vec<Slideline<DIM>>,
        scheme: Scheme,
        h: f64,
        contact_stiffness: f64,
    ) -> Result<Self, CoreError> {
        let wires = Wires::new(line, slidelines, (scheme, h), contact_stiffness)?;
        let implicit = Implicit::new(&wires.line, &wires.coefficients, 1.0)?;
        Ok(Self::with(wires, Integrator::Implicit(Box::new(implicit))))
    }

    /// Creates wires that are chains of point masses, stepped explicitly: see [`Explicit`]. On
    /// slidelines by [`Slideline::smoothed`] contacts are accurate between points as well.
    ///
    /// # Errors
    /// [`CoreError::Input`] or [`CoreError::Singular`].
    pub fn explicit(
        geometry: &Geometry<DIM, D>,
        line: LinearModel<DIM, D>,
        slidelines: Vec<Slideline<DIM>>,
        h: f64,
        contact_stiffness: f64,
    ) -> Result<Self, CoreError> {
        let steps = Explicit::new(geometry, &line.shape, &line, h)?;
        let scheme = Scheme::newmark(0.25, 0.5);
        let wires = Wires::new(line, slidelines, (scheme, h), contact_stiffness)?;
        Ok(Self::with(wires, Integrator::Explicit(Box::new(steps))))
    }

    /// Creates wires whose coordinates and stiffness are formed at every position; `line` is
    /// `geometry` linearised about its equilibrium.
    ///
    /// # Errors
    /// [`CoreError::Input`] or [`CoreError::Singular`].
    pub fn updated(
        geometry: &Geometry<DIM, D>,
        line: LinearModel<DIM, D>,
        slidelines: Vec<Slideline<DIM>>,
        scheme: Scheme,
        h: f64,
        contact_stiffness: f64,
    ) -> Result<Self, CoreError> {
        let wires = Wires::new(line, slidelines, (scheme, h), contact_stiffness)?;
        let geometry = UpdatedGeometry::new(geometry, &wires.line, &wires.coefficients);
        // The forces at the current position are computed: no product K u.
        let implicit = Implicit::new(&wires.line, &wires.coefficients, 0.0)?;
        let integrator = Integrator::UpdatedGeometry(Box::new(implicit), Box::new(geometry));
        Ok(Self::with(wires, integrator))
    }

    fn with(wires: Wires<DIM, D>, integrator: Integrator<DIM, D>) -> Self {
        let mut model = Self { wires, integrator };
        model.set_columns();
        model
    }

    /// Returns a copy that a state owns and forms at its current position, on moved slidelines;
    /// `None` where the geometry is constant.
    pub(crate) fn current_geometry(&self, slidelines: &[Slideline<DIM>]) -> Option<Box<Self>> {
        let Integrator::UpdatedGeometry(..) = self.integrator else {
            return None;
        };
        let mut model = self.clone();
        model.wires.slidelines = slidelines.to_vec();
        Some(Box::new(model))
    }

    /// Forms coordinates, forces, stiffness and links at the current position.
    ///
    /// # Errors
    /// [`CoreError::Singular`], or [`CoreError::Folded`] when the motion has grown out of bounds.
    pub(crate) fn reform(
        &mut self,
        state: &mut WireState<D>,
        step: usize,
    ) -> Result<(), CoreError> {
        match &mut self.integrator {
            Integrator::UpdatedGeometry(implicit, geometry) => {
                geometry.reform(&mut self.wires, implicit, state, step)
            }
            _ => Ok(()),
        }
    }

    /// Computes the compliance columns that contacts and the given links need, unless they are
    /// known.
    pub(crate) fn ensure_columns(&mut self, contacts: &Contacts<DIM>, links: &[usize]) {
        let contact_columns = contacts.active().flat_map(|c| c.point.columns::<D>());
        let link_columns = links.iter().map(|&link| self.link_column(link));
        let needed = contact_columns.chain(link_columns);
        let missing: Vec<usize> = needed.filter(|&n| !self.columns.has(n)).collect();
        if missing.is_empty() {
            return;
        }
        let mut zero_vectors = self.zero_vectors();
        for number in missing {
            if !self.columns.has(number) {
                self.set_column(number, &mut zero_vectors);
            }
        }
    }

    /// Returns the explicit integrator and its state; `None` for the others.
    pub(crate) fn explicit_state<'a>(
        &'a self,
        state: &'a WireState<D>,
    ) -> Option<(&'a Explicit<DIM>, &'a ChainState)> {
        match (&self.integrator, &state.stepping) {
            (Integrator::Explicit(steps), Stepping::Explicit(chain)) => Some((steps, chain)),
            _ => None,
        }
    }

    fn explicit_mut<'a>(
        &'a self,
        stepping: &'a mut Stepping<D>,
    ) -> Option<(&'a Explicit<DIM>, &'a mut ChainState)> {
        match (&self.integrator, stepping) {
            (Integrator::Explicit(steps), Stepping::Explicit(chain)) => Some((steps, chain)),
            _ => None,
        }
    }

    /// Returns the number of blocks in the factor, for reports on cost; zero for explicit steps.
    #[must_use]
    pub fn fill(&self) -> usize {
        match &self.integrator {
            Integrator::Implicit(implicit) | Integrator::UpdatedGeometry(implicit, _) => {
                implicit.factor.fill()
            }
            Integrator::Explicit(_) => 0,
        }
    }

    /// Returns whether islands that nothing has reached stay exactly at rest, so that steps may
    /// leave them out.
    pub(crate) fn may_sleep(&self) -> bool {
        !matches!(self.integrator, Integrator::UpdatedGeometry(..))
    }

    /// Returns whether an energy balance can be evaluated.
    pub(crate) fn has_energy_balance(&self) -> bool {
        !matches!(self.integrator, Integrator::UpdatedGeometry(..))
    }

    /// Returns whether a step allocates nothing, and has the same cost every time.
    pub(crate) fn has_constant_cost(&self) -> bool {
        !matches!(self.integrator, Integrator::UpdatedGeometry(..))
    }

    /// Computes all compliance columns, unless they change with the position.
    pub(crate) fn set_columns(&mut self) {
        match &self.integrator {
            Integrator::Explicit(steps) => {
                let mut chain = steps.zero_state();
                let mut columns = ComplianceColumns::new(self.columns.count());
                for number in 0..columns.count() {
                    let load = self.unit_load(number);
                    let load = load.iter().flat_map(|(node, force)| {
                        let shares = force.iter().enumerate().take(DIM);
                        shares.map(move |(c, f)| (*node, c, *f))
                    });
                    steps.set_column(&mut columns, number, load, &mut chain);
                }
                self.wires.columns = columns;
            }
            Integrator::Implicit(_) => {
                let mut zero_vectors = self.zero_vectors();
                for number in 0..self.columns.count() {
                    self.set_column(number, &mut zero_vectors);
                }
            }
            Integrator::UpdatedGeometry(..) => (),
        }
    }

    /// Returns two vectors of zeros as workspace of columns.
    fn zero_vectors(&self) -> [Vec<[f64; D]>; 2] {
        [0, 1].map(|_| vec![[0.0; D]; self.line.nodes()])
    }

    /// Computes a column with the factor.
    fn set_column(&mut self, number: usize, [x, work]: &mut [Vec<[f64; D]>; 2]) {
        let load = self.unit_load(number);
        if let Integrator::Implicit(implicit) | Integrator::UpdatedGeometry(implicit, _) =
            &self.integrator
        {
            self.wires
                .columns
                .set(number, &implicit.factor, &load, [x, work]);
        }
    }

    /// Returns a state at rest in a displaced position, ready for the first step.
    #[must_use]
    pub fn at_rest(&self, u: Vec<[f64; D]>) -> WireState<D> {
        match &self.integrator {
            Integrator::Explicit(steps) => {
                let (chain, u) = steps.at_rest(self, u);
                WireState::new(self, u, Stepping::Explicit(Box::new(chain)))
            }
            Integrator::Implicit(implicit) | Integrator::UpdatedGeometry(implicit, _) => {
                let stepping = Stepping::Implicit(ImplicitState::new(u.len()));
                let mut state = WireState::new(self, u, stepping);
                implicit.commit(self, &mut state);
                state
            }
        }
    }

    /// Computes the increment of the line without contact forces and corrections, m. `load` adds
    /// prescribed forces (N) to the vector it gets, and returns whether there are any.
    pub fn predict(&self, state: &mut WireState<D>, load: impl FnOnce(&mut [[f64; D]]) -> bool) {
        match &self.integrator {
            Integrator::Explicit(steps) => steps.predict(self, state, load),
            Integrator::Implicit(implicit) => implicit.predict(self, None, state, load),
            Integrator::UpdatedGeometry(implicit, geometry) => {
                implicit.predict(self, Some(&geometry.residual), state, load);
            }
        }
        let WireState {
            links,
            awake,
            delta,
            ..
        } = state;
        let links_and_table = (&self.line.links[..], &self.table);
        for island in self.awake(awake) {
            links.predict(
                island.links.clone(),
                links_and_table,
                &self.coefficients,
                delta,
            );
        }
    }

    /// Adds the response to the changes of forces since the last call in this step: Δu += A⁻¹(C λ −
    /// G r).
    pub(crate) fn apply(
        &self,
        state: &mut WireState<D>,
        problem: &mut ConstraintProblem,
        contacts: &Contacts<DIM>,
    ) {
        let WireState {
            delta,
            links,
            stepping,
            ..
        } = state;
        let mut moved = self.line.nodes()..0;
        let mut add = |column: usize, factor: f64| {
            let nodes = self.columns.add(column, factor, delta);
            moved = moved.start.min(nodes.start)..moved.end.max(nodes.end);
        };
        for &j in &contacts.active {
            let point = &contacts.all[j].point;
            let change = problem.force[j] - problem.applied_force[j];
            problem.applied_force[j] = problem.force[j];
            self.add_explicit_force(stepping, point.shares::<D>(DIM - 1), change);
            for (column, weight) in point.columns::<D>().zip(&point.weights) {
                add(column, weight * change);
            }
            for (link, rise) in contacts.all[j].compliance.links() {
                let tension_relief = self.tension_relief(link, rise) * change;
                add(self.link_column(link), tension_relief);
                links.subtract_tension(link, tension_relief);
            }
        }
        for &link in &problem.links {
            let change = problem.correction[link] - problem.applied_correction[link];
            problem.applied_correction[link] = problem.correction[link];
            if change != 0.0 {
                self.add_explicit_force(stepping, self.line.links[link].shares(1.0), -change);
                add(self.link_column(link), -change);
            }
        }
        let links_and_table = (&self.line.links[..], &self.table);
        links.update_increments(moved, links_and_table, delta);
    }

    /// Adds forces on nodes (N) to those of explicit steps; implicit ones have them in the
    /// increments.
    fn add_explicit_force(
        &self,
        stepping: &mut Stepping<D>,
        shares: impl Iterator<Item = (usize, usize, f64)>,
        factor: f64,
    ) {
        if let Some((steps, chain)) = self.explicit_mut(stepping) {
            for (node, component, share) in shares {
                steps.add_force(chain, node, component, factor * share);
            }
        }
    }

    /// Computes displacement and velocity at the end of the step.
    pub fn commit(&self, state: &mut WireState<D>) {
        match &self.integrator {
            Integrator::Explicit(steps) => steps.commit(state),
            Integrator::Implicit(implicit) | Integrator::UpdatedGeometry(implicit, _) => {
                implicit.commit(self, state);
            }
        }
        for island in self.awake(&state.awake) {
            state.links.commit(island.links.clone(), &self.coefficients);
        }
    }

    /// Undoes what [`WireModel::predict`] and constraint forces have changed, so that the step can
    /// be predicted again from its start: explicit steps add forces to those of the wires.
    pub(crate) fn undo_prediction(&self, state: &mut WireState<D>) {
        let WireState {
            awake, stepping, ..
        } = state;
        if let Some((steps, chain)) = self.explicit_mut(stepping) {
            awake
                .iter()
                .for_each(|&island| steps.wire_forces(island, chain));
        }
    }

    /// Prepares the next step of a restored state.
    pub(crate) fn resume(&self, state: &mut WireState<D>) {
        match &self.integrator {
            Integrator::Implicit(implicit) | Integrator::UpdatedGeometry(implicit, _) => {
                implicit.resume(state)
            }
            Integrator::Explicit(steps) => {
                if let Stepping::Explicit(chain) = &mut state.stepping {
                    (0..self.islands.len()).for_each(|island| steps.wire_forces(island, chain));
                    // Displacements are those of the saved state, of the nodes that it knew.
                    let now = chain.steps;
                    chain
                        .known_until
                        .iter_mut()
                        .for_each(|step| *step = now.max(*step));
                }
            }
        }
    }

    /// Returns the velocity of a node at the time of balance, m/s, with the increment of the
    /// current step; of explicit steps, for a component across the track.
    pub(crate) fn velocity_at_balance(
        &self,
        state: &WireState<D>,
        node: usize,
        component: usize,
    ) -> f64 {
        if let Some((steps, chain)) = self.explicit_state(state) {
            return steps.velocity(chain, node)[component];
        }
        let c = &self.coefficients;
        let of = |field: &[[f64; D]]| field[node][component];
        c.damping * of(&state.delta)
            + c.velocity_from_v * of(&state.v)
            + c.velocity_from_a * of(state.acceleration())
    }

    /// Appends displacements of nodes at the time of balance, m, with the increment of the current
    /// step: of any nodes, requested or not; of explicit steps, for a component across the track,
    /// see `displacement_at_balance` there.
    pub(crate) fn add_displacements(
        &self,
        state: &WireState<D>,
        nodes: &[usize],
        component: usize,
        out: &mut Vec<f32>,
    ) {
        if let Some((steps, chain)) = self.explicit_state(state) {
            let of = |&node: &usize| steps.displacement_at_balance(chain, node, component) as f32;
            out.extend(nodes.iter().map(of));
        } else {
            let (u, delta, keep) = (&state.u, &state.delta, self.coefficients.stiffness);
            let of = |&node: &usize| (u[node][component] + keep * delta[node][component]) as f32;
            out.extend(nodes.iter().map(of));
        }
    }

    /// Returns the displacement of a node from the static shape between two steps, m, along, across
    /// and up; also of nodes that explicit steps were not asked for.
    pub(crate) fn displacement_between_steps(
        &self,
        state: &WireState<D>,
        node: usize,
    ) -> [f64; DIM] {
        let known = || std::array::from_fn(|component| state.u[node][component]);
        let found = self
            .explicit_state(state)
            .and_then(|(steps, chain)| steps.displacement_between_steps(chain, node));
        found.unwrap_or_else(known)
    }

    /// Requests the motion of nodes for the coming step.
    pub(crate) fn request_nodes(
        &self,
        state: &mut WireState<D>,
        nodes: impl Iterator<Item = usize>,
    ) {
        if let Some((steps, chain)) = self.explicit_mut(&mut state.stepping) {
            steps.request_nodes(chain, nodes);
        }
    }

    /// Requests the motion of nodes for every step.
    pub(crate) fn track_nodes(&self, state: &mut WireState<D>, nodes: impl Iterator<Item = usize>) {
        if let Some((steps, chain)) = self.explicit_mut(&mut state.stepping) {
            steps.request_nodes_always(chain, nodes);
        }
    }

    /// Returns whether nothing of an island has moved.
    pub(crate) fn is_at_rest(&self, state: &WireState<D>, island: usize) -> bool {
        let nodes = &self.islands[island].nodes;
        let is_zero = |field: &[[f64; D]]| field[nodes.clone()].iter().flatten().all(|v| *v == 0.0);
        let at_rest = match &state.stepping {
            Stepping::Implicit(own) => is_zero(&own.a),
            Stepping::Explicit(chain) => match &self.integrator {
                Integrator::Explicit(steps) => steps.is_at_rest(island, chain),
                _ => true,
            },
        };
        is_zero(&state.u) && is_zero(&state.v) && at_rest
    }

    /// Puts an island back to rest.
    pub(crate) fn reset(&self, state: &mut WireState<D>, island: usize) {
        let Island { nodes, links, .. } = &self.islands[island];
        for field in [&mut state.u, &mut state.v, &mut state.delta] {
            field[nodes.clone()].fill([0.0; D]);
        }
        state.links.reset(links.clone());
        match (&self.integrator, &mut state.stepping) {
            (Integrator::Explicit(steps), Stepping::Explicit(chain)) => steps.reset(island, chain),
            (_, Stepping::Implicit(own)) => own.reset(nodes.clone()),
            _ => (),
        }
    }
}
