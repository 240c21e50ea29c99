//! The wire a contact runs along: which element it is on, and where in it.

use crate::element::hermite;
use crate::error::CoreError;
use crate::statics::assembly::{Geometry, Shape};

/// Vectors of a node, each of which takes a share of a force on the wire: its position, and its
/// slope where it has one.
#[must_use]
pub const fn slots<const DIM: usize, const D: usize>() -> usize {
    D / DIM
}

/// Elements of one wire in the order of the track, in their static shape.
#[derive(Debug, Clone)]
pub struct Path<const DIM: usize> {
    elements: Vec<PathElement<DIM>>,
    /// The same elements where they have moved to, with updated kinematics; else empty.
    moved: Vec<PathElement<DIM>>,
    /// Nodes along the path, one more than there are elements.
    pub nodes: Vec<usize>,
}

#[derive(Debug, Clone)]
enum PathElement<const DIM: usize> {
    /// Hermite element.
    Curve {
        rest_length: f64,
        coordinates: hermite::Coordinates<DIM>,
    },
    /// Segment of a chain, between its two ends.
    Chord([[f64; DIM]; 2]),
}

/// A place on the path: where a contact acts, and on which degrees of freedom.
#[derive(Debug, Clone, Copy, Default)]
pub struct Place {
    /// Element of the path; its nodes are `path.nodes[element]` and the next one.
    pub element: usize,
    /// Shape functions: with S [`slots`], number k belongs to slot k % S of node k / S of the two.
    pub weights: [f64; 4],
    /// Static height, m.
    pub height: f64,
    /// Static lateral position, m (zero when planar).
    pub lateral: f64,
}

/// Newton steps that invert x(ξ); the wire is nearly straight, three reach rounding.
const MOST_INVERSIONS: usize = 20;

impl<const DIM: usize> PathElement<DIM> {
    /// Coordinates of both ends along the track, m.
    fn range(&self) -> (f64, f64) {
        match self {
            Self::Curve { coordinates: e, .. } => (e[0][0], e[2][0]),
            Self::Chord(ends) => (ends[0][0], ends[1][0]),
        }
    }

    /// Shape functions at coordinate `x` along the track, to the given accuracy in m.
    fn weights(&self, x: f64, accuracy: f64) -> [f64; 4] {
        let (x0, x1) = self.range();
        let mut xi = (x - x0) / (x1 - x0);
        let Self::Curve {
            rest_length: l,
            coordinates: e,
        } = self
        else {
            return [1.0 - xi, xi, 0.0, 0.0];
        };
        for _ in 0..MOST_INVERSIONS {
            let error = hermite::interpolate(&hermite::shape(xi, *l), e)[0] - x;
            let slope = hermite::interpolate(&hermite::shape_slope(xi, *l), e)[0] * l;
            xi -= error / slope;
            if error.abs() <= accuracy {
                break;
            }
        }
        hermite::shape(xi.clamp(0.0, 1.0), *l)
    }

    /// Move both ends (position, and slope where there is one) by the displacements of their nodes.
    fn displace<const D: usize>(&mut self, ends: [&[f64; D]; 2]) {
        for (side, end) in ends.into_iter().enumerate() {
            for c in 0..DIM {
                match self {
                    Self::Curve { coordinates: e, .. } => {
                        e[2 * side][c] += end[c];
                        e[2 * side + 1][c] += end[DIM + c];
                    }
                    Self::Chord(points) => points[side][c] += end[c],
                }
            }
        }
    }

    /// Static position for given shape functions.
    fn point(&self, weights: &[f64; 4]) -> [f64; DIM] {
        match self {
            Self::Curve { coordinates, .. } => hermite::interpolate(weights, coordinates),
            Self::Chord([a, b]) => std::array::from_fn(|c| weights[0] * a[c] + weights[1] * b[c]),
        }
    }
}

/// Element `number` of the wires, in the model that `D` stands for, and its nodes.
fn element<const DIM: usize, const D: usize>(
    geometry: &Geometry<DIM, D>,
    shape: &Shape<D>,
    number: usize,
) -> Result<(PathElement<DIM>, [usize; 2]), CoreError> {
    let s = &geometry.structure;
    if slots::<DIM, D>() == 1 {
        let segment = s.segments.get(number);
        let nodes = segment.ok_or_else(|| refuse("unknown element"))?.nodes;
        let ends = nodes.map(|n| Geometry::<DIM, D>::position(shape, n));
        return Ok((PathElement::Chord(ends), nodes));
    }
    let wire = s.wires.get(number);
    let wire = wire.ok_or_else(|| refuse("unknown element"))?;
    if !wire.runs_through() {
        return Err(refuse("the wire is hinged"));
    }
    let curve = PathElement::Curve {
        rest_length: wire.section.rest_length,
        coordinates: Geometry::<DIM, D>::coordinates(shape, wire),
    };
    Ok((curve, wire.nodes))
}

