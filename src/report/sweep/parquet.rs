use super::{STATUS, parameter_names, result_names};
use crate::batch::{Batch, Block, CHUNK};
use crate::error::{Error, Result};
use parquet::basic::{Encoding, LogicalType, Repetition, Type as Physical};
use parquet::column::writer::ColumnWriter;
use parquet::data_type::ByteArray;
use parquet::errors::ParquetError;
use parquet::file::metadata::{
    FileMetaData, KeyValue, ParquetMetaData, ParquetMetaDataReader, ParquetMetaDataWriter, RowGroupMetaData,
};
use parquet::file::properties::{EnabledStatistics, WriterProperties, WriterPropertiesPtr};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::{ColumnPath, Type, TypePtr};
use std::sync::Arc;

const MAGIC: &[u8] = b"PAR1";
/// The length of the metadata and the magic number end a file.
const TAIL: usize = 8;
/// Rows of a row group, at most and, however wide the table, at least; and most bytes of its numbers in between.
const MOST_ROWS: usize = 128 * CHUNK;
const LEAST_ROWS: usize = 16 * CHUNK;
const MOST_BYTES: usize = 16 << 20;
/// Most bytes of the distinct values of a swept parameter that are kept once instead of in every row.
const MOST_DISTINCT: usize = 64 << 10;

/// A batch as Parquet: `DOUBLE` columns (required for the swept parameters, optional for the rest) and the status as a
/// string.
///
/// Row groups are made one at a time, each as a file of its own in memory. What a file of many needs is its
/// [`head`](Self::head), the groups' bytes one after the other, and a [`foot`](Self::foot) made of the groups'
/// metadata: so a file can be gone on with after any of its groups.
pub struct SweepParquet {
    schema: TypePtr,
    properties: WriterPropertiesPtr,
    notes: Vec<KeyValue>,
    parameters: usize,
    results: usize,
}

/// A row group by itself.
#[derive(Clone, Debug)]
pub struct ParquetGroup {
    /// Its columns.
    pub bytes: Vec<u8>,
    /// What a file's foot says about it, as if it stood alone in a file.
    pub metadata: Vec<u8>,
}

/// A row group in its place in a file.
#[derive(Clone, Debug)]
pub struct PlacedGroup(RowGroupMetaData);

/// Nothing of ours is what Parquet cannot hold: only what a journal kept of a row group can be wrong.
fn failed(_: ParquetError) -> Error {
    let reason = "its record of a row group of the Parquet file is damaged; start the sweep again with --overwrite";
    Error::Output(std::io::Error::other(reason))
}

impl SweepParquet {
    /// The table of a batch; `question` is kept in the file under the key `longdrive`.
    ///
    /// # Errors
    /// [`Error::Output`] for columns that Parquet cannot have.
    pub fn new(batch: &Batch, question: &str) -> Result<Self> {
        let (parameters, results) = (parameter_names(batch), result_names(batch));
        let number = |name: &str, repetition| {
            Type::primitive_type_builder(name, Physical::DOUBLE).with_repetition(repetition).build().map_err(failed)
        };
        let mut fields = vec![];
        for name in &parameters {
            fields.push(number(name, Repetition::REQUIRED)?);
        }
        let status = Type::primitive_type_builder(STATUS, Physical::BYTE_ARRAY).with_repetition(Repetition::REQUIRED);
        fields.push(status.with_logical_type(Some(LogicalType::String)).build().map_err(failed)?);
        for name in &results {
            fields.push(number(name, Repetition::OPTIONAL)?);
        }
        let fields = fields.into_iter().map(Arc::new).collect();
        let schema = Type::group_type_builder("drives").with_fields(fields).build().map_err(failed)?;
        // without page indexes nothing in a file's foot depends on where it stands
        let mut properties = WriterProperties::builder()
            .set_created_by(concat!("longdrive ", env!("CARGO_PKG_VERSION")).into())
            .set_statistics_enabled(EnabledStatistics::Chunk)
            .set_offset_index_disabled(true)
            .set_dictionary_enabled(true)
            .set_dictionary_page_size_limit(MOST_DISTINCT);
        for name in &results {
            let path = ColumnPath::from(name.as_str());
            properties = properties.set_column_dictionary_enabled(path.clone(), false);
            properties = properties.set_column_encoding(path, Encoding::PLAIN);
        }
        Ok(Self {
            schema: Arc::new(schema),
            properties: Arc::new(properties.build()),
            notes: vec![KeyValue::new("longdrive".into(), question.to_owned())],
            parameters: parameters.len(),
            results: results.len(),
        })
    }

    /// How many blocks of [`CHUNK`] rows make a row group: fewer for wide tables, so that a group has room in memory
    /// and little is computed again after a kill.
    pub fn blocks_of_group(&self) -> usize {
        let width = 9 * (self.parameters + self.results) + 1;
        (MOST_BYTES / width).clamp(LEAST_ROWS, MOST_ROWS) / CHUNK
    }

