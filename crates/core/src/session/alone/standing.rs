//! Pantographs of a session as pantographs by themselves.

use crate::pantograph::model::Pantograph;
use crate::session::Session;
use crate::session::alone::start::AloneStart;

impl<const DIM: usize, const D: usize> Session<DIM, D> {
    /// Simulated pantograph by its number, and its start by itself where it stands now: displaced,
    /// with the contact forces that it has. It is at rest there only before the first step.
    #[must_use]
    pub fn standing_alone(&self, number: usize) -> Option<(Pantograph, AloneStart)> {
        let (motion, model) = (&self.state.motion, self.model.pantographs.get(number)?);
        let state = motion.pantographs.get(number)?;
        let mut start = AloneStart {
            displacements: state.u.clone(),
            preload: state.preload,
            datum: motion.datum,
            forces: vec![0.0; model.strips.len()],
            laterals: vec![0.0; model.strips.len()],
        };
        for (contact, force) in motion.contacts.all.iter().zip(&motion.problem.force) {
            let [pantograph, strip, _] = contact.indices;
            if pantograph == number && contact.has_wire {
                start.forces[strip] += force;
                start.laterals[strip] = contact.lateral;
            }
        }
        Some((model.clone(), start))
    }
}
