//! Residual flexibility R as a difference of Green's functions, between two places on elements,
//! from the responses of a patch around one of them.

use super::patch::{Patch, PatchResponse};
use super::string_beam::{EndMatrix, EndVector, StringBeam};

fn dot(a: &EndVector, b: &EndVector) -> f64 {
    (0..4).map(|k| a[k] * b[k]).sum()
}

/// Shape functions at a place on an element: of the mesh, and exact.
#[derive(Debug, Clone, Copy)]
pub struct ShapeFunctions {
    xi: f64,
    mesh: EndVector,
    exact: EndVector,
}

impl ShapeFunctions {
    /// Evaluates the exact shape functions at ξ, for given ones of the mesh.
    #[must_use]
    pub fn new(beam: &StringBeam, xi: f64, mesh: EndVector) -> Self {
        let exact = beam.shapes(xi);
        Self { xi, mesh, exact }
    }
}

/// Residual flexibility R(x, y) along one element, for a force at a node y.
#[derive(Debug, Clone, Copy, Default)]
pub struct NodeGreenFunction {
    mesh: EndVector,
    exact: EndVector,
}

impl NodeGreenFunction {
    /// Reads R of a node from the responses to the ends of the element: R is symmetric.
    #[must_use]
    pub fn new(patch: &Patch<'_>, responses: &[Option<PatchResponse>; 4], node: usize) -> Self {
        let mut field = Self::default();
        for (k, response) in responses.iter().enumerate() {
            let displacement = response
                .as_ref()
                .map_or([0.0; 2], |r| patch.displacement(r, node));
            [field.mesh[k], field.exact[k]] = displacement;
        }
        field
    }

    /// Adds a multiple of another one on the same element.
    pub fn add(&mut self, factor: f64, other: &Self) {
        for k in 0..4 {
            self.mesh[k] += factor * other.mesh[k];
            self.exact[k] += factor * other.exact[k];
        }
    }

    /// Returns R at a place, m/N.
    #[inline]
    #[must_use]
    pub fn at(&self, shapes: &ShapeFunctions) -> f64 {
        dot(&self.exact, &shapes.exact) - dot(&self.mesh, &shapes.mesh)
    }

    /// Returns the largest absolute value at the ends and in the middle, m/N.
    #[must_use]
    pub fn size(&self, beam: &StringBeam) -> f64 {
        let size_at = |xi: f64| {
            let mesh = crate::element::hermite::shape(xi, beam.length);
            self.at(&ShapeFunctions::new(beam, xi, mesh)).abs()
        };
        [0.0, 0.5, 1.0].map(size_at).into_iter().fold(0.0, f64::max)
    }
}

/// Residual flexibility R(x, y) for x on one element and y on the same or another one.
#[derive(Debug, Clone, Copy, Default)]
pub struct ElementGreenFunction {
    mesh: EndMatrix,
    exact: EndMatrix,
}

impl ElementGreenFunction {
    /// Reads R from the responses to the ends of the element of x; y is on element `wire`.
    #[must_use]
    pub fn new(patch: &Patch<'_>, responses: &[Option<PatchResponse>; 4], wire: usize) -> Self {
        let mut green = Self::default();
        for (k, response) in responses.iter().enumerate() {
            let ends = response.as_ref().map(|r| patch.end_displacements(r, wire));
            [green.mesh[k], green.exact[k]] = ends.unwrap_or_default();
        }
        green
    }

    /// Returns R between places on different elements, m/N.
    #[must_use]
    pub fn at(&self, x: &ShapeFunctions, y: &ShapeFunctions) -> f64 {
        let form = |a: &EndMatrix, x: &EndVector, y: &EndVector| -> f64 {
            (0..4).map(|i| x[i] * dot(&a[i], y)).sum()
        };
        form(&self.exact, &x.exact, &y.exact) - form(&self.mesh, &x.mesh, &y.mesh)
    }

