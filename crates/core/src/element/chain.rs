//! Wire as a chain of point masses: segments that stretch, and bends between them.
//!
//! Segment between two nodes at distance ℓ, unstretched length L:
//!
//!   U = ½ (EA/L) (ℓ − L)²
//!
//! Where the track turns by τ to the left along it, ℓ is the length of d = A_b r_b − A_a r_a, see
//! [`frame`](super::frame): (x_b − x_a − ½ τ (y_a + y_b), y_b − y_a, z_b − z_a) up to squares of
//! τ.
//!
//! Bend at the node b that two consecutive segments a–b (length L_p) and b–c (length L_q) share.
//! The rotations of the nodes are eliminated: the second derivative along the wire is a difference,
//!
//!   r″ = ((r_c − r_b)/L_q − (r_b − r_a)/L_p) / ℓ̄,   ℓ̄ = (L_p + L_q)/2,   U = ½ EI |r″|² ℓ̄
//!
//! U is quadratic in the positions and does not change under rigid motion. The part of r″ along the
//! wire is a gradient of strain: EI/(EA ℓ²) of the axial energy of neighbours that stretch
//! differently.
//!
//! Source: Kolesnikov & Kuvshinov (about 2009), point masses joined by elements that carry
//! longitudinal deformation and bending, rotational degrees of freedom eliminated; the sum over
//! bends is the discrete elastica.

use super::bar::BarState;
use super::frame::{self, Frame};
use crate::structure::Segment;

impl Segment {
    /// Stiffness EA/L, N/m.
    #[must_use]
    pub fn stiffness(&self) -> f64 {
        self.axial_stiffness / self.rest_length
    }

    /// State for given positions of its nodes.
    #[must_use]
    pub fn state<const DIM: usize>(&self, ends: [&[f64; DIM]; 2]) -> BarState<DIM> {
        let [a, b] = match Frame::new::<DIM>(self.turn) {
            None => ends.map(|r| *r),
            Some(frame) => [0, 1].map(|end| frame::to_frame(&frame.matrix(end, false), ends[end])),
        };
        BarState::new(&a, &b, self.rest_length, self.stiffness())
    }
}

/// Bend between two segments of given unstretched lengths.
#[derive(Debug, Clone, Copy)]
pub struct BendElement {
    /// Weights wᵢ of r″ = Σ wᵢ rᵢ over the nodes a, b, c, 1/m².
    weights: [f64; 3],
    /// Rigidity EI ℓ̄, N·m³.
    rigidity: f64,
}

impl BendElement {
    /// Bend with the bending stiffness EI, N·m², and the lengths before and behind the node, m.
    #[must_use]
    pub fn new(bending_stiffness: f64, [before, behind]: [f64; 2]) -> Self {
        let mean = 0.5 * (before + behind);
        let (first, last) = (1.0 / (before * mean), 1.0 / (behind * mean));
        Self {
            weights: [first, -first - last, last],
            rigidity: bending_stiffness * mean,
        }
    }

    /// Second derivative r″ at the middle node, 1/m.
    fn second_derivative<const DIM: usize>(&self, nodes: [&[f64; DIM]; 3]) -> [f64; DIM] {
        let [a, b, c] = nodes;
        let [first, _, last] = self.weights;
        // By differences: coordinates are large, their differences small.
        std::array::from_fn(|k| last * (c[k] - b[k]) - first * (b[k] - a[k]))
    }

    /// Energy, J.
    #[must_use]
    pub fn energy<const DIM: usize>(&self, nodes: [&[f64; DIM]; 3]) -> f64 {
        let r = self.second_derivative(nodes);
        0.5 * self.rigidity * r.iter().map(|c| c * c).sum::<f64>()
    }

    /// Gradient of the energy, EI ℓ̄ wᵢ r″, N.
    #[must_use]
    pub fn force<const DIM: usize>(&self, nodes: [&[f64; DIM]; 3]) -> [[f64; DIM]; 3] {
        let r = self.second_derivative(nodes);
        self.weights.map(|w| r.map(|c| self.rigidity * w * c))
    }

