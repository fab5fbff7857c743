use crate::args::Presets;
use crate::output::Answer;
use longdrive::Result;
use longdrive::report::{preset_toml, presets_reply, presets_text};

pub fn run(args: &Presets) -> Result<Answer> {
    Ok(match &args.name {
        name if args.json => Answer::json(&presets_reply(name.as_deref())?),
        Some(name) => Answer::text(preset_toml(name)?),
        None => Answer::text(presets_text()),
    })
}
