//! External pantographs of a run: a program outside is asked before each step, and learns the
//! forces of it.

use crate::error::CoreError;
use crate::pantograph::external::{Outside, StepStart};
use crate::simulation::model::Model;
use crate::simulation::motion::Motion;

impl<const DIM: usize, const D: usize> Motion<DIM, D> {
    /// Sets the motion of an external pantograph in the coming step: heights z₀ at its end, m, and
    /// compliance S, m/N.
    ///
    /// # Errors
    /// A reason.
    pub(crate) fn set_external(
        &mut self,
        number: usize,
        heights: &[f64],
        compliance: &[f64],
    ) -> Result<(), String> {
        let pantograph = &mut self.pantographs[number];
        pantograph.set_external_motion(heights, self.datum, compliance)?;
        self.contacts.update_columns(number, pantograph);
        Ok(())
    }

    /// Sums the generalised contact forces Σ e λ of external pantographs, N.
    pub(crate) fn sum_external_loads(&mut self) {
        for pantograph in &mut self.pantographs {
            pantograph.external.load.fill(0.0);
        }
        for (contact, force) in self.contacts.all.iter().zip(&self.problem.force) {
            if contact.is_active {
                let load = &mut self.pantographs[contact.pantograph()].external.load;
                let shares = load.iter_mut().zip(&contact.vector);
                shares.for_each(|(load, e)| *load += force * e);
            }
        }
    }
}

/// Numbers that are exchanged with a program outside about one pantograph.
#[derive(Debug)]
struct Exchange {
    number: usize,
    heights: Vec<f64>,
    compliance: Vec<f64>,
}

/// External pantographs of a run.
pub(crate) struct ExternalPantographs {
    exchanges: Vec<Exchange>,
}

impl ExternalPantographs {
    /// Returns the external ones among the pantographs of a run.
    pub(crate) fn new<const DIM: usize, const D: usize>(model: &Model<'_, DIM, D>) -> Self {
        let external = model.pantographs.iter().enumerate();
        let exchanges = external
            .filter(|(_, pantograph)| pantograph.is_external)
            .map(|(number, pantograph)| Exchange {
                number,
                heights: vec![0.0; pantograph.size()],
                compliance: vec![0.0; pantograph.size().pow(2)],
            });
        Self {
            exchanges: exchanges.collect(),
        }
    }

    /// Returns whether there are none.
    pub(crate) fn is_empty(&self) -> bool {
        self.exchanges.is_empty()
    }

    /// Tells the program where its pantographs stand at the start, with the first pantograph at a
    /// position (m) and speed (m/s).
    ///
    /// # Errors
    /// [`CoreError::External`].
    pub(crate) fn begin<const DIM: usize, const D: usize>(
        &mut self,
        model: &Model<'_, DIM, D>,
        motion: &mut Motion<DIM, D>,
        at: (f64, f64),
        program: &mut dyn Outside,
    ) -> Result<(), CoreError> {
        motion.sum_external_loads();
        self.each(model, motion, at, |exchange, _, motion| {
            let pantograph = &motion.pantographs[exchange.number];
            pantograph.write_heights(motion.datum, &mut exchange.heights);
            program.begin(
                exchange.number,
                &exchange.heights,
                &pantograph.external.load,
            )
        })
    }

    /// Asks for the motion of the coming step.
    ///
    /// # Errors
    /// [`CoreError::External`].
    pub(crate) fn predict<const DIM: usize, const D: usize>(
        &mut self,
        model: &Model<'_, DIM, D>,
        motion: &mut Motion<DIM, D>,
        at: (f64, f64),
        program: &mut dyn Outside,
    ) -> Result<(), CoreError> {
        self.each(model, motion, at, |exchange, start, motion| {
            let Exchange {
                number,
                heights,
                compliance,
            } = exchange;
            program.predict(*number, start, heights, compliance)?;
            motion.set_external(*number, heights, compliance)
        })
    }

    /// Passes the forces of the step on, and takes over the heights that they lead to.
    ///
    /// # Errors
    /// [`CoreError::External`].
    pub(crate) fn advance<const DIM: usize, const D: usize>(
        &mut self,
        model: &Model<'_, DIM, D>,
        motion: &mut Motion<DIM, D>,
        at: (f64, f64),
        program: &mut dyn Outside,
    ) -> Result<(), CoreError> {
        self.each(model, motion, at, |exchange, _, motion| {
            let Exchange {
                number, heights, ..
            } = exchange;
            let (datum, pantograph) = (motion.datum, &mut motion.pantographs[*number]);
            pantograph.write_heights(datum, heights);
            program.advance(*number, &pantograph.external.load, heights)?;
            pantograph.set_reached_heights(heights, datum)
        })
    }

    /// Exchanges numbers about each pantograph: what is exchanged is given the start of the step.
    fn each<const DIM: usize, const D: usize>(
        &mut self,
        model: &Model<'_, DIM, D>,
        motion: &mut Motion<DIM, D>,
        at: (f64, f64),
        mut exchange_numbers: impl FnMut(
            &mut Exchange,
            &StepStart,
            &mut Motion<DIM, D>,
        ) -> Result<(), String>,
    ) -> Result<(), CoreError> {
        for exchange in &mut self.exchanges {
            let start = step_start(model, motion, exchange.number, at);
            let done = exchange_numbers(exchange, &start, motion);
            done.map_err(|reason| failure(exchange.number, &start, reason))?;
        }
        Ok(())
    }
}

fn step_start<const DIM: usize, const D: usize>(
    model: &Model<'_, DIM, D>,
    motion: &Motion<DIM, D>,
    number: usize,
    (position, speed): (f64, f64),
) -> StepStart {
    StepStart {
        step: motion.steps,
        time: motion.steps as f64 * model.wires.h,
        position: position - model.distances[number],
        speed,
    }
}

fn failure(pantograph: usize, start: &StepStart, reason: String) -> CoreError {
    CoreError::External {
        pantograph,
        step: start.step,
        time: start.time,
        position: start.position,
        reason,
    }
}
