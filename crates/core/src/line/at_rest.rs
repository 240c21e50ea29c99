//! Line at rest: geometry and shape in static equilibrium, and what is read from them.

use crate::error::CoreError;
use crate::integrator::wire_model::WireModel;
use crate::linalg::lanczos::Recurrence;
use crate::line::stepping::Stepping;
use crate::linear::model::LinearModel;
use crate::linear::static_response::StaticSolver;
use crate::slideline::Slideline;
use crate::statics::{Alteration, Geometry, Shape};
use crate::structure::Structure;
use std::sync::Arc;

/// Line of one kind in static equilibrium.
#[derive(Debug, Clone)]
pub struct LineAtRest<const DIM: usize, const D: usize> {
    pub(crate) geometry: Geometry<DIM, D>,
    pub(crate) shape: Shape<D>,
}

impl<const DIM: usize, const D: usize> LineAtRest<DIM, D> {
    /// Finds the equilibrium of a structure. With `design` unknown lengths are found first, from
    /// `near` where it is a line of the same elements. With `residual_flexibility` the compliance
    /// that the elements lack under point forces is added.
    ///
    /// # Errors
    /// Any [`CoreError`] of the statics.
    pub fn new(
        structure: Structure,
        design: bool,
        residual_flexibility: bool,
        near: Option<&Self>,
    ) -> Result<Self, CoreError> {
        let mut geometry = Geometry::<DIM, D>::new(structure)?;
        if residual_flexibility || geometry.structure.fitted_bends {
            geometry.add_residual_flexibility();
        }
        let start = match near {
            Some(known) if design => geometry.design_near(&known.geometry, &known.shape)?,
            None if design => geometry.design()?,
            _ => geometry.initial_shape(),
        };
        // The service equilibrium decides, also after a design: the lengths must reproduce it.
        let shape = geometry.find_equilibrium(&start)?;
        Ok(Self { geometry, shape })
    }

    /// Line at rest from the structure and the shape of one that was found before, node by node.
    ///
    /// # Errors
    /// [`CoreError::Input`] when they do not fit.
    pub fn from_known(structure: Structure, shape: &[f64]) -> Result<Self, CoreError> {
        let geometry = Geometry::<DIM, D>::new(structure)?;
        let (nodes, rest) = shape.as_chunks::<D>();
        let is_finite = shape.iter().all(|v| v.is_finite());
        if nodes.len() != geometry.nodes() || !rest.is_empty() || !is_finite {
            let reason = "not the numbers of each node, or not finite";
            return Err(CoreError::invalid("shape", reason));
        }
        Ok(Self {
            shape: nodes.to_vec(),
            geometry,
        })
    }

    /// Structure, with lengths that the design has found.
    #[must_use]
    pub fn structure(&self) -> &Structure {
        &self.geometry.structure
    }

    /// Static shape, node by node: position and slope, m.
    #[must_use]
    pub fn shape(&self) -> &Shape<D> {
        &self.shape
    }

    /// Finds the equilibrium after an alteration of the structure.
    ///
    /// # Errors
    /// [`CoreError::Input`] for lists that do not fit, or any error of the statics.
    pub fn altered(&self, change: &Alteration) -> Result<Self, CoreError> {
        let (geometry, shape) = self.geometry.altered(&self.shape, change)?;
        Ok(Self { geometry, shape })
    }

    /// Returns the forces on nodes (node, component, N) of a force in N/m along each wire element
    /// or segment.
    ///
    /// # Errors
    /// [`CoreError::Input`].
    pub fn nodal_forces(&self, load: &[[f64; 3]]) -> Result<Vec<(usize, usize, f64)>, CoreError> {
        self.geometry.nodal_forces(load)
    }

    /// Returns the line linearised about its shape.
    #[must_use]
    pub fn linear(&self) -> LinearModel<DIM, D> {
        LinearModel::new(&self.geometry, self.shape.clone())
    }

    /// Returns the slidelines over the wire elements of each lane in the order of the track.
    ///
    /// # Errors
    /// [`CoreError::Input`] when they do not lie one behind the other.
    pub fn slidelines(&self, lanes: &[Vec<usize>]) -> Result<Vec<Slideline<DIM>>, CoreError> {
        self.slidelines_between(lanes, (f64::NEG_INFINITY, f64::INFINITY))
    }

