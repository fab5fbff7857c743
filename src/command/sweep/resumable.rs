use super::journal::{Journal, JournalHeader, WrittenRows, cut, with_suffix};
use super::rows::{FormattedRows, RowFormatter};
use crate::atomic_file::persist;
#[cfg(feature = "parquet")]
use crate::batch::Block;
use crate::command::files::{exists, refused, unwritable};
use crate::command::output::note;
use crate::external_errors::write_error_text;
#[cfg(feature = "parquet")]
use crate::report::{PARQUET_MAGIC, ParquetGroup, RowGroups, SweepParquet};
use crate::units::counted;
use crate::{Error, Result};
#[cfg(feature = "parquet")]
use std::fmt::Display;
use std::fs::{File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use tempfile::TempPath;

/// Minimum time between two lines of the journal.
const OFTEN: Duration = Duration::from_secs(1);
/// Minimum number of blocks of rows between two lines of the journal.
const BLOCKS: u64 = 16;

/// The output file of a sweep that can be resumed. Its name is `FILE.part` until all rows are
/// present, then `FILE`. The file always contains whole rows. The journal counts only rows that
/// equal the rows of an uninterrupted run, byte for byte.
pub struct ResumableFile<'a> {
    /// The path of the complete file.
    path: PathBuf,
    /// The open file.
    file: File,
    journal: Journal,
    formatter: &'a RowFormatter,
    /// The rows in the file.
    pub written: WrittenRows,
    /// Number of rows in the journal. A resumed sweep continues after these rows.
    pub recorded_rows: u64,
    /// Number of blocks since the last line of the journal.
    since: u64,
    /// Time of the last line of the journal.
    last: Option<Instant>,
    /// The written row groups of a Parquet file.
    #[cfg(feature = "parquet")]
    groups: RowGroups,
    /// The rows before each row group.
    #[cfg(feature = "parquet")]
    before_groups: Vec<WrittenRows>,
    /// Blocks of the next row group.
    #[cfg(feature = "parquet")]
    pending: Vec<Block>,
}

/// The path of an incomplete file, `FILE.part`.
pub fn part_of(path: &Path) -> PathBuf {
    with_suffix(path, ".part")
}

/// Refuses a sweep that would delete the rows of an earlier sweep, or replace a file that no sweep
/// wrote.
pub fn refuse_unfinished_sweep(path: &Path, resume: bool, overwrite: bool) -> Result<()> {
    let journal = Journal::path(path);
    if !journal.exists() {
        let part = part_of(path);
        return match (part.exists(), resume && path.exists()) {
            (true, _) => Err(refused(
                &part,
                "it exists, and it is not known which sweep wrote it; move it away",
            )),
            (_, true) => Err(nothing_to_resume(path)),
            _ => Ok(()),
        };
    }
    if !Journal::is_one(&journal).map_err(|error| unwritable(path, &error))? {
        return Err(refused(
            &journal,
            "it exists, and is not the journal of a sweep; move it away",
        ));
    }
    if !resume && !overwrite {
        let reason = "an earlier sweep into it did not end; `resume` continues it, `overwrite` \
                      starts again";
        return Err(refused(path, reason));
    }
    Ok(())
}

fn nothing_to_resume(path: &Path) -> Error {
    let reason = format!(
        "there is nothing to resume, because {} does not exist: the file is complete, or no sweep \
         wrote it; `overwrite` replaces it",
        Journal::path(path).display()
    );
    refused(path, reason)
}

impl<'a> ResumableFile<'a> {
    /// Begins the file. The destination must have been checked.
    pub fn begin(path: &Path, header: JournalHeader, formatter: &'a RowFormatter) -> Result<Self> {
        let unwritable = |error: io::Error| unwritable(path, &error);
        // create the journal first: rows without a journal could not be identified
        let journal = Journal::begin(path, header).map_err(unwritable)?;
        // another sweep may have completed the file since the check
        if !journal.header.overwrite && path.exists() {
            journal.remove().map_err(unwritable)?;
            return Err(exists(path));
        }
        let rows = OpenOptions::new()
            .write(true)
            .create(true)
            .truncate(true)
            .open(part_of(path));
        let file = rows.map_err(|error| {
            let _ = journal.remove();
            unwritable(error)
        })?;
        let mut begun = Self::at_the_beginning(path, file, journal, formatter);
        begun.append(&begun.formatter.head())?;
        Ok(begun)
    }

