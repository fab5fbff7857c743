use crate::Result;
use crate::command::output::{Answer, system};
use crate::report::{Line, PresetsReport, Reply, Report, preset_toml};

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
    if args.json {
        let report = PresetsReport::new(args.name.as_deref())?;
        return Ok(Answer::json(&Reply::of(&report, vec![])));
    }
    if let Some(name) = &args.name {
        return Ok(Answer::text(preset_toml(name)?));
    }
    let mut document = PresetsReport::new(None)?.document(system());
    document.list([Line::item(
        "'longdrive presets NAME' prints one as a setup file, with the source of each number",
    )]);
    Ok(Answer::document(&document))
}
