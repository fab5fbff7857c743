//! Tables of typed columns as Parquet, a row group at a time.

use crate::error::{Error, Result};
use parquet::basic::{Encoding, LogicalType, Repetition, Type as Physical};
use parquet::column::writer::ColumnWriter;
use parquet::data_type::ByteArray;
use parquet::errors::ParquetError;
use parquet::file::metadata::{
    FileMetaData, KeyValue, ParquetMetaData, ParquetMetaDataReader, ParquetMetaDataWriter,
    RowGroupMetaData,
};
use parquet::file::properties::{EnabledStatistics, WriterProperties, WriterPropertiesPtr};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::{ColumnPath, Type, TypePtr};
use std::sync::Arc;

const MAGIC: &[u8] = b"PAR1";
/// The length of the metadata and the magic number end a file.
const TAIL: usize = 8;
/// Most bytes of the distinct values of a column that are kept once instead of in every row.
const MOST_DISTINCT: usize = 64 << 10;

/// The type of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A number in every row; few distinct ones are kept once.
    Number,
    /// A number or none.
    SomeNumber,
    /// A text in every row.
    Text,
    /// A text or none.
    SomeText,
}

/// The values of a column in the rows of a group.
pub(super) enum Cells {
    Numbers(Vec<f64>),
    SomeNumbers(Vec<Option<f64>>),
    Texts(Vec<ByteArray>),
    SomeTexts(Vec<Option<ByteArray>>),
}

/// A table. Row groups are made one at a time, each as a file of its own in memory. What a file of
/// many needs is its [`head`](Self::head), the groups' bytes one after the other, and a
/// [`foot`](Self::foot) made of the groups' metadata: so a file can be gone on with after any of
/// its groups.
pub(super) struct ParquetTable {
    schema: TypePtr,
    properties: WriterPropertiesPtr,
    notes: Vec<KeyValue>,
}

/// A row group by itself.
#[derive(Clone, Debug)]
pub struct ParquetGroup {
    /// Its columns.
    pub bytes: Vec<u8>,
    /// The footer that the column would have as a file of its own.
    pub metadata: Vec<u8>,
}

/// A row group in its place in a file.
#[derive(Clone, Debug)]
pub struct PlacedGroup(RowGroupMetaData);

/// Nothing of ours is what Parquet cannot hold: only what a journal kept of a row group can be
/// wrong.
fn failed(_: ParquetError) -> Error {
    let reason = "its record of a row group of the Parquet file is damaged; start the sweep again \
                  with `overwrite`";
    Error::Output(std::io::Error::other(reason))
}

impl ParquetTable {
    /// A table of these columns; `question` is kept in the file under the key `longdrive`.
    ///
    /// # Errors
    /// [`Error::Output`] for columns that Parquet cannot have.
    pub fn new(name: &str, columns: &[(String, Kind)], question: &str) -> Result<Self> {
        // without page indexes nothing in a file's foot depends on where it stands
        let mut properties = WriterProperties::builder()
            .set_created_by(concat!("longdrive ", env!("CARGO_PKG_VERSION")).into())
            .set_statistics_enabled(EnabledStatistics::Chunk)
            .set_offset_index_disabled(true)
            .set_dictionary_enabled(true)
            .set_dictionary_page_size_limit(MOST_DISTINCT);
        let mut fields = vec![];
        for (name, kind) in columns {
            let repetition = match kind {
                Kind::Number | Kind::Text => Repetition::REQUIRED,
                Kind::SomeNumber | Kind::SomeText => Repetition::OPTIONAL,
            };
            let field = match kind {
                Kind::Number | Kind::SomeNumber => {
                    Type::primitive_type_builder(name, Physical::DOUBLE)
                }
                Kind::Text | Kind::SomeText => {
                    Type::primitive_type_builder(name, Physical::BYTE_ARRAY)
                        .with_logical_type(Some(LogicalType::String))
                }
            };
            fields.push(Arc::new(
                field.with_repetition(repetition).build().map_err(failed)?,
            ));
            if *kind == Kind::SomeNumber {
                let path = ColumnPath::from(name.as_str());
                properties = properties.set_column_dictionary_enabled(path.clone(), false);
                properties = properties.set_column_encoding(path, Encoding::PLAIN);
            }
        }
        let schema = Type::group_type_builder(name)
            .with_fields(fields)
            .build()
            .map_err(failed)?;
        Ok(Self {
            schema: Arc::new(schema),
            properties: Arc::new(properties.build()),
            notes: vec![KeyValue::new("longdrive".into(), question.to_owned())],
        })
    }

    /// The first bytes of a file.
    pub fn head(&self) -> Vec<u8> {
        MAGIC.to_vec()
    }

