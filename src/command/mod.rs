//! The commands of the program, with the syntax of its command line.
//!
//! Each command reads its request, calls the library, and answers as text or as one JSON object.
//!
//! ```
//! use longdrive::command::{Host, MessageKind, run};
//! use std::io;
//! use std::sync::{Arc, Mutex};
//!
//! #[derive(Default)]
//! struct Notes {
//!     answer: Mutex<String>,
//! }
//!
//! impl Host for Notes {
//!     fn print(&self, text: &str) -> io::Result<()> {
//!         self.answer.lock().unwrap().push_str(text);
//!         Ok(())
//!     }
//!     fn say(&self, _: MessageKind, _: &str) {}
//! }
//!
//! let notes = Arc::new(Notes::default());
//! let status = run(["longdrive", "presets", "--json"].map(Into::into).to_vec(), notes.clone());
//! assert_eq!(status, 0);
//! assert!(notes.answer.lock().unwrap().contains("\"mae494\""));
//! ```

mod args;
mod calibrate;
mod call;
mod chart;
#[cfg(feature = "cli")]
mod colour;
mod compare;
#[cfg(feature = "cli")]
mod completions;
mod date;
mod delivery;
mod described;
mod design;
mod explore;
mod files;
mod fly;
mod gradient;
mod help;
mod host;
mod interrupt;
mod laws;
mod listener;
#[cfg(feature = "cli")]
mod man;
mod mention;
mod names;
mod optimize;
mod optimum_sensitivity;
mod output;
mod parameters;
mod pareto;
mod picture;
mod plot;
mod presets;
mod ranges;
mod report;
mod reproduce;
mod request;
mod robust;
mod rows_target;
mod run;
mod running;
#[cfg(test)]
mod schemas;
mod search;
mod sensitivity;
mod simulate;
mod sweep;
mod swings;
#[cfg(feature = "cli")]
mod terminal;
mod uncertainty;
mod usage;
mod validate;
mod verify;
mod width;
mod wording;

pub use crate::input_file::{MemoryFiles, with_memory_files};
pub use args::SwingsArgs;
pub use call::{ArgumentValue, Call, quantity_of, quantity_of_goal, with_degrees};
pub use described::described;
pub use host::{Host, MessageKind, Progress, Work};
pub use mention::{Mention, mark_options};
pub use request::refuse_idle;
pub use run::{call, run};
#[cfg(feature = "cli")]
pub use run::{main, run_in_terminal};

use crate::Result;
#[cfg(test)]
use crate::report::*;
use clap::{ArgMatches, CommandFactory, FromArgMatches, Parser, Subcommand};
use std::ffi::OsString;
use std::sync::LazyLock;

/// The groups of commands in the help, in the order of a user's questions.
const GROUPS: [(&str, &[&str]); 5] = [
    (
        "Your drive",
        &[
            "simulate", "compare", "optimize", "chart", "explore", "report", "plot",
        ],
    ),
    ("Your shots", &["fly", "delivery", "calibrate"]),
    (
        "What matters",
        &[
            "gradient",
            "sensitivity",
            "optimum-sensitivity",
            "uncertainty",
        ],
    ),
    ("Design", &["design", "pareto", "robust", "sweep"]),
    (
        "Reference",
        &[
            "parameters",
            "presets",
            "laws",
            "reproduce",
            "validate",
            "verify",
            "completions",
            "man",
        ],
    ),
];

