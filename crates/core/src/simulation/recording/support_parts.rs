//! Parts that hold the wires at a support.

use crate::linear::model::LinearModel;

/// Parts that hold the wires at a support: rows of springs and struts, where there are any.
#[derive(Debug, Clone, Copy, Default)]
pub struct SupportParts {
    /// Vertical spring of the messenger wire, or of what hangs there without one.
    pub vertical: Option<usize>,
    /// Lateral spring at the same node.
    pub lateral: Option<usize>,
    /// Steady arm.
    pub arm: Option<usize>,
}

impl SupportParts {
    /// Returns the nodes of all parts.
    pub(crate) fn nodes<const DIM: usize, const D: usize>(
        &self,
        line: &LinearModel<DIM, D>,
    ) -> impl Iterator<Item = usize> {
        let held = [self.vertical, self.lateral].into_iter().flatten();
        let held = held.map(|row| line.springs[row].node);
        held.chain(self.arm.map(|row| line.struts[row].node))
    }

    /// Returns whether all parts are among so many springs and struts.
    pub(crate) fn fits(&self, springs: usize, struts: usize) -> bool {
        let held = [self.vertical, self.lateral].into_iter().flatten();
        held.max().is_none_or(|row| row < springs) && self.arm.is_none_or(|row| row < struts)
    }
}
