//! The compiled half of the Python package `longdrive`: setups, one drive, its derivatives, very
//! many drives. What a user sees of it is imported and typed in `python/longdrive`.

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
mod setup;
mod step;
mod wording;

use pyo3::prelude::*;

/// The compiled half of longdrive.
#[pymodule]
mod _longdrive {
    #[pymodule_export]
    use crate::arrow::arrow_stream;
    #[pymodule_export]
    use crate::batch::batch;
    #[pymodule_export]
    use crate::boundary::panic_for_a_test;
    #[pymodule_export]
    use crate::command::{command, described, main};
    #[pymodule_export]
    use crate::derivatives::{gradient, hessian, jacobian};
    #[pymodule_export]
    use crate::drive::simulate;
    #[pymodule_export]
    use crate::names::{asked, outcomes, parameters, presets, unknown_key};
    #[pymodule_export]
    use crate::objective::PyObjective;
    #[pymodule_export]
    use crate::parts::merge_parts;
    #[pymodule_export]
    use crate::plan::plan;
    #[pymodule_export]
    use crate::setup::PySetup;
    #[pymodule_export]
    use crate::wording::in_python;

    use super::*;

    /// The version of longdrive, that of the program.
    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        arrays::prepared(module.py());
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
