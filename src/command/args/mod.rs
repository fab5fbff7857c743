//! Arguments of the command line.

// these doc comments are help texts, in which "carry [yd]" is a column head, not a link
#![allow(rustdoc::broken_intra_doc_links)]

mod certainty;
mod compare;
mod data;
mod fly;
mod help;
mod many;
mod number;
mod pareto;
mod picture;
mod program;
mod robust;
mod search;
mod setup;

pub use certainty::{SensitivityArgs, UncertaintyArgs, Verify};
pub use compare::{Compare, Pair};
pub use data::{Calibrate, DeliveryArgs, Published, Reproduce, Validate};
pub use fly::{Fly, FlyFormat};
#[cfg(feature = "parquet")]
pub use many::PartOf;
pub use many::{Format, Sweep};
pub use pareto::{ParetoArgs, ParetoAsked};
pub use picture::{
    Drawing, Drawn, LawsOver, Moved, Plot, PlotChart, PlotCompare, PlotContour, PlotFace,
    PlotFairway, PlotKind, PlotLaunch, PlotLaws, PlotPareto, PlotStrike, PlotTornado,
    PlotTrajectory, PlotVcurve, Report, Seen,
};
pub use program::OutputOptions;
#[cfg(feature = "cli")]
pub use program::{Completions, Man};
pub use robust::RobustArgs;
pub use search::{
    ChartArgs, DesignArgs, Optimize, OptimumSensitivity, SearchArgs, SwingsArgs, WorkArgs,
};
pub use setup::{
    DriveArgs, Explore, Gradient, Laws, OwnLaw, Parameters, Presets, SETUP, SetupArgs, Simulate,
};

use super::width;
use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use std::ffi::OsString;

/// The longest golf drive, with exact derivatives.
///
/// Computes the impact (rigid bodies, ellipsoidal face), the flight (drag, lift, spin decay, wind)
/// and the landing of a golf drive, and the exact derivatives of every outcome with respect to
/// every parameter. Exit status: 0 done, 1 no answer (no flight, not converged), 2 bad input.
#[derive(Parser)]
#[command(version)]
pub struct Args {
    #[command(flatten)]
    pub shown: OutputOptions,

    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand)]
pub enum Command {
    /// Compute one drive: impact, launch, flight, landing.
    Simulate(Simulate),
    /// Exact derivatives of outcomes by parameters.
    Gradient(Gradient),
    /// Compare two drives, with the cause of each difference.
    ///
    /// The outcomes of both, and the share of each parameter and launch condition in the
    /// difference.
    Compare(Compare),
    /// Find the drive that carries farthest, or any best outcome.
    ///
    /// Finds the parameters that maximize or minimize an outcome: by default, the loft and attack
    /// angle of the longest carry.
    Optimize(Optimize),
    /// Sensitivity of the optimum, and how flat it is.
    ///
    /// How the optimum depends on every other parameter, and the price of its bounds and
    /// constraints.
    OptimumSensitivity(OptimumSensitivity),
    /// Design head and face under the Rules of Golf.
    ///
    /// For swings that vary: the best bulge, roll, loft, inertia or movable weights, with the price
    /// of each rule.
    Design(DesignArgs),
    /// Fit parameters to measured shots.
    ///
    /// With their uncertainties, and the combinations of parameters that the data do not determine.
    Calibrate(Calibrate),
    /// Find the swing and strike behind a measured launch.
    ///
    /// With the combinations of parameters that the launch does not determine.
    Delivery(DeliveryArgs),
    /// The optimum along a parameter, such as club speed.
    Chart(ChartArgs),
    /// The best compromises between two goals.
    ///
    /// For example carry and dispersion, with the rate of exchange between them.
    Pareto(ParetoArgs),
    /// The design that loses least, whichever model is true.
    ///
    /// Several models of impact and flight are compared.
    Robust(RobustArgs),
    /// Open the drive as a page with sliders.
    ///
    /// Serves the explorer on this machine until Ctrl-C, and prints its address. The page computes
    /// by itself; it sends nothing.
    Explore(Explore),
    /// Draw a plot as SVG or PNG, or write its data as CSV.
    Plot(Plot),
    /// Write a page: drive, optimum, map, sensitivities.
    ///
    /// An HTML page of the drive, the optimum, a map around it, sensitivities and uncertainties,
    /// with plots and data.
    Report(Report),
    /// Compute very many drives to CSV, JSON Lines or Parquet.
    ///
    /// At the points of a grid, a quasi-random sequence or a table.
    Sweep(Sweep),
    /// Fly the shots of a launch monitor.
    ///
    /// From a CSV export or GSPro Open Connect: predicted flights, compared with the measured
    /// flights.
    Fly(Fly),
    /// Reproduce a published study, number by number.
    Reproduce(Reproduce),
    /// Compare every law of flight with published drives.
    ///
    /// Bias and mean absolute error of carry, apex and descent.
    Validate(Validate),
    /// Check every derivative against finite differences.
    ///
    /// Also checks smoothness, convergence and the landing; exit status 1 if a check fails.
    Verify(Verify),
    /// Effect of each parameter on the outcomes.
    ///
    /// Slopes, elasticities, and the effect of the uncertainty of each parameter.
    Sensitivity(SensitivityArgs),
    /// Spread of the outcomes from uncertain parameters.
    ///
    /// By exact derivatives, and by a sample of drives.
    Uncertainty(UncertaintyArgs),
    /// List the parameters: unit, range, default, meaning.
    Parameters(Parameters),
    /// List the presets, or print one as a setup file.
    ///
    /// With the source of each number.
    Presets(Presets),
    /// List the laws of drag and lift.
    ///
    /// Authors, formula, ball, source, and fitted range of each law.
    Laws(Laws),
    /// Print a script for completion in a shell.
    #[cfg(feature = "cli")]
    Completions(Completions),
    /// Print a manual page, or write all of them.
    #[cfg(feature = "cli")]
    Man(Man),
}

