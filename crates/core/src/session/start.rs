//! Start of a session.

use crate::error::CoreError;
use crate::integrator::wire_model::WireModel;
use crate::linear::loads::Load;
use crate::pantograph::model::Pantograph;
use crate::session::collectors::{Collector, Collectors, locate};
use crate::session::compliance::ComplianceWork;
use crate::session::outputs::Outputs;
use crate::session::{OwnedModel, Session, SessionStart, is_direct};
use crate::simulation::state::State;
use crate::slideline::local_compliance::MOST_LINKS;
use crate::slideline::point::SlidelinePoint;
use std::sync::Arc;

/// Number of rows of the complementarity problem (contacts, stops and breakpoints, slack links) for
/// which memory is reserved at the start; it grows with the square. A step with more rows allocates
/// once.
pub const RESERVED_ROWS: usize = 256;

impl<const DIM: usize, const D: usize> Session<DIM, D> {
    /// Session with given forces: the line in equilibrium under `forces` (N) of the collectors.
    ///
    /// # Errors
    /// [`CoreError::Input`]: no collector, several slidelines (how a given force is shared between
    /// wires is not known), updated kinematics; [`CoreError::OffWire`], or any of [`StaticSolver`].
    pub fn with_forces(
        line: Arc<WireModel<DIM, D>>,
        collectors: Vec<Collector>,
        forces: &[f64],
        start: SessionStart,
    ) -> Result<Self, CoreError> {
        check(&line, &start)?;
        let is_sound = |c: &Collector| c.behind.is_finite() && c.half_width > 0.0;
        if collectors.is_empty() || !collectors.iter().all(is_sound) {
            let reason = "none, or one that is not sound";
            return Err(CoreError::invalid("collectors", reason));
        }
        if forces.len() != collectors.len() || forces.iter().any(|f| !f.is_finite()) {
            let reason = "not one for each collector, or not finite";
            return Err(CoreError::invalid("forces", reason));
        }
        if line.slidelines.len() > 1 {
            let reason = "several: how a given force is shared between wires is not known";
            return Err(CoreError::invalid("lanes", reason));
        }
        let slideline = &line.slidelines[0];
        let find = |(number, c): (usize, &Collector)| {
            locate(slideline, start.position - c.behind, 0, (number, 0))
        };
        let points = collectors.iter().enumerate().map(find);
        let points: Vec<SlidelinePoint<DIM>> = points.collect::<Result<_, _>>()?;
        let pressed = points
            .iter()
            .map(|point| (*point, slideline.compliance_at(point)));
        let pressed = pressed.collect::<Vec<_>>();
        let equilibrium = line
            .static_solver()?
            .solve_with_compliance(&pressed, forces)?;
        let links = if slideline.is_rigid() { 0 } else { MOST_LINKS };
        let model = OwnedModel {
            pantographs: Vec::new(),
            distances: Vec::new(),
            friction: start.friction,
            line,
        };
        let mut state = State::blank(&model.borrow(), false)?;
        let motion = &mut state.motion;
        motion.wires = model.line.at_rest(equilibrium.u);
        motion.problem.correction = equilibrium.correction;
        motion
            .wires
            .links
            .known_reductions
            .reserve(links * points.len());
        let loads = forces.iter().map(|_| empty_load::<DIM, D>(links));
        Self {
            outputs: Outputs::new(Vec::new(), points.len(), (0, 0)),
            watched: Vec::new(),
            compliance: ComplianceWork::default(),
            collectors: Collectors {
                all: collectors,
                points,
                loads: loads.collect(),
                sizes: forces.to_vec(),
                forces: forces.to_vec(),
            },
            position: start.position,
            speed: start.speed,
            state,
            model,
        }
        .prepared()
    }

    /// Session with simulated pantographs, which follow the first at `distances` (m): line and
    /// pantographs in equilibrium as at the start of a run.
    ///
    /// # Errors
    /// [`CoreError::Input`]: excitation for a whole run, an actuator with a delay, or updated
    /// kinematics; or any error of the start of a run.
    pub fn with_pantographs(
        line: Arc<WireModel<DIM, D>>,
        pantographs: Vec<Pantograph>,
        distances: Vec<f64>,
        start: SessionStart,
    ) -> Result<Self, CoreError> {
        check_pantographs(&pantographs, &distances)?;
        if pantographs.iter().any(|p| p.is_external) {
            let reason = "an external one, whose strips are given";
            return Err(CoreError::invalid("pantographs", reason));
        }
        let is_excited =
            |p: &Pantograph| !p.excitation.forces.is_empty() || p.excitation.base.is_some();
        if pantographs.iter().any(is_excited) {
            let reason = "what is given for a whole run";
            return Err(CoreError::invalid("pantographs", reason));
        }
        if !pantographs.iter().flat_map(|p| &p.actuator).all(is_direct) {
            let reason = "an actuator that is not asked in every step";
            return Err(CoreError::invalid("pantographs", reason));
        }
        Self::on_pantographs(line, (pantographs, distances), start)
    }

