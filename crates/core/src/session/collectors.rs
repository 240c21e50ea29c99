//! Collectors: devices outside that press against the wire with a given force.

use crate::constraint::contacts::Contact;
use crate::error::CoreError;
use crate::integrator::wire_model::WireModel;
use crate::linear::loads::Load;
use crate::simulation::model::Model;
use crate::simulation::motion::Motion;
use crate::slideline::Slideline;
use crate::slideline::point::{Nodal, SlidelinePoint};

/// Device outside whose force on the wire is given.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Collector {
    /// Distance behind the position of the session, m.
    pub behind: f64,
    /// Half width to either side, m; infinite where every lateral position is within it.
    pub half_width: f64,
}

/// Collectors of a session, where they touch the wire, and their forces on it.
#[derive(Debug, Clone, Default)]
pub(crate) struct Collectors<const DIM: usize> {
    pub(crate) all: Vec<Collector>,
    /// Point of the wire found last for each collector.
    pub(crate) points: Vec<SlidelinePoint<DIM>>,
    /// Pattern of forces on nodes for 1 N of each collector.
    pub(crate) loads: Vec<Load>,
    /// Force of each collector at the time of balance, N.
    pub(crate) sizes: Vec<f64>,
    /// Force of each collector in the last step, N.
    pub(crate) forces: Vec<f64>,
}

impl<const DIM: usize> Collectors<DIM> {
    /// Finds the points of the wire at all collectors, with the session at `position`, m.
    ///
    /// # Errors
    /// [`CoreError::OffWire`].
    pub(crate) fn locate(
        &mut self,
        slideline: &Slideline<DIM>,
        position: f64,
        step: usize,
    ) -> Result<(), CoreError> {
        let pairs = self.points.iter_mut().zip(&self.all).enumerate();
        for (number, (point, collector)) in pairs {
            let x = position - collector.behind;
            *point = locate(slideline, x, point.element, (number, step))?;
        }
        Ok(())
    }

    /// Applies the forces of a step, N, at the time of balance. `positions` of the session, m: at
    /// the time of balance and at the end of the step.
    ///
    /// # Errors
    /// [`CoreError::OffWire`], [`CoreError::OutOfReach`].
    pub(crate) fn apply_forces<const D: usize>(
        &mut self,
        model: &Model<'_, DIM, D>,
        motion: &mut Motion<DIM, D>,
        forces: &[f64],
        [balance, end]: [f64; 2],
    ) -> Result<(), CoreError> {
        let (line, step) = (model.wires, motion.steps);
        let old = line.coefficients.old;
        motion.wires.links.known_reductions.clear();
        for (number, collector) in self.all.iter().enumerate() {
            let (slideline, near) = (&line.slidelines[0], self.points[number].element);
            let x = balance - collector.behind;
            let point = locate(slideline, x, near, (number, step))?;
            // The collector must not leave the wire within the step either.
            locate(
                slideline,
                end - collector.behind,
                point.element,
                (number, step),
            )?;
            let lateral =
                point.lateral + lateral_displacement(&point, &motion.wires.displacement());
            if lateral.abs() > collector.half_width {
                return Err(CoreError::OutOfReach {
                    pantograph: number,
                    position: x,
                    lateral,
                    half_width: collector.half_width,
                    step,
                });
            }
            let (compliance, load) = (slideline.compliance_at(&point), &mut self.loads[number]);
            let relieved = || {
                compliance
                    .links()
                    .map(|(l, r)| (l, line.tension_relief(l, r)))
            };
            let tensions = relieved().map(|(link, share)| (link, share * forces[number]));
            motion.wires.links.known_reductions.extend(tensions);
            let on_links = relieved().flat_map(|(link, share)| line.line.links[link].shares(share));
            set_unit_force::<DIM, D>(load, &point, model.friction, on_links);
            // Weighted as histories of loads are: at the time of balance.
            let force = forces[number];
            self.forces[number] = force;
            self.sizes[number] = (1.0 - old) * force + old * force;
        }
        self.request_nodes(line, motion, balance)
    }

    /// Names the nodes of explicit steps that are read at the time of balance.
    fn request_nodes<const D: usize>(
        &mut self,
        line: &WireModel<DIM, D>,
        motion: &mut Motion<DIM, D>,
        balance: f64,
    ) -> Result<(), CoreError> {
        if self.all.is_empty() {
            return Ok(());
        }
        let slideline = &line.slidelines[0];
        self.locate(slideline, balance, motion.steps)?;
        let nodes = self
            .points
            .iter()
            .flat_map(|point| slideline.nodes_around(point));
        line.request_nodes(&mut motion.wires, nodes);
        Ok(())
    }
}

/// Refuses a step of a session that ends where a strip of a pantograph has no wire. A step of a run
/// may end there, because none follows.
///
/// # Errors
/// [`CoreError::OffWire`].
pub(crate) fn check_end<const DIM: usize, const D: usize>(
    line: &WireModel<DIM, D>,
    motion: &Motion<DIM, D>,
    position: f64,
) -> Result<(), CoreError> {
    for of_strip in motion.contacts.all.chunks(line.slidelines.len()) {
        let has_wire = |c: &Contact<DIM>| {
            let slideline = &line.slidelines[c.indices[2]];
            let point = slideline.locate(c.along(position), c.ends[1].element);
            point.is_some()
        };
        if !of_strip.iter().any(has_wire) {
            return Err(CoreError::OffWire {
                pantograph: of_strip[0].pantograph(),
                position: of_strip[0].along(position),
                step: motion.steps,
            });
        }
    }
    Ok(())
}

/// Finds the point of a slideline at a collector, given by its number, in a step.
///
/// # Errors
/// [`CoreError::OffWire`].
pub(crate) fn locate<const DIM: usize>(
    slideline: &Slideline<DIM>,
    position: f64,
    near: usize,
    (number, step): (usize, usize),
) -> Result<SlidelinePoint<DIM>, CoreError> {
    slideline.locate(position, near).ok_or(CoreError::OffWire {
        pantograph: number,
        position,
        step,
    })
}

/// Lateral displacement of the wire at a point, m; zero in the plane.
pub(crate) fn lateral_displacement<const DIM: usize, const D: usize>(
    point: &SlidelinePoint<DIM>,
    u: &(impl Nodal<D> + ?Sized),
) -> f64 {
    if DIM < 3 {
        0.0
    } else {
        point.displacement(u, 1)
    }
}

/// Makes a load the unit force upwards at a point, with the friction μ along the wire, and with the
/// forces `on_links` by which links are relieved.
fn set_unit_force<const DIM: usize, const D: usize>(
    load: &mut Load,
    point: &SlidelinePoint<DIM>,
    friction: f64,
    on_links: impl Iterator<Item = (usize, usize, f64)>,
) {
    let up = point.shares::<D>(DIM - 1);
    let along = point
        .shares::<D>(0)
        .map(|(n, c, share)| (n, c, friction * share));
    let unused = std::iter::repeat((0, 0, 0.0));
    let all = up.chain(along).chain(on_links).chain(unused);
    for (entry, new) in load.pattern.iter_mut().zip(all) {
        *entry = new;
    }
}
