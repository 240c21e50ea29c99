//! Wires, independent of their integrator: matrices, slidelines, links, and the displacements under
//! unit forces within a step.

use crate::constraint::columns::ComplianceColumns;
use crate::constraint::link_table::LinkTable;
use crate::error::CoreError;
use crate::linear::island::Island;
use crate::linear::model::LinearModel;
use crate::linear::static_response::{StaticFactors, StaticSolver};
use crate::scheme::{Coefficients, Scheme};
use crate::slideline::Slideline;
use crate::slideline::point::slots;
use std::ops::RangeInclusive;
use std::sync::OnceLock;

/// Step lengths that are accepted, s. Their squares divide masses and multiply forces: the range is
/// far wider than useful ones, and far from overflow.
const STEP_LENGTHS: RangeInclusive<f64> = 1e-12..=1e6;

/// Linear model of a line with the data that constraints and integrators read.
#[derive(Debug, Clone)]
pub struct Wires<const DIM: usize, const D: usize> {
    /// Linearised structure.
    pub line: LinearModel<DIM, D>,
    /// Slidelines, the wires that contacts run along.
    pub slidelines: Vec<Slideline<DIM>>,
    /// Step length, s.
    pub h: f64,
    /// Coefficients of the scheme.
    pub coefficients: Coefficients,
    /// Compliance columns: slideline by slideline one for each slot (force, couple) of each node,
    /// then one for each link.
    pub columns: ComplianceColumns<D>,
    /// Number of columns of the slidelines.
    pub(crate) slideline_columns: usize,
    pub(crate) table: LinkTable,
    /// Compliance 1/(a k_c) of a contact in a step, m/N; zero for rigid contact.
    pub contact_compliance: f64,
    /// Flexibility 1/k_c of a contact, m/N.
    pub contact_flexibility: f64,
    /// Islands: parts of the line that nothing couples.
    pub(crate) islands: Vec<Island>,
    /// Factors of the stiffness, computed on first use; not used with updated kinematics, which
    /// change it.
    static_factors: OnceLock<StaticFactors<D>>,
}

impl<const DIM: usize, const D: usize> Wires<DIM, D> {
    /// Creates wires without compliance columns, which the integrator computes. `contact_stiffness`
    /// (N/m) is infinite for rigid contact.
    ///
    /// # Errors
    /// [`CoreError::Input`].
    pub(crate) fn new(
        line: LinearModel<DIM, D>,
        slidelines: Vec<Slideline<DIM>>,
        (scheme, h): (Scheme, f64),
        contact_stiffness: f64,
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
        let slideline_columns =
            slots::<DIM, D>() * slidelines.iter().map(|l| l.nodes.len()).sum::<usize>();
        Ok(Self {
            islands: line.islands(),
            table: LinkTable::new(&line.links, &c),
            contact_compliance: 1.0 / (contact_stiffness * c.stiffness),
            contact_flexibility: 1.0 / contact_stiffness,
            columns: ComplianceColumns::new(slideline_columns + line.links.len()),
            slideline_columns,
            line,
            slidelines,
            h,
            coefficients: c,
            static_factors: OnceLock::new(),
        })
    }

    /// Returns the forces and couples of a column, node by node. First come those of the nodes of
    /// all slidelines (unit force in the vertical, and unit couple where they have slopes), then
    /// those of all links.
    pub(crate) fn unit_load(&self, number: usize) -> Vec<(usize, [f64; D])> {
        let slots = slots::<DIM, D>();
        let slideline_nodes = self
            .slidelines
            .iter()
            .flat_map(|slideline| &slideline.nodes);
        let mut load = Vec::new();
        if number < self.slideline_columns {
            let mut force = [0.0; D];
            force[number % slots * DIM + DIM - 1] = 1.0;
            let node = slideline_nodes.copied().nth(number / slots);
            load.extend(node.map(|node| (node, force)));
        } else {
            load.extend(self.line.links[number - self.slideline_columns].unit_pull());
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

    /// Returns the number of the column A⁻¹g of a link, after the columns of the nodes of all
    /// slidelines.
    #[inline(always)]
    #[must_use]
    pub fn link_column(&self, link: usize) -> usize {
        self.slideline_columns + link
    }

    /// Returns the islands with the given numbers.
    pub(crate) fn awake<'a>(&'a self, numbers: &'a [usize]) -> impl Iterator<Item = &'a Island> {
        numbers.iter().map(|&number| &self.islands[number])
    }

    /// Returns the number of the island of a node.
    pub(crate) fn island_of(&self, node: usize) -> usize {
        self.islands
            .partition_point(|island| island.nodes.end <= node)
    }

    /// Returns the factors of the stiffness at rest, which all runs share; computes them on first
    /// use.
    ///
    /// # Errors
    /// [`CoreError::Singular`] when the line is loose.
    pub(crate) fn static_factors(&self) -> Result<&StaticFactors<D>, CoreError> {
        if let Some(factors) = self.static_factors.get() {
            return Ok(factors);
        }
        let factors = StaticFactors::new(&self.line)?;
        Ok(self.static_factors.get_or_init(|| factors))
    }

    /// Returns a static solver with the factors that all runs share.
    ///
    /// # Errors
    /// [`CoreError::Singular`] when the line is loose.
    pub(crate) fn static_solver(&self) -> Result<StaticSolver<'_, DIM, D>, CoreError> {
        Ok(StaticSolver::with_factors(
            &self.line,
            self.static_factors()?,
        ))
    }
}
