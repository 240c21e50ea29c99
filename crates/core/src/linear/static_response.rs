//! The linearised line at rest under vertical forces: starting state and compliance; see `elasticity`
//! for the lift.
//!
//!   K u = C p − G (r − r₀),   T = T₀ + k gᵀu + r ≥ 0,   r ≥ 0,   T r = 0
//!
//! The correction r of unilateral links is found by the same complementarity solver as in the
//! steps, with H = 1/k − GᵀK⁻¹G.

use crate::error::CoreError;
use crate::integrator::prepared::WireModel;
use crate::lcp::LcpSolver;
use crate::linalg::BlockLdl;
use crate::linear::model::LinearModel;
use crate::slideline::point::SlidelinePoint;
use crate::slideline::residual_flexibility::LocalCompliance;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// Factors of the stiffness of a line.
#[derive(Debug, Clone)]
pub struct StaticFactors<const D: usize> {
    /// Of K with every link linear: the corrections r are on the right-hand side.
    pub linear: BlockLdl<D>,
    /// Of the stiffness at rest, without the links that are slack there; `None` when there are none and
    /// `linear` serves.
    at_rest: Option<BlockLdl<D>>,
}

impl<const D: usize> StaticFactors<D> {
    fn new<const DIM: usize>(line: &LinearModel<DIM, D>) -> Result<Self, CoreError> {
        let at_rest = line.stiffness_at_rest().map(|k| BlockLdl::new(&k));
        Ok(Self {
            linear: BlockLdl::new(&line.combine(0.0, 0.0, 1.0))?,
            at_rest: at_rest.transpose()?,
        })
    }
}

impl<const DIM: usize, const D: usize> WireModel<DIM, D> {
    /// Factors of the stiffness at rest, which all runs share; found when they are first asked for.
    pub(crate) fn still_factors(&self) -> Result<&StaticFactors<D>, CoreError> {
        if let Some(known) = self.still.get() {
            return Ok(known);
        }
        let found = StaticFactors::new(&self.line)?;
        Ok(self.still.get_or_init(|| found))
    }
}

/// Static solver of a linearised line.
#[derive(Debug)]
pub struct StaticSolver<'a, const DIM: usize, const D: usize> {
    pub(crate) line: &'a LinearModel<DIM, D>,
    factors: Cow<'a, StaticFactors<D>>,
    pulls: BTreeMap<usize, Vec<[f64; D]>>,
    solver: LcpSolver,
    scratch: Vec<[f64; D]>,
}

/// Displacement under static forces.
#[derive(Debug, Clone)]
pub struct StaticState<const D: usize> {
    /// Displacement, m.
    pub u: Vec<[f64; D]>,
    /// Corrections of the links, N: positive where slack.
    pub correction: Vec<f64>,
    /// Tensions of the links, N; empty with updated kinematics.
    pub(crate) tension: Vec<f64>,
}

impl<const D: usize> StaticState<D> {
    /// What links raise a place on a wire by beyond the mesh since the line was at rest, m.
    pub(crate) fn raised<const DIM: usize>(
        &self,
        line: &LinearModel<DIM, D>,
        yields: &LocalCompliance,
    ) -> f64 {
        let pulled = yields.pulls().map(|(link, rise)| {
            let at_rest = &line.links[link];
            let more = self.tension[link] - at_rest.rest_tension - at_rest.rest_correction();
            rise * more
        });
        pulled.sum()
    }
}

impl<'a, const DIM: usize, const D: usize> StaticSolver<'a, DIM, D> {
    /// Factorise the stiffness.
    ///
    /// # Errors
    /// [`CoreError::Singular`] when the line is loose.
    pub fn new(line: &'a LinearModel<DIM, D>) -> Result<Self, CoreError> {
        Ok(Self::with(line, Cow::Owned(StaticFactors::new(line)?)))
    }

    /// That of a line prepared for runs, which share the factors.
    ///
    /// # Errors
    /// [`CoreError::Singular`] when the line is loose.
    pub(crate) fn of(p: &'a WireModel<DIM, D>) -> Result<Self, CoreError> {
        Ok(Self::with(&p.line, Cow::Borrowed(p.still_factors()?)))
    }

    fn with(line: &'a LinearModel<DIM, D>, factors: Cow<'a, StaticFactors<D>>) -> Self {
        Self {
            line,
            factors,
            pulls: BTreeMap::new(),
            solver: LcpSolver::new(),
            scratch: vec![[0.0; D]; line.nodes()],
        }
    }

    /// Displacement under vertical forces (N, upwards) at places, of a mesh that yields no more than it
    /// shows.
    ///
    /// # Errors
    /// [`CoreError::Lcp`] or [`CoreError::SlackSet`], as of step 0.
    pub fn solve(
        &mut self,
        places: &[SlidelinePoint<DIM>],
        forces: &[f64],
    ) -> Result<StaticState<D>, CoreError> {
        let places = places
            .iter()
            .map(|place| (*place, LocalCompliance::default()));
        self.press(&places.collect::<Vec<_>>(), forces)
    }

