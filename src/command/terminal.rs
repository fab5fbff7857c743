//! The program in a terminal, with one rule for Ctrl-C in every command:
//!
//! - Work that can return a partial result stops and returns it.
//! - Other work ends with status 1: it prints no answer and begins no file.
//! - Files are complete or absent. A message names the files that were completed before.
//! - A second Ctrl-C ends the program at once.

use super::host::{Host, MessageKind, Progress, Work};
use super::{colour, width};
use crate::lock::lock;
use crate::report::{Reply, remark};
use indicatif::{ProgressBar, ProgressStyle};
use std::io::{self, IsTerminal, Read, Write};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// Signals within this time count as one: a wrapper such as `timeout` may repeat the signal of the
/// terminal.
const ONE_PRESS: Duration = Duration::from_millis(300);

/// The exit status of a program that Ctrl-C ends at once.
const AT_ONCE: i32 = 130;

/// The host of the program: a terminal, or the pipes of a script.
#[derive(Clone, Default)]
pub struct Terminal {
    now: Arc<Mutex<Now>>,
    /// The last progress bar. It is hidden while a message is printed.
    bar: Arc<Mutex<Option<ProgressBar>>>,
}

/// The state of the command that the handler of Ctrl-C reads.
#[derive(Default)]
struct Now {
    command: &'static str,
    is_json: bool,
    /// The current work, if it can be interrupted.
    work: Option<Interruptible>,
    /// True once the program has begun to print the answer.
    is_printed: bool,
    /// Completed files.
    written: Vec<String>,
}

/// Work that can stop and return its result so far.
struct Interruptible {
    stop: Arc<AtomicBool>,
    /// The message to show when the work is interrupted.
    stopping: &'static str,
    /// The time of the first Ctrl-C; `None` before it.
    pressed_at: Option<Instant>,
}

impl Terminal {
    fn pressed(&self) {
        let mut now = lock(&self.now);
        if now.is_printed {
            std::process::exit(AT_ONCE);
        }
        match &mut now.work {
            None => {
                let (command, is_json, written) =
                    (now.command, now.is_json, now.written.join(", "));
                self.end(command, is_json, &written);
            }
            Some(Interruptible {
                pressed_at: Some(pressed_at),
                ..
            }) => {
                if pressed_at.elapsed() > ONE_PRESS {
                    std::process::exit(AT_ONCE);
                }
            }
            Some(Interruptible {
                stop,
                stopping,
                pressed_at,
            }) => {
                stop.store(true, Ordering::Relaxed);
                *pressed_at = Some(Instant::now());
                self.say(
                    MessageKind::Note,
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
        self.say(MessageKind::Error, &message);
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
        // during printing, Ctrl-C ends the program at once
        lock(&self.now).is_printed = true;
        colour::print(text)
    }

    fn is_screen(&self) -> bool {
        io::stdout().is_terminal()
    }

    fn is_terminal(&self) -> bool {
        true
    }

    fn width(&self) -> usize {
        width::of_answers()
    }

    fn say(&self, kind: MessageKind, text: &str) {
        let write = || match kind {
            MessageKind::Note => {
                let _ = writeln!(
                    io::stderr().lock(),
                    "{}",
                    remark(text, width::of_messages())
                );
            }
            MessageKind::Warning | MessageKind::Error => colour::say(kind, text),
            // ignore an error, such as a broken pipe
            MessageKind::Usage => {
                let _ = write!(anstream::stderr().lock(), "{text}");
            }
        };
        let bar = lock(&self.bar).clone();
        match bar {
            Some(bar) => bar.suspend(write),
            None => write(),
        }
    }

    fn begin(&self, command: &'static str, is_json: bool) {
        let mut now = lock(&self.now);
        (now.command, now.is_json) = (command, is_json);
        let terminal = self.clone();
        // if no handler can be set, Ctrl-C ends the program in the default way
        let _ = ctrlc::set_handler(move || terminal.pressed());
    }

    fn input(&self) -> io::Result<String> {
        let mut text = String::new();
        io::stdin().lock().read_to_string(&mut text)?;
        Ok(text)
    }

    fn can_stop(&self, stopping: &'static str, stop: &Arc<AtomicBool>) {
        lock(&self.now).work = Some(Interruptible {
            stop: stop.clone(),
            stopping,
            pressed_at: None,
        });
    }

    fn cannot_stop(&self) {
        lock(&self.now).work = None;
    }

    fn hold(&self) -> Box<dyn FnOnce(&Path) + '_> {
        let mut now = lock(&self.now);
        Box::new(move |path| now.written.push(path.display().to_string()))
    }

    fn show_progress(&self, work: Work<'_>) -> Arc<dyn Progress> {
        let bar = |parts, template: &str| {
            let style = ProgressStyle::with_template(template);
            let style = style.unwrap_or_else(|_| ProgressStyle::default_bar());
            ProgressBar::new(parts).with_style(style)
        };
        // `ProgressBar` draws on standard error, and only on a terminal
        let bar = match work {
            Work::Parts(of) => bar(0, &format!("{{bar:40}} {{pos}}/{{len}} {of}, {{eta}} left")),
            Work::Searches => bar(0, "{bar:40} {pos}/{len} searches, {eta} left, best {msg}"),
            Work::Iterations => bar(0, "{msg}"),
            Work::Uncounted(doing) => {
                let spinner = ProgressBar::new_spinner().with_message(doing.to_owned());
                spinner.enable_steady_tick(Duration::from_millis(200));
                spinner
            }
        };
        *lock(&self.bar) = Some(bar.clone());
        Arc::new(bar)
    }
}

impl Progress for ProgressBar {
    fn set_length(&self, parts: u64) {
        Self::set_length(self, parts);
    }

    fn set_position(&self, parts: u64) {
        Self::set_position(self, parts);
    }

    fn inc(&self, parts: u64) {
        Self::inc(self, parts);
    }

    fn set_message(&self, message: String) {
        Self::set_message(self, message);
    }

    fn reset_eta(&self) {
        Self::reset_eta(self);
    }

    fn finish(&self) {
        self.finish_and_clear();
    }
}
