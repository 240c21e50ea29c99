//! One time step of the line and its riders.
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

use super::columns::Columns;
use super::contact::Unilateral;
use super::contacts::Contacts;
use super::explicit::{Explicit, Grid};
use super::islands::Island;
use super::line::Line;
use super::link_table::LinkTable;
use super::links::LinkMotion;
use super::path::Path;
use super::place::slots;
use super::still::StillFactors;
use super::updated::Updating;
use crate::error::CoreError;
use crate::linalg::{BlockLdl, Kernel, widest};
use crate::scheme::{Coefficients, Scheme};
use crate::statics::Geometry;
use std::ops::RangeInclusive;
use std::sync::OnceLock;

/// Step lengths in s. Their squares divide masses and multiply forces: far beyond what moves a line,
/// and far inside of what numbers can hold.
const STEP_LENGTHS: RangeInclusive<f64> = 1e-12..=1e6;

/// Everything that stays the same during a run, and may be shared by many runs.
#[derive(Debug, Clone)]
pub struct Prepared<const DIM: usize, const D: usize> {
    /// Linearised structure.
    pub line: Line<DIM, D>,
    /// Wires the contacts run along.
    pub lanes: Vec<Path<DIM>>,
    /// Step length, s.
    pub h: f64,
    /// Numbers of the scheme.
    pub coefficients: Coefficients,
    /// Influence columns: lane by lane one for each slot (force, couple) of each node, then one for
    /// each link.
    pub columns: Columns<D>,
    /// Columns of the lanes.
    pub(super) lane_columns: usize,
    pub(super) table: LinkTable,
    /// 1/(a k_c), m/N; zero for rigid contact.
    pub contact_compliance: f64,
    /// 1/k_c, m/N.
    pub contact_flexibility: f64,
    /// What updated kinematics need; `None` with linearised kinematics.
    pub(super) updating: Option<Updating<DIM, D>>,
    pub(super) steps: Steps<DIM, D>,
    /// Factors of the stiffness, once somebody asked for them; not with updated kinematics, which change it.
    pub(super) still: OnceLock<StillFactors<D>>,
    /// What of the line nothing couples.
    pub(super) islands: Vec<Island>,
    fixed: Vec<(u32, u32)>,
    from_mass: [f64; 3],
    from_damping: [f64; 3],
    shift: [f64; 3],
}

/// How the line takes a step.
#[derive(Debug, Clone)]
pub(super) enum Steps<const DIM: usize, const D: usize> {
    /// With the factor of the matrix of the scheme.
    Solved(Box<BlockLdl<D>>),
    Explicit(Box<Explicit<DIM>>),
}

/// State of the line during a run.
#[derive(Debug, Clone)]
pub struct LineState<const D: usize> {
    /// Displacement from the static shape, m.
    pub u: Vec<[f64; D]>,
    /// Velocity, m/s.
    pub v: Vec<[f64; D]>,
    /// Acceleration, m/s².
    pub a: Vec<[f64; D]>,
    /// Increment of the current step.
    pub delta: Vec<[f64; D]>,
    /// Elongations and tensions of the links.
    pub links: LinkMotion,
    /// The line as explicit steps move it; then the fields above hold what others read of it.
    pub(super) grid: Option<Grid>,
    /// Numbers of the islands that are stepped, ascending; all else is at rest.
    pub(super) awake: Vec<usize>,
    /// −(combination of u, v, a) whose product with M is the inertia of the next step.
    prepared: Vec<[f64; D]>,
    /// s/κ of the next step.
    shift: Vec<[f64; D]>,
    pub(super) work: Vec<[f64; D]>,
    scratch: Vec<[f64; D]>,
}

impl<const D: usize> LineState<D> {
    fn at_rest<const DIM: usize>(line: &Line<DIM, D>, islands: usize, u: Vec<[f64; D]>) -> Self {
        let zero = vec![[0.0; D]; u.len()];
        Self {
            awake: (0..islands).collect(),
            grid: None,
            links: LinkMotion::at_rest(&line.links, &u),
            v: zero.clone(),
            a: zero.clone(),
            delta: zero.clone(),
            prepared: zero.clone(),
            shift: zero.clone(),
            work: zero.clone(),
            scratch: zero,
            u,
        }
    }

    /// What changes during a run, node by node.
    pub(super) fn fields(&mut self) -> [&mut Vec<[f64; D]>; 6] {
        [
            &mut self.u,
            &mut self.v,
            &mut self.a,
            &mut self.delta,
            &mut self.prepared,
            &mut self.shift,
        ]
    }
}

