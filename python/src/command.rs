//! The studies: every command of the program, asked in its words and answered in its JSON.

use crate::boundary::{Answer, Failure, answer};
use crate::json::to_python;
use crate::pool;
use indicatif::{ProgressBar, ProgressDrawTarget};
use longdrive::command::{Host, Kind, run, run_in_terminal};
use pyo3::prelude::*;
use std::ffi::OsString;
use std::io;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// How long work that was told to end may take to say what it has so far.
const LAST_WORDS: Duration = Duration::from_millis(40);

/// A program in Python, as the host of a command.
#[derive(Default)]
struct Caller {
    now: Mutex<Now>,
    /// The setup, as the text of a setup file.
    setup: String,
}

#[derive(Default)]
struct Now {
    answer: String,
    said: Vec<(&'static str, String)>,
    stop: Option<Arc<AtomicBool>>,
    /// The bar that was shown last.
    bar: Option<ProgressBar>,
}

impl Caller {
    fn now(&self) -> MutexGuard<'_, Now> {
        self.now.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// What work that was told to stop says within a moment.
    fn last_words(&self) -> String {
        let told = Instant::now();
        while told.elapsed() < LAST_WORDS && self.now().answer.is_empty() {
            std::thread::sleep(LAST_WORDS / 16);
        }
        std::mem::take(&mut self.now().answer)
    }
}

impl Host for Caller {
    fn print(&self, text: &str) -> io::Result<()> {
        self.now().answer.push_str(text);
        Ok(())
    }

    fn say(&self, kind: Kind, text: &str) {
        let kind = match kind {
            Kind::Note => "note",
            Kind::Warning => "warning",
            // what arguments lack stands in the answer too, without colours
            Kind::Usage | Kind::Help => return,
            Kind::Error => "error",
        };
        self.now().said.push((kind, text.to_owned()));
    }

    fn input(&self) -> io::Result<String> {
        Ok(self.setup.clone())
    }

    fn can_stop(&self, _: &'static str, stop: &Arc<AtomicBool>) {
        self.now().stop = Some(stop.clone());
    }

    fn cannot_stop(&self) {
        self.now().stop = None;
    }

    fn shows(&self, bar: ProgressBar) -> ProgressBar {
        bar.set_draw_target(ProgressDrawTarget::hidden());
        self.now().bar = Some(bar.clone());
        bar
    }
}

/// Runs a command and waits for its answer: exit status, and answer (parsed where it is JSON, else a text).
///
/// Args:
///     words: the command line, without the name of the program.
///     setup: the text of the setup file that is named ``-``.
///     say: called from the calling thread with what is said beside the answer: its kind (``note``, ``warning``, ``error``) and the text.
///     progress: called now and then from the calling thread with how many parts of how many are done (0 of 0 where they cannot be counted).
///
/// Raises:
///     KeyboardInterrupt: after Ctrl-C, within a tenth of a second; work that can stop stops, and ``answer`` of the exception is what it had by then,
///         or None.
#[pyfunction]
#[pyo3(signature = (words, setup, say, progress = None))]
pub fn command<'py>(
    py: Python<'py>,
    words: Vec<OsString>,
    setup: String,
    say: &Bound<'py, PyAny>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<(u8, Bound<'py, PyAny>)> {
    answer(|| asked(py, words, setup, say, progress))
}

fn asked<'py>(
    py: Python<'py>,
    words: Vec<OsString>,
    setup: String,
    say: &Bound<'py, PyAny>,
    progress: Option<&Bound<'py, PyAny>>,
) -> Answer<(u8, Bound<'py, PyAny>)> {
    let caller = Arc::new(Caller { setup, now: Mutex::default() });
    let host = caller.clone();
    let words = [OsString::from("longdrive")].into_iter().chain(words).collect();
    let watch = || said(&caller, say).and_then(|()| shown(&caller, progress));
    let status = match pool::run(py, move |_| run(words, host), watch) {
        Ok(status) => status,
        Err(Failure::Python(error)) => {
            if let Some(stop) = &caller.now().stop {
                stop.store(true, Ordering::Relaxed);
            }
            let answer = py.detach(|| caller.last_words());
            error.value(py).setattr("answer", parsed(py, &answer)?)?;
            return Err(error.into());
        }
        Err(failure) => return Err(failure),
    };
    said(&caller, say)?;
    let text = std::mem::take(&mut caller.now().answer);
    Ok((status, parsed(py, &text)?))
}

fn said(caller: &Caller, say: &Bound<'_, PyAny>) -> PyResult<()> {
    let said = std::mem::take(&mut caller.now().said);
    said.into_iter().try_for_each(|said| say.call1(said).map(drop))
}

fn shown(caller: &Caller, progress: Option<&Bound<'_, PyAny>>) -> PyResult<()> {
    let Some(progress) = progress else { return Ok(()) };
    let bar = caller.now().bar.clone();
    if let Some(bar) = bar {
        progress.call1((bar.position(), bar.length().unwrap_or(0)))?;
    }
    Ok(())
}

/// JSON as objects of Python, and any other text as it is; None where there is none.
fn parsed<'py>(py: Python<'py>, text: &str) -> Answer<Bound<'py, PyAny>> {
    if text.is_empty() {
        return Ok(py.None().into_bound(py));
    }
    match serde_json::from_str::<serde_json::Value>(text) {
        Ok(value) => to_python(py, &value),
        Err(_) => Ok(pyo3::types::PyString::new(py, text).into_any()),
    }
}

/// The program itself, in the terminal; its exit status.
#[pyfunction]
pub fn main(py: Python<'_>, words: Vec<OsString>) -> PyResult<u8> {
    answer(|| {
        let words = [OsString::from("longdrive")].into_iter().chain(words).collect();
        Ok(py.detach(|| run_in_terminal(words)))
    })
}

/// Every command with its options: what the functions of ``longdrive.commands`` are made of.
#[pyfunction]
pub fn described(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    answer(|| to_python(py, &longdrive::command::described()))
}
