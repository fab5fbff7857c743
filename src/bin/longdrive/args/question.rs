//! What every question starts from, and the questions about one drive.

/// What every question starts from.
#[derive(clap::Args)]
pub struct Question {
    /// A preset's name or a TOML file.
    #[arg(value_name = "SETUP", default_value = "modern-driver")]
    pub setup: String,

    /// Override a parameter, e.g. club.loft=10.5deg; a quantity with a dimension needs its unit. Repeatable.
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,

    /// Fly every drive of this question to within this length of its exact carry (1um where none is given), as cheaply as that
    /// goes: method and step are chosen once, before the first drive. Without: flight.method and flight.step.
    #[arg(long, value_name = "LENGTH", num_args = 0..=1, default_missing_value = "1um", require_equals = true)]
    pub tolerance: Option<String>,

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
