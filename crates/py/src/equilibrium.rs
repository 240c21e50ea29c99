//! Static equilibrium and what is read from it.

use crate::error::convert;
use crate::model::{Any as AnyModel, WireModel};
use crate::structure;
use arcless_core::CoreError;
use arcless_core::element::hermite;
use arcless_core::integrator::wire_model;
use arcless_core::linalg::lanczos::Recurrence;
use arcless_core::linear::model::LinearModel;
use arcless_core::linear::static_response::StaticSolver;
use arcless_core::scheme::Scheme;
use arcless_core::slideline::Slideline;
use arcless_core::statics::{Alteration, Geometry, Shape, assembly};
use numpy::{PyReadonlyArray2, ToPyArray};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;

/// Equilibrium in two or three dimensions, of Hermite elements or of chains of point masses.
enum Any {
    Planar(Solved<2, 4>),
    Spatial(Solved<3, 6>),
    PlanarChain(Solved<2, 2>),
    SpatialChain(Solved<3, 3>),
}

struct Solved<const DIM: usize, const D: usize> {
    geometry: Geometry<DIM, D>,
    shape: Shape<D>,
}

/// Call a method of whichever variant is there.
macro_rules! either {
    ($any:expr, $s:ident => $body:expr) => {
        match $any {
            Any::Planar($s) => $body,
            Any::Spatial($s) => $body,
            Any::PlanarChain($s) => $body,
            Any::SpatialChain($s) => $body,
        }
    };
}

/// Equilibrium that is known, where it is of a variant; else nothing.
macro_rules! variant {
    ($any:expr, $variant:path) => {
        match $any {
            Some($variant(known)) => Some(known),
            _ => None,
        }
    };
}

/// Static equilibrium of a structure.
#[pyclass(frozen)]
pub struct Equilibrium(Any);

#[pymethods]
impl Equilibrium {
    /// Find the equilibrium; with `design`, unknown lengths are found first. Without Hermite
    /// elements in the table `wires`, the wires are the chains in `segments` and `bends`. With
    /// `residual_flexibility`, the compliance that cubic elements lack under droppers, supports and
    /// contacts is added there; with `fitted_bends`, points of chains yield as those of their wires
    /// do; with `across_only`, the linear model moves across the track alone, at the tensions of
    /// rest. With `near`, an equilibrium of the same elements, the design is searched for from
    /// there.
    #[new]
    #[pyo3(signature = (*, dimension, positions, slopes, parts, gravity, design, residual_flexibility = false, fitted_bends = false, across_only = false, near = None))]
    fn new(
        py: Python<'_>,
        dimension: usize,
        positions: PyReadonlyArray2<'_, f64>,
        slopes: PyReadonlyArray2<'_, f64>,
        parts: &Bound<'_, PyDict>,
        gravity: f64,
        design: bool,
        residual_flexibility: bool,
        fitted_bends: bool,
        across_only: bool,
        near: Option<Py<Self>>,
    ) -> PyResult<Self> {
        let how = (design, residual_flexibility);
        let near = near.as_ref().map(|known| &known.get().0);
        let mut s = structure::build(dimension, &positions, &slopes, parts, gravity)?;
        s.fitted_bends = fitted_bends;
        s.across_only = across_only;
        let is_chain = s.wires.is_empty() && !s.segments.is_empty();
        let found = py.detach(|| match (dimension, is_chain) {
            (2, false) => Solved::new(s, how, variant!(near, Any::Planar)).map(Any::Planar),
            (_, false) => Solved::new(s, how, variant!(near, Any::Spatial)).map(Any::Spatial),
            (2, true) => {
                Solved::new(s, how, variant!(near, Any::PlanarChain)).map(Any::PlanarChain)
            }
            (_, true) => {
                Solved::new(s, how, variant!(near, Any::SpatialChain)).map(Any::SpatialChain)
            }
        });
        found.map(Self).map_err(|e| convert(py, &e))
    }

