use crate::Result;
use crate::command::args::Presets;
use crate::command::output::Answer;
use crate::report::{preset_toml, presets_reply, presets_text};

pub fn run(args: &Presets) -> Result<Answer> {
    Ok(match &args.name {
        name if args.json => Answer::json(&presets_reply(name.as_deref())?),
        Some(name) => Answer::text(preset_toml(name)?),
        None => Answer::text(presets_text()),
    })
}
