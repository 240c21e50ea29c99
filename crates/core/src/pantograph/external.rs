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

use crate::pantograph::excitation::Excitation;
use crate::pantograph::model::Pantograph;
use crate::pantograph::state::PantographState;
use crate::pantograph::strip::Strip;

/// Deviation of a compliance matrix from symmetry, and from positive semi-definiteness, that is
/// accepted as a share of its largest entry: differences of a program's results have it. The
/// problem of a step has one solution all the same, as wires add some 10 µm/N and more.
const COMPLIANCE_ROUNDING: f64 = 1e-6;

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

impl PantographState {
    /// Sets the motion of the coming step: heights above the datum at its end without contact
    /// forces, m, and the compliance, m/N, row by row. After a refusal nothing has changed.
    ///
    /// # Errors
    /// A reason.
    pub(crate) fn set_external_motion(
        &mut self,
        heights: &[f64],
        datum: f64,
        compliance: &[f64],
    ) -> Result<(), String> {
        let n = self.u.len();
        if heights.len() != n || compliance.len() != n * n {
            return Err(format!(
                "{} heights and {} compliances, expected {n} and {}",
                heights.len(),
                compliance.len(),
                n * n
            ));
        }
        if let Some(height) = heights.iter().find(|z| !z.is_finite()) {
            return Err(format!("the height is {height} m"));
        }
        check_compliance(compliance, n, &mut self.external.work)?;
        for (free, height) in self.external.free.iter_mut().zip(heights) {
            *free = height - datum;
        }
        self.set_response(compliance);
        Ok(())
    }

    /// Replaces the predicted heights above the datum at the end of the step by those that the
    /// program has reached, m.
    ///
    /// # Errors
    /// A reason.
    pub(crate) fn set_reached_heights(
        &mut self,
        heights: &[f64],
        datum: f64,
    ) -> Result<(), String> {
        if let Some(height) = heights.iter().find(|z| !z.is_finite()) {
            return Err(format!("the height is {height} m"));
        }
        for ((delta, u), height) in self.delta.iter_mut().zip(&self.u).zip(heights) {
            *delta = height - datum - u;
        }
        Ok(())
    }

    /// Writes the heights at the end of the step, in the datum of the line, m.
    pub(crate) fn write_heights(&self, datum: f64, out: &mut [f64]) {
        for ((out, u), delta) in out.iter_mut().zip(&self.u).zip(&self.delta) {
            *out = datum + u + delta;
        }
    }

    /// Commits the increment of an external pantograph in a step of `h` s.
    pub(crate) fn commit_external(&mut self, h: f64) {
        for ((u, v), delta) in self.u.iter_mut().zip(&mut self.v).zip(&self.delta) {
            *u += delta;
            *v = delta / h;
        }
    }
}

/// Refuses a matrix that is not symmetric and positive semi-definite up to rounding; `work` has
/// room for it.
fn check_compliance(s: &[f64], n: usize, work: &mut [f64]) -> Result<(), String> {
    if let Some(value) = s.iter().find(|v| !v.is_finite()) {
        return Err(format!("the compliance is {value} m/N"));
    }
    let largest = s.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    let tolerance = COMPLIANCE_ROUNDING * largest;
    for i in 0..n {
        for j in 0..i {
            let [lower, upper] = [s[i * n + j], s[j * n + i]];
            if (lower - upper).abs() > tolerance {
                return Err(format!(
                    "the compliance is not symmetric: {lower} and {upper} m/N"
                ));
            }
        }
    }
    // Cholesky's pivots of S + tolerance · 1.
    for i in 0..n {
        for j in 0..=i {
            let known: f64 = (0..j).map(|k| work[i * n + k] * work[j * n + k]).sum();
            let reduced = 0.5 * (s[i * n + j] + s[j * n + i]) - known;
            if i != j {
                work[i * n + j] = reduced / work[j * n + j];
            } else if reduced + tolerance > 0.0 {
                work[i * n + i] = (reduced + tolerance).sqrt();
            } else if largest > 0.0 {
                return Err("the compliance is negative for some forces".into());
            } else {
                work[i * n + i] = 1.0;
            }
        }
    }
    Ok(())
}
