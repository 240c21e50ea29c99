//! The start of a loop.

use super::live::{Begin, Collector, Live, STEP, is_direct, refuse};
use super::live_parts::Parts;
use super::live_push::locate;
use super::live_reading::Reading;
use super::loads::Load;
use super::place::Place;
use super::record::RecordPlan;
use super::rider::Rider;
use super::run::{Run, Travel};
use super::stepper::Prepared;
use super::still::Still;
use super::yields::MOST;
use crate::error::CoreError;
use crate::lcp::{PIVOTS_BASE, PIVOTS_PER_ROW};
use std::sync::Arc;

/// Unknowns of the complementarity problem (contacts, stops and kinks, slack links) for which there is
/// room from the start. A step with more makes room once: that is memory in proportion to the square.
pub const ROOM: usize = 256;

impl<const DIM: usize, const D: usize> Live<DIM, D> {
    /// A loop with given forces: the line in equilibrium under `forces` (N) of the collectors.
    ///
    /// # Errors
    /// [`CoreError::Input`]: no collector, several lanes (how a given force is shared between wires is
    /// not known), updated kinematics; [`CoreError::OffWire`], or any of [`Still`].
    pub fn with_forces(
        p: Arc<Prepared<DIM, D>>,
        collectors: Vec<Collector>,
        forces: &[f64],
        begin: Begin,
    ) -> Result<Self, CoreError> {
        check(&p, &begin)?;
        let sound = |c: &Collector| c.behind.is_finite() && c.half_width > 0.0;
        if collectors.is_empty() || !collectors.iter().all(sound) {
            return Err(refuse("collectors", "none, or one that is not sound"));
        }
        if forces.len() != collectors.len() || forces.iter().any(|f| !f.is_finite()) {
            return Err(refuse(
                "forces",
                "not one for each collector, or not finite",
            ));
        }
        if p.lanes.len() > 1 {
            let reason = "several: how a given force is shared between wires is not known";
            return Err(refuse("lanes", reason));
        }
        let find = |(number, c): (usize, &Collector)| {
            locate(&p.lanes[0], begin.position - c.behind, 0, number)
        };
        let places = collectors.iter().enumerate().map(find);
        let places: Vec<Place<DIM>> = places.collect::<Result<_, _>>()?;
        let pressed = places
            .iter()
            .map(|place| (*place, p.lanes[0].yield_at(place)));
        let still = Still::of(&p)?.press(&pressed.collect::<Vec<_>>(), forces)?;
        let mut travel = stand(&begin, Vec::new());
        let is_rigid = p.lanes[0].is_rigid();
        let links = if is_rigid { 0 } else { MOST };
        let loads = forces.iter().map(|&force| load::<DIM, D>(force, links));
        travel.loads = loads.collect();
        let plan = plan();
        let run = Run::blank(&p, &[], &travel, &plan)?;
        let mut parts = Parts::of(run);
        parts.state = p.at_rest(still.u);
        parts.unilateral.correction = still.correction;
        parts.state.links.given.reserve(links * places.len());
        let reading = Reading::new(Vec::new(), places.len(), 0);
        Self::ready(
            p,
            (Vec::new(), collectors, places),
            (travel, plan),
            parts,
            reading,
        )
    }

    /// A loop with simulated riders, which follow the first at `distances` (m): line and riders in
    /// equilibrium as at the start of a run.
    ///
    /// # Errors
    /// [`CoreError::Input`]: what is given for a whole run, an actuator with a delay, or updated
    /// kinematics; or any error of the start of a run.
    pub fn with_riders(
        p: Arc<Prepared<DIM, D>>,
        riders: Vec<Rider>,
        distances: Vec<f64>,
        begin: Begin,
    ) -> Result<Self, CoreError> {
        check(&p, &begin)?;
        if riders.is_empty() || distances.len() != riders.len() {
            return Err(refuse("riders", "none, or not one distance for each"));
        }
        let is_given = |r: &Rider| !r.given.forces.is_empty() || r.given.ground.is_some();
        if riders.iter().any(is_given) {
            return Err(refuse("riders", "what is given for a whole run"));
        }
        if !riders.iter().flat_map(|r| &r.actuator).all(is_direct) {
            return Err(refuse(
                "riders",
                "an actuator that is not asked in every step",
            ));
        }
        let (travel, plan) = (stand(&begin, distances), plan());
        let run = Run::start(&p, &riders, &travel, &plan)?;
        let contacts: Vec<[usize; 3]> = run.contacts.all.iter().map(|c| c.of).collect();
        let coordinates = riders.iter().map(Rider::size).sum();
        let reading = Reading::new(contacts.clone(), contacts.len(), coordinates);
        let parts = Parts::of(run);
        Self::ready(
            p,
            (riders, Vec::new(), Vec::new()),
            (travel, plan),
            parts,
            reading,
        )
    }

    fn ready(
        p: Arc<Prepared<DIM, D>>,
        (riders, collectors, places): (Vec<Rider>, Vec<Collector>, Vec<Place<DIM>>),
        (travel, plan): (Travel, RecordPlan),
        mut parts: Parts<DIM, D>,
        reading: Reading,
    ) -> Result<Self, CoreError> {
        let links = p.line.links.iter().filter(|link| link.unilateral).count();
        let kinks = parts.riders.iter().map(|r| r.kinks.len()).sum::<usize>();
        let rows = (parts.contacts.all.len() + links + kinks).min(ROOM);
        parts.forget_extremes();
        parts.unilateral.reserve(rows);
        if let Some(grid) = &mut parts.state.grid {
            grid.reserve(parts.contacts.all.len() + collectors.len());
        }
        parts
            .record
            .pivot_counts
            .reserve(PIVOTS_BASE + PIVOTS_PER_ROW * rows);
        let mut live = Self {
            p,
            riders,
            collectors,
            places,
            travel,
            plan,
            parts: Some(parts),
            steps: 0,
            reading,
        };
        live.read()?;
        Ok(live)
    }
}

fn check<const DIM: usize, const D: usize>(
    p: &Prepared<DIM, D>,
    begin: &Begin,
) -> Result<(), CoreError> {
    let all = [begin.position, begin.speed, begin.friction];
    if !all.iter().all(|v| v.is_finite()) {
        return Err(refuse("begin", "not finite"));
    }
    if p.updating.is_some() {
        let reason = "updated kinematics, which factorise in every step";
        return Err(refuse("solver", reason));
    }
    Ok(())
}

/// Standing at the start.
fn stand(begin: &Begin, distances: Vec<f64>) -> Travel {
    Travel {
        positions: vec![begin.position; STEP + 2],
        speeds: vec![begin.speed; STEP + 2],
        distances,
        friction: begin.friction,
        loads: Vec::new(),
    }
}

/// A load with room for the shares of a force upwards and of one along, and for those that links take.
fn load<const DIM: usize, const D: usize>(force: f64, links: usize) -> Load {
    // Of a place, in each of two directions.
    let shares = 4;
    Load {
        pattern: vec![(0, 0, 0.0); 2 * shares + 2 * DIM * links],
        sizes: vec![force; STEP + 2],
    }
}

/// Nothing is recorded: no step of a loop is a multiple of these.
fn plan() -> RecordPlan {
    RecordPlan {
        contact_every: usize::MAX,
        line_every: usize::MAX,
        links: false,
        nodes: Vec::new(),
        points: Vec::new(),
        ledger: false,
        ledger_every: 1,
        near: None,
    }
}
