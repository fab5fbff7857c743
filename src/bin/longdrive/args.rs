use clap::{Parser, Subcommand};
use std::path::PathBuf;

/// The longest golf drive, with exact derivatives.
///
/// A drive is hit (rigid bodies, ellipsoidal face), flown (drag, lift, spin decay, wind) and landed; every
/// outcome has exact derivatives by every parameter. Exit status: 0 done, 1 no answer (no flight, not
/// converged), 2 bad input.
#[derive(Parser)]
#[command(version, max_term_width = 110)]
pub struct Args {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand)]
pub enum Command {
    /// Hit and fly one drive.
    Simulate(Simulate),
    /// Exact derivatives of outcomes with respect to parameters.
    Gradient(Gradient),
    /// Find the parameters that make an outcome largest: by default the loft and attack angle of the longest carry.
    Optimize(Optimize),
    /// How the optimum answers to every other parameter, what its bounds and constraints cost, and how flat it is.
    OptimumSensitivity(OptimumSensitivity),
    /// The optimum as a function of a parameter.
    Chart(ChartArgs),
    /// Very many drives: every point of a grid, a quasi-random sequence or a table, to CSV, JSON lines or Parquet.
    Sweep(Sweep),
    /// Hold every exact derivative against differences, and everything they rest on: exit status 1 if any fails.
    Verify(Verify),
    /// What outcomes answer to: slopes, elasticities, and the effect of an uncertainty of each parameter, the largest first.
    Sensitivity(SensitivityArgs),
    /// What is uncertain about outcomes where parameters are: by exact derivatives, and by many drives.
    Uncertainty(UncertaintyArgs),
    /// List every parameter with its unit, range, default and meaning.
    Parameters(Parameters),
    /// List the presets, or print one as a setup file with the source of each number.
    Presets(Presets),
}

/// What every question starts from.
#[derive(clap::Args)]
pub struct Question {
    /// A preset's name or a TOML file.
    #[arg(value_name = "SETUP", default_value = "modern-driver")]
    pub setup: String,

    /// Override a parameter, e.g. club.loft=10.5deg; a number without unit is SI. Repeatable.
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,

    /// Fly every drive of this question to within this length of its exact carry (1um where none is given), as cheaply as that
    /// goes: method and step are chosen once, before the first drive. Without: flight.method and flight.step.
    #[arg(long, value_name = "LENGTH", num_args = 0..=1, default_missing_value = "1um", require_equals = true)]
    pub tolerance: Option<String>,

    /// Print the answer as JSON (SI and radians) to standard output, and nothing else there.
    #[arg(long)]
    pub json: bool,
}

#[derive(clap::Args)]
pub struct Simulate {
    #[command(flatten)]
    pub question: Question,
}

#[derive(clap::Args)]
pub struct Gradient {
    #[command(flatten)]
    pub question: Question,

    /// The outcomes, separated by commas.
    #[arg(long, value_name = "OUTCOME,…", value_delimiter = ',', default_value = "carry")]
    pub of: Vec<String>,

    /// The parameters, separated by commas; "all" for every one that has a number here.
    #[arg(long, value_name = "NAME,…", value_delimiter = ',', default_value = "club.loft,swing.attack_angle")]
    pub wrt: Vec<String>,

    /// The Hessian too.
    #[arg(long)]
    pub hessian: bool,
}

/// What to look for.
#[derive(clap::Args)]
pub struct SearchArgs {
    /// The outcome to make as large as possible.
    #[arg(long, value_name = "OUTCOME", default_value = "carry")]
    pub maximize: String,

    /// A parameter to vary, with its range, e.g. club.loft=4deg..20deg. Repeatable; without any: loft 4–20° and
    /// attack angle −5…+5°.
    #[arg(long, value_name = "NAME=LOW..HIGH", allow_hyphen_values = true)]
    pub vary: Vec<String>,

    /// An outcome to hold within limits, e.g. "descent_angle >= 38 deg", "20 yd <= apex_height <= 35 yd" or
    /// "lateral == 0 m"; every limit with its unit. Repeatable.
    #[arg(long, value_name = "CONSTRAINT", allow_hyphen_values = true)]
    pub subject_to: Vec<String>,

    /// Most iterations of a search.
    #[arg(long, value_name = "N", default_value_t = 500)]
    pub max_iterations: u64,
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

#[derive(clap::Args)]
pub struct Sweep {
    #[command(flatten)]
    pub question: Question,

    /// A parameter to sweep, with its range and number of values, ends included, e.g. club.loft=5deg..15deg:101.
    /// Repeatable: every combination, the first outermost.
    #[arg(long, value_name = "NAME=LOW..HIGH:COUNT", allow_hyphen_values = true)]
    pub over: Vec<String>,

    /// Spread this many points evenly over the ranges of --over (which then have no counts): Sobol's sequence.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub sample: Option<u64>,

    /// Another seed, other points of --sample.
    #[arg(long, value_name = "SEED", default_value_t = 0, requires = "sample")]
    pub seed: u32,

