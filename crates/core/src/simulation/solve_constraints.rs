//! Solution of all unilateral constraints of a step together.

use crate::error::CoreError;
use crate::lcp::LcpStats;
use crate::pantograph::state::PantographState;
use crate::simulation::model::Model;
use crate::simulation::motion::Motion;
use crate::simulation::state::State;

impl<const DIM: usize, const D: usize> State<DIM, D> {
    /// Solves the complementarity problem of the step and complete the increments with its forces.
    ///
    /// Only links that would push enter the working set; a link that starts to push because of the
    /// solution enters then, so the solution is that of the problem with all links. A
    /// [piecewise force](crate::pantograph::piecewise_force) with the solution on its other side
    /// switches its branch, and the problem is solved again.
    ///
    /// # Errors
    /// [`CoreError::Lcp`] or [`CoreError::SlackSet`].
    pub(crate) fn solve_constraints(
        &mut self,
        model: &Model<'_, DIM, D>,
    ) -> Result<LcpStats, CoreError> {
        let Self {
            current_geometry,
            motion,
            ..
        } = self;
        motion.problem.clear_working_set();
        motion.update_working_set(&model.with_geometry(current_geometry.as_deref()));
        let mut total = LcpStats::default();
        for _ in 0..motion.max_rounds(model) {
            // With updated kinematics compliance columns are computed where they are needed.
            if let Some(current_geometry) = current_geometry {
                current_geometry.ensure_columns(&motion.contacts, &motion.problem.links);
            }
            let current = model.with_geometry(current_geometry.as_deref());
            let stats = motion.solve_working_set(&current)?;
            total.pivots += stats.pivots;
            total.fallback_used |= stats.fallback_used;
            total.residual = total.residual.max(stats.residual);
            current
                .wires
                .apply(&mut motion.wires, &mut motion.problem, &motion.contacts);
            if !motion.update_working_set(&current) {
                motion.apply_pantograph_forces();
                if !motion.switch_branch(&current) {
                    return Ok(total);
                }
            }
        }
        Err(CoreError::SlackSet {
            step: motion.steps,
            time: motion.end_time(model),
        })
    }
}

impl<const DIM: usize, const D: usize> Motion<DIM, D> {
    /// Returns the time at the end of the current step, s.
    pub(crate) fn end_time(&self, model: &Model<'_, DIM, D>) -> f64 {
        (self.steps + 1) as f64 * model.wires.h
    }

    /// Finds the forces of the current working set.
    fn solve_working_set(&mut self, model: &Model<'_, DIM, D>) -> Result<LcpStats, CoreError> {
        let tension_free = &self.wires.links.tension_free;
        let stats = self.problem.solve(
            model.wires,
            &self.contacts,
            &mut self.pantographs,
            &self.gaps,
            tension_free,
        );
        stats.map_err(|failure| CoreError::Lcp {
            step: self.steps,
            time: self.end_time(model),
            contacts: self.contacts.active().map(|c| c.indices).collect(),
            links: self.problem.links.clone(),
            stops: self
                .pantographs
                .iter()
                .map(|r| r.active_breakpoints().count())
                .collect(),
            failure,
        })
    }

    /// Adds the response of the pantographs to contact forces and breakpoints.
    fn apply_pantograph_forces(&mut self) {
        for (contact, force) in self.contacts.all.iter().zip(&self.problem.force) {
            if contact.is_active {
                self.pantographs[contact.pantograph()].apply_contact_force(*force, &contact.column);
            }
        }
        self.pantographs
            .iter_mut()
            .for_each(PantographState::apply_breakpoint_forces);
    }

    /// Adds links to the working set; returns whether there are new ones.
    fn update_working_set(&mut self, model: &Model<'_, DIM, D>) -> bool {
        let awake = model.wires.awake(&self.wires.awake);
        let links = (&self.wires.links, &model.wires.table);
        self.problem
            .update_working_set(awake.map(|island| island.links.clone()), links)
    }

    /// Returns the bound on rounds: every round adds at least one link or switches a branch, and
    /// between two links every combination of branches occurs once at most.
    fn max_rounds(&self, model: &Model<'_, DIM, D>) -> usize {
        let piecewise_force_energy = self
            .pantographs
            .iter()
            .map(|r| r.piecewise_forces.len())
            .sum::<usize>();
        let branches = 1_usize
            .checked_shl(piecewise_force_energy as u32)
            .unwrap_or(usize::MAX);
        (model.wires.line.links.len() + 1).saturating_mul(branches)
    }

    /// Switches the branch of the first piecewise force on the wrong side, and resets the
    /// increments of the pantographs.
    fn switch_branch(&mut self, model: &Model<'_, DIM, D>) -> bool {
        let c = model.wires.coefficients;
        let has_switched = self
            .pantographs
            .iter_mut()
            .any(|pantograph| pantograph.switch_branch(&c));
        if has_switched {
            self.pantographs
                .iter_mut()
                .for_each(PantographState::reset_to_prediction);
        }
        has_switched
    }
}
