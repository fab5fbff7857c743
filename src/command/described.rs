use super::program;
use clap::{Arg, ArgAction, Command};
use serde_json::{Value, json};

/// Commands that are useful only in a terminal, not in a binding for another language.
const OF_THE_PROGRAM: [&str; 4] = ["completions", "explore", "man", "help"];

/// Every command with its options, as JSON, from which bindings for another language can be
/// generated.
///
/// ```
/// let commands = longdrive::command::described();
/// let mut commands = commands.as_array().unwrap().iter();
/// let optimize = commands.find(|command| command["name"] == "optimize").unwrap();
/// let mut options = optimize["options"].as_array().unwrap().iter();
/// let vary = options.find(|option| option["name"] == "vary").unwrap();
/// assert_eq!((&vary["takes"], &vary["value"]), (&"several".into(), &"NAME=LOW..HIGH".into()));
/// ```
pub fn described() -> Value {
    let mut program = program().clone().disable_help_subcommand(true);
    program.build();
    program
        .get_subcommands()
        .filter(|command| !OF_THE_PROGRAM.contains(&command.get_name()))
        .map(of_command)
        .collect()
}

/// A command: its name, purpose, options and subcommands.
fn of_command(command: &Command) -> Value {
    let about = command
        .get_long_about()
        .or(command.get_about())
        .map(ToString::to_string);
    let is_own = |arg: &&Arg| !arg.is_global_set() && !arg.is_hide_set() && arg.get_id() != "help";
    let below = command
        .get_subcommands()
        .filter(|below| below.get_name() != "help");
    json!({
        "name": command.get_name(),
        "about": about,
        "options": command.get_arguments().filter(is_own).map(of_option).collect::<Vec<_>>(),
        "commands": below.map(of_command).collect::<Vec<_>>(),
    })
}

/// An option: its name without hyphens, and its number of values: `nothing`, `one` or `several`.
fn of_option(arg: &Arg) -> Value {
    let takes = match arg.get_action() {
        ArgAction::SetTrue | ArgAction::Count => "nothing",
        ArgAction::Append => "several",
        _ => "one",
    };
    let text = |values: &[clap::builder::OsStr]| -> Vec<String> {
        values
            .iter()
            .map(|value| value.to_string_lossy().into_owned())
            .collect()
    };
    let choices: Vec<_> = arg
        .get_possible_values()
        .iter()
        .map(|value| value.get_name().to_owned())
        .collect();
    json!({
        "name": arg.get_long().unwrap_or(arg.get_id().as_str()),
        "positional": arg.is_positional(),
        "required": arg.is_required_set(),
        "takes": takes,
        "may_be_bare": arg.get_num_args().is_some_and(|count| count.min_values() == 0) && takes != "nothing",
        "value": arg.get_value_names().and_then(|names| names.first()).map(|name| name.to_string()),
        "delimiter": arg.get_value_delimiter().map(String::from),
        "default": text(arg.get_default_values()).first(),
        "choices": if takes == "nothing" { vec![] } else { choices },
        "help": arg.get_long_help().or(arg.get_help()).map(ToString::to_string),
    })
}
