use super::columns::{Columns, columns_in_si, refused, wrong_value};
use super::fingerprint::Fingerprint;
use crate::batch::points::Points;
use crate::error::Result;
use crate::foreign::{of_io, of_parquet};
use crate::parameters::{Parameter, Setup};
use crate::units::Message;
use parquet::basic::{Compression, Type};
use parquet::column::reader::ColumnReader;
use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader, SerializedFileReader};
use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

/// Points in a Parquet file: columns of numbers, SI, named by parameters. It is read a row group at a time.
pub struct ParquetTable {
    path: PathBuf,
    file: SerializedFileReader<File>,
    read: Columns,
    notes: Vec<Message>,
    rows: u64,
    fingerprint: Fingerprint,
    /// The row group that is read next.
    group: usize,
    /// Where the columns of the one being read stand, and how many of its rows are left.
    columns: Vec<ColumnReader>,
    left: usize,
    next: u64,
}

impl ParquetTable {
    /// The table in a file. All of it is read once, so that a value that is missing is told before any work.
    ///
    /// # Errors
    /// [`Error::Table`](crate::Error::Table) for a file that cannot be read, a column that is no parameter, given
    /// twice or not of numbers, and a missing value.
    pub fn open(setup: &Setup<f64>, path: &Path) -> Result<Self> {
        let opened = whole(path).map_err(|reason| refused(path, String::new(), reason))?;
        let file = SerializedFileReader::new(opened);
        let file = file.map_err(|error| refused(path, String::new(), of_parquet(&error)))?;
        let schema = file.metadata().file_metadata().schema_descr_ptr();
        let names: Vec<String> = schema.columns().iter().map(|head| head.path().string()).collect();
        let (read, notes) = columns_in_si(setup, path, &names)?;
        for at in &read.at {
            let (head, name) = (schema.column(*at), &names[*at]);
            if head.max_rep_level() > 0 || head.max_def_level() > 1 {
                return Err(refused(path, format!(", column {name}"), "it is nested; a column must hold numbers"));
            }
            let kind = head.physical_type();
            if !matches!(kind, Type::DOUBLE | Type::FLOAT | Type::INT32 | Type::INT64) {
                let reason = format!("its type is {kind}; a column must hold numbers (DOUBLE, FLOAT, INT32 or INT64)");
                return Err(refused(path, format!(", column {name}"), reason));
            }
            let chunks = file.metadata().row_groups().iter().map(|group| group.column(*at));
            if let Some(by) = chunks.filter_map(|chunk| not_read(chunk.compression())).next() {
                let reason = format!(
                    "it is compressed by {by}, which is not read here; write it uncompressed, or with Snappy or ZSTD"
                );
                return Err(refused(path, format!(", column {name}"), reason));
            }
        }
        let (path, columns, fingerprint) = (path.to_owned(), vec![], Fingerprint::new());
        let mut table = Self { path, file, read, notes, rows: 0, fingerprint, group: 0, columns, left: 0, next: 0 };
        (table.rows, table.fingerprint) = Fingerprint::of(&mut table)?;
        table.seek(0)?;
        Ok(table)
    }

    fn unreadable(&self, error: ParquetError) -> crate::Error {
        refused(&self.path, format!(", after row {}", self.next), of_parquet(&error))
    }

    /// Begins row groups until one has rows left; false at the end.
    fn open_group(&mut self) -> Result<bool> {
        while self.left == 0 {
            if self.group == self.file.num_row_groups() {
                return Ok(false);
            }
            let group = self.file.get_row_group(self.group).map_err(|error| self.unreadable(error))?;
            let columns = self.read.at.iter().map(|at| group.get_column_reader(*at));
            self.columns = columns.collect::<Result<_, _>>().map_err(|error| self.unreadable(error))?;
            self.left = group.metadata().num_rows().max(0) as usize;
            self.group += 1;
        }
        Ok(true)
    }
}

