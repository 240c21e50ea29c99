//! The start of a run.

use super::contact::Unilateral;
use super::contacts::Contacts;
use super::loads::Loads;
use super::path::Path;
use super::place::Place;
use super::raised::spots;
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
        let stand = |(j, rider): (usize, &Rider)| {
            let Rest { u, preload, .. } = start.stand(j, &line)?;
            RiderState::standing(rider.clone(), &p.coefficients, (u, preload))
        };
        let states = riders.iter().enumerate().map(stand);
        let states = states.collect::<Result<Vec<_>, _>>()?;
        let mut unilateral = Unilateral::new(start.contacts.all.len(), line.correction);
        for (&i, force) in start.contacts.active.iter().zip(start.forces) {
            unilateral.force[i] = force;
        }
        let model = match p.updating {
            None => Cow::Borrowed(p),
            Some(_) => Cow::Owned(p.on(start.lanes)),
        };
        let mut run = Self {
            state: p.at_rest(line.u),
            unilateral,
            datum: start.datum,
            points,
            ..Self::assemble(model, riders, travel, plan, states, start.contacts)
        };
        run.watch_nodes_of_plan();
        run.let_sleep();
        Ok(run)
    }

    /// A run into which a state is to be put back.
    pub(super) fn blank(
        p: &'a Prepared<DIM, D>,
        riders: &'a [Rider],
        travel: &'a Travel,
        plan: &'a RecordPlan,
    ) -> Result<Self, CoreError> {
        riders.iter().try_for_each(Rider::check)?;
        let stand = |rider: &Rider| {
            let nowhere = (vec![0.0; rider.size()], 0.0);
            RiderState::standing(rider.clone(), &p.coefficients, nowhere)
        };
        let states = riders.iter().map(stand).collect::<Result<Vec<_>, _>>()?;
        let contacts = Contacts::blank(riders, &travel.distances, p.lanes.len());
        // With updated kinematics the first step forms everything that moves anew.
        let model = match p.updating {
            None => Cow::Borrowed(p),
            Some(_) => Cow::Owned(p.clone()),
        };
        let mut run = Self {
            points: points(&p.lanes, &plan.points)?,
            ..Self::assemble(model, riders, travel, plan, states, contacts)
        };
        run.watch_nodes_of_plan();
        Ok(run)
    }

    /// Tell an explicit line what is read in every step.
    fn watch_nodes_of_plan(&mut self) {
        if let (Some(steps), Some(grid)) = (self.p.explicit_steps(), &mut self.state.grid) {
            let near = self.plan.near.iter().flat_map(|near| &near.nodes.of);
            let points = self.points.iter().flat_map(|place| &place.nodes);
            let nodes = self.plan.nodes.iter().chain(near).chain(points);
            steps.watch(grid, nodes.copied());
        }
    }

    /// A run of these riders with the line undisturbed, no force anywhere and no point watched.
    fn assemble(
        p: Cow<'a, Prepared<DIM, D>>,
        described: &'a [Rider],
        travel: &'a Travel,
        plan: &'a RecordPlan,
        riders: Vec<RiderState>,
        mut contacts: Contacts<DIM>,
    ) -> Self {
        contacts.respond(&riders);
        let mut watched = vec![Vec::new(); p.islands.len()];
        for (k, &node) in plan.nodes.iter().enumerate() {
            watched[p.island_of(node)].push(k);
        }
        let (count, links) = (contacts.all.len(), p.line.links.len());
        Self {
            state: p.at_rest(vec![[0.0; D]; p.line.nodes()]),
            start_u: riders.iter().map(|r| r.u.clone()).collect(),
            unilateral: Unilateral::new(count, vec![0.0; links]),
            datum: 0.0,
            points: Vec::new(),
            spots: spots(&p.lanes, plan),
            watched,
            gaps: vec![0.0; count],
            friction: vec![0.0; count],
            loads: Loads::new(&travel.loads),
            record: Record::empty(&contacts, links, plan, riders.len()),
            p,
            travel,
            plan,
            described,
            riders,
            contacts,
        }
    }
}
