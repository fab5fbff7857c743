//! Errors in the arguments, in the words of this program in place of the parser's.

use super::host::MessageKind;
use super::mention::commands_with;
use super::output::{Answer, complain};
use super::running::running;
use super::wording::{advice_on, name_in_host_syntax};
use crate::Error;
use clap::error::{ContextKind, ContextValue, ErrorKind};

/// Reports an error in the arguments, or shows the help.
pub fn explain(mut error: clap::Error) -> u8 {
    let running = running();
    if error.kind() == ErrorKind::InvalidUtf8 {
        let mut words = running.words.iter();
        let word = words.find(|word| word.to_str().is_none());
        let name = word.map_or("an argument".into(), |word| word.to_string_lossy());
        let source = "its name is not UTF-8, and setups are named in UTF-8; rename the file, or \
                      give its text on standard input, as in longdrive simulate - < FILE";
        return complain(&Error::unreadable(name, source));
    }
    in_own_words(&mut error);
    add_subcommands(&mut error);
    let rendered = error.render();
    let shown = rendered.ansi().to_string();
    if !error.use_stderr() {
        let help = Answer::text(shown).print();
        return help.unwrap_or_else(|error| complain(&error));
    }
    running
        .host
        .say(MessageKind::Usage, &running.in_host_syntax(&shown));
    if running.is_json {
        let text = rendered.to_string();
        let text = text.split("\n\nUsage:").next().unwrap_or_default();
        let text = text
            .split("\n\nFor more information")
            .next()
            .unwrap_or_default();
        let message = text.trim().trim_start_matches("error:").trim();
        let message = with_named_arguments(message, &error);
        // an error of the output is ignored: the parser's error is reported already
        let _ = Answer::none("error", message).print();
    }
    u8::try_from(error.exit_code()).unwrap_or(2)
}

/// The parser's message with argument names in the syntax of the command's `Host`: `--width
/// <PIXELS>` for the program, `width` for Python.
fn with_named_arguments(message: &str, error: &clap::Error) -> String {
    let mut message = message.to_owned();
    for kind in [ContextKind::InvalidArg, ContextKind::PriorArg] {
        let names = match error.get(kind) {
            Some(ContextValue::String(name)) => std::slice::from_ref(name),
            Some(ContextValue::Strings(names)) => names,
            _ => &[],
        };
        for name in names {
            if let Some(words) = name_in_host_syntax(name) {
                message = message.replace(name, &words);
            }
        }
    }
    message
}

/// The maximum edit distance between a typed option and a suggested option, relative to the length
/// of the suggested option. A distance of 1 is always allowed.
const MOST_DIFFERENT: f64 = 0.3;

/// True for a misspelling of an option: `--threds` of `--threads`, and not `--over` of
/// `--overwrite`.
fn is_misspelt(argument: &str, option: &str) -> bool {
    let [typed, known] = [argument, option].map(|text| text.trim_start_matches('-'));
    let different = strsim::damerau_levenshtein(typed, known) as f64;
    different <= (MOST_DIFFERENT * known.len() as f64).max(1.0)
}

/// The tip about an option that this command does not have. It names the commands that have the
/// option.
fn tip_of_unknown_option(argument: &str) -> String {
    let name = argument.split('=').next().unwrap_or(argument);
    let commands = commands_with(running().program, name.trim_start_matches('-'));
    let others = match commands.len() {
        0 | 6.. => String::new(),
        _ => format!("; it is an option of {}", commands.join(", ")),
    };
    format!("this command has no option '{name}'{others}; --help lists those that it has")
}

/// Replaces the parser's tip about an unexpected argument. The parser takes an unknown option for a
/// setup and advises `--`, or it suggests an option that only begins like the typed option.
fn in_own_words(error: &mut clap::Error) {
    let Some(ContextValue::String(argument)) = error.get(ContextKind::InvalidArg) else {
        return;
    };
    let argument = argument.clone();
    if let Some(ContextValue::String(option)) = error.get(ContextKind::SuggestedArg)
        && !is_misspelt(&argument, option)
    {
        error.remove(ContextKind::SuggestedArg);
        // remove the usage line: it would show the suggested option
        error.remove(ContextKind::Usage);
        let tip = tip_of_unknown_option(&argument);
        error.insert(
            ContextKind::Suggested,
            ContextValue::StyledStrs(vec![tip.into()]),
        );
        return;
    }
    let is_taken_for_a_setup = match error.get(ContextKind::Suggested) {
        Some(ContextValue::StyledStrs(tips)) => {
            tips.len() == 1 && tips[0].to_string().contains("use '-- ")
        }
        _ => false,
    };
    // `-o`, unlike the value `-5deg`
    let is_option = argument
        .strip_prefix('-')
        .is_some_and(|rest| rest.starts_with('-') || rest.starts_with(char::is_alphabetic));
    let tip = if !argument.starts_with('-') {
        advice_on(&argument)
    } else if !is_taken_for_a_setup {
        None
    } else if is_option {
        Some(tip_of_unknown_option(&argument))
    } else {
        Some(format!(
            "a value that begins with a hyphen is joined to its option by '=', as in \
             --set=NAME={argument}"
        ))
    };
    if let Some(tip) = tip {
        error.insert(
            ContextKind::Suggested,
            ContextValue::StyledStrs(vec![tip.into()]),
        );
    }
}

/// Adds the subcommands of a command to the error about an unknown one, unless the parser suggests
/// one: `plot` takes the kind of the plot before the setup.
fn add_subcommands(error: &mut clap::Error) {
    let is_unknown = error.kind() == ErrorKind::InvalidSubcommand;
    if !is_unknown || error.get(ContextKind::SuggestedSubcommand).is_some() {
        return;
    }
    let running = running();
    let is_typed = |command: &&clap::Command| {
        let name = command.get_name();
        command.has_subcommands() && running.words.iter().any(|word| word == name)
    };
    let Some(command) = running.program.get_subcommands().find(is_typed) else {
        return;
    };
    let names: Vec<_> = command
        .get_subcommands()
        .map(clap::Command::get_name)
        .collect();
    let tip = format!(
        "one of these comes after '{}': {}",
        command.get_name(),
        names.join(", ")
    );
    error.insert(
        ContextKind::Suggested,
        ContextValue::StyledStrs(vec![tip.into()]),
    );
}
