//! Archive of all data that change during a run: one function saves the
//! [state](crate::simulation::state) and restores it.
//!
//! It leaves out data that every step computes before they are read: increments, tensions, gaps,
//! right-hand sides, and the geometry of updated kinematics.

use crate::checkpoint::{Archive, Checkpoint, count, refuse};
use crate::constraint::contacts::Contacts;
use crate::error::CoreError;
use crate::pantograph::actuator::ActuatorState;
use crate::pantograph::breakpoint::Branch;
use crate::pantograph::model::Pantograph;
use crate::pantograph::state::PantographState;
use crate::simulation::model::Model;
use crate::simulation::recording::record::Record;
use crate::simulation::state::State;
use crate::slideline::Slideline;

type Archived = Result<(), CoreError>;

impl<const DIM: usize, const D: usize> State<DIM, D> {
    /// Saves the data from which a run continues.
    ///
    /// # Errors
    /// None for a state between two steps.
    pub(crate) fn save(&mut self, model: &Model<'_, DIM, D>) -> Result<Checkpoint, CoreError> {
        let mut archive = Archive::saving();
        self.archive(model, &mut archive)?;
        Ok(archive.checkpoint(self.motion.steps))
    }

    /// Restores a saved state.
    ///
    /// # Errors
    /// [`CoreError::Input`] for data of another run; the state is then partly restored.
    pub(crate) fn restore(&mut self, model: &Model<'_, DIM, D>, saved: &Checkpoint) -> Archived {
        let mut archive = Archive::restoring(saved);
        self.archive(model, &mut archive)?;
        archive.finish()?;
        let motion = &mut self.motion;
        motion.steps = saved.step;
        if let Some(recorder) = &mut self.recorder {
            recorder.record.steps = saved.step;
            if let Some(books) = &mut recorder.books {
                books.resume(model, motion);
            }
        }
        motion.contacts.restore_vectors(model.pantographs);
        model.wires.resume(&mut motion.wires);
        motion.wires.awake = (0..model.wires.islands.len()).collect();
        self.sleep_untouched(model);
        Ok(())
    }

    fn archive(&mut self, model: &Model<'_, DIM, D>, archive: &mut Archive<'_>) -> Archived {
        let slidelines = &model
            .with_geometry(self.current_geometry.as_deref())
            .wires
            .slidelines;
        let motion = &mut self.motion;
        motion.wires.archive(archive)?;
        archive.numbers("link_correction", motion.problem.correction.iter_mut())?;
        archive.numbers("contact_force", motion.problem.force.iter_mut())?;
        archive.numbers("datum", std::iter::once(&mut motion.datum))?;
        archive_contacts(&mut motion.contacts, archive, slidelines)?;
        let pantographs = motion.pantographs.iter_mut().zip(&mut motion.start_u);
        for (number, (pantograph, start)) in pantographs.enumerate() {
            archive_pantograph(pantograph, start, archive, &format!("rider_{number}"))?;
        }
        let Some(recorder) = &mut self.recorder else {
            return Ok(());
        };
        archive_record(&mut recorder.record, archive)?;
        match &mut recorder.books {
            Some(books) => books.archive(archive),
            None => Ok(()),
        }
    }
}

fn archive_contacts<const DIM: usize>(
    contacts: &mut Contacts<DIM>,
    archive: &mut Archive<'_>,
    slidelines: &[Slideline<DIM>],
) -> Archived {
    let all = &mut contacts.all;
    archive.flags("contact_meets", all.iter_mut().map(|c| &mut c.is_active))?;
    archive.numbers("contact_lateral", all.iter_mut().map(|c| &mut c.lateral))?;
    // A point follows from its element and its shape functions.
    let elements = all.iter_mut().map(|c| &mut c.ends[1].element);
    archive.counts("contact_element", elements)?;
    let weights = all.iter_mut().flat_map(|c| &mut c.ends[1].weights);
    archive.numbers("contact_weights", weights)?;
    for contact in all {
        let end = &mut contact.ends[1];
        let point = slidelines[contact.indices[2]].point_on(end.element, end.weights);
        *end = point.ok_or_else(|| refuse("contact_element", "is no element"))?;
    }
    Ok(())
}

