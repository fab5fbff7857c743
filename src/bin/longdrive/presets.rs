use crate::args::Presets;
use crate::output::Answer;
use longdrive::Result;
use longdrive::report::{preset_toml, presets_json, presets_text};

pub fn run(args: &Presets) -> Result<Answer> {
    Ok(match &args.name {
        Some(name) if !args.json => Answer::text(preset_toml(name)?),
        Some(name) => {
            longdrive::Setup::preset(name)?;
            let mut all = presets_json()?;
            let presets = all["presets"].as_array_mut().map(std::mem::take).unwrap_or_default();
            let one = presets.into_iter().find(|preset| preset["name"] == name.as_str());
            Answer::json(&one.unwrap_or_default())
        }
        None if args.json => Answer::json(&presets_json()?),
        None => Answer::text(presets_text()),
    })
}
