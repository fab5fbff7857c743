//! What can be asked on the command line.

mod certainty;
mod data;
mod many;
mod picture;
mod program;
mod question;
mod search;

pub use certainty::{SensitivityArgs, UncertaintyArgs, Verify};
pub use data::{Calibrate, Published, Reproduce};
pub use many::{Format, Sweep};
pub use picture::{
    Drawing, Plot, PlotChart, PlotContour, PlotKind, PlotTornado, PlotTrajectory, PlotVcurve, Report, Seen,
};
pub use program::{Completions, Man, Shown};
pub use question::{Gradient, Parameters, Presets, Question, Simulate};
pub use search::{ChartArgs, Optimize, OptimumSensitivity, SearchArgs, WorkArgs};

use clap::{Parser, Subcommand};

/// The longest golf drive, with exact derivatives.
///
/// A drive is hit (rigid bodies, ellipsoidal face), flown (drag, lift, spin decay, wind) and landed; every
/// outcome has exact derivatives by every parameter. Exit status: 0 done, 1 no answer (no flight, not
/// converged), 2 bad input.
#[derive(Parser)]
#[command(version, max_term_width = 100)]
pub struct Args {
    #[command(flatten)]
    pub shown: Shown,

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
    /// Print a script that completes commands and options in a shell.
    Completions(Completions),
    /// Print a manual page, or write the pages of all commands.
    Man(Man),
}
