//! Plots and the page.

use super::SearchArgs;
use super::number::whole;
use super::{Pair, ParetoAsked, SetupArgs};
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
    /// The Pareto front of two goals, with its ends, its knee and the slope at the knee.
    Pareto(PlotPareto),
    /// The effects of the uncertainties of parameters on an outcome.
    Tornado(PlotTornado),
    /// The difference between two drives, split into the parameters and launch conditions that
    /// differ.
    Compare(PlotCompare),
    /// The error of central differences against exact derivatives, by step.
    Vcurve(PlotVcurve),
    /// Laws of drag and lift over the spin ratio or the Reynolds number, with measured points.
    Laws(PlotLaws),
    /// The landings of the drive and of the optimum from above, at true scale, with the ellipses of
    /// half and of 95 % of the landings.
    Fairway(PlotFairway),
    /// The club face from the front: the strike, the sweet spot, rings of carry lost, and the side
    /// to which the spin axis tilts.
    Face(PlotFace),
    /// Carry, lateral, ball speed and spin axis over the club face, for the drive as set up and for
    /// the optimum, or for two designs.
    Strike(PlotStrike),
    /// Carry over launch angle and backspin at the drive's ball speed, with the launches of the
    /// drive and of the optimum.
    Launch(PlotLaunch),
}

impl PlotKind {
    /// The setup arguments of the plot.
    pub fn setup_args(&self) -> &SetupArgs {
        match self {
            Self::Trajectory(args) => &args.setup_args,
            Self::Contour(args) => &args.setup_args,
            Self::Chart(args) => &args.setup_args,
            Self::Pareto(args) => &args.setup_args,
            Self::Tornado(args) => &args.setup_args,
            Self::Compare(args) => &args.pair.setup_args,
            Self::Vcurve(args) => &args.setup_args,
            Self::Laws(args) => &args.setup_args,
            Self::Fairway(args) => &args.setup_args,
            Self::Face(args) => &args.setup_args,
            Self::Strike(args) => &args.setup_args,
            Self::Launch(args) => &args.setup_args,
        }
    }
}

/// Options of a picture.
#[derive(clap::Args)]
pub struct Drawing {
    /// The file to write: .svg or .png for a picture, .csv for its data (SI units and radians).
    #[arg(long, short, value_name = "FILE")]
    pub output: PathBuf,

    /// Replace files that exist.
    #[arg(long)]
    pub overwrite: bool,

    /// Draw for a dark background.
    #[arg(long)]
    pub dark: bool,

    /// The width of the picture in pixels; a PNG has twice the resolution. The size of the text
    /// does not change [default: 480].
    #[arg(
        long,
        value_name = "PIXELS",
        value_parser = whole::<u32>(240..=4000, "`width 800`"),
        allow_negative_numbers = true,
    )]
    pub width: Option<u32>,
}

impl Drawing {
    /// The stated options on the appearance of a picture.
    pub fn look(&self) -> Vec<&'static str> {
        let given = [("`dark`", self.dark), ("`width`", self.width.is_some())];
        given
            .into_iter()
            .filter(|(_, is_given)| *is_given)
            .map(|(option, _)| option)
            .collect()
    }
}

/// View of a trajectory.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Seen {
    /// From the side.
    Side,
    /// From above.
    Top,
}

/// Horizontal axis of a plot of laws.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum LawsOver {
    /// Over the spin ratio.
    SpinRatio,
    /// Over the Reynolds number.
    Reynolds,
}

/// The coefficient to draw.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Drawn {
    /// The drag coefficient.
    Cd,
    /// The lift coefficient.
    Cl,
}

/// The uncertainties in a tornado plot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Moved {
    /// Parameters that you control: delivery, strike and club, or a stated launch.
    Control,
    /// Uncertain inputs of the model: coefficients, ball, air, wind and ground.
    Model,
    /// Both kinds in one picture.
    All,
}

#[derive(clap::Args)]
pub struct PlotLaws {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    #[command(flatten)]
    pub drawing: Drawing,

    /// The laws, separated by commas; "table" for your own table of --set aero.table [default: all
    /// laws].
    #[arg(long, value_name = "LAW,…", value_delimiter = ',')]
    pub laws: Vec<String>,

    /// The coefficient to draw.
    #[arg(long, value_enum, default_value_t = Drawn::Cd)]
    pub show: Drawn,

    /// The horizontal axis.
    #[arg(long, value_enum, default_value_t = LawsOver::SpinRatio)]
    pub over: LawsOver,

    /// The constant Reynolds number of a plot over the spin ratio [default: 1.5e5].
    #[arg(long, value_name = "NUMBER", allow_negative_numbers = true)]
    pub reynolds: Option<String>,

    /// The constant spin ratio of a plot over the Reynolds number [default: 0.1].
    #[arg(long, value_name = "NUMBER", allow_negative_numbers = true)]
    pub spin_ratio: Option<String>,
}

