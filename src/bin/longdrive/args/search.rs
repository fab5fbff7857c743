//! Searches for an optimum.

use super::Question;
use std::path::PathBuf;

/// What to look for.
#[derive(clap::Args)]
pub struct SearchArgs {
    /// The outcome to make as large as possible (carry, where neither this nor --minimize is given).
    #[arg(long, value_name = "OUTCOME", conflicts_with = "minimize")]
    pub maximize: Option<String>,

    /// The outcome to make as small as possible.
    #[arg(long, value_name = "OUTCOME")]
    pub minimize: Option<String>,

    /// A parameter to vary, with its range, e.g. club.loft=4deg..20deg. Repeatable; without any: loft 4–20° and
    /// attack angle −5…+5°.
    #[arg(long, value_name = "NAME=LOW..HIGH", allow_hyphen_values = true)]
    pub vary: Vec<String>,

    /// An outcome to hold within limits, e.g. "descent_angle >= 38 deg", "20 yd <= apex_height <= 35 yd" or
    /// "lateral == 0 m"; every limit with its unit. Repeatable.
    #[arg(long, value_name = "CONSTRAINT", allow_hyphen_values = true)]
    pub subject_to: Vec<String>,

    /// Most iterations of a search (500).
    #[arg(long, value_name = "N")]
    pub max_iterations: Option<u64>,
}

/// How long work is done.
#[derive(clap::Args)]
pub struct WorkArgs {
    /// Search from this many starts, spread evenly over the ranges (the first is the setup's own), and list the local
    /// optima.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..))]
    pub starts: u32,

    /// Keep the search in this file after every iteration, and go on from it where it exists.
    #[arg(long, value_name = "FILE")]
    pub checkpoint: Option<PathBuf>,
}

#[derive(clap::Args)]
pub struct Optimize {
    #[command(flatten)]
    pub question: Question,

    #[command(flatten)]
    pub search: SearchArgs,

    #[command(flatten)]
    pub work: WorkArgs,

    /// Write the setup at the optimum into this setup file.
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// Replace the file if it exists.
    #[arg(long, requires = "output")]
    pub overwrite: bool,
}

#[derive(clap::Args)]
pub struct OptimumSensitivity {
    #[command(flatten)]
    pub optimize: Optimize,

    /// The parameters to answer to, separated by commas; "all" for every one that has a number here and is not varied.
    #[arg(long, value_name = "NAME,…", value_delimiter = ',', default_value = "all")]
    pub wrt: Vec<String>,

    /// A change of a parameter, e.g. swing.speed=+5mph: its effect on the optimum is predicted and, beside it, searched
    /// anew. Repeatable.
    #[arg(long, value_name = "NAME=AMOUNT", allow_hyphen_values = true)]
    pub change: Vec<String>,

    /// The loss that the windows allow (default: 1 yd for a distance, 1 % of the outcome otherwise).
    #[arg(long, value_name = "AMOUNT")]
    pub loss: Option<String>,
}

#[derive(clap::Args)]
pub struct ChartArgs {
    #[command(flatten)]
    pub question: Question,

    #[command(flatten)]
    pub search: SearchArgs,

    /// The parameter to follow the optimum along, with its range, e.g. swing.speed=80mph..130mph.
    #[arg(long, value_name = "NAME=LOW..HIGH", allow_hyphen_values = true)]
    pub along: String,

    /// Print the chart as CSV (SI and radians).
    #[arg(long, conflicts_with = "json")]
    pub csv: bool,
}
