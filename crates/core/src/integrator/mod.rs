//! How wires take a step: one interface, three integrators behind it.
//!
//! Nobody outside of this room asks which one it is. A step is: [`WireModel::predict`], the motion without
//! contact forces and corrections; [`WireModel::apply`], as often as forces are found; and
//! [`WireModel::commit`].

pub mod energy;
pub mod explicit;
pub(crate) mod implicit;
pub mod prepared;
pub(crate) mod static_line;
pub mod updated_geometry;

use crate::checkpoint::Archive;
use crate::constraint::columns::ComplianceColumns;
use crate::constraint::contacts::Contacts;
use crate::constraint::links::LinkMotion;
use crate::constraint::problem::ConstraintProblem;
use crate::error::CoreError;
use crate::integrator::explicit::{Explicit, Grid};
use crate::integrator::prepared::WireModel;
use crate::simulation::sleep::Island;
use crate::slideline::point::Nodal;
use implicit::{Implicit, ImplicitState};
use updated_geometry::UpdatedGeometry;

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

/// State of the wires during a run.
#[derive(Debug, Clone)]
pub struct WireState<const D: usize> {
    /// Displacement from the static shape, m, and velocity, m/s. Explicit steps know those of nodes alone
    /// that are linked, watched or looked at.
    pub(crate) u: Vec<[f64; D]>,
    pub(crate) v: Vec<[f64; D]>,
    /// Increment of the present step, of the same nodes.
    pub(crate) delta: Vec<[f64; D]>,
    /// Elongations and tensions of the links.
    pub links: LinkMotion,
    /// Numbers of the islands that are stepped, ascending; all else is at rest.
    pub(crate) awake: Vec<usize>,
    pub(crate) work: Vec<[f64; D]>,
    pub(crate) stepping: Stepping<D>,
}

/// Part of the state that belongs to the integrator.
#[derive(Debug, Clone)]
pub(crate) enum Stepping<const D: usize> {
    Implicit(ImplicitState<D>),
    /// In memory of its own, aligned for wide lanes wherever the state lies.
    Explicit(Box<Grid>),
}

/// Vectors of the nodes whose motion the integrator knows. Explicit steps know that of linked, watched
/// and looked-at nodes alone: asking for another one is a mistake, which tests notice.
#[derive(Debug, Clone, Copy)]
pub struct Known<'a, const D: usize> {
    values: &'a [[f64; D]],
    /// Number of the last step that has found the motion of each node, and the one asked for.
    found: Option<(&'a [u64], u64)>,
}

impl<'a, const D: usize> Known<'a, D> {
    fn new(values: &'a [[f64; D]], stepping: &'a Stepping<D>, ahead: u64) -> Self {
        let found = match stepping {
            Stepping::Implicit(_) => None,
            Stepping::Explicit(grid) => Some((&grid.found[..], grid.steps + ahead)),
        };
        Self { values, found }
    }
}

impl<const D: usize> Nodal<D> for Known<'_, D> {
    #[inline(always)]
    fn at(&self, node: usize) -> &[f64; D] {
        debug_assert!(
            self.found.is_none_or(|(found, step)| found[node] >= step),
            "the motion of node {node} is not known"
        );
        &self.values[node]
    }
}

impl<const D: usize> WireState<D> {
    fn new<const DIM: usize>(
        p: &WireModel<DIM, D>,
        u: Vec<[f64; D]>,
        stepping: Stepping<D>,
    ) -> Self {
        let zero = vec![[0.0; D]; u.len()];
        Self {
            links: LinkMotion::at_rest(&p.line.links, &u),
            v: zero.clone(),
            delta: zero.clone(),
            work: zero,
            awake: (0..p.islands.len()).collect(),
            stepping,
            u,
        }
    }

    /// Whether all that moves is at finite places; implicit steps leave that to whoever looks at
    /// displacements now and then.
    pub(crate) fn is_sound(&self) -> bool {
        match &self.stepping {
            Stepping::Implicit(_) => true,
            Stepping::Explicit(grid) => grid.is_sound(),
        }
    }

