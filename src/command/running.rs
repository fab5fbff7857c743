//! The command of a thread: its host, and its options about output.

use super::args::Shown;
use super::host::{Host, Kind};
use super::mention::with_mentions;
use super::terminal::Terminal;
use crate::units::{Message, System};
use std::cell::RefCell;
use std::ffi::OsString;
use std::sync::{Arc, Mutex, PoisonError};

/// A command with its host.
pub struct Running {
    pub host: Arc<dyn Host>,
    shown: Option<Shown>,
    /// The arguments, without the name of the program.
    words: Vec<OsString>,
    /// Warnings about what was read and chosen before the command's own work.
    early: Mutex<Vec<Message>>,
    /// The text of the setup that is named `-`, once it was read.
    input: Mutex<Option<Arc<str>>>,
}

thread_local! {
    /// The commands that are run on this thread: one that waits for other threads' work may have
    /// another run meanwhile.
    static RUNNING: RefCell<Vec<Arc<Running>>> = const { RefCell::new(vec![]) };
}

/// Removes the command from its thread, also after a panic.
struct Ended;

impl Drop for Ended {
    fn drop(&mut self) {
        RUNNING.with_borrow_mut(|all| all.pop());
    }
}

/// Does the work of a command.
pub fn within<T>(
    host: Arc<dyn Host>,
    shown: Option<Shown>,
    words: &[OsString],
    work: impl FnOnce() -> T,
) -> T {
    let words = words.get(1..).unwrap_or_default().to_vec();
    RUNNING.with_borrow_mut(|all| all.push(Arc::new(Running::of(host, shown, words))));
    let _ended = Ended;
    work()
}

/// The command on this thread; a thread that runs none speaks to the terminal. What runs on threads
/// that the work of a command makes takes it along.
pub fn running() -> Arc<Running> {
    RUNNING
        .with_borrow(|all| all.last().cloned())
        .unwrap_or_else(|| Arc::new(Running::of(Arc::new(Terminal::default()), None, vec![])))
}

impl Running {
    fn of(host: Arc<dyn Host>, shown: Option<Shown>, words: Vec<OsString>) -> Self {
        Self {
            host,
            shown,
            words,
            early: Mutex::default(),
            input: Mutex::default(),
        }
    }

    /// The units of `--units`.
    pub fn stated_system(&self) -> Option<System> {
        self.shown
            .as_ref()
            .and_then(|shown| shown.units)
            .map(System::from)
    }

    /// The units that results are shown in.
    pub fn system(&self) -> System {
        self.stated_system().unwrap_or_default()
    }

    pub fn is_quiet(&self) -> bool {
        self.shown.as_ref().is_some_and(|shown| shown.quiet)
    }

    /// The arguments.
    pub fn words(&self) -> &[OsString] {
        &self.words
    }

    /// A remark or progress, unless --quiet is given.
    pub fn tell(&self, text: &str) {
        if !self.is_quiet() {
            self.host.say(
                Kind::Note,
                &with_mentions(text, |mention| self.host.mention(mention)),
            );
        }
    }

    /// Keeps a warning for the answer, which has it before its own.
    pub fn keep(&self, warning: Message) {
        self.early
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .push(warning);
    }

    /// The kept warnings.
    pub fn kept(&self) -> Vec<Message> {
        self.early
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .clone()
    }

    /// The text of the setup that is named `-`, read once.
    ///
    /// # Errors
    /// If nothing can be read.
    pub fn input(&self) -> std::io::Result<Arc<str>> {
        let mut input = self.input.lock().unwrap_or_else(PoisonError::into_inner);
        if input.is_none() {
            *input = Some(self.host.input()?.into());
        }
        Ok(input.clone().unwrap_or_default())
    }
}
