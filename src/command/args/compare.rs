//! Options of `compare`: two drives.

use super::SetupArgs;

/// The two drives.
#[derive(clap::Args)]
pub struct Pair {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    /// The second drive, b: a preset's name or a TOML file; SETUP is the first drive, a [default:
    /// the setup of a].
    #[arg(value_name = "SETUP_B")]
    pub other: Option<String>,

    /// Set a parameter of drive a only, in place of --set. --set and --launch apply to both drives.
    /// Repeatable.
    #[arg(long, value_name = "NAME=VALUE")]
    pub set_a: Vec<String>,

    /// Set a parameter of drive b only, in place of --set, e.g. club.loft=10.5deg. Repeatable.
    #[arg(long, value_name = "NAME=VALUE")]
    pub set_b: Vec<String>,

    /// The launch conditions of drive a, as in --launch.
    #[arg(long, value_name = "NAME=VALUE,…", value_delimiter = ',')]
    pub launch_a: Vec<String>,

    /// The launch conditions of drive b, as in --launch.
    #[arg(long, value_name = "NAME=VALUE,…", value_delimiter = ',')]
    pub launch_b: Vec<String>,
}

#[derive(clap::Args)]
pub struct Compare {
    #[command(flatten)]
    pub pair: Pair,

    /// The outcomes whose difference is split, separated by commas; "all" for every one.
    #[arg(
        long,
        value_name = "OUTCOME,…",
        value_delimiter = ',',
        default_value = "carry"
    )]
    pub of: Vec<String>,
}
