use crate::Result;
use crate::command::args::Presets;
use crate::command::output::{Answer, system};
use crate::report::{Line, PresetsReport, Reply, Report, preset_toml};

pub fn run(args: &Presets) -> Result<Answer> {
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
