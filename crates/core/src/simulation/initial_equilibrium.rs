//! Line and riders in static equilibrium.
//!
//! A rider with one contact presses with its force at the start. The contacts of one with several
//! share it: with the rider at level z = bᵀu, forces λ on the contacts, and W the compliance of the
//! line at them,
//!
//!   gap = (wire + W λ) − E u + λ/k_c,   K u − b p = f − Eᵀλ,   bᵀu = z,   Σ λ = F
//!
//! which [share](crate::simulation::load_sharing) solves, as u is linear in λ and z. Level and force along the preload
//! belong together, so H = W + E K⁺ Eᵀ + 1/k_c is symmetric, and K⁺ exists also for a rider that stands
//! on no spring. Links that slacken, tables, and other riders change the numbers: it is repeated, rider
//! by rider, until no share moves.

use crate::constraint::contacts::{Contact, Contacts};
use crate::error::CoreError;
use crate::integrator::prepared::WireModel;
use crate::integrator::static_line::StaticLine;
use crate::linalg::BlockLdl;
use crate::linear::static_response::{StaticState, compliance};
use crate::pantograph::equilibrium::{self, Rest};
use crate::pantograph::system::{Pantograph, inner, times};
use crate::simulation::load_sharing::{share, unshared};
use crate::simulation::model::Model;
use crate::slideline::Slideline;

/// Bound on the rounds over all riders; a round takes the error down by the coupling between riders.
const MOST_ROUNDS: usize = 100;
/// Change of a share that is rounding, as a share of the largest force.
const SETTLED: f64 = 1e-12;

/// Line, contacts and riders on the way to equilibrium.
pub(crate) struct Start<'a, const DIM: usize, const D: usize> {
    p: &'a WireModel<DIM, D>,
    riders: &'a [Pantograph],
    /// Position of the first rider, m.
    position: f64,
    /// Speed, m/s.
    speed: f64,
    wires: StaticLine<'a, DIM, D>,
    pub(crate) lanes: Vec<Slideline<DIM>>,
    pub(crate) contacts: Contacts<DIM>,
    /// Forces of the active contacts, N.
    pub(crate) forces: Vec<f64>,
    /// bᵀu of riders with several contacts, once known.
    levels: Vec<Option<f64>>,
    pub(crate) datum: f64,
}

impl<'a, const DIM: usize, const D: usize> Start<'a, DIM, D> {
    pub(crate) fn new(
        model: &Model<'a, DIM, D>,
        position: f64,
        speed: f64,
    ) -> Result<Self, CoreError> {
        let (p, riders) = (model.line, model.riders);
        let rest = vec![[0.0; D]; p.line.nodes()];
        let lanes = p.lanes.clone();
        let contacts = Contacts::new(riders, model.distances, &lanes, position, &rest)?;
        let mut start = Self {
            wires: StaticLine::new(p)?,
            forces: vec![0.0; contacts.active.len()],
            levels: vec![None; riders.len()],
            datum: datum(&contacts),
            p,
            riders,
            position,
            speed,
            lanes,
            contacts,
        };
        for (j, rider) in riders.iter().enumerate() {
            let own = start.own(j);
            let height = |&i: &usize| start.contact(i).place.height;
            let lowest = own
                .iter()
                .copied()
                .min_by(|a, b| height(a).total_cmp(&height(b)));
            if let Some(lowest) = lowest {
                start.forces[lowest] = rider.start_force;
            }
        }
        Ok(start)
    }

    /// Active contacts of a rider.
    fn own(&self, rider: usize) -> Vec<usize> {
        let active = self.contacts.active().enumerate();
        active
            .filter(|(_, c)| c.rider() == rider)
            .map(|(i, _)| i)
            .collect()
    }

    fn contact(&self, i: usize) -> &Contact<DIM> {
        &self.contacts.all[self.contacts.active[i]]
    }

    /// The line under the present forces; contacts follow it where it moves along the track.
    fn line(&mut self) -> Result<StaticState<D>, CoreError> {
        let forces = (self.position, &self.forces[..]);
        let found = self
            .wires
            .press(&mut self.lanes, &mut self.contacts, forces)?;
        self.datum = datum(&self.contacts);
        Ok(found)
    }

    /// Share the forces of all riders among their contacts; returns the line under them.
    pub(crate) fn settle(&mut self) -> Result<StaticState<D>, CoreError> {
        let several: Vec<usize> = (0..self.riders.len())
            .filter(|&j| self.own(j).len() > 1)
            .collect();
        let largest = self.forces.iter().fold(0.0, |m: f64, f| m.max(f.abs()));
        for _ in 0..MOST_ROUNDS {
            let mut change: f64 = 0.0;
            for &j in &several {
                let line = self.line()?;
                change = change.max(self.share_of(j, &line)?);
            }
            if change <= SETTLED * largest {
                return self.line();
            }
        }
        Err(unshared())
    }