pub(crate) fn archive_pantograph(
    pantograph: &mut PantographState,
    start: &mut [f64],
    archive: &mut Archive<'_>,
    prefix: &str,
) -> Archived {
    let name = |part: &str| format!("{prefix}_{part}");
    archive.numbers(&name("displacement"), pantograph.u.iter_mut())?;
    archive.numbers(&name("velocity"), pantograph.v.iter_mut())?;
    archive.numbers(&name("acceleration"), pantograph.a.iter_mut())?;
    archive.numbers(&name("start"), start.iter_mut())?;
    let rest = [
        &mut pantograph.preload,
        &mut pantograph.excitation.displacement,
        &mut pantograph.actuator.force,
    ];
    archive.numbers(&name("preload_ground_actuator"), rest.into_iter())?;
    archive_pending_forces(&mut pantograph.actuator, archive, &name("waiting"))?;
    // Displacements of stops count from the start.
    let closed = pantograph.breakpoints.iter_mut().map(|k| &mut k.threshold);
    archive.numbers(&name("kink_closed"), closed)?;
    let force = pantograph.breakpoints.iter_mut().map(|k| &mut k.force);
    archive.numbers(&name("kink_force"), force)?;
    let ranges = pantograph
        .piecewise_forces
        .iter_mut()
        .flat_map(|l| &mut l.range);
    archive.numbers(&name("law_range"), ranges)?;
    let mut right: Vec<bool> = pantograph
        .piecewise_forces
        .iter()
        .map(|l| l.branch == Branch::Right)
        .collect();
    archive.flags(&name("law_right"), right.iter_mut())?;
    for (law, right) in right.into_iter().enumerate() {
        pantograph.set_branch(law, if right { Branch::Right } else { Branch::Left });
    }
    Ok(())
}

/// Saves or restores pending forces: step and force (N) of each, one after the other.
fn archive_pending_forces(
    actuator: &mut ActuatorState,
    archive: &mut Archive<'_>,
    name: &str,
) -> Archived {
    let waiting = &mut actuator.pending;
    let pairs = waiting.iter().flat_map(|&(due, force)| [due as f64, force]);
    let mut list = pairs.collect();
    archive.list(name, &mut list)?;
    if list.len() % 2 == 1 {
        return Err(refuse(name, "has a step without a force"));
    }
    waiting.clear();
    for pair in list.chunks_exact(2) {
        waiting.push_back((count(name, pair[0])?, pair[1]));
    }
    Ok(())
}

fn archive_record(record: &mut Record, archive: &mut Archive<'_>) -> Archived {
    archive.numbers("link_min", record.link_min.iter_mut())?;
    archive.numbers("link_max", record.link_max.iter_mut())?;
    archive.numbers("uplift_max", record.uplift_max.iter_mut())?;
    archive.numbers("stop_max", record.stop_max.iter_mut())?;
    let counts = [
        &mut record.slack_max,
        &mut record.pivots,
        &mut record.pivots_max,
        &mut record.fallbacks,
    ];
    archive.counts("slack_pivots_fallbacks", counts.into_iter())?;
    let largest = [
        &mut record.lcp_residual,
        &mut record.energy_residual,
        &mut record.energy_turnover,
        &mut record.energy_switching,
    ];
    archive.numbers("residuals_turnover", largest.into_iter())?;
    let mut pivots: Vec<f64> = record.pivot_counts.iter().map(|&n| n as f64).collect();
    archive.list("pivot_counts", &mut pivots)?;
    let counts = pivots.into_iter().map(|n| count("pivot_counts", n));
    record.pivot_counts = counts.collect::<Result<_, _>>()?;
    Ok(())
}

impl<const DIM: usize> Contacts<DIM> {
    /// Interpolates the strip vectors where the wires were in the last step.
    fn restore_vectors(&mut self, pantographs: &[Pantograph]) {
        for contact in &mut self.all {
            let strip = &pantographs[contact.indices[0]].strips[contact.indices[1]];
            contact.interpolate_vectors(strip);
        }
    }
}
