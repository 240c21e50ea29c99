//! Errors of the core, each variant with the numbers that explain it.

use crate::lcp::LcpFailure;

/// Failure of a computation of the core. The caller translates indices into names.
#[derive(Debug, Clone, thiserror::Error)]
pub enum CoreError {
    /// The arrays that describe the problem contradict each other.
    #[error("input array {array}: {reason}")]
    Input {
        /// Name of the array.
        array: &'static str,
        /// Reason why it is refused.
        reason: String,
    },
    /// Explicit steps are longer than is stable.
    #[error("explicit steps of {step} s: the longest stable one is {longest:.3e} s")]
    StepTooLong {
        /// Time step, s.
        step: f64,
        /// Longest stable time step, s, four figures.
        longest: f64,
    },
    /// A pivot of a factorisation vanished: the structure can move without force.
    #[error("the stiffness of node {node} vanishes: the structure is loose there")]
    Singular {
        /// Node whose pivot block is singular.
        node: usize,
    },
    /// The equilibrium found would not hold: a small push moves the structure away from it.
    #[error("the equilibrium is unstable in {directions} directions")]
    Unstable {
        /// Number of negative pivots of the tangent stiffness.
        directions: usize,
    },
    /// Newton's method for the static equilibrium did not converge.
    #[error(
        "no static equilibrium after {iterations} iterations: largest residual {residual:.3e} N \
         at node {node} (allowed {tolerance:.1e} N)"
    )]
    NoEquilibrium {
        /// Iterations done.
        iterations: usize,
        /// Largest force that is not balanced, N (or N·m for slopes).
        residual: f64,
        /// Node where it acts.
        node: usize,
        /// Largest residual accepted, N.
        tolerance: f64,
    },
    /// A link whose length was to be found would have to push.
    #[error("link {link} would have to push with {force:.3} N to hold the given position")]
    PushingLink {
        /// Index of the link.
        link: usize,
        /// Tension of the link (negative), N.
        force: f64,
    },
    /// A table ends before a pantograph is in equilibrium at the start.
    #[error(
        "table {table} of pantograph {pantograph} ends at {end} m, the start is at {displacement} m"
    )]
    BeyondTable {
        /// Index of the pantograph.
        pantograph: usize,
        /// Index of the table among the piecewise linear forces.
        table: usize,
        /// Displacement in equilibrium if the table continued, m.
        displacement: f64,
        /// Displacement at the end of the table, m.
        end: f64,
    },
    /// The controller of an actuator gave no force.
    #[error("no force for pantograph {pantograph} in step {step} (t = {time:.6} s): {reason}")]
    Control {
        /// Index of the pantograph.
        pantograph: usize,
        /// Step number.
        step: usize,
        /// Time, s.
        time: f64,
        /// Position of the pantograph, m.
        position: f64,
        /// Reason given by the controller.
        reason: String,
    },
    /// The program that moves an external pantograph failed, or gave no sound motion.
    #[error(
        "no motion of external pantograph {pantograph} in step {step} (t = {time:.6} s): {reason}"
    )]
    External {
        /// Index of the pantograph.
        pantograph: usize,
        /// Step number.
        step: usize,
        /// Time, s.
        time: f64,
        /// Position of the pantograph, m.
        position: f64,
        /// Reason given by the program, or why its motion is refused.
        reason: String,
    },
    /// A number became infinite or not a number.
    #[error("not a finite number in {what} at step {step}")]
    NotFinite {
        /// Quantity concerned.
        what: &'static str,
        /// Number of the step after which it was noticed.
        step: usize,
    },
    /// The energy balance does not close.
    #[error(
        "the energy balance does not close in step {step} (t = {time:.6} s): {what} of \
         {off:.3e} J, {turnover:.3e} J were turned over"
    )]
    Balance {
        /// Term: `residual`, `damping` that gives energy, or `switching`.
        what: &'static str,
        /// Step number.
        step: usize,
        /// Time at the end of the step, s.
        time: f64,
        /// Error of the term, J.
        off: f64,
        /// Energy turned over or stored so far, J.
        turnover: f64,
    },
    /// The wire that contacts run along no longer runs forwards: the motion has grown out of
    /// bounds.
    #[error("the wire folds back on itself in step {step}")]
    Folded {
        /// Step number.
        step: usize,
    },
    /// The complementarity problem of a step has no verified solution.
    #[error("the contact problem of step {step} (t = {time:.6} s) could not be solved: {failure}")]
    Lcp {
        /// Step number.
        step: usize,
        /// Time, s.
        time: f64,
        /// Contacts in the problem: pantograph, strip, slideline.
        contacts: Vec<[usize; 3]>,
        /// Links in the problem by index, in the rows after the contacts.
        links: Vec<usize>,
        /// Number of stops of each pantograph, in the rows after the links.
        stops: Vec<usize>,
        /// Complementarity problem and the reason of its failure.
        failure: Box<LcpFailure>,
    },
    /// The set of slack links did not settle within a step.
    #[error("the set of slack links did not settle in step {step} (t = {time:.6} s)")]
    SlackSet {
        /// Step number.
        step: usize,
        /// Time, s.
        time: f64,
    },
    /// A strip of a pantograph is where no slideline has wire.
    #[error("pantograph {pantograph} left the wire at {position:.3} m in step {step}")]
    OffWire {
        /// Index of the pantograph.
        pantograph: usize,
        /// Position along the track, m.
        position: f64,
        /// Step number.
        step: usize,
    },
    /// All wires are beyond the ends of a strip of a pantograph.
    #[error(
        "the wire leaves pantograph {pantograph} sideways at {position:.3} m in step {step}: \
         {lateral:.3} m off the middle of a strip that reaches {half_width:.3} m"
    )]
    OutOfReach {
        /// Index of the pantograph.
        pantograph: usize,
        /// Position of the strip along the track, m.
        position: f64,
        /// Lateral position of the nearest wire, m.
        lateral: f64,
        /// Half width of the strip, m.
        half_width: f64,
        /// Step number.
        step: usize,
    },
    /// The caller asked to stop.
    #[error("cancelled at step {step}")]
    Cancelled {
        /// Number of steps done.
        step: usize,
    },
}

impl CoreError {
    /// Refuses an input array, with what is wrong with it.
    pub(crate) fn invalid(array: &'static str, reason: impl Into<String>) -> Self {
        let reason = reason.into();
        Self::Input { array, reason }
    }

    /// Tells whether a function that the run calls has ended it.
    #[must_use]
    pub fn is_ended_from_outside(&self) -> bool {
        matches!(
            self,
            Self::Cancelled { .. } | Self::Control { .. } | Self::External { .. }
        )
    }

    /// Sets the index of the pantograph concerned.
    pub(crate) fn of_pantograph(mut self, number: usize) -> Self {
        if let Self::BeyondTable { pantograph, .. } = &mut self {
            *pantograph = number;
        }
        self
    }
}