    /// Equilibrium of the same structure after changes: factors on lengths and stiffnesses, new
    /// masses, loads along the wires, offsets of link lengths and of the rest positions of springs
    /// and struts, forces at free ends, links removed.
    fn altered(&self, py: Python<'_>, changes: &Bound<'_, PyDict>) -> PyResult<Self> {
        let change = structure::alteration(changes)?;
        let found = py.detach(|| match &self.0 {
            Any::Planar(s) => s.altered(&change).map(Any::Planar),
            Any::Spatial(s) => s.altered(&change).map(Any::Spatial),
            Any::PlanarChain(s) => s.altered(&change).map(Any::PlanarChain),
            Any::SpatialChain(s) => s.altered(&change).map(Any::SpatialChain),
        });
        found.map(Self).map_err(|e| convert(py, &e))
    }

    /// Forces on nodes (node, component, N) of a force in N/m along each wire element or segment.
    fn nodal_forces(
        &self,
        py: Python<'_>,
        load: PyReadonlyArray2<'_, f64>,
    ) -> PyResult<Vec<(usize, usize, f64)>> {
        let load = structure::triples(&load)?;
        let found = either!(&self.0, s => s.geometry.nodal_forces(&load));
        found.map_err(|e| convert(py, &e))
    }

    /// Shape, lengths and forces as arrays.
    fn arrays<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        either!(&self.0, s => s.arrays(py))
    }

    /// Elasticity in m/N at coordinates `x` in m, for a force in N on the wires of `lanes`: wire
    /// elements in the order of the track, one list for each lane.
    fn elasticity(
        &self,
        py: Python<'_>,
        lanes: Vec<Vec<usize>>,
        x: Vec<f64>,
        force: f64,
    ) -> PyResult<Vec<f64>> {
        let found = py.detach(|| either!(&self.0, s => s.elasticity(&lanes, &x, force)));
        found.map_err(|e| convert(py, &e))
    }

    /// Lowest natural frequencies in Hz.
    fn frequencies(&self, py: Python<'_>, count: usize) -> PyResult<Vec<f64>> {
        let mut raised = None::<PyErr>;
        let found = py.detach(|| {
            let mut go_on = || {
                let signals = Python::attach(|py| py.check_signals());
                signals.map_err(|error| raised = Some(error)).is_ok()
            };
            either!(&self.0, s => s.line().frequencies_while(count, &mut go_on))
        });
        found.map_err(|e| raised.unwrap_or_else(|| convert(py, &e)))
    }

    /// Modes that a vertical force of 1 N at coordinate `x` in m excites, shared equally by the
    /// wires of `lanes`: square of the start vector's length, diagonal and off-diagonal of the
    /// Lanczos matrix of 1/ω².
    fn modes_moved(
        &self,
        py: Python<'_>,
        lanes: Vec<Vec<usize>>,
        x: f64,
        steps: usize,
    ) -> PyResult<(f64, Vec<f64>, Vec<f64>)> {
        let found = py.detach(|| either!(&self.0, s => s.modes_moved(&lanes, x, steps)));
        let found = found.map_err(|e| convert(py, &e))?;
        Ok((found.squared_length, found.diagonal, found.off))
    }

    /// Factorise for stepping: wire elements of each lane in the order of the track, scheme as name
    /// and parameters, step in s, contact stiffness in N/m (infinite when rigid), updated or
    /// linearised kinematics, and whether the mass of the wires is corrected for the period error
    /// of the scheme.
    #[pyo3(signature = (*, lanes, scheme, step, contact_stiffness, updated, period_correction = false))]
    fn prepare(
        &self,
        py: Python<'_>,
        lanes: Vec<Vec<usize>>,
        scheme: (String, Vec<f64>),
        step: f64,
        contact_stiffness: f64,
        updated: bool,
        period_correction: bool,
    ) -> PyResult<WireModel> {
        let stepping = Stepping {
            scheme: read_scheme(&scheme.0, &scheme.1)?,
            step,
            contact_stiffness,
            explicit: scheme.0 == EXPLICIT,
            updated,
            period_correction,
        };
        let with = &stepping;
        let found = py.detach(|| match &self.0 {
            Any::Planar(s) => s.prepare(&lanes, with).map(AnyModel::Planar),
            Any::Spatial(s) => s.prepare(&lanes, with).map(AnyModel::Spatial),
            Any::PlanarChain(s) => s.prepare(&lanes, with).map(AnyModel::PlanarChain),
            Any::SpatialChain(s) => s.prepare(&lanes, with).map(AnyModel::SpatialChain),
        });
        found.map(WireModel).map_err(|e| convert(py, &e))
    }
}

