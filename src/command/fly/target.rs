//! Destination and format of the rows of shots.

use super::args::{Args, FlyFormat};
use crate::command::files::{
    Destination, DestinationKind, OutputRule, ending, parquet_without_file,
    refuse_overwrite_of_standard_output, refused,
};
use crate::command::request::Request;
use crate::command::running::running;
use crate::{Error, Result};
use std::path::Path;

/// The format of `--format`, or else of the file name extension. Without `--format`, a screen gets
/// a table of fixed width, and any other standard output gets CSV.
///
/// # Errors
/// [`Error::Together`] for `--format` with an answer in JSON and no file, because then no rows are
/// written; [`Error::Results`] for a file or a format that cannot be written.
pub fn format_of(args: &Args, is_json: bool) -> Result<FlyFormat> {
    let path = args.output.as_path();
    let is_standard = path == Path::new("-");
    if is_standard && is_json && args.format.is_some() {
        return Err(Error::Together {
            given: "`format` with `json`".into(),
            reason: "an answer in JSON is a summary without rows; name a file for the rows with \
                     `output`, or leave `format` out"
                .into(),
        });
    }
    let running = running();
    let fits_screen = running.host.is_screen() && !running.options.all;
    let format = match (args.format, ending(path).as_str()) {
        (Some(format), _) => format,
        (None, "csv") => FlyFormat::Csv,
        (None, "jsonl" | "ndjson") => FlyFormat::Jsonl,
        (None, "json") => FlyFormat::OpenConnect,
        (None, _) if is_standard && fits_screen => FlyFormat::Screen,
        (None, _) if is_standard => FlyFormat::Csv,
        #[cfg(feature = "parquet")]
        (None, "parquet") => FlyFormat::Parquet,
        #[cfg(not(feature = "parquet"))]
        (None, "parquet") => return Err(refused(path, crate::features::how_to_get("parquet"))),
        (None, _) => {
            return Err(refused(
                path,
                "its name must end in .csv, .jsonl, .json or .parquet, or `format` must name the \
                 format",
            ));
        }
    };
    let is_text = matches!(
        format,
        FlyFormat::Csv
            | FlyFormat::LaunchMonitor
            | FlyFormat::Jsonl
            | FlyFormat::OpenConnect
            | FlyFormat::Screen
    );
    if is_standard && !is_text {
        return Err(parquet_without_file(path));
    }
    Ok(format)
}

/// The destination of the rows. Without an output file, an answer in JSON has the summary only: no
/// rows are written.
pub fn destination(args: &Args, shots: &Path, request: &Request) -> Result<Destination> {
    let path = args.output.as_path();
    refuse_overwrite_of_standard_output(path, args.overwrite)?;
    if path == Path::new("-") {
        return Ok(Destination::without_file(match request.is_json {
            true => DestinationKind::Nowhere,
            false => DestinationKind::StandardOutput,
        }));
    }
    let inputs = request
        .inputs()
        .chain((shots != Path::new("-")).then(|| shots.to_path_buf()));
    OutputRule::new(inputs, args.overwrite).file(path)
}
