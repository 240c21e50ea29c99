//! Recording only what lies near the pantographs: a line may have thousands of links, of which a
//! few dozen are moved at any time.

use crate::error::CoreError;

/// Links and nodes of which only those near the pantographs are recorded.
#[derive(Debug, Clone)]
pub struct Near {
    /// Distance behind the last pantograph at which a row begins, m.
    pub behind: f64,
    /// Links in the order along the track.
    pub links: SortedStations,
    /// Nodes in the order along the track.
    pub nodes: SortedStations,
}

/// Things in the order along the track, of which a fixed number in a row is recorded.
#[derive(Debug, Clone)]
pub struct SortedStations {
    /// Their numbers.
    pub of: Vec<usize>,
    /// Their coordinates, ascending, m.
    pub x: Vec<f64>,
    /// Number of them in a row.
    pub count: usize,
}

impl Near {
    /// # Errors
    /// [`CoreError::Input`] for coordinates out of order, or what is not there.
    pub(crate) fn check(&self, links: usize, nodes: usize) -> Result<(), CoreError> {
        let sound = self.behind.is_finite() && self.links.fits(links) && self.nodes.fits(nodes);
        let reason = "what is near is not there, or not in the order along the track";
        sound.then_some(()).ok_or(CoreError::Input {
            array: "plan",
            reason: reason.into(),
        })
    }

    /// Where a row begins with the first pantograph at a position, m.
    pub(crate) fn from(&self, position: f64, distances: &[f64]) -> f64 {
        let last = distances.iter().fold(0.0_f64, |d, v| d.max(*v));
        position - last - self.behind
    }
}

impl Near {
    /// Smallest coordinate from which anything is recorded in a row that begins at `from`: the last
    /// rows hold the end of the line.
    pub(crate) fn first_recorded(&self, from: f64) -> f64 {
        [&self.links, &self.nodes]
            .into_iter()
            .filter_map(|ordered| ordered.x.get(ordered.first(from)))
            .fold(from, |least, x| least.min(*x))
    }
}

impl SortedStations {
    /// Place in the order of the first that a row holds, which begins at a coordinate.
    pub(crate) fn first(&self, x: f64) -> usize {
        let first = self.x.partition_point(|p| *p < x);
        first.min(self.of.len() - self.count)
    }

    /// Returns the numbers of a row.
    pub(crate) fn row(&self, first: usize) -> &[usize] {
        &self.of[first..first + self.count]
    }

    pub(crate) fn fits(&self, there: usize) -> bool {
        self.of.len() == self.x.len()
            && self.count <= self.of.len()
            && self.of.iter().all(|&i| i < there)
            && self.x.is_sorted()
            && self.x.iter().all(|x| x.is_finite())
    }
}

/// Selection of recorded motion.
#[derive(Debug, Clone)]
pub struct MotionPlan {
    /// Every how many steps a row is recorded.
    pub every: usize,
    /// Distance behind the last pantograph at which a row begins, m.
    pub behind: f64,
    /// Nodes of each wire in the order along it.
    pub wires: Vec<SortedStations>,
    /// Links in the order along the track.
    pub links: SortedStations,
}

impl MotionPlan {
    /// # Errors
    /// [`CoreError::Input`] for coordinates out of order, or what is not there.
    pub(crate) fn check(&self, links: usize, nodes: usize) -> Result<(), CoreError> {
        let fits = self.wires.iter().all(|wire| wire.fits(nodes)) && self.links.fits(links);
        if self.every > 0 && self.behind.is_finite() && fits {
            return Ok(());
        }
        Err(CoreError::Input {
            array: "plan",
            reason: "the motion to record is not there, or not in the order along the track".into(),
        })
    }
}
