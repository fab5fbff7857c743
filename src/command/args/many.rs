//! Very many drives.

use super::Question;
use super::number::{U32, whole};
use std::path::PathBuf;

#[derive(clap::Args)]
pub struct Sweep {
    #[command(flatten)]
    pub question: Question,

    /// A parameter to sweep, with its range and number of values, ends included, e.g. club.loft=5deg..15deg:101.
    /// Repeatable: all combinations are computed; the last parameter changes fastest.
    #[arg(long, value_name = "NAME=LOW..HIGH:COUNT", allow_hyphen_values = true)]
    pub over: Vec<String>,

    /// Take this many points of a quasi-random (Sobol') sequence in the ranges of --over, which then have no counts.
    #[arg(long, value_name = "N", value_parser = whole::<u64>(1..=u64::MAX, "--sample 1000"), allow_negative_numbers = true)]
    pub sample: Option<u64>,

    /// The seed of --sample; the same seed gives the same points.
    #[arg(long, value_name = "SEED", default_value_t = 0, requires = "sample", value_parser = whole::<u32>(0..=U32, "--seed 7"), allow_negative_numbers = true)]
    pub seed: u32,

    /// Take the points from a table (.csv, .parquet, or Arrow IPC: .arrow, .arrows, .feather): a column for each
    /// parameter; in CSV in the unit that its head names, as in "club.loft [deg]", in the others in SI.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["over", "sample", "seed"])]
    pub points: Option<PathBuf>,

    /// The outcomes, separated by commas; "all" for every one.
    #[arg(long, value_name = "OUTCOME,…", value_delimiter = ',', default_value = "carry")]
    pub outcomes: Vec<String>,

    /// Compute the exact derivatives of the outcomes with respect to the swept parameters too.
    #[arg(long)]
    pub gradient: bool,

    /// Compute the exact derivatives of the outcomes with respect to these parameters too, separated by commas.
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    pub wrt: Vec<String>,

    /// The file to write; its ending says in which format (.csv, .jsonl, .parquet). "-" is standard output.
    #[arg(long, short, value_name = "FILE", default_value = "-")]
    pub output: PathBuf,

    /// The format, whatever the name of the file ends in [default for standard output: csv].
    #[cfg_attr(feature = "parquet", arg(long, value_enum))]
    #[cfg_attr(not(feature = "parquet"), arg(long, value_name = "FORMAT", value_parser = without_parquet))]
    pub format: Option<Format>,

    /// Continue a sweep that was stopped or killed; the complete file is the same as without the interruption.
    #[arg(long, conflicts_with = "overwrite")]
    pub resume: bool,

    /// Replace the file if it exists.
    #[arg(long)]
    pub overwrite: bool,

    /// Refuse a sweep whose file would be larger than this, e.g. 50GB [default: the free space of the disk].
    #[arg(long, value_name = "SIZE")]
    pub max_size: Option<String>,

    /// The number of threads (0: as many as there are processors); no more are used than there is work for. The results do not depend on it.
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = whole::<usize>(0..=u64::MAX, "--threads 4"), allow_negative_numbers = true)]
    pub threads: usize,
}

/// How rows are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Format {
    /// Comma-separated values; a missing value is an empty cell.
    Csv,
    /// One JSON object per drive and line; a missing value is null.
    #[value(alias = "ndjson")]
    Jsonl,
    /// Apache Parquet; a missing value is null.
    #[cfg(feature = "parquet")]
    Parquet,
}

/// Reads a format where there is no Parquet.
#[cfg(not(feature = "parquet"))]
fn without_parquet(text: &str) -> Result<Format, String> {
    if text == "parquet" {
        return Err(crate::features::how_to_get("parquet"));
    }
    clap::ValueEnum::from_str(text, false).map_err(|_| "the formats are csv and jsonl".into())
}
