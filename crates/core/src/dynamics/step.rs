//! One step of line and riders.

use super::inputs::Inputs;
use super::model::Model;
use super::rider::inner;
use super::state::{Motion, State};
use crate::error::CoreError;

/// Take one step: from the state at its start to the state at its end.
///
/// # Errors
/// [`CoreError::OffWire`], [`CoreError::OutOfReach`] where a rider leaves its wires,
/// [`CoreError::Lcp`], [`CoreError::SlackSet`] where the unilateral forces are not found,
/// [`CoreError::Singular`], [`CoreError::Folded`] with updated kinematics, [`CoreError::Balance`],
/// [`CoreError::NotFinite`].
pub fn step<const DIM: usize, const D: usize>(
    model: &Model<'_, DIM, D>,
    inputs: &Inputs<'_>,
    state: &mut State<DIM, D>,
) -> Result<(), CoreError> {
    // With updated kinematics: coordinates, forces and stiffness at the present position.
    if let Some(present) = &mut state.present {
        present.reform(&mut state.motion.line, state.motion.steps)?;
    }

    // Where the strips meet the wires.
    let at = model.at(state.present.as_deref());
    state.motion.find_contacts(&at, inputs)?;

    // Motion without contact forces.
    state.motion.drag(model.friction);
    state.motion.predict(&at, inputs);
    state.motion.measure_gaps(&at);

    // Contacts, slack links, stops and kinks together: one complementarity problem.
    let solved = state.solve_unilateral(model)?;

    let State {
        present,
        motion,
        recorder,
    } = state;
    let at = model.at(present.as_deref());
    match recorder {
        Some(recorder) => recorder.take(&at, inputs, motion, &solved),
        None => {
            motion.advance(&at);
            motion.check_sound()
        }
    }
}

impl<const DIM: usize, const D: usize> Motion<DIM, D> {
    /// Contacts of the step, and what of the line they wake and read.
    fn find_contacts(
        &mut self,
        model: &Model<'_, DIM, D>,
        inputs: &Inputs<'_>,
    ) -> Result<(), CoreError> {
        let (lanes, u) = (&model.line.lanes, self.line.displacement());
        self.contacts
            .find(model.riders, lanes, &u, inputs.positions, self.steps)?;
        self.contacts.slide(&self.riders);
        self.unilateral.choose(&self.contacts);
        let with_wire = self.contacts.all.iter().filter(|c| c.has_wire);
        let read = with_wire.flat_map(|c| lanes[c.of[2]].around(&c.place));
        if !self.contacts.all.is_empty() {
            model.line.look_at(&mut self.line, read);
        }
        self.wake(model);
        Ok(())
    }

    /// Friction of the force of the step before, T = f n (Amontons–Coulomb), drags the wire along.
    fn drag(&mut self, friction: f64) {
        for (t, n) in self.friction.iter_mut().zip(&self.unilateral.force) {
            *t = friction * n;
        }
    }

    /// Increments of line and riders without contact forces.
    fn predict(&mut self, model: &Model<'_, DIM, D>, inputs: &Inputs<'_>) {
        let Self {
            line,
            riders,
            contacts,
            friction,
            ..
        } = self;
        model.line.predict(line, |f| {
            inputs.loads.add_to(f);
            for &i in contacts.active.iter().filter(|&&i| friction[i] != 0.0) {
                contacts.all[i].place.add_force(friction[i], 0, f);
            }
            !inputs.loads.is_empty() || friction.iter().any(|t| *t != 0.0)
        });
        for (number, rider) in riders.iter_mut().enumerate() {
            if let Some(given) = inputs.given.get(number) {
                rider.begin(given);
            }
            rider.free_increment(&model.line.coefficients, inputs.speed);
        }
    }

    /// Gaps that the motion without contact forces would open (or, negative, close).
    fn measure_gaps(&mut self, model: &Model<'_, DIM, D>) {
        let keep = model.line.coefficients.stiffness;
        for &i in &self.contacts.active {
            let contact = &self.contacts.all[i];
            let (rider, e) = (&self.riders[contact.rider()], &contact.vector);
            let strip = self.datum + inner(e, &rider.u) + keep * inner(e, &rider.delta);
            let raised = contact.yields.rise + self.raised_by_links(model, &contact.yields, keep);
            self.gaps[i] = self.wire_at(model, contact, DIM - 1) + raised - strip;
        }
    }

    /// Take the increments: the state at the end of the step.
    pub(super) fn advance(&mut self, model: &Model<'_, DIM, D>) {
        model.line.commit(&mut self.line);
        for rider in &mut self.riders {
            rider.advance(&model.line.coefficients);
        }
        self.steps += 1;
    }

    /// Refuse a motion that is not finite, step by step where only the integrator sees all of it.
    ///
    /// # Errors
    /// [`CoreError::NotFinite`].
    pub(super) fn check_sound(&self) -> Result<(), CoreError> {
        let of_riders = self.riders.iter().flat_map(|r| &r.u);
        let mut all = of_riders.chain(&self.unilateral.force);
        if self.line.is_sound() && all.all(|v| v.is_finite()) {
            return Ok(());
        }
        Err(CoreError::NotFinite {
            what: "the motion",
            step: self.steps - 1,
        })
    }
}
