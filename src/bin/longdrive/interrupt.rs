//! What Ctrl-C does, under one rule for every command. Work that can answer with what is done so far stops and does so. Any other work ends
//! with status 1: nothing is printed, and no file is begun. A file is whole or not there, and files that were written before are named. A second Ctrl-C
//! ends the program at once.

use crate::colour;
use crate::output::{say, tell};
use longdrive::report::Reply;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Signals within this time are one: a program around this one (`timeout`) may send its own beside the terminal's.
const ONE_PRESS: Duration = Duration::from_millis(300);

/// What a search does on Ctrl-C.
pub const BEST_SO_FAR: &str = "stopping with the best result so far";

/// The exit status of a program that Ctrl-C ends at once.
const AT_ONCE: i32 = 130;

/// What Ctrl-C finds.
struct Now {
    command: &'static str,
    is_json: bool,
    /// Work that can stop, if it is such.
    work: Option<Work>,
    /// Whether the answer is being printed.
    is_printed: bool,
    /// Files that are whole.
    written: Vec<String>,
}

/// Work that can stop with what is done so far.
struct Work {
    stop: Arc<AtomicBool>,
    /// What it does then.
    stopping: &'static str,
    /// When it was told to.
    told: Option<Instant>,
}

static NOW: Mutex<Now> =
    Mutex::new(Now { command: "", is_json: false, work: None, is_printed: false, written: Vec::new() });

fn now() -> MutexGuard<'static, Now> {
    NOW.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Answers Ctrl-C from here on.
pub fn begin(command: &'static str, is_json: bool) {
    let mut now = now();
    (now.command, now.is_json) = (command, is_json);
    // without a handler Ctrl-C ends the program as it ends any other
    let _ = ctrlc::set_handler(pressed);
}

/// Becomes true on Ctrl-C, which is answered with a line of what happens then; a second one ends the program at once.
pub fn stops(stopping: &'static str) -> Arc<AtomicBool> {
    let stop = Arc::new(AtomicBool::new(false));
    now().work = Some(Work { stop: stop.clone(), stopping, told: None });
    stop
}

/// What follows cannot stop half-way: Ctrl-C ends it.
pub fn ends() {
    now().work = None;
}

/// The answer is printed from here on: Ctrl-C ends that at once, as where a reader takes no more of it.
pub fn prints() {
    now().is_printed = true;
}

/// Writes a file, or files that belong together, whole: Ctrl-C waits until they are.
pub fn undisturbed<T, E>(files: &[&Path], write: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
    let mut now = now();
    let written = write()?;
    now.written.extend(files.iter().map(|file| file.display().to_string()));
    Ok(written)
}

fn pressed() {
    let mut now = now();
    if now.is_printed {
        std::process::exit(AT_ONCE);
    }
    match &mut now.work {
        None => {
            now.end();
        }
        Some(Work { told: Some(told), .. }) => {
            if told.elapsed() > ONE_PRESS {
                std::process::exit(AT_ONCE);
            }
        }
        Some(Work { stop, stopping, told }) => {
            stop.store(true, Ordering::Relaxed);
            *told = Some(Instant::now());
            tell(&format!("{stopping}; press Ctrl-C again to end at once"));
        }
    }
}

impl Now {
    fn end(&self) -> ! {
        let files = match &self.written[..] {
            [] => "nothing was printed or written".to_owned(),
            written => format!("nothing was printed; written before: {}", written.join(", ")),
        };
        let message = format!("interrupted before there was an answer; {files}");
        colour::say("error", &message);
        if self.is_json {
            say(&Reply::refused(Some(self.command), "interrupted", message));
        }
        std::process::exit(1)
    }
}
