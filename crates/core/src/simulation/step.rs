//! Step of line and pantographs.

use crate::error::CoreError;
use crate::lcp::LcpStats;
use crate::linalg::small::inner;
use crate::simulation::inputs::Inputs;
use crate::simulation::model::Model;
use crate::simulation::motion::Motion;
use crate::simulation::state::State;

/// Takes one step: from the state at its start to the state at its end.
///
/// # Errors
/// [`CoreError::OffWire`], [`CoreError::OutOfReach`] where a pantograph leaves its wires,
/// [`CoreError::Lcp`], [`CoreError::SlackSet`] where the unilateral forces are not found,
/// [`CoreError::Singular`], [`CoreError::Folded`] with updated kinematics, [`CoreError::Balance`],
/// [`CoreError::NotFinite`].
pub fn step<const DIM: usize, const D: usize>(
    model: &Model<'_, DIM, D>,
    inputs: &Inputs<'_>,
    state: &mut State<DIM, D>,
) -> Result<(), CoreError> {
    let stats = solve(model, inputs, state)?;
    complete(model, inputs, state, &stats)
}

/// Finds the increments of a step and its forces.
///
/// # Errors
/// As [`step`].
pub(crate) fn solve<const DIM: usize, const D: usize>(
    model: &Model<'_, DIM, D>,
    inputs: &Inputs<'_>,
    state: &mut State<DIM, D>,
) -> Result<LcpStats, CoreError> {
    // With updated kinematics: coordinates, forces and stiffness at the current position.
    if let Some(current_geometry) = &mut state.current_geometry {
        current_geometry.reform(&mut state.motion.wires, state.motion.steps)?;
    }

    // Points where strips meet wires.
    let current = model.with_geometry(state.current_geometry.as_deref());
    state.motion.find_contacts(&current, inputs)?;

    // Motion without contact forces.
    state.motion.update_friction(model.friction);
    state.motion.predict(&current, inputs);
    state.motion.measure_gaps(&current);

    // Contacts, slack links, stops and breakpoints together: one complementarity problem.
    let stats = state.solve_constraints(model)?;
    state.motion.sum_external_loads();
    Ok(stats)
}

/// Records the step and moves the state to its end.
///
/// # Errors
/// [`CoreError::Balance`], [`CoreError::NotFinite`].
pub(crate) fn complete<const DIM: usize, const D: usize>(
    model: &Model<'_, DIM, D>,
    inputs: &Inputs<'_>,
    state: &mut State<DIM, D>,
    stats: &LcpStats,
) -> Result<(), CoreError> {
    let State {
        current_geometry,
        motion,
        recorder,
    } = state;
    let current = model.with_geometry(current_geometry.as_deref());
    match recorder {
        Some(recorder) => recorder.take(&current, inputs, motion, stats),
        None => {
            motion.commit(&current);
            motion.check_sound()
        }
    }
}

impl<const DIM: usize, const D: usize> Motion<DIM, D> {
    /// Finds the contacts of the step, wakes their islands and requests the nodes they read.
    fn find_contacts(
        &mut self,
        model: &Model<'_, DIM, D>,
        inputs: &Inputs<'_>,
    ) -> Result<(), CoreError> {
        let (slidelines, u) = (&model.wires.slidelines, self.wires.displacement());
        self.contacts.search(
            model.pantographs,
            slidelines,
            &u,
            inputs.positions,
            self.steps,
        )?;
        self.contacts.update_vectors(&self.pantographs);
        self.problem.drop_inactive_contacts(&self.contacts);
        let with_wire = self.contacts.all.iter().filter(|c| c.has_wire);
        let read = with_wire.flat_map(|c| slidelines[c.indices[2]].nodes_around(&c.point));
        if !self.contacts.all.is_empty() {
            model.wires.request_nodes(&mut self.wires, read);
        }
        self.wake(model);
        Ok(())
    }

    /// Computes friction along the wire from the forces of the step before, T = f n
    /// (Amontons–Coulomb), N.
    fn update_friction(&mut self, friction: f64) {
        for (t, n) in self.friction.iter_mut().zip(&self.problem.force) {
            *t = friction * n;
        }
    }

    /// Computes the increments of line and pantographs without contact forces, m.
    fn predict(&mut self, model: &Model<'_, DIM, D>, inputs: &Inputs<'_>) {
        let Self {
            wires,
            pantographs,
            contacts,
            friction,
            ..
        } = self;
        model.wires.predict(wires, |f| {
            inputs.loads.add_to(f);
            for &i in contacts.active.iter().filter(|&&i| friction[i] != 0.0) {
                contacts.all[i].point.add_force(friction[i], 0, f);
            }
            !inputs.loads.is_empty() || friction.iter().any(|t| *t != 0.0)
        });
        for (number, pantograph) in pantographs.iter_mut().enumerate() {
            if let Some(excitation) = inputs.excitations.get(number) {
                pantograph.set_excitation(excitation);
            }
            pantograph.predict(&model.wires.coefficients, inputs.speed);
        }
    }

    /// Computes the gaps of the motion without contact forces, m; negative ones are closed.
    fn measure_gaps(&mut self, model: &Model<'_, DIM, D>) {
        let keep = model.wires.coefficients.stiffness;
        for &i in &self.contacts.active {
            let contact = &self.contacts.all[i];
            let (pantograph, e) = (&self.pantographs[contact.pantograph()], &contact.vector);
            let strip = self.datum + inner(e, &pantograph.u) + keep * inner(e, &pantograph.delta);
            let height_above_mesh = contact.compliance.static_height
                + self.raised_by_links(model, &contact.compliance, keep);
            self.gaps[i] = self.wire_at(model, contact, DIM - 1) + height_above_mesh - strip;
        }
    }

    /// Adds the increments: the state at the end of the step.
    pub(crate) fn commit(&mut self, model: &Model<'_, DIM, D>) {
        model.wires.commit(&mut self.wires);
        for pantograph in &mut self.pantographs {
            if pantograph.model.is_external {
                pantograph.commit_external(model.wires.h);
            } else {
                pantograph.commit(&model.wires.coefficients);
            }
        }
        self.steps += 1;
    }

    /// Refuses a motion that is not finite, step by step where only the integrator sees all of it.
    ///
    /// # Errors
    /// [`CoreError::NotFinite`].
    pub(crate) fn check_sound(&self) -> Result<(), CoreError> {
        let displacements = self.pantographs.iter().flat_map(|r| &r.u);
        let mut all = displacements.chain(&self.problem.force);
        if self.wires.is_sound() && all.all(|v| v.is_finite()) {
            return Ok(());
        }
        Err(CoreError::NotFinite {
            what: "the motion",
            step: self.steps - 1,
        })
    }
}
