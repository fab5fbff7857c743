//! Runs command lines and requests.

use super::call::{Call, with_degrees};
use super::host::Host;
use super::output::{Answer, complain};
use super::running::{Running, within};
#[cfg(feature = "cli")]
use super::terminal::Terminal;
use super::usage::explain;
use super::wording::with_quotes_advice;
use super::{Program, named_in, program};
use crate::Error;
use crate::input_file::with_memory_files;
use std::ffi::OsString;
use std::io::ErrorKind;
#[cfg(feature = "cli")]
use std::process::ExitCode;
use std::sync::Arc;

/// The program: runs the command line of the process in a terminal.
#[cfg(feature = "cli")]
pub fn main() -> ExitCode {
    ExitCode::from(run_in_terminal(std::env::args_os().collect()))
}

/// Runs the program; the first argument is the program's name. Returns the exit status.
#[cfg(feature = "cli")]
pub fn run_in_terminal(words: Vec<OsString>) -> u8 {
    run(words, Arc::new(Terminal::default()))
}

/// Runs a command line for a host; the first word is the name of the program. Returns the exit
/// status: 0 done, 1 no answer, 2 bad input. The host receives the error message. With `--json`,
/// the answer also contains the error message.
pub fn run(words: Vec<OsString>, host: Arc<dyn Host>) -> u8 {
    run_words(words, host, &[])
}

/// Runs a request of a program that embeds the library. Returns the exit status of [`run`].
pub fn call(call: &Call, host: Arc<dyn Host>) -> u8 {
    match call.command_line() {
        Ok(line) => run_words(line.words, host, &line.bare_angles),
        Err(error) => {
            let running = Running {
                program: program(),
                host,
                is_json: true,
                ..Running::default()
            };
            within(running, || complain(&error))
        }
    }
}

/// Runs a command line. `bare_angles` are the angles, rad, that the request gave without a unit.
fn run_words(words: Vec<OsString>, host: Arc<dyn Host>, bare_angles: &[f64]) -> u8 {
    let read = Program::read(&words);
    let words = words.into_iter().skip(1).collect::<Vec<_>>();
    let request = match read {
        Ok(request) => request,
        Err(error) => {
            let running = Running {
                program: program(),
                host,
                command: named_in(&words),
                is_json: words.iter().any(|word| word == "--json"),
                words,
                ..Running::default()
            };
            return within(running, || explain(error));
        }
    };
    host.begin(request.name, request.is_json);
    let files = host.files();
    let running = Running {
        program: program(),
        host,
        command: Some(request.name),
        is_json: request.is_json,
        options: request.output.clone(),
        words,
        ..Running::default()
    };
    let work = || match request.command.answer().and_then(Answer::print) {
        Ok(status) => status,
        // a broken pipe, as in `longdrive … | head`, is not an error
        Err(Error::Output(error)) if error.kind() == ErrorKind::BrokenPipe => 0,
        Err(error) => complain(&with_degrees(with_quotes_advice(error), bare_angles)),
    };
    within(running, || with_memory_files(files, work))
}
