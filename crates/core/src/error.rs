//! What can go wrong in the core, each variant with the numbers that explain it.

use crate::lcp::LcpFailure;

/// Failure of a computation of the core. The caller translates indices into names.
#[derive(Debug, Clone, thiserror::Error)]
pub enum CoreError {
    /// The arrays that describe the problem contradict each other.
    #[error("input array {array}: {reason}")]
    Input {
        /// Name of the array.
        array: &'static str,
        /// What is wrong with it.
        reason: String,
    },
    /// Explicit steps are longer than is stable.
    #[error("explicit steps of {step} s: the longest stable one is {longest:.3e} s")]
    StepTooLong {
        /// Time step, s.
        step: f64,
        /// Longest stable one, s, four figures.
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
        /// Where it acts.
        node: usize,
        /// Largest residual accepted, N.
        tolerance: f64,
    },
    /// A link whose length was to be found would have to push.
    #[error("link {link} would have to push with {force:.3} N to hold the given position")]
    PushingLink {
        /// Index of the link.
        link: usize,
        /// Its (negative) tension, N.
        force: f64,
    },
    /// A table ends before a rider is in equilibrium at the start.
    #[error("table {table} of rider {rider} ends at {end} m, the start is at {place} m")]
    BeyondTable {
        /// Index of the rider.
        rider: usize,
        /// Index of the table among its laws.
        table: usize,
        /// Displacement in equilibrium if the table went on, m.
        place: f64,
        /// Where it ends, m.
        end: f64,
    },
    /// The force of an actuator was asked for and not given.
    #[error("no force for rider {rider} in step {step} (t = {time:.6} s): {reason}")]
    Control {
        /// Index of the rider.
        rider: usize,
        /// Step number.
        step: usize,
        /// Time, s.
        time: f64,
        /// Position of the rider, m.
        position: f64,
        /// Why.
        reason: String,
    },
    /// A number became infinite or not a number.
    #[error("not a finite number in {what} at step {step}")]
    NotFinite {
        /// Quantity concerned.
        what: &'static str,
        /// Step at which it was noticed.
        step: usize,
    },
    /// The energy ledger does not close.
    #[error(
        "the energy balance does not close in step {step} (t = {time:.6} s): {what} of {off:.3e} J, \
         {turnover:.3e} J were turned over"
    )]
    Balance {
        /// `residual`, `damping` that gives energy, or `switching`.
        what: &'static str,
        /// Step number.
        step: usize,
        /// Time at its end, s.
        time: f64,
        /// How much, J.
        off: f64,
        /// Energy turned over or stored so far, J.
        turnover: f64,
    },
    /// The wire that contacts run along no longer runs forwards: the motion has grown out of bounds.
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
        /// Contacts in the problem: rider, strip, lane.
        contacts: Vec<[usize; 3]>,
        /// Links in the problem, by index, after the contacts.
        links: Vec<usize>,
        /// Number of stops of each rider; they stand behind the links.
        stops: Vec<usize>,
        /// The problem itself and why it failed.
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
    /// A strip of a rider stands where no lane has wire.
    #[error("rider {rider} left the wire at {position:.3} m in step {step}")]
    OffWire {
        /// Index of the rider.
        rider: usize,
        /// Position along the track, m.
        position: f64,
        /// Step number.
        step: usize,
    },
    /// All wires lie beyond the ends of a rider's strips.
    #[error(
        "the wire leaves rider {rider} sideways at {position:.3} m in step {step}: {lateral:.3} m off \
         the middle of a strip that reaches {half_width:.3} m"
    )]
    OutOfReach {
        /// Index of the rider.
        rider: usize,
        /// Position of the strip along the track, m.
        position: f64,
        /// Lateral place of the wire least far out, m.
        lateral: f64,
        /// Half width of the strip, m.
        half_width: f64,
        /// Step number.
        step: usize,
    },
    /// The caller asked to stop.
    #[error("cancelled at step {step}")]
    Cancelled {
        /// Steps done.
        step: usize,
    },
}

impl CoreError {
    /// The same error with the number of the rider that it is about.
    pub(crate) fn of_rider(mut self, number: usize) -> Self {
        if let Self::BeyondTable { rider, .. } = &mut self {
            *rider = number;
        }
        self
    }
}
