use indicatif::{ProgressBar, ProgressStyle};
use longdrive::report::{Empty, Reply};
use longdrive::{Error, Result};
use serde::Serialize;
use std::io::{self, Write};
use std::process::ExitCode;

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
        Self::text(serde_json::to_string_pretty(value).unwrap_or_default() + "\n")
    }

    /// The same answer, with exit status 1 where it says that there is none.
    pub fn found(self, found: bool) -> Self {
        Self { found, ..self }
    }

    pub fn print(self) -> Result<ExitCode> {
        let mut out = io::stdout().lock();
        match out.write_all(self.text.as_bytes()).and_then(|()| out.flush()) {
            // a reader that has gone away, as `head` does, is no failure of ours
            Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(Error::Output(error)),
            _ => Ok(ExitCode::from(u8::from(!self.found))),
        }
    }
}

/// A line on standard error.
pub fn tell(line: &str) {
    let _ = writeln!(io::stderr().lock(), "{line}");
}

pub fn warn(warnings: &[String]) {
    for warning in warnings {
        tell(&format!("warning: {warning}"));
    }
}

/// Says what went wrong; status 1 for a sound question without an answer, 2 for bad input. Where JSON is asked for, standard
/// output says it too.
pub fn complain(error: &Error, command: &'static str, is_json: bool) -> ExitCode {
    tell(&format!("error: {error}"));
    // what could not be written once cannot be written now
    if is_json && !matches!(error, Error::Output(_)) {
        say(&Reply::none(Some(command), error));
    }
    ExitCode::from(if error.is_an_outcome() { 1 } else { 2 })
}

/// Says what the arguments lack, or shows the help that they ask for.
pub fn explain(error: &clap::Error, command: Option<&'static str>, is_json: bool) -> ExitCode {
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

fn say(reply: &Reply<Empty>) {
    let _ = Answer::json(reply).print();
}

/// Progress of long work, on standard error; nothing where that is no terminal.
pub fn bar(of: &str) -> ProgressBar {
    let style = ProgressStyle::with_template(&format!("{{bar:40}} {{pos}}/{{len}} {of}, {{eta}} left"));
    ProgressBar::new(0).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
