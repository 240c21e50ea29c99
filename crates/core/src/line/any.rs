//! Line of any kind.

use crate::error::CoreError;
use crate::integrator::wire_model::WireModel;
use crate::linalg::lanczos::Recurrence;
use crate::line::at_rest::LineAtRest;
use crate::line::stepping::Stepping;
use crate::statics::Alteration;
use crate::structure::Structure;
use std::sync::Arc;

/// Evaluates an expression for whichever kind of a line (an enum of the four kinds) is there; with
/// `=> Other`, a result of the same kind of another enum.
#[macro_export]
macro_rules! each_kind {
    ($any:expr, $from:ident, $value:ident => $body:expr) => {
        match $any {
            $from::Planar($value) => $body,
            $from::Spatial($value) => $body,
            $from::PlanarChain($value) => $body,
            $from::SpatialChain($value) => $body,
        }
    };
    ($any:expr, $from:ident => $to:ident, $value:ident => $body:expr) => {
        match $any {
            $from::Planar($value) => $body.map($to::Planar),
            $from::Spatial($value) => $body.map($to::Spatial),
            $from::PlanarChain($value) => $body.map($to::PlanarChain),
            $from::SpatialChain($value) => $body.map($to::SpatialChain),
        }
    };
}

/// Line at rest.
#[derive(Debug, Clone)]
pub enum AnyLine {
    /// Along and up, Hermite elements.
    Planar(LineAtRest<2, 4>),
    /// Along, across and up, Hermite elements.
    Spatial(LineAtRest<3, 6>),
    /// Along and up, chains of point masses.
    PlanarChain(LineAtRest<2, 2>),
    /// Along, across and up, chains of point masses.
    SpatialChain(LineAtRest<3, 3>),
}

/// Line ready for steps, shared by all that step it.
#[derive(Debug, Clone)]
pub enum AnyWireModel {
    /// Along and up, Hermite elements.
    Planar(Arc<WireModel<2, 4>>),
    /// Along, across and up, Hermite elements.
    Spatial(Arc<WireModel<3, 6>>),
    /// Along and up, chains of point masses.
    PlanarChain(Arc<WireModel<2, 2>>),
    /// Along, across and up, chains of point masses.
    SpatialChain(Arc<WireModel<3, 3>>),
}

/// Evaluates an expression of the kind of line that a structure means.
macro_rules! by_structure {
    ($structure:expr, $kind:ident => $body:expr) => {{
        let s: &Structure = $structure;
        let is_chain = s.wires.is_empty() && !s.segments.is_empty();
        match (s.dim, is_chain) {
            (2, false) => {
                type $kind = LineAtRest<2, 4>;
                $body.map(AnyLine::Planar)
            }
            (_, false) => {
                type $kind = LineAtRest<3, 6>;
                $body.map(AnyLine::Spatial)
            }
            (2, true) => {
                type $kind = LineAtRest<2, 2>;
                $body.map(AnyLine::PlanarChain)
            }
            (_, true) => {
                type $kind = LineAtRest<3, 3>;
                $body.map(AnyLine::SpatialChain)
            }
        }
    }};
}

/// Line of one kind among those of any kind.
trait OfKind: Sized {
    /// Returns the line if it is of this kind.
    fn among(any: &AnyLine) -> Option<&Self>;
}

/// Implements [`OfKind`] for the four kinds.
macro_rules! of_kind {
    ($($variant:ident $dim:literal $size:literal),+) => {
        $(impl OfKind for LineAtRest<$dim, $size> {
            fn among(any: &AnyLine) -> Option<&Self> {
                match any {
                    AnyLine::$variant(line) => Some(line),
                    _ => None,
                }
            }
        })+
    };
}

of_kind!(Planar 2 4, Spatial 3 6, PlanarChain 2 2, SpatialChain 3 3);

