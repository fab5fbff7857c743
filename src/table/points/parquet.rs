use super::columnar::ColumnarFile;
use crate::external_errors::{parquet_error_text, read_error_text};
use crate::input_file::InputFile;
use bytes::Bytes;
use parquet::basic::{Compression, ConvertedType, LogicalType, Type};
use parquet::column::reader::ColumnReader;
use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::schema::types::{ColumnDescPtr, ColumnDescriptor};
use std::collections::BTreeMap;
use std::io::{Read, Seek, SeekFrom};
use std::ops::Range;
use std::path::Path;

/// Reads a Parquet file by row groups.
pub(super) struct ParquetFile {
    file: Box<dyn FileReader>,
    /// Number of row groups begun; the last of them is the current one.
    begun: usize,
    /// Open column readers of the current group, by column.
    columns: BTreeMap<usize, ColumnReader>,
}

impl ParquetFile {
    fn head(&self, column: usize) -> ColumnDescPtr {
        let metadata = self.file.metadata().file_metadata();
        metadata.schema_descr().column(column)
    }

    fn next(&mut self, column: usize, rows: usize) -> Result<Vec<Option<f64>>, ParquetError> {
        macro_rules! read {
            ($column:expr, $into:expr) => {{
                let (mut values, mut levels) = (Vec::with_capacity(rows), Vec::new());
                let mut read = 0;
                while read < rows {
                    let (records, _, _) =
                        $column.read_records(rows - read, Some(&mut levels), None, &mut values)?;
                    if records == 0 {
                        break;
                    }
                    read += records;
                }
                let mut present = values.into_iter().map($into);
                // a required column has no definition levels, and no value is missing
                match levels.is_empty() {
                    true => present.map(Some).collect(),
                    false => levels
                        .iter()
                        .map(|level| if *level > 0 { present.next() } else { None })
                        .collect(),
                }
            }};
        }
        if !self.columns.contains_key(&column) {
            let reader = self
                .file
                .get_row_group(self.begun - 1)?
                .get_column_reader(column)?;
            self.columns.insert(column, reader);
        }
        let integers = StoredIntegers::of(&self.head(column)).unwrap_or(StoredIntegers::Signed);
        Ok(match self.columns.get_mut(&column) {
            Some(ColumnReader::DoubleColumnReader(column)) => read!(column, |value| value),
            Some(ColumnReader::FloatColumnReader(column)) => read!(column, f64::from),
            Some(ColumnReader::Int32ColumnReader(column)) => {
                read!(column, |value| integers
                    .number(f64::from(value), f64::from(value.cast_unsigned())))
            }
            Some(ColumnReader::Int64ColumnReader(column)) => {
                read!(column, |value| integers
                    .number(value as f64, value.cast_unsigned() as f64))
            }
            _ => {
                return Err(ParquetError::General(
                    "it is not a column of numbers".into(),
                ));
            }
        })
    }
}

impl ColumnarFile for ParquetFile {
    fn open(path: &Path) -> Result<Self, String> {
        let file = reader(open_checked(path)?).map_err(|error| parquet_error_text(&error))?;
        Ok(Self {
            file,
            begun: 0,
            columns: BTreeMap::new(),
        })
    }

    fn names(&self) -> Vec<String> {
        let columns = self
            .file
            .metadata()
            .file_metadata()
            .schema_descr()
            .columns();
        columns.iter().map(|head| head.path().string()).collect()
    }

    fn refusal(&self, column: usize) -> Option<String> {
        let head = self.head(column);
        if head.max_rep_level() > 0 || head.max_def_level() > 1 {
            return Some("it is nested; a column must hold numbers".into());
        }
        if !is_number(&head) {
            return Some(format!(
                "its type is {}; a column must hold numbers (DOUBLE, FLOAT, integers, or DECIMAL \
                 stored as INT32 or INT64)",
                type_name(&head)
            ));
        }
        let row_groups = self.file.metadata().row_groups();
        let by = row_groups
            .iter()
            .find_map(|group| not_read(group.column(column).compression()))?;
        Some(format!(
            "it is compressed by {by}, which is not read here; write it uncompressed, or with \
             Snappy or ZSTD"
        ))
    }

    fn rewind(&mut self) {
        (self.begun, self.columns) = (0, BTreeMap::new());
    }

    fn next_piece(&mut self) -> Result<Option<usize>, String> {
        let Some(group) = self.file.metadata().row_groups().get(self.begun) else {
            return Ok(None);
        };
        let rows = usize::try_from(group.num_rows()).unwrap_or(0);
        (self.begun, self.columns) = (self.begun + 1, BTreeMap::new());
        Ok(Some(rows))
    }

    fn values(&mut self, column: usize, rows: Range<usize>) -> Result<Vec<Option<f64>>, String> {
        self.next(column, rows.len())
            .map_err(|error| parquet_error_text(&error))
    }
}

