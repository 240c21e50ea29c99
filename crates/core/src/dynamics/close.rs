//! The end of a step: everything unilateral at once.

use super::rider::RiderState;
use super::run::Run;
use crate::error::CoreError;
use crate::lcp::LcpStats;

impl<const DIM: usize, const D: usize> Run<'_, DIM, D> {
    /// Solve the complementarity problem of the step and complete the increments with its forces.
    ///
    /// Only links that would push enter; a link that starts to push because of the solution
    /// enters then, so the answer is that of the problem with all links. A [law](super::law) on
    /// whose other side the solution lies turns, and the problem is solved anew.
    ///
    /// # Errors
    /// [`CoreError::Lcp`] or [`CoreError::SlackSet`].
    pub(super) fn close(&mut self, step: usize) -> Result<LcpStats, CoreError> {
        let time = (step + 1) as f64 * self.p.h;
        self.unilateral.clear();
        self.collect();
        let mut total = LcpStats::default();
        for _ in 0..self.most_rounds() {
            self.provide_columns();
            let tension_free = &self.state.links.tension_free;
            let stats = self.unilateral.solve(
                &self.p,
                &self.contacts,
                &mut self.riders,
                &self.gaps,
                tension_free,
            );
            let stats = stats.map_err(|failure| CoreError::Lcp {
                step,
                time,
                contacts: self.contacts.active().map(|c| c.of).collect(),
                links: self.unilateral.links.clone(),
                stops: self.riders.iter().map(|r| r.entered().count()).collect(),
                failure,
            })?;
            total.pivots += stats.pivots;
            total.fallback_used |= stats.fallback_used;
            total.residual = total.residual.max(stats.residual);
            self.p
                .respond(&mut self.state, &mut self.unilateral, &self.contacts);
            if !self.collect() {
                for (contact, force) in self.contacts.all.iter().zip(&self.unilateral.force) {
                    if contact.meets {
                        self.riders[contact.rider()].add_contact(*force, &contact.column);
                    }
                }
                self.riders.iter_mut().for_each(RiderState::add_kinks);
                if !self.turn() {
                    return Ok(total);
                }
            }
        }
        Err(CoreError::SlackSet { step, time })
    }

    /// Let links enter that have to; tells whether there are new ones.
    fn collect(&mut self) -> bool {
        let awake = self.p.awake(&self.state.awake);
        let links = (&self.state.links, &self.p.table);
        self.unilateral
            .collect(awake.map(|island| island.links.clone()), links)
    }

    /// Every round adds at least one link or turns a law; between two links the laws take every
    /// arrangement of their sides once at most.
    fn most_rounds(&self) -> usize {
        let laws = self.riders.iter().map(|r| r.laws.len()).sum::<usize>();
        let sides = 1_usize.checked_shl(laws as u32).unwrap_or(usize::MAX);
        (self.p.line.links.len() + 1).saturating_mul(sides)
    }

    /// Let the first law on the wrong side turn, and take the increments of the riders back.
    fn turn(&mut self) -> bool {
        let c = self.p.coefficients;
        let turned = self.riders.iter_mut().any(|rider| rider.turn(&c));
        if turned {
            self.riders.iter_mut().for_each(RiderState::take_back);
        }
        turned
    }

    /// With updated kinematics, influence columns are computed where they are needed.
    fn provide_columns(&mut self) {
        if self.p.updating.is_some() {
            let links = &self.unilateral.links;
            self.p.to_mut().provide(&self.contacts, links);
        }
    }
}
