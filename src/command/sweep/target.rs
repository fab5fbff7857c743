use super::args::{Args, Format};
use super::resumable::{ResumableFile, check, part_of};
use super::rows::{Rows, Writer};
use crate::batch::StatusCounts;
#[cfg(feature = "parquet")]
use crate::command::files::parquet_without_file;
use crate::command::files::{
    Rule, ending, refuse_overwrite_of_standard_output, refused, unwritable,
};
use crate::command::request::Request;
use crate::command::running::running;
use crate::external_errors::write_error_text;
use crate::units::counted;
use crate::{Error, Result};
use std::fs::{File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// The destination of the rows.
pub struct Target {
    /// The path as typed.
    path: PathBuf,
    /// The file, if the destination stores its bytes.
    pub file: Option<PathBuf>,
    pub format: Format,
}

impl Target {
    pub fn new(args: &Args, request: &Request) -> Result<Self> {
        let target = Self {
            path: args.output.clone(),
            file: None,
            format: Format::Csv,
        };
        let refuse = |reason: &str| Err(refused(&target.path, reason));
        let standard_output = ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];
        if standard_output
            .map(Path::new)
            .contains(&target.path.as_path())
        {
            return refuse("it is standard output; write `output -` with `format csv` or jsonl");
        }
        refuse_overwrite_of_standard_output(&target.path, args.overwrite)?;
        let format = target.format_of(args)?;
        if target.is_standard_output() && request.is_json {
            return refuse(
                "standard output cannot hold both the rows and the summary of `json`; name a file \
                 with `output`",
            );
        }
        if target.is_stream() && args.resume {
            return refuse("only a file can be resumed; name one with `output`");
        }
        #[cfg(feature = "parquet")]
        if target.is_stream() && format == Format::Parquet {
            return Err(parquet_without_file(&target.path));
        }
        if target.is_standard_output() {
            return Ok(Self { format, ..target });
        }
        let inputs = request.inputs().chain(args.points.clone());
        // with `--resume` a file may exist; the code below checks that it belongs to a sweep
        let destination = Rule::new(inputs, args.overwrite || args.resume).file(&target.path)?;
        if destination.is_in_memory() {
            return refuse(
                "there is no disk here; write the rows to standard output, with `format csv` or \
                 jsonl",
            );
        }
        let file = destination.is_file().then(|| destination.path.clone());
        if let Some(file) = &file {
            check(file, args.resume, args.overwrite)?;
        }
        Ok(Self {
            format,
            file,
            ..target
        })
    }

    /// The format of `--format`, or else of the file name extension.
    fn format_of(&self, args: &Args) -> Result<Format> {
        Ok(match (args.format, ending(&self.path).as_str()) {
            (Some(format), _) => format,
            (None, "csv") => Format::Csv,
            (None, "jsonl" | "ndjson") => Format::Jsonl,
            #[cfg(feature = "parquet")]
            (None, "parquet") => Format::Parquet,
            #[cfg(not(feature = "parquet"))]
            (None, "parquet") => {
                let reason = crate::features::how_to_get("parquet");
                return Err(refused(&self.path, reason));
            }
            (None, _) if self.is_standard_output() => Format::Csv,
            _ => {
                return Err(refused(
                    &self.path,
                    "its name must end in .csv, .jsonl or .parquet, or `format` must name the \
                     format",
                ));
            }
        })
    }

    pub fn is_standard_output(&self) -> bool {
        self.path == Path::new("-")
    }

    /// Returns true for a pipe, a terminal or a device, which do not store the bytes.
    fn is_stream(&self) -> bool {
        self.is_standard_output()
            || std::fs::metadata(&self.path).is_ok_and(|found| !found.is_file())
    }

    /// The path of the incomplete file.
    pub fn part(&self) -> Option<PathBuf> {
        self.file.as_deref().map(part_of)
    }

    /// Begins the output, or continues an interrupted output.
    pub fn open<'a>(&self, writer: &'a Writer, args: &Args) -> Result<Output<'a>> {
        if let Some(file) = &self.file {
            return Ok(Output::Resumable(Box::new(ResumableFile::open(
                file.clone(),
                writer,
                args.resume,
                args.overwrite,
            )?)));
        }
        let device = if self.is_standard_output() {
            None
        } else {
            let device = OpenOptions::new().write(true).open(&self.path);
            Some(device.map_err(|error| unwritable(&self.path, &error))?)
        };
        let mut stream = Stream {
            device,
            status_counts: StatusCounts::default(),
        };
        stream.write(&writer.head())?;
        Ok(Output::Stream(stream))
    }
}

/// The open destination of the rows.
pub enum Output<'a> {
    Resumable(Box<ResumableFile<'a>>),
    Stream(Stream),
}

pub struct Stream {
    /// The device; `None` for standard output.
    device: Option<File>,
    status_counts: StatusCounts,
}

impl Stream {
    fn write(&mut self, bytes: &[u8]) -> Result<()> {
        let written = match &mut self.device {
            None => running().host.write(bytes),
            Some(device) => device.write_all(bytes).and_then(|()| device.flush()),
        };
        written.map_err(|error| {
            if error.kind() == io::ErrorKind::BrokenPipe {
                return Error::Output(error);
            }
            Error::Output(io::Error::new(
                error.kind(),
                format!(
                    "{}; written before: {}",
                    write_error_text(&error),
                    counted(self.status_counts.total(), "row")
                ),
            ))
        })
    }
}

impl Output<'_> {
    /// Number of rows that need not be computed again: at the start, the rows of an earlier run.
    pub fn safe(&self) -> u64 {
        match self {
            Self::Resumable(file) => file.safe,
            Self::Stream(_) => 0,
        }
    }

    pub fn status_counts(&self) -> &StatusCounts {
        match self {
            Self::Resumable(file) => file.status_counts(),
            Self::Stream(stream) => &stream.status_counts,
        }
    }

    pub fn take(&mut self, rows: Rows) -> Result<()> {
        match self {
            Self::Resumable(file) => file.take(rows),
            Self::Stream(stream) => match rows {
                Rows::Text {
                    bytes,
                    status_counts,
                } => {
                    stream.status_counts.merge(&status_counts);
                    stream.write(&bytes)
                }
                #[cfg(feature = "parquet")]
                Rows::Block(_) => Ok(()),
            },
        }
    }

    /// Closes the output so that the rows can be read.
    pub fn close(&mut self, is_complete: bool) -> Result<()> {
        match self {
            Self::Resumable(file) => file.close(is_complete),
            Self::Stream(_) => Ok(()),
        }
    }
}
