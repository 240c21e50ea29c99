//! State of the wires between two steps, independent of their integrator.

use crate::checkpoint::Archive;
use crate::constraint::links::LinkMotion;
use crate::constraint::wires::Wires;
use crate::error::CoreError;
use crate::integrator::explicit::ChainState;
use crate::slideline::point::Nodal;
use std::ops::Range;

/// State of the wires during a run.
#[derive(Debug, Clone)]
pub struct WireState<const D: usize> {
    /// Displacement from the static shape, m, and velocity, m/s. Explicit steps know those of
    /// linked, tracked and requested nodes only.
    pub(crate) u: Vec<[f64; D]>,
    pub(crate) v: Vec<[f64; D]>,
    /// Increment of the current step, m, of the same nodes.
    pub(crate) delta: Vec<[f64; D]>,
    /// Elongations and tensions of the links.
    pub links: LinkMotion,
    /// Numbers of the islands that are stepped, ascending; the others are at rest.
    pub(crate) awake: Vec<usize>,
    pub(crate) work: Vec<[f64; D]>,
    pub(crate) stepping: Stepping<D>,
}

/// Part of the state that belongs to the integrator.
#[derive(Debug, Clone)]
pub(crate) enum Stepping<const D: usize> {
    Implicit(ImplicitState<D>),
    /// In memory of its own, aligned for wide lanes wherever the state lies.
    Explicit(Box<ChainState>),
}

/// Vectors of the nodes whose motion the integrator knows. Explicit steps know that of linked,
/// tracked and requested nodes only: reading another one is a mistake, which debug builds notice.
#[derive(Debug, Clone, Copy)]
pub struct Known<'a, const D: usize> {
    values: &'a [[f64; D]],
    /// Number of the last step that computed the motion of each node, and the step requested.
    last_found: Option<(&'a [u64], u64)>,
}

impl<'a, const D: usize> Known<'a, D> {
    fn new(values: &'a [[f64; D]], stepping: &'a Stepping<D>, ahead: u64) -> Self {
        let last_found = match stepping {
            Stepping::Implicit(_) => None,
            Stepping::Explicit(chain) => Some((&chain.known_until[..], chain.steps + ahead)),
        };
        Self { values, last_found }
    }
}

impl<const D: usize> Nodal<D> for Known<'_, D> {
    #[inline(always)]
    fn at(&self, node: usize) -> &[f64; D] {
        debug_assert!(
            self.last_found
                .is_none_or(|(last_found, step)| last_found[node] >= step),
            "the motion of node {node} is not known"
        );
        &self.values[node]
    }
}

impl<const D: usize> WireState<D> {
    pub(crate) fn new<const DIM: usize>(
        wires: &Wires<DIM, D>,
        u: Vec<[f64; D]>,
        stepping: Stepping<D>,
    ) -> Self {
        let zero = vec![[0.0; D]; u.len()];
        Self {
            links: LinkMotion::at_rest(&wires.line.links, &u),
            v: zero.clone(),
            delta: zero.clone(),
            work: zero,
            awake: (0..wires.islands.len()).collect(),
            stepping,
            u,
        }
    }

    /// Returns whether the motion of explicit steps is finite; that of implicit steps is checked by
    /// `is_finite` at intervals.
    pub(crate) fn is_sound(&self) -> bool {
        match &self.stepping {
            Stepping::Implicit(_) => true,
            Stepping::Explicit(chain) => chain.is_finite(),
        }
    }

    /// Returns displacements at the start of the step, m, of nodes that were requested in the step
    /// before.
    #[must_use]
    pub fn displacement(&self) -> Known<'_, D> {
        Known::new(&self.u, &self.stepping, 0)
    }

    /// Returns velocities at the start of the step, m/s, of the same nodes.
    #[must_use]
    pub fn velocity(&self) -> Known<'_, D> {
        Known::new(&self.v, &self.stepping, 0)
    }

    /// Returns displacements and increments of the current step, m, of requested nodes. Their sum
    /// is known for all of these; the displacement alone for those of the step before.
    pub(crate) fn at_balance(&self) -> [Known<'_, D>; 2] {
        [&self.u, &self.delta].map(|values| Known::new(values, &self.stepping, 1))
    }

    /// Returns accelerations of implicit steps, m/s²; none of explicit ones, which do not compute
    /// all.
    pub(crate) fn acceleration(&self) -> &[[f64; D]] {
        match &self.stepping {
            Stepping::Implicit(vectors) => &vectors.a,
            Stepping::Explicit(_) => &[],
        }
    }

    /// Returns whether every displacement is finite.
    pub(crate) fn is_finite(&self) -> bool {
        self.u.iter().flatten().all(|v| v.is_finite())
    }

    /// Make room for what is read at a number of places, so that none is made in a step.
    pub(crate) fn reserve(&mut self, places: usize) {
        if let Stepping::Explicit(chain) = &mut self.stepping {
            chain.reserve(places);
        }
    }

    /// Saves or restores the motion.
    ///
    /// # Errors
    /// [`CoreError::Input`] for numbers that do not fit.
    pub(crate) fn archive(&mut self, archive: &mut Archive<'_>) -> Result<(), CoreError> {
        archive.numbers("line_displacement", self.u.as_flattened_mut().iter_mut())?;
        archive.numbers("line_velocity", self.v.as_flattened_mut().iter_mut())?;
        match &mut self.stepping {
            Stepping::Implicit(vectors) => {
                let a = vectors.a.as_flattened_mut().iter_mut();
                archive.numbers("line_acceleration", a)?;
            }
            Stepping::Explicit(chain) => {
                archive.numbers("grid_across", chain.transverse_motion())?;
                archive.numbers("grid_along", chain.x.iter_mut().flatten())?;
            }
        }
        archive.numbers("link_elongation", self.links.archived_values())
    }
}

/// Vectors that only implicit steps need.
#[derive(Debug, Clone)]
pub(crate) struct ImplicitState<const D: usize> {
    /// Acceleration, m/s².
    pub a: Vec<[f64; D]>,
    /// Negative combination of u, v, a whose product with M is the inertia of the next step.
    pub prepared: Vec<[f64; D]>,
    /// Shift s/κ of the next step, m.
    pub shift: Vec<[f64; D]>,
    pub scratch: Vec<[f64; D]>,
}

impl<const D: usize> ImplicitState<D> {
    pub fn new(nodes: usize) -> Self {
        let zero = vec![[0.0; D]; nodes];
        Self {
            a: zero.clone(),
            prepared: zero.clone(),
            shift: zero.clone(),
            scratch: zero,
        }
    }

    /// Puts nodes back to rest.
    pub fn reset(&mut self, nodes: Range<usize>) {
        for field in [&mut self.a, &mut self.prepared, &mut self.shift] {
            field[nodes.clone()].fill([0.0; D]);
        }
    }
}