/// Declares the commands. Each has its help, its variant of [`Command`], its module with `Args` and
/// `run`, and the types of its answers in JSON.
macro_rules! commands {
    ($(
        $(#[doc = $help:tt])*
        $(#[cfg($condition:meta)])?
        $Name:ident($module:ident) $(: $($(#[cfg($of:meta)])? $Answer:ty),+)?;
    )*) => {
        #[derive(Subcommand)]
        enum Command {
            $($(#[doc = $help])* $(#[cfg($condition)])? $Name($module::Args),)*
        }

        impl Command {
            fn answer(&self) -> Result<output::Answer> {
                match self {
                    $($(#[cfg($condition)])? Self::$Name(args) => $module::run(args),)*
                }
            }
        }

        #[cfg(test)]
        fn answers() -> Vec<schemas::Answers> {
            let mut all = vec![];
            $($(#[cfg($condition)])? {
                let answers = schemas::Answers::new(stringify!($module));
                $($($(#[cfg($of)])? let answers = answers.or::<$Answer>();)+)?
                all.push(answers);
            })*
            all
        }
    };
}

commands! {
    /// Compute one drive: impact, launch, flight, landing.
    Simulate(simulate): DriveReport<'_>;
    /// Exact derivatives of outcomes by parameters.
    Gradient(gradient): GradientReport<'_>;
    /// Compare two drives, with the cause of each difference.
    ///
    /// The outcomes of both, and the share of each parameter and launch condition in the
    /// difference.
    Compare(compare): ComparisonReport<'_>;
    /// Find the drive that carries farthest, or any best outcome.
    ///
    /// Finds the parameters that maximize or minimize an outcome: by default, the loft and attack
    /// angle of the longest carry.
    Optimize(optimize): OptimizeReport<'_>;
    /// Sensitivity of the optimum, and how flat it is.
    ///
    /// How the optimum depends on every other parameter, and the price of its bounds and
    /// constraints.
    OptimumSensitivity(optimum_sensitivity): OptimumSensitivityReport<'_>;
    /// Design head and face under the Rules of Golf.
    ///
    /// For swings that vary: the best bulge, roll, loft, inertia or movable weights, with the price
    /// of each rule.
    Design(design): DesignReport<'_>;
    /// Fit parameters to measured shots.
    ///
    /// Also finds their uncertainties, and the combinations of parameters that the data do not
    /// determine.
    Calibrate(calibrate): CalibrationReport<'_>;
    /// Find the swing and strike behind a measured launch.
    ///
    /// Also finds the combinations of parameters that the launch does not determine.
    Delivery(delivery): DeliveryReport<'_>;
    /// The optimum along a parameter, such as club speed.
    Chart(chart): ChartReport<'_>;
    /// The best compromises between two goals.
    ///
    /// For example between carry and dispersion. Also computes their rate of exchange.
    Pareto(pareto): ParetoReport<'_>;
    /// The design that loses least, whichever model is true.
    ///
    /// Several models of impact and flight are compared. The loss of a design under a model
    /// is its difference from the best design for this model.
    Robust(robust): RobustReport<'_>;
    /// Open the drive as a page with sliders.
    ///
    /// Serves the explorer on this machine until Ctrl-C, and prints its address. The page computes
    /// by itself; it sends nothing.
    Explore(explore);
    /// Draw a plot as SVG or PNG, or write its data as CSV.
    Plot(plot): picture::PlotFile<'_>;
    /// Write a page: drive, optimum, map, sensitivities.
    ///
    /// An HTML page of the drive, the optimum, a map around it, sensitivities and uncertainties,
    /// with plots and data.
    Report(report): report::ReportFiles<'_>;
    /// Compute very many drives to CSV, JSON Lines or Parquet.
    ///
    /// At the points of a grid, a quasi-random sequence or a table.
    Sweep(sweep):
        sweep::SweepSummary,
        #[cfg(feature = "parquet")] sweep::parts::WrittenPart,
        #[cfg(feature = "parquet")] crate::parts::Checked;
    /// Fly the shots of a launch monitor.
    ///
    /// Reads a CSV export or messages of GSPro Open Connect, and compares predicted with measured
    /// flights.
    Fly(fly): ShotsReport, fly::listen::MessageCounts;
    /// Reproduce a published study, number by number.
    Reproduce(reproduce): Mae494Report<'_>, WinfieldTanReport<'_>;
    /// Compare every law of flight with published drives.
    ///
    /// Bias and mean absolute error of carry, apex and descent.
    Validate(validate): ValidationReport<'_>;
    /// Check every derivative against finite differences.
    ///
    /// Also checks smoothness, convergence and the landing; exit status 1 if a check fails.
    Verify(verify): CertificateReport<'_>;
    /// Effect of each parameter on the outcomes.
    ///
    /// Slopes, elasticities, and the effect of the uncertainty of each parameter.
    Sensitivity(sensitivity): SensitivityReport<'_>;
    /// Spread of the outcomes from uncertain parameters.
    ///
    /// By exact derivatives, and by a sample of drives.
    Uncertainty(uncertainty): UncertaintyReport<'_>;
    /// List the parameters: unit, range, default, meaning.
    Parameters(parameters): ParametersReport;
    /// List the presets, or print one as a setup file.
    ///
    /// With the source of each number.
    Presets(presets): PresetsReport;
    /// List the laws of drag and lift.
    ///
    /// Authors, formula, ball, source, and fitted range of each law.
    Laws(laws): LawsReport;
    /// Print a script for completion in a shell.
    #[cfg(feature = "cli")]
    Completions(completions);
    /// Print a manual page, or write all of them.
    #[cfg(feature = "cli")]
    Man(man);
}

/// The longest golf drive, with exact derivatives.
///
/// Computes the impact (rigid bodies, ellipsoidal face), the flight (drag, lift, spin decay, wind)
/// and the landing of a golf drive, and the exact derivatives of every outcome with respect to
/// every parameter. Exit status: 0 done, 1 no answer (no flight, not converged), 2 bad input.
#[derive(Parser)]
#[command(version)]
struct Program {
    #[command(flatten)]
    output: args::OutputOptions,

    #[command(subcommand)]
    command: Command,

    /// The name of the command.
    #[arg(skip)]
    name: &'static str,

    /// True for an answer in JSON.
    #[arg(skip)]
    is_json: bool,
}

impl Program {
    /// Reads a command line.
    ///
    /// # Errors
    /// If `words` are no command line of this program, and for `--help` and `--version`.
    fn read(words: &[OsString]) -> Result<Self, clap::Error> {
        let width = width::of_answers();
        let with_help = program()
            .clone()
            .term_width(width)
            .help_template(help::template(program(), &GROUPS, width));
        let matches = with_help.try_get_matches_from(words)?;
        let command = matches
            .subcommand_name()
            .and_then(|name| program().find_subcommand(name));
        Ok(Self {
            name: command.map_or("", clap::Command::get_name),
            is_json: asks_for_json(&matches),
            ..Self::from_arg_matches(&matches)?
        })
    }
}

/// True if `--json` is among the arguments of the command.
fn asks_for_json(matches: &ArgMatches) -> bool {
    // `try_get_one` fails for a command without this option
    let json = matches.try_get_one::<bool>("json").ok().flatten();
    let below = matches.subcommand();
    json == Some(&true) || below.is_some_and(|(_, matches)| asks_for_json(matches))
}

/// The command of an invalid command line, for the error in JSON: the first of `words` that is the
/// name of a command with `--json`.
fn named_in(words: &[OsString]) -> Option<&'static str> {
    let with_json = mention::commands_with(program(), "json");
    let has_json = |name| {
        let mut names = with_json.iter().map(|names| names.split(' ').next());
        names.any(|other| other == Some(name))
    };
    words.iter().find_map(|word| {
        let mut names = program().get_subcommands().map(clap::Command::get_name);
        names.find(|name| word == name && has_json(name))
    })
}

/// The program, with the options of all commands.
fn program() -> &'static clap::Command {
    static PROGRAM: LazyLock<clap::Command> =
        LazyLock::new(|| help::with_outcomes(Program::command()));
    &PROGRAM
}

/// Formats the arguments and commands of a message with `write`.
///
/// ```
/// use longdrive::command::{Mention, with_mentions};
/// let message = "give a range, as in `vary club.loft=4deg..20deg`";
/// let program = with_mentions(message, |mention| mention.in_command_line_syntax());
/// assert_eq!(program, "give a range, as in --vary club.loft=4deg..20deg");
/// ```
pub fn with_mentions(message: &str, write: impl Fn(Mention<'_>) -> String) -> String {
    mention::with_mentions_of(program(), message, write)
}
