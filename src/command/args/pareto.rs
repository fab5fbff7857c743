//! Options of `pareto`: two goals.

use super::number::whole;
use super::{SetupArgs, SwingsArgs};
use std::path::PathBuf;

/// The two goals and the varied parameters.
#[derive(clap::Args)]
pub struct ParetoAsked {
    /// A goal to maximize: an outcome, or over many swings a statistic of it, e.g. "mean(carry)".
    /// Give two goals in total, with --maximize and --minimize.
    #[arg(long, value_name = "GOAL")]
    pub maximize: Vec<String>,

    /// A goal to minimize, e.g. "std(lateral)".
    #[arg(long, value_name = "GOAL")]
    pub minimize: Vec<String>,

    /// A parameter to vary, with its range, e.g. club.loft=4deg..20deg. Repeatable [default: loft 4
    /// to 20 deg; for one drive also attack angle -5 to 5 deg].
    #[arg(long, value_name = "NAME=LOW..HIGH", allow_hyphen_values = true)]
    pub vary: Vec<String>,

    /// A constraint on a goal, e.g. "apex_height <= 35 yd", over many swings "mean(carry) >= 240
    /// yd"; every limit with its unit. Repeatable.
    #[arg(long, value_name = "CONSTRAINT", allow_hyphen_values = true)]
    pub subject_to: Vec<String>,

    /// The number of points, spread evenly from the optimum of one goal to the optimum of the
    /// other.
    #[arg(
        long,
        value_name = "N",
        default_value_t = 15,
        value_parser = whole::<usize>(2..=1000, "`points 15`"),
        allow_negative_numbers = true,
    )]
    pub points: usize,

    /// The largest number of iterations of a search [default: 500].
    #[arg(
        long,
        value_name = "N",
        value_parser = whole::<u64>(0..=u64::MAX, "`max_iterations 200`"),
        allow_negative_numbers = true,
    )]
    pub max_iterations: Option<u64>,

    #[command(flatten)]
    pub swings: SwingsArgs,
}

#[derive(clap::Args)]
pub struct ParetoArgs {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    #[command(flatten)]
    pub asked: ParetoAsked,

    /// Write the points into this file: .csv for all of them (SI units and radians), .toml for the
    /// setup at one of them, which --at chooses.
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// The point whose setup is written: "knee", or its number in the table [default: knee].
    #[arg(
        long,
        value_name = "POINT",
        requires = "output",
        allow_negative_numbers = true
    )]
    pub at: Option<String>,

    /// Replace the file if it exists.
    #[arg(long, requires = "output")]
    pub overwrite: bool,
}
