//! Height of the real wire above that of the mesh during a run: see [`yields`](super::yields).

use super::contacts::Contact;
use super::path::Path;
use super::place::Place;
use super::record::RecordPlan;
use super::run::Run;
use super::stepper::Prepared;
use super::yields::Yield;
use std::collections::{BTreeMap, BTreeSet};

/// A place whose motion is watched.
#[derive(Debug, Clone)]
pub(super) struct Spot<const DIM: usize> {
    lane: usize,
    place: Place<DIM>,
    yields: Yield,
}

impl<const DIM: usize> Spot<DIM> {
    /// A place on one of the lanes; `None` where it yields as the mesh does.
    fn new(lanes: &[Path<DIM>], place: &Place<DIM>) -> Option<Self> {
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
pub(super) fn spots<const DIM: usize>(
    lanes: &[Path<DIM>],
    plan: &RecordPlan,
) -> BTreeMap<usize, Spot<DIM>> {
    if lanes.iter().all(Path::is_rigid) {
        return BTreeMap::new();
    }
    let near = plan.near.iter().flat_map(|near| &near.nodes.of);
    let watched: BTreeSet<usize> = plan.nodes.iter().chain(near).copied().collect();
    let ends = lanes.iter().flat_map(Path::ends);
    let ends = ends.filter(|(node, _)| watched.contains(node));
    ends.filter_map(|(node, place)| Some((node, Spot::new(lanes, &place)?)))
        .collect()
}

impl<const DIM: usize, const D: usize> Run<'_, DIM, D> {
    /// Σ R_d (k e − r₀) at a place, m, with a share of the present increment.
    pub(super) fn raised_by_links(&self, yields: &Yield, share: f64) -> f64 {
        let motion = &self.state.links;
        let by_link = |(link, rise): (usize, f64)| {
            let elongation = motion.elongation[link] + share * motion.delta[link];
            let slack = self.p.line.links[link].rest_correction();
            self.p.eased(link, rise) * elongation - rise * slack
        };
        yields.pulls().map(by_link).sum()
    }

    /// The same with corrections and contact forces; `residual` is R̃ from a contact.
    fn raised(&self, yields: &Yield, share: f64, residual: impl Fn(&Contact<DIM>) -> f64) -> f64 {
        let corrections = &self.unilateral.correction;
        let corrected = yields.pulls().map(|(link, rise)| rise * corrections[link]);
        let pressed = self.contacts.active.iter().map(|&j| {
            let force = self.unilateral.force[j];
            force * residual(&self.contacts.all[j])
        });
        self.raised_by_links(yields, share) + corrected.sum::<f64>() + pressed.sum::<f64>()
    }

    /// Height of the wire at a contact above the mesh, m.
    pub(super) fn raised_at(&self, contact: &Contact<DIM>, share: f64) -> f64 {
        if self.p.lanes[contact.of[2]].is_rigid() {
            return 0.0;
        }
        let residual = |other: &Contact<DIM>| self.p.residual(contact, other);
        contact.yields.rise + self.raised(&contact.yields, share, residual)
    }

    /// What a watched place has risen by beyond the mesh since the line was at rest, m.
    fn raised_since(&self, spot: &Spot<DIM>) -> f64 {
        let p: &Prepared<DIM, D> = &self.p;
        let residual = |other: &Contact<DIM>| {
            let carried = p.carried(&spot.yields, &other.yields);
            if other.of[2] == spot.lane {
                p.lanes[spot.lane].between(&spot.place, &other.place) - carried
            } else {
                -carried
            }
        };
        self.raised(&spot.yields, p.coefficients.stiffness, residual)
    }

    /// The same of a node; zero when it is not on a lane.
    pub(super) fn node_raised(&self, node: usize) -> f64 {
        let spot = self.spots.get(&node);
        spot.map_or(0.0, |spot| self.raised_since(spot))
    }

    /// The same of a place on a lane.
    pub(super) fn place_raised(&self, place: &Place<DIM>) -> f64 {
        let spot = Spot::new(&self.p.lanes, place);
        spot.map_or(0.0, |spot| self.raised_since(&spot))
    }
}
