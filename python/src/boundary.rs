//! The boundary between Rust and Python: every function that Python calls returns through
//! [`answer`], which converts errors and panics to exceptions of `longdrive.errors`.

use crate::wording::in_python;
use pyo3::exceptions::PyUnicodeEncodeError;
use pyo3::prelude::*;
use pyo3::types::PyString;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// The error of a call from Python.
#[derive(Debug)]
pub enum Failure {
    /// An error of longdrive.
    Longdrive(Box<longdrive::Error>),
    /// A bad argument.
    Input(String),
    /// An unknown key of a mapping.
    Key(String),
    /// An exception of Python.
    Python(PyErr),
    /// A bug in longdrive: a panic, or inconsistent results.
    Internal(String),
}

/// The result of a call from Python.
pub type Answer<T> = Result<T, Failure>;

impl From<longdrive::Error> for Failure {
    fn from(error: longdrive::Error) -> Self {
        Self::Longdrive(Box::new(error))
    }
}

impl From<PyErr> for Failure {
    fn from(error: PyErr) -> Self {
        Self::Python(error)
    }
}

impl From<Failure> for PyErr {
    fn from(failure: Failure) -> Self {
        match failure {
            Failure::Python(error) => lone_surrogate_error(error),
            Failure::Input(message) => raised("InputError", message, None),
            Failure::Key(message) => raised("UnknownKeyError", message, None),
            Failure::Longdrive(error) if error.has_valid_input() => {
                raised("NoAnswerError", error.to_string(), Some(error.status()))
            }
            Failure::Longdrive(error) => raised("InputError", error.to_string(), None),
            Failure::Internal(message) => raised("InternalError", message, None),
        }
    }
}

/// The exception `name` of `longdrive.errors`. Its class is written in Python, so that the
/// exception can be pickled. Arguments in the message get the syntax of Python.
fn raised(name: &str, message: String, status: Option<&str>) -> PyErr {
    Python::attach(|py| {
        let class = py
            .import("longdrive.errors")
            .and_then(|module| module.getattr(name));
        let message = in_python(&message);
        let made = class.and_then(|class| match status {
            Some(status) => class.call1((message, status)),
            None => class.call1((message,)),
        });
        made.map_or_else(|error| error, PyErr::from_value)
    })
}

/// Converts the error of a text that is not valid Unicode to an error of bad input.
fn lone_surrogate_error(error: PyErr) -> PyErr {
    Python::attach(|py| {
        if !error.is_instance_of::<PyUnicodeEncodeError>(py) {
            return error;
        }
        let text = error
            .value(py)
            .getattr("object")
            .map_or_else(|_| "a text".into(), |text| shown(&text));
        Failure::Input(format!("{text} {LONE_SURROGATE}")).into()
    })
}

const LONE_SURROGATE: &str = "has half a character (a lone surrogate); give the text without it";

/// A text of Python; `what` is its name in messages.
pub fn text_of<'a>(what: &str, text: &'a Bound<'_, PyString>) -> Answer<&'a str> {
    text.to_str()
        .map_err(|_| Failure::Input(format!("{what} = {} {LONE_SURROGATE}", shown(text))))
}

/// Runs the work of a call. A panic becomes `longdrive.InternalError`, which `except Exception`
/// catches; PyO3 would raise a `BaseException`.
pub fn answer<T>(work: impl FnOnce() -> Answer<T>) -> PyResult<T> {
    Ok(unpanicked(work)??)
}

/// Runs work, and converts a panic to a failure.
pub fn unpanicked<T>(work: impl FnOnce() -> T) -> Answer<T> {
    // AssertUnwindSafe: Python gets results only when they are complete
    catch_unwind(AssertUnwindSafe(work)).map_err(|panic| {
        let text = panic
            .downcast_ref::<String>()
            .map(String::as_str)
            .or_else(|| panic.downcast_ref::<&str>().copied());
        let what = text.unwrap_or("no message");
        Failure::Internal(format!(
            "a bug in longdrive, please report it with the call that caused it: {what}"
        ))
    })
}

/// The type of a value with its article, for messages: `an int`, `a list`.
pub fn kind_of(value: &Bound<'_, PyAny>) -> String {
    let kind = value
        .py()
        .import("longdrive.arguments")
        .and_then(|module| module.getattr("kind_of")?.call1((value,))?.extract());
    kind.unwrap_or_else(|_: PyErr| "something else".into())
}

/// A value in a message, shortened.
pub fn shown(value: &Bound<'_, PyAny>) -> String {
    let shown = value
        .py()
        .import("longdrive.arguments")
        .and_then(|module| module.getattr("shown")?.call1((value,))?.extract());
    shown.unwrap_or_else(|_: PyErr| kind_of(value))
}

/// Panics, for a test of the exception.
#[pyfunction(name = "_panic_for_a_test")]
pub fn panic_for_a_test(message: String) -> PyResult<()> {
    answer(|| panic!("{message}"))
}