/// Meaning of the integers in a column.
#[derive(Clone, Copy)]
enum StoredIntegers {
    Signed,
    Unsigned,
    /// Decimal numbers: each is the integer divided by this power of 10.
    Decimal {
        divisor: f64,
    },
}

impl StoredIntegers {
    /// The meaning by the type of the column; `None` for dates, times and other types that are no
    /// numbers.
    fn of(head: &ColumnDescriptor) -> Option<Self> {
        let logical = head.logical_type_ref();
        // times in nanoseconds have no converted type
        if matches!(
            logical,
            Some(LogicalType::Time(_) | LogicalType::Timestamp(_))
        ) {
            return None;
        }
        match head.converted_type() {
            ConvertedType::NONE
            | ConvertedType::INT_8
            | ConvertedType::INT_16
            | ConvertedType::INT_32
            | ConvertedType::INT_64 => Some(Self::Signed),
            ConvertedType::UINT_8
            | ConvertedType::UINT_16
            | ConvertedType::UINT_32
            | ConvertedType::UINT_64 => Some(Self::Unsigned),
            // at most 18 digits: the power is exact
            ConvertedType::DECIMAL => Some(Self::Decimal {
                divisor: 10_f64.powi(head.type_scale()),
            }),
            _ => None,
        }
    }

    /// The number that a stored integer means, given its value as a signed and as an unsigned
    /// integer.
    fn number(self, signed: f64, unsigned: f64) -> f64 {
        match self {
            Self::Signed => signed,
            Self::Unsigned => unsigned,
            Self::Decimal { divisor } => signed / divisor,
        }
    }
}

fn is_number(head: &ColumnDescriptor) -> bool {
    match head.physical_type() {
        Type::DOUBLE | Type::FLOAT => true,
        Type::INT32 | Type::INT64 => StoredIntegers::of(head).is_some(),
        _ => false,
    }
}

/// Name of a column's type, for messages.
fn type_name(head: &ColumnDescriptor) -> String {
    match (head.logical_type_ref(), head.converted_type()) {
        (Some(LogicalType::Time(_)), _) => "TIME".into(),
        (Some(LogicalType::Timestamp(_)), _) => "TIMESTAMP".into(),
        (_, ConvertedType::DECIMAL) => format!(
            "DECIMAL of {} digits stored as {}",
            head.type_precision(),
            head.physical_type()
        ),
        (_, ConvertedType::NONE) => head.physical_type().to_string(),
        (_, converted) => converted.to_string(),
    }
}

fn reader(file: InputFile) -> Result<Box<dyn FileReader>, ParquetError> {
    Ok(match file {
        InputFile::Disk(file) => Box::new(SerializedFileReader::new(file)?),
        InputFile::Memory(content) => {
            let content = Bytes::from_owner(content.into_inner());
            Box::new(SerializedFileReader::new(content)?)
        }
    })
}

/// Opens a file and checks the first and last bytes of the Parquet format.
fn open_checked(path: &Path) -> Result<InputFile, String> {
    const MAGIC: &[u8; 4] = b"PAR1";
    const ENCRYPTED: &[u8; 4] = b"PARE";
    let unreadable = |error: std::io::Error| read_error_text(&error);
    let mut file = InputFile::open(path).map_err(unreadable)?;
    let mut begins = vec![];
    file.by_ref()
        .take(4)
        .read_to_end(&mut begins)
        .map_err(unreadable)?;
    if begins.is_empty() {
        return Err("it is empty".into());
    }
    if begins == ENCRYPTED {
        return Err("it is encrypted; write it without encryption".into());
    }
    if begins != MAGIC {
        return Err(
            "it is not a Parquet file; its name must end in its format: .parquet, .csv, .arrow, \
             .arrows or .feather"
                .into(),
        );
    }
    let mut ends = [0; 4];
    let length = file.seek(SeekFrom::End(0)).map_err(unreadable)?;
    file.seek(SeekFrom::Start(length.saturating_sub(4)))
        .map_err(unreadable)?;
    file.read_exact(&mut ends).map_err(unreadable)?;
    if length < 12 || ends != *MAGIC {
        return Err(
            "it has no footer: it was cut short, or the program that wrote it did not close it"
                .into(),
        );
    }
    file.rewind().map_err(unreadable)?;
    Ok(file)
}

/// Name of a compression that is not supported; `None` for a supported compression.
fn not_read(compression: Compression) -> Option<&'static str> {
    match compression {
        Compression::UNCOMPRESSED | Compression::SNAPPY | Compression::ZSTD(_) => None,
        Compression::GZIP(_) => Some("GZIP"),
        Compression::BROTLI(_) => Some("Brotli"),
        Compression::LZ4 | Compression::LZ4_RAW => Some("LZ4"),
        Compression::LZO => Some("LZO"),
    }
}
