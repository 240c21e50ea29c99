//! Damping of the linearised line that is not common to all parts: C − α M − β K.

use crate::linalg::{Block, SymmetricBlocks};
use crate::linear::island::Island;
use crate::linear::model::{LinearModel, subtract_stretching};
use crate::statics::assembly::{Geometry, Shape};

impl<const DIM: usize, const D: usize> LinearModel<DIM, D> {
    /// Adds d (C − α M − β K), the damping that is not common to all parts.
    pub fn add_damping_rest_matrix(&self, d: f64, a: &mut SymmetricBlocks<D>) {
        for (i, j, block) in &self.damping_rest {
            let mut scaled = *block;
            scaled.iter_mut().flatten().for_each(|v| *v *= d);
            a.add(*i, *j, &scaled);
        }
    }

    /// Adds (C − α M − β K) x to `y` on one island: the damping that is not common to all parts.
    /// `work` is scratch space.
    #[inline(always)]
    pub fn add_damping_rest(
        &self,
        island: &Island,
        x: &[[f64; D]],
        y: &mut [[f64; D]],
        work: &mut [[f64; D]],
    ) {
        if let Some(rest) = &self.mass_damping_rest {
            rest.product_at(island.nodes.clone(), x, work);
            let nodes = y[island.nodes.clone()].iter_mut();
            for (y, w) in nodes.zip(&work[island.nodes.clone()]) {
                for c in 0..D {
                    y[c] += w[c];
                }
            }
        }
        for (i, j, block) in &self.damping_rest[island.damping.clone()] {
            let (xi, xj) = (x[*i], x[*j]);
            crate::linalg::block::add_product(&mut y[*i], block, &xj);
            if i != j {
                for a in 0..D {
                    for b in 0..D {
                        y[*j][b] += block[a][b] * xi[a];
                    }
                }
            }
        }
    }
}

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