    /// Factor of the unit matrix in ∂²U/∂rᵢ∂rⱼ = EI ℓ̄ wᵢ wⱼ 1, N/m.
    #[must_use]
    pub fn stiffness(&self, i: usize, j: usize) -> f64 {
        self.rigidity * self.weights[i] * self.weights[j]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::Rayleigh;

    const SEGMENT: Segment = Segment {
        nodes: [0, 1],
        rest_length: 0.25,
        axial_stiffness: 15e6,
        turn: 0.0,
        mass: 1.35,
        damping: Rayleigh {
            alpha: 0.0,
            beta: 0.0,
        },
        design_tension: 22e3,
    };
    const NODES: [[f64; 3]; 3] = [[0.1, 0.0, 5.0], [0.35, 0.02, 5.03], [0.75, 0.0, 5.01]];

    fn bend() -> BendElement {
        BendElement::new(195.0, [0.25, 0.4])
    }

    /// Central difference of a smooth function: for the quadratic energy of a bend only rounding,
    /// ε U / h = 1e-9 N, remains; for the segment h² EA/L³ = 1e-3 N of 1e6 N.
    const DIFFERENCE: f64 = 1e-6;

    fn moved<const N: usize>(r: [[f64; 3]; N], i: usize, c: usize, by: f64) -> [[f64; 3]; N] {
        let mut moved = r;
        moved[i][c] += by;
        moved
    }

    #[test]
    fn force_of_a_segment_is_the_gradient_of_its_energy() {
        let ends = [NODES[0], NODES[1]];
        let energy = |r: [[f64; 3]; 2]| {
            let state = SEGMENT.state([&r[0], &r[1]]);
            0.5 * SEGMENT.stiffness() * (state.length - SEGMENT.rest_length).powi(2)
        };
        let state = SEGMENT.state([&ends[0], &ends[1]]);
        for c in 0..3 {
            let up = energy(moved(ends, 1, c, DIFFERENCE));
            let down = energy(moved(ends, 1, c, -DIFFERENCE));
            let slope = (up - down) / (2.0 * DIFFERENCE);
            assert!((slope - state.linear_tension * state.direction[c]).abs() < 0.1);
        }
    }

    #[test]
    fn force_of_a_bend_is_the_gradient_of_its_energy() {
        let b = bend();
        let force = b.force(NODES.each_ref());
        for i in 0..3 {
            for c in 0..3 {
                // Central differences: error DIFFERENCE² of forces of order 1, and rounding over
                // DIFFERENCE.
                let up = b.energy(moved(NODES, i, c, DIFFERENCE).each_ref());
                let down = b.energy(moved(NODES, i, c, -DIFFERENCE).each_ref());
                let slope = (up - down) / (2.0 * DIFFERENCE);
                assert!((slope - force[i][c]).abs() < 1e-7, "{slope} {force:?}");
            }
        }
        assert!(force[1][2] > 10.0, "the partner: there is a force");
    }

    #[test]
    fn stiffness_of_a_bend_is_the_gradient_of_its_force() {
        let b = bend();
        for j in 0..3 {
            for c in 0..3 {
                let up = b.force(moved(NODES, j, c, DIFFERENCE).each_ref());
                let down = b.force(moved(NODES, j, c, -DIFFERENCE).each_ref());
                for i in 0..3 {
                    for k in 0..3 {
                        let slope = (up[i][k] - down[i][k]) / (2.0 * DIFFERENCE);
                        let expected = if k == c { b.stiffness(i, j) } else { 0.0 };
                        // Linear in the positions: rounding of 1e-15 relative over h.
                        assert!((slope - expected).abs() < 1e-8 * b.stiffness(1, 1));
                    }
                }
            }
        }
    }

    /// Turned about the y axis and carried away.
    fn carried(r: [f64; 3]) -> [f64; 3] {
        let (sin, cos) = 0.7_f64.sin_cos();
        [
            3.0 + cos * r[0] - sin * r[2],
            r[1] - 2.0,
            1.0 + sin * r[0] + cos * r[2],
        ]
    }

    #[test]
    fn rigid_motion_needs_no_force() {
        let straight = [[0.0; 3], [0.25, 0.0, 0.0], [0.65, 0.0, 0.0]].map(carried);
        let [a, b, _] = &straight;
        // EA times the rounding of the strain, coordinates of 3 m over 0.25 m; for the bend EI ℓ⁻².
        assert!(SEGMENT.state([a, b]).linear_tension.abs() < 15e6 * 1e-14);
        let force = bend().force(straight.each_ref());
        assert!(force.iter().flatten().all(|f| f.abs() < 1e-10));
    }

    #[test]
    fn energy_of_a_bend_does_not_change_under_rigid_motion() {
        let (b, turned) = (bend(), NODES.map(carried));
        let (here, there) = (b.energy(NODES.each_ref()), b.energy(turned.each_ref()));
        assert!((there / here - 1.0).abs() < 1e-13, "rounding");
        assert!(here > 1.0, "the partner: it is bent");
    }

    /// On a circle of radius R the second difference is 1/R up to O(ℓ²).
    #[test]
    fn curvature_of_a_circle() {
        let radius = 10.0;
        let error = |step: f64| {
            let at = |k: f64| {
                let (sin, cos) = (k * step / radius).sin_cos();
                [radius * sin, 0.0, radius * cos]
            };
            let nodes = [at(-1.0), at(0.0), at(1.0)];
            let energy = BendElement::new(2.0, [step; 2]).energy(nodes.each_ref());
            1.0 - energy * radius * radius / step
        };
        let order = (error(0.2) / error(0.1)).log2();
        assert!((order - 2.0).abs() < 0.01, "{order}");
    }
}
