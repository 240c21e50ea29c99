//! Nodes whose uplift a session reads after each step: those of the contact wire at supports.

use crate::error::CoreError;
use crate::session::Session;
use crate::session::snapshot::{Snapshot, TouchPoint};
use crate::session::subgrid_height::height_above_mesh;
use crate::slideline::Slideline;
use crate::slideline::point::Nodal;

/// Node whose uplift is read.
#[derive(Debug, Clone, Copy)]
pub(crate) struct WatchedNode<const DIM: usize> {
    pub(crate) node: usize,
    /// Its place on a slideline that yields beyond the mesh.
    place: Option<TouchPoint<DIM>>,
}

impl<const DIM: usize, const D: usize> Session<DIM, D> {
    /// Chooses the nodes whose uplift the outputs have from now on, before the first step.
    ///
    /// # Errors
    /// [`CoreError::Input`] for a node that does not exist, or after a step.
    pub fn watch(&mut self, nodes: &[usize]) -> Result<(), CoreError> {
        let count = self.nodes();
        if let Some(node) = nodes.iter().find(|&&node| node >= count) {
            return Err(CoreError::invalid("nodes", format!("{node} of {count}")));
        }
        if self.steps() > 0 {
            let reason = "steps have been taken, in which they were not watched";
            return Err(CoreError::invalid("nodes", reason));
        }
        let line = &*self.model.line;
        line.track_nodes(&mut self.state.motion.wires, nodes.iter().copied());
        let watched = nodes.iter().map(|&node| WatchedNode {
            node,
            place: place(&line.slidelines, node),
        });
        self.watched = watched.collect();
        self.outputs.uplift = vec![0.0; nodes.len()];
        self.read_outputs()
    }

    /// Numbers of the watched nodes, as a saved state has them.
    pub(crate) fn watched_numbers(&self) -> Vec<f64> {
        self.watched.iter().map(|w| w.node as f64).collect()
    }
}

fn place<const DIM: usize>(lanes: &[Slideline<DIM>], node: usize) -> Option<TouchPoint<DIM>> {
    let mut yielding = lanes.iter().enumerate().filter(|(_, s)| !s.is_rigid());
    yielding.find_map(|(slideline, lane)| {
        let (_, point) = lane.node_points().find(|(other, _)| *other == node)?;
        Some(TouchPoint {
            slideline,
            point,
            compliance: lane.compliance_at(&point),
        })
    })
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