#[derive(clap::Args)]
pub struct PlotTrajectory {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    #[command(flatten)]
    pub drawing: Drawing,

    /// The side from which the trajectory is shown.
    #[arg(long, value_enum, default_value_t = Seen::Side)]
    pub view: Seen,
}

#[derive(clap::Args)]
pub struct PlotFairway {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    #[command(flatten)]
    pub search: SearchArgs,

    #[command(flatten)]
    pub drawing: Drawing,

    /// The standard deviation of a parameter of the golfer from drive to drive, e.g.
    /// swing.face_angle=2deg. Repeatable; other parameters of swing, strike and club have the
    /// default uncertainties of "longdrive sensitivity".
    #[arg(long, value_name = "NAME=AMOUNT")]
    pub sigma: Vec<String>,
}

#[derive(clap::Args)]
pub struct PlotFace {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    #[command(flatten)]
    pub drawing: Drawing,
}

#[derive(clap::Args)]
pub struct PlotStrike {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    #[command(flatten)]
    pub search: SearchArgs,

    /// A preset or setup file of another design to draw in place of the optimum, e.g. best.toml of
    /// "longdrive optimize -o".
    #[arg(long, value_name = "SETUP")]
    pub after: Option<String>,

    #[command(flatten)]
    pub drawing: Drawing,
}

#[derive(clap::Args)]
pub struct PlotLaunch {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    #[command(flatten)]
    pub search: SearchArgs,

    #[command(flatten)]
    pub drawing: Drawing,
}

#[derive(clap::Args)]
pub struct PlotContour {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    #[command(flatten)]
    pub search: SearchArgs,

    #[command(flatten)]
    pub drawing: Drawing,
}

#[derive(clap::Args)]
pub struct PlotChart {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    #[command(flatten)]
    pub search: SearchArgs,

    #[command(flatten)]
    pub drawing: Drawing,

    /// The parameter to follow the optimum along, with its range, e.g. swing.speed=80mph..130mph.
    #[arg(long, value_name = "NAME=LOW..HIGH", allow_hyphen_values = true)]
    pub along: String,

    /// The curve to draw: the outcome, or one of the parameters varied.
    #[arg(long, value_name = "NAME")]
    pub show: Option<String>,
}

#[derive(clap::Args)]
pub struct PlotPareto {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    #[command(flatten)]
    pub asked: ParetoAsked,

    #[command(flatten)]
    pub drawing: Drawing,
}

#[derive(clap::Args)]
pub struct PlotTornado {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    #[command(flatten)]
    pub drawing: Drawing,

    /// The outcome.
    #[arg(long, value_name = "OUTCOME", default_value = "carry")]
    pub of: String,

    /// The standard uncertainty of a parameter, e.g. swing.speed=1mph or air.density=0.5%.
    /// Repeatable; other parameters have the default uncertainties of "longdrive sensitivity".
    #[arg(long, value_name = "NAME=AMOUNT")]
    pub sigma: Vec<String>,

    /// The uncertainties to draw.
    #[arg(long, value_enum, default_value_t = Moved::Control)]
    pub show: Moved,
}

#[derive(clap::Args)]
pub struct PlotCompare {
    #[command(flatten)]
    pub pair: Pair,

    #[command(flatten)]
    pub drawing: Drawing,

    /// The outcome.
    #[arg(long, value_name = "OUTCOME", default_value = "carry")]
    pub of: String,
}

#[derive(clap::Args)]
pub struct PlotVcurve {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    #[command(flatten)]
    pub drawing: Drawing,

    /// The outcomes, separated by commas.
    #[arg(
        long,
        value_name = "OUTCOME,…",
        value_delimiter = ',',
        default_value = "carry"
    )]
    pub of: Vec<String>,

    /// The parameters, separated by commas. Without: loft and attack angle, or the launch
    /// conditions if they are given.
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    pub wrt: Vec<String>,
}

#[derive(clap::Args)]
pub struct Report {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    #[command(flatten)]
    pub search: SearchArgs,

    /// The folder to write: index.html, the best drive as setup.toml, and each plot as
    /// NAME-metric.svg, NAME-us.svg and NAME.csv. The folder is created if it does not exist; other
    /// files in it are not touched.
    #[arg(long, short, value_name = "DIR")]
    pub output: PathBuf,

    /// Replace files that exist.
    #[arg(long)]
    pub overwrite: bool,

    /// The standard uncertainty of a parameter, e.g. swing.speed=1mph or air.density=0.5%.
    /// Repeatable; other parameters have the default uncertainties of "longdrive sensitivity".
    #[arg(long, value_name = "NAME=AMOUNT")]
    pub sigma: Vec<String>,

    /// The parameter to follow the optimum along, with its range [default:
    /// swing.speed=80mph..130mph; with --launch, launch.ball_speed=120mph..190mph; around the
    /// drive's own speed if this is outside of the range].
    #[arg(long, value_name = "NAME=LOW..HIGH", allow_hyphen_values = true)]
    pub along: Option<String>,
}
