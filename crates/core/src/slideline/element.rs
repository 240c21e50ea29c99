//! Element of a slideline: its range along the track, and its shape functions.

use crate::element::hermite;
use crate::error::CoreError;
use crate::slideline::point::slots;
use crate::slideline::smoothed_segment::SmoothedSegment;
use crate::statics::assembly::{Geometry, Shape};
use std::sync::Arc;

/// Element in its static shape, or at its present position.
#[derive(Debug, Clone)]
pub(crate) enum SlidelineElement<const DIM: usize> {
    /// Hermite element.
    Curve {
        rest_length: f64,
        coordinates: hermite::Coordinates<DIM>,
    },
    /// Segment of a chain, a chord between its two ends.
    Chord([[f64; DIM]; 2]),
    /// Segment of a chain, as a curve: with explicit steps.
    Smoothed(Arc<SmoothedSegment<DIM>>),
}

/// Bound on the Newton steps that invert x(ξ); the wire is nearly straight, three reach rounding.
const MOST_INVERSIONS: usize = 20;

impl<const DIM: usize> SlidelineElement<DIM> {
    /// Coordinates of both ends along the track, m.
    pub(crate) fn range(&self) -> (f64, f64) {
        match self {
            Self::Curve { coordinates: e, .. } => (e[0][0], e[2][0]),
            Self::Chord(ends) => (ends[0][0], ends[1][0]),
            Self::Smoothed(segment) => segment.range(),
        }
    }

    /// Shape functions at coordinate `x` along the track, to the given accuracy in m.
    pub(crate) fn weights(&self, x: f64, accuracy: f64) -> [f64; 4] {
        let xi = self.natural_coordinate(x, accuracy);
        match self {
            Self::Curve { rest_length: l, .. } => hermite::shape(xi, *l),
            Self::Chord(_) => [1.0 - xi, xi, 0.0, 0.0],
            Self::Smoothed(segment) => segment.shape(xi),
        }
    }

    /// Derivatives of the shape functions along the track, dS/dx = S′ / x′, 1/m.
    pub(crate) fn weight_slopes(&self, x: f64, accuracy: f64) -> [f64; 4] {
        let xi = self.natural_coordinate(x, accuracy);
        match self {
            Self::Curve {
                rest_length: l,
                coordinates: e,
            } => {
                let slopes = hermite::shape_slope(xi, *l);
                let along = hermite::interpolate(&slopes, e)[0];
                slopes.map(|slope| slope / along)
            }
            Self::Chord([a, b]) => {
                let per_length = 1.0 / (b[0] - a[0]);
                [-per_length, per_length, 0.0, 0.0]
            }
            Self::Smoothed(segment) => segment.shape_slope(xi),
        }
    }

    /// Natural coordinate ξ from 0 to 1 at coordinate `x` along the track, m.
    fn natural_coordinate(&self, x: f64, accuracy: f64) -> f64 {
        let (x0, x1) = self.range();
        let mut xi = (x - x0) / (x1 - x0);
        let Self::Curve {
            rest_length: l,
            coordinates: e,
        } = self
        else {
            return xi;
        };
        for _ in 0..MOST_INVERSIONS {
            let error = hermite::interpolate(&hermite::shape(xi, *l), e)[0] - x;
            let slope = hermite::interpolate(&hermite::shape_slope(xi, *l), e)[0] * l;
            xi -= error / slope;
            if error.abs() <= accuracy {
                break;
            }
        }
        xi.clamp(0.0, 1.0)
    }

    /// Moves both ends (position, and slope where there is one) by the displacements of their
    /// nodes.
    pub(crate) fn displace<const D: usize>(&mut self, ends: [&[f64; D]; 2]) {
        for (side, end) in ends.into_iter().enumerate() {
            for c in 0..DIM {
                match self {
                    Self::Curve { coordinates: e, .. } => {
                        e[2 * side][c] += end[c];
                        e[2 * side + 1][c] += end[DIM + c];
                    }
                    Self::Chord(points) => points[side][c] += end[c],
                    // Explicit steps keep the kinematics of the position at rest.
                    Self::Smoothed(_) => (),
                }
            }
        }
    }

    /// Static position for given shape functions.
    pub(crate) fn point(&self, weights: &[f64; 4]) -> [f64; DIM] {
        match self {
            Self::Curve { coordinates, .. } => hermite::interpolate(weights, coordinates),
            Self::Chord([a, b]) => std::array::from_fn(|c| weights[0] * a[c] + weights[1] * b[c]),
            Self::Smoothed(segment) => segment.point(weights),
        }
    }

    /// Number of nodes with shape functions before the first end, and in all.
    pub(crate) fn node_window(&self) -> (usize, usize) {
        match self {
            Self::Curve { .. } | Self::Chord(_) => (0, 2),
            Self::Smoothed(segment) => segment.point_window(),
        }
    }

    /// Shape functions at the first or second end (`side` 0, 1).
    pub(crate) fn end_weights(&self, side: usize) -> [f64; 4] {
        let mut weights = [0.0; 4];
        match self {
            Self::Curve { .. } => weights[2 * side] = 1.0,
            Self::Chord(_) => weights[side] = 1.0,
            Self::Smoothed(segment) => weights = segment.shape(side as f64),
        }
        weights
    }

    /// Residual flexibility R(x, x) of a chain, m/N.
    pub(crate) fn residual_flexibility(&self, weights: &[f64; 4]) -> f64 {
        match self {
            Self::Smoothed(segment) => segment.residual_flexibility(weights),
            _ => 0.0,
        }
    }

    /// Residual flexibility R(x, y) of a chain between a point of this element and one of `other`,
    /// m/N.
    pub(crate) fn residual_flexibility_between(
        &self,
        weights: &[f64; 4],
        other: &Self,
        other_weights: &[f64; 4],
    ) -> f64 {
        match (self, other) {
            (Self::Smoothed(segment), Self::Smoothed(other)) => {
                segment.residual_flexibility_between(weights, other, other_weights)
            }
            _ => 0.0,
        }
    }

    /// Positions of both ends of a segment of a chain, m.
    pub(crate) fn chord(&self) -> Option<[[f64; DIM]; 2]> {
        match self {
            Self::Chord(ends) => Some(*ends),
            _ => None,
        }
    }
}

/// Element `number` of the wires, in the model that `D` means, and its nodes.
pub(crate) fn element<const DIM: usize, const D: usize>(
    geometry: &Geometry<DIM, D>,
    shape: &Shape<D>,
    number: usize,
) -> Result<(SlidelineElement<DIM>, [usize; 2]), CoreError> {
    let s = &geometry.structure;
    if slots::<DIM, D>() == 1 {
        let segment = s.segments.get(number);
        let nodes = segment
            .ok_or_else(|| CoreError::invalid("lanes", "unknown element"))?
            .nodes;
        let ends = nodes.map(|n| Geometry::<DIM, D>::position(shape, n));
        return Ok((SlidelineElement::Chord(ends), nodes));
    }
    let wire = s.wires.get(number);
    let wire = wire.ok_or_else(|| CoreError::invalid("lanes", "unknown element"))?;
    if !wire.runs_through() {
        return Err(CoreError::invalid("lanes", "the wire is hinged"));
    }
    let curve = SlidelineElement::Curve {
        rest_length: wire.section.rest_length,
        coordinates: Geometry::<DIM, D>::coordinates(shape, wire),
    };
    Ok((curve, wire.nodes))
}
