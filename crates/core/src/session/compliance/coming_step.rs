//! Solution of the coming step without taking it, and what is read from it.

use crate::constraint::contacts::Contact;
use crate::constraint::row::{OnWires, Row};
use crate::error::CoreError;
use crate::linalg::dense;
use crate::session::compliance::Compliance;
use crate::session::{Session, step_inputs};
use crate::simulation::step::solve;

impl<const DIM: usize, const D: usize> Session<DIM, D> {
    /// Finds the wire at the collectors in the coming step, which is to end at `position` (m) with
    /// `speed` (m/s), about the forces of the step before. It takes about as long as a step,
    /// allocates nothing, and changes no later step.
    ///
    /// # Errors
    /// [`CoreError::Input`] where no forces are given, or any [`CoreError`] that a step can raise.
    pub fn compliance(&mut self, position: f64, speed: f64) -> Result<&Compliance, CoreError> {
        self.compliance.about.clone_from(&self.collectors.forces);
        self.find_compliance(position, speed)
    }

    /// Finds the wire as [`Session::compliance`] does, about other forces, N: those that a program
    /// outside has found from it, when it asks again until they stay.
    ///
    /// # Errors
    /// [`CoreError::Input`] where no forces are given, or for forces that are not finite or not one
    /// for each collector; or any [`CoreError`] that a step can raise.
    pub fn compliance_about(
        &mut self,
        forces: &[f64],
        position: f64,
        speed: f64,
    ) -> Result<&Compliance, CoreError> {
        let is_finite = forces.iter().all(|force| force.is_finite());
        if forces.len() != self.collectors.all.len() || !is_finite {
            let reason = "not one for each collector, or not finite";
            return Err(CoreError::invalid("forces", reason));
        }
        self.compliance.about.copy_from_slice(forces);
        self.find_compliance(position, speed)
    }

    fn find_compliance(&mut self, position: f64, speed: f64) -> Result<&Compliance, CoreError> {
        if self.collectors.all.is_empty() {
            let reason = "none: compliance is that at collectors with given forces";
            return Err(CoreError::invalid("collectors", reason));
        }
        if !position.is_finite() || !speed.is_finite() {
            return Err(CoreError::invalid("position", "not finite"));
        }
        let (work, motion) = (&mut self.compliance, &self.state.motion);
        work.forces.copy_from_slice(&self.collectors.forces);
        work.correction.copy_from_slice(&motion.problem.correction);
        work.points.copy_from_slice(&self.collectors.points);
        let found = self.try_step(position, speed);
        let (work, motion) = (&mut self.compliance, &mut self.state.motion);
        motion.problem.correction.copy_from_slice(&work.correction);
        self.collectors.points.copy_from_slice(&work.points);
        self.collectors.forces.copy_from_slice(&work.forces);
        self.model.line.undo_prediction(&mut motion.wires);
        found.map(|()| &self.compliance.result)
    }

    /// Solves the coming step under the forces about which it is linear, without taking it, and
    /// reads the wire at the collectors.
    fn try_step(&mut self, position: f64, speed: f64) -> Result<(), CoreError> {
        let about = std::mem::take(&mut self.compliance.about);
        let tried = self.solve_step(&about, position, speed);
        self.compliance.about = about;
        tried?;
        self.find_matrix();
        self.find_free_heights();
        Ok(())
    }

    fn solve_step(&mut self, forces: &[f64], position: f64, speed: f64) -> Result<(), CoreError> {
        let positions = self.positions(position);
        self.set_forces(forces, positions)?;
        let speed = self.at_balance(self.speed, speed);
        let inputs = step_inputs(&self.collectors, positions, speed);
        solve(&self.model.borrow(), &inputs, &mut self.state)?;
        let slideline = &self.model.line.slidelines[0];
        let pairs = self
            .compliance
            .contacts
            .iter_mut()
            .zip(&self.collectors.points);
        for (contact, point) in pairs {
            (contact.point, contact.compliance) = (*point, slideline.compliance_at(point));
        }
        Ok(())
    }

    /// Finds W.
    fn find_matrix(&mut self) {
        let (line, problem) = (&*self.model.line, &self.state.motion.problem);
        let work = &mut self.compliance;
        let keep = line.coefficients.stiffness;
        let is_slack = |&&link: &&usize| problem.correction[link] > 0.0;
        let slack = || problem.links.iter().filter(is_slack);
        let link_row = |&link: &usize| Row::link(line, link, (0.0, 0.0));
        let n = work.contacts.len();
        let size = slack().count();
        work.slack_matrix.clear();
        for (i, a) in slack().enumerate() {
            let row = link_row(a);
            for (j, b) in slack().enumerate() {
                let entry = if i == j {
                    row.diagonal(line)
                } else {
                    row.coupling(&link_row(b), line)[0]
                };
                work.slack_matrix.push(entry);
            }
        }
        for source in 0..n {
            let contact = contact_row(&work.contacts[source]);
            work.copy.clear();
            work.copy.extend_from_slice(&work.slack_matrix);
            work.column.clear();
            let opened = slack().map(|link| link_row(link).coupling(&contact, line)[0]);
            work.column.extend(opened);
            // The matrix is positive definite: see the problem of a step.
            let is_regular = size == 0 || dense::solve_in_place(&mut work.copy, &mut work.column);
            debug_assert!(is_regular, "slack links are independent");
            for target in 0..n {
                let row = contact_row(&work.contacts[target]);
                let direct = if target == source {
                    row.diagonal(line)
                } else {
                    row.coupling(&contact, line)[0]
                };
                let through = slack()
                    .zip(&work.column)
                    .map(|(link, correction)| row.coupling(&link_row(link), line)[0] * correction);
                work.result.matrix[target * n + source] = keep * (direct - through.sum::<f64>());
            }
        }
    }

    /// Finds z₀ from the heights of the step that was solved.
    fn find_free_heights(&mut self) {
        let (line, motion) = (&*self.model.line, &self.state.motion);
        let model = self.model.borrow();
        let work = &mut self.compliance;
        let (keep, n) = (line.coefficients.stiffness, work.contacts.len());
        for (target, contact) in work.contacts.iter().enumerate() {
            let [u, delta] = motion.wires.at_balance();
            let place = &contact.point;
            let mesh = place.height
                + place.displacement(&u, DIM - 1)
                + keep * place.displacement(&delta, DIM - 1);
            let corrected = contact.compliance.links();
            let corrected = corrected.map(|(link, rise)| rise * motion.problem.correction[link]);
            let mut height = mesh
                + contact.compliance.static_height
                + motion.raised_by_links(&model, &contact.compliance, keep)
                + corrected.sum::<f64>();
            for (source, force) in work.about.iter().enumerate() {
                height += force * line.residual_compliance(contact, &work.contacts[source]);
                height -= force * work.result.matrix[target * n + source];
            }
            work.result.free_height[target] = height;
        }
    }
}

/// Row of a contact that presses with a given force.
fn contact_row<const DIM: usize>(contact: &Contact<DIM>) -> Row<'_, DIM> {
    Row {
        wires: OnWires::Contact(contact),
        pantograph: None,
        sign: 1.0,
        compliance: 0.0,
        free: 0.0,
        force: 0.0,
    }
}
