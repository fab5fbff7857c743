//! Format and destination of rows, by one rule for `fly` and `sweep`.

use super::files::{ending, refused};
use crate::Result;
use std::path::Path;

/// Other names of standard output.
const STANDARD_OUTPUT: [&str; 3] = ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];

/// A format of rows.
pub trait RowFormat: Copy + 'static {
    /// File name extensions in lower case, each with its format.
    const EXTENSIONS: &'static [(&'static str, Self)];
    /// The extensions, for messages.
    const LISTED: &'static str;

    /// True for a format of text, which standard output and devices take too.
    fn is_text(self) -> bool;
}

/// The path of the rows, which is a file, a device, or "-" for standard output.
#[derive(Clone, Copy)]
pub struct RowsTarget<'a>(pub &'a Path);

impl<'a> RowsTarget<'a> {
    /// The target of the option `output`.
    ///
    /// # Errors
    /// [`Error::Results`](crate::Error::Results) for another name of standard output than "-", and
    /// for `overwrite` of standard output.
    pub fn new(path: &'a Path, overwrite: bool) -> Result<Self> {
        if STANDARD_OUTPUT.map(Path::new).contains(&path) {
            let reason = "it is standard output; write `output -` with `format csv` or jsonl";
            return Err(refused(path, reason));
        }
        let target = Self(path);
        if target.is_standard_output() && overwrite {
            let reason = "`overwrite` replaces a file, and the rows go to standard output; name a \
                          file with `output`, or leave `overwrite` out";
            return Err(refused(path, reason));
        }
        Ok(target)
    }

    pub fn is_standard_output(self) -> bool {
        self.0 == Path::new("-")
    }

    /// True for standard output, and for a pipe, a terminal or a device, which do not store the
    /// bytes.
    pub fn is_stream(self) -> bool {
        let is_device = |found: std::fs::Metadata| !found.is_file() && !found.is_dir();
        self.is_standard_output() || std::fs::metadata(self.0).is_ok_and(is_device)
    }

    /// The format: the `stated` format, or else that of the file name extension, or `default` for
    /// standard output.
    ///
    /// # Errors
    /// [`Error::Results`](crate::Error::Results) for an unknown extension, for a format that is not
    /// compiled in, and for a stream in a format that is no text.
    pub fn format<F: RowFormat>(self, stated: Option<F>, default: F) -> Result<F> {
        let format = match stated {
            Some(format) => format,
            None if self.is_standard_output() => default,
            None => self.format_of_extension()?,
        };
        if self.is_stream() && !format.is_text() {
            let reason =
                "Parquet needs a file; name one with `output`, or take `format csv` or jsonl";
            return Err(refused(self.0, reason));
        }
        Ok(format)
    }

    fn format_of_extension<F: RowFormat>(self) -> Result<F> {
        let extension = ending(self.0);
        let mut known = F::EXTENSIONS.iter();
        if let Some((_, format)) = known.find(|(known, _)| *known == extension) {
            return Ok(*format);
        }
        #[cfg(not(feature = "parquet"))]
        if extension == "parquet" {
            return Err(refused(self.0, crate::features::how_to_get("parquet")));
        }
        let listed = F::LISTED;
        let reason = format!("its name must end in {listed}, or `format` must name the format");
        Err(refused(self.0, reason))
    }
}
