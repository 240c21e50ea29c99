//! Outputs of a session, read from the line and the pantographs after each step.

use crate::error::CoreError;
use crate::integrator::state::WireState;
use crate::session::collectors::lateral_displacement;
use crate::session::snapshot::Snapshot;
use crate::slideline::Slideline;
use crate::slideline::point::SlidelinePoint;

/// Wire where something touches it, and pantographs. Where forces are given there is one value for
/// each collector; where pantographs are simulated, one for each contact (strip on a slideline),
/// and those of the pantographs.
#[derive(Debug, Clone, Default)]
pub struct Outputs {
    /// Contacts: pantograph, strip and slideline of each; empty where forces are given.
    pub contacts: Vec<[usize; 3]>,
    /// Contact force, N, at the time of balance of the step; the given one where forces are given.
    pub force: Vec<f64>,
    /// Height of the wire, m; height, lateral position and rate are NaN where there is no wire.
    pub height: Vec<f64>,
    /// Lateral position of the wire, m; zero when planar.
    pub lateral: Vec<f64>,
    /// Rate of the height of the wire at the point that moves with the speed of the session, m/s.
    pub rate: Vec<f64>,
    /// Displacements of all coordinates of all pantographs since the start, m.
    pub displacement: Vec<f64>,
    /// Velocities of all coordinates of all pantographs, m/s.
    pub velocity: Vec<f64>,
    /// Uplift of the [watched](crate::session::Session::watch) nodes, m.
    pub uplift: Vec<f64>,
    /// Heights of all coordinates of external pantographs, m; empty where there are none.
    pub strip_height: Vec<f64>,
}

impl Outputs {
    /// Zeros for `count` contacts or collectors and `coordinates` of pantographs, of which
    /// `external` are heights of external ones.
    pub(crate) fn new(
        contacts: Vec<[usize; 3]>,
        count: usize,
        (coordinates, external): (usize, usize),
    ) -> Self {
        let zero = vec![0.0; count];
        Self {
            contacts,
            force: zero.clone(),
            height: zero.clone(),
            lateral: zero.clone(),
            rate: zero,
            displacement: vec![0.0; coordinates],
            velocity: vec![0.0; coordinates],
            uplift: Vec::new(),
            strip_height: vec![0.0; external],
        }
    }

    /// Reads the mesh and the pantographs.
    ///
    /// # Errors
    /// [`CoreError::NotFinite`].
    pub(crate) fn read_mesh<const DIM: usize, const D: usize>(
        &mut self,
        snapshot: &Snapshot<'_, DIM, D>,
    ) -> Result<(), CoreError> {
        let Snapshot {
            line,
            motion,
            collectors,
            position,
            speed,
        } = *snapshot;
        let mut is_finite = true;
        for (number, collector) in collectors.all.iter().enumerate() {
            let x = position - collector.behind;
            self.force[number] = collectors.forces[number];
            let wire = (&line.slidelines[0], x, &collectors.points[number]);
            is_finite &= self.read_wire(number, wire, &motion.wires, speed);
        }
        for (number, contact) in motion.contacts.all.iter().enumerate() {
            let (slideline, x) = (
                &line.slidelines[contact.indices[2]],
                contact.along(position),
            );
            self.force[number] = motion.problem.force[number];
            match slideline.locate(x, contact.ends[1].element) {
                Some(point) => {
                    let wire = (slideline, x, &point);
                    is_finite &= self.read_wire(number, wire, &motion.wires, speed);
                }
                None => self.set_no_wire(number),
            }
        }
        let pantographs = motion.pantographs.iter().zip(&motion.start_u);
        let displacements = pantographs
            .flat_map(|(pantograph, start)| pantograph.u.iter().zip(start).map(|(u, s)| u - s));
        let outputs = self.displacement.iter_mut().zip(displacements);
        outputs.for_each(|(output, new)| *output = new);
        let velocities = motion
            .pantographs
            .iter()
            .flat_map(|pantograph| &pantograph.v);
        let outputs = self.velocity.iter_mut().zip(velocities);
        outputs.for_each(|(output, new)| *output = *new);
        let external = motion.pantographs.iter().filter(|p| p.model.is_external);
        let heights = external.flat_map(|pantograph| &pantograph.u);
        let outputs = self.strip_height.iter_mut().zip(heights);
        outputs.for_each(|(output, u)| *output = motion.datum + u);
        let numbers = self.force.iter().chain(&self.displacement);
        if is_finite && numbers.chain(&self.velocity).all(|v| v.is_finite()) {
            return Ok(());
        }
        let (what, step) = ("the motion", motion.steps);
        Err(CoreError::NotFinite { what, step })
    }

    /// Reads the wire at a point that moves along it with `speed`, m/s; returns whether it is
    /// finite.
    fn read_wire<const DIM: usize, const D: usize>(
        &mut self,
        number: usize,
        (slideline, x, point): (&Slideline<DIM>, f64, &SlidelinePoint<DIM>),
        line: &WireState<D>,
        speed: f64,
    ) -> bool {
        let (u, v) = (&line.displacement(), &line.velocity());
        self.height[number] = point.height + point.displacement(u, DIM - 1);
        self.lateral[number] = point.lateral + lateral_displacement(point, u);
        self.rate[number] = point.displacement(v, DIM - 1) + speed * slideline.slope(x, point, u);
        self.height[number].is_finite() && self.rate[number].is_finite()
    }

    /// Sets the values of a contact without wire to NaN.
    fn set_no_wire(&mut self, number: usize) {
        for list in [&mut self.height, &mut self.lateral, &mut self.rate] {
            list[number] = f64::NAN;
        }
    }
}
