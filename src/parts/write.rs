use super::footer::{Footer, Manifest, PART, Part, hex};
use super::share::{file_name, rows_of};
use crate::atomic_file::{create_beside, folder_of, persist};
use crate::batch::{Batch, Block, Points, Run, SweepDefinition};
use crate::error::{Error, Result};
use crate::external_errors::write_error_text;
use crate::report::{PARQUET_MAGIC, ParquetGroup, RowGroups, SweepParquet};
use crate::statistics::{Histogram, Ranking, Summary, SummarySpec};
use sha2::{Digest, Sha256};
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::Path;

/// A sweep divided into parts.
pub struct Dataset {
    batch: Batch,
    summary_spec: SummarySpec,
    /// Definition of the sweep.
    pub definition: SweepDefinition,
    table: SweepParquet,
}

/// Result of writing a part.
#[derive(Clone, Debug, PartialEq)]
pub enum PartResult {
    /// The part was computed and its file written.
    New(Manifest),
    /// The folder already had a complete file of the part.
    Existing(Manifest),
    /// The computation was interrupted; no file was written.
    Stopped,
}

impl Dataset {
    /// Divides the sweep of `batch` over `points` into `parts` parts. The footer of each part has
    /// the histograms and the best rows that `histograms` and `best` request; each may be empty.
    ///
    /// # Errors
    /// [`Error::Together`] if there are more parts than blocks of rows, and errors of
    /// [`SummarySpec::new`].
    pub fn new(
        batch: Batch,
        points: &dyn Points,
        parts: u64,
        histograms: Vec<Histogram>,
        best: Vec<Ranking>,
    ) -> Result<Self> {
        rows_of(parts, parts, points.rows())?;
        let summary_spec = SummarySpec::new(&batch, histograms, best)?;
        let definition = SweepDefinition::new(&batch, points, summary_spec.identity(), parts);
        let table = SweepParquet::new(&batch, &definition.text())?;
        Ok(Self {
            batch,
            summary_spec,
            definition,
            table,
        })
    }

    /// Computes a part and writes it into an existing folder. If the folder has the complete part
    /// already and `overwrite` is false, nothing is computed. The file is synced to the disk before
    /// it is renamed. `run` gives the threads and the stop flag; `progress` receives the number of
    /// computed rows.
    ///
    /// # Errors
    /// [`Error::Results`] if the folder has a part of another sweep, if another file has the name
    /// of this part and `overwrite` is false, or if the file cannot be written, and errors of
    /// [`rows_of`] and [`Batch::run`].
    pub fn write(
        &self,
        points: &mut dyn Points,
        part: u64,
        folder: &Path,
        run: &Run<'_>,
        overwrite: bool,
        mut progress: impl FnMut(u64),
    ) -> Result<PartResult> {
        let rows = rows_of(part, self.definition.parts, self.definition.rows)?;
        let name = file_name(part, self.definition.parts);
        let path = folder.join(&name);
        let results = |reason: String| Error::Results {
            file: path.display().to_string(),
            reason,
        };
        if !overwrite && path.exists() {
            return self
                .found(part, &path)
                .map(PartResult::Existing)
                .map_err(results);
        }
        self.refuse_other_sweep(folder, &path)?;
        let unwritten = |error: io::Error| {
            let why = write_error_text(&error);
            results(format!(
                "it cannot be written ({why}); nothing of it is kept. Correct this, then repeat \
                 part {part}"
            ))
        };
        let mut file = PartFile {
            file: create_beside(&path).map_err(unwritten)?,
            hash: Sha256::default(),
            bytes: 0,
            groups: RowGroups::default(),
            summary: self.summary_spec.empty(),
        };
        let run = Run {
            first_row: rows.start,
            end_row: Some(rows.end),
            ..*run
        };
        if !self.write_rows(&mut file, points, &run, &mut progress, unwritten)? {
            return Ok(PartResult::Stopped);
        }
        let part = self.part(part, rows.start, &mut file);
        // serialization cannot fail: the description has only strings and finite numbers
        let note = serde_json::to_string(&part).unwrap_or_default();
        let footer = self.table.footer(&file.groups, &[(PART, note)])?;
        file.write(&footer).map_err(unwritten)?;
        let (bytes, sha256) = file.persist(&path).map_err(unwritten)?;
        Ok(PartResult::New(Manifest {
            file: name,
            bytes,
            sha256,
            part,
        }))
    }