    fn at_the_beginning(
        path: &Path,
        file: File,
        journal: Journal,
        formatter: &'a RowFormatter,
    ) -> Self {
        Self {
            path: path.into(),
            file,
            journal,
            formatter,
            written: WrittenRows::default(),
            recorded_rows: 0,
            since: 0,
            last: None,
            #[cfg(feature = "parquet")]
            groups: RowGroups::default(),
            #[cfg(feature = "parquet")]
            before_groups: vec![],
            #[cfg(feature = "parquet")]
            pending: vec![],
        }
    }

    /// Continues the file after the rows that its journal records. The destination must have been
    /// checked.
    pub fn resume(
        path: &Path,
        header: &JournalHeader,
        formatter: &'a RowFormatter,
    ) -> Result<Self> {
        let unusable =
            |error: io::Error| refused(path, format!("its sweep cannot be resumed ({error})"));
        // the file is missing if the program was killed after it created the journal, and before it
        // created the file
        let file = OpenOptions::new()
            .write(true)
            .create(true)
            .truncate(false)
            .open(part_of(path))
            .map_err(unusable)?;
        let length = file.metadata().map_err(unusable)?.len();
        let Some((journal, entries)) =
            Journal::open(path, |entry| entry.bytes <= length).map_err(unusable)?
        else {
            return Err(nothing_to_resume(path));
        };
        let earlier = &journal.header;
        let other_format = (header.format != earlier.format).then(|| "different formats".into());
        let difference = header.definition.difference(&earlier.definition);
        if let Some(difference) = difference.or(other_format) {
            let reason = format!(
                "it belongs to another command ({difference}); repeat the command that began it, \
                 or give `overwrite` to replace the file"
            );
            return Err(refused(path, reason));
        }
        if !earlier.overwrite && path.exists() {
            let reason = "it exists, and the sweep into it was begun without `overwrite`; move it \
                          away, then repeat the \
                          same command with `resume`";
            return Err(refused(path, reason));
        }
        let mut kept = Self::at_the_beginning(path, file, journal, formatter);
        if let Some(last) = entries.last() {
            kept.written = last.clone();
            kept.recorded_rows = kept.rows();
        }
        #[cfg(feature = "parquet")]
        if let RowFormatter::Parquet(_) = formatter {
            kept.restore_groups(&entries)?;
        }
        cut(&mut kept.file, kept.written.bytes).map_err(unusable)?;
        note(&format!(
            "resuming after {}",
            counted(kept.recorded_rows, "row")
        ));
        if kept.recorded_rows == 0 {
            kept.append(&kept.formatter.head())?;
        }
        Ok(kept)
    }

    /// Number of rows in the file.
    fn rows(&self) -> u64 {
        self.written.status_counts.total()
    }

    pub fn push(&mut self, rows: FormattedRows) -> Result<()> {
        match rows {
            FormattedRows::Text {
                bytes,
                status_counts,
            } => {
                self.append(&bytes)?;
                self.written.status_counts.merge(&status_counts);
                self.since += 1;
                if self.since >= BLOCKS && self.last.is_none_or(|last| last.elapsed() >= OFTEN) {
                    self.keep(vec![])?;
                }
            }
            #[cfg(feature = "parquet")]
            FormattedRows::Block(block) => {
                let RowFormatter::Parquet(table) = self.formatter else {
                    return Ok(());
                };
                self.pending.push(block);
                if self.pending.len() == table.blocks_of_group() {
                    let metadata = self.write_group(table)?;
                    self.keep(metadata)?;
                }
            }
        }
        Ok(())
    }

    /// Writes the rows computed so far and, for Parquet, the footer, so that the file can be read.
    /// A complete file is renamed to its final name, and its journal is deleted.
    pub fn close(&mut self, is_complete: bool) -> Result<()> {
        #[cfg(feature = "parquet")]
        if let RowFormatter::Parquet(table) = self.formatter {
            // after a disk error there may be no space for these rows
            let rest = if self.pending.is_empty() {
                Ok(())
            } else {
                self.write_group(table).map(|_| ())
            };
            self.write_footer(table).and(rest)?;
        }
        if !is_complete && self.since > 0 {
            // ignore an error: without this entry, a resumed sweep only repeats some more rows
            let _ = self.keep(vec![]);
        }
        if is_complete {
            let in_place = || {
                self.file.sync_all()?;
                let part = TempPath::try_from_path(part_of(&self.path))?;
                persist(part, &self.path, self.journal.header.overwrite).map_err(|failed| {
                    // keep the file: it has all rows
                    let _ = failed.path.keep();
                    failed.error
                })?;
                self.journal.remove()
            };
            in_place().map_err(|error| self.failed(&error))?;
        }
        Ok(())
    }

