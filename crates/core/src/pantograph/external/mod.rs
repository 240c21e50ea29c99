//! External pantograph: its strips move as a program outside says.
//!
//! Its coordinates are the heights z of its strips (or of any points that the
//! [vectors of its strips](crate::pantograph::strip) combine), m. At the end of a step they are
//!
//!   z = z₀ − S λ̂,   λ̂ = Σ e λ
//!
//! with z₀ the heights at the end of the step if nothing presses during it, S the compliance of the
//! step, m/N, symmetric and positive semi-definite, and λ the contact forces of the step, which are
//! constant in it. That is Δu = Δu₀ − A_p⁻¹ e λ of any pantograph with A_p⁻¹ = S and
//! Δu₀ = z₀ − uₙ, so it joins the [problem](crate::constraint::problem) of the step as eᵀS e, and
//! contact is as stiff as inside. At the time of balance the scheme weighs old and new as it does
//! everywhere:
//!
//!   z_f = (1 − α_f) z + α_f uₙ
//!
//! The program may report other heights than z₀ − S λ̂ when it knows the forces: they are
//! the state, and the contact law then holds up to the difference. Velocity is the increment per
//! step length; there is no acceleration. Nothing is stored in such a pantograph: λ̂ᵀ Δu is work
//! from outside.

mod motion;

use crate::pantograph::excitation::Excitation;
use crate::pantograph::model::Pantograph;
use crate::pantograph::strip::Strip;

/// Instant before a step at which a program outside is asked.
#[derive(Debug, Clone, Copy)]
pub struct StepStart {
    /// Number of the step, from 0.
    pub step: usize,
    /// Time at its start, s.
    pub time: f64,
    /// Position of the pantograph along the track then, m.
    pub position: f64,
    /// Speed then, m/s.
    pub speed: f64,
}

/// Program outside that moves the external pantographs of a run. Heights are in the datum of the
/// line, as its nodes are (above the rail), m. An error is a reason, which ends the run.
pub trait Outside {
    /// Receives the heights of a pantograph, given by its number, and the generalised contact
    /// forces Σ e λ, N, in equilibrium at the start of the run.
    ///
    /// # Errors
    /// A reason.
    fn begin(&mut self, pantograph: usize, heights: &[f64], forces: &[f64]) -> Result<(), String>;

    /// Writes the heights z₀ at the end of the coming step if nothing presses, m, and the
    /// compliance S of the step, m/N, row by row.
    ///
    /// # Errors
    /// A reason.
    fn predict(
        &mut self,
        pantograph: usize,
        start: &StepStart,
        heights: &mut [f64],
        compliance: &mut [f64],
    ) -> Result<(), String>;

    /// Takes the step under the generalised contact forces Σ e λ, N; writes the heights at its
    /// end, m. They are z₀ − S λ̂ when it is called.
    ///
    /// # Errors
    /// A reason.
    fn advance(
        &mut self,
        pantograph: usize,
        forces: &[f64],
        heights: &mut [f64],
    ) -> Result<(), String>;
}

/// Program outside of runs without external pantographs.
#[derive(Debug, Default)]
pub struct Nobody;

impl Nobody {
    fn answer<T>() -> Result<T, String> {
        Err("nobody moves it".into())
    }
}

impl Outside for Nobody {
    fn begin(&mut self, _: usize, _: &[f64], _: &[f64]) -> Result<(), String> {
        Self::answer()
    }

    fn predict(
        &mut self,
        _: usize,
        _: &StepStart,
        _: &mut [f64],
        _: &mut [f64],
    ) -> Result<(), String> {
        Self::answer()
    }

    fn advance(&mut self, _: usize, _: &[f64], _: &mut [f64]) -> Result<(), String> {
        Self::answer()
    }
}

/// Part of the state that external pantographs alone have.
#[derive(Debug, Clone, Default)]
pub(crate) struct ExternalState {
    /// Displacements z₀ at the end of the step without contact forces, m.
    pub(crate) free: Vec<f64>,
    /// Generalised contact forces Σ e λ of the step, N.
    pub(crate) load: Vec<f64>,
    /// Workspace of n × n numbers.
    work: Vec<f64>,
}

impl ExternalState {
    pub(crate) fn new(n: usize) -> Self {
        Self {
            free: vec![0.0; n],
            load: vec![0.0; n],
            work: vec![0.0; n * n],
        }
    }
}

impl Pantograph {
    /// External pantograph of `n` coordinates, the heights that the vectors of its `strips`
    /// combine; `start_force` is the sum of its contact forces at the start, N. There all
    /// coordinates have one height.
    #[must_use]
    pub fn external(strips: Vec<Strip>, n: usize, start_force: f64) -> Self {
        let matrix = vec![0.0; n * n];
        Self {
            mass: matrix.clone(),
            damping: matrix.clone(),
            stiffness: matrix,
            strips,
            // The level of the start is the mean of the coordinates.
            preload: vec![1.0 / n as f64; n],
            lift: vec![0.0; n],
            start_force,
            excitation: Excitation::default(),
            stops: Vec::new(),
            piecewise_forces: Vec::new(),
            actuator: None,
            is_external: true,
        }
    }

    /// Tells whether nothing inside acts on an external pantograph.
    pub(crate) fn is_free_of_inner_forces(&self) -> bool {
        let mut numbers = [&self.mass, &self.damping, &self.stiffness, &self.lift]
            .into_iter()
            .flatten();
        numbers.all(|v| *v == 0.0)
            && self.excitation.forces.is_empty()
            && self.excitation.base.is_none()
            && self.stops.is_empty()
            && self.piecewise_forces.is_empty()
            && self.actuator.is_none()
    }
}
