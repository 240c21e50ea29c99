//! Record of a run: flat arrays, one row per recorded instant.
//!
//! All values of an instant belong to the time of balance tₙ₊₁₋α_f of the step, except energies,
//! which belong to the end of the step.

use crate::constraint::contacts::Contacts;
use crate::energy_terms::EnergyTerms;
use crate::error::CoreError;
use crate::simulation::recording::support_parts::SupportParts;
use crate::simulation::recording::window::{MotionPlan, Near};
use std::mem::{replace, take};

/// Selection of recorded quantities and their intervals.
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
    /// Parts whose forces are recorded, in the order of `nodes`, or of those in `near` where it is
    /// given; empty for none.
    pub supports: Vec<SupportParts>,
    /// Coordinates along the track at which the uplift of the contact wire is recorded, m.
    pub points: Vec<f64>,
    /// Keep the energy balance.
    pub ledger: bool,
    /// Every how many steps explicit ones measure what wires dissipate: see
    /// [`balance`](crate::integrator::energy::explicit).
    pub ledger_every: usize,
    /// Record links and nodes near the pantographs only; `None` for all of them.
    pub near: Option<Near>,
    /// Record the motion of wires near the pantographs; `None` for none of it.
    pub motion: Option<MotionPlan>,
}

impl RecordPlan {
    /// Checks the parts at supports against the numbers of watched nodes, springs and struts.
    ///
    /// # Errors
    /// [`CoreError::Input`].
    pub(crate) fn check_supports(&self, springs: usize, struts: usize) -> Result<(), CoreError> {
        let watched = self
            .near
            .as_ref()
            .map_or(&self.nodes, |near| &near.nodes.of);
        let count = self.supports.len();
        let is_sound = count == 0 || count == watched.len();
        if is_sound
            && self
                .supports
                .iter()
                .all(|parts| parts.fits(springs, struts))
        {
            return Ok(());
        }
        Err(CoreError::Input {
            array: "plan",
            reason: "parts at supports are not there, or not one for each watched node".into(),
        })
    }
}