impl Args {
    /// The program, with its commands in groups.
    fn program() -> clap::Command {
        let program = Self::command().term_width(width::of_answers());
        let template = help::template(&program, width::of_answers());
        program.help_template(template)
    }

    /// Reads a command line.
    ///
    /// # Errors
    /// For words that are no command line of this program, and for `--help` and `--version`.
    pub fn read(words: &[OsString]) -> Result<Self, clap::Error> {
        let matches = Self::program().try_get_matches_from(words)?;
        Self::from_arg_matches(&matches)
    }
}

impl Command {
    /// Commands with `--json`.
    const NAMES: [&str; 23] = [
        "simulate",
        "gradient",
        "compare",
        "optimize",
        "optimum-sensitivity",
        "design",
        "calibrate",
        "delivery",
        "chart",
        "pareto",
        "robust",
        "plot",
        "report",
        "sweep",
        "fly",
        "reproduce",
        "validate",
        "verify",
        "sensitivity",
        "uncertainty",
        "parameters",
        "presets",
        "laws",
    ];

    /// The command in arguments that could not be parsed.
    pub fn named_in(words: &[OsString]) -> Option<&'static str> {
        words
            .iter()
            .find_map(|word| Self::NAMES.into_iter().find(|name| word == name))
    }

    /// The name on the command line, and true for an answer in JSON.
    fn asked(&self) -> (&'static str, bool) {
        match self {
            Self::Simulate(args) => ("simulate", args.setup_args.json),
            Self::Gradient(args) => ("gradient", args.setup_args.json),
            Self::Compare(args) => ("compare", args.pair.setup_args.json),
            Self::Optimize(args) => ("optimize", args.setup_args.json),
            Self::OptimumSensitivity(args) => {
                ("optimum-sensitivity", args.optimize.setup_args.json)
            }
            Self::Design(args) => ("design", args.optimize.setup_args.json),
            Self::Calibrate(args) => ("calibrate", args.setup_args.json),
            Self::Delivery(args) => ("delivery", args.setup_args.json),
            Self::Chart(args) => ("chart", args.setup_args.json),
            Self::Pareto(args) => ("pareto", args.setup_args.json),
            Self::Robust(args) => ("robust", args.setup_args.json),
            Self::Explore(_) => ("explore", false),
            Self::Plot(args) => ("plot", args.kind.setup_args().json),
            Self::Report(args) => ("report", args.setup_args.json),
            Self::Sweep(args) => ("sweep", args.setup_args.json),
            Self::Fly(args) => ("fly", args.setup_args.json),
            Self::Reproduce(args) => ("reproduce", args.json),
            Self::Validate(args) => ("validate", args.json),
            Self::Verify(args) => ("verify", args.setup_args.json),
            Self::Sensitivity(args) => ("sensitivity", args.setup_args.json),
            Self::Uncertainty(args) => ("uncertainty", args.setup_args.json),
            Self::Parameters(args) => ("parameters", args.setup_args.json),
            Self::Presets(args) => ("presets", args.json),
            Self::Laws(args) => ("laws", args.json),
            #[cfg(feature = "cli")]
            Self::Completions(_) => ("completions", false),
            #[cfg(feature = "cli")]
            Self::Man(_) => ("man", false),
        }
    }

    /// Name on the command line.
    pub fn name(&self) -> &'static str {
        self.asked().0
    }

    /// Returns true if the answer is JSON.
    pub fn is_json(&self) -> bool {
        self.asked().1
    }
}
