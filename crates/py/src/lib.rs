//! The Python face of the core: borrow arrays, release the interpreter, call, convert.

mod equilibrium;
mod error;
mod filter;
mod lcp;
mod live;
mod prepared;
mod records;
mod riders;
mod structure;

use pyo3::prelude::*;

/// Native part of `arcless`; private, use the package's Python interface.
#[pymodule]
fn _core(m: &Bound<'_, PyModule>) -> PyResult<()> {
    m.add("__version__", env!("CARGO_PKG_VERSION"))?;
    m.add("NativeError", m.py().get_type::<error::NativeError>())?;
    m.add_class::<equilibrium::Equilibrium>()?;
    m.add_class::<prepared::Prepared>()?;
    m.add_class::<live::Live>()?;
    m.add_function(wrap_pyfunction!(lcp::solve_lcp, m)?)?;
    m.add_function(wrap_pyfunction!(filter::filtered, m)?)?;
    Ok(())
}
