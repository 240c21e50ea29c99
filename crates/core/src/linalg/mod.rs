//! Linear algebra on node blocks, dense matrices, and small vectors: the only folder that depends
//! on how matrices are stored.

pub mod block;
pub mod dense;
pub mod islands;
pub mod lanczos;
pub mod ldl;
pub mod mass;
pub mod small;
mod substitution;
pub mod symmetric;
pub mod wide;

pub use block::Block;
pub use ldl::{BlockLdl, Refactoring};
pub use mass::MassMatrix;
pub use symmetric::{HeldEntry, SymmetricBlocks};
pub use wide::{Kernel, widest};