impl<const DIM: usize, const D: usize> Prepared<DIM, D> {
    /// Factorise the matrix of the scheme and prepare the influence columns.
    /// `contact_stiffness` is infinite for rigid contact.
    ///
    /// # Errors
    /// [`CoreError::Input`] or [`CoreError::Singular`].
    pub fn new(
        line: Line<DIM, D>,
        lanes: Vec<Path<DIM>>,
        scheme: Scheme,
        h: f64,
        contact_stiffness: f64,
    ) -> Result<Self, CoreError> {
        Self::assemble(line, lanes, scheme, h, contact_stiffness, (None, None))
    }

    /// The same for explicit steps of wires that are chains, see [`Explicit`]; on [`Path::rounded`] lanes they are
    /// right between points as well.
    ///
    /// # Errors
    /// [`CoreError::Input`] or [`CoreError::Singular`].
    pub fn explicit(
        geometry: &Geometry<DIM, D>,
        line: Line<DIM, D>,
        lanes: Vec<Path<DIM>>,
        h: f64,
        contact_stiffness: f64,
    ) -> Result<Self, CoreError> {
        let steps = Explicit::new(geometry, &line.shape, &line, h)?;
        let scheme = Scheme::newmark(0.25, 0.5);
        let with = (None, Some(steps));
        Self::assemble(line, lanes, scheme, h, contact_stiffness, with)
    }

    pub(super) fn assemble(
        line: Line<DIM, D>,
        lanes: Vec<Path<DIM>>,
        scheme: Scheme,
        h: f64,
        contact_stiffness: f64,
        (updating, explicit): (Option<Updating<DIM, D>>, Option<Explicit<DIM>>),
    ) -> Result<Self, CoreError> {
        scheme.check()?;
        if !STEP_LENGTHS.contains(&h) || contact_stiffness.is_nan() || contact_stiffness <= 0.0 {
            let reason = format!("step {h} s, contact stiffness {contact_stiffness} N/m");
            return Err(CoreError::Input {
                array: "solver",
                reason,
            });
        }
        let c = scheme.coefficients(h);
        let steps = match explicit {
            None => {
                let matrix = line.combine(c.mass, c.damping, c.stiffness);
                Steps::Solved(Box::new(BlockLdl::new(&matrix)?))
            }
            Some(steps) => Steps::Explicit(Box::new(steps)),
        };
        let beta = line.common.beta;
        let kappa = c.stiffness + c.damping * beta;
        // Each vector below is a combination of (u, v, a) with constant numbers.
        let old_v = [0.0, c.velocity_from_v, c.velocity_from_a];
        let old_a = [0.0, c.acceleration_from_v, c.acceleration_from_a];
        // With updated kinematics the forces of the present position are given: no product K u.
        let from_u = f64::from(u8::from(updating.is_none()));
        let s = [from_u, beta * old_v[1], beta * old_v[2]];
        let alpha = line.common.alpha;
        let combine =
            |k: usize| old_a[k] + alpha * old_v[k] - (c.mass + c.damping * alpha) / kappa * s[k];
        let lane_columns = slots::<DIM, D>() * lanes.iter().map(|l| l.nodes.len()).sum::<usize>();
        let fixed = line.free.iter().enumerate().flat_map(|(node, free)| {
            (0..D)
                .filter(|&k| !free[k])
                .map(move |k| (node as u32, k as u32))
        });
        let fixed: Vec<(u32, u32)> = fixed.collect();
        let mut prepared = Self {
            islands: Island::all(&line, &fixed),
            fixed,
            from_mass: [0, 1, 2].map(combine),
            from_damping: [0, 1, 2].map(|k| old_v[k] - c.damping / kappa * s[k]),
            shift: s.map(|v| v / kappa),
            table: LinkTable::new(&line.links, &c),
            contact_compliance: 1.0 / (contact_stiffness * c.stiffness),
            contact_flexibility: 1.0 / contact_stiffness,
            columns: Columns::new(lane_columns + line.links.len()),
            lane_columns,
            line,
            lanes,
            h,
            coefficients: c,
            steps,
            still: OnceLock::new(),
            updating,
        };
        if let Steps::Explicit(steps) = &prepared.steps {
            let mut grid = steps.still();
            for number in 0..prepared.columns.count() {
                let load = prepared.unit_load(number);
                let load = load.iter().flat_map(|(node, force)| {
                    let shares = force.iter().enumerate().take(DIM);
                    shares.map(move |(c, f)| (*node, c, *f))
                });
                steps.set_column(&mut prepared.columns, number, load, &mut grid);
            }
        } else if prepared.updating.is_none() {
            let mut space = prepared.space();
            for number in 0..prepared.columns.count() {
                prepared.set_column(number, &mut space);
            }
        }
        Ok(prepared)
    }

    /// Two vectors of zeros to compute columns in.
    pub(super) fn space(&self) -> [Vec<[f64; D]>; 2] {
        [0, 1].map(|_| vec![[0.0; D]; self.line.nodes()])
    }

