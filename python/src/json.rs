//! JSON as objects of Python.

use crate::boundary::Answer;
use pyo3::IntoPyObjectExt;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use serde::Serialize;
use serde_json::Value;

/// Answers of `--json` as dicts, lists, numbers and texts. JSON has no infinity: the texts `"inf"`
/// and `"-inf"` become infinite numbers.
pub fn to_python<'py>(py: Python<'py>, answer: &impl Serialize) -> Answer<Bound<'py, PyAny>> {
    let value =
        serde_json::to_value(answer).map_err(|error| PyValueError::new_err(error.to_string()))?;
    Ok(object(py, &value)?)
}

fn object<'py>(py: Python<'py>, value: &Value) -> PyResult<Bound<'py, PyAny>> {
    match value {
        Value::Null => Ok(py.None().into_bound(py)),
        Value::Bool(truth) => truth.into_bound_py_any(py),
        Value::Number(number) => match number.as_i64() {
            Some(whole) => whole.into_bound_py_any(py),
            None => number.as_f64().into_bound_py_any(py),
        },
        Value::String(text) => match text.as_str() {
            "inf" => f64::INFINITY.into_bound_py_any(py),
            "-inf" => f64::NEG_INFINITY.into_bound_py_any(py),
            text => text.into_bound_py_any(py),
        },
        Value::Array(values) => {
            let objects = values
                .iter()
                .map(|value| object(py, value))
                .collect::<PyResult<Vec<_>>>()?;
            Ok(PyList::new(py, objects)?.into_any())
        }
        Value::Object(map) => {
            let dict = PyDict::new(py);
            for (key, value) in map {
                dict.set_item(key, object(py, value)?)?;
            }
            Ok(dict.into_any())
        }
    }
}