    /// The first bytes of a file.
    pub fn head(&self) -> Vec<u8> {
        MAGIC.to_vec()
    }

    /// The row group of some blocks.
    ///
    /// # Errors
    /// [`Error::Output`] where Parquet cannot hold it.
    pub fn group(&self, blocks: &[Block]) -> Result<ParquetGroup> {
        let mut file = self.write(Some(blocks)).map_err(failed)?;
        let metadata = metadata_of(&file);
        file.truncate(file.len() - TAIL - metadata.len());
        Ok(ParquetGroup { bytes: file.split_off(MAGIC.len()), metadata })
    }

    /// A file of one row group, or of none.
    fn write(&self, blocks: Option<&[Block]>) -> Result<Vec<u8>, ParquetError> {
        let mut file = SerializedFileWriter::new(Vec::new(), self.schema.clone(), self.properties.clone())?;
        let Some(blocks) = blocks else { return file.into_inner() };
        let rows: usize = blocks.iter().map(Block::rows).sum();
        let all = |block: &Block| 0..block.rows();
        let mut group = file.next_row_group()?;
        let mut number = 0;
        while let Some(mut column) = group.next_column()? {
            match column.untyped() {
                ColumnWriter::DoubleColumnWriter(writer) if number < self.parameters => {
                    let mut values = Vec::with_capacity(rows);
                    for block in blocks {
                        values.extend(all(block).map(|row| block.point(row)[number]));
                    }
                    writer.write_batch(&values, None, None)?;
                }
                ColumnWriter::DoubleColumnWriter(writer) => {
                    let (mut values, mut levels) = (Vec::with_capacity(rows), Vec::with_capacity(rows));
                    for value in blocks.iter().flat_map(|block| block.result(number - self.parameters - 1)) {
                        levels.push(i16::from(value.is_some()));
                        values.extend(value);
                    }
                    writer.write_batch(&values, Some(&levels), None)?;
                }
                ColumnWriter::ByteArrayColumnWriter(writer) => {
                    let status = |block: &Block, row| ByteArray::from(block.status(row).name());
                    let status = blocks.iter().flat_map(|block| all(block).map(move |row| status(block, row)));
                    writer.write_batch(&status.collect::<Vec<_>>(), None, None)?;
                }
                _ => return Err(ParquetError::General(format!("column {number} is of no kind that was asked for"))),
            }
            column.close()?;
            number += 1;
        }
        group.close()?;
        file.into_inner()
    }

    /// A row group, given by its metadata, in its place: after `at` bytes of the file, as group number `ordinal`.
    ///
    /// # Errors
    /// [`Error::Output`] for metadata of something else.
    pub fn place(&self, metadata: &[u8], at: u64, ordinal: usize) -> Result<PlacedGroup> {
        let place = || {
            let alone = ParquetMetaDataReader::decode_metadata(metadata)?;
            let group = alone.row_groups().first().cloned();
            let group = group.ok_or_else(|| ParquetError::General("metadata without a row group".into()))?;
            let by = at as i64 - MAGIC.len() as i64;
            let columns = group.columns().iter().cloned().map(|column| {
                let (data, dictionary) = (column.data_page_offset(), column.dictionary_page_offset());
                let moved = column.into_builder().set_data_page_offset(data + by);
                moved.set_dictionary_page_offset(dictionary.map(|offset| offset + by)).build()
            });
            let columns = columns.collect::<Result<_, _>>()?;
            let placed = group.into_builder().set_column_metadata(columns);
            placed.set_ordinal(ordinal as i32).set_file_offset(at as i64).build()
        };
        place().map(PlacedGroup).map_err(failed)
    }

    /// The last bytes of a file of these row groups.
    ///
    /// # Errors
    /// [`Error::Output`] where Parquet cannot hold them.
    pub fn foot(&self, groups: &[PlacedGroup]) -> Result<Vec<u8>> {
        let foot = || {
            let like = ParquetMetaDataReader::decode_metadata(&metadata_of(&self.write(None)?))?;
            let like = like.file_metadata();
            let rows = groups.iter().map(|group| group.0.num_rows()).sum();
            let file = FileMetaData::new(
                like.version(),
                rows,
                like.created_by().map(str::to_owned),
                Some(self.notes.clone()),
                like.schema_descr_ptr(),
                like.column_orders().cloned(),
            );
            let metadata = ParquetMetaData::new(file, groups.iter().map(|group| group.0.clone()).collect());
            let mut bytes = Vec::new();
            ParquetMetaDataWriter::new(&mut bytes, &metadata).finish()?;
            Ok(bytes)
        };
        foot().map_err(failed)
    }
}

/// The metadata at the end of a file: its length stands in four of the last eight bytes.
fn metadata_of(file: &[u8]) -> Vec<u8> {
    let end = file.len() - TAIL;
    let length = file[end..end + 4].iter().rev().fold(0, |length, byte| length << 8 | usize::from(*byte));
    file[end - length..end].to_vec()
}
