//! What follows a search from outside: shown its iterations, able to stop it, and given its state
//! to keep.

use super::domain::Domain;
use super::solution::Iteration;
use super::sqp::Progress;
use crate::error::Result;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Follows a search: is shown its iterations, may stop it, and may store its state.
pub struct Observer {
    /// Is shown every iteration.
    pub iteration: Box<dyn FnMut(&Iteration)>,
    /// Ends the search, with the best point so far, once it is true: before the next evaluation, or
    /// within one that [looks at it](super::Problem::evaluate).
    pub interrupt: Arc<AtomicBool>,
    /// Is given the search after every iteration, to keep it.
    pub keep: Option<Box<Keep>>,
    /// A search that was kept, to go on with.
    pub resume: Option<Snapshot>,
}

/// Keeps a search, or says why it cannot.
pub type Keep = dyn FnMut(&Snapshot) -> Result<()>;

impl Observer {
    /// Shows every iteration.
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
            keep: None,
            resume: None,
        }
    }
}

/// A search between two iterations: going on from it ends as the search itself would have, bit by
/// bit.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Snapshot {
    pub(super) iterations: u64,
    pub(super) progress: Progress,
}

impl Snapshot {
    /// Iterations done.
    pub fn iterations(&self) -> u64 {
        self.iterations
    }

    /// Whether it has the shape of a problem over this domain.
    pub(super) fn is_of(&self, domain: &Domain) -> bool {
        let (n, m) = (domain.variables.dimension(), domain.constraints.dimension());
        self.progress.is_of(n, m)
    }
}
