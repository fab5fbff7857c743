use crate::Result;
use crate::command::output::{Answer, is_json};
use crate::report::{PresetsReport, SetupOrigin, preset_toml};

#[derive(clap::Args)]
pub struct Args {
    /// The preset to print as a setup file.
    #[arg(value_name = "NAME")]
    pub name: Option<String>,

    /// Print the presets as JSON.
    #[arg(long)]
    pub json: bool,
}

pub fn run(args: &Args) -> Result<Answer> {
    if let (Some(name), false) = (&args.name, is_json()) {
        return Ok(Answer::text(preset_toml(name)?));
    }
    let report = PresetsReport::new(args.name.as_deref())?;
    Ok(Answer::report(&report, &SetupOrigin::default()))
}