    /// Returns R between two places on the same element, m/N.
    #[must_use]
    pub fn within(&self, beam: &StringBeam, x: &ShapeFunctions, y: &ShapeFunctions) -> f64 {
        self.at(x, y) + beam.clamped_compliance(x.xi, y.xi)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::hermite;
    use crate::statics::Geometry;
    use crate::structure::{Rayleigh, Structure, Wire};

    const LENGTH: f64 = 1.5;
    const TENSION: f64 = 22e3;
    const BENDING: f64 = 195.0;

    /// Returns eleven elements in a row.
    fn row() -> Geometry<2, 4> {
        let section = crate::structure::Section {
            rest_length: LENGTH,
            axial_stiffness: 15e6,
            bending_stiffness: BENDING,
        };
        let wire = |k: usize| Wire {
            nodes: [k, k + 1],
            slope_nodes: [k, k + 1],
            section,
            mass: 1.0,
            turn: 0.0,
            damping: Rayleigh::default(),
            design_tension: TENSION,
        };
        let structure = Structure {
            dim: 2,
            positions: (0..12).map(|k| [LENGTH * f64::from(k), 0.0, 0.0]).collect(),
            slopes: vec![[1.0, 0.0, 0.0]; 12],
            wires: (0..11).map(wire).collect(),
            fixed: vec![(0, 0), (0, 1), (11, 0), (11, 1)],
            ..Structure::default()
        };
        Geometry::new(structure).expect("a valid structure")
    }

    /// Returns Green's function of the whole row between hinged ends, from a series, minus that of
    /// the mesh.
    fn direct(x: f64, y: f64) -> f64 {
        let whole = StringBeam {
            length: 11.0 * LENGTH,
            tension: TENSION,
            bending: BENDING,
        };
        // Clamped and hinged ends agree in the middle up to the ends' own shift, which R does not
        // contain: so take both from hinged ends, w = sin series.
        let l = whole.length;
        let green: f64 = (1..200_000)
            .map(|n| {
                let k = f64::from(n) * std::f64::consts::PI / l;
                2.0 / l * (k * x).sin() * (k * y).sin() / (TENSION * k * k + BENDING * k.powi(4))
            })
            .sum();
        green - mesh(x, y)
    }

    fn mesh(x: f64, y: f64) -> f64 {
        use crate::linalg::dense;
        let beam = StringBeam {
            length: LENGTH,
            tension: TENSION,
            bending: BENDING,
        };
        let (n, element) = (24, beam.cubic());
        let mut k = vec![0.0; n * n];
        for e in 0..11 {
            for (p, row) in element.iter().enumerate() {
                for (q, value) in row.iter().enumerate() {
                    k[(2 * e + p) * n + 2 * e + q] += value;
                }
            }
        }
        for held in [0, 22] {
            k[held * n + held] += 1e12;
        }
        let shares = |x: f64| {
            let e = ((x / LENGTH) as usize).min(10);
            (2 * e, hermite::shape(x / LENGTH - e as f64, LENGTH))
        };
        let mut b = vec![0.0; n];
        let (at, weights) = shares(y);
        (0..4).for_each(|i| b[at + i] = weights[i]);
        assert!(dense::solve_in_place(&mut k, &mut b));
        let (at, weights) = shares(x);
        (0..4).map(|i| weights[i] * b[at + i]).sum()
    }

    #[test]
    fn what_is_missing_is_found_in_a_patch() {
        let geometry = row();
        let network = geometry.wire_network(None);
        let patch = Patch::new(&network, &[5, 6]).expect("a patch");
        let responses = patch.unit_responses_at_ends(5);
        let beam = *network.beam(5);
        let shapes = |xi: f64| ShapeFunctions::new(&beam, xi, hermite::shape(xi, LENGTH));
        let x0 = 5.0 * LENGTH;
        // The series ends at 2e5 terms: 1e-13; heights held four elements away: 5⁻⁸ of R, 2e-12.
        let close = |found: f64, expected: f64| {
            assert!((found - expected).abs() < 2e-11, "{found:e} {expected:e}");
        };
        let same_element = ElementGreenFunction::new(&patch, &responses, 5);
        for (x, y) in [(0.5, 0.5), (0.1, 0.1), (0.2, 0.7), (0.0, 0.4)] {
            let found = same_element.within(&beam, &shapes(x), &shapes(y));
            close(found, direct(x0 + x * LENGTH, x0 + y * LENGTH));
        }
        // Largest in the middle between nodes: the size that the theory predicts.
        let peak = same_element.within(&beam, &shapes(0.5), &shapes(0.5)) * TENSION / LENGTH;
        assert!((0.02..0.05).contains(&peak), "{peak}");
        for ahead in [1, 2] {
            let pair = ElementGreenFunction::new(&patch, &responses, 5 + ahead);
            let at = x0 + (ahead as f64 + 0.4) * LENGTH;
            close(
                pair.at(&shapes(0.3), &shapes(0.4)),
                direct(x0 + 0.3 * LENGTH, at),
            );
        }
        let field = NodeGreenFunction::new(&patch, &responses, 7);
        close(
            field.at(&shapes(0.8)),
            direct(x0 + 0.8 * LENGTH, x0 + 2.0 * LENGTH),
        );
    }
}
