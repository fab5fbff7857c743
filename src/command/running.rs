//! The command that runs on a thread: its program, its `Host`, and its output options.

use super::args::OutputOptions;
use super::host::{Host, MessageKind};
use super::mention::with_mentions_of;
use crate::lock::lock;
use crate::thread_stack::with_innermost;
use crate::units::{Message, System};
use clap::Command;
use std::cell::RefCell;
use std::ffi::OsString;
use std::sync::{Arc, LazyLock, Mutex};

/// A command with its host.
pub struct Running {
    /// The program, with the options of all commands.
    pub program: &'static Command,
    pub host: Arc<dyn Host>,
    /// The name of the command; `None` if the command line names none.
    pub command: Option<&'static str>,
    /// True for an answer in JSON.
    pub is_json: bool,
    pub options: OutputOptions,
    /// The arguments, without the name of the program.
    pub words: Vec<OsString>,
    /// Warnings that were reported before the work of the command began.
    pub early: Mutex<Vec<Message>>,
    /// The other warnings of the answer.
    pub warnings: Mutex<Vec<Message>>,
    /// Parameters that the answer leaves out, with the reasons.
    pub left_out: Mutex<Vec<String>>,
    /// The text of the setup named `-`, after its first use.
    pub input: Mutex<Option<Arc<str>>>,
}

thread_local! {
    /// The commands on this thread; the innermost command is the last. While a command waits for
    /// other threads, this thread may run another command.
    static RUNNING: RefCell<Vec<Arc<Running>>> = const { RefCell::new(vec![]) };
}

/// Runs `work` as a command of this thread.
pub fn within<T>(running: Running, work: impl FnOnce() -> T) -> T {
    with_innermost(&RUNNING, Arc::new(running), work)
}

/// The innermost command of this thread. Threads that a command starts must get its `Running`
/// explicitly.
pub fn running() -> Arc<Running> {
    RUNNING
        .with_borrow(|all| all.last().cloned())
        .unwrap_or_default()
}

/// The state of a thread without a command: a program without options, and a host that discards
/// what it receives.
impl Default for Running {
    fn default() -> Self {
        static NO_COMMAND: LazyLock<Command> = LazyLock::new(|| Command::new("longdrive"));
        Self {
            program: &NO_COMMAND,
            host: Arc::new(()),
            command: None,
            is_json: false,
            options: OutputOptions::default(),
            words: vec![],
            early: Mutex::default(),
            warnings: Mutex::default(),
            left_out: Mutex::default(),
            input: Mutex::default(),
        }
    }
}

impl Running {
    /// The units of the results.
    pub fn system(&self) -> System {
        self.options.units.unwrap_or_default()
    }

    pub fn is_verbose(&self) -> bool {
        self.options.verbose || self.host.receives_details()
    }

    /// A message in the syntax of the host.
    pub fn in_host_syntax(&self, message: &str) -> String {
        with_mentions_of(self.program, message, |mention| self.host.mention(mention))
    }

    /// Reports a remark or progress, unless `--quiet` is given.
    pub fn note(&self, text: &str) {
        if !self.options.quiet {
            self.host.say(MessageKind::Note, &self.in_host_syntax(text));
        }
    }

    /// The text of the setup named `-`, which is read once.
    ///
    /// # Errors
    /// If the setup cannot be read.
    pub fn input(&self) -> std::io::Result<Arc<str>> {
        let mut input = lock(&self.input);
        if input.is_none() {
            *input = Some(self.host.input()?.into());
        }
        Ok(input.clone().unwrap_or_default())
    }
}