    /// The same at places where the wire yields beyond the mesh.
    pub(crate) fn press(
        &mut self,
        places: &[(SlidelinePoint<DIM>, LocalCompliance)],
        forces: &[f64],
    ) -> Result<StaticState<D>, CoreError> {
        let links = &self.line.links;
        let mut free = vec![[0.0; D]; self.line.nodes()];
        let mut rest: Vec<f64> = links.iter().map(|l| l.rest_tension).collect();
        for ((place, yields), &force) in places.iter().zip(forces) {
            place.add_force(force, DIM - 1, &mut free);
            for (link, rise) in yields.pulls() {
                let eased = links[link].stiffness * rise * force;
                links[link].add_to(eased, &mut free);
                rest[link] -= eased;
            }
        }
        links
            .iter()
            .for_each(|l| l.add_to(l.rest_correction(), &mut free));
        self.line.mask(&mut free);
        self.factors.linear.solve(&mut free, &mut self.scratch);
        let mut correction = vec![0.0; links.len()];
        let mut active: Vec<usize> = Vec::new();
        let mut u = free.clone();
        // Every round adds at least one link, so there are at most as many rounds as links.
        for _ in 0..=links.len() {
            let pushes = |i: usize| {
                let l = &links[i];
                l.unilateral && rest[i] + l.stiffness * l.elongation(&u) < 0.0
            };
            let new: Vec<usize> = (0..links.len())
                .filter(|i| !active.contains(i) && pushes(*i))
                .collect();
            if new.is_empty() {
                let tension = |(i, r): (usize, &f64)| {
                    rest[i] + links[i].stiffness * links[i].elongation(&u) + r
                };
                return Ok(StaticState {
                    tension: correction.iter().enumerate().map(tension).collect(),
                    u,
                    correction,
                });
            }
            active.extend(new);
            self.correct((&active, &rest), &free, &mut u, &mut correction)?;
        }
        Err(CoreError::SlackSet { step: 0, time: 0.0 })
    }

    fn correct(
        &mut self,
        (active, rest): (&[usize], &[f64]),
        free: &[[f64; D]],
        u: &mut [[f64; D]],
        correction: &mut [f64],
    ) -> Result<(), CoreError> {
        let n = active.len();
        for &i in active {
            self.prepare_pull(i);
        }
        let links = &self.line.links;
        let (mut h, mut w) = (vec![0.0; n * n], vec![0.0; n]);
        for (a, &i) in active.iter().enumerate() {
            let l = &links[i];
            for (b, j) in active.iter().enumerate() {
                h[a * n + b] = -self.pulls.get(j).map_or(0.0, |pull| l.elongation(pull));
            }
            h[a * n + a] += 1.0 / l.stiffness;
            w[a] = rest[i] / l.stiffness + l.elongation(free);
        }
        let (mut x, mut y) = (vec![0.0; n], vec![0.0; n]);
        self.solver
            .solve(&h, &w, &mut x, &mut y, &[])
            .map_err(|failure| CoreError::Lcp {
                step: 0,
                time: 0.0,
                contacts: Vec::new(),
                links: active.to_vec(),
                stops: Vec::new(),
                failure: Box::new(failure),
            })?;
        u.copy_from_slice(free);
        for (&i, &r) in active.iter().zip(&x) {
            correction[i] = r;
            let Some(pull) = self.pulls.get(&i) else {
                continue;
            };
            for (target, value) in u.iter_mut().zip(pull) {
                for c in 0..D {
                    target[c] -= r * value[c];
                }
            }
        }
        Ok(())
    }

    /// Keep K⁻¹g of a link.
    fn prepare_pull(&mut self, link: usize) {
        if !self.pulls.contains_key(&link) {
            let mut pull = vec![[0.0; D]; self.line.nodes()];
            self.line.links[link].add_to(1.0, &mut pull);
            self.line.mask(&mut pull);
            self.factors.linear.solve(&mut pull, &mut self.scratch);
            self.pulls.insert(link, pull);
        }
    }

    /// Lift of places under unit vertical forces on them, m/N, row by row, for small motion about the
    /// state at rest: links slack there take no part. R between places is left out.
    pub(crate) fn lifts(&self, places: &[(SlidelinePoint<DIM>, LocalCompliance)]) -> Vec<f64> {
        let factors = &self.factors;
        let factor = factors.at_rest.as_ref().unwrap_or(&factors.linear);
        let links = &self.line.links;
        compliance(self.line, factor, places, |link| {
            links[link].rest_correction() > 0.0
        })
    }
}

/// What a unit force at place k raises place i by, m/N, but for R between them; row by row. `factor` is
/// without the links that are slack.
pub(crate) fn compliance<const DIM: usize, const D: usize>(
    line: &LinearModel<DIM, D>,
    factor: &BlockLdl<D>,
    places: &[(SlidelinePoint<DIM>, LocalCompliance)],
    is_slack: impl Fn(usize) -> bool,
) -> Vec<f64> {
    let n = places.len();
    let (mut found, mut scratch) = (vec![0.0; n * n], vec![[0.0; D]; line.nodes()]);
    let taut = |y: &LocalCompliance| {
        y.pulls()
            .filter(|(link, _)| !is_slack(*link))
            .collect::<Vec<_>>()
    };
    for (k, (source, pressed)) in places.iter().enumerate() {
        let mut u = vec![[0.0; D]; line.nodes()];
        source.add_force(1.0, DIM - 1, &mut u);
        for (link, rise) in taut(pressed) {
            let link = &line.links[link];
            link.add_to(link.stiffness * rise, &mut u);
        }
        line.mask(&mut u);
        factor.solve(&mut u, &mut scratch);
        for (i, (target, raised)) in places.iter().enumerate() {
            let mut lift = target.displacement(&u, DIM - 1);
            for (link, rise) in taut(raised) {
                let elongation = line.links[link].elongation(&u) - pressed.of(link);
                lift += line.links[link].stiffness * rise * elongation;
            }
            found[i * n + k] = lift;
        }
    }
    found
}