struct Stepping {
    scheme: Scheme,
    step: f64,
    contact_stiffness: f64,
    explicit: bool,
    updated: bool,
    period_correction: bool,
}

const EXPLICIT: &str = "central-difference";

fn read_scheme(name: &str, parameters: &[f64]) -> PyResult<Scheme> {
    match (name, parameters) {
        ("generalised-alpha", &[radius]) => Ok(Scheme::generalised_alpha(radius)),
        ("hht", &[alpha]) => Ok(Scheme::hht(alpha)),
        ("newmark", &[beta, gamma]) => Ok(Scheme::newmark(beta, gamma)),
        ("trapezoidal", &[]) => Ok(Scheme::generalised_alpha(1.0)),
        // Scheme of the parts that are not stepped explicitly.
        (EXPLICIT, &[]) => Ok(Scheme::newmark(0.25, 0.5)),
        ("backward-difference", &[]) => Ok(Scheme::BackwardDifference),
        _ => Err(PyValueError::new_err(format!(
            "unknown scheme {name} with {} parameters",
            parameters.len()
        ))),
    }
}

impl<const DIM: usize, const D: usize> Solved<DIM, D> {
    fn new(
        s: arcless_core::structure::Structure,
        (design, residual_flexibility): (bool, bool),
        near: Option<&Self>,
    ) -> Result<Self, CoreError> {
        let mut geometry = Geometry::<DIM, D>::new(s)?;
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

    fn altered(&self, change: &Alteration) -> Result<Self, CoreError> {
        let (geometry, shape) = self.geometry.altered(&self.shape, change)?;
        Ok(Self { geometry, shape })
    }

    fn line(&self) -> LinearModel<DIM, D> {
        LinearModel::new(&self.geometry, self.shape.clone())
    }

    fn lanes(&self, lanes: &[Vec<usize>]) -> Result<Vec<Slideline<DIM>>, CoreError> {
        self.lanes_between(lanes, (f64::NEG_INFINITY, f64::INFINITY))
    }

    /// Lanes to be asked for points between two coordinates along the track, m: the residual
    /// flexibility of all elements takes longer than the elasticity of a span.
    fn lanes_between(
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

    fn elasticity(
        &self,
        lanes: &[Vec<usize>],
        x: &[f64],
        force: f64,
    ) -> Result<Vec<f64>, CoreError> {
        let beyond = (f64::INFINITY, f64::NEG_INFINITY);
        let stretch = x.iter().fold(beyond, |(a, b), &x| (a.min(x), b.max(x)));
        let (line, lanes) = (self.line(), self.lanes_between(lanes, stretch)?);
        StaticSolver::new(&line)?.elasticity(&lanes, x, force)
    }

    fn modes_moved(
        &self,
        lanes: &[Vec<usize>],
        x: f64,
        steps: usize,
    ) -> Result<Recurrence, CoreError> {
        let lanes = self.lanes(lanes)?;
        let places: Vec<_> = lanes.iter().filter_map(|lane| lane.locate(x, 0)).collect();
        if places.is_empty() {
            return Err(CoreError::OffWire {
                pantograph: 0,
                position: x,
                step: 0,
            });
        }
        self.line().modes_moved(&places, steps)
    }

    fn prepare(
        &self,
        lanes: &[Vec<usize>],
        with: &Stepping,
    ) -> Result<Arc<wire_model::WireModel<DIM, D>>, CoreError> {
        let (lanes, h, contact) = (self.lanes(lanes)?, with.step, with.contact_stiffness);
        let (geometry, mut line) = (&self.geometry, self.line());
        if with.period_correction {
            line = line.with_correct_period(geometry, &with.scheme, h);
        }
        if with.updated && geometry.structure.residual.is_some() {
            return Err(CoreError::Input {
                array: "solver",
                reason: "residual flexibility with updated kinematics".into(),
            });
        }
        if with.explicit {
            let p = wire_model::WireModel::explicit(geometry, line, lanes, h, contact);
            return p.map(Arc::new);
        }
        if with.updated {
            let p = wire_model::WireModel::updated(geometry, line, lanes, with.scheme, h, contact);
            return p.map(Arc::new);
        }
        wire_model::WireModel::new(line, lanes, with.scheme, h, contact).map(Arc::new)
    }

    fn arrays<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let s = &self.geometry.structure;
        let out = PyDict::new(py);
        let real = self.geometry.real_shape(&self.shape);
        let positions = real.iter().flat_map(|node| node[..DIM].to_vec());
        // None where nodes have no slopes.
        let slopes = self.shape.iter().flat_map(|node| node[DIM..].to_vec());
        let links: Vec<_> = s
            .links
            .iter()
            .map(|l| (l, Geometry::<DIM, D>::link_state(&self.shape, l)))
            .collect();
        let collect = |values: Vec<f64>| values.to_pyarray(py);
        out.set_item("positions", collect(positions.collect()))?;
        out.set_item("slopes", collect(slopes.collect()))?;
        out.set_item("wire_rest_length", collect(self.rest_lengths()))?;
        out.set_item("wire_tension", collect(self.tensions()))?;
        out.set_item("wire_mass", collect(self.masses()))?;
        let length = |l| Geometry::<DIM, D>::link_state(&real, l).length;
        out.set_item("link_length", collect(s.links.iter().map(length).collect()))?;
        out.set_item(
            "link_rest_length",
            collect(s.links.iter().map(|l| l.rest_length).collect()),
        )?;
        let tension = links.iter().map(|(l, b)| assembly::link_tension(l, b));
        out.set_item("link_tension", collect(tension.collect()))?;
        let strut = |t| Geometry::<DIM, D>::strut_state(&self.shape, t).linear_tension;
        out.set_item(
            "strut_tension",
            collect(s.struts.iter().map(strut).collect()),
        )?;
        let anchors: Vec<f64> = s.struts.iter().flat_map(|t| t.anchor).collect();
        out.set_item("strut_anchor", collect(anchors))?;
        let spring = |p: &arcless_core::structure::Spring| {
            -p.stiffness * (self.shape[p.node][p.component] - p.rest)
        };
        out.set_item(
            "spring_force",
            collect(s.springs.iter().map(spring).collect()),
        )?;
        out.set_item(
            "spring_rest",
            collect(s.springs.iter().map(|p| p.rest).collect()),
        )?;
        Ok(out)
    }

    /// Unstretched length of each wire element or segment, m.
    fn rest_lengths(&self) -> Vec<f64> {
        let s = &self.geometry.structure;
        let segments = s.segments.iter().map(|k| k.rest_length);
        let wires = s.wires.iter().map(|w| w.section.rest_length);
        wires.chain(segments).collect()
    }

    /// Mass per metre of rest length of each wire element or segment, kg/m.
    fn masses(&self) -> Vec<f64> {
        let s = &self.geometry.structure;
        let segments = s.segments.iter().map(|k| k.mass);
        s.wires.iter().map(|w| w.mass).chain(segments).collect()
    }

    /// Tension in the middle of each wire element or segment, N.
    fn tensions(&self) -> Vec<f64> {
        let s = &self.geometry.structure;
        let middle = |w: &arcless_core::structure::Wire| {
            let e = Geometry::<DIM, D>::frame_coordinates(&self.shape, w);
            hermite::tension(&w.section, &e, 0.5)
        };
        let segments = s
            .segments
            .iter()
            .map(|k| Geometry::<DIM, D>::segment_state(&self.shape, k).linear_tension);
        s.wires.iter().map(middle).chain(segments).collect()
    }
}
