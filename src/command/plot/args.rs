//! Options of plots.

use crate::command::args::{DriveArgs, SearchArgs, SetupArgs};
use crate::command::compare::PairArgs;
use crate::command::gradient::DerivativeArgs;
use crate::command::pareto::GoalArgs;
use crate::command::picture::PictureArgs;
use crate::report::figures::{Causes, Coefficient, Over, View};
use clap::Subcommand;

#[derive(clap::Args)]
pub struct Args {
    #[command(subcommand)]
    pub kind: PlotKind,
}

#[derive(Subcommand)]
pub enum PlotKind {
    /// The path of the ball.
    Trajectory {
        #[command(flatten)]
        setup_args: SetupArgs,

        #[command(flatten)]
        drawing: PictureArgs,

        /// The side from which the trajectory is shown.
        #[arg(long, value_enum, default_value_t = View::Side)]
        view: View,
    },
    /// An outcome over two parameters, with its gradients and the optimum.
    Contour(PlotSearch),
    /// The optimum as a function of a parameter.
    Chart {
        #[command(flatten)]
        plot: PlotSearch,

        /// The parameter along which optima are computed, with its range, e.g.
        /// swing.speed=80mph..130mph.
        #[arg(long, value_name = "NAME=LOW..HIGH", allow_hyphen_values = true)]
        along: String,

        /// The curve to draw: the outcome, or one of the parameters varied.
        #[arg(long, value_name = "NAME")]
        show: Option<String>,
    },
    /// The Pareto front of two goals, with its ends, its knee and the slope at the knee.
    Pareto {
        #[command(flatten)]
        setup_args: SetupArgs,

        #[command(flatten)]
        requested: GoalArgs,

        #[command(flatten)]
        drawing: PictureArgs,
    },
    /// The effects of the uncertainties of parameters on an outcome.
    Tornado(PlotTornado),
    /// The difference between two drives, split into the parameters and launch conditions that
    /// differ.
    Compare {
        #[command(flatten)]
        pair: PairArgs,

        #[command(flatten)]
        drawing: PictureArgs,

        /// The outcome.
        #[arg(long, value_name = "OUTCOME", default_value = "carry")]
        of: String,
    },
    /// The error of central differences against exact derivatives, by step.
    Vcurve {
        #[command(flatten)]
        setup_args: SetupArgs,

        #[command(flatten)]
        drawing: PictureArgs,

        #[command(flatten)]
        derivatives: DerivativeArgs,
    },
    /// Laws of drag and lift over the spin ratio or the Reynolds number, with measured points.
    Laws(PlotLaws),
    /// The landings of the drive and of the optimum from above, at true scale, with the ellipses of
    /// half and of 95 % of the landings.
    Fairway {
        #[command(flatten)]
        plot: PlotSearch,

        /// The standard deviation of a parameter of the golfer from drive to drive, e.g.
        /// swing.face_angle=2deg. Repeatable; other parameters of swing, strike and club have the
        /// default uncertainties of "longdrive sensitivity".
        #[arg(long, value_name = "NAME=AMOUNT")]
        sigma: Vec<String>,
    },
    /// The club face from the front: the strike, the sweet spot, contours of lost carry, and the
    /// side to which the spin axis tilts.
    Face {
        #[command(flatten)]
        setup_args: SetupArgs,

        #[command(flatten)]
        drawing: PictureArgs,
    },
    /// Carry, lateral, ball speed and spin axis over the club face, for the drive as set up and for
    /// the optimum, or for two designs.
    Strike {
        #[command(flatten)]
        setup_args: SetupArgs,

        #[command(flatten)]
        search: SearchArgs,

        /// A preset or setup file of another design to draw in place of the optimum, e.g. best.toml
        /// of "longdrive optimize -o".
        #[arg(long, value_name = "SETUP")]
        after: Option<String>,

        #[command(flatten)]
        drawing: PictureArgs,
    },
    /// Carry over launch angle and backspin at the drive's ball speed, with the launches of the
    /// drive and of the optimum.
    Launch(PlotSearch),
}

#[derive(clap::Args)]
pub struct PlotLaws {
    #[command(flatten)]
    pub drive: DriveArgs,

    #[command(flatten)]
    pub drawing: PictureArgs,

    /// The laws, separated by commas; "table" for your own table of --set aero.table [default: all
    /// laws].
    #[arg(long, value_name = "LAW,…", value_delimiter = ',')]
    pub laws: Vec<String>,

    /// The coefficient to draw.
    #[arg(long, value_enum, default_value_t = Coefficient::Drag)]
    pub show: Coefficient,

    /// The horizontal axis.
    #[arg(long, value_enum, default_value_t = Over::SpinRatio)]
    pub over: Over,

    /// The constant Reynolds number of a plot over the spin ratio [default: 1.5e5].
    #[arg(long, value_name = "NUMBER", allow_negative_numbers = true)]
    pub reynolds: Option<String>,

    /// The constant spin ratio of a plot over the Reynolds number [default: 0.1].
    #[arg(long, value_name = "NUMBER", allow_negative_numbers = true)]
    pub spin_ratio: Option<String>,

    /// Print the answer as JSON (SI units and radians), and nothing else, to standard output.
    #[arg(long)]
    pub json: bool,
}

/// A plot with the optimum of a search.
#[derive(clap::Args)]
pub struct PlotSearch {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    #[command(flatten)]
    pub search: SearchArgs,

    #[command(flatten)]
    pub drawing: PictureArgs,
}

#[derive(clap::Args)]
pub struct PlotTornado {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    #[command(flatten)]
    pub drawing: PictureArgs,

    /// The outcome.
    #[arg(long, value_name = "OUTCOME", default_value = "carry")]
    pub of: String,

    /// The standard uncertainty of a parameter, e.g. swing.speed=1mph or air.density=0.5%.
    /// Repeatable; other parameters have the default uncertainties of "longdrive sensitivity".
    #[arg(long, value_name = "NAME=AMOUNT")]
    pub sigma: Vec<String>,

    /// The uncertainties to draw.
    #[arg(long, value_enum, default_value_t = Causes::Control)]
    pub show: Causes,
}
