use clap::{Parser, Subcommand};

/// The longest golf drive, with exact derivatives.
///
/// A drive is hit (rigid bodies, ellipsoidal face), flown (drag, lift, spin decay, wind) and landed; every
/// outcome has exact derivatives by every parameter. Exit status: 0 done, 1 no answer (no flight, not
/// converged), 2 bad input.
#[derive(Parser)]
#[command(version, max_term_width = 110)]
pub struct Args {
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
    /// List every parameter with its unit, range, default and meaning.
    Parameters(Parameters),
    /// List the presets, or print one as a setup file with the source of each number.
    Presets(Presets),
}

/// What every question starts from.
#[derive(clap::Args)]
pub struct Question {
    /// A preset's name or a TOML file.
    #[arg(value_name = "SETUP", default_value = "modern-driver")]
    pub setup: String,

    /// Override a parameter, e.g. club.loft=10.5deg; a number without unit is SI. Repeatable.
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,

    /// Print the answer as JSON (SI and radians) to standard output, and nothing else there.
    #[arg(long)]
    pub json: bool,
}

#[derive(clap::Args)]
pub struct Simulate {
    #[command(flatten)]
    pub question: Question,
}

#[derive(clap::Args)]
pub struct Gradient {
    #[command(flatten)]
    pub question: Question,

    /// The outcomes, separated by commas.
    #[arg(long, value_name = "OUTCOME,…", value_delimiter = ',', default_value = "carry")]
    pub of: Vec<String>,

    /// The parameters, separated by commas; "all" for every one that has a number here.
    #[arg(long, value_name = "NAME,…", value_delimiter = ',', default_value = "club.loft,swing.attack_angle")]
    pub wrt: Vec<String>,

    /// The Hessian too.
    #[arg(long)]
    pub hessian: bool,
}

#[derive(clap::Args)]
pub struct Optimize {
    #[command(flatten)]
    pub question: Question,

    /// The outcome to make as large as possible.
    #[arg(long, value_name = "OUTCOME", default_value = "carry")]
    pub maximize: String,

    /// A parameter to vary, with its range, e.g. club.loft=4deg..20deg. Repeatable; without any: loft 4–20° and
    /// attack angle −5…+5°.
    #[arg(long, value_name = "NAME=LOW..HIGH", allow_hyphen_values = true)]
    pub vary: Vec<String>,

    /// Most iterations.
    #[arg(long, value_name = "N", default_value_t = 100)]
    pub max_iterations: u64,
}

#[derive(clap::Args)]
pub struct Parameters {
    #[command(flatten)]
    pub question: Question,
}

#[derive(clap::Args)]
pub struct Presets {
    /// The preset to print as a setup file.
    #[arg(value_name = "NAME")]
    pub name: Option<String>,

    /// Print the presets as JSON.
    #[arg(long)]
    pub json: bool,
}
