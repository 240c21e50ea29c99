//! The end of a step: everything unilateral at once.

use crate::error::CoreError;
use crate::lcp::LcpStats;
use crate::pantograph::system::PantographState;
use crate::simulation::model::Model;
use crate::simulation::state::{Motion, State};

impl<const DIM: usize, const D: usize> State<DIM, D> {
    /// Solve the complementarity problem of the step and complete the increments with its forces.
    ///
    /// Only links that would push enter; a link that starts to push because of the solution
    /// enters then, so the answer is that of the problem with all links. A [law](crate::pantograph::piecewise_force) on
    /// whose other side the solution lies turns, and the problem is solved anew.
    ///
    /// # Errors
    /// [`CoreError::Lcp`] or [`CoreError::SlackSet`].
    pub(crate) fn solve_unilateral(
        &mut self,
        model: &Model<'_, DIM, D>,
    ) -> Result<LcpStats, CoreError> {
        let Self {
            present, motion, ..
        } = self;
        motion.unilateral.clear();
        motion.collect(&model.at(present.as_deref()));
        let mut total = LcpStats::default();
        for _ in 0..motion.most_rounds(model) {
            // With updated kinematics influence columns are computed where they are needed.
            if let Some(present) = present {
                present.provide(&motion.contacts, &motion.unilateral.links);
            }
            let at = model.at(present.as_deref());
            let stats = motion.solve_round(&at)?;
            total.pivots += stats.pivots;
            total.fallback_used |= stats.fallback_used;
            total.residual = total.residual.max(stats.residual);
            at.line
                .apply(&mut motion.line, &mut motion.unilateral, &motion.contacts);
            if !motion.collect(&at) {
                motion.push_riders();
                if !motion.turn(&at) {
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
    /// Time at the end of the present step, s.
    pub(crate) fn end_time(&self, model: &Model<'_, DIM, D>) -> f64 {
        (self.steps + 1) as f64 * model.line.h
    }

    /// Forces for the links and kinks that have entered so far.
    fn solve_round(&mut self, model: &Model<'_, DIM, D>) -> Result<LcpStats, CoreError> {
        let tension_free = &self.line.links.tension_free;
        let stats = self.unilateral.solve(
            model.line,
            &self.contacts,
            &mut self.riders,
            &self.gaps,
            tension_free,
        );
        stats.map_err(|failure| CoreError::Lcp {
            step: self.steps,
            time: self.end_time(model),
            contacts: self.contacts.active().map(|c| c.of).collect(),
            links: self.unilateral.links.clone(),
            stops: self.riders.iter().map(|r| r.entered().count()).collect(),
            failure,
        })
    }

    /// Add the response of the riders to contact forces and kinks.
    fn push_riders(&mut self) {
        for (contact, force) in self.contacts.all.iter().zip(&self.unilateral.force) {
            if contact.meets {
                self.riders[contact.rider()].add_contact(*force, &contact.column);
            }
        }
        self.riders.iter_mut().for_each(PantographState::add_kinks);
    }

    /// Let links enter that have to; tells whether there are new ones.
    fn collect(&mut self, model: &Model<'_, DIM, D>) -> bool {
        let awake = model.line.awake(&self.line.awake);
        let links = (&self.line.links, &model.line.table);
        self.unilateral
            .collect(awake.map(|island| island.links.clone()), links)
    }

    /// Every round adds at least one link or turns a law; between two links the laws take every
    /// arrangement of their sides once at most.
    fn most_rounds(&self, model: &Model<'_, DIM, D>) -> usize {
        let laws = self.riders.iter().map(|r| r.laws.len()).sum::<usize>();
        let sides = 1_usize.checked_shl(laws as u32).unwrap_or(usize::MAX);
        (model.line.line.links.len() + 1).saturating_mul(sides)
    }

    /// Let the first law on the wrong side turn, and take the increments of the riders back.
    fn turn(&mut self, model: &Model<'_, DIM, D>) -> bool {
        let c = model.line.coefficients;
        let turned = self.riders.iter_mut().any(|rider| rider.turn(&c));
        if turned {
            self.riders.iter_mut().for_each(PantographState::take_back);
        }
        turned
    }
}
