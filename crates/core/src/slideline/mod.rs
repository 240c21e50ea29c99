//! The lanes that contacts run along: which element a place is on, and where in it.
//!
//! A lane is one wire, or several one behind the other with gaps between them. Several lanes lie
//! side by side, or take over from one another where they overlap along the track.

pub(crate) mod element;
pub mod point;
pub mod residual_flexibility;
pub(crate) mod smoothed_segment;
pub(crate) mod smoothing;

use crate::error::CoreError;
use crate::slideline::element::{SlidelineElement, element};
use crate::slideline::point::{Nodal, SlidelinePoint};
use crate::slideline::residual_flexibility::LocalCompliances;
use crate::statics::assembly::{Geometry, Shape};

/// Elements of a lane in the order of the track, in their static shape.
#[derive(Debug, Clone)]
pub struct Slideline<const DIM: usize> {
    pub(crate) elements: Vec<SlidelineElement<DIM>>,
    /// The same elements where they have moved to, with updated kinematics; else empty.
    moved: Vec<SlidelineElement<DIM>>,
    /// Nodes of each element.
    pub(crate) ends: Vec<[usize; 2]>,
    /// Wire of each element, counted along the lane.
    pub(crate) wires: Vec<usize>,
    /// Nodes along the lane, wire by wire: each wire has one more than it has elements.
    pub nodes: Vec<usize>,
    /// Number of nodes in the lanes before this one.
    before: usize,
    pub(crate) yields: LocalCompliances,
}

pub(crate) fn refuse(reason: &str) -> CoreError {
    CoreError::Input {
        array: "lanes",
        reason: reason.into(),
    }
}

/// Elements that the search for a place goes from where it starts, one by one: more than a contact moves
/// in a time step.
const STEPS: usize = 4;

impl<const DIM: usize> Slideline<DIM> {
    /// One path for each list of wire elements (segments of a chain).
    ///
    /// # Errors
    /// Those of [`Slideline::new`]; also [`CoreError::Input`] without lanes, or when an element is in two.
    pub fn lanes<const D: usize>(
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        lanes: &[Vec<usize>],
    ) -> Result<Vec<Self>, CoreError> {
        let mut numbers = lanes.concat();
        numbers.sort_unstable();
        if lanes.is_empty() || numbers.windows(2).any(|pair| pair[0] == pair[1]) {
            return Err(refuse("none, or an element that is in two places"));
        }
        let mut before = 0;
        let lanes = lanes.iter().map(|wires| {
            let path = Self::new(geometry, shape, wires)?;
            let path = Self { before, ..path };
            before += path.nodes.len();
            Ok(path)
        });
        lanes.collect()
    }

    /// A lane over the given wire elements (segments of a chain) in the order of the track. An
    /// element that shares no node with the one before begins a new wire, which must not overlap it.
    ///
    /// # Errors
    /// [`CoreError::Input`] when they do not lie one behind the other.
    pub fn new<const D: usize>(
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        wires: &[usize],
    ) -> Result<Self, CoreError> {
        if wires.is_empty() {
            return Err(refuse("no elements"));
        }
        let mut lane = Self {
            elements: Vec::with_capacity(wires.len()),
            moved: Vec::new(),
            ends: Vec::with_capacity(wires.len()),
            wires: Vec::with_capacity(wires.len()),
            nodes: Vec::with_capacity(wires.len() + 1),
            before: 0,
            yields: LocalCompliances::default(),
        };
        for &number in wires {
            let (element, ends) = element(geometry, shape, number)?;
            lane.push(element, ends)?;
        }
        Ok(lane)
    }

    fn push(&mut self, element: SlidelineElement<DIM>, ends: [usize; 2]) -> Result<(), CoreError> {
        let (first, last) = element.range();
        if last <= first {
            return Err(refuse("the wire runs backwards"));
        }
        let mut wire = self.wires.last().copied().unwrap_or(0);
        if self.nodes.last() != Some(&ends[0]) {
            if self.elements.last().is_some_and(|e| e.range().1 > first) {
                return Err(refuse("the wires of a lane overlap along the track"));
            }
            wire += usize::from(!self.elements.is_empty());
            self.nodes.push(ends[0]);
        }
        self.nodes.push(ends[1]);
        self.elements.push(element);
        self.ends.push(ends);
        self.wires.push(wire);
        Ok(())
    }

