//! Runs the commands of the program for Python, from typed arguments to an answer in JSON.

use crate::boundary::{Answer, answer};
use crate::json::to_python;
use crate::pool::{self, Ended, lock};
use crate::request::arguments_of;
use crate::wording;
use longdrive::command::{
    Call, Host, MemoryFiles, Mention, MessageKind, Progress, Work, call, mark_options,
    run_in_terminal,
};
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use serde_json::Value;
use std::collections::HashMap;
use std::ffi::OsString;
use std::io;
use std::panic::resume_unwind;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use std::time::Duration;

/// Time for stopped work to return its result so far. Work checks for a stop only between two
/// drives, and a drive may take longer than this.
const ANSWER_TIME: Duration = Duration::from_secs(2);

/// A program in Python that calls a command: the `Host` of the command.
#[derive(Default)]
struct Caller {
    state: Mutex<HostState>,
    files: Mutex<Files>,
    /// The setup, as the text of a setup file.
    setup: String,
    /// Names of the parameters that the call gives in a dict.
    stated: Vec<String>,
    /// The input files in memory.
    inputs: MemoryFiles,
    /// The output files in memory, with their contents once they are complete.
    outputs: Mutex<HashMap<PathBuf, Vec<u8>>>,
}

#[derive(Default)]
struct HostState {
    answer: String,
    messages: Vec<(&'static str, String)>,
    stop: Option<Arc<AtomicBool>>,
    /// True after interruptible work has ended. Then the command only has to write its answer.
    only_answer_is_left: bool,
    /// The last progress that the command showed.
    bar: Option<Arc<Bar>>,
}

/// The progress of long work.
#[derive(Default)]
struct Bar {
    /// Number of completed parts.
    position: AtomicU64,
    /// Number of all parts, 0 if it is unknown.
    length: AtomicU64,
    message: Mutex<String>,
}

impl Bar {
    fn position(&self) -> u64 {
        self.position.load(Ordering::Relaxed)
    }

    fn length(&self) -> u64 {
        self.length.load(Ordering::Relaxed)
    }
}

impl Progress for Bar {
    fn set_length(&self, parts: u64) {
        self.length.store(parts, Ordering::Relaxed);
    }

    fn set_position(&self, parts: u64) {
        self.position.store(parts, Ordering::Relaxed);
    }

    fn inc(&self, parts: u64) {
        self.position.fetch_add(parts, Ordering::Relaxed);
    }

    fn set_message(&self, message: String) {
        *lock(&self.message) = message;
    }

    fn finish(&self) {
        self.set_position(self.length());
    }
}

/// The files of a command. Its lock is held while a file is written.
#[derive(Default)]
struct Files {
    /// Names of the complete files.
    written: Vec<String>,
    /// True if the call has returned before the command ended.
    is_abandoned: bool,
}

impl Caller {
    /// Adds a note with the position of the progress bar and the best value so far.
    fn note_progress(&self) {
        let mut state = lock(&self.state);
        let Some(bar) = state.bar.clone().filter(|bar| bar.length() > 0) else {
            return;
        };
        let best = match lock(&bar.message).as_str() {
            "" => String::new(),
            best => format!(", best {best}"),
        };
        let message = format!("{} of {} done{best}", bar.position(), bar.length());
        state.messages.push(("note", message));
    }

    /// Stops the current work. Returns the time to wait for the answer: zero if the work can
    /// neither be stopped nor has ended.
    fn stop(&self) -> Duration {
        let state = lock(&self.state);
        if let Some(stop) = &state.stop {
            stop.store(true, Ordering::Relaxed);
        }
        if state.stop.is_some() || state.only_answer_is_left {
            ANSWER_TIME
        } else {
            Duration::ZERO
        }
    }
}

impl Host for Caller {
    fn print(&self, text: &str) -> io::Result<()> {
        lock(&self.state).answer.push_str(text);
        Ok(())
    }

    fn say(&self, kind: MessageKind, text: &str) {
        // the answer contains the errors in the arguments already, without colours
        if kind == MessageKind::Usage {
            return;
        }
        let message = (kind.name(), text.to_owned());
        lock(&self.state).messages.push(message);
    }

