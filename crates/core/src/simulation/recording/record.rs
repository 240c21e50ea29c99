//! What a run leaves behind: flat arrays, one row per recorded instant.
//!
//! All values of an instant belong to the time of balance tₙ₊₁₋α_f of the step, except energies,
//! which belong to the end of the step.

use crate::constraint::contacts::Contacts;
use crate::error::CoreError;
use crate::integrator::energy::implicit::EnergyTerms;
use crate::simulation::recording::window::Near;
use std::mem::{replace, take};

/// What to record and how often.
#[derive(Debug, Clone)]
pub struct RecordPlan {
    /// Every how many steps contacts are recorded.
    pub contact_every: usize,
    /// Every how many steps the line is recorded.
    pub line_every: usize,
    /// Record the force of every link.
    pub links: bool,
    /// Nodes whose uplift is recorded and watched (supports).
    pub nodes: Vec<usize>,
    /// Coordinates along the track at which the uplift of the contact wire is recorded, m.
    pub points: Vec<f64>,
    /// Keep the energy ledger.
    pub ledger: bool,
    /// Every how many steps explicit ones measure what wires dissipate: see [`balance`](crate::integrator::energy::explicit).
    pub ledger_every: usize,
    /// Record links and nodes near the riders only; `None` for all of them.
    pub near: Option<Near>,
}

/// Time series and extremes of a run; rows are instants.
#[derive(Debug, Clone, Default)]
pub struct Record {
    /// Times of the contact rows, s.
    pub time: Vec<f64>,
    /// Contacts: rider, strip and lane of each.
    pub contacts: Vec<[usize; 3]>,
    /// Contact force, N: one column per contact; so the next three.
    pub force: Vec<f64>,
    /// Gap, m; infinite where a contact has no wire in reach.
    pub gap: Vec<f64>,
    /// Height of the wire at the contact, m; NaN where the lane has none.
    pub height: Vec<f64>,
    /// Lateral position of the wire at the contact, m; zero when planar, NaN where the lane has none.
    pub lateral: Vec<f64>,
    /// Position along the track, m: one column per rider.
    pub position: Vec<f64>,
    /// Speed, m/s: one value per row.
    pub speed: Vec<f64>,
    /// Force of the actuator of each rider, N; zero without.
    pub control: Vec<f64>,
    /// Displacement of all masses of all riders since the start, m.
    pub masses: Vec<f64>,
    /// Times of the line rows, s.
    pub line_time: Vec<f64>,
    /// Tension of each link, or of those near the riders, N.
    pub link_force: Vec<f64>,
    /// Uplift of the watched nodes, or of those near the riders, m.
    pub uplift: Vec<f64>,
    /// Where near ones alone are recorded: place in their order of the first link of each row.
    pub link_first: Vec<f64>,
    /// The same of the nodes.
    pub uplift_first: Vec<f64>,
    /// Uplift of the watched points, m.
    pub point_uplift: Vec<f64>,
    /// Displacement of the watched points along the track, m.
    pub point_along: Vec<f64>,
    /// Number of slack links.
    pub slack: Vec<f64>,
    /// Energy entries.
    pub energy: Vec<EnergyTerms>,
    /// Smallest tension of each link over all steps, N.
    pub link_min: Vec<f64>,
    /// Largest tension of each link over all steps, N.
    pub link_max: Vec<f64>,
    /// Largest uplift of each watched node over all steps, m.
    pub uplift_max: Vec<f64>,
    /// Largest force of any stop of each rider over all steps, N.
    pub stop_max: Vec<f64>,
    /// Smallest and largest motion of each law of each rider over all steps, m or m/s.
    pub law_ranges: Vec<f64>,
    /// Largest number of slack links in any step.
    pub slack_max: usize,
    /// Exchanges of the complementarity solver, all steps.
    pub pivots: usize,
    /// Number of steps that took 0, 1, 2, … exchanges.
    pub pivot_counts: Vec<usize>,
    /// Largest number of exchanges in one step.
    pub pivots_max: usize,
    /// Steps in which the finite fallback rule was needed.
    pub fallbacks: usize,
    /// Largest residual of a complementarity problem.
    pub lcp_residual: f64,
    /// Steps done.
    pub steps: usize,
    /// Largest residual of the energy ledger where it was settled (line rows and the end), J.
    pub energy_residual: f64,
    /// Largest energy turned over, J: the scale of the residual.
    pub energy_turnover: f64,
    /// Largest energy that switching has taken or given, J.
    pub energy_switching: f64,
}

impl Record {
    /// Nothing recorded yet.
    pub(crate) fn empty<const DIM: usize>(
        contacts: &Contacts<DIM>,
        links: usize,
        plan: &RecordPlan,
        riders: usize,
    ) -> Self {
        Self {
            contacts: contacts.all.iter().map(|c| c.of).collect(),
            link_min: vec![f64::INFINITY; links],
            link_max: vec![f64::NEG_INFINITY; links],
            uplift_max: vec![f64::NEG_INFINITY; plan.nodes.len()],
            stop_max: vec![0.0; riders],
            ..Self::default()
        }
    }

    /// Take the series away, so that those of later instants begin anew. Extremes and counts stay, and
    /// the piece has them as they are so far.
    pub(crate) fn take_series(&mut self) -> Self {
        let energy = take(&mut self.energy);
        let taken = self.series_mut().map(|own| {
            let as_many = Vec::with_capacity(own.len());
            replace(own, as_many)
        });
        let mut piece = Self {
            energy,
            ..self.clone()
        };
        for (own, series) in piece.series_mut().into_iter().zip(taken) {
            *own = series;
        }
        piece
    }

    /// Numbers in the series.
    pub(crate) fn held(&mut self) -> usize {
        let numbers: usize = self.series_mut().iter().map(|s| s.len()).sum();
        numbers + self.energy.len() * (size_of::<EnergyTerms>() / size_of::<f64>())
    }

    /// All series of numbers; the energies are entries.
    fn series_mut(&mut self) -> [&mut Vec<f64>; 17] {
        [
            &mut self.time,
            &mut self.force,
            &mut self.gap,
            &mut self.height,
            &mut self.lateral,
            &mut self.position,
            &mut self.speed,
            &mut self.control,
            &mut self.masses,
            &mut self.line_time,
            &mut self.link_force,
            &mut self.uplift,
            &mut self.link_first,
            &mut self.uplift_first,
            &mut self.point_uplift,
            &mut self.point_along,
            &mut self.slack,
        ]
    }

    /// Whether the ledger, where one is kept, holds numbers: squares grow faster than motion.
    pub(crate) fn check_energy(&self, step: usize) -> Result<(), CoreError> {
        let mut known = self.energy.iter().filter(|e| !e.is_unknown());
        if known.all(|e| e.residual().is_finite()) {
            return Ok(());
        }
        let what = "the energy ledger";
        Err(CoreError::NotFinite { what, step })
    }
}
