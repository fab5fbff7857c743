use super::{Columns, STATUS, parameter_names};
use crate::batch::{Batch, Block, CHUNK};
use crate::error::Result;
use crate::report::parquet::{Cells, Kind, ParquetGroup, ParquetTable, PlacedGroup};
use parquet::data_type::ByteArray;

/// Rows of a row group, at most and, however wide the table, at least; and most bytes of its
/// numbers in between.
const MOST_ROWS: usize = 128 * CHUNK;
const LEAST_ROWS: usize = 16 * CHUNK;
const MOST_BYTES: usize = 16 << 20;

/// A batch as Parquet: `DOUBLE` columns (required for the swept parameters, optional for the rest)
/// and the status as a string.
///
/// Row groups are made one at a time: what a file of many needs is its [`head`](Self::head), the
/// groups' bytes one after the other, and a [`foot`](Self::foot) made of the groups' metadata: so a
/// file can be gone on with after any of its groups.
pub struct SweepParquet {
    table: ParquetTable,
    parameters: usize,
    results: usize,
    columns: Columns,
}

impl SweepParquet {
    /// The table of a batch; `question` is kept in the file under the key `longdrive`.
    ///
    /// # Errors
    /// [`Error::Output`](crate::Error::Output) for columns that Parquet cannot have.
    pub fn new(batch: &Batch, question: &str) -> Result<Self> {
        let (parameters, results) = (parameter_names(batch), batch.columns());
        let columns = parameters
            .iter()
            .map(|name| ((*name).to_owned(), Kind::Number));
        let columns = columns.chain([(STATUS.to_owned(), Kind::Text)]);
        let columns: Vec<_> = columns
            .chain(results.iter().map(|name| (name.clone(), Kind::SomeNumber)))
            .collect();
        let table = ParquetTable::new("drives", &columns, question)?;
        Ok(Self {
            table,
            parameters: parameters.len(),
            results: results.len(),
            columns: Columns::of(batch),
        })
    }

    /// Number of blocks of [`CHUNK`] rows in a row group: fewer for wide tables. A group must fit
    /// in memory, and little must be computed again after a kill.
    pub fn blocks_of_group(&self) -> usize {
        let width = 9 * (self.parameters + self.results) + 1;
        (MOST_BYTES / width).clamp(LEAST_ROWS, MOST_ROWS) / CHUNK
    }

    /// The first bytes of a file.
    pub fn head(&self) -> Vec<u8> {
        self.table.head()
    }

    /// The row group of some blocks.
    ///
    /// # Errors
    /// [`Error::Output`](crate::Error::Output) where Parquet cannot hold it.
    ///
    /// # Panics
    /// Where a block is of a batch with other numbers of parameters, outcomes or derivatives.
    pub fn group(&self, blocks: &[Block]) -> Result<ParquetGroup> {
        blocks.iter().for_each(|block| self.columns.expect(block));
        let all = |block: &Block| 0..block.rows();
        self.table.group(|number| match number {
            number if number < self.parameters => {
                let value = |block: &Block, row| block.point(row)[number];
                let values = blocks
                    .iter()
                    .flat_map(|block| all(block).map(move |row| value(block, row)));
                Cells::Numbers(values.collect())
            }
            number if number == self.parameters => {
                let status = |block: &Block, row| ByteArray::from(block.status(row).name());
                let status = blocks
                    .iter()
                    .flat_map(|block| all(block).map(move |row| status(block, row)));
                Cells::Texts(status.collect())
            }
            number => {
                let values = blocks
                    .iter()
                    .flat_map(|block| block.result(number - self.parameters - 1));
                Cells::SomeNumbers(values.collect())
            }
        })
    }

    /// A row group, given by its metadata, in its place: after `at` bytes of the file, as group
    /// number `ordinal`.
    ///
    /// # Errors
    /// [`Error::Output`](crate::Error::Output) for metadata of something else.
    pub fn place(&self, metadata: &[u8], at: u64, ordinal: usize) -> Result<PlacedGroup> {
        self.table.place(metadata, at, ordinal)
    }

    /// The last bytes of a file of these row groups.
    ///
    /// # Errors
    /// [`Error::Output`](crate::Error::Output) where Parquet cannot hold them.
    pub fn foot(&self, groups: &[PlacedGroup]) -> Result<Vec<u8>> {
        self.foot_with(groups, &[])
    }

    /// The footer with further notes in the file, by their keys.
    ///
    /// # Errors
    /// [`Error::Output`](crate::Error::Output) where Parquet cannot hold them.
    pub fn foot_with(&self, groups: &[PlacedGroup], notes: &[(&str, String)]) -> Result<Vec<u8>> {
        self.table.foot(groups, notes)
    }
}
