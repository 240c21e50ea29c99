//! The start of a run.

use super::contact::Unilateral;
use super::loads::Loads;
use super::path::Path;
use super::place::Place;
use super::record::{Record, RecordPlan};
use super::rest::Rest;
use super::rider::{Rider, RiderState};
use super::run::{Run, Travel};
use super::standing::Start;
use super::stepper::Prepared;
use crate::error::CoreError;
use std::borrow::Cow;

/// Places of the given points: on the lowest wire where there are several.
pub(super) fn points<const DIM: usize>(
    lanes: &[Path<DIM>],
    x: &[f64],
) -> Result<Vec<Place<DIM>>, CoreError> {
    let locate = |&x: &f64| {
        let found = lanes.iter().filter_map(|lane| lane.locate(x, 0));
        let lowest = found.min_by(|a, b| a.height.total_cmp(&b.height));
        lowest.ok_or_else(|| CoreError::Input {
            array: "points",
            reason: format!("no wire at {x} m"),
        })
    };
    x.iter().map(locate).collect()
}

impl<'a, const DIM: usize, const D: usize> Run<'a, DIM, D> {
    /// Static equilibrium with the riders in place.
    pub(super) fn start(
        p: &'a Prepared<DIM, D>,
        riders: &'a [Rider],
        travel: &'a Travel,
        plan: &'a RecordPlan,
    ) -> Result<Self, CoreError> {
        riders.iter().try_for_each(Rider::check)?;
        let points = points(&p.lanes, &plan.points)?;
        let mut start = Start::new(p, riders, travel)?;
        let line = start.settle()?;
        let state = |(j, rider): (usize, &Rider)| {
            let Rest { u, preload, .. } = start.stand(j, &line)?;
            RiderState::standing(rider.clone(), &p.coefficients, (u, preload))
        };
        let states = riders.iter().enumerate().map(state);
        let states = states.collect::<Result<Vec<_>, _>>()?;
        let Start {
            mut contacts,
            forces,
            lanes,
            datum,
            ..
        } = start;
        contacts.respond(&states);
        let mut unilateral = Unilateral::new(contacts.all.len(), line.correction);
        for (&i, force) in contacts.active.iter().zip(forces) {
            unilateral.force[i] = force;
        }
        Ok(Self {
            start_u: states.iter().map(|r| r.u.clone()).collect(),
            described: riders,
            riders: states,
            unilateral,
            state: p.at_rest(line.u),
            gaps: vec![0.0; contacts.all.len()],
            friction: vec![0.0; contacts.all.len()],
            loads: Loads::new(&travel.loads),
            record: Record::empty(&contacts, p.line.links.len(), plan, riders.len()),
            p: match p.updating {
                None => Cow::Borrowed(p),
                Some(_) => Cow::Owned(p.on(lanes)),
            },
            contacts,
            datum,
            points,
            travel,
            plan,
        })
    }
}
