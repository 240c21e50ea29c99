//! Everything that changes during a run, on the one [walk](crate::simulation::state) that takes it down and puts it back.
//!
//! Not on it is what every step makes anew before it is read: increments, tensions, gaps, right-hand
//! sides, and all that updated kinematics form.

use crate::checkpoint::{Archive, Checkpoint, count, refuse};
use crate::constraint::contacts::Contacts;
use crate::error::CoreError;
use crate::pantograph::actuator::ActuatorState;
use crate::pantograph::piecewise_force::Branch;
use crate::pantograph::system::{Pantograph, PantographState};
use crate::simulation::model::Model;
use crate::simulation::recording::record::Record;
use crate::simulation::state::State;
use crate::slideline::Slideline;

type Done = Result<(), CoreError>;

impl<const DIM: usize, const D: usize> State<DIM, D> {
    /// Numbers with which a run goes on.
    ///
    /// # Errors
    /// None of a state that steps have left.
    pub(crate) fn take_down(&mut self, model: &Model<'_, DIM, D>) -> Result<Checkpoint, CoreError> {
        let mut walk = Archive::taking_down();
        self.walk(model, &mut walk)?;
        Ok(walk.checkpoint(self.motion.steps))
    }

    /// Take the place of a saved state.
    ///
    /// # Errors
    /// [`CoreError::Input`] for numbers of another run; the state is then part the one, part the other.
    pub(crate) fn put_back(&mut self, model: &Model<'_, DIM, D>, saved: &Checkpoint) -> Done {
        let mut walk = Archive::putting_back(saved);
        self.walk(model, &mut walk)?;
        walk.finish()?;
        let motion = &mut self.motion;
        motion.steps = saved.step;
        if let Some(recorder) = &mut self.recorder {
            recorder.record.steps = saved.step;
            if let Some(books) = &mut recorder.books {
                books.resume(model, motion);
            }
        }
        motion.contacts.go_on(model.riders);
        model.line.resume(&mut motion.line);
        motion.line.awake = (0..model.line.islands.len()).collect();
        self.let_sleep(model);
        Ok(())
    }

    fn walk(&mut self, model: &Model<'_, DIM, D>, walk: &mut Archive<'_>) -> Done {
        let lanes = &model.at(self.present.as_deref()).line.lanes;
        let motion = &mut self.motion;
        motion.line.walk(walk)?;
        walk.numbers("link_correction", motion.unilateral.correction.iter_mut())?;
        walk.numbers("contact_force", motion.unilateral.force.iter_mut())?;
        walk.numbers("datum", std::iter::once(&mut motion.datum))?;
        walk_contacts(&mut motion.contacts, walk, lanes)?;
        let riders = motion.riders.iter_mut().zip(&mut motion.start_u);
        for (number, (rider, start)) in riders.enumerate() {
            walk_rider(rider, start, walk, &format!("rider_{number}"))?;
        }
        let Some(recorder) = &mut self.recorder else {
            return Ok(());
        };
        walk_record(&mut recorder.record, walk)?;
        match &mut recorder.books {
            Some(books) => books.walk(walk),
            None => Ok(()),
        }
    }
}

fn walk_contacts<const DIM: usize>(
    contacts: &mut Contacts<DIM>,
    walk: &mut Archive<'_>,
    lanes: &[Slideline<DIM>],
) -> Done {
    let all = &mut contacts.all;
    walk.flags("contact_meets", all.iter_mut().map(|c| &mut c.meets))?;
    walk.numbers("contact_lateral", all.iter_mut().map(|c| &mut c.lateral))?;
    // A place follows from its element and its shape functions.
    let elements = all.iter_mut().map(|c| &mut c.ends[1].element);
    walk.counts("contact_element", elements)?;
    let weights = all.iter_mut().flat_map(|c| &mut c.ends[1].weights);
    walk.numbers("contact_weights", weights)?;
    for contact in all {
        let end = &mut contact.ends[1];
        let place = lanes[contact.of[2]].at(end.element, end.weights);
        *end = place.ok_or_else(|| refuse("contact_element", "is no element"))?;
    }
    Ok(())
}