    /// The row group of these columns, by their numbers.
    ///
    /// # Errors
    /// [`Error::Output`] where Parquet cannot hold it.
    pub fn group(&self, cells: impl FnMut(usize) -> Cells) -> Result<ParquetGroup> {
        let mut file = self.write(Some(cells)).map_err(failed)?;
        let metadata = metadata_of(&file);
        file.truncate(file.len() - TAIL - metadata.len());
        Ok(ParquetGroup {
            bytes: file.split_off(MAGIC.len()),
            metadata,
        })
    }

    /// A file of one row group, or of none.
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
                (ColumnWriter::DoubleColumnWriter(writer), Cells::Numbers(values)) => {
                    writer.write_batch(&values, None, None)?;
                }
                (ColumnWriter::DoubleColumnWriter(writer), Cells::SomeNumbers(values)) => {
                    let (values, levels) = present(values);
                    writer.write_batch(&values, Some(&levels), None)?;
                }
                (ColumnWriter::ByteArrayColumnWriter(writer), Cells::Texts(values)) => {
                    writer.write_batch(&values, None, None)?;
                }
                (ColumnWriter::ByteArrayColumnWriter(writer), Cells::SomeTexts(values)) => {
                    let (values, levels) = present(values);
                    writer.write_batch(&values, Some(&levels), None)?;
                }
                _ => {
                    return Err(ParquetError::General(format!(
                        "column {number} is of no kind that was asked for"
                    )));
                }
            }
            column.close()?;
            number += 1;
        }
        group.close()?;
        file.into_inner()
    }

    /// A row group, given by its metadata, in its place: after `at` bytes of the file, as group
    /// number `ordinal`.
    ///
    /// # Errors
    /// [`Error::Output`] for metadata of something else.
    pub fn place(&self, metadata: &[u8], at: u64, ordinal: usize) -> Result<PlacedGroup> {
        let place = || {
            let alone = ParquetMetaDataReader::decode_metadata(metadata)?;
            let group = alone.row_groups().first().cloned();
            let group = group
                .ok_or_else(|| ParquetError::General("metadata without a row group".into()))?;
            let by = at as i64 - MAGIC.len() as i64;
            let columns = group.columns().iter().cloned().map(|column| {
                let (data, dictionary) =
                    (column.data_page_offset(), column.dictionary_page_offset());
                let moved = column.into_builder().set_data_page_offset(data + by);
                moved
                    .set_dictionary_page_offset(dictionary.map(|offset| offset + by))
                    .build()
            });
            let columns = columns.collect::<Result<_, _>>()?;
            let placed = group.into_builder().set_column_metadata(columns);
            placed
                .set_ordinal(ordinal as i32)
                .set_file_offset(at as i64)
                .build()
        };
        place().map(PlacedGroup).map_err(failed)
    }

    /// The last bytes of a file of these row groups, with further notes, by their keys.
    ///
    /// # Errors
    /// [`Error::Output`] where Parquet cannot hold them.
    pub fn foot(&self, groups: &[PlacedGroup], notes: &[(&str, String)]) -> Result<Vec<u8>> {
        let foot = || {
            let none: Option<fn(usize) -> Cells> = None;
            let like = ParquetMetaDataReader::decode_metadata(&metadata_of(&self.write(none)?))?;
            let like = like.file_metadata();
            let rows = groups.iter().map(|group| group.0.num_rows()).sum();
            let further = notes
                .iter()
                .map(|(key, note)| KeyValue::new((*key).to_owned(), note.clone()));
            let file = FileMetaData::new(
                like.version(),
                rows,
                like.created_by().map(str::to_owned),
                Some(self.notes.iter().cloned().chain(further).collect()),
                like.schema_descr_ptr(),
                like.column_orders().cloned(),
            );
            let metadata =
                ParquetMetaData::new(file, groups.iter().map(|group| group.0.clone()).collect());
            let mut bytes = Vec::new();
            ParquetMetaDataWriter::new(&mut bytes, &metadata).finish()?;
            Ok(bytes)
        };
        foot().map_err(failed)
    }
}

/// The values that are there, and for each row whether one is.
fn present<T>(cells: Vec<Option<T>>) -> (Vec<T>, Vec<i16>) {
    let levels = cells.iter().map(|cell| i16::from(cell.is_some())).collect();
    (cells.into_iter().flatten().collect(), levels)
}

/// The metadata at the end of a file. Four of the last eight bytes state their length.
fn metadata_of(file: &[u8]) -> Vec<u8> {
    let end = file.len() - TAIL;
    let length = file[end..end + 4]
        .iter()
        .rev()
        .fold(0, |length, byte| length << 8 | usize::from(*byte));
    file[end - length..end].to_vec()
}
