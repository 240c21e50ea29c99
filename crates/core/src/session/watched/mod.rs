//! Nodes whose uplift a session reads after each step: those of the contact wire at supports.

mod choice;

use crate::session::snapshot::{Snapshot, TouchPoint};
use crate::session::subgrid_height::height_above_mesh;
use crate::slideline::point::Nodal;

/// Node whose uplift is read.
#[derive(Debug, Clone, Copy)]
pub(crate) struct WatchedNode<const DIM: usize> {
    pub(crate) node: usize,
    /// Its place on a slideline that yields beyond the mesh.
    place: Option<TouchPoint<DIM>>,
}

/// Reads the uplift of watched nodes at the end of the step, m.
pub(crate) fn read_uplifts<const DIM: usize, const D: usize>(
    watched: &[WatchedNode<DIM>],
    snapshot: &Snapshot<'_, DIM, D>,
    forces: &[f64],
    uplifts: &mut [f64],
) {
    let u = snapshot.motion.wires.displacement();
    for (uplift, watched) in uplifts.iter_mut().zip(watched) {
        *uplift = u.at(watched.node)[DIM - 1];
        if let Some(place) = &watched.place {
            let height = height_above_mesh(snapshot, forces, place, 0.0);
            *uplift += height - place.compliance.static_height;
        }
    }
}
