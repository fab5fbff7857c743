use super::footer::{Footer, Manifest, PART, Part};
use super::hash::Hash;
use super::question::Question;
use super::share::{file_name, rows_of};
use crate::atomic_file::create_beside;
use crate::batch::{Batch, Block, Points, Run};
use crate::error::{Error, Result};
use crate::report::{ParquetGroup, PlacedGroup, SweepParquet};
use crate::statistics::{Bins, Sought, Summarized};
use std::fs::{self, File};
use std::io::{self, Write};
use std::ops::Range;
use std::path::Path;

/// A sweep that is divided into parts.
pub struct Dataset {
    batch: Batch,
    summarized: Summarized,
    question: Question,
    table: SweepParquet,
}

/// What became of a part that was to be written.
#[derive(Clone, Debug, PartialEq)]
pub enum Written {
    /// It was computed, and its file is in its place.
    New(Manifest),
    /// It was there already, whole, and stays.
    There(Manifest),
    /// It was stopped, and nothing is left of it.
    Stopped,
}

impl Dataset {
    /// The sweep of a batch over all of these points, in so many parts. The footer of each has
    /// these histograms and best rows.
    ///
    /// # Errors
    /// [`Error::Together`] for more parts than there are blocks of rows, and as
    /// [`Summarized::new`].
    pub fn new(
        batch: Batch,
        points: &dyn Points,
        parts: u64,
        bins: &[Bins],
        sought: &[Sought],
    ) -> Result<Self> {
        rows_of(parts, parts, points.rows())?;
        let summarized = Summarized::new(&batch, bins, sought)?;
        let question = Question::new(&batch, points, &summarized, parts);
        let table = SweepParquet::new(&batch, &question.text())?;
        Ok(Self {
            batch,
            summarized,
            question,
            table,
        })
    }

    /// What tells it from any other.
    pub fn question(&self) -> &Question {
        &self.question
    }

    /// The rows of a part, from 0.
    ///
    /// # Errors
    /// [`Error::Together`] for a part that is not from 1 to their number.
    pub fn rows_of(&self, part: u64) -> Result<Range<u64>> {
        rows_of(part, self.question.parts, self.question.rows)
    }

    /// Writes a part into a folder that exists, unless it is there already: beside its place, and
    /// there once it is whole and safe on the disk. Of `run` the threads and the stop count.
    /// `progress` is told how many rows are computed.
    ///
    /// # Errors
    /// [`Error::Results`] for a file of another question in the folder or of none in its place,
    /// which only `overwrite` replaces, and for what cannot be written; as
    /// [`rows_of`](Self::rows_of) and [`Batch::run`].
    pub fn write(
        &self,
        points: &mut dyn Points,
        part: u64,
        folder: &Path,
        run: &Run<'_>,
        overwrite: bool,
        mut progress: impl FnMut(u64),
    ) -> Result<Written> {
        let rows = self.rows_of(part)?;
        let name = file_name(part, self.question.parts);
        let path = folder.join(&name);
        let results = |reason: String| Error::Results {
            file: path.display().to_string(),
            reason,
        };
        if !overwrite && path.exists() {
            return self.found(part, &path).map(Written::There).map_err(results);
        }
        self.refuse_strangers(folder, &path)?;
        let unwritten = |error: io::Error| {
            let why = Error::why_unwritten(&error);
            results(format!(
                "it cannot be written ({why}); nothing of it is left. Put that right, then ask for \
                 part {part} again"
            ))
        };
        let mut file = Unfinished::new(create_beside(&path).map_err(unwritten)?);
        file.write(&self.table.head()).map_err(unwritten)?;
        let mut summary = self.summarized.none();
        let (mut waiting, mut placed, mut done) = (vec![], vec![], 0);
        let run = Run {
            first_row: rows.start,
            end_row: Some(rows.end),
            ..*run
        };
        let end = self.batch.run(
            points,
            &run,
            |block| (self.summarized.of(&block), block),
            |(of_block, block)| {
                summary.merge(&of_block);
                done += block.rows() as u64;
                waiting.push(block);
                if waiting.len() == self.table.blocks_of_group() {
                    self.write_group(&mut file, &mut waiting, &mut placed, unwritten)?;
                }
                progress(done);
                Ok(())
            },
        )?;
        if end < rows.end {
            return Ok(Written::Stopped);
        }
        if !waiting.is_empty() {
            self.write_group(&mut file, &mut waiting, &mut placed, unwritten)?;
        }
        let part = Part {
            part,
            parts: self.question.parts,
            first_row: rows.start,
            rows: done,
            question: self.question.hash(),
            instructions: self.question.instructions.clone(),
            data: file.hash.clone().hex(),
            summary,
        };
        // names are texts, and numbers finite or null
        let note = serde_json::to_string(&part).unwrap_or_default();
        file.write(&self.table.foot_with(&placed, &[(PART, note)])?)
            .map_err(unwritten)?;
        let (bytes, sha256) = file.put(&path).map_err(unwritten)?;
        Ok(Written::New(Manifest {
            file: name,
            bytes,
            sha256,
            part,
        }))
    }

