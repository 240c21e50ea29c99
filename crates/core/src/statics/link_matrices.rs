//! Tangent stiffness and damping of a link (dropper, steady arm) between its two nodes.
//!
//!   K = k n nᵀ + (T/ℓ)(1 − n nᵀ),   C = β K + c n nᵀ
//!
//! with n from the first to the second node and T its tension by its own law. The matrices couple
//! the displacements of the nodes as [1 −1; −1 1].

use super::assembly::{Geometry, LinkLaw, Shape, link_tension};
use crate::structure::Link;

impl<const DIM: usize, const D: usize> Geometry<DIM, D> {
    /// K of a link, N/m, times `factor`; a link that is slack by `law` keeps T/ℓ alone.
    #[must_use]
    pub fn link_tangent(
        shape: &Shape<D>,
        link: &Link,
        law: LinkLaw,
        factor: f64,
    ) -> [[f64; DIM]; DIM] {
        let state = Self::link_state(shape, link);
        let slack = link.unilateral && state.linear_tension < 0.0;
        let stiffness = if slack && law == LinkLaw::Unilateral {
            0.0
        } else {
            link.stiffness
        };
        state.tangent(factor * stiffness, factor * link_tension(link, &state))
    }

    /// C of a link with stiffness-proportional damping `beta` (s), N·s/m.
    #[must_use]
    pub fn link_damping(shape: &Shape<D>, link: &Link, beta: f64) -> [[f64; DIM]; DIM] {
        let n = Self::link_state(shape, link).direction;
        let mut c = Self::link_tangent(shape, link, LinkLaw::Linear, 1.0);
        for p in 0..DIM {
            for q in 0..DIM {
                c[p][q] = beta * c[p][q] + link.viscosity * (n[p] * n[q]);
            }
        }
        c
    }
}