    /// Compute a column.
    pub(super) fn set_column(&mut self, number: usize, [x, work]: &mut [Vec<[f64; D]>; 2]) {
        let load = self.unit_load(number);
        if let Steps::Solved(factor) = &self.steps {
            self.columns.set(number, factor, &load, [x, work]);
        }
    }

    /// Right-hand side of a column, node by node. First come those of the nodes of all lanes (unit
    /// force in the vertical, and unit couple where they have slopes), then those of all links.
    fn unit_load(&self, number: usize) -> Vec<(usize, [f64; D])> {
        let slots = slots::<DIM, D>();
        let (mut place, mut on_lane) = (number / slots, None);
        for lane in &self.lanes {
            on_lane = lane.nodes.get(place);
            if on_lane.is_some() {
                break;
            }
            place -= lane.nodes.len();
        }
        let mut load = Vec::new();
        if let Some(&node) = on_lane {
            let mut force = [0.0; D];
            force[number % slots * DIM + DIM - 1] = 1.0;
            load.push((node, force));
        } else {
            load.extend(self.line.links[number - self.lane_columns].unit_pull());
        }
        for (node, force) in &mut load {
            for c in 0..D {
                if !self.line.free[*node][c] {
                    force[c] = 0.0;
                }
            }
        }
        load
    }

    /// Blocks in the factor, for reports on cost; explicit steps have none.
    #[must_use]
    pub fn fill(&self) -> usize {
        match &self.steps {
            Steps::Solved(factor) => factor.fill(),
            Steps::Explicit(_) => 0,
        }
    }

    /// What explicit steps need, where they are taken.
    pub(super) fn explicit_steps(&self) -> Option<&Explicit<DIM>> {
        match &self.steps {
            Steps::Solved(_) => None,
            Steps::Explicit(steps) => Some(steps),
        }
    }

    /// A state at rest in a displaced position, ready for the first step.
    #[must_use]
    pub fn at_rest(&self, u: Vec<[f64; D]>) -> LineState<D> {
        let (grid, u) = match self.explicit_steps() {
            None => (None, u),
            Some(steps) => steps.at_rest(self, u),
        };
        let mut state = LineState::at_rest(&self.line, self.islands.len(), u);
        if grid.is_some() {
            state.grid = grid;
            return state;
        }
        widest(Advance {
            p: self,
            state: &mut state,
        });
        state
    }

    /// Increment of the line without contact forces and corrections. `load` is called with the
    /// force vector to add given forces; it tells whether there are any.
    pub fn free_increment(
        &self,
        state: &mut LineState<D>,
        load: impl FnOnce(&mut [[f64; D]]) -> bool,
    ) {
        let factor = match &self.steps {
            Steps::Solved(factor) => factor,
            Steps::Explicit(steps) => return self.free_explicit(steps, state, load),
        };
        widest(Inertia { p: self, state });
        let LineState {
            u,
            v,
            a,
            delta,
            work,
            shift,
            scratch,
            links,
            awake,
            ..
        } = state;
        for island in self.awake(awake) {
            self.subtract_damping_rest(island, [u, v, a], [work, scratch], delta);
        }
        load(delta);
        if let Some(now) = &self.updating {
            for (force, residual) in delta.iter_mut().zip(&now.residual) {
                for c in 0..D {
                    force[c] -= residual[c];
                }
            }
        }
        for island in self.awake(awake) {
            if self.updating.is_none() {
                self.line.add_rest_corrections(island.links.clone(), delta);
            }
            for &(node, component) in &self.fixed[island.fixed.clone()] {
                delta[node as usize][component as usize] = 0.0;
            }
        }
        let nodes = self.awake(awake).map(|island| island.nodes.clone());
        factor.solve_minus(nodes, delta, shift, work);
        self.begin_links(awake, links, delta);
    }

    /// Tensions of links under the increment without contact forces and corrections.
    pub(super) fn begin_links(&self, awake: &[usize], links: &mut LinkMotion, delta: &[[f64; D]]) {
        let of = (&self.line.links[..], &self.table);
        for island in self.awake(awake) {
            links.begin(island.links.clone(), of, &self.coefficients, delta);
        }
    }

    /// `f −= (C − αM − βK) (v* − (a_C/κ) s)` on an island.
    fn subtract_damping_rest(
        &self,
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
        if self.line.mass_damping_rest.is_some() {
            island.nodes.clone().for_each(combine);
        } else {
            for (i, j, _) in &self.line.damping_rest[island.damping.clone()] {
                combine(*i);
                combine(*j);
            }
        }
        self.line.add_damping_rest(island, work, f, scratch);
    }

