//! Options of the commands on accuracy and uncertainty.

use super::SearchArgs;
use super::SetupArgs;
use super::number::whole;

#[derive(clap::Args)]
pub struct Verify {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    /// The outcomes, separated by commas; "all" for every one.
    #[arg(
        long,
        value_name = "OUTCOME,…",
        value_delimiter = ',',
        default_value = "carry,lateral"
    )]
    pub of: Vec<String>,

    /// The parameters, separated by commas; "all" for every one that has a value in this setup.
    #[arg(
        long,
        value_name = "NAME,…",
        value_delimiter = ',',
        default_value = "all"
    )]
    pub wrt: Vec<String>,
}

#[derive(clap::Args)]
pub struct SensitivityArgs {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    /// The outcomes, separated by commas; "all" for every one.
    #[arg(
        long,
        value_name = "OUTCOME,…",
        value_delimiter = ',',
        default_value = "carry"
    )]
    pub of: Vec<String>,

    /// The standard uncertainty of a parameter, e.g. swing.speed=1mph or air.density=0.5% of its
    /// value. Repeatable.
    #[arg(long, value_name = "NAME=AMOUNT")]
    pub sigma: Vec<String>,

    /// Use no default uncertainties: only parameters with a --sigma are uncertain.
    #[arg(long)]
    pub no_defaults: bool,

    /// Compute the slopes and effects at the optimum of a search, and show the total derivatives of
    /// the optimum too.
    #[arg(long)]
    pub at_optimum: bool,

    #[command(flatten)]
    pub search: SearchArgs,
}

#[derive(clap::Args)]
pub struct UncertaintyArgs {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    /// The outcomes, separated by commas; "all" for every one. For carry and lateral together,
    /// landing ellipses are computed.
    #[arg(
        long,
        value_name = "OUTCOME,…",
        value_delimiter = ',',
        default_value = "carry,lateral"
    )]
    pub of: Vec<String>,

    /// The standard deviation of a parameter that is normally distributed about its value, e.g.
    /// swing.speed=1mph or air.density=0.5% of its value. Repeatable [default, without
    /// --distribution: the uncertainties that "sensitivity" uses].
    #[arg(long, value_name = "NAME=AMOUNT")]
    pub sigma: Vec<String>,

    /// The distribution of a parameter: NAME=normal(MEAN,DEVIATION), NAME=uniform(LOW,HIGH),
    /// NAME=triangular(LOW,MODE,HIGH) or NAME=truncated(MEAN,DEVIATION,LOW,HIGH). Repeatable.
    #[arg(long, value_name = "NAME=KIND(…)")]
    pub distribution: Vec<String>,

    /// The number of points N of the sample; with k uncertain parameters, N (k + 2) drives are
    /// computed.
    #[arg(
        long,
        value_name = "N",
        default_value_t = 4096,
        value_parser = whole::<u64>(2..=1_000_000, "`samples 4096`"),
        allow_negative_numbers = true,
    )]
    pub samples: u64,

    /// The seed of the sample; the same seed gives the same sample.
    #[arg(
        long,
        value_name = "SEED",
        default_value_t = 0,
        value_parser = whole::<u64>(0..=u64::MAX, "`seed 7`"),
        allow_negative_numbers = true,
    )]
    pub seed: u64,
}
