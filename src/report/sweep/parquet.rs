use super::{STATUS, column_counts, expect_columns};
use crate::batch::{Batch, Block, CHUNK};
use crate::error::Result;
use crate::report::parquet::{Cells, ColumnType, ParquetGroup, ParquetTable, RowGroups};
use parquet::data_type::ByteArray;

/// Maximum number of rows in a row group.
const MOST_ROWS: usize = 128 * CHUNK;
/// Minimum number of rows in a row group. It takes precedence over `MOST_BYTES`.
const LEAST_ROWS: usize = 16 * CHUNK;
/// Maximum size of the numbers in a row group, bytes.
const MOST_BYTES: usize = 16 << 20;

/// A batch as Parquet: optional `DOUBLE` columns, and the status as a required string.
///
/// Row groups are created one at a time. A file with many row groups consists of
/// [`PARQUET_MAGIC`](crate::report::PARQUET_MAGIC), the bytes of the groups, and a
/// [`footer`](Self::footer) made from the metadata of the groups. An interrupted file can therefore
/// continue after any of its groups.
pub struct SweepParquet {
    table: ParquetTable,
    /// Number of parameters, outcomes and derivatives.
    columns: [usize; 3],
}

impl SweepParquet {
    /// The table of a batch. `definition` is a text that describes the request; the file stores it
    /// under the key `longdrive`.
    ///
    /// # Errors
    /// [`Error::Output`](crate::Error::Output) if Parquet does not allow the columns of the batch.
    pub fn new(batch: &Batch, definition: &str) -> Result<Self> {
        let results = batch.columns();
        let columns = batch
            .parameters()
            .iter()
            .map(|row| (row.name.to_owned(), ColumnType::SomeRepeatedNumber));
        let columns = columns.chain([(STATUS.to_owned(), ColumnType::Text)]);
        let columns: Vec<_> = columns
            .chain(
                results
                    .iter()
                    .map(|name| (name.clone(), ColumnType::SomeNumber)),
            )
            .collect();
        let table = ParquetTable::new("drives", &columns, definition)?;
        Ok(Self {
            table,
            columns: column_counts(batch),
        })
    }

    /// Number of blocks of [`CHUNK`] rows in a row group. A row group must fit in memory, and an
    /// interruption must not lose much work; a wide table therefore has fewer blocks in a group.
    pub fn blocks_of_group(&self) -> usize {
        let width = 9 * self.columns.iter().sum::<usize>() + 1;
        (MOST_BYTES / width).clamp(LEAST_ROWS, MOST_ROWS) / CHUNK
    }

    /// The row group that contains `blocks`.
    ///
    /// # Errors
    /// [`Error::Output`](crate::Error::Output) if Parquet does not allow a value of `blocks`.
    ///
    /// # Panics
    /// If a block differs from the batch in the number of parameters, outcomes or derivatives.
    pub fn group(&self, blocks: &[Block]) -> Result<ParquetGroup> {
        blocks
            .iter()
            .for_each(|block| expect_columns(self.columns, block));
        let all = |block: &Block| 0..block.rows();
        let [parameters, ..] = self.columns;
        self.table.group(|number| match number {
            number if number < parameters => {
                let value = |block: &Block, row| {
                    let value = block.point(row)[number];
                    // NaN: the table of points has no value here
                    Some(value).filter(|value| !value.is_nan())
                };
                let values = blocks
                    .iter()
                    .flat_map(|block| all(block).map(move |row| value(block, row)));
                Cells::Numbers(values.collect())
            }
            number if number == parameters => {
                let status = |block: &Block, row| Some(ByteArray::from(block.status(row).name()));
                let status = blocks
                    .iter()
                    .flat_map(|block| all(block).map(move |row| status(block, row)));
                Cells::Texts(status.collect())
            }
            number => {
                let values = blocks
                    .iter()
                    .flat_map(|block| block.result(number - parameters - 1));
                Cells::Numbers(values.collect())
            }
        })
    }

    /// The end of a file with these row groups. The file also stores the key-value pairs
    /// `metadata`.
    ///
    /// # Errors
    /// [`Error::Output`](crate::Error::Output) if Parquet does not allow `groups` or `metadata`.
    pub fn footer(&self, groups: &RowGroups, metadata: &[(&str, String)]) -> Result<Vec<u8>> {
        self.table.footer(groups, metadata)
    }
}
