//! Parts of a sweep: `longdrive sweep --part` and `--check`, for a setup of Python, and what merges of their answers.

use crate::boundary::{Answer, Failure, answer};
use crate::json::to_python;
use crate::pool;
use longdrive::command::{self, Host, Kind};
use longdrive::parts::{Manifest, merge};
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use serde_json::Value;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

/// Whom the command is run for: it keeps the answer.
#[derive(Default)]
struct Listener {
    setup: String,
    answer: Mutex<String>,
    stops: Mutex<Vec<Arc<AtomicBool>>>,
}

impl Host for Listener {
    fn print(&self, text: &str) -> std::io::Result<()> {
        self.answer.lock().unwrap_or_else(PoisonError::into_inner).push_str(text);
        Ok(())
    }

    // an error stands in the answer, and so do the warnings
    fn say(&self, _: Kind, _: &str) {}

    fn input(&self) -> std::io::Result<String> {
        Ok(self.setup.clone())
    }

    fn can_stop(&self, _: &'static str, stop: &Arc<AtomicBool>) {
        self.stops.lock().unwrap_or_else(PoisonError::into_inner).push(Arc::clone(stop));
    }
}

impl Listener {
    fn stop(&self) {
        let stops = self.stops.lock().unwrap_or_else(PoisonError::into_inner);
        stops.iter().for_each(|stop| stop.store(true, Ordering::Relaxed));
    }

    fn value(&self) -> Answer<Value> {
        let answer = self.answer.lock().unwrap_or_else(PoisonError::into_inner);
        serde_json::from_str(&answer).map_err(|error| Failure::Panic(format!("the answer of sweep: {error}")))
    }
}

/// The answer of ``longdrive sweep --json`` with these options for a setup, the text of a setup file. Bad input is an exception; a part that is
/// missing is none.
#[pyfunction]
pub fn sweep_command<'py>(py: Python<'py>, setup: String, options: Vec<String>) -> PyResult<Bound<'py, PyAny>> {
    answer(|| {
        let listener = Arc::new(Listener { setup, ..Listener::default() });
        let words = ["longdrive", "sweep", "-", "--json", "--quiet"].into_iter().map(Into::into);
        let words: Vec<_> = words.chain(options.into_iter().map(Into::into)).collect();
        let host = Arc::clone(&listener);
        let status = pool::run(py, move |_| command::run(words, host), || Ok(()));
        if status.is_err() {
            listener.stop();
        }
        let (status, value) = (status?, listener.value()?);
        let message = || value["message"].as_str().unwrap_or_default().to_owned();
        match (status, value["status"].as_str()) {
            (2, _) => Err(Failure::Input(message())),
            (_, Some("interrupted")) => Err(Failure::Python(PyKeyboardInterrupt::new_err(message()))),
            _ => to_python(py, &value),
        }
    })
}

/// What the rows of some parts are like in all, from their manifests as JSON.
#[pyfunction]
pub fn merge_parts<'py>(py: Python<'py>, manifests: &str) -> PyResult<Bound<'py, PyAny>> {
    answer(|| {
        let manifests: Vec<Manifest> = serde_json::from_str(manifests)
            .map_err(|error| Failure::Input(format!("manifests: {error}; give what a sweep in parts has answered")))?;
        to_python(py, &merge(&manifests)?)
    })
}
