//! Options of every command, and the commands about the program itself.

use crate::units::System;
#[cfg(feature = "cli")]
use std::path::PathBuf;

/// Options of every command about its output.
#[derive(Clone, Debug, clap::Args)]
#[command(next_help_heading = "Options of every command")]
pub struct OutputOptions {
    /// The units of results in texts, plots and pages [default: us; reproduce: the units of the
    /// study]. JSON is in SI units and radians. Tables name the unit of each column in its head.
    #[arg(long, value_enum, global = true)]
    pub units: Option<Units>,

    /// Print no progress and no remarks on standard error; warnings and errors are printed.
    #[arg(long, short, global = true)]
    pub quiet: bool,

    /// Print the whole answer, also tables and rows for which a screen has no room.
    #[arg(long, global = true)]
    pub all: bool,

    /// Print details of the computation too: each iteration, the KKT residual, and what was left
    /// out.
    #[arg(long, global = true, conflicts_with = "quiet")]
    pub verbose: bool,
}

/// The units of results.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Units {
    /// Metres and metres per second.
    Metric,
    /// Yards and miles per hour.
    Us,
}

impl From<Units> for System {
    fn from(units: Units) -> Self {
        match units {
            Units::Metric => Self::Metric,
            Units::Us => Self::Us,
        }
    }
}

#[cfg(feature = "cli")]
#[derive(clap::Args)]
pub struct Completions {
    /// The shell.
    #[arg(value_enum, value_name = "SHELL")]
    pub shell: clap_complete::Shell,
}

#[cfg(feature = "cli")]
#[derive(clap::Args)]
pub struct Man {
    /// The command whose page is printed, e.g. "optimize" or "plot contour"; without it, the page
    /// of the program.
    #[arg(value_name = "COMMAND")]
    pub command: Vec<String>,

    /// Write the page of every command into this folder instead, as longdrive.1,
    /// longdrive-optimize.1, …. The folder is created if it does not exist.
    #[arg(long, short, value_name = "DIR", conflicts_with = "command")]
    pub output: Option<PathBuf>,

    /// Replace files that exist.
    #[arg(long, requires = "output", conflicts_with = "command")]
    pub overwrite: bool,
}
