//! Destination and format of the rows of a sweep.

use super::args::{Args, SweepFormat};
use super::journal::{Journal, JournalHeader};
use super::resumable::{ResumableFile, refuse_unfinished_sweep};
use super::rows::{FormattedRows, RowFormatter};
use crate::batch::StatusCounts;
use crate::command::files::{Destination, DestinationKind, OutputRule, OutputStream, refused};
use crate::command::output::is_json;
use crate::command::request::Request;
use crate::command::rows_target::{RowFormat, RowsTarget};
use crate::external_errors::write_error_text;
use crate::units::counted;
use crate::{Error, Result};
use std::io;

impl RowFormat for SweepFormat {
    const EXTENSIONS: &'static [(&'static str, Self)] = &[
        ("csv", Self::Csv),
        ("jsonl", Self::Jsonl),
        ("ndjson", Self::Jsonl),
        #[cfg(feature = "parquet")]
        ("parquet", Self::Parquet),
    ];
    const LISTED: &'static str = ".csv, .jsonl or .parquet";

    fn is_text(self) -> bool {
        match self {
            Self::Csv | Self::Jsonl => true,
            #[cfg(feature = "parquet")]
            Self::Parquet => false,
        }
    }
}

/// The destination of the rows.
pub fn destination(args: &Args, request: &Request, target: RowsTarget<'_>) -> Result<Destination> {
    let refuse = |reason: &str| Err(refused(target.0, reason));
    let is_standard = target.is_standard_output();
    if is_standard && is_json() {
        return refuse(
            "standard output cannot hold both the rows and the summary of `json`; name a file \
             with `output`",
        );
    }
    if target.is_stream() && args.resume {
        return refuse("only a file can be resumed; name one with `output`");
    }
    if is_standard {
        return Ok(Destination::without_file(DestinationKind::StandardOutput));
    }
    let inputs = request.inputs().chain(args.points.clone());
    // with `--resume` a file may exist; the code below checks that it belongs to a sweep
    let destination = OutputRule::new(inputs, args.overwrite || args.resume).file(target.0)?;
    if destination.kind == DestinationKind::Memory {
        return refuse(
            "there is no disk here; write the rows to standard output, with `format csv` or jsonl",
        );
    }
    if let Some(file) = destination.file() {
        refuse_unfinished_sweep(file, args.resume, args.overwrite)?;
    }
    Ok(destination)
}

/// The open destination of the rows.
pub enum SweepOutput<'a> {
    Resumable(Box<ResumableFile<'a>>),
    /// Standard output or a device, which cannot be resumed.
    Stream {
        stream: OutputStream,
        status_counts: StatusCounts,
    },
}

impl<'a> SweepOutput<'a> {
    /// Begins the output, or continues an interrupted output.
    pub fn open(
        destination: &Destination,
        header: JournalHeader,
        formatter: &'a RowFormatter,
        resume: bool,
    ) -> Result<Self> {
        if let Some(file) = destination.file() {
            let file = match resume && Journal::path(file).exists() {
                true => ResumableFile::resume(file, &header, formatter),
                false => ResumableFile::begin(file, header, formatter),
            };
            return Ok(Self::Resumable(Box::new(file?)));
        }
        let mut stream = destination.begin()?;
        let status_counts = StatusCounts::default();
        write(&mut stream, &formatter.head(), &status_counts)?;
        Ok(Self::Stream {
            stream,
            status_counts,
        })
    }

    /// Number of rows that the journal records; a resumed sweep continues after these rows. Always
    /// 0 for a stream.
    pub fn recorded_rows(&self) -> u64 {
        match self {
            Self::Resumable(file) => file.recorded_rows,
            Self::Stream { .. } => 0,
        }
    }

    pub fn status_counts(&self) -> &StatusCounts {
        match self {
            Self::Resumable(file) => &file.written.status_counts,
            Self::Stream { status_counts, .. } => status_counts,
        }
    }

    pub fn push(&mut self, rows: FormattedRows) -> Result<()> {
        match (self, rows) {
            (Self::Resumable(file), rows) => file.push(rows),
            (
                Self::Stream {
                    stream,
                    status_counts: all,
                },
                FormattedRows::Text {
                    bytes,
                    status_counts,
                },
            ) => {
                all.merge(&status_counts);
                write(stream, &bytes, all)
            }
            #[cfg(feature = "parquet")]
            (Self::Stream { .. }, FormattedRows::Block(_)) => Ok(()),
        }
    }

    /// Closes the output so that the rows can be read.
    pub fn close(&mut self, is_complete: bool) -> Result<()> {
        match self {
            Self::Resumable(file) => file.close(is_complete),
            Self::Stream { .. } => Ok(()),
        }
    }
}

/// Writes to a stream. An error contains the number of rows written before.
fn write(stream: &mut OutputStream, bytes: &[u8], status_counts: &StatusCounts) -> Result<()> {
    stream.try_write(bytes).map_err(|error| {
        if error.kind() == io::ErrorKind::BrokenPipe {
            return Error::Output(error);
        }
        Error::Output(io::Error::new(
            error.kind(),
            format!(
                "{}; written before: {}",
                write_error_text(&error),
                counted(status_counts.total(), "row")
            ),
        ))
    })
}