/// Defines a record by the one table of its channels: its fields, and all that goes through them.
macro_rules! channels {
    (
        series { $($(#[$of_series:meta])+ $series:ident,)+ }
        extremes { $($(#[$of_extreme:meta])+ $extreme:ident,)+ }
        counts { $($(#[$of_count:meta])+ $count:ident,)+ }
        largest { $($(#[$of_largest:meta])+ $largest:ident,)+ }
    ) => {
        /// Time series and extremes of a run; rows are instants.
        #[derive(Debug, Clone, Default)]
        pub struct Record {
            /// Contacts: pantograph, strip and slideline of each.
            pub contacts: Vec<[usize; 3]>,
            /// Energies of each line row.
            pub energy: Vec<EnergyTerms>,
            /// Number of steps that took 0, 1, 2, … exchanges.
            pub pivot_counts: Vec<usize>,
            /// Motion of the wires, row by row: see [`MotionPlan`].
            pub motion: Vec<f32>,
            $($(#[$of_series])+ pub $series: Vec<f64>,)+
            $($(#[$of_extreme])+ pub $extreme: Vec<f64>,)+
            $($(#[$of_count])+ pub $count: usize,)+
            $($(#[$of_largest])+ pub $largest: f64,)+
        }

        impl Record {
            /// Names of the series, which grow with the run.
            pub const SERIES: &[&str] = &[$(stringify!($series)),+];

            /// All series of numbers; the energies are entries.
            pub(super) fn series_mut(&mut self) -> [&mut Vec<f64>; Record::SERIES.len()] {
                [$(&mut self.$series),+]
            }

            /// Counts so far, by their names.
            #[must_use]
            pub fn counts(&self) -> Vec<(&'static str, usize)> {
                vec![$((stringify!($count), self.$count)),+]
            }

            /// Largest numbers so far, by their names.
            #[must_use]
            pub fn largest(&self) -> Vec<(&'static str, f64)> {
                vec![$((stringify!($largest), self.$largest)),+]
            }

            /// Series and extremes, by their names.
            #[must_use]
            pub fn into_arrays(self) -> Vec<(&'static str, Vec<f64>)> {
                vec![
                    $((stringify!($series), self.$series),)+
                    $((stringify!($extreme), self.$extreme),)+
                ]
            }
        }
    };
}

channels! {
    series {
        /// Times of the contact rows, s.
        time,
        /// Contact force, N: one column per contact.
        force,
        /// Gap, m: one column per contact; infinite where it has no wire in reach.
        gap,
        /// Height of the wire, m: one column per contact; NaN where the slideline has none.
        height,
        /// Lateral position of the wire, m: one column per contact; zero when planar, NaN where the
        /// slideline has none.
        lateral,
        /// Position along the track, m: one column per pantograph.
        position,
        /// Speed, m/s: one value per contact row.
        speed,
        /// Force of the actuator of each pantograph, N; zero without.
        control,
        /// Displacement of all masses of all pantographs since the start, m.
        masses,
        /// Times of the line rows, s.
        line_time,
        /// Tension of each link, or of those near the pantographs, N.
        link_force,
        /// Uplift of the watched nodes, or of those near the pantographs, m.
        uplift,
        /// Vertical force on the support of each watched node, or of those near the pantographs,
        /// N: positive downwards.
        support_force,
        /// Lateral force of the wires on the same supports, N: positive to the left.
        support_lateral,
        /// Uplift of what the same supports hold, m.
        held_uplift,
        /// Tension of the steady arms at the same supports, N.
        arm_force,
        /// Angle of the same arms to the horizontal plane, rad.
        arm_angle,
        /// Place in the order of links of the first one of each row, where near ones alone are
        /// recorded.
        link_first,
        /// Place in the order of watched nodes of the first one of each row, where near ones alone
        /// are recorded.
        uplift_first,
        /// Uplift of the watched points, m.
        point_uplift,
        /// Displacement of the watched points along the track, m.
        point_along,
        /// Number of slack links.
        slack,
        /// Times of the rows of motion, s.
        motion_time,
        /// Place in the order of its nodes of the first one of each wire in a row of motion, then
        /// that of the links.
        motion_first,
    }
    extremes {
        /// Smallest tension of each link over all steps, N.
        link_min,
        /// Largest tension of each link over all steps, N.
        link_max,
        /// Largest uplift of each watched node over all steps, m.
        uplift_max,
        /// Largest force of any stop of each pantograph over all steps, N.
        stop_max,
        /// Smallest and largest motion of each piecewise force of each pantograph, m or m/s.
        law_ranges,
    }
    counts {
        /// Steps done.
        steps,
        /// Largest number of slack links in any step.
        slack_max,
        /// Exchanges of the complementarity solver, all steps.
        pivots,
        /// Largest number of exchanges in one step.
        pivots_max,
        /// Steps in which the finite fallback rule was needed.
        fallbacks,
    }
    largest {
        /// Residual of a complementarity problem.
        lcp_residual,
        /// Residual of the energy balance where it was settled (line rows and the end), J.
        energy_residual,
        /// Energy turned over, J: the scale of the residual.
        energy_turnover,
        /// Energy that switching has taken or given, J.
        energy_switching,
    }
}

impl Record {
    /// Nothing recorded yet.
    pub(crate) fn empty<const DIM: usize>(
        contacts: &Contacts<DIM>,
        links: usize,
        plan: &RecordPlan,
        pantographs: usize,
    ) -> Self {
        Self {
            contacts: contacts.all.iter().map(|c| c.indices).collect(),
            link_min: vec![f64::INFINITY; links],
            link_max: vec![f64::NEG_INFINITY; links],
            uplift_max: vec![f64::NEG_INFINITY; plan.nodes.len()],
            stop_max: vec![0.0; pantographs],
            ..Self::default()
        }
    }

    /// Takes the series recorded so far, and leaves empty ones for later instants. Extremes and
    /// counts stay, and the piece has a copy of them.
    pub(crate) fn take_series(&mut self) -> Self {
        let (energy, motion) = (take(&mut self.energy), take(&mut self.motion));
        let taken = self.series_mut().map(|own| {
            let as_many = Vec::with_capacity(own.len());
            replace(own, as_many)
        });
        let mut piece = Self {
            energy,
            motion,
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
        let energies = self.energy.len() * (size_of::<EnergyTerms>() / size_of::<f64>());
        numbers + energies + self.motion.len() * size_of::<f32>() / size_of::<f64>()
    }

    /// Checks that the energy balance, if kept, is finite: squares grow faster than motion.
    pub(crate) fn check_energy(&self, step: usize) -> Result<(), CoreError> {
        let mut known = self.energy.iter().filter(|e| !e.is_unknown());
        if known.all(|e| e.residual().is_finite()) {
            return Ok(());
        }
        let what = "the energy balance";
        Err(CoreError::NotFinite { what, step })
    }
}
