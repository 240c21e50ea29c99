//! A line ready for steps: all that stays the same during a run.

use crate::constraint::columns::ComplianceColumns;
use crate::constraint::link_table::LinkTable;
use crate::error::CoreError;
use crate::integrator::Integrator;
use crate::integrator::explicit::Explicit;
use crate::integrator::implicit::Implicit;
use crate::linear::model::LinearModel;
use crate::linear::static_response::StaticFactors;
use crate::scheme::{Coefficients, Scheme};
use crate::simulation::sleep::Island;
use crate::slideline::Slideline;
use crate::slideline::point::slots;
use crate::statics::Geometry;
use std::ops::RangeInclusive;
use std::sync::OnceLock;

/// Step lengths in s. Their squares divide masses and multiply forces: far beyond what moves a line,
/// and far inside of what numbers can hold.
const STEP_LENGTHS: RangeInclusive<f64> = 1e-12..=1e6;

/// Everything that stays the same during a run, and may be shared by many runs.
#[derive(Debug, Clone)]
pub struct WireModel<const DIM: usize, const D: usize> {
    /// Linearised structure.
    pub line: LinearModel<DIM, D>,
    /// Wires the contacts run along.
    pub lanes: Vec<Slideline<DIM>>,
    /// Step length, s.
    pub h: f64,
    /// Numbers of the scheme.
    pub coefficients: Coefficients,
    /// Influence columns: lane by lane one for each slot (force, couple) of each node, then one for
    /// each link.
    pub columns: ComplianceColumns<D>,
    /// Columns of the lanes.
    pub(crate) lane_columns: usize,
    pub(crate) table: LinkTable,
    /// 1/(a k_c), m/N; zero for rigid contact.
    pub contact_compliance: f64,
    /// 1/k_c, m/N.
    pub contact_flexibility: f64,
    pub(crate) integrator: Integrator<DIM, D>,
    /// Factors of the stiffness, once somebody asked for them; not with updated kinematics, which change it.
    pub(crate) still: OnceLock<StaticFactors<D>>,
    /// What of the line nothing couples.
    pub(crate) islands: Vec<Island>,
}

impl<const DIM: usize, const D: usize> WireModel<DIM, D> {
    /// Factorise the matrix of the scheme and prepare the influence columns.
    /// `contact_stiffness` is infinite for rigid contact.
    ///
    /// # Errors
    /// [`CoreError::Input`] or [`CoreError::Singular`].
    pub fn new(
        line: LinearModel<DIM, D>,
        lanes: Vec<Slideline<DIM>>,
        scheme: Scheme,
        h: f64,
        contact_stiffness: f64,
    ) -> Result<Self, CoreError> {
        Self::assemble(
            line,
            lanes,
            (scheme, h),
            contact_stiffness,
            |line, c, fixed| {
                let own = Implicit::new(line, c, fixed, 1.0)?;
                Ok(Integrator::Implicit(Box::new(own)))
            },
        )
    }

    /// The same for explicit steps of wires that are chains, see [`Explicit`]; on [`Slideline::rounded`] lanes they are
    /// right between points as well.
    ///
    /// # Errors
    /// [`CoreError::Input`] or [`CoreError::Singular`].
    pub fn explicit(
        geometry: &Geometry<DIM, D>,
        line: LinearModel<DIM, D>,
        lanes: Vec<Slideline<DIM>>,
        h: f64,
        contact_stiffness: f64,
    ) -> Result<Self, CoreError> {
        let steps = Explicit::new(geometry, &line.shape, &line, h)?;
        let scheme = Scheme::newmark(0.25, 0.5);
        Self::assemble(line, lanes, (scheme, h), contact_stiffness, |_, _, _| {
            Ok(Integrator::Explicit(Box::new(steps)))
        })
    }

    /// Assemble with an integrator, made of the linearised line, the numbers of the scheme, and the
    /// components that cannot move.
    pub(crate) fn assemble(
        line: LinearModel<DIM, D>,
        lanes: Vec<Slideline<DIM>>,
        (scheme, h): (Scheme, f64),
        contact_stiffness: f64,
        integrator: impl FnOnce(
            &LinearModel<DIM, D>,
            &Coefficients,
            Vec<(u32, u32)>,
        ) -> Result<Integrator<DIM, D>, CoreError>,
    ) -> Result<Self, CoreError> {
        scheme.check()?;
        if !STEP_LENGTHS.contains(&h) || contact_stiffness.is_nan() || contact_stiffness <= 0.0 {
            let reason = format!("step {h} s, contact stiffness {contact_stiffness} N/m");
            return Err(CoreError::Input {
                array: "solver",
                reason,
            });
        }
        let c = scheme.coefficients(h);
        let lane_columns = slots::<DIM, D>() * lanes.iter().map(|l| l.nodes.len()).sum::<usize>();
        let fixed = line.free.iter().enumerate().flat_map(|(node, free)| {
            (0..D)
                .filter(|&k| !free[k])
                .map(move |k| (node as u32, k as u32))
        });
        let fixed: Vec<(u32, u32)> = fixed.collect();
        let mut prepared = Self {
            islands: Island::all(&line, &fixed),
            table: LinkTable::new(&line.links, &c),
            contact_compliance: 1.0 / (contact_stiffness * c.stiffness),
            contact_flexibility: 1.0 / contact_stiffness,
            columns: ComplianceColumns::new(lane_columns + line.links.len()),
            lane_columns,
            integrator: integrator(&line, &c, fixed)?,
            line,
            lanes,
            h,
            coefficients: c,
            still: OnceLock::new(),
        };
        prepared.set_columns();
        Ok(prepared)
    }

    /// Right-hand side of a column, node by node. First come those of the nodes of all lanes (unit
    /// force in the vertical, and unit couple where they have slopes), then those of all links.
    pub(crate) fn unit_load(&self, number: usize) -> Vec<(usize, [f64; D])> {
        let slots = slots::<DIM, D>();
        let (mut place, mut on_lane) = (number / slots, None);
        for lane in &self.lanes {
            on_lane = lane.nodes.get(place);
            if on_lane.is_some() {
                break;
            }
            place -= lane.nodes.len();
        }
        let mut load = Vec::new();
        if let Some(&node) = on_lane {
            let mut force = [0.0; D];
            force[number % slots * DIM + DIM - 1] = 1.0;
            load.push((node, force));
        } else {
            load.extend(self.line.links[number - self.lane_columns].unit_pull());
        }
        for (node, force) in &mut load {
            for c in 0..D {
                if !self.line.free[*node][c] {
                    force[c] = 0.0;
                }
            }
        }
        load
    }
}