    /// Appends all of the bytes, or none.
    fn append(&mut self, bytes: &[u8]) -> Result<()> {
        if let Err(error) = self.file.write_all(bytes) {
            // remove the incomplete row
            let _ = cut(&mut self.file, self.written.bytes);
            return Err(self.failed(&error));
        }
        self.written.bytes += bytes.len() as u64;
        Ok(())
    }

    /// The command that continues this sweep.
    pub fn resuming_command(&self) -> &'static str {
        if self.journal.header.overwrite {
            "the same command with `resume` in place of `overwrite`"
        } else {
            "the same command with `resume`"
        }
    }

    fn failed(&self, error: &io::Error) -> Error {
        let rows = counted(self.rows(), "complete row");
        let part = part_of(&self.path);
        let (what, remedy) = match error.kind() {
            ErrorKind::AlreadyExists => (
                "it was made by another program while the sweep ran".into(),
                "move the other file away",
            ),
            _ => (
                format!("it cannot be written further ({})", write_error_text(error)),
                "make room",
            ),
        };
        let reason = format!(
            "{what}; {} keeps its first {rows}; {remedy}, then repeat {}",
            part.display(),
            self.resuming_command()
        );
        refused(&self.path, reason)
    }

    /// Records the written rows in the journal.
    fn keep(&mut self, group: Vec<u8>) -> Result<()> {
        let entry = WrittenRows {
            group,
            ..self.written.clone()
        };
        self.file
            .sync_data()
            .and_then(|()| self.journal.add(&entry))
            .map_err(|error| self.failed(&error))?;
        (self.recorded_rows, self.since, self.last) = (self.rows(), 0, Some(Instant::now()));
        Ok(())
    }
}

#[cfg(feature = "parquet")]
impl ResumableFile<'_> {
    /// Writes the pending blocks as a row group and returns its metadata.
    fn write_group(&mut self, table: &SweepParquet) -> Result<Vec<u8>> {
        let blocks = std::mem::take(&mut self.pending);
        let ParquetGroup { bytes, metadata } = table.group(&blocks)?;
        let before = self.written.clone();
        self.append(&bytes)?;
        self.groups.add(&metadata)?;
        self.before_groups.push(before);
        for block in &blocks {
            self.written.status_counts.add(block);
        }
        Ok(metadata)
    }

    /// Writes the footer, without which no row of a Parquet file can be read. If the disk is full,
    /// removes row groups to make space.
    fn write_footer(&mut self, table: &SweepParquet) -> Result<()> {
        let mut no_room = None;
        loop {
            let footer = table.footer(&self.groups, &[])?;
            let Err(error) = self.file.write_all(&footer) else {
                break;
            };
            let Some(before) = self.before_groups.pop() else {
                return Err(self.failed(&error));
            };
            self.groups.remove_last();
            self.written = before;
            cut(&mut self.file, self.written.bytes)
                .and_then(|()| self.journal.forget_beyond(self.written.bytes))
                .map_err(|error| self.failed(&error))?;
            no_room = Some(error);
        }
        // if row groups were removed, the file is incomplete: return the error of the full disk
        no_room.map_or(Ok(()), |error| Err(self.failed(&error)))
    }

    /// Restores the row groups that the journal records.
    fn restore_groups(&mut self, entries: &[WrittenRows]) -> Result<()> {
        let mut before = WrittenRows {
            bytes: PARQUET_MAGIC.len() as u64,
            ..WrittenRows::default()
        };
        for entry in entries {
            let unusable = |why: &dyn Display| {
                let reason =
                    format!("its sweep cannot be resumed ({why}); start it again with `overwrite`");
                refused(&self.path, reason)
            };
            self.groups
                .add(&entry.group)
                .map_err(|error| unusable(&error))?;
            if u64::try_from(self.groups.end()) != Ok(entry.bytes) {
                return Err(unusable(
                    &"a row group has another length than its journal says",
                ));
            }
            self.before_groups.push(before);
            before = entry.clone();
        }
        Ok(())
    }
}
