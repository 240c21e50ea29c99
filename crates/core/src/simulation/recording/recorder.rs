//! Records of a run while it steps, and the extremes of all steps.

use crate::constraint::contacts::Contact;
use crate::energy_terms::EnergyTerms;
use crate::error::CoreError;
use crate::lcp::LcpStats;
use crate::linalg::{Kernel, widest};
use crate::pantograph::state::PantographState;
use crate::simulation::inputs::Inputs;
use crate::simulation::model::Model;
use crate::simulation::motion::Motion;
use crate::simulation::recording::energy_balance::EnergyBalance;
use crate::simulation::recording::motion::record as motion_record;
use crate::simulation::recording::record::{Record, RecordPlan};
use crate::simulation::recording::subgrid_height::{Probe, spots};
use crate::simulation::recording::support_loads;
use crate::slideline::Slideline;
use crate::slideline::point::{Nodal, SlidelinePoint};
use std::collections::BTreeMap;
use std::ops::Range;

/// Recorder of a run: what it records, where, and what it has so far.
#[derive(Debug, Clone)]
pub(crate) struct Recorder<const DIM: usize, const D: usize> {
    pub(crate) plan: RecordPlan,
    /// Number of the last step of the run.
    last: usize,
    /// Places whose uplift is recorded.
    points: Vec<SlidelinePoint<DIM>>,
    /// Watched nodes on slidelines, where wires have compliance beyond the mesh.
    spots: BTreeMap<usize, Probe<DIM>>,
    /// For each island, the watched nodes of the plan on it, by their numbers in the plan.
    watched: Vec<Vec<usize>>,
    pub(crate) record: Record,
    /// Ledger of energies; `None` where none is kept.
    pub(crate) books: Option<EnergyBalance<DIM, D>>,
}

