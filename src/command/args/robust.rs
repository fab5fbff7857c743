//! One design for several models.

use super::number::{U32, whole};
use super::{SearchArgs, SetupArgs, SwingsArgs};
use std::path::PathBuf;

#[derive(clap::Args)]
pub struct RobustArgs {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    #[command(flatten)]
    pub search: SearchArgs,

    #[command(flatten)]
    pub swings: SwingsArgs,

    /// Make each search from this many starts, spread evenly over the ranges (the first is the
    /// setup's own).
    #[arg(
        long,
        value_name = "N",
        default_value_t = 1,
        value_parser = whole::<u32>(1..=U32, "`starts 8`"),
        allow_negative_numbers = true,
    )]
    pub starts: u32,

    /// A model in addition to the setup itself: changes of the setup, e.g. "aero.law=ferguson" or
    /// "impact.friction=0.3,impact.gear_scale=0.5". Repeatable [default: the laws launch-monitor
    /// and ferguson, a friction of 0.3 and half the gear effect, each as its own model].
    #[arg(long, value_name = "NAME=VALUE,…", allow_hyphen_values = true)]
    pub model: Vec<String>,

    /// The allowed loss of each model against its own best design [default: 1 yd for a distance].
    #[arg(long, value_name = "AMOUNT", allow_hyphen_values = true)]
    pub within: Option<String>,

    /// Write the setup with the robust design into this setup file.
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// Replace the file if it exists.
    #[arg(long, requires = "output")]
    pub overwrite: bool,
}