    /// Nodes of the element of a place and of two on each side: where it acts now, and in the next step.
    pub(crate) fn around(&self, place: &SlidelinePoint<DIM>) -> impl Iterator<Item = usize> + '_ {
        let last = (place.element + 3).min(self.ends.len());
        let elements = &self.ends[place.element.saturating_sub(2)..last];
        elements.iter().flatten().copied()
    }

    /// First and last coordinate along the track, m.
    #[must_use]
    pub fn range(&self) -> (f64, f64) {
        let last = self.elements.len() - 1;
        (self.elements[0].range().0, self.elements[last].range().1)
    }

    /// From now on, places are found on the wire displaced by `u`. Tells whether every element still
    /// runs along the track.
    pub fn follow<const D: usize>(&mut self, u: &[[f64; D]]) -> bool {
        self.moved.clone_from(&self.elements);
        let mut runs_forwards = true;
        for (element, nodes) in self.moved.iter_mut().zip(&self.ends) {
            element.displace([&u[nodes[0]], &u[nodes[1]]]);
            let (first, last) = element.range();
            runs_forwards &= first < last;
        }
        runs_forwards
    }

    fn present(&self) -> &[SlidelineElement<DIM>] {
        if self.moved.is_empty() {
            &self.elements
        } else {
            &self.moved
        }
    }

    /// Place at coordinate `x` along the track; `None` beyond the ends and in gaps. `near` is the
    /// element where the search starts (contacts move little from step to step).
    #[must_use]
    pub fn locate(&self, x: f64, near: usize) -> Option<SlidelinePoint<DIM>> {
        let present = self.present();
        let (first, last) = (present[0].range().0, present[present.len() - 1].range().1);
        if !(first..=last).contains(&x) {
            return None;
        }
        let mut k = near.min(present.len() - 1);
        for _ in 0..STEPS {
            if k > 0 && x < present[k].range().0 {
                k -= 1;
            } else if k + 1 < present.len() && x > present[k].range().1 {
                k += 1;
            } else {
                break;
            }
        }
        // A lane that has had no wire for long: the element that steps would end at, by halving.
        if x < present[k].range().0 {
            k = present.partition_point(|one| one.range().0 <= x) - 1;
        } else if x > present[k].range().1 {
            k = present.partition_point(|one| one.range().1 < x);
        }
        // Otherwise it is in a gap.
        let (from, to) = present[k].range();
        (from..=to).contains(&x).then(|| self.place(k, x))
    }

    /// Place at coordinate `x` on the wire of element `near`, at its end when that is nearer.
    #[must_use]
    pub(crate) fn on_wire(&self, x: f64, near: usize) -> SlidelinePoint<DIM> {
        let present = self.present();
        let mut k = near.min(present.len() - 1);
        while k > 0 && self.wires[k - 1] == self.wires[k] && x < present[k].range().0 {
            k -= 1;
        }
        let is_last = |k: usize| self.wires.get(k + 1) != Some(&self.wires[k]);
        while !is_last(k) && x > present[k].range().1 {
            k += 1;
        }
        let (first, last) = present[k].range();
        self.place(k, x.clamp(first, last))
    }

    /// Whether two places are on the same wire.
    #[must_use]
    pub(crate) fn is_one_wire(&self, a: &SlidelinePoint<DIM>, b: &SlidelinePoint<DIM>) -> bool {
        self.wires[a.element] == self.wires[b.element]
    }

    /// Place on element `k` at coordinate `x`, which lies on it.
    fn place(&self, k: usize, x: f64) -> SlidelinePoint<DIM> {
        let present = self.present();
        let last = present[present.len() - 1].range().1;
        let weights = present[k].weights(x, 4.0 * f64::EPSILON * last.abs());
        self.weighted(k, weights)
    }

    /// Slope dz/dx of the wire displaced by `u`, on the element of `near` at coordinate `x`.
    pub(crate) fn slope<const D: usize>(
        &self,
        x: f64,
        near: &SlidelinePoint<DIM>,
        u: &(impl Nodal<D> + ?Sized),
    ) -> f64 {
        let accuracy = 4.0 * f64::EPSILON * x.abs();
        let slopes = self.elements[near.element].slopes(x, accuracy);
        let place = self.weighted(near.element, slopes);
        place.height + place.displacement(u, DIM - 1)
    }

    /// Place on element `k` with known shape functions; `None` when there is no such element.
    pub(crate) fn at(&self, k: usize, weights: [f64; 4]) -> Option<SlidelinePoint<DIM>> {
        (k < self.elements.len()).then(|| self.weighted(k, weights))
    }

    /// Whether a place is on this lane.
    pub(crate) fn holds(&self, place: &SlidelinePoint<DIM>) -> bool {
        (self.before..self.before + self.nodes.len()).contains(&place.number)
    }

    /// The nodes of the lane with their places, those between two elements twice.
    pub(crate) fn ends(&self) -> impl Iterator<Item = (usize, SlidelinePoint<DIM>)> {
        self.ends.iter().enumerate().flat_map(move |(k, nodes)| {
            let at = |side: usize| (nodes[side], self.weighted(k, self.elements[k].end(side)));
            [at(0), at(1)]
        })
    }

    fn weighted(&self, k: usize, weights: [f64; 4]) -> SlidelinePoint<DIM> {
        // The static point with these weights: displacements are added by whoever asks for them.
        let r = self.elements[k].point(&weights);
        let (first, count) = self.elements[k].window();
        // Place of its first node along the lane.
        let number = k + self.wires[k] - first;
        SlidelinePoint {
            element: k,
            nodes: std::array::from_fn(|i| self.nodes[number + i.min(count - 1)]),
            count,
            number: self.before + number,
            weights,
            height: r[DIM - 1],
            lateral: if DIM == 3 { r[1] } else { 0.0 },
        }
    }
}
