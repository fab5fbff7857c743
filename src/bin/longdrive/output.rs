use indicatif::{ProgressBar, ProgressStyle};
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

/// Says what went wrong; status 1 for a sound question without an answer, 2 for bad input.
pub fn complain(error: &Error) -> ExitCode {
    tell(&format!("error: {error}"));
    ExitCode::from(if error.is_an_outcome() { 1 } else { 2 })
}

/// Progress of long work, on standard error; nothing where that is no terminal.
pub fn bar(of: &str) -> ProgressBar {
    let style = ProgressStyle::with_template(&format!("{{bar:40}} {{pos}}/{{len}} {of}, {{eta}} left"));
    ProgressBar::new(0).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
