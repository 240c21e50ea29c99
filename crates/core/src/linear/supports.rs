//! Springs to ground and steady arms of the linearised line.
//!
//! A spring acts on its node with F = F₀ − k u − c u̇ along its component. A steady arm, a bar from
//! its node to a point of the ground, has the tension
//!
//!   T = T₀ − k n·u      linearised, n from the node to the ground
//!   T = k (ℓ − ℓ₀)      with updated kinematics, ℓ from node to ground as it is
//!
//! k contains the residual flexibility R of the wire: the mesh yields by F/k, the real wire by F/kₐ
//! of the spring alone, so that it moves by the share k/kₐ of the node.

use crate::statics::assembly::{Geometry, Shape};
use crate::structure::{Spring, Strut};

/// Spring and damper between a node and the ground.
#[derive(Debug, Clone, Copy)]
pub struct LinearSpring {
    /// Node.
    pub node: usize,
    /// Component of its position.
    pub component: usize,
    /// Stiffness k, N/m.
    pub stiffness: f64,
    /// Damping c, N·s/m.
    pub viscosity: f64,
    /// Force F₀ on the node at equilibrium, N.
    pub rest_force: f64,
    /// Motion of the real wire over that of the node, k/kₐ.
    pub real_share: f64,
}

/// Steady arm between a node and a point of the ground.
#[derive(Debug, Clone, Copy)]
pub struct LinearStrut<const DIM: usize> {
    /// Node.
    pub node: usize,
    /// Its position at equilibrium, m.
    pub position: [f64; DIM],
    /// Point of the ground, m.
    pub anchor: [f64; DIM],
    /// Unit vector n from the node to the ground, at equilibrium.
    pub direction: [f64; DIM],
    /// Stiffness k, N/m.
    pub stiffness: f64,
    /// Unstretched length ℓ₀, m.
    pub rest_length: f64,
    /// Tension T₀ at equilibrium, N.
    pub rest_tension: f64,
}

impl LinearSpring {
    /// Linearises a spring; `alone` is its stiffness without the residual flexibility, N/m.
    pub(super) fn new<const D: usize>(spring: &Spring, alone: f64, shape: &Shape<D>) -> Self {
        let Spring {
            node,
            component,
            stiffness,
            viscosity,
            rest,
            ..
        } = *spring;
        Self {
            node,
            component,
            stiffness,
            viscosity,
            rest_force: -stiffness * (shape[node][component] - rest),
            // A pure damper moves as its node does.
            real_share: if alone > 0.0 { stiffness / alone } else { 1.0 },
        }
    }
}

impl<const DIM: usize> LinearStrut<DIM> {
    pub(super) fn new<const D: usize>(strut: &Strut, shape: &Shape<D>) -> Self {
        let state = Geometry::<DIM, D>::strut_state(shape, strut);
        let mut anchor = [0.0; DIM];
        anchor.copy_from_slice(&strut.anchor[..DIM]);
        Self {
            node: strut.node,
            position: Geometry::<DIM, D>::position(shape, strut.node),
            anchor,
            direction: state.direction,
            stiffness: strut.stiffness,
            rest_length: strut.rest_length,
            rest_tension: state.linear_tension,
        }
    }

    /// Returns the tension of the linearised arm with its node displaced by u, N.
    #[must_use]
    pub fn linear_tension(&self, u: &[f64; DIM]) -> f64 {
        let towards: f64 = self.direction.iter().zip(u).map(|(n, u)| n * u).sum();
        self.rest_tension - self.stiffness * towards
    }

    /// Returns the tension by the distance between node and ground, N.
    #[must_use]
    pub fn tension(&self, u: &[f64; DIM]) -> f64 {
        self.stiffness * (self.span(u).1 - self.rest_length)
    }

    /// Returns the angle of the arm to the horizontal plane, rad: positive where the ground point
    /// is the higher end.
    #[must_use]
    pub fn angle(&self, u: &[f64; DIM]) -> f64 {
        let (rise, length) = self.span(u);
        (rise / length).asin()
    }

    /// Returns the rise from the node to the ground point, and their distance, m.
    fn span(&self, u: &[f64; DIM]) -> (f64, f64) {
        let between: [f64; DIM] = std::array::from_fn(|c| self.anchor[c] - self.position[c] - u[c]);
        let squares: f64 = between.iter().map(|d| d * d).sum();
        (between[DIM - 1], squares.sqrt())
    }
}