    /// Height of the wire at a contact above the datum, m.
    fn wire(&self, i: usize, line: &StaticState<D>) -> f64 {
        let contact = self.contact(i);
        let (place, yields) = (&contact.place, &contact.yields);
        let active = self.contacts.active().zip(&self.forces);
        let pressed = active.map(|(other, force)| self.p.missing(contact, other) * force);
        let raised = yields.rise + line.raised(&self.p.line, yields) + pressed.sum::<f64>();
        place.height + place.displacement(&line.u, DIM - 1) + raised - self.datum
    }

    /// A rider under its present forces: with one contact at the height of its wire, with several at
    /// its level, or at first at the height of the wire that carries it.
    pub(crate) fn stand(&self, j: usize, line: &StaticState<D>) -> Result<Rest, CoreError> {
        let (own, rider, speed) = (self.own(j), &self.riders[j], self.speed);
        let [first, ..] = own[..] else {
            return Err(unshared());
        };
        let of_rider = |error: CoreError| error.of_rider(j);
        if let Some(level) = self.levels[j] {
            let load = self.load(&own, rider.size());
            return equilibrium::settle(rider, &load, (&rider.preload, level), speed)
                .map_err(of_rider);
        }
        let carrying = own.iter().copied().find(|&i| self.forces[i] != 0.0);
        let i = carrying.unwrap_or(first);
        let (e, force) = (&self.contact(i).vector, rider.start_force);
        let z = self.wire(i, line) + force * self.p.contact_flexibility;
        equilibrium::settle(rider, &times(force, e), (e, z), speed).map_err(of_rider)
    }

    /// Σ e λ.
    fn load(&self, own: &[usize], n: usize) -> Vec<f64> {
        let mut load = vec![0.0; n];
        for &i in own {
            let e = &self.contact(i).vector;
            load.iter_mut()
                .zip(e)
                .for_each(|(sum, e)| *sum += self.forces[i] * e);
        }
        load
    }

    /// Share the force of one rider anew; returns the largest change of a contact's force, N.
    fn share_of(&mut self, j: usize, line: &StaticState<D>) -> Result<f64, CoreError> {
        let (own, rider, p) = (self.own(j), &self.riders[j], self.p);
        let (n, rest) = (own.len(), self.stand(j, line)?);
        let level = inner(&rider.preload, &rest.u);
        let places = own.iter().map(|&i| self.contact(i));
        let places: Vec<_> = places.map(|c| (c.place, c.yields)).collect();
        let is_slack = |link: usize| line.correction[link] > 0.0;
        let slack = p.line.stiffness_without(is_slack);
        let mut h = compliance(&p.line, &BlockLdl::new(&slack)?, &places, is_slack);
        let rise = rest.respond(rider, vec![0.0; rider.size()], &rider.preload, 1.0)?;
        let (mut q, mut a) = (vec![0.0; n], vec![0.0; n]);
        for (k, &source) in own.iter().enumerate() {
            let push = times(-1.0, &self.contact(source).vector);
            let sunk = rest.respond(rider, push, &rider.preload, 0.0)?;
            for (l, &target) in own.iter().enumerate() {
                h[l * n + k] += p.missing(self.contact(target), self.contact(source));
                h[l * n + k] -= inner(&self.contact(target).vector, &sunk);
            }
            h[k * n + k] += p.contact_flexibility;
        }
        for (l, &i) in own.iter().enumerate() {
            let e = &self.contact(i).vector;
            a[l] = inner(e, &rise);
            let yielded: f64 = own
                .iter()
                .enumerate()
                .map(|(k, &i)| h[l * n + k] * self.forces[i])
                .sum();
            let compressed = self.forces[i] * p.contact_flexibility;
            q[l] = self.wire(i, line) - inner(e, &rest.u) + compressed - yielded + a[l] * level;
        }
        let (shared, z) = share(&h, &q, &a, rider.start_force).ok_or_else(unshared)?;
        self.levels[j] = Some(z);
        let mut change: f64 = 0.0;
        for (&i, force) in own.iter().zip(shared) {
            change = change.max((self.forces[i] - force).abs());
            self.forces[i] = force;
        }
        Ok(change)
    }
}

/// Static height of the wire at the first contact, from which heights count, m.
fn datum<const DIM: usize>(contacts: &Contacts<DIM>) -> f64 {
    let first = contacts.active().next();
    first.map_or(0.0, |contact| contact.place.height)
}
