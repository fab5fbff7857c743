//! The compiled module of the Python package `longdrive`. `python/longdrive` imports and types its
//! public items.

mod arrays;
mod arrow;
mod batch;
mod boundary;
mod command;
mod degrees;
mod derivatives;
mod drive;
mod given;
mod hessians;
mod json;
mod names;
mod objective;
mod parts;
mod plan;
mod pool;
mod request;
mod results;
mod setup;
mod step;
mod wording;

use pyo3::prelude::*;

/// The compiled module of longdrive.
#[pymodule]
mod _longdrive {
    #[pymodule_export]
    use crate::arrow::arrow_stream;
    #[pymodule_export]
    use crate::batch::{BatchResult, batch};
    #[pymodule_export]
    use crate::boundary::panic_for_a_test;
    #[pymodule_export]
    use crate::command::{command, described, main};
    #[pymodule_export]
    use crate::derivatives::{gradient, hessian, jacobian};
    #[pymodule_export]
    use crate::drive::{PySimulated, simulate};
    #[pymodule_export]
    use crate::names::{
        is_out_of_range, outcomes, parameter_names_in, parameters, presets, requested_names,
        unit_of, unit_of_goal, unknown_key,
    };
    #[pymodule_export]
    use crate::objective::PyObjective;
    #[pymodule_export]
    use crate::parts::merge_parts;
    #[pymodule_export]
    use crate::plan::plan;
    #[pymodule_export]
    use crate::request::{word_of, words_of};
    #[pymodule_export]
    use crate::setup::PySetup;
    #[pymodule_export]
    use crate::step::PyIntegration;
    #[pymodule_export]
    use crate::wording::in_python;

    use super::*;

    /// Adds the version, which equals the version of the program. Imports NumPy, and registers
    /// `Setup` as a mapping.
    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        let py = module.py();
        arrays::prepared(py);
        let mapping = py.import("collections.abc")?.getattr("Mapping")?;
        mapping.call_method1("register", (py.get_type::<PySetup>(),))?;
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
