//! Merges the statistics of the parts of a sweep. The command `sweep` writes and checks the parts.

use crate::boundary::{Failure, answer};
use crate::json::to_python;
use longdrive::parts::{Manifest, merge};
use pyo3::prelude::*;

/// Merges the statistics of the parts of a sweep. `manifests` is a JSON array with the manifest of
/// each part.
#[pyfunction]
pub fn merge_parts<'py>(py: Python<'py>, manifests: &str) -> PyResult<Bound<'py, PyAny>> {
    answer(|| {
        let manifests: Vec<Manifest> = serde_json::from_str(manifests).map_err(|error| {
            Failure::Input(format!(
                "manifests: {error}; give the rows of a manifest, as a sweep in parts returns them"
            ))
        })?;
        to_python(py, &merge(&manifests)?)
    })
}
