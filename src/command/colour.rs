//! Colours of status words, on terminals only; NO_COLOR turns them off, as do `TERM=dumb` and a
//! pipe.

use crate::report::remark;
use anstream::{AutoStream, ColorChoice};
use clap::builder::styling::{AnsiColor, Style};
use std::io::{self, Write};

const GOOD: Style = AnsiColor::Green.on_default().bold();
const DOUBTFUL: Style = AnsiColor::Yellow.on_default().bold();
const BAD: Style = AnsiColor::Red.on_default().bold();

/// Words that begin a line of an answer and say how it ended.
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
    // text without colours is written unchanged, byte for byte
    if AutoStream::choice(&io::stdout()) == ColorChoice::Never {
        let mut out = out.into_inner();
        return out.write_all(text.as_bytes()).and_then(|()| out.flush());
    }
    out.write_all(painted(text).as_bytes())
        .and_then(|()| out.flush())
}

/// On standard error: "warning: …", in lines that fit a terminal; "error: …", which stays in the
/// lines that it has: they may point at a place of a file or of an expression.
pub fn say(kind: &str, message: &str) {
    let (style, text) = match kind {
        "error" => (BAD, format!("{kind}: {message}")),
        _ => (DOUBTFUL, remark(&format!("{kind}: {message}"))),
    };
    let _ = writeln!(
        anstream::stderr().lock(),
        "{style}{kind}:{style:#}{}",
        &text[kind.len() + 1..]
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
