//! Destination and format of the rows of a sweep.

use super::args::{Args, SweepFormat};
use super::journal::Journal;
use super::resumable::{ResumableFile, refuse_unfinished_sweep};
use super::rows::{FormattedRows, Identity, RowFormatter};
use crate::batch::StatusCounts;
use crate::command::files::{
    Destination, DestinationKind, OutputRule, OutputStream, ending, parquet_without_file,
    refuse_overwrite_of_standard_output, refused,
};
use crate::command::request::Request;
use crate::external_errors::write_error_text;
use crate::units::counted;
use crate::{Error, Result};
use std::io;
use std::path::Path;

/// The format of `--format`, or else of the file name extension.
pub fn format_of(args: &Args) -> Result<SweepFormat> {
    let path = args.output.as_path();
    let standard_output = ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];
    if standard_output.map(Path::new).contains(&path) {
        let reason = "it is standard output; write `output -` with `format csv` or jsonl";
        return Err(refused(path, reason));
    }
    refuse_overwrite_of_standard_output(path, args.overwrite)?;
    Ok(match (args.format, ending(path).as_str()) {
        (Some(format), _) => format,
        (None, "csv") => SweepFormat::Csv,
        (None, "jsonl" | "ndjson") => SweepFormat::Jsonl,
        #[cfg(feature = "parquet")]
        (None, "parquet") => SweepFormat::Parquet,
        #[cfg(not(feature = "parquet"))]
        (None, "parquet") => {
            return Err(refused(path, crate::features::how_to_get("parquet")));
        }
        (None, _) if path == Path::new("-") => SweepFormat::Csv,
        _ => {
            return Err(refused(
                path,
                "its name must end in .csv, .jsonl or .parquet, or `format` must name the format",
            ));
        }
    })
}

/// The destination of the rows in this format.
pub fn destination(args: &Args, request: &Request, format: SweepFormat) -> Result<Destination> {
    let path = args.output.as_path();
    let refuse = |reason: &str| Err(refused(path, reason));
    let is_standard = path == Path::new("-");
    if is_standard && request.is_json {
        return refuse(
            "standard output cannot hold both the rows and the summary of `json`; name a file \
             with `output`",
        );
    }
    // a pipe, a terminal or a device does not store the bytes
    let is_stream = is_standard || std::fs::metadata(path).is_ok_and(|found| !found.is_file());
    if is_stream && args.resume {
        return refuse("only a file can be resumed; name one with `output`");
    }
    let is_text = matches!(format, SweepFormat::Csv | SweepFormat::Jsonl);
    if is_stream && !is_text {
        return Err(parquet_without_file(path));
    }
    if is_standard {
        return Ok(Destination::without_file(DestinationKind::StandardOutput));
    }
    let inputs = request.inputs().chain(args.points.clone());
    // with `--resume` a file may exist; the code below checks that it belongs to a sweep
    let destination = OutputRule::new(inputs, args.overwrite || args.resume).file(path)?;
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
        identity: &Identity,
        formatter: &'a RowFormatter,
        args: &Args,
    ) -> Result<Self> {
        if let Some(file) = destination.file() {
            let file = match args.resume && Journal::path(file).exists() {
                true => ResumableFile::resume(file, identity, formatter),
                false => ResumableFile::begin(file, identity, formatter, args.overwrite),
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