/// The file, where its first and last bytes are those of a Parquet file; or what is wrong with it.
fn whole(path: &Path) -> Result<File, String> {
    const MAGIC: &[u8; 4] = b"PAR1";
    const ENCRYPTED: &[u8; 4] = b"PARE";
    let unreadable = |error: std::io::Error| of_io(&error);
    let mut file = File::open(path).map_err(unreadable)?;
    let mut begins = vec![];
    file.by_ref().take(4).read_to_end(&mut begins).map_err(unreadable)?;
    if begins.is_empty() {
        return Err("it is empty".into());
    }
    if begins == ENCRYPTED {
        return Err("it is encrypted; write it without encryption".into());
    }
    if begins != MAGIC {
        return Err(
            "it is not a Parquet file; its name must end in what it is: .parquet, .csv, .arrow, .arrows or .feather"
                .into(),
        );
    }
    let mut ends = [0; 4];
    let length = file.seek(SeekFrom::End(0)).map_err(unreadable)?;
    file.seek(SeekFrom::Start(length.saturating_sub(4))).map_err(unreadable)?;
    file.read_exact(&mut ends).map_err(unreadable)?;
    if length < 12 || ends != *MAGIC {
        return Err("it has no footer: it was cut short, or the program that wrote it did not close it".into());
    }
    file.rewind().map_err(unreadable)?;
    Ok(file)
}

/// The name of a compression that this program does not read.
fn not_read(compression: Compression) -> Option<&'static str> {
    match compression {
        Compression::UNCOMPRESSED | Compression::SNAPPY | Compression::ZSTD(_) => None,
        Compression::GZIP(_) => Some("GZIP"),
        Compression::BROTLI(_) => Some("Brotli"),
        Compression::LZ4 | Compression::LZ4_RAW => Some("LZ4"),
        Compression::LZO => Some("LZO"),
    }
}

/// The next values of a column.
fn values(column: &mut ColumnReader, rows: usize) -> Result<Vec<Option<f64>>, ParquetError> {
    macro_rules! read {
        ($column:expr, $into:expr) => {{
            let (mut values, mut levels) = (Vec::with_capacity(rows), Vec::new());
            let mut read = 0;
            while read < rows {
                let (records, _, _) = $column.read_records(rows - read, Some(&mut levels), None, &mut values)?;
                if records == 0 {
                    break;
                }
                read += records;
            }
            let mut present = values.into_iter().map($into);
            // a column of which every value must be there has no levels
            match levels.is_empty() {
                true => present.map(Some).collect(),
                false => levels.iter().map(|level| if *level > 0 { present.next() } else { None }).collect(),
            }
        }};
    }
    Ok(match column {
        ColumnReader::DoubleColumnReader(column) => read!(column, |value| value),
        ColumnReader::FloatColumnReader(column) => read!(column, f64::from),
        ColumnReader::Int32ColumnReader(column) => read!(column, f64::from),
        ColumnReader::Int64ColumnReader(column) => read!(column, |value| value as f64),
        _ => return Err(ParquetError::General("it is not a column of numbers".into())),
    })
}

impl Points for ParquetTable {
    fn parameters(&self) -> &[&'static Parameter] {
        &self.read.parameters
    }

    fn notes(&self) -> Vec<Message> {
        self.notes.clone()
    }

    fn rows(&self) -> u64 {
        self.rows
    }

    fn seek(&mut self, row: u64) -> Result<()> {
        (self.group, self.left, self.next) = (0, 0, 0);
        let mut passed = vec![];
        while self.next < row {
            let most = (row - self.next).min(super::super::CHUNK as u64) as usize;
            passed.clear();
            if self.read(most, &mut passed)? == 0 {
                break;
            }
        }
        Ok(())
    }

    fn read(&mut self, most: usize, into: &mut Vec<f64>) -> Result<usize> {
        let width = self.read.parameters.len();
        let mut rows = 0;
        // a chunk may reach over the end of a row group
        while rows < most && self.open_group()? {
            let wanted = self.left.min(most - rows);
            let first = into.len();
            into.resize(first + wanted * width, 0.0);
            for (i, parameter) in self.read.parameters.iter().enumerate() {
                let column = values(&mut self.columns[i], wanted).map_err(|error| {
                    let rows = format!(", rows {} to {}", self.next + 1, self.next + wanted as u64);
                    refused(&self.path, format!("{rows}, column {}", parameter.name), of_parquet(&error))
                })?;
                // what a damaged file leaves out is missing too
                let column = column.into_iter().chain(std::iter::repeat(None)).take(wanted);
                for (row, value) in column.enumerate() {
                    if let Some(wrong) = wrong_value(parameter, value) {
                        let place = format!(", row {}, column {}", self.next + row as u64 + 1, parameter.name);
                        return Err(refused(&self.path, place, wrong));
                    }
                    into[first + row * width + i] = value.unwrap_or_default();
                }
            }
            self.left -= wanted;
            self.next += wanted as u64;
            rows += wanted;
        }
        Ok(rows)
    }

    fn identity(&self) -> String {
        self.fingerprint.identity(self)
    }
}
