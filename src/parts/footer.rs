use crate::batch::SweepDefinition;
use crate::external_errors::{parquet_error_text, read_error_text};
use crate::report::DEFINITION_KEY;
use crate::statistics::Summary;
use parquet::file::metadata::{KeyValue, ParquetMetaDataReader};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom};
use std::path::Path;

/// Metadata key of the description of the part.
pub(super) const PART: &str = "longdrive.part";

/// Description of a part in the footer of its file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Part {
    /// Number of the part, from 1.
    pub part: u64,
    /// Number of parts.
    pub parts: u64,
    /// Index of the part's first row among all rows of the sweep, from 0.
    pub first_row: u64,
    /// Number of rows.
    pub rows: u64,
    /// SHA-256 of the definition of the sweep. The file has the definition under the key
    /// `longdrive`.
    pub question: String,
    /// Architecture and instruction set of the processor: `x86_64 avx2`.
    pub instructions: String,
    /// SHA-256 of the bytes before the footer: the rows.
    pub data: String,
    /// Statistics of the rows.
    #[serde(flatten)]
    pub summary: Summary,
}

/// File of a part, with a description of its content. A repetition of the computation, on any
/// number of threads, gives the same file and description.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Manifest {
    /// Name of the file.
    pub file: String,
    /// Size, bytes.
    pub bytes: u64,
    /// SHA-256 of the whole file, in the format of `sha256sum`.
    pub sha256: String,
    /// The footer.
    #[serde(flatten)]
    pub part: Part,
}

impl SweepDefinition {
    /// SHA-256, in hexadecimal.
    pub fn hash(&self) -> String {
        hex(Sha256::new_with_prefix(self.text()))
    }
}

/// The SHA-256 in hexadecimal, as `sha256sum` prints it.
pub(super) fn hex(hash: Sha256) -> String {
    hash.finalize()
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect()
}

/// The footer of a file, read without its rows.
pub(super) struct Footer {
    pub definition: SweepDefinition,
    pub part: Part,
    pub bytes: u64,
    /// Number of bytes before the footer.
    data: u64,
}

impl Footer {
    /// Reads the footer of a file, or returns the reason why it cannot be read.
    pub fn read(path: &Path) -> Result<Self, String> {
        let mut file = File::open(path).map_err(|error| read_error_text(&error))?;
        let metadata = ParquetMetaDataReader::new().parse_and_finish(&file);
        let metadata = metadata.map_err(|error| {
            format!("its footer cannot be read ({})", parquet_error_text(&error))
        })?;
        let notes = metadata
            .file_metadata()
            .key_value_metadata()
            .map(Vec::as_slice)
            .unwrap_or_default();
        let (Some(definition), Some(part)) = (
            note::<SweepDefinition>(notes, DEFINITION_KEY),
            note::<Part>(notes, PART),
        ) else {
            return Err("it is not a part of a sweep of longdrive".into());
        };
        let (bytes, data) = lengths(&mut file).map_err(|error| read_error_text(&error))?;
        let rows: i64 = metadata
            .row_groups()
            .iter()
            .map(|group| group.num_rows())
            .sum();
        let ends = metadata
            .row_groups()
            .iter()
            .flat_map(|group| group.columns())
            .map(|column| {
                let (at, length) = column.byte_range();
                at + length
            });
        if part.question != definition.hash()
            || u64::try_from(rows) != Ok(part.rows)
            || ends.max() != Some(data)
        {
            return Err("its rows do not match its footer".into());
        }
        Ok(Self {
            definition,
            part,
            bytes,
            data,
        })
    }

    /// The manifest of the file. Reads and hashes the whole file.
    pub fn manifest(self, path: &Path) -> Result<Manifest, String> {
        let unreadable = |error: io::Error| read_error_text(&error);
        let file = File::open(path).map_err(unreadable)?;
        let mut hash = Sha256::default();
        add(&mut hash, (&file).take(self.data)).map_err(unreadable)?;
        let of_rows = hex(hash.clone());
        add(&mut hash, &file).map_err(unreadable)?;
        if of_rows != self.part.data {
            return Err(
                "its rows have changed: their SHA-256 differs from the SHA-256 in its footer"
                    .into(),
            );
        }
        let name = path
            .file_name()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        Ok(Manifest {
            file: name,
            bytes: self.bytes,
            sha256: hex(hash),
            part: self.part,
        })
    }
}

/// Adds all bytes of a source to a hash.
fn add(hash: &mut Sha256, source: impl Read) -> io::Result<()> {
    let mut source = BufReader::with_capacity(1 << 20, source);
    loop {
        let bytes = source.fill_buf()?;
        if bytes.is_empty() {
            return Ok(());
        }
        hash.update(bytes);
        let read = bytes.len();
        source.consume(read);
    }
}

fn note<T: for<'de> Deserialize<'de>>(notes: &[KeyValue], key: &str) -> Option<T> {
    let note = notes.iter().find(|note| note.key == key)?;
    serde_json::from_str(note.value.as_deref()?).ok()
}

/// Size of a file, and number of bytes before its footer. A Parquet file ends with the length of
/// the footer (four bytes) and the magic number (four bytes).
fn lengths(file: &mut File) -> io::Result<(u64, u64)> {
    let mut tail = [0; 4];
    let bytes = file.seek(SeekFrom::End(0))?;
    file.seek(SeekFrom::Start(bytes.saturating_sub(8)))?;
    file.read_exact(&mut tail)?;
    Ok((
        bytes,
        bytes.saturating_sub(8 + u64::from(u32::from_le_bytes(tail))),
    ))
}