    /// The description of a part. All of its rows must have been written to `file`.
    fn part(&self, part: u64, first_row: u64, file: &mut PartFile) -> Part {
        Part {
            part,
            parts: self.definition.parts,
            first_row,
            rows: file.summary.status_counts.total(),
            question: self.definition.hash(),
            instructions: self.definition.instructions.clone(),
            data: hex(file.hash.clone()),
            summary: std::mem::take(&mut file.summary),
        }
    }

    /// Computes the rows of `run` and writes them to the file. Returns false if the run was
    /// stopped.
    fn write_rows(
        &self,
        file: &mut PartFile,
        points: &mut dyn Points,
        run: &Run<'_>,
        progress: &mut impl FnMut(u64),
        unwritten: impl Fn(io::Error) -> Error + Copy,
    ) -> Result<bool> {
        file.write(PARQUET_MAGIC).map_err(unwritten)?;
        let mut waiting = vec![];
        let end = self.batch.run(
            points,
            run,
            |block| (self.summary_spec.of(&block), block),
            |(of_block, block)| {
                file.summary.merge(&of_block);
                waiting.push(block);
                if waiting.len() == self.table.blocks_of_group() {
                    self.write_group(file, &mut waiting, unwritten)?;
                }
                progress(file.summary.status_counts.total());
                Ok(())
            },
        )?;
        if run.end_row.is_some_and(|last| end < last) {
            return Ok(false);
        }
        if !waiting.is_empty() {
            self.write_group(file, &mut waiting, unwritten)?;
        }
        Ok(true)
    }

    fn write_group(
        &self,
        file: &mut PartFile,
        waiting: &mut Vec<Block>,
        unwritten: impl Fn(io::Error) -> Error,
    ) -> Result<()> {
        let ParquetGroup { bytes, metadata } = self.table.group(&std::mem::take(waiting))?;
        file.groups.add(&metadata)?;
        file.write(&bytes).map_err(unwritten)
    }

    /// The manifest of the existing file at `path`, or the reason why the file is not the complete
    /// part `part` of this sweep.
    fn found(&self, part: u64, path: &Path) -> Result<Manifest, String> {
        let advice = "take another folder, or give `overwrite` to replace the file";
        let footer = Footer::read(path).map_err(|reason| format!("{reason}; {advice}"))?;
        if let Some(difference) = self.definition.difference(&footer.definition) {
            return Err(format!(
                "it exists and belongs to another sweep ({difference}); {advice}"
            ));
        }
        if footer.part.part != part {
            return Err(format!(
                "it exists and is part {} under a wrong name; {advice}",
                footer.part.part
            ));
        }
        footer
            .manifest(path)
            .map_err(|reason| format!("{reason}; {advice}"))
    }

    /// Refuses a folder that contains a part of another sweep. For speed, reads only the first
    /// readable footer; [`check`](super::check()) reads all files.
    fn refuse_other_sweep(&self, folder: &Path, place: &Path) -> Result<()> {
        let entries = fs::read_dir(folder).map_err(|error| Error::Results {
            file: folder.display().to_string(),
            reason: crate::external_errors::read_error_text(&error),
        })?;
        let is_part = |path: &Path| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            name.starts_with("part-") && name.ends_with(".parquet") && path != place
        };
        let mut others = entries
            .flatten()
            .map(|entry| entry.path())
            .filter(|path| is_part(path));
        let Some((other, footer)) = others.find_map(|path| {
            let footer = Footer::read(&path).ok()?;
            Some((path, footer))
        }) else {
            return Ok(());
        };
        match self.definition.difference(&footer.definition) {
            None => Ok(()),
            Some(difference) => Err(Error::Results {
                file: other.display().to_string(),
                reason: format!(
                    "it belongs to another sweep ({difference}), and a folder holds the parts of \
                     one sweep; take another folder, or compute that sweep"
                ),
            }),
        }
    }
}

/// A part that is being written to a temporary file.
struct PartFile {
    file: tempfile::NamedTempFile,
    /// Hash of the bytes written so far.
    hash: Sha256,
    /// Number of bytes written so far.
    bytes: u64,
    /// The row groups written so far.
    groups: RowGroups,
    /// Statistics of the rows computed so far.
    summary: Summary,
}

impl PartFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.file.write_all(bytes)?;
        self.hash.update(bytes);
        self.bytes += bytes.len() as u64;
        Ok(())
    }

    /// Syncs the file to the disk and renames it to its final path. Returns its size and SHA-256.
    fn persist(self, path: &Path) -> io::Result<(u64, String)> {
        self.file.as_file().sync_all()?;
        persist(self.file.into_temp_path(), path, true)?;
        #[cfg(unix)]
        File::open(folder_of(path))?.sync_all()?;
        Ok((self.bytes, hex(self.hash)))
    }
}
