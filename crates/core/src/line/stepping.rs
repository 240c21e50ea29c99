//! Choice of the steps of a line.

use crate::scheme::Scheme;

/// Scheme, step length and contact of a line that is stepped.
#[derive(Debug, Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Stepping {
    /// Time-stepping scheme; with explicit steps that of the parts that are not stepped so, which
    /// is Newmark's β = ¼, γ = ½.
    pub scheme: Scheme,
    /// Step length, s.
    pub step: f64,
    /// Stiffness of a contact, N/m; infinite when it is rigid.
    pub contact_stiffness: f64,
    /// Explicit steps of chains.
    pub explicit: bool,
    /// Coordinates and stiffness formed at every position.
    pub updated: bool,
    /// Correction of the mass of the wires for the period error of the scheme.
    pub period_correction: bool,
}
