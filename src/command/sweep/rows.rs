use super::args::SweepFormat;
use crate::Result;
use crate::batch::{Batch, Block, StatusCounts, SweepDefinition};
use crate::command::output::stated_system;
#[cfg(feature = "parquet")]
use crate::report::{PARQUET_MAGIC, SweepParquet};
use crate::report::{SweepCsv, SweepJsonLines};

/// Rows ready to be written to a file.
pub enum FormattedRows {
    Text {
        bytes: Vec<u8>,
        status_counts: StatusCounts,
    },
    /// Rows of a row group that is not complete yet.
    #[cfg(feature = "parquet")]
    Block(Block),
}

impl FormattedRows {
    /// Number of rows.
    pub fn count(&self) -> u64 {
        match self {
            Self::Text { status_counts, .. } => status_counts.total(),
            #[cfg(feature = "parquet")]
            Self::Block(block) => block.rows() as u64,
        }
    }
}

/// Formats blocks as rows.
pub enum RowFormatter {
    Csv(SweepCsv),
    JsonLines(SweepJsonLines),
    #[cfg(feature = "parquet")]
    Parquet(Box<SweepParquet>),
}

impl RowFormatter {
    /// The formatter of a batch. A Parquet file contains the definition of the sweep.
    #[cfg_attr(not(feature = "parquet"), allow(unused_variables))]
    pub fn new(batch: &Batch, format: SweepFormat, definition: &SweepDefinition) -> Result<Self> {
        Ok(match format {
            SweepFormat::Csv => Self::Csv(SweepCsv::new(batch, stated_system().into())),
            SweepFormat::Jsonl => Self::JsonLines(SweepJsonLines::new(batch)),
            #[cfg(feature = "parquet")]
            SweepFormat::Parquet => {
                Self::Parquet(Box::new(SweepParquet::new(batch, &definition.text())?))
            }
        })
    }

    /// The bytes of a file before the first row.
    pub fn head(&self) -> Vec<u8> {
        match self {
            Self::Csv(table) => table.head(),
            Self::JsonLines(_) => vec![],
            #[cfg(feature = "parquet")]
            Self::Parquet(_) => PARQUET_MAGIC.to_vec(),
        }
    }

    /// The rows of a block. The thread that computed the block calls this function.
    pub fn rows(&self, block: Block) -> FormattedRows {
        let bytes = match self {
            Self::Csv(table) => table.rows(&block),
            Self::JsonLines(table) => table.rows(&block),
            #[cfg(feature = "parquet")]
            Self::Parquet(_) => return FormattedRows::Block(block),
        };
        let mut status_counts = StatusCounts::default();
        status_counts.add(&block);
        FormattedRows::Text {
            bytes,
            status_counts,
        }
    }
}
