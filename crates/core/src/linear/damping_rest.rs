//! Damping of the linearised line that is not common to all parts: C − α M − β K.

use crate::linalg::{Block, SymmetricBlocks};
use crate::statics::assembly::{Geometry, Shape};
use crate::structure::Rayleigh;

/// Returns the blocks of Σ (β − β₀) K over the parts whose β differs, plus all dampers.
pub(super) fn damping_rest<const DIM: usize, const D: usize>(
    geometry: &Geometry<DIM, D>,
    shape: &Shape<D>,
    common: f64,
    c: &mut SymmetricBlocks<D>,
) -> Vec<(usize, usize, Block<D>)> {
    let s = &geometry.structure;
    c.clear();
    for wire in s.wires.iter().filter(|w| w.damping.beta != common) {
        Geometry::<DIM, D>::add_wire(c, shape, wire, wire.damping.beta - common);
    }
    for segment in s.segments.iter().filter(|k| k.damping.beta != common) {
        let difference = segment.damping.beta - common;
        Geometry::<DIM, D>::add_segment(c, shape, segment, difference);
    }
    if s.across_only {
        subtract_stretching(geometry, shape, |damping| damping.beta - common, c);
    }
    for bend in s.bends.iter().filter(|b| b.beta != common) {
        geometry.add_bend(c, bend, bend.beta - common);
    }
    for link in &s.links {
        let damping = Geometry::<DIM, D>::link_damping(shape, link, link.damping.beta - common);
        Geometry::<DIM, D>::add_between(c, link.nodes, &damping);
    }
    for strut in s.struts.iter().filter(|_| common != 0.0) {
        Geometry::<DIM, D>::add_strut(c, shape, strut, -common);
    }
    for spring in &s.springs {
        let value = spring.viscosity - common * spring.stiffness;
        Geometry::<DIM, D>::add_spring(c, spring, value);
    }
    let mut rest = Vec::new();
    for i in 0..c.rows() {
        for k in c.row_start[i]..c.row_start[i + 1] {
            if c.blocks[k].iter().flatten().any(|&v| v != 0.0) {
                rest.push((i, c.columns[k], c.blocks[k]));
            }
        }
    }
    rest
}

/// Subtracts the axial part of the tangents of all wires, times a factor that depends on their
/// damping.
pub(super) fn subtract_stretching<const DIM: usize, const D: usize>(
    geometry: &Geometry<DIM, D>,
    shape: &Shape<D>,
    factor: impl Fn(Rayleigh) -> f64,
    k: &mut SymmetricBlocks<D>,
) {
    for wire in &geometry.structure.wires {
        Geometry::<DIM, D>::add_wire_stretching(k, shape, wire, -factor(wire.damping));
    }
    for segment in &geometry.structure.segments {
        Geometry::<DIM, D>::add_segment_stretching(k, shape, segment, -factor(segment.damping));
    }
}
