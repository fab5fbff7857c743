//! Observer of a search: receives its iterations and snapshots, and can interrupt it.

use super::iteration::Iteration;
use super::sqp::SearchProgress;
use crate::error::Result;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Receives the iterations of a search; can interrupt, save and resume the search.
pub struct Observer {
    /// Called at the start (iteration 0) and after every iteration.
    pub iteration: Box<dyn FnMut(&Iteration)>,
    /// Interrupt flag: once true, the search ends with the best point so far. It ends before the
    /// next evaluation, or during an evaluation that [checks the flag](super::Problem::evaluate).
    pub interrupt: Arc<AtomicBool>,
    /// Called after every iteration with a snapshot to save.
    pub save: Option<Box<SaveSnapshot>>,
    /// Snapshot to resume from.
    pub resume: Option<Snapshot>,
    /// True if every iteration passed to the observer contains the quadratic model at the iterate.
    /// This costs a copy of the search's state and the solution of a quadratic program.
    pub models: bool,
}

/// Saves a snapshot.
pub type SaveSnapshot = dyn FnMut(&Snapshot) -> Result<()>;

impl Observer {
    /// Observer that passes every iteration to a closure.
    pub fn showing(iteration: impl FnMut(&Iteration) + 'static) -> Self {
        Self {
            iteration: Box::new(iteration),
            ..Self::default()
        }
    }
}

impl Default for Observer {
    fn default() -> Self {
        Self {
            iteration: Box::new(|_| ()),
            interrupt: Arc::default(),
            save: None,
            resume: None,
            models: false,
        }
    }
}

/// Complete state of a search between two iterations. A search resumed from it gives the same bits
/// as an uninterrupted search.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Snapshot {
    /// Number of completed iterations.
    pub iterations: u64,
    pub(super) progress: SearchProgress,
}