    /// Returns slidelines to be asked for points between two coordinates along the track, m: the
    /// residual flexibility of all elements takes longer than the elasticity of a span.
    fn slidelines_between(
        &self,
        lanes: &[Vec<usize>],
        stretch: (f64, f64),
    ) -> Result<Vec<Slideline<DIM>>, CoreError> {
        let (geometry, shape) = (&self.geometry, &self.shape);
        let paths = Slideline::from_elements(geometry, shape, lanes)?;
        if geometry.structure.fitted_bends {
            return Ok(Slideline::smoothed(paths, geometry, shape));
        }
        if geometry.structure.residual.is_some() {
            return Ok(Slideline::with_residual_flexibility_between(
                paths, geometry, shape, lanes, stretch,
            ));
        }
        Ok(paths)
    }

    /// Returns the elasticity at coordinates `x` (m) for a force in N, m/N.
    ///
    /// # Errors
    /// [`CoreError::OffWire`], [`CoreError::Singular`], [`CoreError::Input`].
    pub fn elasticity(
        &self,
        lanes: &[Vec<usize>],
        x: &[f64],
        force: f64,
    ) -> Result<Vec<f64>, CoreError> {
        let beyond = (f64::INFINITY, f64::NEG_INFINITY);
        let stretch = x.iter().fold(beyond, |(a, b), &x| (a.min(x), b.max(x)));
        let (line, lanes) = (self.linear(), self.slidelines_between(lanes, stretch)?);
        StaticSolver::new(&line)?.elasticity(&lanes, x, force)
    }

    /// Returns the lowest natural frequencies, Hz; `go_on` is asked at intervals.
    ///
    /// # Errors
    /// [`CoreError::Cancelled`], or any error of the search.
    pub fn frequencies_while(
        &self,
        count: usize,
        go_on: &mut dyn FnMut() -> bool,
    ) -> Result<Vec<f64>, CoreError> {
        self.linear().frequencies_while(count, go_on)
    }

    /// Returns the modes that a vertical force of 1 N at coordinate `x` (m) excites, shared equally
    /// by the wires of the lanes there.
    ///
    /// # Errors
    /// [`CoreError::OffWire`], [`CoreError::Singular`], [`CoreError::Input`].
    pub fn modes_moved(
        &self,
        lanes: &[Vec<usize>],
        x: f64,
        steps: usize,
    ) -> Result<Recurrence, CoreError> {
        let lanes = self.slidelines(lanes)?;
        let places: Vec<_> = lanes.iter().filter_map(|lane| lane.locate(x, 0)).collect();
        if places.is_empty() {
            return Err(CoreError::OffWire {
                pantograph: 0,
                position: x,
                step: 0,
            });
        }
        self.linear().modes_moved(&places, steps)
    }

    /// Prepares the line for steps.
    ///
    /// # Errors
    /// [`CoreError::Input`], [`CoreError::Singular`], [`CoreError::StepTooLong`].
    pub fn prepare(
        &self,
        lanes: &[Vec<usize>],
        with: &Stepping,
    ) -> Result<Arc<WireModel<DIM, D>>, CoreError> {
        let (lanes, h, contact) = (self.slidelines(lanes)?, with.step, with.contact_stiffness);
        let (geometry, mut line) = (&self.geometry, self.linear());
        if with.period_correction {
            line = line.with_correct_period(geometry, &with.scheme, h);
        }
        if with.updated && geometry.structure.residual.is_some() {
            let reason = "residual flexibility with updated kinematics";
            return Err(CoreError::invalid("solver", reason));
        }
        if with.explicit {
            return WireModel::explicit(geometry, line, lanes, h, contact).map(Arc::new);
        }
        if with.updated {
            let model = WireModel::updated(geometry, line, lanes, with.scheme, h, contact);
            return model.map(Arc::new);
        }
        WireModel::new(line, lanes, with.scheme, h, contact).map(Arc::new)
    }
}
