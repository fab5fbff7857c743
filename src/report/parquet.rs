//! Tables of typed columns as Parquet, written one row group at a time.

use crate::error::{Error, Result};
use crate::external_errors::parquet_error_text;
use parquet::basic::{Encoding, LogicalType, Repetition, Type as Physical};
use parquet::column::writer::ColumnWriter;
use parquet::data_type::ByteArray;
use parquet::errors::ParquetError;
use parquet::file::metadata::{
    ColumnChunkMetaData, FileMetaData, KeyValue, ParquetMetaData, ParquetMetaDataReader,
    ParquetMetaDataWriter, RowGroupMetaData,
};
use parquet::file::properties::{EnabledStatistics, WriterProperties, WriterPropertiesPtr};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::{ColumnPath, Type, TypePtr};
use std::sync::Arc;

/// The first bytes of a Parquet file.
pub const PARQUET_MAGIC: &[u8] = b"PAR1";
/// Bytes after the metadata at the end of a file: the length of the metadata and the magic number.
const TAIL: usize = 8;
/// Maximum size of a column's dictionary, bytes. A column that needs a larger dictionary is stored
/// plain.
const LARGEST_DICTIONARY: usize = 64 << 10;

/// The type of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ColumnType {
    /// A number in every row, dictionary-encoded if few values are distinct.
    Number,
    /// A number or null.
    SomeNumber,
    /// A number or null, dictionary-encoded if few values are distinct.
    SomeRepeatedNumber,
    /// A text in every row.
    Text,
    /// A text or null.
    SomeText,
}

/// The cells of a column in a row group. `None` is null, which only optional columns contain.
pub(super) enum Cells {
    Numbers(Vec<Option<f64>>),
    Texts(Vec<Option<ByteArray>>),
}

/// A table. Each row group is first written as a file of its own in memory. The whole file consists
/// of `PARQUET_MAGIC`, the bytes of all groups, and a [`footer`](Self::footer) made from the
/// metadata of the groups. Interrupted writing can therefore continue after any group.
pub(super) struct ParquetTable {
    schema: TypePtr,
    properties: WriterPropertiesPtr,
    metadata: Vec<KeyValue>,
}

/// A row group before it has a place in a file.
#[derive(Clone, Debug)]
pub struct ParquetGroup {
    /// The bytes of the columns.
    pub bytes: Vec<u8>,
    /// The footer of a file that contains only this row group.
    pub metadata: Vec<u8>,
}

/// The row groups of a file, in order.
#[derive(Clone, Debug, Default)]
pub struct RowGroups(Vec<RowGroupMetaData>);

impl RowGroups {
    /// Adds the row group that `metadata` describes, after the last row group.
    ///
    /// # Errors
    /// [`Error::Output`] if `metadata` is not the metadata of a row group.
    pub fn add(&mut self, metadata: &[u8]) -> Result<()> {
        let placed = self.placed(metadata).map_err(|_| {
            let reason = "the metadata of a row group of the Parquet file is damaged";
            Error::Output(std::io::Error::other(reason))
        })?;
        self.0.push(placed);
        Ok(())
    }

    /// Removes the last row group.
    pub fn remove_last(&mut self) {
        self.0.pop();
    }

