use super::mention::Mention;
use indicatif::ProgressBar;
use std::io;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Kinds of messages beside the answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A remark or progress; none with `--quiet`.
    Note,
    /// A warning about the request or the answer.
    Warning,
    /// Why there is no answer.
    Error,
    /// An error in the arguments, from the argument parser, with colours.
    Usage,
    /// The help that was asked for, or the version, with its colours.
    Help,
}

/// The caller of a command: a terminal, or a program that has loaded the library. A command calls
/// it from its own thread; progress also comes from other threads.
pub trait Host: Send + Sync {
    /// Takes the answer.
    ///
    /// # Errors
    /// Where it cannot be written.
    fn print(&self, text: &str) -> io::Result<()>;

    /// Takes a message beside the answer.
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
    /// If nothing can be read.
    fn input(&self) -> io::Result<String> {
        Err(io::Error::other("no text was given"))
    }

    /// Announces work that can be interrupted: it returns its result so far once `stop` is true.
    /// `stopping` is the message then.
    fn can_stop(&self, _stopping: &'static str, _stop: &Arc<AtomicBool>) {}

    /// The following work cannot be interrupted.
    fn cannot_stop(&self) {}

    /// Locks the end of the process while files that belong together are written.
    fn hold(&self) -> Box<dyn Hold + '_> {
        Box::new(())
    }

    /// Shows a bar, or how long work without parts takes, to whoever waits; `bar` is drawn on
    /// standard error where that is a terminal.
    fn shows(&self, bar: ProgressBar) -> ProgressBar {
        bar
    }
}

/// The lock while files are written.
pub trait Hold {
    /// Tells that these files are whole.
    fn written(&mut self, _files: &[&Path]) {}
}

impl Hold for () {}
