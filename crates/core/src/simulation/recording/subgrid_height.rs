//! Height of the real wire above that of the mesh during a run: see
//! [local compliance](crate::slideline::local_compliance).

use crate::constraint::contacts::Contact;
use crate::simulation::model::Model;
use crate::simulation::motion::Motion;
use crate::simulation::recording::record::RecordPlan;
use crate::slideline::Slideline;
use crate::slideline::local_compliance::LocalCompliance;
use crate::slideline::point::SlidelinePoint;
use std::collections::{BTreeMap, BTreeSet};

/// A place whose motion is watched.
#[derive(Debug, Clone)]
pub(crate) struct Probe<const DIM: usize> {
    lane: usize,
    place: SlidelinePoint<DIM>,
    yields: LocalCompliance,
}

impl<const DIM: usize> Probe<DIM> {
    /// A place on one of the slidelines; `None` where it yields as the mesh does.
    fn new(lanes: &[Slideline<DIM>], place: &SlidelinePoint<DIM>) -> Option<Self> {
        let lane = lanes.iter().position(|lane| lane.contains(place))?;
        let is_rigid = lanes[lane].is_rigid();
        (!is_rigid).then(|| Self {
            lane,
            place: *place,
            yields: lanes[lane].compliance_at(place),
        })
    }
}

/// Returns probes of the watched nodes of a plan that lie on slidelines; none without residual
/// flexibility.
pub(crate) fn spots<const DIM: usize>(
    lanes: &[Slideline<DIM>],
    plan: &RecordPlan,
) -> BTreeMap<usize, Probe<DIM>> {
    if lanes.iter().all(Slideline::is_rigid) {
        return BTreeMap::new();
    }
    let near = plan.near.iter().flat_map(|near| &near.nodes.of);
    let watched: BTreeSet<usize> = plan.nodes.iter().chain(near).copied().collect();
    let ends = lanes.iter().flat_map(Slideline::node_points);
    let ends = ends.filter(|(node, _)| watched.contains(node));
    ends.filter_map(|(node, place)| Some((node, Probe::new(lanes, &place)?)))
        .collect()
}

impl<const DIM: usize, const D: usize> Motion<DIM, D> {
    /// Σ R_d (k e − r₀) at a place, m, with a share of the present increment.
    pub(crate) fn raised_by_links(
        &self,
        model: &Model<'_, DIM, D>,
        yields: &LocalCompliance,
        share: f64,
    ) -> f64 {
        let (motion, line) = (&self.wires.links, model.wires);
        let by_link = |(link, rise): (usize, f64)| {
            let elongation = motion.elongation[link] + share * motion.delta[link];
            let slack = line.line.links[link].rest_correction();
            line.tension_relief(link, rise) * elongation - rise * slack
        };
        yields.links().map(by_link).sum()
    }

    /// Height above the mesh from links, corrections and contact forces, m; `residual` is R̃ from a
    /// contact.
    fn raised(
        &self,
        model: &Model<'_, DIM, D>,
        (yields, share): (&LocalCompliance, f64),
        residual: impl Fn(&Contact<DIM>) -> f64,
    ) -> f64 {
        let corrections = &self.problem.correction;
        let corrected = yields.links().map(|(link, rise)| rise * corrections[link]);
        let pressed = self.contacts.active.iter().map(|&j| {
            let force = self.problem.force[j];
            force * residual(&self.contacts.all[j])
        });
        self.raised_by_links(model, yields, share) + corrected.sum::<f64>() + pressed.sum::<f64>()
    }

    /// Height of the wire at a contact above the mesh, m.
    pub(crate) fn raised_at(
        &self,
        model: &Model<'_, DIM, D>,
        contact: &Contact<DIM>,
        share: f64,
    ) -> f64 {
        let line = model.wires;
        if line.slidelines[contact.indices[2]].is_rigid() {
            return 0.0;
        }
        let residual = |other: &Contact<DIM>| line.residual_compliance(contact, other);
        contact.compliance.static_height
            + self.raised(model, (&contact.compliance, share), residual)
    }

    /// Rise of a watched place beyond the mesh since the line was at rest, m.
    pub(crate) fn raised_since(&self, model: &Model<'_, DIM, D>, spot: &Probe<DIM>) -> f64 {
        let line = model.wires;
        let residual = |other: &Contact<DIM>| {
            let carried = line.flexibility_through_links(&spot.yields, &other.compliance);
            if other.indices[2] == spot.lane {
                line.slidelines[spot.lane].residual_flexibility(&spot.place, &other.point) - carried
            } else {
                -carried
            }
        };
        let share = line.coefficients.stiffness;
        self.raised(model, (&spot.yields, share), residual)
    }

    /// Rise of a place beyond the mesh since the line was at rest, m.
    pub(crate) fn place_raised(
        &self,
        model: &Model<'_, DIM, D>,
        place: &SlidelinePoint<DIM>,
    ) -> f64 {
        let spot = Probe::new(&model.wires.slidelines, place);
        spot.map_or(0.0, |spot| self.raised_since(model, &spot))
    }
}
