//! Height of the real wire above that of the mesh during a run: see [`yields`](crate::slideline::residual_flexibility).

use crate::constraint::contacts::Contact;
use crate::simulation::model::Model;
use crate::simulation::recording::record::RecordPlan;
use crate::simulation::state::Motion;
use crate::slideline::Slideline;
use crate::slideline::point::SlidelinePoint;
use crate::slideline::residual_flexibility::LocalCompliance;
use std::collections::{BTreeMap, BTreeSet};

/// A place whose motion is watched.
#[derive(Debug, Clone)]
pub(crate) struct Probe<const DIM: usize> {
    lane: usize,
    place: SlidelinePoint<DIM>,
    yields: LocalCompliance,
}

impl<const DIM: usize> Probe<DIM> {
    /// A place on one of the lanes; `None` where it yields as the mesh does.
    fn new(lanes: &[Slideline<DIM>], place: &SlidelinePoint<DIM>) -> Option<Self> {
        let lane = lanes.iter().position(|lane| lane.holds(place))?;
        let is_rigid = lanes[lane].is_rigid();
        (!is_rigid).then(|| Self {
            lane,
            place: *place,
            yields: lanes[lane].yield_at(place),
        })
    }
}

/// Those of the watched nodes of a plan that lie on lanes; none without residual flexibility.
pub(crate) fn spots<const DIM: usize>(
    lanes: &[Slideline<DIM>],
    plan: &RecordPlan,
) -> BTreeMap<usize, Probe<DIM>> {
    if lanes.iter().all(Slideline::is_rigid) {
        return BTreeMap::new();
    }
    let near = plan.near.iter().flat_map(|near| &near.nodes.of);
    let watched: BTreeSet<usize> = plan.nodes.iter().chain(near).copied().collect();
    let ends = lanes.iter().flat_map(Slideline::ends);
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
        let (motion, line) = (&self.line.links, model.line);
        let by_link = |(link, rise): (usize, f64)| {
            let elongation = motion.elongation[link] + share * motion.delta[link];
            let slack = line.line.links[link].rest_correction();
            line.eased(link, rise) * elongation - rise * slack
        };
        yields.pulls().map(by_link).sum()
    }

    /// Height above the mesh from links, corrections and contact forces, m; `residual` is R̃ from a
    /// contact.
    fn raised(
        &self,
        model: &Model<'_, DIM, D>,
        (yields, share): (&LocalCompliance, f64),
        residual: impl Fn(&Contact<DIM>) -> f64,
    ) -> f64 {
        let corrections = &self.unilateral.correction;
        let corrected = yields.pulls().map(|(link, rise)| rise * corrections[link]);
        let pressed = self.contacts.active.iter().map(|&j| {
            let force = self.unilateral.force[j];
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
        let line = model.line;
        if line.lanes[contact.of[2]].is_rigid() {
            return 0.0;
        }
        let residual = |other: &Contact<DIM>| line.residual(contact, other);
        contact.yields.rise + self.raised(model, (&contact.yields, share), residual)
    }

    /// Rise of a watched place beyond the mesh since the line was at rest, m.
    pub(crate) fn raised_since(&self, model: &Model<'_, DIM, D>, spot: &Probe<DIM>) -> f64 {
        let line = model.line;
        let residual = |other: &Contact<DIM>| {
            let carried = line.carried(&spot.yields, &other.yields);
            if other.of[2] == spot.lane {
                line.lanes[spot.lane].between(&spot.place, &other.place) - carried
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
        let spot = Probe::new(&model.line.lanes, place);
        spot.map_or(0.0, |spot| self.raised_since(model, &spot))
    }
}
