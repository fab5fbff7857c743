//! How sure derivatives and outcomes are.

use super::Question;
use super::SearchArgs;

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
