//! Plots and the page.

use super::Question;
use super::SearchArgs;
use clap::Subcommand;
use std::path::PathBuf;

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

impl PlotKind {
    /// What the plot starts from.
    pub fn question(&self) -> &Question {
        match self {
            Self::Trajectory(args) => &args.question,
            Self::Contour(args) => &args.question,
            Self::Chart(args) => &args.question,
            Self::Tornado(args) => &args.question,
            Self::Vcurve(args) => &args.question,
        }
    }
}

/// How a plot is drawn.
#[derive(clap::Args)]
pub struct Drawing {
    /// The file to write; its ending says what: .svg or .png for a picture, .csv for its data (SI and radians).
    #[arg(long, short, value_name = "FILE")]
    pub output: PathBuf,

    /// Replace files that exist.
    #[arg(long)]
    pub overwrite: bool,

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

    /// Replace files that exist.
    #[arg(long)]
    pub overwrite: bool,

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
