//! The whole way over the border: arrays in, arrays out, or an error that can be told.

use super::feed::Feed;
use super::finite::{assert_finite, told};
use super::{motion, stepping, structure};
use arcless_core::integrator::wire_model::WireModel;
use arcless_core::linear::model::LinearModel;
use arcless_core::linear::static_response::StaticSolver;
use arcless_core::slideline::Slideline;
use arcless_core::statics::{Alteration, Geometry, Shape};

/// Last stage that an input reached.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Reached {
    /// Structure refused, or without an equilibrium.
    Nothing,
    /// Equilibrium found.
    Equilibrium,
    /// Matrices of the steps prepared.
    Prepared,
    /// Run completed.
    Run,
}

/// Outcome of an input: components of space, whether wires are chains, last stage reached.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Outcome {
    pub dim: usize,
    pub chain: bool,
    pub reached: Reached,
}

/// Take bytes over the border.
///
/// # Panics
/// When a number that comes back is not finite, or the core itself panics.
pub fn cross(bytes: &[u8]) -> Outcome {
    let feed = &mut Feed::new(bytes);
    let (dim, chain) = (2 + feed.below(2), feed.flag());
    let reached = match (dim, chain) {
        (2, false) => pass::<2, 4>(feed),
        (2, true) => pass::<2, 2>(feed),
        (_, false) => pass::<3, 6>(feed),
        (_, true) => pass::<3, 3>(feed),
    };
    Outcome {
        dim,
        chain,
        reached,
    }
}

fn pass<const DIM: usize, const D: usize>(feed: &mut Feed<'_>) -> Reached {
    let (mut s, lanes) = structure::structure(feed, DIM, D == DIM);
    for _ in 0..feed.below(4) {
        structure::spoil(feed, &mut s);
    }
    let Some((geometry, shape)) = settled::<DIM, D>(feed, s) else {
        return Reached::Nothing;
    };
    let lanes = spoilt_lanes(feed, lanes);
    let (geometry, shape) = altered(feed, geometry, shape);
    read_at_rest(feed, &geometry, &shape, &lanes);
    let Some(prepared) = prepared(feed, &geometry, &shape, &lanes) else {
        return Reached::Equilibrium;
    };
    match told(stepping::run(feed, &prepared)) {
        None => Reached::Prepared,
        Some(()) => Reached::Run,
    }
}

fn settled<const DIM: usize, const D: usize>(
    feed: &mut Feed<'_>,
    s: arcless_core::structure::Structure,
) -> Option<(Geometry<DIM, D>, Shape<D>)> {
    let mut geometry = told(Geometry::<DIM, D>::new(s))?;
    let start = if feed.flag() {
        geometry.initial_shape()
    } else {
        told(geometry.design())?
    };
    let shape = told(geometry.find_equilibrium(&start))?;
    assert_finite("shape", shape.iter().flatten().copied());
    let links = geometry.structure.links.iter();
    assert_finite("link lengths", links.map(|l| l.rest_length));
    Some((geometry, shape))
}

fn spoilt_lanes(feed: &mut Feed<'_>, mut lanes: Vec<Vec<usize>>) -> Vec<Vec<usize>> {
    match feed.below(16) {
        0..=11 => (),
        12 => feed.disturb(&mut lanes),
        13 => lanes.iter_mut().for_each(|lane| feed.disturb(lane)),
        14 => lanes.iter_mut().for_each(|lane| lane.reverse()),
        _ => lanes
            .iter_mut()
            .flatten()
            .for_each(|k| *k = feed.index(*k + 1)),
    }
    lanes
}

