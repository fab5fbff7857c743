//! One design for several models.

use super::{Question, SearchArgs, SwingsArgs};
use std::path::PathBuf;

#[derive(clap::Args)]
pub struct RobustArgs {
    #[command(flatten)]
    pub question: Question,

    #[command(flatten)]
    pub search: SearchArgs,

    #[command(flatten)]
    pub swings: SwingsArgs,

    /// A model beside the setup as it is: its changes, e.g. "aero.law=ferguson" or "impact.friction=0.3,impact.gear_scale=0.5". Repeatable
    /// [default: the laws launch-monitor and ferguson, a friction of 0.3 and half the gear effect, each alone].
    #[arg(long, value_name = "NAME=VALUE,…", allow_hyphen_values = true)]
    pub model: Vec<String>,

    /// The loss beside the best for each model that is allowed [default: 1 yd for a distance].
    #[arg(long, value_name = "AMOUNT", allow_hyphen_values = true)]
    pub within: Option<String>,

    /// Write the setup with the robust design into this setup file.
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// Replace the file if it exists.
    #[arg(long, requires = "output")]
    pub overwrite: bool,
}