    /// Take the points from a table (.csv or .parquet): a column for each parameter, in SI, or in the unit that a head
    /// like "club.loft [deg]" names.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["over", "sample"])]
    pub points: Option<PathBuf>,

    /// The outcomes, separated by commas; "all" for every one.
    #[arg(long, value_name = "OUTCOME,…", value_delimiter = ',', default_value = "carry")]
    pub outcomes: Vec<String>,

    /// The exact derivatives of the outcomes too, by the swept parameters.
    #[arg(long)]
    pub gradient: bool,

    /// The exact derivatives of the outcomes too, by these parameters, separated by commas.
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    pub wrt: Vec<String>,

    /// The file to write; its ending says in which format (.csv, .jsonl, .parquet). "-" is standard output.
    #[arg(long, short, value_name = "FILE", default_value = "-")]
    pub output: PathBuf,

    /// The format, whatever the file's name ends in (standard output: CSV unless said otherwise).
    #[arg(long, value_enum)]
    pub format: Option<Format>,

    /// Go on with a sweep that was stopped or killed: the file ends up as if nothing had happened.
    #[arg(long, conflicts_with = "overwrite")]
    pub resume: bool,

    /// Replace a file that exists.
    #[arg(long)]
    pub overwrite: bool,

    /// Refuse to begin what would take more than this, e.g. 50GB (without it: more than the disk has free).
    #[arg(long, value_name = "SIZE")]
    pub max_size: Option<String>,

    /// Threads (0: as many as there are processors); the results do not depend on it.
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub threads: usize,
}

#[derive(clap::Args)]
pub struct Verify {
    #[command(flatten)]
    pub question: Question,

    /// The outcomes, separated by commas; "all" for every one.
    #[arg(long, value_name = "OUTCOME,…", value_delimiter = ',', default_value = "carry,lateral")]
    pub of: Vec<String>,

    /// The parameters, separated by commas; "all" for every one that has a number here.
    #[arg(long, value_name = "NAME,…", value_delimiter = ',', default_value = "all")]
    pub wrt: Vec<String>,
}

#[derive(clap::Args)]
pub struct SensitivityArgs {
    #[command(flatten)]
    pub question: Question,

    /// The outcomes, separated by commas; "all" for every one.
    #[arg(long, value_name = "OUTCOME,…", value_delimiter = ',', default_value = "carry")]
    pub of: Vec<String>,

    /// A standard uncertainty of a parameter, e.g. swing.speed=1mph or air.density=0.5% of its value. Repeatable.
    #[arg(long, value_name = "NAME=AMOUNT")]
    pub sigma: Vec<String>,

    /// Leave parameters without a --sigma without an uncertainty (by default some have one, with its source).
    #[arg(long)]
    pub no_defaults: bool,

    /// Ask at the optimum of a search, where the best value's own slopes stand beside those of the drive.
    #[arg(long)]
    pub at_optimum: bool,

    #[command(flatten)]
    pub search: SearchArgs,
}

#[derive(clap::Args)]
pub struct UncertaintyArgs {
    #[command(flatten)]
    pub question: Question,

    /// The outcomes, separated by commas; "all" for every one. With carry and lateral come landing ellipses.
    #[arg(long, value_name = "OUTCOME,…", value_delimiter = ',', default_value = "carry,lateral")]
    pub of: Vec<String>,

    /// A standard deviation of a parameter that is normally distributed about its value, e.g. swing.speed=1mph or
    /// air.density=0.5% of its value. Repeatable; without any (and without --distribution) the defaults of "sensitivity".
    #[arg(long, value_name = "NAME=AMOUNT")]
    pub sigma: Vec<String>,

    /// A parameter's distribution: NAME=normal(MEAN,DEVIATION), NAME=uniform(LOW,HIGH) or NAME=triangular(LOW,MODE,HIGH).
    /// Repeatable.
    #[arg(long, value_name = "NAME=KIND(…)")]
    pub distribution: Vec<String>,

    /// Points of the sample: this many drives for each uncertain parameter, and twice as many more.
    #[arg(long, value_name = "N", default_value_t = 4096, value_parser = clap::value_parser!(u64).range(2..=1_000_000))]
    pub samples: u64,

    /// Another seed, another sample.
    #[arg(long, value_name = "SEED", default_value_t = 0)]
    pub seed: u64,
}

/// How rows are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Format {
    /// Comma-separated values, a missing one an empty cell.
    Csv,
    /// A JSON object for each drive, a line each, a missing value null.
    #[value(alias = "ndjson")]
    Jsonl,
    /// Apache Parquet, a missing value null.
    #[cfg(feature = "parquet")]
    Parquet,
}

#[derive(clap::Args)]
pub struct Parameters {
    #[command(flatten)]
    pub question: Question,
}

#[derive(clap::Args)]
pub struct Presets {
    /// The preset to print as a setup file.
    #[arg(value_name = "NAME")]
    pub name: Option<String>,

    /// Print the presets as JSON.
    #[arg(long)]
    pub json: bool,
}
