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
    /// Fit parameters to measured shots, with their uncertainty and what the data do not tell.
    Calibrate(Calibrate),
    /// The optimum as a function of a parameter.
    Chart(ChartArgs),
    /// A plot as SVG or PNG, or its data as CSV.
    Plot(Plot),
    /// A page to look at: the drive, the map of the optimum, its prices, what it answers to; with its plots and their data.
    Report(Report),
    /// Very many drives: every point of a grid, a quasi-random sequence or a table, to CSV, JSON lines or Parquet.
    Sweep(Sweep),
    /// A published study computed anew, its every number beside what it prints.
    Reproduce(Reproduce),
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
pub struct Calibrate {
    /// Measured shots in CSV, a row each: columns named by parameters and outcomes, the unit in the head, as in "carry [yd]";
    /// see docs/calibration.md.
    #[arg(value_name = "DATA")]
    pub data: PathBuf,

    #[command(flatten)]
    pub question: Question,

    /// A parameter to fit, e.g. aero.cd0 or aero.cd0=0.1..0.4. Repeatable.
    #[arg(long, value_name = "NAME[=LOW..HIGH]", required = true, allow_hyphen_values = true)]
    pub fit: Vec<String>,

    /// Let outliers pull no harder than a residual of 1.345 σ (Huber's loss).
    #[arg(long)]
    pub huber: bool,

    /// Search from this many starts, spread evenly over the ranges; the first is the setup's own.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..))]
    pub starts: u32,

    /// Fit again K times, each without a K-th of the rows, and show how well these are told.
    #[arg(long, value_name = "K", default_value_t = 0)]
    pub folds: u32,

    /// Another aerodynamic law, as published and fitted, on the same rows by held-out error. Repeatable.
    #[arg(long, value_name = "LAW")]
    pub compare: Vec<String>,

    /// Most iterations of a search.
    #[arg(long, value_name = "N", default_value_t = 200)]
    pub max_iterations: u64,

    /// Write the fitted setup into this file.
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// Write the report into this folder too: a page (index.html), Markdown, and plots of the residuals with their data.
    #[arg(long, value_name = "DIR")]
    pub plot: Option<PathBuf>,
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
pub struct Plot {
    #[command(subcommand)]
    pub kind: PlotKind,
}

#[derive(Subcommand)]
pub enum PlotKind {
    /// The path of the ball.
    Trajectory(PlotTrajectory),
    /// An outcome over two parameters, with its gradients and the optimum.
    Contour(PlotContour),
    /// The optimum as a function of a parameter.
    Chart(PlotChart),
    /// What standard uncertainties of parameters do to an outcome.
    Tornado(PlotTornado),
    /// Central differences beside exact derivatives, by their step.
    Vcurve(PlotVcurve),
}

/// How a plot is drawn.
#[derive(clap::Args)]
pub struct Drawing {
    /// The file to write; its ending says what: .svg or .png for a picture, .csv for its data (SI and radians).
    #[arg(long, short, value_name = "FILE")]
    pub output: PathBuf,

    /// The units on the axes.
    #[arg(long, value_enum, default_value_t = Units::Us)]
    pub units: Units,

    /// For a dark page.
    #[arg(long)]
    pub dark: bool,

    /// The picture's width, pixels; a PNG has twice as many dots. Text keeps its size.
    #[arg(long, value_name = "PIXELS", default_value_t = 480, value_parser = clap::value_parser!(u32).range(240..=4000))]
    pub width: u32,
}

/// The units of a plot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Units {
    /// Metres and metres per second.
    Metric,
    /// Yards and miles per hour.
    Us,
}

/// Where a trajectory is seen from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Seen {
    /// From the side.
    Side,
    /// From above.
    Top,
}

#[derive(clap::Args)]
pub struct PlotTrajectory {
    #[command(flatten)]
    pub question: Question,

    #[command(flatten)]
    pub drawing: Drawing,

    /// Where it is seen from.
    #[arg(long, value_enum, default_value_t = Seen::Side)]
    pub view: Seen,
}

#[derive(clap::Args)]
pub struct PlotContour {
    #[command(flatten)]
    pub question: Question,

    #[command(flatten)]
    pub search: SearchArgs,

    #[command(flatten)]
    pub drawing: Drawing,
}

#[derive(clap::Args)]
pub struct PlotChart {
    #[command(flatten)]
    pub question: Question,

    #[command(flatten)]
    pub search: SearchArgs,

    #[command(flatten)]
    pub drawing: Drawing,

    /// The parameter to follow the optimum along, with its range, e.g. swing.speed=80mph..130mph.
    #[arg(long, value_name = "NAME=LOW..HIGH", allow_hyphen_values = true)]
    pub along: String,

    /// What to draw along it: the outcome, or one of the parameters varied.
    #[arg(long, value_name = "NAME")]
    pub show: Option<String>,
}

#[derive(clap::Args)]
pub struct PlotTornado {
    #[command(flatten)]
    pub question: Question,

    #[command(flatten)]
    pub drawing: Drawing,

    /// The outcome.
    #[arg(long, value_name = "OUTCOME", default_value = "carry")]
    pub of: String,

    /// The standard uncertainty of a parameter, e.g. swing.speed=1mph or air.density=0.5%. Repeatable; others have the defaults
    /// of `longdrive sensitivity`.
    #[arg(long, value_name = "NAME=AMOUNT")]
    pub sigma: Vec<String>,
}

#[derive(clap::Args)]
pub struct PlotVcurve {
    #[command(flatten)]
    pub question: Question,

    #[command(flatten)]
    pub drawing: Drawing,

    /// The outcomes, separated by commas.
    #[arg(long, value_name = "OUTCOME,…", value_delimiter = ',', default_value = "carry")]
    pub of: Vec<String>,

    /// The parameters, separated by commas.
    #[arg(long, value_name = "NAME,…", value_delimiter = ',', default_value = "club.loft,swing.attack_angle")]
    pub wrt: Vec<String>,
}

#[derive(clap::Args)]
pub struct Report {
    #[command(flatten)]
    pub question: Question,

    #[command(flatten)]
    pub search: SearchArgs,

    /// The folder to write: index.html, and each plot as NAME-metric.svg, NAME-us.svg and NAME.csv. Made where it does not
    /// exist; other files in it are left alone.
    #[arg(long, short, value_name = "DIR")]
    pub output: PathBuf,

    /// The standard uncertainty of a parameter, e.g. swing.speed=1mph or air.density=0.5%. Repeatable; others have the defaults
    /// of `longdrive sensitivity`.
    #[arg(long, value_name = "NAME=AMOUNT")]
    pub sigma: Vec<String>,

    /// The parameter to follow the optimum along, with its range.
    #[arg(
        long,
        value_name = "NAME=LOW..HIGH",
        default_value = "swing.speed=80mph..130mph",
        allow_hyphen_values = true
    )]
    pub along: String,
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
pub struct Reproduce {
    /// The study.
    #[arg(value_enum, value_name = "STUDY")]
    pub study: Published,

    /// Print the answer as JSON (SI and radians) to standard output, and nothing else there.
    #[arg(long)]
    pub json: bool,

    /// Write it into this folder too: a page (index.html), Markdown, and every plot as SVG with its data as CSV.
    #[arg(long, short, value_name = "DIR")]
    pub output: Option<PathBuf>,
}

/// A study that can be reproduced.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Published {
    /// The student report "Optimization of a Golf Driver", MAE 494.
    Mae494,
    /// Winfield & Tan (1994), "Optimization of clubhead loft and swing elevation angles".
    WinfieldTan,
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