/// Places of the given points: on the lowest wire where there are several.
fn points<const DIM: usize>(
    lanes: &[Slideline<DIM>],
    x: &[f64],
) -> Result<Vec<SlidelinePoint<DIM>>, CoreError> {
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

impl<const DIM: usize, const D: usize> Recorder<DIM, D> {
    /// Recorder with nothing recorded yet, for a run of `steps` steps; tells an explicit line what
    /// is read in every step. Points are those of the line at rest.
    ///
    /// # Errors
    /// [`CoreError::Input`] for a point without wire.
    pub(crate) fn new(
        model: &Model<'_, DIM, D>,
        plan: &RecordPlan,
        steps: usize,
        motion: &mut Motion<DIM, D>,
    ) -> Result<Self, CoreError> {
        let line = model.wires;
        let points = points(&line.slidelines, &plan.points)?;
        let near = plan.near.iter().flat_map(|near| &near.nodes.of);
        let at_points = points.iter().flat_map(|place| &place.nodes);
        let held = plan
            .supports
            .iter()
            .flat_map(|parts| parts.nodes(&line.line));
        let read = plan.nodes.iter().chain(near).chain(at_points);
        let read = read.copied().chain(held);
        line.track_nodes(&mut motion.wires, read);
        let mut watched = vec![Vec::new(); line.islands.len()];
        for (k, &node) in plan.nodes.iter().enumerate() {
            watched[line.island_of(node)].push(k);
        }
        let (links, pantographs) = (line.line.links.len(), model.pantographs.len());
        Ok(Self {
            last: steps - 1,
            spots: spots(&line.slidelines, plan),
            record: Record::empty(&motion.contacts, links, plan, pantographs),
            books: None,
            plan: plan.clone(),
            points,
            watched,
        })
    }

    /// Opens the ledger at the start of the run, if one is kept.
    pub(crate) fn open_books(&mut self, model: &Model<'_, DIM, D>, motion: &Motion<DIM, D>) {
        if self.plan.ledger {
            self.books = Some(EnergyBalance::open(model, motion, self.plan.ledger_every));
        }
    }

    /// Records the step at its time of balance, then take it, booking its energies when a ledger is
    /// kept.
    ///
    /// # Errors
    /// [`CoreError::Balance`] when energies do not add up, [`CoreError::NotFinite`].
    pub(crate) fn take(
        &mut self,
        model: &Model<'_, DIM, D>,
        inputs: &Inputs<'_>,
        motion: &mut Motion<DIM, D>,
        solved: &LcpStats,
    ) -> Result<(), CoreError> {
        self.count(solved, motion);
        self.watch(model, inputs, motion);
        let step = motion.steps;
        self.record.steps = step + 1;
        let is_row = step.is_multiple_of(self.plan.line_every);
        let is_due = is_row || step == self.last;
        let Some(books) = &mut self.books else {
            motion.commit(model);
            return motion.check_sound();
        };
        let settled = books.take(model, inputs, motion, is_due);
        motion.check_sound()?;
        let row = if settled {
            books.check(model, &mut self.record, step)?
        } else {
            EnergyTerms::unknown()
        };
        if is_row {
            self.record.energy.push(row);
        }
        Ok(())
    }

    /// Removes rows with numbers that are not finite, which a failed step may leave, and completes
    /// energies: they are recorded last.
    pub(crate) fn keep_finite(&mut self) {
        let record = &mut self.record;
        record.keep_finite();
        if self.books.is_some() {
            let rows = record.line_time.len();
            record.energy.resize(rows, EnergyTerms::unknown());
        }
    }

    fn count(&mut self, stats: &LcpStats, motion: &Motion<DIM, D>) {
        let r = &mut self.record;
        r.pivots += stats.pivots;
        r.pivots_max = r.pivots_max.max(stats.pivots);
        if r.pivot_counts.len() <= stats.pivots {
            r.pivot_counts.resize(stats.pivots + 1, 0);
        }
        r.pivot_counts[stats.pivots] += 1;
        r.fallbacks += usize::from(stats.fallback_used);
        r.lcp_residual = r.lcp_residual.max(stats.residual);
        let slack = motion.problem.links.iter();
        let slack = slack
            .filter(|&&i| motion.problem.correction[i] > 0.0)
            .count();
        r.slack_max = r.slack_max.max(slack);
    }

    /// Updates the extremes of some links.
    fn watch_links(&mut self, motion: &Motion<DIM, D>, which: Range<usize>) {
        widest(Extremes {
            tension: &motion.wires.links.tension[which.clone()],
            correction: &motion.problem.correction[which.clone()],
            min: &mut self.record.link_min[which.clone()],
            max: &mut self.record.link_max[which],
        });
    }

    /// Updates the extremes of links and watched nodes of an island.
    pub(crate) fn watch_island(
        &mut self,
        model: &Model<'_, DIM, D>,
        motion: &Motion<DIM, D>,
        island: usize,
    ) {
        self.watch_links(motion, model.wires.islands[island].links.clone());
        for &k in &self.watched[island] {
            let uplift = node_uplift(&self.spots, model, motion, self.plan.nodes[k]);
            self.record.uplift_max[k] = self.record.uplift_max[k].max(uplift);
        }
    }

    /// Records the instant of balance and update the extremes.
    fn watch(
        &mut self,
        model: &Model<'_, DIM, D>,
        inputs: &Inputs<'_>,
        motion: &mut Motion<DIM, D>,
    ) {
        let (c, step) = (&model.wires.coefficients, motion.steps);
        let time = (step as f64 + 1.0 - c.old) * model.wires.h;
        for k in 0..motion.wires.awake.len() {
            self.watch_island(model, motion, motion.wires.awake[k]);
        }
        for (largest, pantograph) in self.record.stop_max.iter_mut().zip(&motion.pantographs) {
            *largest = largest.max(pantograph.largest_stop_force());
        }
        for pantograph in &mut motion.pantographs {
            pantograph.record_ranges(c);
        }
        let position = inputs.positions[1];
        if step.is_multiple_of(self.plan.contact_every) {
            self.record_contacts(model, motion, (time, inputs.speed, position));
        }
        if step.is_multiple_of(self.plan.line_every) {
            self.record_line(model, motion, (time, position));
        }
        if let Some(plan) = &self.plan.motion
            && step.is_multiple_of(plan.every)
        {
            motion_record(plan, model, motion, (time, position), &mut self.record);
        }
    }

    fn record_contacts(
        &mut self,
        model: &Model<'_, DIM, D>,
        motion: &Motion<DIM, D>,
        (time, speed, position): (f64, f64, f64),
    ) {
        let keep = model.wires.coefficients.stiffness;
        let r = &mut self.record;
        r.time.push(time);
        r.speed.push(speed);
        for (i, contact) in motion.contacts.all.iter().enumerate() {
            let (mut height, mut lateral) = (f64::NAN, f64::NAN);
            if contact.has_wire {
                let raised = motion.raised_at(model, contact, keep);
                height = motion.wire_at(model, contact, DIM - 1) + raised;
                lateral = if DIM < 3 {
                    0.0
                } else {
                    motion.wire_at(model, contact, 1)
                };
            }
            r.force.push(motion.problem.force[i]);
            r.gap.push(motion.problem.gap[i]);
            r.height.push(height);
            r.lateral.push(lateral);
        }
        for (j, pantograph) in motion.pantographs.iter().enumerate() {
            r.position.push(position - model.distances[j]);
            r.control.push(pantograph.actuator.force);
            for ((u, d), start) in pantograph
                .u
                .iter()
                .zip(&pantograph.delta)
                .zip(&motion.start_u[j])
            {
                r.masses.push(u + keep * d - start);
            }
        }
    }

    fn record_line(
        &mut self,
        model: &Model<'_, DIM, D>,
        motion: &Motion<DIM, D>,
        (time, position): (f64, f64),
    ) {
        let Self {
            plan,
            points,
            spots,
            record,
            ..
        } = self;
        record.line_time.push(time);
        let tension = |&link: &usize| motion.tension(link);
        let uplift = |&node: &usize| node_uplift(spots, model, motion, node);
        if let Some(near) = &plan.near {
            let from = near.from(position, model.distances);
            if plan.links {
                let first = near.links.first(from);
                record.link_first.push(first as f64);
                record
                    .link_force
                    .extend(near.links.row(first).iter().map(tension));
            }
            let first = near.nodes.first(from);
            record.uplift_first.push(first as f64);
            record
                .uplift
                .extend(near.nodes.row(first).iter().map(uplift));
            let row = first..first + near.nodes.count;
            for parts in plan.supports.get(row).unwrap_or_default() {
                support_loads::record(parts, model, motion, record);
            }
        } else {
            if plan.links {
                let links = 0..model.wires.line.links.len();
                record.link_force.extend(links.map(|link| tension(&link)));
            }
            record.uplift.extend(plan.nodes.iter().map(uplift));
            for parts in &plan.supports {
                support_loads::record(parts, model, motion, record);
            }
        }
        let ([u, delta], keep) = (
            motion.wires.at_balance(),
            model.wires.coefficients.stiffness,
        );
        for place in &*points {
            let moved = |c: usize| place.displacement(&u, c) + keep * place.displacement(&delta, c);
            let raised = motion.place_raised(model, place);
            record.point_uplift.push(moved(DIM - 1) + raised);
            record.point_along.push(moved(0));
        }
        let corrections = motion.problem.correction.iter();
        let slack = corrections.filter(|r| **r > 0.0).count();
        record.slack.push(slack as f64);
    }

    /// Smallest coordinate from which anything is recorded with the first pantograph at a position;
    /// `None` where all of the line is, and where a ledger needs all of it.
    pub(crate) fn first_recorded(&self, model: &Model<'_, DIM, D>, position: f64) -> Option<f64> {
        let near = self.plan.near.as_ref()?;
        let needs_all = self
            .books
            .as_ref()
            .is_some_and(EnergyBalance::needs_all_islands);
        let from = near.from(position, model.distances);
        (!needs_all).then(|| near.first_recorded(from))
    }

    /// Returns whether the motion of a point on one of these nodes is recorded.
    pub(crate) fn has_points(&self, nodes: &Range<usize>) -> bool {
        self.points.iter().any(|p| nodes.contains(&p.nodes[0]))
    }

    /// Books an island that is about to be laid to rest.
    pub(crate) fn leave(
        &mut self,
        model: &Model<'_, DIM, D>,
        motion: &Motion<DIM, D>,
        island: usize,
    ) {
        if let Some(books) = &mut self.books {
            books.leave(model, motion, island);
        }
    }

    /// Records the ranges of the piecewise forces of the pantographs.
    pub(crate) fn read_laws(&mut self, motion: &Motion<DIM, D>) {
        let pantographs = motion.pantographs.iter();
        self.record.law_ranges = pantographs
            .flat_map(PantographState::coordinate_ranges)
            .collect();
    }
}

impl<const DIM: usize, const D: usize> Motion<DIM, D> {
    /// Coordinate `c` of the wire at a contact, at the time of balance with the current increment.
    pub(crate) fn wire_at(
        &self,
        model: &Model<'_, DIM, D>,
        contact: &Contact<DIM>,
        c: usize,
    ) -> f64 {
        let place = &contact.point;
        let rest = if c == DIM - 1 {
            place.height
        } else {
            place.lateral
        };
        let [u, delta] = self.wires.at_balance();
        rest + place.displacement(&u, c)
            + model.wires.coefficients.stiffness * place.displacement(&delta, c)
    }

    /// Tension of a link at the time of balance, N.
    #[inline(always)]
    pub(crate) fn tension(&self, link: usize) -> f64 {
        if self.problem.correction[link] > 0.0 {
            return 0.0;
        }
        self.wires.links.tension[link]
    }
}

/// Uplift of a node at the time of balance, m.
fn node_uplift<const DIM: usize, const D: usize>(
    spots: &BTreeMap<usize, Probe<DIM>>,
    model: &Model<'_, DIM, D>,
    motion: &Motion<DIM, D>,
    node: usize,
) -> f64 {
    let ([u, delta], keep) = (
        motion.wires.at_balance(),
        model.wires.coefficients.stiffness,
    );
    let moved = u.at(node)[DIM - 1] + keep * delta.at(node)[DIM - 1];
    let spot = spots.get(&node);
    moved + spot.map_or(0.0, |spot| motion.raised_since(model, spot))
}

/// Extremes of the tensions of links, which slack ones do not have.
struct Extremes<'a> {
    tension: &'a [f64],
    correction: &'a [f64],
    min: &'a mut [f64],
    max: &'a mut [f64],
}

impl Kernel for Extremes<'_> {
    #[inline(always)]
    fn run(self) {
        let both = self.tension.iter().zip(self.correction);
        let extremes = self.min.iter_mut().zip(self.max);
        for ((tension, correction), (min, max)) in both.zip(extremes) {
            let tension = if *correction > 0.0 { 0.0 } else { *tension };
            *min = if tension < *min { tension } else { *min };
            *max = if tension > *max { tension } else { *max };
        }
    }
}
