//! Arguments of a search for an optimum.

use super::SetupArgs;
use super::number::{U32_MAX, whole};
use std::path::PathBuf;

/// Objective, variables and constraints of a search.
#[derive(clap::Args)]
pub struct SearchArgs {
    /// The outcome to maximize [default: carry, unless --minimize is given].
    #[arg(long, value_name = "OUTCOME")]
    pub maximize: Option<String>,

    /// The outcome to minimize.
    #[arg(long, value_name = "OUTCOME")]
    pub minimize: Option<String>,

    /// A parameter to vary, with its range, e.g. club.loft=4deg..20deg. Repeatable [default: loft 4
    /// to 20 deg and attack angle -5 to 5 deg; a parameter that you set, e.g. with --loft, stays
    /// fixed].
    #[arg(long, value_name = "NAME=LOW..HIGH", allow_hyphen_values = true)]
    pub vary: Vec<String>,

    /// A constraint on an outcome, e.g. "descent_angle >= 38 deg", "20 yd <= apex_height <= 35 yd"
    /// or "lateral == 0 m". Every limit needs its unit. A search over many swings also takes a
    /// named linear relation of parameters, e.g. "budget: club.weight_1.mass +
    /// club.weight_2.mass <= 20 g". Repeatable.
    #[arg(long, value_name = "CONSTRAINT", allow_hyphen_values = true)]
    pub subject_to: Vec<String>,

    /// The largest number of iterations of a search [default: 500].
    #[arg(
        long,
        value_name = "N",
        value_parser = whole::<u64>(0..=u64::MAX, "`max_iterations 200`"),
        allow_negative_numbers = true,
    )]
    pub max_iterations: Option<u64>,
}

/// Swings that vary, for a design that is best over all of them.
#[derive(Clone, Default, clap::Args)]
pub struct SwingsArgs {
    /// Search for the best over many swings: a TOML file with [distributions] and [[correlations]],
    /// or a table (CSV, Parquet, Arrow) of recorded swings, a column for each parameter. Goals are
    /// then written like "mean(carry)", "std(lateral)", "lowest(carry, 10%)", "within(lateral,
    /// 15yd)" or "mean(carry) - 0.5*std(lateral)", and by default only the loft is varied.
    #[arg(long, value_name = "FILE")]
    pub swings: Option<PathBuf>,

    /// The distribution of a parameter from swing to swing: NAME=normal(MEAN,DEVIATION),
    /// NAME=uniform(LOW,HIGH), NAME=triangular(LOW,MODE,HIGH) or
    /// NAME=truncated(MEAN,DEVIATION,LOW,HIGH). Repeatable.
    #[arg(long, value_name = "NAME=KIND(…)", allow_hyphen_values = true)]
    pub distribution: Vec<String>,

    /// The correlation of two parameters with distributions, e.g. swing.path,swing.face_angle=0.6.
    /// Repeatable.
    #[arg(long, value_name = "NAME,NAME=COEFFICIENT", allow_hyphen_values = true)]
    pub correlation: Vec<String>,

    /// Take this many swings of the distributions, by a quasi-random sequence [default: quadrature
    /// for up to 3 distributions, else 512 swings; also 512 for lowest, highest and within].
    #[arg(
        long,
        value_name = "N",
        value_parser = whole::<usize>(2..=100_000, "`scenarios 1024`"),
        allow_negative_numbers = true,
    )]
    pub scenarios: Option<usize>,

    /// The seed of the swings; the same seed gives the same swings [default: 0].
    #[arg(
        long,
        value_name = "SEED",
        value_parser = whole::<u32>(0..=U32_MAX, "`seed 7`"),
        allow_negative_numbers = true,
    )]
    pub seed: Option<u32>,

    /// A CSV table with the columns "distance [yd]" (to the hole) and "strokes" (expected number to
    /// hole out). The goal "strokes(400yd)" is the expected number of strokes after the drive, on a
    /// hole of 400 yd, from the landing point (without run).
    #[arg(long, value_name = "FILE")]
    pub strokes: Option<PathBuf>,
}

/// A search for an optimum, with its starts and files.
#[derive(clap::Args)]
pub struct OptimumArgs {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    #[command(flatten)]
    pub search: SearchArgs,

    /// Search from this many starts, spread evenly over the ranges (the first is the setup's own),
    /// and list the local optima.
    #[arg(
        long,
        value_name = "N",
        default_value_t = 1,
        value_parser = whole::<u32>(1..=U32_MAX, "`starts 8`"),
        allow_negative_numbers = true,
    )]
    pub starts: u32,

    /// Save the search to this file after every iteration; if the file exists, continue from it.
    #[arg(long, value_name = "FILE")]
    pub checkpoint: Option<PathBuf>,

    /// Write the setup at the optimum into this setup file.
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// Replace the file if it exists.
    #[arg(long, requires = "output")]
    pub overwrite: bool,
}

/// A search for an optimum of one drive, or over many swings.
#[derive(clap::Args)]
pub struct OptimizeArgs {
    #[command(flatten)]
    pub optimum: OptimumArgs,

    #[command(flatten)]
    pub swings: SwingsArgs,
}
