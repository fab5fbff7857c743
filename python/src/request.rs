//! Requests from Python: the typed values of `longdrive.conversion`.

use crate::boundary::{Answer, Failure, answer, kind_of};
use longdrive::command::{ArgumentValue, Call};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyList, PyString};
use std::ffi::OsString;

/// The value of an argument.
pub fn value_of(given: &Bound<'_, PyAny>) -> Answer<ArgumentValue> {
    if given.is_instance_of::<PyBool>() {
        return Ok(ArgumentValue::Switch(given.extract()?));
    }
    if given.is_instance_of::<PyString>() {
        return Ok(ArgumentValue::Text(given.extract::<OsString>()?));
    }
    if given.is_instance_of::<PyFloat>() {
        return Ok(ArgumentValue::Number(given.extract()?));
    }
    if given.is_instance_of::<PyInt>() {
        // a whole number beyond 64 bits stays a text, which the command refuses
        return Ok(match given.extract() {
            Ok(number) => ArgumentValue::Whole(number),
            Err(_) => ArgumentValue::Text(given.str()?.extract()?),
        });
    }
    if let Ok(list) = given.cast::<PyList>() {
        return Ok(ArgumentValue::Several(values_of(list)?));
    }
    let attribute = |name: &str| given.getattr(name);
    match given.get_type().name()?.to_str()? {
        "Range" => Ok(ArgumentValue::Range {
            low: Box::new(value_of(&attribute("low")?)?),
            high: Box::new(value_of(&attribute("high")?)?),
            count: attribute("count")?.extract()?,
        }),
        "Distribution" => Ok(ArgumentValue::Distribution(
            attribute("kind")?.extract()?,
            values_of(
                attribute("numbers")?
                    .cast::<PyList>()
                    .map_err(PyErr::from)?,
            )?,
        )),
        "Named" => Ok(ArgumentValue::Named(
            attribute("name")?.extract()?,
            Box::new(value_of(&attribute("value")?)?),
        )),
        "Joined" => Ok(ArgumentValue::Joined(values_of(
            attribute("parts")?.cast::<PyList>().map_err(PyErr::from)?,
        )?)),
        _ => Err(Failure::Internal(format!(
            "{} is no value of an argument",
            kind_of(given)
        ))),
    }
}

fn values_of(given: &Bound<'_, PyList>) -> Answer<Vec<ArgumentValue>> {
    given.iter().map(|value| value_of(&value)).collect()
}

/// Arguments by the names of their options.
pub fn arguments_of(given: &Bound<'_, PyDict>) -> Answer<Vec<(String, ArgumentValue)>> {
    given
        .iter()
        .map(|(name, value)| Ok((name.extract()?, value_of(&value)?)))
        .collect()
}

/// The text of a value on the command line.
#[pyfunction]
pub fn word_of(value: &Bound<'_, PyAny>) -> PyResult<OsString> {
    answer(|| Ok(value_of(value)?.text()))
}

/// The command line of a request, the name of the program first.
#[pyfunction]
pub fn words_of(command: String, arguments: &Bound<'_, PyDict>) -> PyResult<Vec<OsString>> {
    answer(|| {
        let call = Call {
            command,
            arguments: arguments_of(arguments)?,
        };
        Ok(call.words()?)
    })
}
