//! What of a run is its own between two steps of a loop; the rest is borrowed for each step anew.

use super::contact::Unilateral;
use super::contacts::{Contact, Contacts};
use super::live::STEP;
use super::loads::Loads;
use super::path::Path;
use super::place::Place;
use super::raised::Spot;
use super::record::{Record, RecordPlan};
use super::rider::{Rider, RiderState};
use super::run::{Run, Travel};
use super::stepper::{LineState, Prepared};
use crate::error::CoreError;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// The parts of a [`Run`] that borrow nothing.
#[derive(Debug)]
pub(super) struct Parts<const DIM: usize, const D: usize> {
    pub(super) state: LineState<D>,
    pub(super) riders: Vec<RiderState>,
    pub(super) start_u: Vec<Vec<f64>>,
    pub(super) unilateral: Unilateral,
    pub(super) contacts: Contacts<DIM>,
    datum: f64,
    points: Vec<Place<DIM>>,
    spots: BTreeMap<usize, Spot<DIM>>,
    watched: Vec<Vec<usize>>,
    gaps: Vec<f64>,
    friction: Vec<f64>,
    sizes: Vec<f64>,
    pub(super) record: Record,
}

impl<const DIM: usize, const D: usize> Parts<DIM, D> {
    pub(super) fn of(run: Run<'_, DIM, D>) -> Self {
        Self {
            state: run.state,
            riders: run.riders,
            start_u: run.start_u,
            unilateral: run.unilateral,
            contacts: run.contacts,
            datum: run.datum,
            points: run.points,
            spots: run.spots,
            watched: run.watched,
            gaps: run.gaps,
            friction: run.friction,
            sizes: run.loads.into_sizes(),
            record: run.record,
        }
    }

    /// A loop keeps no extremes: there only have to be numbers, which a state can hold.
    pub(super) fn forget_extremes(&mut self) {
        self.record.link_min.fill(0.0);
        self.record.link_max.fill(0.0);
        let laws = self.riders.iter_mut().flat_map(|rider| &mut rider.laws);
        laws.for_each(|law| law.range = [0.0; 2]);
    }

    /// A step of a run may end beyond the wire, because none follows; a step of a loop may not.
    pub(super) fn check_end(&self, lanes: &[Path<DIM>], position: f64) -> Result<(), CoreError> {
        for of_strip in self.contacts.all.chunks(lanes.len()) {
            let has_wire = |c: &Contact<DIM>| {
                let lane = &lanes[c.of[2]];
                lane.locate(c.along(position), c.ends[1].element).is_some()
            };
            if !of_strip.iter().any(has_wire) {
                return Err(CoreError::OffWire {
                    rider: of_strip[0].rider(),
                    position: of_strip[0].along(position),
                    step: STEP,
                });
            }
        }
        Ok(())
    }

    /// The run, ready for a step. Moves lists, copies none.
    pub(super) fn run<'a>(
        self,
        p: &'a Prepared<DIM, D>,
        travel: &'a Travel,
        plan: &'a RecordPlan,
        described: &'a [Rider],
    ) -> Run<'a, DIM, D> {
        Run {
            p: Cow::Borrowed(p),
            travel,
            plan,
            described,
            state: self.state,
            riders: self.riders,
            start_u: self.start_u,
            unilateral: self.unilateral,
            datum: self.datum,
            contacts: self.contacts,
            points: self.points,
            spots: self.spots,
            watched: self.watched,
            gaps: self.gaps,
            friction: self.friction,
            loads: Loads::reusing(self.sizes, &travel.loads),
            record: self.record,
        }
    }
}
