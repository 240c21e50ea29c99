//! Kernels compiled for the widest SIMD instructions of the processor, chosen at run time.
//!
//! Wider instructions do the same operations in the same order, several at a time, and nothing
//! fuses a multiplication with an addition: the bits are the same on every machine.

use std::sync::OnceLock;

/// Kernel to compile for wide SIMD instructions. `run`, and whatever it calls, must be
/// `inline(always)`, or it is compiled for the lowest common processor after all.
pub trait Kernel {
    /// Runs the kernel.
    fn run(self);
}

/// Runs a kernel with the best instructions this processor has.
#[inline(always)]
pub fn widest(kernel: impl Kernel) {
    static ARCH: OnceLock<pulp::Arch> = OnceLock::new();
    ARCH.get_or_init(pulp::Arch::new).dispatch(Wrapped(kernel));
}

struct Wrapped<K>(K);

impl<K: Kernel> pulp::NullaryFnOnce for Wrapped<K> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        self.0.run();
    }
}
