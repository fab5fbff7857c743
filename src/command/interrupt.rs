//! Announces to the `Host` of a command which work of the command can be interrupted.

use super::running::running;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// The message when a search is interrupted.
pub const BEST_SO_FAR: &str = "stopping with the best result so far";

/// A flag for work that can be interrupted. To interrupt it, the `Host` sets the flag and shows the
/// message `stopping`; the work then returns its result so far.
pub fn enable(stopping: &'static str) -> Arc<AtomicBool> {
    let stop = Arc::new(AtomicBool::new(false));
    running().host.can_stop(stopping, &stop);
    stop
}

/// Announces that the following work cannot be interrupted.
pub fn disable() {
    running().host.cannot_stop();
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