fn refuse(reason: &str) -> CoreError {
    CoreError::Input {
        array: "path",
        reason: reason.into(),
    }
}

impl<const DIM: usize> Path<DIM> {
    /// Path over the given wire elements (segments of a chain), which must follow each other along
    /// the track.
    ///
    /// # Errors
    /// [`CoreError::Input`] when they do not.
    pub fn new<const D: usize>(
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        wires: &[usize],
    ) -> Result<Self, CoreError> {
        let mut nodes: Vec<usize> = Vec::with_capacity(wires.len() + 1);
        let mut elements = Vec::with_capacity(wires.len());
        for &number in wires {
            let (element, ends) = element(geometry, shape, number)?;
            if nodes.is_empty() {
                nodes.push(ends[0]);
            } else if nodes.last() != Some(&ends[0]) {
                return Err(refuse("elements do not follow each other"));
            }
            let (first, last) = element.range();
            if last <= first {
                return Err(refuse("the wire runs backwards"));
            }
            nodes.push(ends[1]);
            elements.push(element);
        }
        if elements.is_empty() {
            return Err(refuse("no elements"));
        }
        Ok(Self {
            elements,
            moved: Vec::new(),
            nodes,
        })
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
        for (element, nodes) in self.moved.iter_mut().zip(self.nodes.windows(2)) {
            element.displace([&u[nodes[0]], &u[nodes[1]]]);
            let (first, last) = element.range();
            runs_forwards &= first < last;
        }
        runs_forwards
    }

    /// Place at coordinate `x` along the track; `None` beyond the ends. `near` is the element
    /// where the search starts (contacts move little from step to step).
    #[must_use]
    pub fn locate(&self, x: f64, near: usize) -> Option<Place> {
        let present = if self.moved.is_empty() {
            &self.elements
        } else {
            &self.moved
        };
        let (first, last) = (present[0].range().0, present[present.len() - 1].range().1);
        if !(first..=last).contains(&x) {
            return None;
        }
        let mut k = near.min(present.len() - 1);
        while k > 0 && x < present[k].range().0 {
            k -= 1;
        }
        while k + 1 < present.len() && x > present[k].range().1 {
            k += 1;
        }
        let weights = present[k].weights(x, 4.0 * f64::EPSILON * last.abs());
        // The static point with these weights: displacements are added by whoever asks for them.
        let r = self.elements[k].point(&weights);
        let lateral = if DIM == 3 { r[1] } else { 0.0 };
        Some(Place {
            element: k,
            weights,
            height: r[DIM - 1],
            lateral,
        })
    }

    /// Component `c` of a displacement field at a place.
    #[inline(always)]
    #[must_use]
    pub fn displacement<const D: usize>(&self, place: &Place, x: &[[f64; D]], c: usize) -> f64 {
        let (a, b) = (
            &x[self.nodes[place.element]],
            &x[self.nodes[place.element + 1]],
        );
        let w = &place.weights;
        if slots::<DIM, D>() == 1 {
            return w[0] * a[c] + w[1] * b[c];
        }
        w[0] * a[c] + w[1] * a[DIM + c] + w[2] * b[c] + w[3] * b[DIM + c]
    }

    /// Degrees of freedom that share component `c` of a force at a place: node, component, share.
    pub fn shares<const D: usize>(
        &self,
        place: &Place,
        c: usize,
    ) -> impl Iterator<Item = (usize, usize, f64)> {
        let (slots, first, weights) = (slots::<DIM, D>(), place.element, place.weights);
        (0..2 * slots).map(move |k| {
            let node = self.nodes[first + k / slots];
            (node, k % slots * DIM + c, weights[k])
        })
    }

    /// Add a force on component `c` at a place.
    pub fn add_force<const D: usize>(
        &self,
        place: &Place,
        force: f64,
        c: usize,
        f: &mut [[f64; D]],
    ) {
        for (node, component, share) in self.shares::<D>(place, c) {
            f[node][component] += share * force;
        }
    }
}
