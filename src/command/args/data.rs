//! Measured shots and published studies.

use super::number::{U32, whole};
use super::{OwnLaw, SetupArgs};
use std::path::PathBuf;

#[derive(clap::Args)]
#[command(group = clap::ArgGroup::new("written").args(["output", "plot"]).multiple(true))]
pub struct Calibrate {
    /// Measured shots as CSV, one row per shot; the head of each column names a parameter or an
    /// outcome and its unit, as in "carry [yd]"; see docs/calibration.md.
    #[arg(value_name = "DATA")]
    pub data: PathBuf,

    #[command(flatten)]
    pub setup_args: SetupArgs,

    /// Read only the rows with this text in a column, e.g. Club=Driver, in upper or lower case;
    /// several texts of one column are alternatives. Repeatable.
    #[arg(long, value_name = "COLUMN=VALUE")]
    pub only: Vec<String>,

    /// A parameter to fit, e.g. aero.cd0 or aero.cd0=0.1..0.4. Repeatable.
    #[arg(
        long,
        value_name = "NAME[=LOW..HIGH]",
        required = true,
        allow_hyphen_values = true
    )]
    pub fit: Vec<String>,

    /// Use Huber's loss: an outlier has no more influence than a residual of 1.345 σ.
    #[arg(long)]
    pub huber: bool,

    /// Search from this many starts: the setup's own values, then points spread evenly over the
    /// fitted ranges. State these ranges: the default is the whole allowed range, in which few
    /// drives fly.
    #[arg(
        long,
        value_name = "N",
        default_value_t = 1,
        value_parser = whole::<u32>(1..=U32, "`starts 8`"),
        allow_negative_numbers = true,
    )]
    pub starts: u32,

    /// Cross-validate: fit K times, each time without a K-th of the rows, and show the prediction
    /// errors of the omitted rows.
    #[arg(
        long,
        value_name = "K",
        default_value_t = 0,
        value_parser = whole::<u32>(0..=U32, "`folds 5`"),
        allow_negative_numbers = true,
    )]
    pub folds: u32,

    /// Compare with another aerodynamic law, as published and fitted, by its cross-validation
    /// error. Repeatable.
    #[arg(long, value_name = "LAW")]
    pub compare: Vec<String>,

    /// The largest number of iterations of a search.
    #[arg(
        long,
        value_name = "N",
        default_value_t = 200,
        value_parser = whole::<u64>(0..=u64::MAX, "`max_iterations 200`"),
        allow_negative_numbers = true,
    )]
    pub max_iterations: u64,

    /// Write the fitted setup into this file.
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// Write the report into this folder too: a page (index.html), Markdown, and plots of the
    /// residuals with their data.
    #[arg(long, value_name = "DIR")]
    pub plot: Option<PathBuf>,

    /// Replace files that exist.
    #[arg(long, requires = "written")]
    pub overwrite: bool,
}

#[derive(clap::Args)]
#[command(group(clap::ArgGroup::new("written").args(["output", "swings"]).multiple(true)))]
pub struct DeliveryArgs {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    /// The measured speed of the ball, e.g. 167mph.
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true)]
    pub ball_speed: Option<String>,

    /// The measured angle of the launch above horizontal, e.g. 10.9deg.
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    pub launch_angle: Option<String>,

    /// The measured direction of the launch, + right of the target line [default: not measured].
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    pub launch_direction: Option<String>,

    /// The measured total spin, e.g. 2686rpm; with --spin-axis.
    #[arg(long, value_name = "SPIN", allow_hyphen_values = true)]
    pub spin: Option<String>,

    /// The measured tilt of the spin axis, + for a ball that curves to the right [default: not
    /// measured].
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    pub spin_axis: Option<String>,

    /// The measured backspin, in place of --spin; with --sidespin.
    #[arg(long, value_name = "SPIN", allow_hyphen_values = true)]
    pub backspin: Option<String>,

    /// The measured sidespin, + for a ball that curves to the right [default: not measured].
    #[arg(long, value_name = "SPIN", allow_hyphen_values = true)]
    pub sidespin: Option<String>,

    /// Measured shots as CSV, one row per shot, as a launch monitor exports them or as calibrate
    /// reads them. Club values in a row count as measured too.
    #[arg(long, value_name = "FILE")]
    pub shots: Option<PathBuf>,

    /// Read only the rows with this text in a column, e.g. Club=Driver, in upper or lower case;
    /// several texts of one column are alternatives. Repeatable.
    #[arg(long, value_name = "COLUMN=VALUE", requires = "shots")]
    pub only: Vec<String>,

    /// A parameter to find and its range, e.g. club.loft=4deg..20deg. Repeatable [default: the
    /// speed, attack angle, shaft lean, path and face angle of the swing, and the impact point on
    /// the face].
    #[arg(long, value_name = "NAME=LOW..HIGH", allow_hyphen_values = true)]
    pub vary: Vec<String>,

    /// The prior standard uncertainty of a parameter about its value in the setup, e.g.
    /// swing.attack_angle=1deg. Repeatable.
    #[arg(long, value_name = "NAME=AMOUNT")]
    pub sigma: Vec<String>,

    /// Write the setup with the delivery into this file; for several shots, with their mean
    /// delivery.
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// Write the swings that explain the shots into this file, for "longdrive optimize --swings": a
    /// table with a row for each shot (.csv), or distributions with correlations, without the
    /// errors of the launch monitor (.toml).
    #[arg(long, value_name = "FILE", requires = "shots")]
    pub swings: Option<PathBuf>,

    /// Replace files that exist.
    #[arg(long, requires = "written")]
    pub overwrite: bool,
}

#[derive(clap::Args)]
pub struct Reproduce {
    /// The study.
    #[arg(value_enum, value_name = "STUDY")]
    pub study: Published,

    /// Print the answer as JSON (SI units and radians), and nothing else, to standard output.
    #[arg(long)]
    pub json: bool,

    /// Write the study into this folder too: a page (index.html), Markdown, and every plot as SVG
    /// with its data as CSV.
    #[arg(long, short, value_name = "DIR")]
    pub output: Option<PathBuf>,

    /// Replace files that exist.
    #[arg(long, requires = "output")]
    pub overwrite: bool,
}

#[derive(clap::Args)]
pub struct Validate {
    /// Print the answer as JSON (SI units and radians), and nothing else, to standard output.
    #[arg(long)]
    pub json: bool,

    /// Print every law on every drive as CSV (SI units and radians) to standard output.
    #[arg(long, conflicts_with = "json")]
    pub csv: bool,

    /// Write the comparison to this folder, as a page (index.html) and Markdown with pictures and
    /// their data; or, to a name that ends in .csv, every law on every drive.
    #[arg(long, short, value_name = "DIR or FILE.csv")]
    pub output: Option<PathBuf>,

    /// Replace files that exist.
    #[arg(long, requires = "output")]
    pub overwrite: bool,

    #[command(flatten)]
    pub own: OwnLaw,
}

/// A study that can be reproduced.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Published {
    /// The student report "Optimization of a Golf Driver", MAE 494.
    Mae494,
    /// Winfield & Tan (1994), "Optimization of clubhead loft and swing elevation angles".
    WinfieldTan,
}
