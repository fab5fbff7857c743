use super::mention::Mention;
use super::width;
use crate::input_file::MemoryFiles;
use std::io::{self, Write};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Kinds of messages other than the answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MessageKind {
    /// A remark or progress. `--quiet` suppresses it.
    Note,
    /// A warning about the request or the answer.
    Warning,
    /// The reason why the answer, or a part of it, is missing.
    Error,
    /// An error in the arguments, as the argument parser words it, with escape codes for colours.
    Usage,
}

variant_names! {
    /// The word before the text of a message, such as "warning".
    MessageKind {
        Note = "note",
        Warning = "warning",
        Error = "error",
        Usage = "usage",
    }
}

/// The caller of a command: a terminal, or a program that embeds the library. A command calls the
/// host from its own thread; worker threads also report progress to it.
pub trait Host: Send + Sync {
    /// Receives the answer. The texts of `--help` and `--version` are answers too; they contain
    /// escape codes for colours.
    ///
    /// # Errors
    /// If the answer cannot be written.
    fn print(&self, text: &str) -> io::Result<()>;

    /// Receives rows of a table for standard output.
    ///
    /// # Errors
    /// If the rows cannot be written.
    fn write(&self, rows: &[u8]) -> io::Result<()> {
        let mut out = io::stdout();
        out.write_all(rows).and_then(|()| out.flush())
    }

    /// Receives a message other than the answer.
    fn say(&self, kind: MessageKind, text: &str);

    /// The maximum width of an answer as text, in columns.
    fn width(&self) -> usize {
        width::UNKNOWN
    }

    /// True if a person reads the answer on a screen while it is printed.
    fn is_screen(&self) -> bool {
        false
    }

    /// True for a terminal, in which a person can end a command by Ctrl-C.
    fn is_terminal(&self) -> bool {
        false
    }

    /// True if the host receives the details of the computation without `--verbose`.
    fn receives_details(&self) -> bool {
        false
    }

    /// Formats an argument or a command in a message. The default is the syntax of the command
    /// line.
    fn mention(&self, mention: Mention<'_>) -> String {
        mention.in_command_line_syntax()
    }

    /// Announces the start of a command.
    fn begin(&self, _command: &'static str, _is_json: bool) {}

    /// The text of the setup named `-`.
    ///
    /// # Errors
    /// If the setup cannot be read.
    fn input(&self) -> io::Result<String> {
        Err(io::Error::other("no text was given"))
    }

    /// The name of the setup named `-`, for messages and titles.
    fn setup_name(&self) -> &'static str {
        "standard input"
    }

    /// Names of the parameters that the setup named `-` states, if its text also has other values.
    /// They count as settings, like parameters of `--set`: a search varies none of them unless
    /// `--vary` names it. `None` if the text is a setup file as people write it.
    fn stated(&self) -> Option<Vec<String>> {
        None
    }

    /// The input files in memory. A command reads other files from disk.
    fn files(&self) -> MemoryFiles {
        MemoryFiles::new()
    }

    /// True if the host keeps this output file, or the files of this output folder, in memory.
    fn keeps(&self, _name: &Path) -> bool {
        false
    }

    /// Receives the content of an output file that the host keeps in memory.
    fn keep(&self, _name: &Path, _content: Vec<u8>) {}

    /// Announces work that can be interrupted. To interrupt it, the host sets `stop` to true and
    /// shows the message `stopping`; the work then returns its result so far.
    fn can_stop(&self, _stopping: &'static str, _stop: &Arc<AtomicBool>) {}

    /// Announces that the following work cannot be interrupted.
    fn cannot_stop(&self) {}

    /// Called before a file, or several files of one folder, are written. The process must not end
    /// until the returned function is called or dropped. The command calls the function with the
    /// path once the file or folder is complete.
    fn hold(&self) -> Box<dyn FnOnce(&Path) + '_> {
        Box::new(|_| ())
    }

    /// Announces long work, and returns the receiver of its progress. `--quiet` suppresses the
    /// progress.
    fn show_progress(&self, _work: Work<'_>) -> Arc<dyn Progress> {
        Arc::new(())
    }
}

/// A host that discards what it receives.
impl Host for () {
    fn print(&self, _: &str) -> io::Result<()> {
        Ok(())
    }

    fn say(&self, _: MessageKind, _: &str) {}
}

/// The work whose progress a host may show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Work<'a> {
    /// Countable parts with this name, in plural. [`Progress::set_length`] receives their number.
    Parts(&'a str),
    /// Several searches. [`Progress::set_length`] receives their number, and
    /// [`Progress::set_message`] the best value so far.
    Searches,
    /// The iterations of one search. [`Progress::set_message`] receives each iteration as text.
    Iterations,
    /// Work without countable parts, with its name.
    Uncounted(&'a str),
}

/// Shows the progress of one piece of work. Worker threads call these functions too.
pub trait Progress: Send + Sync {
    /// Sets the number of all parts.
    fn set_length(&self, _parts: u64) {}

    /// Sets the number of completed parts.
    fn set_position(&self, _parts: u64) {}

    /// Adds completed parts.
    fn inc(&self, _parts: u64) {}

    /// Sets the message.
    fn set_message(&self, _message: String) {}

    /// Restarts the estimate of the remaining time, because an earlier run completed all parts that
    /// are counted so far.
    fn reset_eta(&self) {}

    /// Announces the end of the work.
    fn finish(&self) {}
}

/// Discards the progress.
impl Progress for () {}
