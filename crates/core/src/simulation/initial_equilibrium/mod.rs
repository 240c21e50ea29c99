//! Static equilibrium of line and pantographs at the start of a run.
//!
//! A pantograph with one contact has its initial force there. Several contacts of one pantograph
//! share it: with the pantograph at level z = bᵀu, forces λ on the contacts, and W the compliance
//! of the line at them,
//!
//!   gap = (wire + W λ) − E u + λ/k_c,   K u − b p = f − Eᵀλ,   bᵀu = z,   Σ λ = F
//!
//! which [load sharing](crate::simulation::initial_equilibrium::load_sharing) solves, as u is
//! linear in λ and z. Level and force along the preload belong together, so H = W + E K⁺ Eᵀ + 1/k_c
//! is symmetric, and K⁺ exists also for a pantograph without springs to its base. Links that
//! slacken, piecewise forces, and other pantographs change the matrices: it is repeated, pantograph
//! by pantograph, until no share changes.

mod load_sharing;

use crate::constraint::contacts::{Contact, Contacts};
use crate::error::CoreError;
use crate::integrator::static_line::StaticLine;
use crate::integrator::wire_model::WireModel;
use crate::linalg::BlockLdl;
use crate::linalg::small::{inner, scaled};
use crate::linear::static_response::{StaticState, compliance_matrix};
use crate::pantograph::equilibrium::{self, PantographEquilibrium};
use crate::pantograph::model::Pantograph;
use crate::simulation::initial_equilibrium::load_sharing::{cannot_share, share_load};
use crate::simulation::model::Model;
use crate::slideline::Slideline;

/// Bound on the rounds over all pantographs; the error falls in each round by the coupling between
/// pantographs.
const MOST_ROUNDS: usize = 100;
/// Change of a share that is rounding, as a share of the largest force.
const SETTLED: f64 = 1e-12;

/// Line, contacts and pantographs on the way to equilibrium.
pub(crate) struct InitialEquilibrium<'a, const DIM: usize, const D: usize> {
    wires: &'a WireModel<DIM, D>,
    pantographs: &'a [Pantograph],
    /// Position of the first pantograph, m.
    position: f64,
    /// Speed, m/s.
    speed: f64,
    static_line: StaticLine<'a, DIM, D>,
    pub(crate) slidelines: Vec<Slideline<DIM>>,
    pub(crate) contacts: Contacts<DIM>,
    /// Forces of the active contacts, N.
    pub(crate) forces: Vec<f64>,
    /// Level bᵀu of pantographs with several contacts, m, once known.
    levels: Vec<Option<f64>>,
    pub(crate) datum: f64,
}

impl<'a, const DIM: usize, const D: usize> InitialEquilibrium<'a, DIM, D> {
    pub(crate) fn new(
        model: &Model<'a, DIM, D>,
        position: f64,
        speed: f64,
    ) -> Result<Self, CoreError> {
        let (wires, pantographs) = (model.wires, model.pantographs);
        let rest = vec![[0.0; D]; wires.line.nodes()];
        let slidelines = wires.slidelines.clone();
        let contacts = Contacts::new(pantographs, model.distances, &slidelines, position, &rest)?;
        let mut start = Self {
            static_line: StaticLine::new(wires)?,
            forces: vec![0.0; contacts.active.len()],
            levels: vec![None; pantographs.len()],
            datum: datum(&contacts),
            wires,
            pantographs,
            position,
            speed,
            slidelines,
            contacts,
        };
        for (j, pantograph) in pantographs.iter().enumerate() {
            let contacts = start.contacts_of(j);
            let height = |&i: &usize| start.contact(i).point.height;
            let lowest = contacts
                .iter()
                .copied()
                .min_by(|a, b| height(a).total_cmp(&height(b)));
            if let Some(lowest) = lowest {
                start.forces[lowest] = pantograph.start_force;
            }
        }
        Ok(start)
    }

    /// Returns the active contacts of a pantograph.
    fn contacts_of(&self, pantograph: usize) -> Vec<usize> {
        let active = self.contacts.active().enumerate();
        active
            .filter(|(_, c)| c.pantograph() == pantograph)
            .map(|(i, _)| i)
            .collect()
    }

    fn contact(&self, i: usize) -> &Contact<DIM> {
        &self.contacts.all[self.contacts.active[i]]
    }

    /// Finds the line under the current forces; contacts follow it where it moves along the track.
    fn solve_wires(&mut self) -> Result<StaticState<D>, CoreError> {
        let forces = (self.position, &self.forces[..]);
        let state = self
            .static_line
            .solve(&mut self.slidelines, &mut self.contacts, forces)?;
        self.datum = datum(&self.contacts);
        Ok(state)
    }

    /// Shares the forces of all pantographs among their contacts; returns the line under them.
    pub(crate) fn find_equilibrium(&mut self) -> Result<StaticState<D>, CoreError> {
        let several: Vec<usize> = (0..self.pantographs.len())
            .filter(|&j| self.contacts_of(j).len() > 1)
            .collect();
        let largest = self.forces.iter().fold(0.0, |m: f64, f| m.max(f.abs()));
        for _ in 0..MOST_ROUNDS {
            let mut change: f64 = 0.0;
            for &j in &several {
                let static_state = self.solve_wires()?;
                change = change.max(self.redistribute(j, &static_state)?);
            }
            if change <= SETTLED * largest {
                return self.solve_wires();
            }
        }
        Err(cannot_share())
    }