    /// Displacements at the start of the step, m, of nodes that the step before has looked at.
    #[must_use]
    pub fn displacement(&self) -> Known<'_, D> {
        Known::new(&self.u, &self.stepping, 0)
    }

    /// Velocities at the start of the step, m/s, of the same nodes.
    #[must_use]
    pub fn velocity(&self) -> Known<'_, D> {
        Known::new(&self.v, &self.stepping, 0)
    }

    /// Displacements and increments of the present step, m, of nodes that it looks at. Their sum is known
    /// of all of these; the displacement alone of those that the step before has looked at.
    pub(crate) fn at_balance(&self) -> [Known<'_, D>; 2] {
        [&self.u, &self.delta].map(|values| Known::new(values, &self.stepping, 1))
    }

    /// Accelerations of implicit steps, m/s²; of explicit ones nobody knows all.
    pub(crate) fn acceleration(&self) -> &[[f64; D]] {
        match &self.stepping {
            Stepping::Implicit(own) => &own.a,
            Stepping::Explicit(_) => &[],
        }
    }

    /// Whether every displacement that others read is finite.
    pub(crate) fn is_finite(&self) -> bool {
        self.u.iter().flatten().all(|v| v.is_finite())
    }

    /// Make room for what is read at a number of places, so that none is made in a step.
    pub(crate) fn reserve(&mut self, places: usize) {
        if let Stepping::Explicit(grid) = &mut self.stepping {
            grid.reserve(places);
        }
    }

    /// Save or put back the motion.
    ///
    /// # Errors
    /// [`CoreError::Input`] for numbers that do not fit.
    pub(crate) fn walk(&mut self, walk: &mut Archive<'_>) -> Result<(), CoreError> {
        walk.numbers("line_displacement", self.u.as_flattened_mut().iter_mut())?;
        walk.numbers("line_velocity", self.v.as_flattened_mut().iter_mut())?;
        match &mut self.stepping {
            Stepping::Implicit(own) => {
                let a = own.a.as_flattened_mut().iter_mut();
                walk.numbers("line_acceleration", a)?;
            }
            Stepping::Explicit(grid) => {
                walk.numbers("grid_across", grid.across())?;
                walk.numbers("grid_along", grid.x.iter_mut().flatten())?;
            }
        }
        walk.numbers("link_elongation", self.links.numbers())
    }
}