/// The structure changed after its design, or as it was when that fails.
fn altered<const DIM: usize, const D: usize>(
    feed: &mut Feed<'_>,
    geometry: Geometry<DIM, D>,
    shape: Shape<D>,
) -> (Geometry<DIM, D>, Shape<D>) {
    if !feed.flag() {
        return (geometry, shape);
    }
    let s = &geometry.structure;
    let (elements, links) = (s.wires.len() + s.segments.len(), s.links.len());
    let mut change = Alteration {
        length_factor: vec![feed.number(1.0); elements],
        axial_factor: vec![feed.number(1.0); elements],
        bending_factor: vec![feed.number(1.0); s.wires.len() + s.bends.len()],
        mass: vec![feed.number(1.35); elements],
        load: vec![[0.0, feed.number(1.0), 0.0]; elements],
        link_factor: vec![feed.number(1.0); links],
        link_offset: vec![feed.number(0.0); links],
        removed: (0..feed.below(3)).collect(),
        ..Alteration::default()
    };
    // One number for all offsets: the bytes of the corpus that follow keep their meaning.
    let offset = change.link_offset.first().copied().unwrap_or(0.0);
    change.spring_offset = vec![offset; s.springs.len()];
    change.strut_offset = vec![offset; s.struts.len()];
    let ends = s.ends.iter();
    change.end_force = ends.map(|e| e.released.then_some(e.force)).collect();
    if feed.flag() {
        let at = feed.below(4);
        let lists = [&mut change.length_factor, &mut change.mass];
        let lists = lists.into_iter().chain([&mut change.link_factor]);
        match lists.into_iter().nth(at) {
            Some(list) => feed.disturb(list),
            None => feed.disturb(&mut change.removed),
        }
    }
    match told(geometry.altered(&shape, &change)) {
        None => (geometry, shape),
        Some((geometry, shape)) => {
            assert_finite("altered shape", shape.iter().flatten().copied());
            (geometry, shape)
        }
    }
}

/// Elasticity, frequencies, forces of loads: what is asked of a line at rest.
fn read_at_rest<const DIM: usize, const D: usize>(
    feed: &mut Feed<'_>,
    geometry: &Geometry<DIM, D>,
    shape: &Shape<D>,
    lanes: &[Vec<usize>],
) {
    let Some(paths) = told(Slideline::from_elements(geometry, shape, lanes)) else {
        return;
    };
    let s = &geometry.structure;
    let loads = vec![[0.0, feed.number(1.0), 0.0]; s.wires.len() + s.segments.len()];
    if let Some(forces) = told(geometry.nodal_forces(&loads)) {
        assert_finite("nodal forces", forces.iter().map(|f| f.2));
    }
    let line = LinearModel::new(geometry, shape.clone());
    let Some(mut still) = told(StaticSolver::new(&line)) else {
        return;
    };
    let (x, force) = ([feed.number(4.0), 7.5], feed.number(50.0));
    if let Some(found) = told(still.elasticity(&paths, &x, force)) {
        assert_finite("elasticity", found);
    }
    if let Some(found) = told(line.frequencies(feed.below(9))) {
        assert_finite("frequencies", found);
    }
    let places: Vec<_> = paths
        .iter()
        .filter_map(|path| path.locate(x[0], 0))
        .collect();
    if let Some(found) = told(line.modes_moved(&places, 9)) {
        assert_finite("modes moved", found.diagonal.into_iter().chain(found.off));
    }
}

fn prepared<const DIM: usize, const D: usize>(
    feed: &mut Feed<'_>,
    geometry: &Geometry<DIM, D>,
    shape: &Shape<D>,
    lanes: &[Vec<usize>],
) -> Option<WireModel<DIM, D>> {
    let paths = told(Slideline::from_elements(geometry, shape, lanes))?;
    let (scheme, h) = (motion::scheme(feed), feed.number(1e-3));
    let contact = [5e4, f64::INFINITY][feed.below(2)];
    let contact = feed.number(contact);
    let line = LinearModel::new(geometry, shape.clone());
    told(if feed.flag() {
        WireModel::updated(geometry, line, paths, scheme, h, contact)
    } else {
        WireModel::new(line, paths, scheme, h, contact)
    })
}
