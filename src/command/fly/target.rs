//! Destination and format of the rows of shots.

use super::args::{Args, FlyFormat};
use crate::command::files::{Destination, DestinationKind, OutputRule};
use crate::command::output::is_json;
use crate::command::request::Request;
use crate::command::rows_target::{RowFormat, RowsTarget};
use crate::command::running::running;
use crate::{Error, Result};
use std::path::Path;

impl RowFormat for FlyFormat {
    const EXTENSIONS: &'static [(&'static str, Self)] = &[
        ("csv", Self::Csv),
        ("jsonl", Self::Jsonl),
        ("ndjson", Self::Jsonl),
        ("json", Self::OpenConnect),
        #[cfg(feature = "parquet")]
        ("parquet", Self::Parquet),
    ];
    const LISTED: &'static str = ".csv, .jsonl, .json or .parquet";

    fn is_text(self) -> bool {
        match self {
            Self::Csv | Self::LaunchMonitor | Self::Jsonl | Self::OpenConnect | Self::Screen => {
                true
            }
            #[cfg(feature = "parquet")]
            Self::Parquet => false,
        }
    }
}

/// The format of `--format`, or else of the file name extension. Without `--format`, a screen gets
/// a table of fixed width, and any other standard output gets CSV.
///
/// # Errors
/// [`Error::Together`] for `--format` with an answer in JSON and no file, because then no rows are
/// written; the errors of [`RowsTarget::format`].
pub fn format_of(args: &Args, target: RowsTarget<'_>) -> Result<FlyFormat> {
    if target.is_standard_output() && is_json() && args.format.is_some() {
        return Err(Error::Together {
            given: "`format` with `json`".into(),
            reason: "an answer in JSON is a summary without rows; name a file for the rows with \
                     `output`, or leave `format` out"
                .into(),
        });
    }
    let running = running();
    let fits_screen = running.host.is_screen() && !running.options.all;
    let default = match fits_screen {
        true => FlyFormat::Screen,
        false => FlyFormat::Csv,
    };
    target.format(args.format, default)
}

/// The destination of the rows. Without an output file, an answer in JSON has the summary only: no
/// rows are written.
pub fn destination(
    args: &Args,
    target: RowsTarget<'_>,
    shots: &Path,
    request: &Request,
) -> Result<Destination> {
    if target.is_standard_output() {
        return Ok(Destination::without_file(match is_json() {
            true => DestinationKind::Nowhere,
            false => DestinationKind::StandardOutput,
        }));
    }
    let inputs = request
        .inputs()
        .chain((shots != Path::new("-")).then(|| shots.to_path_buf()));
    OutputRule::new(inputs, args.overwrite).file(target.0)
}
