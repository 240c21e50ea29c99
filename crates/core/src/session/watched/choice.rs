//! Choice of the nodes whose uplift is read.

use crate::error::CoreError;
use crate::session::Session;
use crate::session::snapshot::TouchPoint;
use crate::session::watched::WatchedNode;
use crate::slideline::Slideline;

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
        // Of a node between two elements the point of the second, as runs record it.
        let (_, point) = lane.node_points().filter(|(n, _)| *n == node).last()?;
        Some(TouchPoint {
            slideline,
            point,
            compliance: lane.compliance_at(&point),
        })
    })
}
