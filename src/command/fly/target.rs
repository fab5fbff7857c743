use super::args::{Args, FlyFormat};
#[cfg(feature = "parquet")]
use crate::command::files::parquet_without_file;
use crate::command::files::{
    Destination, Pieces, Rule, ending, refuse_overwrite_of_standard_output, refused,
};
use crate::command::request::Request;
use crate::command::running::running;
use crate::{Error, Result};
use std::path::Path;

/// The destination of the rows.
pub struct Target {
    destination: Option<Destination>,
    pub format: FlyFormat,
    /// True if no rows are written: without an output file, an answer in JSON has the summary only.
    pub is_silent: bool,
}

impl Target {
    pub fn new(args: &Args, shots: &Path, request: &Request) -> Result<Self> {
        let path = args.output.as_path();
        let is_standard = path == Path::new("-");
        let format = match (args.format, ending(path).as_str()) {
            (Some(format), _) => format,
            (None, "csv") => FlyFormat::Csv,
            (None, "jsonl" | "ndjson") => FlyFormat::Jsonl,
            (None, "json") => FlyFormat::OpenConnect,
            (None, _) if is_standard && running().is_for_a_screen() => FlyFormat::Screen,
            (None, _) if is_standard => FlyFormat::Csv,
            #[cfg(feature = "parquet")]
            (None, "parquet") => FlyFormat::Parquet,
            #[cfg(not(feature = "parquet"))]
            (None, "parquet") => return Err(refused(path, crate::features::how_to_get("parquet"))),
            (None, _) => {
                return Err(refused(
                    path,
                    "its name must end in .csv, .jsonl, .json or .parquet, or `format` must name \
                     the format",
                ));
            }
        };
        #[cfg(feature = "parquet")]
        if is_standard && format == FlyFormat::Parquet && !request.is_json {
            return Err(parquet_without_file(path));
        }
        refuse_overwrite_of_standard_output(path, args.overwrite)?;
        let inputs = request
            .inputs()
            .chain((shots != Path::new("-")).then(|| shots.to_path_buf()));
        let destination = (!is_standard)
            .then(|| Rule::new(inputs, args.overwrite).file(path))
            .transpose()?;
        Ok(Self {
            is_silent: destination.is_none() && request.is_json,
            destination,
            format,
        })
    }

    /// The file, if the destination of the rows is a file on disk.
    pub fn file(&self) -> Option<&Path> {
        let destination = self.destination.as_ref();
        destination
            .filter(|destination| !destination.is_in_memory())
            .map(|destination| destination.path.as_path())
    }

    /// Opens the destination and writes the first bytes.
    pub fn open(&self, head: &[u8]) -> Result<Output> {
        let mut output = match &self.destination {
            Some(destination) => Output::File(destination.begin()?),
            None if self.is_silent => Output::Nowhere,
            None => Output::Standard,
        };
        output.write(head)?;
        Ok(output)
    }
}

/// The open destination of the rows.
pub enum Output {
    File(Pieces),
    Standard,
    Nowhere,
}

impl Output {
    pub fn write(&mut self, bytes: &[u8]) -> Result<()> {
        match self {
            Self::File(file) => file.write(bytes),
            Self::Standard => running().host.write(bytes).map_err(Error::Output),
            Self::Nowhere => Ok(()),
        }
    }

    /// Completes the output.
    pub fn finish(self) -> Result<()> {
        match self {
            Self::File(file) => file.finish(),
            Self::Standard | Self::Nowhere => Ok(()),
        }
    }
}