    /// Always true: the level of Python's log selects the messages.
    fn receives_details(&self) -> bool {
        true
    }

    fn mention(&self, mention: Mention<'_>) -> String {
        wording::mention(mention)
    }

    fn input(&self) -> io::Result<String> {
        Ok(self.setup.clone())
    }

    fn setup_name(&self) -> &'static str {
        "the setup"
    }

    fn stated(&self) -> Option<Vec<String>> {
        Some(self.stated.clone())
    }

    fn files(&self) -> MemoryFiles {
        self.inputs.clone()
    }

    fn keeps(&self, name: &Path) -> bool {
        lock(&self.outputs).contains_key(name)
    }

    fn keep(&self, name: &Path, content: Vec<u8>) {
        lock(&self.outputs).insert(name.into(), content);
    }

    fn can_stop(&self, _: &'static str, stop: &Arc<AtomicBool>) {
        lock(&self.state).stop = Some(stop.clone());
    }

    fn cannot_stop(&self) {
        let mut state = lock(&self.state);
        state.only_answer_is_left |= state.stop.take().is_some();
    }

    fn hold(&self) -> Box<dyn FnOnce(&Path) + '_> {
        let mut files = lock(&self.files);
        if files.is_abandoned {
            drop(files);
            // the call has returned, and its caller expects no more files: end this thread without
            // the message of a panic
            resume_unwind(Box::new("abandoned"));
        }
        Box::new(move |path| files.written.push(path.display().to_string()))
    }

    fn show_progress(&self, _: Work<'_>) -> Arc<dyn Progress> {
        let bar = Arc::new(Bar::default());
        lock(&self.state).bar = Some(bar.clone());
        bar
    }
}

/// The result of a command: exit status, answer, output files in memory, and the exception that
/// interrupted the command. An abandoned command has the exit status `None`, and the names of the
/// files that it had written as its answer.
type Ran<'py> = (
    Option<u8>,
    Bound<'py, PyAny>,
    Bound<'py, PyDict>,
    Option<PyErr>,
);

/// Runs a command, and returns its exit status, its answer (parsed JSON, else a text), its output
/// files in memory, and the exception that interrupted the command, if any. After Ctrl-C,
/// interruptible work has two seconds, or until the next Ctrl-C, to answer with its result so far.
/// Other work is abandoned: it writes no more files, and a list of the files that it has written
/// replaces the answer.
///
/// Parameters
/// ----------
/// command
///     The command, as ``optimize`` or ``plot contour``.
/// arguments
///     Typed values by the names of the options.
/// setup
///     The text of the setup file ``-``.
/// files
///     Input files in memory.
/// outputs
///     Names of output files that stay in memory.
/// say
///     Called from the calling thread with each message: its kind (``note``, ``warning``,
///     ``error``) and its text.
/// progress
///     Called now and then from the calling thread with the number of completed parts and the
///     number of all parts. The second number is 0 if the parts cannot be counted.
/// stated
///     The names of the parameters that the call states in a dict.
#[pyfunction]
#[expect(
    clippy::too_many_arguments,
    reason = "only longdrive.run_command calls it"
)]
#[pyo3(signature = (command, arguments, setup, files, outputs, say, progress = None, stated = None))]
pub fn command<'py>(
    py: Python<'py>,
    command: String,
    arguments: &Bound<'py, PyDict>,
    setup: String,
    files: HashMap<PathBuf, Vec<u8>>,
    outputs: Vec<PathBuf>,
    say: &Bound<'py, PyAny>,
    progress: Option<&Bound<'py, PyAny>>,
    stated: Option<Vec<String>>,
) -> PyResult<Ran<'py>> {
    answer(|| {
        let call = Call {
            command,
            arguments: arguments_of(arguments)?,
        };
        let caller = Caller {
            setup,
            stated: stated.unwrap_or_default(),
            inputs: files
                .into_iter()
                .map(|(name, content)| (name, content.into()))
                .collect(),
            outputs: Mutex::new(outputs.into_iter().map(|name| (name, vec![])).collect()),
            ..Caller::default()
        };
        ran(py, call, Arc::new(caller), say, progress)
    })
}

