//! What merges of the parts of a sweep. The parts themselves are written and checked by the command
//! `sweep`.

use crate::boundary::{Failure, answer};
use crate::json::to_python;
use longdrive::parts::{Manifest, merge};
use pyo3::prelude::*;

/// The statistics of several parts together, from their manifest rows as the text of a JSON array.
#[pyfunction]
pub fn merge_parts<'py>(py: Python<'py>, manifests: &str) -> PyResult<Bound<'py, PyAny>> {
    answer(|| {
        let manifests: Vec<Manifest> = serde_json::from_str(manifests).map_err(|error| {
            Failure::Input(format!(
                "manifests: {error}; give what a sweep in parts has answered"
            ))
        })?;
        to_python(py, &merge(&manifests)?)
    })
}
