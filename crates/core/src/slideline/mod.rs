//! Slidelines: the wires that contacts slide along, and the points on them.
//!
//! A slideline is one wire, or several one behind the other with gaps between them. Several
//! slidelines are side by side, or relieve one another where they overlap along the track.

pub(crate) mod element;
pub mod local_compliance;
pub mod point;
pub(crate) mod residual_flexibility;
pub(crate) mod smoothed_segment;
pub(crate) mod smoothing;

use crate::error::CoreError;
use crate::slideline::element::{SlidelineElement, element};
use crate::slideline::local_compliance::{LocalCompliance, LocalCompliances};
use crate::slideline::point::{Nodal, SlidelinePoint};
use crate::statics::assembly::{Geometry, Shape};

/// Slideline: elements in the order of the track, in their static shape.
#[derive(Debug, Clone)]
pub struct Slideline<const DIM: usize> {
    pub(crate) elements: Vec<SlidelineElement<DIM>>,
    /// Elements at their present position, with updated kinematics; else empty.
    moved: Vec<SlidelineElement<DIM>>,
    /// Nodes of each element.
    pub(crate) ends: Vec<[usize; 2]>,
    /// Wire of each element, counted along the slideline.
    pub(crate) wires: Vec<usize>,
    /// Nodes along the slideline, wire by wire: each wire has one more than it has elements.
    pub nodes: Vec<usize>,
    /// Number of nodes in the slidelines before this one.
    first_node: usize,
    pub(crate) compliances: LocalCompliances,
}

/// Number of elements that the search for a point passes one by one: more than a contact moves in a
/// time step.
const SEARCH_STEPS: usize = 4;

impl<const DIM: usize> Slideline<DIM> {
    /// Slidelines from lists of wire elements (segments of a chain), one for each list.
    ///
    /// # Errors
    /// Errors of [`Slideline::new`]; also [`CoreError::Input`] without lists, or when an element is
    /// in two.
    pub fn from_elements<const D: usize>(
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        lists: &[Vec<usize>],
    ) -> Result<Vec<Self>, CoreError> {
        let mut numbers = lists.concat();
        numbers.sort_unstable();
        if lists.is_empty() || numbers.windows(2).any(|pair| pair[0] == pair[1]) {
            return Err(CoreError::invalid(
                "lanes",
                "none, or an element that is in two places",
            ));
        }
        let mut first_node = 0;
        let slidelines = lists.iter().map(|elements| {
            let slideline = Self::new(geometry, shape, elements)?;
            let slideline = Self {
                first_node,
                ..slideline
            };
            first_node += slideline.nodes.len();
            Ok(slideline)
        });
        slidelines.collect()
    }

    /// Slideline over the given wire elements (segments of a chain) in the order of the track. An
    /// element that shares no node with the one before begins a new wire, which must not overlap
    /// it.
    ///
    /// # Errors
    /// [`CoreError::Input`] when they do not lie one behind the other.
    pub fn new<const D: usize>(
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        numbers: &[usize],
    ) -> Result<Self, CoreError> {
        if numbers.is_empty() {
            return Err(CoreError::invalid("lanes", "no elements"));
        }
        let mut slideline = Self {
            elements: Vec::with_capacity(numbers.len()),
            moved: Vec::new(),
            ends: Vec::with_capacity(numbers.len()),
            wires: Vec::with_capacity(numbers.len()),
            nodes: Vec::with_capacity(numbers.len() + 1),
            first_node: 0,
            compliances: LocalCompliances::default(),
        };
        for &number in numbers {
            let (element, ends) = element(geometry, shape, number)?;
            slideline.push(element, ends)?;
        }
        Ok(slideline)
    }