    /// The row group that `metadata` describes, with its place after the last row group.
    fn placed(&self, metadata: &[u8]) -> Result<RowGroupMetaData, ParquetError> {
        let alone = ParquetMetaDataReader::decode_metadata(metadata)?;
        let Some(group) = alone.row_groups().first().cloned() else {
            return Err(ParquetError::General("metadata without a row group".into()));
        };
        // `byte_range` asserts positive numbers, and sums of greater numbers would overflow
        let is_valid = |column: &ColumnChunkMetaData| {
            let dictionary = column.dictionary_page_offset().unwrap_or(0);
            let numbers = [
                dictionary,
                column.data_page_offset(),
                column.compressed_size(),
            ];
            numbers.iter().all(|number| (0..1 << 60).contains(number))
        };
        if !group.columns().iter().all(is_valid) {
            return Err(ParquetError::General(
                "an offset or length out of range".into(),
            ));
        }
        let at = self.end();
        let by = at - PARQUET_MAGIC.len() as i64;
        let columns = group.columns().iter().cloned().map(|column| {
            let (data, dictionary) = (column.data_page_offset(), column.dictionary_page_offset());
            let moved = column.into_builder().set_data_page_offset(data + by);
            moved
                .set_dictionary_page_offset(dictionary.map(|offset| offset + by))
                .build()
        });
        let columns = columns.collect::<Result<_, _>>()?;
        let placed = group.into_builder().set_column_metadata(columns);
        placed
            .set_ordinal(self.0.len() as i32)
            .set_file_offset(at)
            .build()
    }

    /// Offset of the next row group in the file, bytes.
    pub fn end(&self) -> i64 {
        let columns = self.0.last().map(RowGroupMetaData::columns);
        let ends = columns.into_iter().flatten().map(|column| {
            let (at, length) = column.byte_range();
            (at + length) as i64
        });
        ends.max().unwrap_or(PARQUET_MAGIC.len() as i64)
    }
}

/// The error if Parquet does not allow the columns or the values of a table.
fn refused(error: ParquetError) -> Error {
    let reason = format!(
        "Parquet does not allow the table: {}",
        parquet_error_text(&error)
    );
    Error::Output(std::io::Error::other(reason))
}

/// Key under which the metadata of a file has the definition of its sweep.
pub(crate) const DEFINITION_KEY: &str = "longdrive";

impl ParquetTable {
    /// A table of these columns. `definition` describes the request; the file stores it under the
    /// key [`DEFINITION_KEY`].
    ///
    /// # Errors
    /// [`Error::Output`] if Parquet does not allow `columns`.
    pub fn new(name: &str, columns: &[(String, ColumnType)], definition: &str) -> Result<Self> {
        // write no page index: `RowGroups::add` would have to change each position in it
        let mut properties = WriterProperties::builder()
            .set_created_by(concat!("longdrive ", env!("CARGO_PKG_VERSION")).into())
            .set_statistics_enabled(EnabledStatistics::Chunk)
            .set_offset_index_disabled(true)
            .set_dictionary_enabled(true)
            .set_dictionary_page_size_limit(LARGEST_DICTIONARY);
        let mut fields = vec![];
        for (name, kind) in columns {
            let repetition = match kind {
                ColumnType::Number | ColumnType::Text => Repetition::REQUIRED,
                ColumnType::SomeNumber | ColumnType::SomeRepeatedNumber | ColumnType::SomeText => {
                    Repetition::OPTIONAL
                }
            };
            let field = match kind {
                ColumnType::Number | ColumnType::SomeNumber | ColumnType::SomeRepeatedNumber => {
                    Type::primitive_type_builder(name, Physical::DOUBLE)
                }
                ColumnType::Text | ColumnType::SomeText => {
                    Type::primitive_type_builder(name, Physical::BYTE_ARRAY)
                        .with_logical_type(Some(LogicalType::String))
                }
            };
            fields.push(Arc::new(
                field.with_repetition(repetition).build().map_err(refused)?,
            ));
            if *kind == ColumnType::SomeNumber {
                let path = ColumnPath::from(name.as_str());
                properties = properties.set_column_dictionary_enabled(path.clone(), false);
                properties = properties.set_column_encoding(path, Encoding::PLAIN);
            }
        }
        let schema = Type::group_type_builder(name)
            .with_fields(fields)
            .build()
            .map_err(refused)?;
        Ok(Self {
            schema: Arc::new(schema),
            properties: Arc::new(properties.build()),
            metadata: vec![KeyValue::new(DEFINITION_KEY.into(), definition.to_owned())],
        })
    }

