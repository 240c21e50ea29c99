//! Residual flexibility: compliance that a mesh lacks where a point force bends a wire under
//! tension.
//!
//! The shape of such a wire has a corner there, rounded over √(EI/T). No cubic element that is
//! longer than that can represent it. The missing displacement at x under a unit force at y is
//!
//!   R(x, y) = G(x, y) − N(x)ᵀ K⁻¹ N(y)
//!
//! with G Green's function of EI w⁗ − T w″ = δ, N the cubic shape functions and K the stiffness of
//! the mesh: the residual flexibility of MacNeal (Comput. Struct. 1 (1971) 581). It is symmetric
//! and positive (the mesh is a Ritz approximation), of the size of 0.03 ℓ/T, and local: a fifth of
//! it is left one element away, 4 % two away. So it is added where forces meet the wire, and needs
//! no unknown.
//!
//! With the stiffnesses of a wire divided at its nodes, K̂ exact and K of cubic elements, and φ, N
//! the shape functions of both,
//!
//!   G(x, y) = φ(x)ᵀ K̂⁻¹ φ(y) + G₀(x, y)
//!
//! where G₀, for two places on one element, is that of the element between clamped ends. Distant
//! supports of the wire have no part in R, so both stiffnesses are those of a patch of some
//! elements.

pub mod green_function;
pub mod patch;
pub mod string_beam;
