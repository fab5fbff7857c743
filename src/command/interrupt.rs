//! Announces to the `Host` of a command which work of the command can be interrupted.

use super::running::running;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// The message when a search is interrupted.
pub const BEST_SO_FAR: &str = "stopping with the best result so far";

/// Work that can be interrupted until this value is dropped.
#[must_use]
pub struct InterruptibleWork {
    /// The flag that the `Host` sets to interrupt the work.
    pub stop: Arc<AtomicBool>,
}

/// Announces work that can be interrupted. To interrupt it, the `Host` sets the flag and shows the
/// message `stopping`; the work then returns its result so far.
pub fn enable(stopping: &'static str) -> InterruptibleWork {
    let stop = Arc::new(AtomicBool::new(false));
    running().host.can_stop(stopping, &stop);
    InterruptibleWork { stop }
}

impl Drop for InterruptibleWork {
    /// Announces that the following work cannot be interrupted.
    fn drop(&mut self) {
        running().host.cannot_stop();
    }
}

/// Calls `write`, which writes one file or several files that belong together. An interruption does
/// not end the process before `write` returns.
pub fn undisturbed<T, E>(path: &Path, write: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
    let running = running();
    let hold = running.host.hold();
    let written = write()?;
    hold(path);
    Ok(written)
}
