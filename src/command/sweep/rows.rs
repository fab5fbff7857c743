use super::args::SweepFormat;
use crate::Result;
use crate::batch::{Batch, Block, StatusCounts};
use crate::command::output::stated_system;
use crate::fingerprint::elementary_functions;
#[cfg(feature = "parquet")]
use crate::report::{PARQUET_MAGIC, SweepParquet};
use crate::report::{SweepCsv, SweepJsonLines};
use crate::units::TableUnits;
use serde::{Deserialize, Serialize};

/// The identity of a sweep. Sweeps with equal identities write the same bytes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Identity {
    pub version: String,
    pub setup: String,
    pub points: String,
    pub outcomes: String,
    pub derivatives: String,
    pub format: String,
    /// Architecture and instruction set of the processor: other instructions round differently.
    pub instructions: String,
    /// Hash of values of the C library's functions: other libraries round differently.
    pub functions: String,
    /// The largest integration error of a drive, m; `inf` if there is no limit.
    pub largest_defect: String,
}

impl Identity {
    pub fn new(batch: &Batch, format: SweepFormat, points: String) -> Self {
        let names = |names: Vec<&str>| names.join(",");
        Self {
            version: env!("CARGO_PKG_VERSION").into(),
            // debug form: every number to the last digit
            setup: format!("{:?}", batch.setup()),
            points,
            outcomes: names(batch.outcomes().iter().map(|of| of.name()).collect()),
            derivatives: names(batch.wrt().iter().map(|by| by.name).collect()),
            format: match (format, stated_system().into()) {
                (SweepFormat::Csv, TableUnits::Of(system)) => format!("csv in {system} units"),
                _ => format!("{format:?}").to_lowercase(),
            },
            instructions: batch.instructions(),
            functions: elementary_functions(),
            largest_defect: format!("{:?}", batch.largest_defect),
        }
    }

    /// The formatter of the rows. A Parquet file contains the identity.
    pub fn formatter(&self, batch: &Batch, format: SweepFormat) -> Result<RowFormatter> {
        Ok(match format {
            SweepFormat::Csv => RowFormatter::Csv(SweepCsv::new(batch, stated_system().into())),
            SweepFormat::Jsonl => RowFormatter::JsonLines(SweepJsonLines::new(batch)),
            #[cfg(feature = "parquet")]
            SweepFormat::Parquet => {
                // strings always serialize
                let note = serde_json::to_string(self).unwrap_or_default();
                RowFormatter::Parquet(Box::new(SweepParquet::new(batch, &note)?))
            }
        })
    }

    /// The name, in plural, of the first field that differs from `other`; `None` if both are equal.
    pub fn difference(&self, other: &Self) -> Option<&'static str> {
        let parts = [
            ("the versions of longdrive", &self.version, &other.version),
            ("the formats", &self.format, &other.format),
            ("the points", &self.points, &other.points),
            ("the outcomes", &self.outcomes, &other.outcomes),
            ("the derivatives", &self.derivatives, &other.derivatives),
            (
                "the instructions of the processors",
                &self.instructions,
                &other.instructions,
            ),
            (
                "the functions of the C libraries",
                &self.functions,
                &other.functions,
            ),
            (
                "the tolerances",
                &self.largest_defect,
                &other.largest_defect,
            ),
            // compare the setups last: their integration step depends on all values above
            ("the setups", &self.setup, &other.setup),
        ];
        parts
            .into_iter()
            .find(|(_, ours, theirs)| ours != theirs)
            .map(|(part, _, _)| part)
    }
}

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
