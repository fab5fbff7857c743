//! The commands of the program, with the syntax of its command line.
//!
//! Each command reads its request, calls the library, and answers as text or as one JSON object.
//!
//! ```
//! use longdrive::command::{Host, Kind, run};
//! use std::io;
//! use std::sync::{Arc, Mutex};
//!
//! #[derive(Default)]
//! struct Notes {
//!     answer: Mutex<String>,
//! }
//!
//! impl Host for Notes {
//!     fn print(&self, text: &str) -> io::Result<()> {
//!         self.answer.lock().unwrap().push_str(text);
//!         Ok(())
//!     }
//!     fn say(&self, _: Kind, _: &str) {}
//! }
//!
//! let notes = Arc::new(Notes::default());
//! let status = run(["longdrive", "presets", "--json"].map(Into::into).to_vec(), notes.clone());
//! assert_eq!(status, 0);
//! assert!(notes.answer.lock().unwrap().contains("\"mae494\""));
//! ```

mod args;
mod calibrate;
mod call;
mod chart;
#[cfg(feature = "cli")]
mod colour;
mod compare;
#[cfg(feature = "cli")]
mod completions;
mod date;
mod delivery;
mod described;
mod design;
mod explore;
mod files;
mod fly;
mod gradient;
mod host;
mod interrupt;
mod laws;
mod listener;
#[cfg(feature = "cli")]
mod man;
mod mention;
mod names;
mod optimize;
mod optimum_sensitivity;
mod output;
mod parameters;
mod pareto;
mod picture;
mod plot;
mod plot_drive;
mod presets;
mod progress;
mod ranges;
mod report;
mod reproduce;
mod request;
mod robust;
mod running;
#[cfg(test)]
mod schemas;
mod search;
mod sensitivity;
mod simulate;
mod sweep;
mod swings;
#[cfg(feature = "cli")]
mod terminal;
mod threads;
mod uncertainty;
mod validate;
mod verify;
mod width;
mod wording;

pub use crate::input_file::{MemoryFiles, with_memory_files};
pub use call::{Call, Value, quantity_of, quantity_of_goal, with_degrees};
pub use described::described;
pub use host::{Hold, Host, Kind};
pub use mention::{Argument, Mention, mark_options, with_mentions};
pub use progress::{Progress, SharedProgress, Work};

use crate::{Error, Result};
use args::{Args, Command};
use output::Answer;
use std::ffi::OsString;
use std::io::ErrorKind;
#[cfg(feature = "cli")]
use std::process::ExitCode;
use std::sync::Arc;
#[cfg(feature = "cli")]
use terminal::Terminal;

/// The program: runs the command line of the process in a terminal.
#[cfg(feature = "cli")]
pub fn main() -> ExitCode {
    ExitCode::from(run_in_terminal(std::env::args_os().collect()))
}

/// Runs the program for these arguments, its name first; returns the exit status.
#[cfg(feature = "cli")]
pub fn run_in_terminal(words: Vec<OsString>) -> u8 {
    run(words, Arc::new(Terminal::default()))
}

/// Runs a command line for a host; the first word is the name of the program. Returns the exit
/// status: 0 done, 1 no answer, 2 bad input. The host receives the error message; with `--json` the
/// answer contains it too.
pub fn run(words: Vec<OsString>, host: Arc<dyn Host>) -> u8 {
    run_words(words, host, &[])
}

/// Runs a request of a program that embeds the library, as [`run`] runs a command line.
pub fn call(call: &Call, host: Arc<dyn Host>) -> u8 {
    match call.command_line() {
        Ok(line) => run_words(line.words, host, &line.bare_angles),
        Err(error) => running::within(host, None, &[], || output::complain(&error, "", true)),
    }
}

/// Runs a command line. `bare_angles` are its angles that were given without a unit, rad.
fn run_words(words: Vec<OsString>, host: Arc<dyn Host>, bare_angles: &[f64]) -> u8 {
    let args = match Args::read(&words) {
        Ok(args) => args,
        Err(error) => {
            let command = Command::named_in(words.get(1..).unwrap_or_default());
            let is_json = words.iter().any(|word| word == "--json");
            return running::within(host, None, &words, || {
                output::explain(error, command, is_json)
            });
        }
    };
    let (name, is_json) = (args.command.name(), args.command.is_json());
    host.begin(name, is_json);
    let files = host.files();
    let work = || match answer(&args.command).and_then(Answer::print) {
        Ok(status) => status,
        // a broken pipe, as in `longdrive … | head`, is not an error
        Err(Error::Output(error)) if error.kind() == ErrorKind::BrokenPipe => 0,
        Err(error) => {
            let error = call::with_degrees(wording::with_argument(error), bare_angles);
            output::complain(&error, name, is_json)
        }
    };
    running::within(host, Some(args.shown.clone()), &words, || {
        with_memory_files(files, work)
    })
}

fn answer(command: &Command) -> Result<Answer> {
    match command {
        Command::Simulate(args) => simulate::run(args),
        Command::Gradient(args) => gradient::run(args),
        Command::Compare(args) => compare::run(args),
        Command::Optimize(args) => optimize::run(args),
        Command::OptimumSensitivity(args) => optimum_sensitivity::run(args),
        Command::Design(args) => design::run(args),
        Command::Calibrate(args) => calibrate::run(args),
        Command::Delivery(args) => delivery::run(args),
        Command::Chart(args) => chart::run(args),
        Command::Pareto(args) => pareto::run(args),
        Command::Robust(args) => robust::run(args),
        Command::Explore(args) => explore::run(args),
        Command::Plot(args) => plot::run(args),
        Command::Report(args) => report::run(args),
        Command::Sweep(args) => sweep::run(args),
        Command::Fly(args) => fly::run(args),
        Command::Reproduce(args) => reproduce::run(args),
        Command::Validate(args) => validate::run(args),
        Command::Verify(args) => verify::run(args),
        Command::Sensitivity(args) => sensitivity::run(args),
        Command::Uncertainty(args) => uncertainty::run(args),
        Command::Parameters(args) => parameters::run(args),
        Command::Presets(args) => presets::run(args),
        Command::Laws(args) => laws::run(args),
        #[cfg(feature = "cli")]
        Command::Completions(args) => completions::run(args),
        #[cfg(feature = "cli")]
        Command::Man(args) => man::run(args),
    }
}