    /// Add the response to what changed since the last call in this step: Δu += A⁻¹(C λ − G r).
    pub(super) fn respond(
        &self,
        state: &mut LineState<D>,
        unilateral: &mut Unilateral,
        contacts: &Contacts<DIM>,
    ) {
        let mut moved = self.line.nodes()..0;
        let mut add = |column: usize, factor: f64| {
            let nodes = self.columns.add(column, factor, &mut state.delta);
            moved = moved.start.min(nodes.start)..moved.end.max(nodes.end);
        };
        for &j in &contacts.active {
            let place = &contacts.all[j].place;
            let change = unilateral.force[j] - unilateral.applied_force[j];
            unilateral.applied_force[j] = unilateral.force[j];
            self.push(&mut state.grid, place.shares::<D>(DIM - 1), change);
            for (column, weight) in place.columns::<D>().zip(&place.weights) {
                add(column, weight * change);
            }
            for (link, rise) in contacts.all[j].yields.pulls() {
                let eased = self.eased(link, rise) * change;
                add(self.link_column(link), eased);
                state.links.ease(link, eased);
            }
        }
        for &link in &unilateral.links {
            let change = unilateral.correction[link] - unilateral.applied_correction[link];
            unilateral.applied_correction[link] = unilateral.correction[link];
            if change != 0.0 {
                self.push(&mut state.grid, self.line.links[link].shares(1.0), -change);
                add(self.link_column(link), -change);
            }
        }
        let of = (&self.line.links[..], &self.table);
        state.links.follow(moved, of, &state.delta);
    }

    /// Tell an explicit line which nodes are read in the coming step.
    pub(super) fn look_at(&self, state: &mut LineState<D>, nodes: impl Iterator<Item = usize>) {
        if let (Some(steps), Some(grid)) = (self.explicit_steps(), &mut state.grid) {
            steps.look_at(grid, nodes);
        }
    }

    /// Tell an explicit line which nodes are read in every step.
    pub(super) fn watch(&self, state: &mut LineState<D>, nodes: impl Iterator<Item = usize>) {
        if let (Some(steps), Some(grid)) = (self.explicit_steps(), &mut state.grid) {
            steps.watch(grid, nodes);
        }
    }

    /// What the next step starts from, for a state that was put back.
    pub(super) fn go_on(&self, state: &mut LineState<D>) {
        if let (Some(steps), Some(grid)) = (self.explicit_steps(), &mut state.grid) {
            (0..self.islands.len()).for_each(|island| steps.wire_forces(island, grid));
            return;
        }
        for i in 0..state.u.len() {
            for k in 0..D {
                let at = [state.u[i][k], state.v[i][k], state.a[i][k]];
                let next = next(self.from_mass, self.shift, at);
                (state.prepared[i][k], state.shift[i][k]) = next;
            }
        }
    }

    /// Take the step: new displacement, velocity, acceleration.
    pub fn advance(&self, state: &mut LineState<D>) {
        match self.explicit_steps() {
            None => widest(Advance { p: self, state }),
            Some(steps) => steps.advance(state),
        }
        for island in self.awake(&state.awake) {
            state
                .links
                .advance(island.links.clone(), &self.coefficients);
        }
    }
}

/// Inertia and shift of the next step from displacement, velocity and acceleration.
#[inline(always)]
fn next([mu, mv, ma]: [f64; 3], [su, sv, sa]: [f64; 3], [u, v, a]: [f64; 3]) -> (f64, f64) {
    (-(mu * u + mv * v + ma * a), su * u + sv * v + sa * a)
}

/// `delta = M · prepared`
struct Inertia<'a, const DIM: usize, const D: usize> {
    p: &'a Prepared<DIM, D>,
    state: &'a mut LineState<D>,
}

impl<const DIM: usize, const D: usize> Kernel for Inertia<'_, DIM, D> {
    #[inline(always)]
    fn run(self) {
        let LineState {
            delta,
            prepared,
            awake,
            ..
        } = self.state;
        for island in self.p.awake(awake) {
            let mass = &self.p.line.mass;
            mass.multiply(island.nodes.clone(), prepared, delta);
        }
    }
}

/// New displacement, velocity and acceleration, and the combinations of them that the next step
/// starts from: one pass over the state.
struct Advance<'a, const DIM: usize, const D: usize> {
    p: &'a Prepared<DIM, D>,
    state: &'a mut LineState<D>,
}

impl<const DIM: usize, const D: usize> Kernel for Advance<'_, DIM, D> {
    #[inline(always)]
    fn run(self) {
        let LineState {
            u,
            v,
            a,
            delta,
            prepared,
            shift: shifts,
            awake,
            ..
        } = self.state;
        let (c, from_mass, shift) = (&self.p.coefficients, self.p.from_mass, self.p.shift);
        for island in self.p.awake(awake) {
            let nodes = || island.nodes.clone();
            // Every number by itself: over rows the compiler would gather four of them and transpose.
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
                (*w, *s) = next(from_mass, shift, [new_u, new_v, new_a]);
                (*u, *v, *a) = (new_u, new_v, new_a);
            }
        }
    }
}
