//! Options of a sweep.

// these doc comments are help texts, in which "carry [yd]" is a column head, not a link
#![allow(rustdoc::broken_intra_doc_links)]

use crate::command::args::{SetupArgs, U32_MAX, whole};
use crate::number::Level;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use std::path::PathBuf;

#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    /// A parameter to sweep, with its range and number of values, ends included, e.g.
    /// club.loft=5deg..15deg:101. Repeatable: all combinations are computed; the last parameter
    /// changes fastest.
    #[arg(long, value_name = "NAME=LOW..HIGH:COUNT", allow_hyphen_values = true)]
    pub over: Vec<String>,

    /// Take this many points of a quasi-random (Sobol') sequence in the ranges of --over, written
    /// without counts: NAME=LOW..HIGH.
    #[arg(
        long,
        value_name = "N",
        value_parser = whole::<u64>(1..=u64::MAX, "`sample 1000`"),
        allow_negative_numbers = true,
    )]
    pub sample: Option<u64>,

    /// The seed of --sample; the same seed gives the same points.
    #[arg(
        long,
        value_name = "SEED",
        default_value_t = 0,
        requires = "sample",
        value_parser = whole::<u32>(0..=U32_MAX, "`seed 7`"),
        allow_negative_numbers = true,
    )]
    pub seed: u32,

    /// Take the points from a table (.csv, .parquet, or Arrow IPC: .arrow, .arrows, .feather) with
    /// a column for each parameter. In CSV the head of a column names its unit, as in "club.loft
    /// [deg]"; other formats are in SI.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["over", "sample", "seed"])]
    pub points: Option<PathBuf>,

    /// The outcomes, separated by commas; "all" for every one.
    #[arg(
        long,
        value_name = "OUTCOME,…",
        value_delimiter = ',',
        default_value = "carry"
    )]
    pub outcomes: Vec<String>,

    /// Compute the exact derivatives of the outcomes with respect to the swept parameters too.
    #[arg(long)]
    pub gradient: bool,

    /// Compute the exact derivatives of the outcomes with respect to these parameters too,
    /// separated by commas.
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    pub wrt: Vec<String>,

    /// Write part K of M of the sweep as a Parquet file into the folder of -o, e.g. --part 17/1000;
    /// each process of a job array writes another part. Parts are counted from 1. The bytes of a
    /// part depend neither on the machine nor on repetition. An existing part is kept.
    #[arg(
        long,
        value_name = "K/M",
        requires = "output",
        conflicts_with_all = ["resume", "format", "max_size"],
        value_parser = PartOf::read,
    )]
    pub part: Option<PartOf>,

    /// Check the parts in this folder: list missing and damaged parts, and summarize all rows.
    /// Nothing is computed. If the options of the sweep are given, the parts are compared with
    /// them.
    #[arg(
        long,
        value_name = "DIR",
        conflicts_with_all = ["part", "output", "resume", "overwrite", "format", "max_size"],
    )]
    pub check: Option<PathBuf>,

    /// With --check: read the rows too, compare them with the SHA-256 in each part, and compute the
    /// SHA-256 of the whole set.
    #[arg(long, requires = "check")]
    pub hash: bool,

    /// With --part: count an outcome in bins of equal width, e.g. carry=200m..300m:64. Repeatable,
    /// once for each outcome.
    #[arg(
        long,
        value_name = "OUTCOME=LOW..HIGH:BINS",
        allow_hyphen_values = true
    )]
    pub histogram: Vec<String>,

    /// With --part: also store in the summary the N rows with the highest values of an outcome,
    /// e.g. carry:10. Repeatable.
    #[arg(long, value_name = "OUTCOME:N")]
    pub highest: Vec<String>,

    /// With --part: also store in the summary the N rows with the lowest values of an outcome.
    /// Repeatable.
    #[arg(long, value_name = "OUTCOME:N")]
    pub lowest: Vec<String>,

    /// The instruction set to compute with [default: the widest of this processor]. Results of
    /// different instruction sets agree to rounding only: on a cluster of different machines, name
    /// one that all of them have.
    #[arg(long, value_name = "NAME", value_parser = instructions())]
    pub instructions: Option<Level>,

    /// The file to write; its extension selects the format (.csv, .jsonl, .parquet). "-" is
    /// standard output.
    #[arg(long, short, value_name = "FILE", default_value = "-")]
    pub output: PathBuf,

    /// The format, whatever the extension of the file [default for standard output: csv].
    #[cfg_attr(feature = "parquet", arg(long, value_enum))]
    #[cfg_attr(
        not(feature = "parquet"),
        arg(long, value_name = "FORMAT", value_parser = without_parquet),
    )]
    pub format: Option<SweepFormat>,

    /// Continue a sweep that was stopped or killed; the complete file is the same as without the
    /// interruption.
    #[arg(long, conflicts_with = "overwrite")]
    pub resume: bool,

    /// Replace the file if it exists.
    #[arg(long)]
    pub overwrite: bool,

    /// Refuse a sweep whose file would be larger than this, e.g. 50GB [default: the free space of
    /// the disk].
    #[arg(long, value_name = "SIZE")]
    pub max_size: Option<String>,

    /// The number of threads (0: one per processor), at most 256 and no more than there is work
    /// for. The results do not depend on it.
    #[arg(
        long,
        value_name = "N",
        default_value_t = 0,
        value_parser = whole::<usize>(0..=u64::MAX, "`threads 4`"),
        allow_negative_numbers = true,
    )]
    pub threads: usize,
}

/// Parser of instruction sets.
fn instructions() -> impl TypedValueParser<Value = Level> {
    PossibleValuesParser::new(Level::NAMES)
        .map(|name| Level::from_name(&name).unwrap_or(Level::Baseline))
}

/// A part of a sweep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PartOf {
    /// Number of the part, from 1.
    pub part: u64,
    /// Number of parts.
    pub parts: u64,
}

impl PartOf {
    fn read(text: &str) -> Result<Self, String> {
        let number = |text: &str| text.trim().parse::<u64>().ok().filter(|number| *number > 0);
        let parts = text
            .split_once('/')
            .and_then(|(part, parts)| Some((number(part)?, number(parts)?)));
        match parts {
            Some((part, parts)) if part <= parts => Ok(Self { part, parts }),
            Some((_, parts)) => Err(format!(
                "there are {parts} parts; give one from 1/{parts} to {parts}/{parts}"
            )),
            None => Err(
                "write the number of the part, from 1, and the number of all parts, for example \
                 `part 17/1000`"
                    .into(),
            ),
        }
    }
}

/// Format of the rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum SweepFormat {
    /// Comma-separated values; a missing value is an empty cell.
    Csv,
    /// One JSON object per drive and line; a missing value is null.
    #[value(alias = "ndjson")]
    Jsonl,
    /// Apache Parquet; a missing value is null.
    #[cfg(feature = "parquet")]
    Parquet,
}

/// Parser of formats in a build without Parquet.
#[cfg(not(feature = "parquet"))]
fn without_parquet(text: &str) -> Result<SweepFormat, String> {
    if text == "parquet" {
        return Err(crate::features::how_to_get("parquet"));
    }
    clap::ValueEnum::from_str(text, false).map_err(|_| "the formats are csv and jsonl".into())
}
