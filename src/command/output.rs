use super::host::{MessageKind, Progress, Work};
use super::running::running;
use super::wording::in_host_syntax;
use crate::lock::lock;
use crate::report::{Document, Reply, Report, SetupOrigin, TextOptions};
use crate::units::{Message, System};
use crate::{Error, Result};
use serde::Serialize;
use serde_json::Value;
use std::ffi::OsStr;
use std::fmt::Display;
use std::io;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// The units that `--units` states; `None` without this option.
pub fn stated_system() -> Option<System> {
    running().options.units
}

/// True for an answer in JSON.
pub fn is_json() -> bool {
    running().is_json
}

/// The units of the results.
pub fn system() -> System {
    running().system()
}

/// Reports a warning before the work of the command begins. Does nothing if the warning was
/// reported already. Early warnings come first in the answer; an answer without a result has no
/// other warnings.
pub fn warn_early(warning: Message) {
    if lock(&running().early).contains(&warning) {
        return;
    }
    say_warning(&warning);
    lock(&running().early).push(warning);
}

/// Reports warnings, and adds them to the answer. Does nothing for a warning that was reported
/// early.
pub fn warn(warnings: impl IntoIterator<Item = Message>) {
    for warning in warnings {
        if lock(&running().early).contains(&warning) {
            continue;
        }
        say_warning(&warning);
        lock(&running().warnings).push(warning);
    }
}

fn say_warning(warning: &Message) {
    let running = running();
    let text = warning.in_units(running.system());
    running
        .host
        .say(MessageKind::Warning, &in_host_syntax(&text));
}

/// All warnings of the answer.
pub fn warnings() -> Vec<Message> {
    let running = running();
    let early = lock(&running.early).clone();
    early
        .into_iter()
        .chain(lock(&running.warnings).iter().cloned())
        .collect()
}

/// The standard output of a command, with a flag that is true if the command found an answer.
pub struct Answer {
    text: String,
    found: bool,
}

impl Answer {
    pub fn text(text: String) -> Self {
        Self {
            text: in_host_syntax(&text),
            found: true,
        }
    }

    pub fn json(value: &impl Serialize) -> Self {
        let mut value = value_of(value);
        let left_out = lock(&running().left_out).clone();
        if let (Some(answer), false) = (value.as_object_mut(), left_out.is_empty()) {
            answer.insert("left_out".into(), left_out.into());
        }
        Self::of_value(value)
    }

    fn of_value(mut value: Value) -> Self {
        put_in_host_syntax(&mut value);
        Self::text(serde_json::to_string_pretty(&value).unwrap_or_default() + "\n")
    }

    /// An answer without a result, as JSON.
    pub fn none(status: &'static str, message: String) -> Self {
        let running = running();
        let refused = Reply::refused(running.command, status, message);
        let warnings = lock(&running.early).clone();
        Self::of_value(value_of(&Reply {
            warnings,
            ..refused
        }))
    }

    /// The report of a command about a setup, as JSON or as text.
    pub fn report(report: &impl Report, origin: &SetupOrigin) -> Self {
        if is_json() {
            return Self::json(&Reply::of(report, warnings()).about(origin));
        }
        let mut document = report.document(system());
        origin.put_before(&mut document, system());
        Self::text(text_of(&document))
    }

    /// Sets the exit status: 0 if `found` is true, otherwise 1.
    pub fn found(self, found: bool) -> Self {
        Self { found, ..self }
    }

    /// Prints the answer and returns the exit status.
    pub fn print(self) -> Result<u8> {
        match running().host.print(&self.text) {
            // a broken pipe, as in `longdrive … | head`, is not an error
            Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(Error::Output(error)),
            _ => Ok(u8::from(!self.found)),
        }
    }
}

/// A document as text, with the width and the details that the running command asks for.
pub fn text_of(document: &Document) -> String {
    let document = document.clone().map_texts(in_host_syntax);
    let running = running();
    document.text(&TextOptions {
        width: running.host.width(),
        all: running.options.all,
        verbose: running.is_verbose(),
    })
}

fn value_of(answer: &impl Serialize) -> Value {
    // serialization cannot fail: keys are strings, and numbers are finite
    serde_json::to_value(answer).unwrap_or_default()
}

