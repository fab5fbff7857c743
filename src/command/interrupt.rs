//! What a command says to whom it is run for about being stopped.

use super::running::running;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// The message of an interrupted search.
pub const BEST_SO_FAR: &str = "stopping with the best result so far";

/// Becomes true when the work that follows is to stop with what is done so far.
pub fn stops(stopping: &'static str) -> Arc<AtomicBool> {
    let stop = Arc::new(AtomicBool::new(false));
    running().host.can_stop(stopping, &stop);
    stop
}

/// The following work cannot be interrupted.
pub fn ends() {
    running().host.cannot_stop();
}

/// Writes a file, or files that belong together, whole.
pub fn undisturbed<T, E>(files: &[&Path], write: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
    let running = running();
    let mut hold = running.host.hold();
    let written = write()?;
    hold.written(files);
    Ok(written)
}
