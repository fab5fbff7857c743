//! Checkpoint file of several searches: the results of the searches that have ended, and snapshots
//! of the unfinished searches.

use super::observer::Snapshot;
use super::solution::Solution;
use crate::atomic_file::{create_beside, folder_of, persist};
use crate::error::{Error, Result};
use crate::external_errors::{read_error_text, write_error_text};
use crate::lock::lock;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// State of one search in a checkpoint.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SavedSearch {
    /// The search has ended.
    Done(Box<Solution>),
    /// The search has not ended: its state between two iterations.
    #[serde(rename = "going")]
    Unfinished(Box<Snapshot>),
}

/// Checkpoint file of the searches of one problem. Each save writes all states to a temporary file,
/// which then replaces the checkpoint. The checkpoint is therefore complete at any time.
#[derive(Debug)]
pub struct Checkpoint {
    path: PathBuf,
    content: Mutex<CheckpointContent>,
}

#[derive(Debug, Serialize, Deserialize)]
struct CheckpointContent {
    /// Text that identifies the problem.
    #[serde(rename = "question")]
    problem: String,
    #[serde(rename = "runs")]
    searches: BTreeMap<usize, SavedSearch>,
}

impl Checkpoint {
    /// Opens a checkpoint file, or creates it if it does not exist. `problem` identifies the
    /// problem: a text that is different for every problem.
    ///
    /// # Errors
    /// [`Error::Checkpoint`] if the file cannot be read or written, is not a checkpoint, or belongs
    /// to another problem.
    pub fn open(path: &Path, problem: &str) -> Result<Self> {
        let refuse = |reason: String| Error::Checkpoint {
            file: path.display().to_string(),
            reason,
        };
        if std::fs::metadata(path).is_ok_and(|found| !found.is_file()) {
            return Err(refuse(
                "it is not a file; name a file that does not exist yet, or the checkpoint of an \
                 earlier search"
                    .into(),
            ));
        }
        let text = match std::fs::read_to_string(path) {
            Ok(text) => Some(text),
            Err(error) if error.kind() == ErrorKind::NotFound => None,
            Err(error) => return Err(refuse(read_error_text(&error))),
        };
        let content = match &text {
            Some(text) => serde_json::from_str(text).map_err(|_| {
                refuse(
                    "it is not a checkpoint of a search, or it is damaged; name another file"
                        .into(),
                )
            })?,
            None => CheckpointContent {
                problem: problem.into(),
                searches: BTreeMap::new(),
            },
        };
        if content.problem != problem {
            let reason = "its setup, search or options differ from those of this search; name \
                          another file, or remove this one to start again";
            return Err(refuse(reason.into()));
        }
        let checkpoint = Self {
            path: path.into(),
            content: Mutex::new(content),
        };
        // if the file cannot be written, fail now and not after hours of work
        checkpoint.write(&lock(&checkpoint.content), text.is_some())?;
        Ok(checkpoint)
    }

    /// Saved state of search `number`; `None` if nothing was saved.
    pub fn saved(&self, number: usize) -> Option<SavedSearch> {
        lock(&self.content).searches.get(&number).cloned()
    }

    /// Saves `search`, the state of search `number`.
    ///
    /// # Errors
    /// [`Error::Checkpoint`] if the file cannot be written.
    pub fn save(&self, number: usize, search: SavedSearch) -> Result<()> {
        let mut content = lock(&self.content);
        content.searches.insert(number, search);
        self.write(&content, true)
    }

    fn write(&self, content: &CheckpointContent, may_replace: bool) -> Result<()> {
        let written = || -> std::io::Result<()> {
            let mut file = create_beside(&self.path)?;
            file.write_all(&serde_json::to_vec(content)?)?;
            Ok(persist(file.into_temp_path(), &self.path, may_replace)?)
        };
        written().map_err(|error| {
            let folder = folder_of(&self.path);
            let reason = match error.kind() {
                ErrorKind::AlreadyExists => {
                    "another search has just created this file; name another file".into()
                }
                _ if !folder.is_dir() => format!(
                    "it cannot be written: there is no folder '{}'",
                    folder.display()
                ),
                _ => format!(
                    "it cannot be written ({}); name another place",
                    write_error_text(&error)
                ),
            };
            Error::Checkpoint {
                file: self.path.display().to_string(),
                reason,
            }
        })
    }
}
