//! The progress of long work, which the `Host` of a command may show.

use std::sync::Arc;

/// The work whose progress a host may show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Work<'a> {
    /// Parts of this name, in plural. Their number follows.
    Parts(&'a str),
    /// This number of searches. The message is the best value so far.
    Searches(u64),
    /// The iterations of one search. The message is the last of them.
    Iterations,
    /// Work without countable parts, with its name.
    Uncounted(&'a str),
}

/// Shows the progress of one piece of work. Worker threads call it too.
pub trait Progress: Send + Sync {
    /// Sets the number of all parts.
    fn set_length(&self, _parts: u64) {}

    /// Sets the number of completed parts.
    fn set_position(&self, _parts: u64) {}

    /// Adds completed parts.
    fn inc(&self, _parts: u64) {}

    /// Sets the message.
    fn set_message(&self, _message: String) {}

    /// Estimates the remaining time from now on: the parts so far were completed earlier.
    fn reset_eta(&self) {}

    /// Runs `work`, which reports to the host, while nothing of the progress is on the screen.
    fn suspend(&self, work: &mut dyn FnMut()) {
        work();
    }

    /// Announces the end of the work.
    fn finish(&self) {}
}

/// No progress is shown.
impl Progress for () {}

/// Progress that several observers report.
pub type SharedProgress = Arc<dyn Progress>;
