use super::wording::Mention;
use indicatif::ProgressBar;
use std::io;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// What a command says beside its answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A remark or progress; none with `--quiet`.
    Note,
    /// A warning about the question or the answer.
    Warning,
    /// Why there is no answer.
    Error,
    /// What the arguments lack, as the reader of arguments says it, with its colours.
    Usage,
    /// The help that was asked for, or the version, with its colours.
    Help,
}

/// Whom a command is run for: a terminal, or a program that has loaded the library. A command calls
/// it from the thread that runs it, and with progress from others.
pub trait Host: Send + Sync {
    /// Takes the answer.
    ///
    /// # Errors
    /// Where it cannot be written.
    fn print(&self, text: &str) -> io::Result<()>;

    /// Takes what is said beside the answer.
    fn say(&self, kind: Kind, text: &str);

    /// The words for an argument or a command in a message: those of the command line.
    fn mention(&self, mention: Mention<'_>) -> String {
        mention.in_words_of_the_program()
    }

    /// Begins a command.
    fn begin(&self, _command: &'static str, _is_json: bool) {}

    /// The setup that is named `-`.
    ///
    /// # Errors
    /// Where there is none to be read.
    fn input(&self) -> io::Result<String> {
        Err(io::Error::other("no text was given"))
    }

    /// Work begins that ends, with what is done so far, once `stop` is true; `stopping` says what
    /// it does then.
    fn can_stop(&self, _stopping: &'static str, _stop: &Arc<AtomicBool>) {}

    /// What follows cannot be stopped half-way.
    fn cannot_stop(&self) {}

    /// Files that belong together are written while this is held: whoever can end the process waits
    /// until then.
    fn hold(&self) -> Box<dyn Hold + '_> {
        Box::new(())
    }

    /// Shows a bar, or how long work without parts takes, to whoever waits; `bar` is drawn on
    /// standard error where that is a terminal.
    fn shows(&self, bar: ProgressBar) -> ProgressBar {
        bar
    }
}

/// What is held while files are written.
pub trait Hold {
    /// Tells that these files are whole.
    fn written(&mut self, _files: &[&Path]) {}
}

impl Hold for () {}
