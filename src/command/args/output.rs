//! Options of every command.

use crate::units::System;
use clap::ValueEnum;
use clap::builder::PossibleValue;

/// Options about the output, for every command.
#[derive(Clone, Debug, Default, clap::Args)]
#[command(next_help_heading = "Options of every command")]
pub struct OutputOptions {
    /// The units of results in texts, plots and pages [default: us; reproduce: the units of the
    /// study]. JSON is in SI units and radians. Tables name the unit of each column in its head.
    #[arg(long, value_enum, global = true)]
    pub units: Option<System>,

    /// Print no progress and no remarks on standard error; warnings and errors are printed.
    #[arg(long, short, global = true)]
    pub quiet: bool,

    /// Print all tables and rows, also those that are left out to fit a screen.
    #[arg(long, global = true)]
    pub all: bool,

    /// Print details of the computation too: each iteration, the KKT residual, and what was left
    /// out.
    #[arg(long, global = true, conflicts_with = "quiet")]
    pub verbose: bool,
}

impl ValueEnum for System {
    fn value_variants<'a>() -> &'a [Self] {
        &Self::ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let help = match self {
            Self::Metric => "Metres and metres per second",
            Self::Us => "Yards and miles per hour",
        };
        let value = PossibleValue::new(self.name()).help(help);
        Some(match self {
            Self::Metric => value,
            // else clap proposes `metric` for this word
            Self::Us => value.alias("imperial"),
        })
    }
}