impl<const DIM: usize, const D: usize> WireModel<DIM, D> {
    /// Explicit steps with their grid.
    pub(crate) fn explicit_state<'a>(
        &'a self,
        state: &'a WireState<D>,
    ) -> Option<(&'a Explicit<DIM>, &'a Grid)> {
        match (&self.integrator, &state.stepping) {
            (Integrator::Explicit(steps), Stepping::Explicit(grid)) => Some((steps, grid)),
            _ => None,
        }
    }

    fn explicit_mut<'a>(
        &'a self,
        stepping: &'a mut Stepping<D>,
    ) -> Option<(&'a Explicit<DIM>, &'a mut Grid)> {
        match (&self.integrator, stepping) {
            (Integrator::Explicit(steps), Stepping::Explicit(grid)) => Some((steps, grid)),
            _ => None,
        }
    }

    /// Blocks in the factor, for reports on cost; explicit steps have none.
    #[must_use]
    pub fn fill(&self) -> usize {
        match &self.integrator {
            Integrator::Implicit(own) | Integrator::UpdatedGeometry(own, _) => own.factor.fill(),
            Integrator::Explicit(_) => 0,
        }
    }

    /// Whether islands that nothing has reached stay exactly at rest, so that steps may leave them out.
    pub(crate) fn may_sleep(&self) -> bool {
        !matches!(self.integrator, Integrator::UpdatedGeometry(..))
    }

    /// Whether a ledger of energies can be kept.
    pub(crate) fn keeps_energy(&self) -> bool {
        !matches!(self.integrator, Integrator::UpdatedGeometry(..))
    }

    /// Whether a step allocates nothing, and costs the same every time.
    pub(crate) fn steps_evenly(&self) -> bool {
        !matches!(self.integrator, Integrator::UpdatedGeometry(..))
    }

    /// Compute all influence columns, unless they change with the position.
    pub(crate) fn set_columns(&mut self) {
        match &self.integrator {
            Integrator::Explicit(steps) => {
                let mut grid = steps.still();
                let mut columns = ComplianceColumns::new(self.columns.count());
                for number in 0..columns.count() {
                    let load = self.unit_load(number);
                    let load = load.iter().flat_map(|(node, force)| {
                        let shares = force.iter().enumerate().take(DIM);
                        shares.map(move |(c, f)| (*node, c, *f))
                    });
                    steps.set_column(&mut columns, number, load, &mut grid);
                }
                self.columns = columns;
            }
            Integrator::Implicit(_) => {
                let mut space = self.space();
                for number in 0..self.columns.count() {
                    self.set_column(number, &mut space);
                }
            }
            Integrator::UpdatedGeometry(..) => (),
        }
    }

    /// Two vectors of zeros to compute columns in.
    fn space(&self) -> [Vec<[f64; D]>; 2] {
        [0, 1].map(|_| vec![[0.0; D]; self.line.nodes()])
    }

    /// Compute a column with the factor.
    fn set_column(&mut self, number: usize, [x, work]: &mut [Vec<[f64; D]>; 2]) {
        let load = self.unit_load(number);
        if let Integrator::Implicit(own) | Integrator::UpdatedGeometry(own, _) = &self.integrator {
            self.columns.set(number, &own.factor, &load, [x, work]);
        }
    }

    /// A state at rest in a displaced position, ready for the first step.
    #[must_use]
    pub fn at_rest(&self, u: Vec<[f64; D]>) -> WireState<D> {
        match &self.integrator {
            Integrator::Explicit(steps) => {
                let (grid, u) = steps.at_rest(self, u);
                WireState::new(self, u, Stepping::Explicit(Box::new(grid)))
            }
            Integrator::Implicit(own) | Integrator::UpdatedGeometry(own, _) => {
                let stepping = Stepping::Implicit(ImplicitState::new(u.len()));
                let mut state = WireState::new(self, u, stepping);
                own.commit(self, &mut state);
                state
            }
        }
    }

    /// Increment of the line without contact forces and corrections. `load` is called with the
    /// force vector to add given forces; it tells whether there are any.
    pub fn predict(&self, state: &mut WireState<D>, load: impl FnOnce(&mut [[f64; D]]) -> bool) {
        match &self.integrator {
            Integrator::Explicit(steps) => steps.predict(self, state, load),
            Integrator::Implicit(own) => own.predict(self, None, state, load),
            Integrator::UpdatedGeometry(own, now) => {
                own.predict(self, Some(&now.residual), state, load);
            }
        }
        let WireState {
            links,
            awake,
            delta,
            ..
        } = state;
        let of = (&self.line.links[..], &self.table);
        for island in self.awake(awake) {
            links.begin(island.links.clone(), of, &self.coefficients, delta);
        }
    }

    /// Add the response to what changed since the last call in this step: Δu += A⁻¹(C λ − G r).
    pub(crate) fn apply(
        &self,
        state: &mut WireState<D>,
        unilateral: &mut ConstraintProblem,
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
            let place = &contacts.all[j].place;
            let change = unilateral.force[j] - unilateral.applied_force[j];
            unilateral.applied_force[j] = unilateral.force[j];
            self.push(stepping, place.shares::<D>(DIM - 1), change);
            for (column, weight) in place.columns::<D>().zip(&place.weights) {
                add(column, weight * change);
            }
            for (link, rise) in contacts.all[j].yields.pulls() {
                let eased = self.eased(link, rise) * change;
                add(self.link_column(link), eased);
                links.ease(link, eased);
            }
        }
        for &link in &unilateral.links {
            let change = unilateral.correction[link] - unilateral.applied_correction[link];
            unilateral.applied_correction[link] = unilateral.correction[link];
            if change != 0.0 {
                self.push(stepping, self.line.links[link].shares(1.0), -change);
                add(self.link_column(link), -change);
            }
        }
        let of = (&self.line.links[..], &self.table);
        links.follow(moved, of, delta);
    }

    /// Add a share of forces on nodes to what moves explicit steps; increments hold the others.
    fn push(
        &self,
        stepping: &mut Stepping<D>,
        shares: impl Iterator<Item = (usize, usize, f64)>,
        factor: f64,
    ) {
        if let Some((steps, grid)) = self.explicit_mut(stepping) {
            for (node, component, share) in shares {
                steps.push(grid, node, component, factor * share);
            }
        }
    }

    /// Take the step: new displacement and velocity.
    pub fn commit(&self, state: &mut WireState<D>) {
        match &self.integrator {
            Integrator::Explicit(steps) => steps.commit(state),
            Integrator::Implicit(own) | Integrator::UpdatedGeometry(own, _) => {
                own.commit(self, state);
            }
        }
        for island in self.awake(&state.awake) {
            state
                .links
                .advance(island.links.clone(), &self.coefficients);
        }
    }

    /// Prepare the next step of a state that was put back.
    pub(crate) fn resume(&self, state: &mut WireState<D>) {
        match &self.integrator {
            Integrator::Implicit(own) | Integrator::UpdatedGeometry(own, _) => own.resume(state),
            Integrator::Explicit(steps) => {
                if let Stepping::Explicit(grid) = &mut state.stepping {
                    (0..self.islands.len()).for_each(|island| steps.wire_forces(island, grid));
                    // Displacements are those of the saved state, of the nodes that it knew.
                    let now = grid.steps;
                    grid.found
                        .iter_mut()
                        .for_each(|step| *step = now.max(*step));
                }
            }
        }
    }

    /// Name the nodes that are read in the coming step.
    pub(crate) fn look_at(&self, state: &mut WireState<D>, nodes: impl Iterator<Item = usize>) {
        if let Some((steps, grid)) = self.explicit_mut(&mut state.stepping) {
            steps.look_at(grid, nodes);
        }
    }

    /// Name the nodes that are read in every step.
    pub(crate) fn watch(&self, state: &mut WireState<D>, nodes: impl Iterator<Item = usize>) {
        if let Some((steps, grid)) = self.explicit_mut(&mut state.stepping) {
            steps.watch(grid, nodes);
        }
    }

    /// Whether nothing of an island has moved.
    pub(crate) fn is_at_rest(&self, state: &WireState<D>, island: usize) -> bool {
        let nodes = &self.islands[island].nodes;
        let still = |field: &[[f64; D]]| field[nodes.clone()].iter().flatten().all(|v| *v == 0.0);
        let at_rest = match &state.stepping {
            Stepping::Implicit(own) => still(&own.a),
            Stepping::Explicit(grid) => match &self.integrator {
                Integrator::Explicit(steps) => steps.lies(island, grid),
                _ => true,
            },
        };
        still(&state.u) && still(&state.v) && at_rest
    }

    /// Put an island back to rest.
    pub(crate) fn reset(&self, state: &mut WireState<D>, island: usize) {
        let Island { nodes, links, .. } = &self.islands[island];
        for field in [&mut state.u, &mut state.v, &mut state.delta] {
            field[nodes.clone()].fill([0.0; D]);
        }
        state.links.lay(links.clone());
        match (&self.integrator, &mut state.stepping) {
            (Integrator::Explicit(steps), Stepping::Explicit(grid)) => steps.lay(island, grid),
            (_, Stepping::Implicit(own)) => own.reset(nodes.clone()),
            _ => (),
        }
    }
}
