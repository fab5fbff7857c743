//! Colours of status words. Only terminals show them; `NO_COLOR`, `TERM=dumb` and a pipe turn them
//! off.

use super::host::MessageKind;
use super::width;
use crate::report::remark;
use anstream::{AutoStream, ColorChoice};
use clap::builder::styling::{AnsiColor, Style};
use std::io::{self, Write};

const GOOD: Style = AnsiColor::Green.on_default().bold();
const DOUBTFUL: Style = AnsiColor::Yellow.on_default().bold();
const BAD: Style = AnsiColor::Red.on_default().bold();

/// Status words at the beginning of a line.
const STATUS: [(&str, Style); 15] = [
    ("converged", GOOD),
    ("passed", GOOD),
    ("pass", GOOD),
    ("stalled", DOUBTFUL),
    ("stalled-at-kink", DOUBTFUL),
    ("iteration-limit", DOUBTFUL),
    ("interrupted", DOUBTFUL),
    ("undetermined", DOUBTFUL),
    ("infeasible", BAD),
    ("unbounded", BAD),
    ("no-flight", BAD),
    ("no flight", BAD),
    ("FAILED", BAD),
    ("fail", BAD),
    ("left out", DOUBTFUL),
];

/// Prints an answer to standard output.
pub fn print(text: &str) -> io::Result<()> {
    let mut out = anstream::stdout().lock();
    // Without colours, write the bytes unchanged. The help contains escape codes: `out` removes
    // them.
    if AutoStream::choice(&io::stdout()) == ColorChoice::Never && !text.contains('\u{1b}') {
        let mut out = out.into_inner();
        return out.write_all(text.as_bytes()).and_then(|()| out.flush());
    }
    out.write_all(painted(text).as_bytes())
        .and_then(|()| out.flush())
}

/// Prints a message to standard error. "warning: …" is wrapped to the width of the terminal;
/// "error: …" keeps its lines, which may point at a place in a file or an expression.
pub fn say(kind: MessageKind, message: &str) {
    let text = format!("{kind}: {message}");
    let (style, text) = match kind {
        MessageKind::Error => (BAD, text),
        _ => (DOUBTFUL, remark(&text, width::of_messages())),
    };
    let _ = writeln!(
        anstream::stderr().lock(),
        "{style}{kind}:{style:#}{}",
        &text[kind.name().len() + 1..]
    );
}

fn painted(text: &str) -> String {
    let line = |line: &str| {
        let word = line.trim_start();
        let indent = &line[..line.len() - word.len()];
        let status = STATUS.iter().find(|(status, _)| {
            word.strip_prefix(status)
                .is_some_and(|rest| rest.starts_with(':'))
        });
        match status {
            Some((status, style)) => {
                format!("{indent}{style}{status}{style:#}{}", &word[status.len()..])
            }
            None => line.to_owned(),
        }
    };
    text.split_inclusive('\n').map(line).collect()
}