    /// Returns the height of the wire at a contact above the datum, m.
    fn wire_height(&self, i: usize, static_state: &StaticState<D>) -> f64 {
        let contact = self.contact(i);
        let (point, compliance) = (&contact.point, &contact.compliance);
        let active = self.contacts.active().zip(&self.forces);
        let pressed =
            active.map(|(other, force)| self.wires.residual_flexibility(contact, other) * force);
        let height_above_mesh = compliance.static_height
            + static_state.rise_by_links(&self.wires.line, compliance)
            + pressed.sum::<f64>();
        point.height + point.displacement(&static_state.u, DIM - 1) + height_above_mesh - self.datum
    }

    /// Finds the equilibrium of a pantograph under its current forces: with one contact at the
    /// height of its wire, with several at its level, or at first at the height of the wire that
    /// carries it.
    pub(crate) fn pantograph_equilibrium(
        &self,
        j: usize,
        static_state: &StaticState<D>,
    ) -> Result<PantographEquilibrium, CoreError> {
        let (contacts, pantograph, speed) = (self.contacts_of(j), &self.pantographs[j], self.speed);
        let [first, ..] = contacts[..] else {
            return Err(cannot_share());
        };
        let of_pantograph = |error: CoreError| error.of_pantograph(j);
        if let Some(level) = self.levels[j] {
            let load = self.contact_load(&contacts, pantograph.size());
            return equilibrium::find_equilibrium(
                pantograph,
                &load,
                (&pantograph.preload, level),
                speed,
            )
            .map_err(of_pantograph);
        }
        let carrying = contacts.iter().copied().find(|&i| self.forces[i] != 0.0);
        let i = carrying.unwrap_or(first);
        let (e, force) = (&self.contact(i).vector, pantograph.start_force);
        let z = self.wire_height(i, static_state) + force * self.wires.contact_flexibility;
        equilibrium::find_equilibrium(pantograph, &scaled(force, e), (e, z), speed)
            .map_err(of_pantograph)
    }

    /// Returns Σ e λ, N.
    fn contact_load(&self, contacts: &[usize], n: usize) -> Vec<f64> {
        let mut load = vec![0.0; n];
        for &i in contacts {
            let e = &self.contact(i).vector;
            load.iter_mut()
                .zip(e)
                .for_each(|(sum, e)| *sum += self.forces[i] * e);
        }
        load
    }

    /// Redistributes the force of one pantograph; returns the largest change of a contact's force,
    /// N.
    fn redistribute(&mut self, j: usize, static_state: &StaticState<D>) -> Result<f64, CoreError> {
        let (contacts, pantograph, wires) = (self.contacts_of(j), &self.pantographs[j], self.wires);
        let (n, rest) = (
            contacts.len(),
            self.pantograph_equilibrium(j, static_state)?,
        );
        let level = inner(&pantograph.preload, &rest.u);
        let points = contacts.iter().map(|&i| self.contact(i));
        let points: Vec<_> = points.map(|c| (c.point, c.compliance)).collect();
        let is_slack = |link: usize| static_state.correction[link] > 0.0;
        let slack = wires.line.stiffness_without(is_slack);
        let mut h = compliance_matrix(&wires.line, &BlockLdl::new(&slack)?, &points, is_slack);
        let rise = rest.displacement_change(
            pantograph,
            vec![0.0; pantograph.size()],
            &pantograph.preload,
            1.0,
        )?;
        let (mut q, mut a) = (vec![0.0; n], vec![0.0; n]);
        for (k, &source) in contacts.iter().enumerate() {
            let unit_load = scaled(-1.0, &self.contact(source).vector);
            let strip_displacement =
                rest.displacement_change(pantograph, unit_load, &pantograph.preload, 0.0)?;
            for (l, &target) in contacts.iter().enumerate() {
                h[l * n + k] +=
                    wires.residual_flexibility(self.contact(target), self.contact(source));
                h[l * n + k] -= inner(&self.contact(target).vector, &strip_displacement);
            }
            h[k * n + k] += wires.contact_flexibility;
        }
        for (l, &i) in contacts.iter().enumerate() {
            let e = &self.contact(i).vector;
            a[l] = inner(e, &rise);
            let by_forces: f64 = contacts
                .iter()
                .enumerate()
                .map(|(k, &i)| h[l * n + k] * self.forces[i])
                .sum();
            let compressed = self.forces[i] * wires.contact_flexibility;
            q[l] = self.wire_height(i, static_state) - inner(e, &rest.u) + compressed - by_forces
                + a[l] * level;
        }
        let (shared, z) =
            share_load(&h, &q, &a, pantograph.start_force).ok_or_else(cannot_share)?;
        self.levels[j] = Some(z);
        let mut change: f64 = 0.0;
        for (&i, force) in contacts.iter().zip(shared) {
            change = change.max((self.forces[i] - force).abs());
            self.forces[i] = force;
        }
        Ok(change)
    }
}

/// Returns the static height of the wire at the first contact, the datum of heights, m.
fn datum<const DIM: usize>(contacts: &Contacts<DIM>) -> f64 {
    let first = contacts.active().next();
    first.map_or(0.0, |contact| contact.point.height)
}