    /// The row group of these cells; `cells(i)` are the values of column `i`.
    ///
    /// # Errors
    /// [`Error::Output`] if Parquet does not allow a value of `cells`.
    pub fn group(&self, cells: impl FnMut(usize) -> Cells) -> Result<ParquetGroup> {
        let mut file = self.write(Some(cells)).map_err(refused)?;
        let metadata = metadata_of(&file);
        file.truncate(file.len() - TAIL - metadata.len());
        Ok(ParquetGroup {
            bytes: file.split_off(PARQUET_MAGIC.len()),
            metadata,
        })
    }

    /// A file with one row group of these cells; without `cells`, a file without row groups.
    fn write(&self, cells: Option<impl FnMut(usize) -> Cells>) -> Result<Vec<u8>, ParquetError> {
        let mut file =
            SerializedFileWriter::new(Vec::new(), self.schema.clone(), self.properties.clone())?;
        let Some(mut cells) = cells else {
            return file.into_inner();
        };
        let mut group = file.next_row_group()?;
        let mut number = 0;
        while let Some(mut column) = group.next_column()? {
            match (column.untyped(), cells(number)) {
                (ColumnWriter::DoubleColumnWriter(writer), Cells::Numbers(cells)) => {
                    let (values, levels) = present(cells);
                    writer.write_batch(&values, Some(&levels), None)?;
                }
                (ColumnWriter::ByteArrayColumnWriter(writer), Cells::Texts(cells)) => {
                    let (values, levels) = present(cells);
                    writer.write_batch(&values, Some(&levels), None)?;
                }
                _ => {
                    return Err(ParquetError::General(format!(
                        "the values of column {number} do not have the type of the column"
                    )));
                }
            }
            column.close()?;
            number += 1;
        }
        group.close()?;
        file.into_inner()
    }

    /// The footer of a file with these row groups. `metadata` is added to the key-value metadata of
    /// the table.
    ///
    /// # Errors
    /// [`Error::Output`] if Parquet does not allow `groups` or `metadata`.
    pub fn footer(&self, groups: &RowGroups, metadata: &[(&str, String)]) -> Result<Vec<u8>> {
        let footer = || {
            let none: Option<fn(usize) -> Cells> = None;
            let like = ParquetMetaDataReader::decode_metadata(&metadata_of(&self.write(none)?))?;
            let like = like.file_metadata();
            let rows = groups.0.iter().map(RowGroupMetaData::num_rows).sum();
            let further = metadata
                .iter()
                .map(|(key, value)| KeyValue::new((*key).to_owned(), value.clone()));
            let file = FileMetaData::new(
                like.version(),
                rows,
                like.created_by().map(str::to_owned),
                Some(self.metadata.iter().cloned().chain(further).collect()),
                like.schema_descr_ptr(),
                like.column_orders().cloned(),
            );
            let metadata = ParquetMetaData::new(file, groups.0.clone());
            let mut bytes = Vec::new();
            ParquetMetaDataWriter::new(&mut bytes, &metadata).finish()?;
            Ok(bytes)
        };
        footer().map_err(refused)
    }
}

/// The values that are not null, and the definition level of each row: 1 for a value, 0 for null.
/// The writer ignores the levels of a required column.
fn present<T>(cells: Vec<Option<T>>) -> (Vec<T>, Vec<i16>) {
    let levels = cells.iter().map(|cell| i16::from(cell.is_some())).collect();
    (cells.into_iter().flatten().collect(), levels)
}

/// The metadata of a file. Eight bytes follow the metadata; the first four of them are the length
/// of the metadata, little-endian.
fn metadata_of(file: &[u8]) -> Vec<u8> {
    let end = file.len() - TAIL;
    let length = file[end..end + 4]
        .iter()
        .rev()
        .fold(0, |length, byte| length << 8 | usize::from(*byte));
    file[end - length..end].to_vec()
}
