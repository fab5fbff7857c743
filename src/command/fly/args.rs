//! Options of `fly`, which flies the shots of a launch monitor.

// these doc comments are help texts, in which "carry [yd]" is a column head, not a link
#![allow(rustdoc::broken_intra_doc_links)]

use crate::command::args::{SetupArgs, whole};
use std::net::IpAddr;
use std::path::PathBuf;

#[derive(clap::Args)]
pub struct Args {
    /// Shots, one per row: the CSV export of a launch monitor, any CSV with columns such as
    /// "ball_speed [mph]", "launch_angle [deg]" and "backspin [rpm]", or messages of GSPro Open
    /// Connect as JSON (one per line, or an array); "-" is standard input. See
    /// docs/launch-monitors.md.
    #[arg(value_name = "SHOTS", required_unless_present = "listen")]
    pub shots: Option<PathBuf>,

    #[command(flatten)]
    pub setup_args: SetupArgs,

    /// Read only the rows with this text in a column, e.g. Club=Driver, in upper or lower case;
    /// several texts of one column are alternatives. Repeatable.
    #[arg(long, value_name = "COLUMN=VALUE", conflicts_with = "listen")]
    pub only: Vec<String>,

    /// The outcomes of the flight to predict, separated by commas; "all" for every one.
    #[arg(
        long,
        value_name = "OUTCOME,…",
        value_delimiter = ',',
        default_value = "carry_distance,lateral,apex_height,flight_time,descent_angle,total"
    )]
    pub of: Vec<String>,

    /// The file for the rows; its extension selects the format (.csv, .jsonl, .parquet; .json for
    /// Open Connect). "-" is standard output. With --json and without a file only the summary is
    /// printed.
    #[arg(
        long,
        short,
        value_name = "FILE",
        default_value = "-",
        conflicts_with = "listen"
    )]
    pub output: PathBuf,

    /// The format, whatever the extension of the file [default for standard output: csv].
    #[arg(long, value_enum, conflicts_with = "listen")]
    pub format: Option<FlyFormat>,

    /// Replace the file if it exists.
    #[arg(long, conflicts_with = "listen")]
    pub overwrite: bool,

    /// The number of threads (0: one per processor). The results do not depend on it.
    #[arg(
        long,
        value_name = "N",
        default_value_t = 0,
        conflicts_with = "listen",
        value_parser = whole::<usize>(0..=u64::MAX, "`threads 4`"),
        allow_negative_numbers = true,
    )]
    pub threads: usize,

    /// Listen on this TCP port (921 if none is given, as for GSPro) instead of reading a file, and
    /// answer messages of GSPro Open Connect until Ctrl-C; 0 selects a free port.
    #[arg(
        long,
        value_name = "PORT",
        num_args = 0..=1,
        default_missing_value = "921",
        value_parser = whole::<u16>(0..=65_535, "`listen 9210`"),
        allow_negative_numbers = true,
    )]
    pub listen: Option<u16>,

    /// The address to listen on. An address that is not a loopback address accepts connections from
    /// other machines.
    #[arg(
        long,
        value_name = "ADDRESS",
        default_value = "127.0.0.1",
        requires = "listen"
    )]
    pub address: IpAddr,
}

/// Format of flown shots.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum FlyFormat {
    /// The columns of the table, unchanged, then columns of predictions.
    Csv,
    /// The columns of a launch monitor, for any kind of input, then columns of predictions.
    LaunchMonitor,
    /// A line with a JSON object for each row, in SI.
    #[value(alias = "ndjson")]
    Jsonl,
    /// A line with a message of GSPro Open Connect for each row.
    OpenConnect,
    /// Apache Parquet, in SI: the stated values, the predictions and the original row.
    #[cfg(feature = "parquet")]
    Parquet,
    /// Six columns of fixed width, the default for a terminal.
    #[value(skip)]
    Screen,
}