fn walk_rider(
    rider: &mut PantographState,
    start: &mut [f64],
    walk: &mut Archive<'_>,
    prefix: &str,
) -> Done {
    let name = |part: &str| format!("{prefix}_{part}");
    walk.numbers(&name("displacement"), rider.u.iter_mut())?;
    walk.numbers(&name("velocity"), rider.v.iter_mut())?;
    walk.numbers(&name("acceleration"), rider.a.iter_mut())?;
    walk.numbers(&name("start"), start.iter_mut())?;
    let rest = [
        &mut rider.preload,
        &mut rider.drive.now,
        &mut rider.actuator.force,
    ];
    walk.numbers(&name("preload_ground_actuator"), rest.into_iter())?;
    walk_waiting(&mut rider.actuator, walk, &name("waiting"))?;
    // Stops are measured from the start.
    let closed = rider.kinks.iter_mut().map(|k| &mut k.closed);
    walk.numbers(&name("kink_closed"), closed)?;
    let force = rider.kinks.iter_mut().map(|k| &mut k.force);
    walk.numbers(&name("kink_force"), force)?;
    let ranges = rider.laws.iter_mut().flat_map(|l| &mut l.range);
    walk.numbers(&name("law_range"), ranges)?;
    let mut right: Vec<bool> = rider.laws.iter().map(|l| l.side == Branch::Right).collect();
    walk.flags(&name("law_right"), right.iter_mut())?;
    for (law, right) in right.into_iter().enumerate() {
        rider.enter(law, if right { Branch::Right } else { Branch::Left });
    }
    Ok(())
}

/// Forces that wait: step and force of each, one after the other.
fn walk_waiting(actuator: &mut ActuatorState, walk: &mut Archive<'_>, name: &str) -> Done {
    let waiting = &mut actuator.waiting;
    let pairs = waiting.iter().flat_map(|&(due, force)| [due as f64, force]);
    let mut list = pairs.collect();
    walk.list(name, &mut list)?;
    if list.len() % 2 == 1 {
        return Err(refuse(name, "has a step without a force"));
    }
    waiting.clear();
    for pair in list.chunks_exact(2) {
        waiting.push_back((count(name, pair[0])?, pair[1]));
    }
    Ok(())
}

fn walk_record(record: &mut Record, walk: &mut Archive<'_>) -> Done {
    walk.numbers("link_min", record.link_min.iter_mut())?;
    walk.numbers("link_max", record.link_max.iter_mut())?;
    walk.numbers("uplift_max", record.uplift_max.iter_mut())?;
    walk.numbers("stop_max", record.stop_max.iter_mut())?;
    let counts = [
        &mut record.slack_max,
        &mut record.pivots,
        &mut record.pivots_max,
        &mut record.fallbacks,
    ];
    walk.counts("slack_pivots_fallbacks", counts.into_iter())?;
    let largest = [
        &mut record.lcp_residual,
        &mut record.energy_residual,
        &mut record.energy_turnover,
        &mut record.energy_switching,
    ];
    walk.numbers("residuals_turnover", largest.into_iter())?;
    let mut pivots: Vec<f64> = record.pivot_counts.iter().map(|&n| n as f64).collect();
    walk.list("pivot_counts", &mut pivots)?;
    let counts = pivots.into_iter().map(|n| count("pivot_counts", n));
    record.pivot_counts = counts.collect::<Result<_, _>>()?;
    Ok(())
}

impl<const DIM: usize> Contacts<DIM> {
    /// Read the strips where the wires lay in the last step.
    fn go_on(&mut self, riders: &[Pantograph]) {
        for contact in &mut self.all {
            let strip = &riders[contact.of[0]].strips[contact.of[1]];
            contact.read(strip);
        }
    }
}
