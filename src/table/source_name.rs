//! The file that shots are read from, for messages.

use crate::error::{Error, Result};
use crate::foreign::of_io;
use std::io;

/// The name of the file, for messages.
#[derive(Clone, Debug)]
pub(crate) struct SourceName(pub String);

impl SourceName {
    pub fn refused(&self, place: String, reason: impl Into<String>) -> Error {
        Error::Table { file: self.0.clone(), place, reason: reason.into() }
    }

    pub fn io<T>(&self, result: io::Result<T>) -> Result<T> {
        result.map_err(|error| self.refused(String::new(), of_io(&error)))
    }
}
