//! Long work kept in a file: what searches have found, and how far the others have come.

use super::observer::Snapshot;
use super::solution::Solution;
use crate::error::{Error, Result};
use crate::foreign::{of_io, of_write};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::io::Write;
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

/// Searches of one question, kept in a file that is whole at every moment: each state is written beside it and put in
/// its place at once.
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
    /// [`Error::Checkpoint`] for a file that cannot be read, is none of this kind, or belongs to another question.
    pub fn open(path: &Path, question: &str) -> Result<Self> {
        let refuse = |reason: String| Error::Checkpoint { file: path.display().to_string(), reason };
        if std::fs::metadata(path).is_ok_and(|found| !found.is_file()) {
            return Err(refuse(
                "it is not a file; name a file that does not exist yet, or the checkpoint of an earlier search".into(),
            ));
        }
        let content = match std::fs::read_to_string(path) {
            Ok(text) => serde_json::from_str(&text).map_err(|_| {
                refuse("it is not a checkpoint of a search, or it is damaged; name another file".into())
            })?,
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
                Content { question: question.into(), runs: BTreeMap::new() }
            }
            Err(error) => return Err(refuse(of_io(&error))),
        };
        if content.question != question {
            let reason = "it belongs to another question (setup, search or options differ); name another file, or \
                          remove it to start again";
            return Err(refuse(reason.into()));
        }
        let checkpoint = Self { path: path.into(), content: Mutex::new(content) };
        // what cannot be written is told now, not after hours
        checkpoint.write(&checkpoint.lock())?;
        Ok(checkpoint)
    }

    /// The search of this number, if it was kept.
    pub fn run(&self, number: usize) -> Option<Run> {
        self.lock().runs.get(&number).cloned()
    }

    /// Searches that have ended.
    pub fn done(&self) -> usize {
        self.lock().runs.values().filter(|run| matches!(run, Run::Done(_))).count()
    }

    /// Keeps a search.
    ///
    /// # Errors
    /// [`Error::Checkpoint`] where the file cannot be written.
    pub fn keep(&self, number: usize, run: Run) -> Result<()> {
        let mut content = self.lock();
        content.runs.insert(number, run);
        self.write(&content)
    }

    fn write(&self, content: &Content) -> Result<()> {
        let folder = self.path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let written = || -> std::io::Result<()> {
            // the name of this file is nobody's business
            let beside = tempfile::NamedTempFile::new_in(folder);
            let mut beside = beside.map_err(|error| std::io::Error::from(error.kind()))?;
            beside.write_all(&serde_json::to_vec(content)?)?;
            beside.persist(&self.path)?;
            Ok(())
        };
        written().map_err(|error| Error::Checkpoint {
            file: self.path.display().to_string(),
            reason: match folder.is_dir() {
                true => format!("it cannot be written ({}); name another place", of_write(&error)),
                false => format!("it cannot be written: there is no folder '{}'", folder.display()),
            },
        })
    }

    fn lock(&self) -> std::sync::MutexGuard<'_, Content> {
        // a search that panicked elsewhere leaves a whole content: it is only ever replaced entry by entry
        self.content.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
    }
}
