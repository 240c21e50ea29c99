//! The Python face of the core: borrow arrays, release the interpreter, call, convert.

mod equilibrium;
mod error;
mod lcp;
mod prepared;
mod published;
mod structure;

use arcless_core::scheme::Scheme;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// Numbers (beta, gamma, alpha_m, alpha_f) of a scheme of the family: `generalised-alpha` with its
/// spectral radius, or `hht` with alpha from 0 to 1/3.
#[pyfunction]
fn scheme(name: &str, parameter: f64) -> PyResult<(f64, f64, f64, f64)> {
    let s = match name {
        "generalised-alpha" => Scheme::generalised_alpha(parameter),
        "hht" => Scheme::hht(parameter),
        other => return Err(PyValueError::new_err(format!("unknown scheme {other}"))),
    };
    Ok((s.beta, s.gamma, s.alpha_m, s.alpha_f))
}

/// Native part of `arcless`; private, use the package's Python interface.
#[pymodule]
fn _core(m: &Bound<'_, PyModule>) -> PyResult<()> {
    m.add("__version__", env!("CARGO_PKG_VERSION"))?;
    m.add("NativeError", m.py().get_type::<error::NativeError>())?;
    m.add_function(wrap_pyfunction!(scheme, m)?)?;
    m.add_class::<equilibrium::Equilibrium>()?;
    m.add_class::<prepared::Prepared>()?;
    m.add_function(wrap_pyfunction!(lcp::solve_lcp, m)?)?;
    m.add_class::<published::PublishedStep>()?;
    m.add_function(wrap_pyfunction!(published::friction, m)?)?;
    Ok(())
}