    /// Appends an element with its two nodes.
    fn push(&mut self, element: SlidelineElement<DIM>, ends: [usize; 2]) -> Result<(), CoreError> {
        let (first, last) = element.range();
        if last <= first {
            return Err(CoreError::invalid("lanes", "the wire runs backwards"));
        }
        let mut wire = self.wires.last().copied().unwrap_or(0);
        if self.nodes.last() != Some(&ends[0]) {
            if self.elements.last().is_some_and(|e| e.range().1 > first) {
                return Err(CoreError::invalid(
                    "lanes",
                    "the wires of a lane overlap along the track",
                ));
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

    /// Nodes of the element of a point and of two elements on each side, which a contact there acts
    /// on in this step and in the next one.
    pub(crate) fn nodes_around(
        &self,
        point: &SlidelinePoint<DIM>,
    ) -> impl Iterator<Item = usize> + '_ {
        let last = (point.element + 3).min(self.ends.len());
        let elements = &self.ends[point.element.saturating_sub(2)..last];
        elements.iter().flatten().copied()
    }

    /// First and last coordinate along the track, m.
    #[must_use]
    pub fn range(&self) -> (f64, f64) {
        let last = self.elements.len() - 1;
        (self.elements[0].range().0, self.elements[last].range().1)
    }

    /// Moves the elements on which points are found to the wire displaced by `u`, m; returns
    /// whether every element still runs along the track.
    pub fn update_geometry<const D: usize>(&mut self, u: &[[f64; D]]) -> bool {
        self.moved.clone_from(&self.elements);
        let mut runs_forwards = true;
        for (element, nodes) in self.moved.iter_mut().zip(&self.ends) {
            element.displace([&u[nodes[0]], &u[nodes[1]]]);
            let (first, last) = element.range();
            runs_forwards &= first < last;
        }
        runs_forwards
    }

    /// Elements at their present position.
    fn present(&self) -> &[SlidelineElement<DIM>] {
        if self.moved.is_empty() {
            &self.elements
        } else {
            &self.moved
        }
    }

    /// Point at coordinate `x` along the track, m; `None` beyond the ends and in gaps. `near` is
    /// the element where the search starts (contacts move little from step to step).
    #[must_use]
    pub fn locate(&self, x: f64, near: usize) -> Option<SlidelinePoint<DIM>> {
        let present = self.present();
        let (first, last) = (present[0].range().0, present[present.len() - 1].range().1);
        if !(first..=last).contains(&x) {
            return None;
        }
        let mut k = near.min(present.len() - 1);
        for _ in 0..SEARCH_STEPS {
            if k > 0 && x < present[k].range().0 {
                k -= 1;
            } else if k + 1 < present.len() && x > present[k].range().1 {
                k += 1;
            } else {
                break;
            }
        }
        // No wire for long: the element that single steps would end at, by halving.
        if x < present[k].range().0 {
            k = present.partition_point(|element| element.range().0 <= x) - 1;
        } else if x > present[k].range().1 {
            k = present.partition_point(|element| element.range().1 < x);
        }
        // Otherwise it is in a gap.
        let (from, to) = present[k].range();
        (from..=to).contains(&x).then(|| self.point_at(k, x))
    }

    /// Point of the wire of element `near` that is nearest to coordinate `x` along the track, m.
    #[must_use]
    pub(crate) fn nearest_on_wire(&self, x: f64, near: usize) -> SlidelinePoint<DIM> {
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
        self.point_at(k, x.clamp(first, last))
    }

    /// Tells whether two points are on the same wire.
    #[must_use]
    pub(crate) fn is_same_wire(&self, a: &SlidelinePoint<DIM>, b: &SlidelinePoint<DIM>) -> bool {
        self.wires[a.element] == self.wires[b.element]
    }

    /// Point of element `k` at coordinate `x` along the track, m, which is on it.
    fn point_at(&self, k: usize, x: f64) -> SlidelinePoint<DIM> {
        let present = self.present();
        let last = present[present.len() - 1].range().1;
        let weights = present[k].weights(x, 4.0 * f64::EPSILON * last.abs());
        self.weighted_point(k, weights)
    }

    /// Slope dz/dx of the wire displaced by `u`, m, on the element of `near` at coordinate `x`, m.
    pub(crate) fn slope<const D: usize>(
        &self,
        x: f64,
        near: &SlidelinePoint<DIM>,
        u: &(impl Nodal<D> + ?Sized),
    ) -> f64 {
        let accuracy = 4.0 * f64::EPSILON * x.abs();
        let slopes = self.elements[near.element].weight_slopes(x, accuracy);
        let derivative = self.weighted_point(near.element, slopes);
        derivative.height + derivative.displacement(u, DIM - 1)
    }

    /// Point of element `k` with known shape functions; `None` when there is no such element.
    pub(crate) fn point_on(&self, k: usize, weights: [f64; 4]) -> Option<SlidelinePoint<DIM>> {
        (k < self.elements.len()).then(|| self.weighted_point(k, weights))
    }

    /// Tells whether a point is on this slideline.
    pub(crate) fn contains(&self, point: &SlidelinePoint<DIM>) -> bool {
        (self.first_node..self.first_node + self.nodes.len()).contains(&point.number)
    }

    /// Nodes of the slideline with their points, those between two elements twice.
    pub(crate) fn node_points(&self) -> impl Iterator<Item = (usize, SlidelinePoint<DIM>)> {
        self.ends.iter().enumerate().flat_map(move |(k, nodes)| {
            let point = |side: usize| {
                let weights = self.elements[k].end_weights(side);
                (nodes[side], self.weighted_point(k, weights))
            };
            [point(0), point(1)]
        })
    }

    /// Point of element `k` with the given shape functions.
    fn weighted_point(&self, k: usize, weights: [f64; 4]) -> SlidelinePoint<DIM> {
        // Static position; displacements are added where they are needed.
        let r = self.elements[k].point(&weights);
        let (first, count) = self.elements[k].node_window();
        // Number of its first node along the slideline.
        let number = k + self.wires[k] - first;
        SlidelinePoint {
            element: k,
            nodes: std::array::from_fn(|i| self.nodes[number + i.min(count - 1)]),
            count,
            number: self.first_node + number,
            weights,
            height: r[DIM - 1],
            lateral: if DIM == 3 { r[1] } else { 0.0 },
        }
    }

    /// Local compliance of the wire at a point.
    #[inline]
    pub(crate) fn compliance_at(&self, point: &SlidelinePoint<DIM>) -> LocalCompliance {
        match &self.compliances {
            LocalCompliances::Nothing => LocalCompliance::default(),
            LocalCompliances::OfCubics(elements) => elements[point.element].at(&point.weights),
            LocalCompliances::OfChains => LocalCompliance::of_chain(
                self.elements[point.element].residual_flexibility(&point.weights),
            ),
        }
    }

    /// Tells whether there is no residual flexibility, so that the wire is as compliant as the
    /// mesh.
    pub(crate) fn is_rigid(&self) -> bool {
        matches!(self.compliances, LocalCompliances::Nothing)
    }

    /// Residual flexibility R(a, b) between two points of the slideline, m/N.
    pub(crate) fn residual_flexibility(
        &self,
        a: &SlidelinePoint<DIM>,
        b: &SlidelinePoint<DIM>,
    ) -> f64 {
        let (first, second) = if a.element <= b.element {
            (a, b)
        } else {
            (b, a)
        };
        match &self.compliances {
            LocalCompliances::Nothing => 0.0,
            LocalCompliances::OfCubics(elements) => {
                local_compliance::between(elements, first, second)
            }
            LocalCompliances::OfChains => {
                let [element, other] = [first, second].map(|point| &self.elements[point.element]);
                element.residual_flexibility_between(&first.weights, other, &second.weights)
            }
        }
    }
}
