//! The program in a terminal, and what Ctrl-C does there, under one rule for every command. Work
//! that can answer with what is done so far stops and does so. Any other work ends with status 1:
//! nothing is printed, and no file is begun. A file is whole or not there, and files that were
//! written before are named. A second Ctrl-C ends the program at once.

use super::colour;
use super::host::{Hold, Host, Kind};
use crate::report::{Reply, remark};
use std::io::{self, Read, Write};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Signals within this time are one: a program around this one (`timeout`) may send its own beside
/// the terminal's.
const ONE_PRESS: Duration = Duration::from_millis(300);

/// The exit status of a program that Ctrl-C ends at once.
const AT_ONCE: i32 = 130;

/// A terminal, or the pipes of a script.
#[derive(Clone, Default)]
pub struct Terminal {
    now: Arc<Mutex<Now>>,
}

/// The state of the command, for Ctrl-C.
#[derive(Default)]
struct Now {
    command: &'static str,
    is_json: bool,
    /// Work that can stop, if it is such.
    work: Option<Work>,
    /// True while the answer is printed.
    is_printed: bool,
    /// Files that are whole.
    written: Vec<String>,
}

/// Work that can stop with what is done so far.
struct Work {
    stop: Arc<AtomicBool>,
    /// The message when it is interrupted.
    stopping: &'static str,
    /// When it was told to.
    told: Option<Instant>,
}

impl Terminal {
    fn now(&self) -> MutexGuard<'_, Now> {
        self.now.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn pressed(&self) {
        let mut now = self.now();
        if now.is_printed {
            std::process::exit(AT_ONCE);
        }
        match &mut now.work {
            None => {
                let (command, is_json, written) =
                    (now.command, now.is_json, now.written.join(", "));
                self.end(command, is_json, &written);
            }
            Some(Work {
                told: Some(told), ..
            }) => {
                if told.elapsed() > ONE_PRESS {
                    std::process::exit(AT_ONCE);
                }
            }
            Some(Work {
                stop,
                stopping,
                told,
            }) => {
                stop.store(true, Ordering::Relaxed);
                *told = Some(Instant::now());
                self.say(
                    Kind::Note,
                    &format!("{stopping}; press Ctrl-C again to end at once"),
                );
            }
        }
    }

    fn end(&self, command: &'static str, is_json: bool, written: &str) -> ! {
        let files = match written {
            "" => "nothing was printed or written".to_owned(),
            written => format!("nothing was printed; written before: {written}"),
        };
        let message = format!("interrupted before there was an answer; {files}");
        self.say(Kind::Error, &message);
        if is_json {
            let reply = Reply::refused(Some(command), "interrupted", message);
            let _ =
                colour::print(&(serde_json::to_string_pretty(&reply).unwrap_or_default() + "\n"));
        }
        std::process::exit(1)
    }
}

impl Host for Terminal {
    fn print(&self, text: &str) -> io::Result<()> {
        // Ctrl-C ends printing at once, as where a reader takes no more of it
        self.now().is_printed = true;
        colour::print(text)
    }

    fn say(&self, kind: Kind, text: &str) {
        match kind {
            Kind::Note => {
                let _ = writeln!(io::stderr().lock(), "{}", remark(text));
            }
            Kind::Warning => colour::say("warning", text),
            Kind::Error => colour::say("error", text),
            // a reader that has gone away is no failure of ours
            Kind::Usage => {
                let _ = write!(anstream::stderr().lock(), "{text}");
            }
            Kind::Help => {
                let _ = write!(anstream::stdout().lock(), "{text}");
            }
        }
    }

    fn begin(&self, command: &'static str, is_json: bool) {
        let mut now = self.now();
        (now.command, now.is_json) = (command, is_json);
        let terminal = self.clone();
        // without a handler Ctrl-C ends the program as it ends any other
        let _ = ctrlc::set_handler(move || terminal.pressed());
    }

    fn input(&self) -> io::Result<String> {
        let mut text = String::new();
        io::stdin().lock().read_to_string(&mut text)?;
        Ok(text)
    }

    fn can_stop(&self, stopping: &'static str, stop: &Arc<AtomicBool>) {
        self.now().work = Some(Work {
            stop: stop.clone(),
            stopping,
            told: None,
        });
    }

    fn cannot_stop(&self) {
        self.now().work = None;
    }

    fn hold(&self) -> Box<dyn Hold + '_> {
        Box::new(self.now())
    }
}

impl Hold for MutexGuard<'_, Now> {
    fn written(&mut self, files: &[&Path]) {
        self.written
            .extend(files.iter().map(|file| file.display().to_string()));
    }
}