impl AnyLine {
    /// Finds the equilibrium of a structure, see [`LineAtRest::new`]; `near` counts if it is of the
    /// same kind. Without Hermite elements the wires are chains.
    ///
    /// # Errors
    /// Any [`CoreError`] of the statics.
    pub fn new(
        structure: Structure,
        design: bool,
        residual_flexibility: bool,
        near: Option<&Self>,
    ) -> Result<Self, CoreError> {
        by_structure!(&structure, Kind => {
            Kind::new(structure, design, residual_flexibility, near.and_then(Kind::among))
        })
    }

    /// Line at rest that was found before, see [`LineAtRest::from_known`].
    ///
    /// # Errors
    /// [`CoreError::Input`] when structure and shape do not fit.
    pub fn from_known(structure: Structure, shape: &[f64]) -> Result<Self, CoreError> {
        by_structure!(&structure, Kind => Kind::from_known(structure, shape))
    }

    /// Structure, with lengths that the design has found.
    #[must_use]
    pub fn structure(&self) -> &Structure {
        each_kind!(self, Self, line => line.structure())
    }

    /// Static shape as numbers, node by node: position and slope, m.
    #[must_use]
    pub fn shape_numbers(&self) -> Vec<f64> {
        each_kind!(self, Self, line => line.shape().as_flattened().to_vec())
    }

    /// Finds the equilibrium after an alteration.
    ///
    /// # Errors
    /// As [`LineAtRest::altered`].
    pub fn altered(&self, change: &Alteration) -> Result<Self, CoreError> {
        each_kind!(self, Self => Self, line => line.altered(change))
    }

    /// Returns the forces on nodes (node, component, N) of a force in N/m along each element.
    ///
    /// # Errors
    /// [`CoreError::Input`].
    pub fn nodal_forces(&self, load: &[[f64; 3]]) -> Result<Vec<(usize, usize, f64)>, CoreError> {
        each_kind!(self, Self, line => line.nodal_forces(load))
    }

    /// Returns shape, lengths, masses and forces by their names.
    #[must_use]
    pub fn arrays(&self) -> Vec<(&'static str, Vec<f64>)> {
        each_kind!(self, Self, line => line.arrays())
    }

    /// Returns the elasticity at coordinates `x` (m) for a force in N, m/N.
    ///
    /// # Errors
    /// As [`LineAtRest::elasticity`].
    pub fn elasticity(
        &self,
        lanes: &[Vec<usize>],
        x: &[f64],
        force: f64,
    ) -> Result<Vec<f64>, CoreError> {
        each_kind!(self, Self, line => line.elasticity(lanes, x, force))
    }

    /// Returns the lowest natural frequencies, Hz; `go_on` is asked at intervals.
    ///
    /// # Errors
    /// As [`LineAtRest::frequencies_while`].
    pub fn frequencies_while(
        &self,
        count: usize,
        go_on: &mut dyn FnMut() -> bool,
    ) -> Result<Vec<f64>, CoreError> {
        each_kind!(self, Self, line => line.frequencies_while(count, go_on))
    }

    /// Returns the modes that a vertical force of 1 N at coordinate `x` (m) excites.
    ///
    /// # Errors
    /// As [`LineAtRest::modes_moved`].
    pub fn modes_moved(
        &self,
        lanes: &[Vec<usize>],
        x: f64,
        steps: usize,
    ) -> Result<Recurrence, CoreError> {
        each_kind!(self, Self, line => line.modes_moved(lanes, x, steps))
    }

    /// Prepares the line for steps.
    ///
    /// # Errors
    /// As [`LineAtRest::prepare`].
    pub fn prepare(
        &self,
        lanes: &[Vec<usize>],
        with: &Stepping,
    ) -> Result<AnyWireModel, CoreError> {
        each_kind!(self, Self => AnyWireModel, line => line.prepare(lanes, with))
    }
}

impl AnyWireModel {
    /// Returns sizes that explain the cost of a step: nodes, blocks of the factor, numbers in the
    /// compliance columns.
    #[must_use]
    pub fn cost(&self) -> (usize, usize, usize) {
        each_kind!(self, Self, p => (p.line.nodes(), p.fill(), p.columns.stored()))
    }

    /// Step length, s.
    #[must_use]
    pub fn step_length(&self) -> f64 {
        each_kind!(self, Self, p => p.h)
    }
}