    /// Writes the blocks that wait as a row group.
    fn write_group(
        &self,
        file: &mut Unfinished,
        waiting: &mut Vec<Block>,
        placed: &mut Vec<PlacedGroup>,
        unwritten: impl Fn(io::Error) -> Error,
    ) -> Result<()> {
        let ParquetGroup { bytes, metadata } = self.table.group(&std::mem::take(waiting))?;
        placed.push(self.table.place(&metadata, file.bytes, placed.len())?);
        file.write(&bytes).map_err(unwritten)
    }

    /// The part that is in its place, if it is this one; or why it is not.
    fn found(&self, part: u64, path: &Path) -> Result<Manifest, String> {
        let advice = "take another folder, or replace it with `overwrite`";
        let footer = Footer::read(path).map_err(|reason| format!("{reason}; {advice}"))?;
        if let Some(difference) = self.question.difference(&footer.question) {
            return Err(format!(
                "it is there, of another sweep ({difference}); {advice}"
            ));
        }
        if footer.part.part != part {
            return Err(format!(
                "it is there, and is part {} under a wrong name; {advice}",
                footer.part.part
            ));
        }
        footer
            .manifest(path)
            .map_err(|reason| format!("{reason}; {advice}"))
    }

    /// Refuses a folder with a part of another sweep. One file is looked at, so that it takes no
    /// time; a check looks at all.
    fn refuse_strangers(&self, folder: &Path, place: &Path) -> Result<()> {
        let entries = fs::read_dir(folder).map_err(|error| Error::Results {
            file: folder.display().to_string(),
            reason: crate::external_errors::read_error_text(&error),
        })?;
        let is_part = |path: &Path| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            name.starts_with("part-") && name.ends_with(".parquet") && path != place
        };
        let other = entries
            .flatten()
            .map(|entry| entry.path())
            .find(|path| is_part(path));
        let Some((other, footer)) =
            other.and_then(|path| Some((path.clone(), Footer::read(&path).ok()?)))
        else {
            return Ok(());
        };
        match self.question.difference(&footer.question) {
            None => Ok(()),
            Some(difference) => Err(Error::Results {
                file: other.display().to_string(),
                reason: format!(
                    "it belongs to another sweep ({difference}), and a folder holds the parts of \
                     one; take another folder, or the same question"
                ),
            }),
        }
    }
}

/// A file that is not in its place yet.
struct Unfinished {
    file: tempfile::NamedTempFile,
    hash: Hash,
    bytes: u64,
}

impl Unfinished {
    fn new(file: tempfile::NamedTempFile) -> Self {
        Self {
            file,
            hash: Hash::default(),
            bytes: 0,
        }
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.file.write_all(bytes)?;
        self.hash.add(bytes);
        self.bytes += bytes.len() as u64;
        Ok(())
    }

    /// Puts it in its place, where it is also after a loss of power; its length and SHA-256.
    fn put(self, path: &Path) -> io::Result<(u64, String)> {
        self.file.as_file().sync_all()?;
        self.file.persist(path)?;
        #[cfg(unix)]
        File::open(crate::atomic_file::folder_of(path))?.sync_all()?;
        Ok((self.bytes, self.hash.hex()))
    }
}
