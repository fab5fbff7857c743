//! Long work kept in a file: what searches have found, and how far the others have come.

use super::observer::Snapshot;
use super::solution::Solution;
use crate::atomic_file::{create_beside, folder_of, persist};
use crate::error::{Error, Result};
use crate::external_errors::{read_error_text, write_error_text};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// A search that is kept.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Run {
    /// It has ended.
    Done(Box<Solution>),
    /// It is between two iterations.
    Going(Box<Snapshot>),
}

/// Searches of one question, kept in a file that is whole at every moment: each state is written
/// beside it and put in its place at once.
#[derive(Debug)]
pub struct Checkpoint {
    path: PathBuf,
    content: Mutex<Content>,
}

#[derive(Debug, Serialize, Deserialize)]
struct Content {
    /// What was asked, in whatever words tell one question from another.
    question: String,
    runs: BTreeMap<usize, Run>,
}

impl Checkpoint {
    /// The checkpoint in a file, with what it holds; a new one where there is no such file.
    ///
    /// # Errors
    /// [`Error::Checkpoint`] for a file that cannot be read, is none of this kind, or belongs to
    /// another question.
    pub fn open(path: &Path, question: &str) -> Result<Self> {
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
            None => Content {
                question: question.into(),
                runs: BTreeMap::new(),
            },
        };
        if content.question != question {
            let reason = "it belongs to another question (setup, search or options differ); name \
                          another file, or \
                          remove it to start again";
            return Err(refuse(reason.into()));
        }
        let checkpoint = Self {
            path: path.into(),
            content: Mutex::new(content),
        };
        // what cannot be written is told now, not after hours
        checkpoint.write(&checkpoint.lock(), text.is_some())?;
        Ok(checkpoint)
    }

    /// The search of this number, if it was kept.
    pub fn run(&self, number: usize) -> Option<Run> {
        self.lock().runs.get(&number).cloned()
    }

    /// Searches that have ended.
    pub fn done(&self) -> usize {
        self.lock()
            .runs
            .values()
            .filter(|run| matches!(run, Run::Done(_)))
            .count()
    }

    /// Keeps a search.
    ///
    /// # Errors
    /// [`Error::Checkpoint`] where the file cannot be written.
    pub fn keep(&self, number: usize, run: Run) -> Result<()> {
        let mut content = self.lock();
        content.runs.insert(number, run);
        self.write(&content, true)
    }

    fn write(&self, content: &Content, may_replace: bool) -> Result<()> {
        let written = || -> std::io::Result<()> {
            let mut file = create_beside(&self.path)?;
            file.write_all(&serde_json::to_vec(content)?)?;
            Ok(persist(file.into_temp_path(), &self.path, may_replace)?)
        };
        written().map_err(|error| {
            let folder = folder_of(&self.path);
            let reason = match error.kind() {
                ErrorKind::AlreadyExists => {
                    "another search has begun it at this moment; name another file".into()
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

    fn lock(&self) -> std::sync::MutexGuard<'_, Content> {
        // a search that panicked elsewhere leaves a whole content: it is only ever replaced entry
        // by entry
        self.content
            .lock()
            .unwrap_or_else(std::sync::PoisonError::into_inner)
    }
}
