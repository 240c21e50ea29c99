//! The wire a contact runs along: which element it is on, and where in it.

use crate::element::hermite;
use crate::error::CoreError;
use crate::statics::assembly::{Geometry, Shape};

/// Elements of one wire in the order of the track, in their static shape.
#[derive(Debug, Clone)]
pub struct Path<const DIM: usize> {
    elements: Vec<PathElement<DIM>>,
    /// Nodes along the path, one more than there are elements.
    pub nodes: Vec<usize>,
}

#[derive(Debug, Clone)]
struct PathElement<const DIM: usize> {
    rest_length: f64,
    coordinates: hermite::Coordinates<DIM>,
}

/// A place on the path: where a contact acts, and on which degrees of freedom.
#[derive(Debug, Clone, Copy, Default)]
pub struct Place {
    /// Element of the path; its nodes are `path.nodes[element]` and the next one.
    pub element: usize,
    /// Shape functions of the four coordinates.
    pub weights: [f64; 4],
    /// Static height, m.
    pub height: f64,
    /// Static lateral position, m (zero when planar).
    pub lateral: f64,
}

/// Newton steps that invert x(ξ); the wire is nearly straight, three reach rounding.
const MOST_INVERSIONS: usize = 20;

impl<const DIM: usize> Path<DIM> {
    /// Path over the given wire elements, which must follow each other along the track.
    ///
    /// # Errors
    /// [`CoreError::Input`] when they do not.
    pub fn new<const D: usize>(
        geometry: &Geometry<DIM, D>,
        shape: &Shape<D>,
        wires: &[usize],
    ) -> Result<Self, CoreError> {
        let refuse = |reason: &str| CoreError::Input {
            array: "path",
            reason: reason.into(),
        };
        let mut nodes: Vec<usize> = Vec::with_capacity(wires.len() + 1);
        let mut elements = Vec::with_capacity(wires.len());
        for &w in wires {
            let wire = geometry
                .structure
                .wires
                .get(w)
                .ok_or_else(|| refuse("unknown element"))?;
            if !wire.runs_through() {
                return Err(refuse("the wire is hinged"));
            }
            if nodes.is_empty() {
                nodes.push(wire.nodes[0]);
            } else if nodes.last() != Some(&wire.nodes[0]) {
                return Err(refuse("elements do not follow each other"));
            }
            let coordinates = Geometry::<DIM, D>::coordinates(shape, wire);
            if coordinates[2][0] <= coordinates[0][0] {
                return Err(refuse("the wire runs backwards"));
            }
            nodes.push(wire.nodes[1]);
            elements.push(PathElement {
                rest_length: wire.section.rest_length,
                coordinates,
            });
        }
        if elements.is_empty() {
            return Err(refuse("no elements"));
        }
        Ok(Self { elements, nodes })
    }

    /// First and last coordinate along the track, m.
    #[must_use]
    pub fn range(&self) -> (f64, f64) {
        let last = self.elements.len() - 1;
        (
            self.elements[0].coordinates[0][0],
            self.elements[last].coordinates[2][0],
        )
    }

    /// Place at coordinate `x` along the track; `None` beyond the ends. `near` is the element
    /// where the search starts (contacts move little from step to step).
    #[must_use]
    pub fn locate(&self, x: f64, near: usize) -> Option<Place> {
        let (first, last) = self.range();
        if !(first..=last).contains(&x) {
            return None;
        }
        let mut k = near.min(self.elements.len() - 1);
        while x < self.elements[k].coordinates[0][0] {
            k -= 1;
        }
        while x > self.elements[k].coordinates[2][0] {
            k += 1;
        }
        let e = &self.elements[k];
        let l = e.rest_length;
        let (x0, x1) = (e.coordinates[0][0], e.coordinates[2][0]);
        let mut xi = (x - x0) / (x1 - x0);
        for _ in 0..MOST_INVERSIONS {
            let error = hermite::interpolate(&hermite::shape(xi, l), &e.coordinates)[0] - x;
            let slope = hermite::interpolate(&hermite::shape_slope(xi, l), &e.coordinates)[0] * l;
            xi -= error / slope;
            if error.abs() <= 4.0 * f64::EPSILON * last.abs() {
                break;
            }
        }
        let weights = hermite::shape(xi.clamp(0.0, 1.0), l);
        let r = hermite::interpolate(&weights, &e.coordinates);
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
        w[0] * a[c] + w[1] * a[DIM + c] + w[2] * b[c] + w[3] * b[DIM + c]
    }

    /// Add a force on component `c` at a place.
    pub fn add_force<const D: usize>(
        &self,
        place: &Place,
        force: f64,
        c: usize,
        f: &mut [[f64; D]],
    ) {
        let (a, b) = (self.nodes[place.element], self.nodes[place.element + 1]);
        let w = &place.weights;
        f[a][c] += w[0] * force;
        f[a][DIM + c] += w[1] * force;
        f[b][c] += w[2] * force;
        f[b][DIM + c] += w[3] * force;
    }
}