fn ran<'py>(
    py: Python<'py>,
    request: Call,
    caller: Arc<Caller>,
    say: &Bound<'py, PyAny>,
    progress: Option<&Bound<'py, PyAny>>,
) -> Answer<Ran<'py>> {
    let host = caller.clone();
    let watch = || pass_on(&caller, say).and_then(|()| shown(&caller, progress));
    let patience = |raised: &PyErr| {
        let time = caller.stop();
        // wait for the answer after Ctrl-C, but not after an exception of `say` or `progress`
        if raised.is_instance_of::<PyKeyboardInterrupt>(py) {
            time
        } else {
            Duration::ZERO
        }
    };
    let (status, raised) =
        match pool::run_to_answer(py, move |_| call(&request, host), watch, patience)? {
            Ended::Done(status, raised) => (Some(status), raised),
            Ended::Abandoned(raised) => {
                caller.note_progress();
                pass_on(&caller, say)?;
                let written = py.detach(|| {
                    let mut files = lock(&caller.files);
                    files.is_abandoned = true;
                    std::mem::take(&mut files.written)
                });
                let none = PyDict::new(py);
                return Ok((None, written.into_pyobject(py)?, none, Some(raised)));
            }
        };
    // the user may also press Ctrl-C during these last messages
    let raised = raised.or(pass_on(&caller, say).err());
    let text = std::mem::take(&mut lock(&caller.state).answer);
    let outputs = PyDict::new(py);
    for (name, content) in lock(&caller.outputs).drain() {
        outputs.set_item(name.to_string_lossy(), PyBytes::new(py, &content))?;
    }
    Ok((status, parsed(py, &text)?, outputs, raised))
}

fn pass_on(caller: &Caller, say: &Bound<'_, PyAny>) -> PyResult<()> {
    let messages = std::mem::take(&mut lock(&caller.state).messages);
    messages
        .into_iter()
        .try_for_each(|message| say.call1(message).map(drop))
}

fn shown(caller: &Caller, progress: Option<&Bound<'_, PyAny>>) -> PyResult<()> {
    let Some(progress) = progress else {
        return Ok(());
    };
    let bar = lock(&caller.state).bar.clone();
    if let Some(bar) = bar {
        progress.call1((bar.position(), bar.length()))?;
    }
    Ok(())
}

/// JSON as objects of Python, other texts unchanged; None for an empty text.
fn parsed<'py>(py: Python<'py>, text: &str) -> Answer<Bound<'py, PyAny>> {
    if text.is_empty() {
        return Ok(py.None().into_bound(py));
    }
    match serde_json::from_str::<Value>(text) {
        Ok(value) => to_python(py, &value),
        Err(_) => Ok(pyo3::types::PyString::new(py, text).into_any()),
    }
}

/// Runs the program in the terminal; returns its exit status.
#[pyfunction]
pub fn main(py: Python<'_>, words: Vec<OsString>) -> PyResult<u8> {
    answer(|| {
        let words = [OsString::from("longdrive")]
            .into_iter()
            .chain(words)
            .collect();
        Ok(py.detach(|| run_in_terminal(words)))
    })
}

/// Every command with its options. ``make_commands.py`` writes the functions of
/// ``longdrive.commands`` from them. Each option also has ``argument``, its name in Python, and
/// ``words``, its help in the syntax of Python.
#[pyfunction]
pub fn described(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    fn describe(command: &mut Value) {
        for option in command["options"].as_array_mut().into_iter().flatten() {
            let name = option["name"]
                .as_str()
                .unwrap_or_default()
                .replace('-', "_");
            option["argument"] = wording::argument_of(&name).into();
            let help = option["help"].as_str().unwrap_or_default();
            option["words"] = wording::in_python(&mark_options(help)).into();
        }
        for below in command["commands"].as_array_mut().into_iter().flatten() {
            describe(below);
        }
    }
    let mut commands = longdrive::command::described();
    for command in commands.as_array_mut().into_iter().flatten() {
        describe(command);
    }
    answer(|| to_python(py, &commands))
}
