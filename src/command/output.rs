use super::host::MessageKind;
use super::host::{Progress, Work};
use super::mention::commands_with;
use super::running::running;
use super::wording::{advice_on, in_host_syntax, name_in_host_syntax};
use crate::lock::lock;
use crate::report::{Document, Empty, Reply, Report, SetupOrigin, TextOptions};
use crate::units::{Message, System};
use crate::{Error, Result};
use clap::error::{ContextKind, ContextValue, ErrorKind};
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
    pub fn none(reply: Reply<Empty>) -> Self {
        let warnings = lock(&running().early).clone();
        Self::of_value(value_of(&Reply { warnings, ..reply }))
    }

    /// The report of a command about a setup, as JSON or as text.
    pub fn report(report: &impl Report, origin: &SetupOrigin, is_json: bool) -> Self {
        if is_json {
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
pub fn complain(error: &Error, command: Option<&'static str>, is_json: bool) -> u8 {
    note_error(error);
    // after an output error, no further output
    if is_json && !matches!(error, Error::Output(_)) {
        say(Reply::refused(command, error.status(), error.to_string()));
    }
    if error.has_valid_input() { 1 } else { 2 }
}

/// Reports an error in the arguments, or shows the help.
pub fn explain(mut error: clap::Error, command: Option<&'static str>, is_json: bool) -> u8 {
    if error.kind() == ErrorKind::InvalidUtf8 {
        return complain(&not_utf8(), command, is_json);
    }
    in_own_words(&mut error);
    add_subcommands(&mut error);
    let rendered = error.render();
    let shown = in_host_syntax(&rendered.ansi().to_string());
    if !error.use_stderr() {
        return match running().host.print(&shown) {
            Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
                complain(&Error::Output(error), command, false)
            }
            _ => 0,
        };
    }
    running().host.say(MessageKind::Usage, &shown);
    if is_json {
        let text = rendered.to_string();
        let text = text.split("\n\nUsage:").next().unwrap_or_default();
        let text = text
            .split("\n\nFor more information")
            .next()
            .unwrap_or_default();
        let message = text.trim().trim_start_matches("error:").trim();
        let message = with_named_arguments(message, &error);
        say(Reply::refused(command, "error", message));
    }
    u8::try_from(error.exit_code()).unwrap_or(2)
}

fn not_utf8() -> Error {
    let running = running();
    let mut words = running.words.iter();
    let word = words.find(|word| word.to_str().is_none());
    let name = word.map_or("an argument".into(), |word| word.to_string_lossy());
    let source = "its name is not UTF-8, and setups are named in UTF-8; rename the file, or give \
                  its text on standard input, as in longdrive simulate - < FILE";
    Error::unreadable(name, source)
}

/// The parser's message with argument names in the syntax of the command's `Host`: `--width
/// <PIXELS>` for the program, `width` for Python.
fn with_named_arguments(message: &str, error: &clap::Error) -> String {
    let mut message = message.to_owned();
    for kind in [ContextKind::InvalidArg, ContextKind::PriorArg] {
        let names = match error.get(kind) {
            Some(ContextValue::String(name)) => std::slice::from_ref(name),
            Some(ContextValue::Strings(names)) => names,
            _ => &[],
        };
        for name in names {
            if let Some(words) = name_in_host_syntax(name) {
                message = message.replace(name, &words);
            }
        }
    }
    message
}

/// The maximum edit distance between a typed option and a suggested option, relative to the length
/// of the suggested option. A distance of 1 is always allowed.
const MOST_DIFFERENT: f64 = 0.3;

/// True for a misspelling of an option: `--threds` of `--threads`, and not `--over` of
/// `--overwrite`.
fn is_misspelt(argument: &str, option: &str) -> bool {
    let [typed, known] = [argument, option].map(|text| text.trim_start_matches('-'));
    let different = strsim::damerau_levenshtein(typed, known) as f64;
    different <= (MOST_DIFFERENT * known.len() as f64).max(1.0)
}

/// The tip about an option that this command does not have. It names the commands that have the
/// option.
fn tip_of_unknown_option(argument: &str) -> String {
    let name = argument.split('=').next().unwrap_or(argument);
    let commands = commands_with(running().program, name.trim_start_matches('-'));
    let others = match commands.len() {
        0 | 6.. => String::new(),
        _ => format!("; it is an option of {}", commands.join(", ")),
    };
    format!("this command has no option '{name}'{others}; --help lists those that it has")
}

/// Replaces the parser's tip about an unexpected argument. The parser takes an unknown option for a
/// setup and advises `--`, or it suggests an option that only begins like the typed option.
fn in_own_words(error: &mut clap::Error) {
    let Some(ContextValue::String(argument)) = error.get(ContextKind::InvalidArg) else {
        return;
    };
    let argument = argument.clone();
    if let Some(ContextValue::String(option)) = error.get(ContextKind::SuggestedArg)
        && !is_misspelt(&argument, option)
    {
        error.remove(ContextKind::SuggestedArg);
        // remove the usage line: it would show the suggested option
        error.remove(ContextKind::Usage);
        let tip = tip_of_unknown_option(&argument);
        error.insert(
            ContextKind::Suggested,
            ContextValue::StyledStrs(vec![tip.into()]),
        );
        return;
    }
    let is_taken_for_a_setup = match error.get(ContextKind::Suggested) {
        Some(ContextValue::StyledStrs(tips)) => {
            tips.len() == 1 && tips[0].to_string().contains("use '-- ")
        }
        _ => false,
    };
    // `-o`, unlike the value `-5deg`
    let is_option = argument
        .strip_prefix('-')
        .is_some_and(|rest| rest.starts_with('-') || rest.starts_with(char::is_alphabetic));
    let tip = if !argument.starts_with('-') {
        advice_on(&argument)
    } else if !is_taken_for_a_setup {
        None
    } else if is_option {
        Some(tip_of_unknown_option(&argument))
    } else {
        Some(format!(
            "a value that begins with a hyphen is joined to its option by '=', as in \
             --set=NAME={argument}"
        ))
    };
    if let Some(tip) = tip {
        error.insert(
            ContextKind::Suggested,
            ContextValue::StyledStrs(vec![tip.into()]),
        );
    }
}

/// Adds the subcommands of a command to the error about an unknown one, unless the parser suggests
/// one: `plot` takes the kind of the plot before the setup.
fn add_subcommands(error: &mut clap::Error) {
    let is_unknown = error.kind() == ErrorKind::InvalidSubcommand;
    if !is_unknown || error.get(ContextKind::SuggestedSubcommand).is_some() {
        return;
    }
    let running = running();
    let is_typed = |command: &&clap::Command| {
        let name = command.get_name();
        command.has_subcommands() && running.words.iter().any(|word| word == name)
    };
    let Some(command) = running.program.get_subcommands().find(is_typed) else {
        return;
    };
    let names: Vec<_> = command
        .get_subcommands()
        .map(clap::Command::get_name)
        .collect();
    let tip = format!(
        "one of these comes after '{}': {}",
        command.get_name(),
        names.join(", ")
    );
    error.insert(
        ContextKind::Suggested,
        ContextValue::StyledStrs(vec![tip.into()]),
    );
}

/// Prints an answer without a result.
fn say(reply: Reply<Empty>) {
    let _ = running().host.print(&Answer::none(reply).text);
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