    /// Session with given strips: those of [external](Pantograph::external) pantographs, which
    /// follow the first at `distances` (m). The line is in equilibrium under their forces at the
    /// start, the strips are where it is.
    ///
    /// # Errors
    /// [`CoreError::Input`]: a pantograph that is not external, or updated kinematics; or any error
    /// of the start of a run.
    pub fn with_strips(
        line: Arc<WireModel<DIM, D>>,
        pantographs: Vec<Pantograph>,
        distances: Vec<f64>,
        start: SessionStart,
    ) -> Result<Self, CoreError> {
        check_pantographs(&pantographs, &distances)?;
        if !pantographs.iter().all(|p| p.is_external) {
            let reason = "one that is not external";
            return Err(CoreError::invalid("pantographs", reason));
        }
        Self::on_pantographs(line, (pantographs, distances), start)
    }

    fn on_pantographs(
        line: Arc<WireModel<DIM, D>>,
        (pantographs, distances): (Vec<Pantograph>, Vec<f64>),
        start: SessionStart,
    ) -> Result<Self, CoreError> {
        check(&line, &start)?;
        let sizes = || pantographs.iter().map(|p| (p.size(), p.is_external));
        let coordinates = sizes().map(|(size, _)| size).sum();
        let external = sizes().filter(|(_, is_external)| *is_external);
        let external = external.map(|(size, _)| size).sum();
        let model = OwnedModel {
            friction: start.friction,
            line,
            pantographs,
            distances,
        };
        let mut state =
            State::in_equilibrium(&model.borrow(), (start.position, start.speed), true)?;
        state.sleep_untouched(&model.borrow());
        let contacts: Vec<[usize; 3]> = state
            .motion
            .contacts
            .all
            .iter()
            .map(|c| c.indices)
            .collect();
        Self {
            collectors: Collectors::default(),
            position: start.position,
            speed: start.speed,
            outputs: Outputs::new(contacts.clone(), contacts.len(), (coordinates, external)),
            watched: Vec::new(),
            compliance: ComplianceWork::default(),
            state,
            model,
        }
        .prepared()
    }

    /// Reserves memory for the steps, and reads the outputs of the start.
    fn prepared(mut self) -> Result<Self, CoreError> {
        let motion = &mut self.state.motion;
        let links = self.model.line.line.links.iter();
        let links = links.filter(|link| link.unilateral).count();
        let breakpoints = motion
            .pantographs
            .iter()
            .map(|p| p.breakpoints.len())
            .sum::<usize>();
        let rows = (motion.contacts.all.len() + links + breakpoints).min(RESERVED_ROWS);
        motion.problem.reserve(rows);
        let points = motion.contacts.all.len() + self.collectors.all.len();
        motion.wires.reserve(points);
        let corrections = motion.problem.correction.len();
        self.compliance.reserve(
            self.collectors.all.len(),
            corrections,
            links.min(RESERVED_ROWS),
        );
        self.read_outputs()?;
        Ok(self)
    }
}

fn check_pantographs(pantographs: &[Pantograph], distances: &[f64]) -> Result<(), CoreError> {
    if !pantographs.is_empty() && distances.len() == pantographs.len() {
        return Ok(());
    }
    let reason = "none, or not one distance for each";
    Err(CoreError::invalid("pantographs", reason))
}

fn check<const DIM: usize, const D: usize>(
    line: &WireModel<DIM, D>,
    start: &SessionStart,
) -> Result<(), CoreError> {
    let numbers = [start.position, start.speed, start.friction];
    if !numbers.iter().all(|v| v.is_finite()) {
        return Err(CoreError::invalid("begin", "not finite"));
    }
    if !line.has_constant_cost() {
        let reason = "updated kinematics, which factorise in every step";
        return Err(CoreError::invalid("solver", reason));
    }
    Ok(())
}

/// Load with room for the shares of a force upwards and of one along the track at a point, and for
/// those of `links` links.
fn empty_load<const DIM: usize, const D: usize>(links: usize) -> Load {
    // At a point, in each of two directions.
    let shares = 4;
    Load {
        pattern: vec![(0, 0, 0.0); 2 * shares + 2 * DIM * links],
        sizes: Vec::new(),
    }
}
