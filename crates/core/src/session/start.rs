//! The start of a loop.

use crate::error::CoreError;
use crate::integrator::prepared::WireModel;
use crate::linear::loads::Load;
use crate::linear::static_response::StaticSolver;
use crate::pantograph::system::Pantograph;
use crate::session::forces::locate;
use crate::session::outputs::Outputs;
use crate::session::{Begin, Collector, Fixed, Session, is_direct, refuse};
use crate::simulation::state::State;
use crate::slideline::point::SlidelinePoint;
use crate::slideline::residual_flexibility::MOST;
use std::sync::Arc;

/// Unknowns of the complementarity problem (contacts, stops and kinks, slack links) for which there is
/// room from the start. A step with more makes room once: that is memory in proportion to the square.
pub const ROOM: usize = 256;

impl<const DIM: usize, const D: usize> Session<DIM, D> {
    /// A loop with given forces: the line in equilibrium under `forces` (N) of the collectors.
    ///
    /// # Errors
    /// [`CoreError::Input`]: no collector, several lanes (how a given force is shared between wires is
    /// not known), updated kinematics; [`CoreError::OffWire`], or any of [`StaticSolver`].
    pub fn with_forces(
        p: Arc<WireModel<DIM, D>>,
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
            locate(&p.lanes[0], begin.position - c.behind, 0, (number, 0))
        };
        let places = collectors.iter().enumerate().map(find);
        let places: Vec<SlidelinePoint<DIM>> = places.collect::<Result<_, _>>()?;
        let pressed = places
            .iter()
            .map(|place| (*place, p.lanes[0].yield_at(place)));
        let pressed = pressed.collect::<Vec<_>>();
        let still = StaticSolver::of(&p)?.press(&pressed, forces)?;
        let is_rigid = p.lanes[0].is_rigid();
        let links = if is_rigid { 0 } else { MOST };
        let fixed = Fixed {
            riders: Vec::new(),
            distances: Vec::new(),
            friction: begin.friction,
            line: p,
        };
        let mut state = State::blank(&fixed.model(), false)?;
        let motion = &mut state.motion;
        motion.line = fixed.line.at_rest(still.u);
        motion.unilateral.correction = still.correction;
        motion.line.links.given.reserve(links * places.len());
        let loads = forces.iter().map(|_| load::<DIM, D>(links));
        Self {
            loads: loads.collect(),
            sizes: forces.to_vec(),
            forces: forces.to_vec(),
            position: begin.position,
            speed: begin.speed,
            reading: Outputs::new(Vec::new(), places.len(), 0),
            collectors,
            places,
            state,
            fixed,
        }
        .ready()
    }

    /// A loop with simulated riders, which follow the first at `distances` (m): line and riders in
    /// equilibrium as at the start of a run.
    ///
    /// # Errors
    /// [`CoreError::Input`]: what is given for a whole run, an actuator with a delay, or updated
    /// kinematics; or any error of the start of a run.
    pub fn with_riders(
        p: Arc<WireModel<DIM, D>>,
        riders: Vec<Pantograph>,
        distances: Vec<f64>,
        begin: Begin,
    ) -> Result<Self, CoreError> {
        check(&p, &begin)?;
        if riders.is_empty() || distances.len() != riders.len() {
            return Err(refuse("riders", "none, or not one distance for each"));
        }
        let is_given = |r: &Pantograph| !r.given.forces.is_empty() || r.given.ground.is_some();
        if riders.iter().any(is_given) {
            return Err(refuse("riders", "what is given for a whole run"));
        }
        if !riders.iter().flat_map(|r| &r.actuator).all(is_direct) {
            return Err(refuse(
                "riders",
                "an actuator that is not asked in every step",
            ));
        }
        let coordinates = riders.iter().map(Pantograph::size).sum();
        let fixed = Fixed {
            friction: begin.friction,
            line: p,
            riders,
            distances,
        };
        let model = fixed.model();
        let mut state = State::standing(&model, (begin.position, begin.speed), true)?;
        state.let_sleep(&model);
        let contacts: Vec<[usize; 3]> = state.motion.contacts.all.iter().map(|c| c.of).collect();
        Self {
            collectors: Vec::new(),
            places: Vec::new(),
            loads: Vec::new(),
            sizes: Vec::new(),
            forces: Vec::new(),
            position: begin.position,
            speed: begin.speed,
            reading: Outputs::new(contacts.clone(), contacts.len(), coordinates),
            state,
            fixed,
        }
        .ready()
    }

    /// Make room for the steps, and read what the start has left.
    fn ready(mut self) -> Result<Self, CoreError> {
        let motion = &mut self.state.motion;
        let links = self.fixed.line.line.links.iter();
        let links = links.filter(|link| link.unilateral).count();
        let kinks = motion.riders.iter().map(|r| r.kinks.len()).sum::<usize>();
        let rows = (motion.contacts.all.len() + links + kinks).min(ROOM);
        motion.unilateral.reserve(rows);
        let places = motion.contacts.all.len() + self.collectors.len();
        motion.line.reserve(places);
        self.read()?;
        Ok(self)
    }
}

fn check<const DIM: usize, const D: usize>(
    p: &WireModel<DIM, D>,
    begin: &Begin,
) -> Result<(), CoreError> {
    let all = [begin.position, begin.speed, begin.friction];
    if !all.iter().all(|v| v.is_finite()) {
        return Err(refuse("begin", "not finite"));
    }
    if !p.steps_evenly() {
        let reason = "updated kinematics, which factorise in every step";
        return Err(refuse("solver", reason));
    }
    Ok(())
}

/// A load with room for the shares of a force upwards and of one along, and for those that links take.
fn load<const DIM: usize, const D: usize>(links: usize) -> Load {
    // Of a place, in each of two directions.
    let shares = 4;
    Load {
        pattern: vec![(0, 0, 0.0); 2 * shares + 2 * DIM * links],
        sizes: Vec::new(),
    }
}
