//! The Python face of the core: borrow arrays, release the interpreter, call, convert.

mod equilibrium;
mod error;
mod export;
mod filter;
mod lcp;
mod model;
mod outside;
mod pantographs;
mod records;
mod session;
mod structure;
mod together;

use arcless_core::simulation::recording::record::Record;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

/// Native part of `arcless`; private, use the package's Python interface.
#[pymodule]
fn _core(m: &Bound<'_, PyModule>) -> PyResult<()> {
    m.add("__version__", env!("CARGO_PKG_VERSION"))?;
    m.add("SERIES", PyTuple::new(m.py(), Record::SERIES)?)?;
    m.add("NativeError", m.py().get_type::<error::NativeError>())?;
    m.add_class::<equilibrium::Equilibrium>()?;
    m.add_class::<model::WireModel>()?;
    m.add_class::<session::Session>()?;
    m.add_function(wrap_pyfunction!(lcp::solve_lcp, m)?)?;
    m.add_function(wrap_pyfunction!(filter::filtered, m)?)?;
    m.add_function(wrap_pyfunction!(filter::filter_on, m)?)?;
    m.add_function(wrap_pyfunction!(together::advance, m)?)?;
    m.add_function(wrap_pyfunction!(export::exported_line, m)?)?;
    m.add_function(wrap_pyfunction!(export::exported_pantograph, m)?)?;
    m.add_function(wrap_pyfunction!(export::described, m)?)?;
    Ok(())
}
