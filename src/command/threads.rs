//! The threads of a command.

use crate::batch::HAS_THREADS;
use crate::{Error, Result};

/// Refuses several threads on a processor that has one: WebAssembly.
///
/// # Errors
/// [`Error::Unreadable`], which names the option.
pub fn refuse_threads(threads: usize) -> Result<()> {
    if HAS_THREADS || threads <= 1 {
        return Ok(());
    }
    Err(Error::Unreadable {
        name: format!("`threads {threads}`"),
        source: "there is one thread here; leave it out".into(),
    })
}
