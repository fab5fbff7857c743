use crate::args::Shown;
use crate::colour;
use clap::error::{ContextKind, ContextValue};
use indicatif::{ProgressBar, ProgressStyle};
use longdrive::report::{Empty, Reply, remark};
use longdrive::units::{Message, System};
use longdrive::{Error, Result};
use serde::Serialize;
use serde_json::Value;
use std::io::{self, Write};
use std::process::ExitCode;
use std::sync::{Mutex, OnceLock, PoisonError};

/// The options of every command about what is printed; set once, before anything is.
static SHOWN: OnceLock<Shown> = OnceLock::new();

pub fn begin(shown: Shown) {
    // a second time would be a mistake of the program, and the first stays
    let _ = SHOWN.set(shown);
}

/// The units that were asked for, if any.
pub fn stated_system() -> Option<System> {
    SHOWN.get().and_then(|shown| shown.units).map(System::from)
}

/// The units that results are shown in.
pub fn system() -> System {
    stated_system().unwrap_or_default()
}

fn is_quiet() -> bool {
    SHOWN.get().is_some_and(|shown| shown.quiet)
}

/// Warnings about what was read and chosen before a command's own work; its answer has them too.
static EARLY: Mutex<Vec<Message>> = Mutex::new(vec![]);

/// Warns of what the work of the command begins with.
pub fn warn_early(warning: Message) {
    warn(std::slice::from_ref(&warning));
    EARLY.lock().unwrap_or_else(PoisonError::into_inner).push(warning);
}

/// What a command has to say on standard output, and whether it found what it was asked for.
pub struct Answer {
    text: String,
    found: bool,
}

impl Answer {
    pub fn text(text: String) -> Self {
        Self { text, found: true }
    }

    pub fn json(value: &impl Serialize) -> Self {
        // names are strings and numbers finite: nothing of ours fails to serialise
        let mut value = serde_json::to_value(value).unwrap_or_default();
        let early = EARLY.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(warnings) = value.get_mut("warnings").and_then(Value::as_array_mut) {
            warnings.splice(0..0, early.iter().map(|warning| warning.to_string().into()));
        }
        Self::text(serde_json::to_string_pretty(&value).unwrap_or_default() + "\n")
    }

    /// The same answer, with exit status 1 where it says that there is none.
    pub fn found(self, found: bool) -> Self {
        Self { found, ..self }
    }

    pub fn print(self) -> Result<ExitCode> {
        match colour::print(&self.text) {
            // a reader that has gone away, as `head` does, is no failure of ours
            Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(Error::Output(error)),
            _ => Ok(ExitCode::from(u8::from(!self.found))),
        }
    }
}

/// The arguments as a command line that can be given again to a shell.
pub fn command_line(arguments: impl Iterator<Item = String>) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "-_./=,:+@%".contains(c);
    let quoted = |argument: String| match !argument.is_empty() && argument.chars().all(is_plain) {
        true => argument,
        false => format!("'{}'", argument.replace('\'', "'\\''")),
    };
    std::iter::once("longdrive".to_owned()).chain(arguments.map(quoted)).collect::<Vec<_>>().join(" ")
}

/// A remark or progress on standard error, in lines that fit a terminal, unless --quiet is given.
pub fn tell(text: &str) {
    if !is_quiet() {
        let _ = writeln!(io::stderr().lock(), "{}", remark(text));
    }
}

pub fn warn(warnings: &[Message]) {
    for warning in warnings {
        colour::say("warning", &warning.in_units(system()));
    }
}

/// An error on standard error, where the command goes on.
pub fn tell_error(error: &Error) {
    colour::say("error", &error.in_units(system()));
}

/// Says what went wrong; status 1 for a sound question without an answer, 2 for bad input. Where JSON is asked for, standard
/// output says it too.
pub fn complain(error: &Error, command: &'static str, is_json: bool) -> ExitCode {
    tell_error(error);
    // what could not be written once cannot be written now
    if is_json && !matches!(error, Error::Output(_)) {
        say(&Reply::none(Some(command), error));
    }
    ExitCode::from(if error.is_an_outcome() { 1 } else { 2 })
}

/// Says what the arguments lack, or shows the help that they ask for.
pub fn explain(mut error: clap::Error, command: Option<&'static str>, is_json: bool) -> ExitCode {
    in_own_words(&mut error);
    // a reader that has gone away is no failure of ours
    let _ = error.print();
    if error.use_stderr() && is_json {
        let text = error.render().to_string();
        let text = text.split("\n\nUsage:").next().unwrap_or_default();
        let text = text.split("\n\nFor more information").next().unwrap_or_default();
        let message = text.trim().trim_start_matches("error:").trim().to_owned();
        say(&Reply::refused(command, "error", message));
    }
    ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2))
}

/// Says what to do about an argument that begins with a hyphen and is no option: the reader of arguments takes it for the name of a
/// setup that is to stand after `--`.
fn in_own_words(error: &mut clap::Error) {
    let Some(ContextValue::StyledStrs(tips)) = error.get(ContextKind::Suggested) else { return };
    let Some(ContextValue::String(argument)) = error.get(ContextKind::InvalidArg) else { return };
    if tips.len() != 1 || !tips[0].to_string().contains("use '-- ") {
        return;
    }
    let tip = match argument.starts_with("--") {
        true => format!("this command has no option '{argument}'; --help lists those that it has"),
        false => {
            format!("a value that begins with a hyphen is joined to its option by '=', as in --set=NAME={argument}")
        }
    };
    error.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![tip.into()]));
}

/// An answer without anything found, on standard output, where the program ends with it.
pub fn say(reply: &Reply<Empty>) {
    let _ = colour::print(&Answer::json(reply).text);
}

/// Progress of long work, on standard error; nothing where that is not a terminal, or with --quiet.
pub fn bar(of: &str) -> ProgressBar {
    if is_quiet() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template(&format!("{{bar:40}} {{pos}}/{{len}} {of}, {{eta}} left"));
    ProgressBar::new(0).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

/// Shows how many of how many are done.
pub fn show(bar: &ProgressBar, done: usize, all: usize) {
    bar.set_length(all as u64);
    bar.set_position(done as u64);
}

/// That work without parts to count is under way, and for how long.
pub fn spinner(doing: &'static str) -> ProgressBar {
    if is_quiet() {
        return ProgressBar::hidden();
    }
    let spinner = ProgressBar::new_spinner().with_message(doing);
    spinner.enable_steady_tick(std::time::Duration::from_millis(200));
    spinner
}