/// Writes the arguments in backquotes, in all texts of a JSON value, in the syntax of the host:
/// options in a shell, keyword arguments in Python.
fn put_in_host_syntax(value: &mut Value) {
    match value {
        Value::String(text) if text.contains('`') => *text = in_host_syntax(text),
        Value::Array(values) => values.iter_mut().for_each(put_in_host_syntax),
        Value::Object(fields) => fields.values_mut().for_each(put_in_host_syntax),
        _ => {}
    }
}

/// The arguments as a command line that a shell can run again.
pub fn command_line(arguments: impl IntoIterator<Item: AsRef<OsStr>>) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "-_./=,:+@%".contains(c);
    let quoted = |argument: String| match !argument.is_empty() && argument.chars().all(is_plain) {
        true => argument,
        false => format!("'{}'", argument.replace('\'', "'\\''")),
    };
    let arguments = arguments
        .into_iter()
        .map(|argument| quoted(argument.as_ref().to_string_lossy().into_owned()));
    std::iter::once("longdrive".to_owned())
        .chain(arguments)
        .collect::<Vec<_>>()
        .join(" ")
}

/// Reports a remark or progress, unless `--quiet` is given.
pub fn note(text: &str) {
    running().note(text);
}

/// Reports notes about an input, which `input` names.
pub fn note_each<'a>(input: impl Display, notes: impl IntoIterator<Item = &'a Message>) {
    for message in notes {
        note(&format!("note: {input}: {}", message.in_units(system())));
    }
}

/// Adds a text about omitted parameters to the JSON; with `--verbose`, also reports the text.
pub fn note_left_out(text: &str) {
    lock(&running().left_out).push(text.into());
    note_detail(text);
}

/// Reports a detail of the computation, with `--verbose`.
pub fn note_detail(text: &str) {
    let running = running();
    if running.is_verbose() {
        running.note(text);
    }
}

/// Reports an error after which the command continues.
pub fn note_error(error: &Error) {
    say_error(&error.in_units(system()));
}

/// Reports an error message.
pub fn say_error(message: &str) {
    running()
        .host
        .say(MessageKind::Error, &in_host_syntax(message));
}

/// Reports an error and returns the exit status: 1 for a valid request without an answer, 2 for bad
/// input. With `--json`, standard output also contains the error.
pub fn complain(error: &Error) -> u8 {
    note_error(error);
    // after an output error, no further output
    if is_json() && !matches!(error, Error::Output(_)) {
        // ignore an error of the output: the first error is reported already
        let _ = Answer::none(error.status(), error.to_string()).print();
    }
    if error.has_valid_input() { 1 } else { 2 }
}

/// The progress of countable parts; `of` is their name in plural.
pub fn bar(of: &str) -> Arc<dyn Progress> {
    shown(Work::Parts(of))
}

/// The progress of work without countable parts.
pub fn spinner(doing: &str) -> Arc<dyn Progress> {
    shown(Work::Uncounted(doing))
}

/// The progress of this work; hidden with `--quiet`.
pub fn shown(work: Work<'_>) -> Arc<dyn Progress> {
    let running = running();
    match running.options.quiet {
        true => Arc::new(()),
        false => running.host.show_progress(work),
    }
}

/// Returns a function that is true at most once a second. It is false in the first second: most
/// searches end before a reader could read a line of progress.
pub fn once_a_second() -> impl Fn() -> bool + Send + Sync {
    let last = Mutex::new(Instant::now());
    move || {
        let mut last = lock(&last);
        let is_due = last.elapsed() >= Duration::from_secs(1);
        if is_due {
            *last = Instant::now();
        }
        is_due
    }
}

/// Runs `work` with a progress bar. `work` reports the number of completed parts and the number of
/// all parts. `of` is the name of the parts in plural.
pub fn with_bar<T>(of: &str, work: impl FnOnce(&(dyn Fn(usize, usize) + Sync)) -> T) -> T {
    let bar = bar(of);
    let done = work(&|done, all| {
        bar.set_length(all as u64);
        bar.set_position(done as u64);
    });
    bar.finish();
    done
}
