//! Arguments and commands in messages.
//!
//! In a message, an argument is in backquotes, with its value after a space: `` `vary
//! club.loft=4deg..20deg` ``. A command has parentheses: `` `parameters()` ``. The
//! [`Host`](super::Host) writes arguments and commands in its own syntax: the program writes
//! `--vary club.loft=4deg..20deg`.

use clap::{Arg, Command};

/// A mention of an argument or a command in a message. Each host has its own syntax for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mention<'a> {
    /// An argument of a request.
    Argument {
        /// The name with underscores: `subject_to`.
        name: &'a str,
        /// The value, if the message gives one.
        value: Option<&'a str>,
        /// True if the argument takes a value; `overwrite` takes none.
        takes_value: bool,
    },
    /// A command of the program, such as `parameters`.
    Command(&'a str),
}

impl Mention<'_> {
    /// The syntax of the command line: `--vary club.loft=4deg..20deg`.
    pub fn in_command_line_syntax(self) -> String {
        let (name, value) = match self {
            Mention::Command(name) => return format!("'longdrive {name}'"),
            Mention::Argument { name, value, .. } => (name, value),
        };
        let option = match name {
            "output" => "-o".into(),
            _ => format!("--{}", name.replace('_', "-")),
        };
        match value {
            None => option,
            // `--tolerance` may have no value, so its value needs an equals sign
            Some(value) if name == "tolerance" => format!("{option}={value}"),
            Some(value) => format!("{option} {value}"),
        }
    }
}

/// Formats the arguments and commands in a message with `write`; `program` declares the arguments.
pub fn with_mentions_of(
    program: &Command,
    message: &str,
    write: impl Fn(Mention<'_>) -> String,
) -> String {
    let mut written = String::with_capacity(message.len());
    let mut rest = message;
    while let Some((before, after)) = rest.split_once('`') {
        written.push_str(before);
        let mention = after
            .split_once('`')
            .and_then(|(inside, behind)| Some((mention(program, inside)?, behind)));
        match mention {
            Some((mention, behind)) => {
                written.push_str(&write(mention));
                rest = behind;
            }
            None => {
                written.push('`');
                rest = after;
            }
        }
    }
    written + rest
}

/// Puts the options in a help text in backquotes, as in a message.
///
/// ```
/// use longdrive::command::mark_options;
/// assert_eq!(mark_options("unless --max-size is given"), "unless `max_size` is given");
/// ```
pub fn mark_options(help: &str) -> String {
    let mut marked = String::with_capacity(help.len());
    let mut rest = help;
    while let Some((before, after)) = rest.split_once("--") {
        let end = after
            .find(|c: char| !c.is_ascii_lowercase() && c != '-')
            .unwrap_or(after.len());
        let (option, behind) = after.split_at(end);
        let is_option = !option.is_empty() && !before.ends_with(char::is_alphanumeric);
        marked.push_str(before);
        if is_option {
            marked.push_str(&format!("`{}`", option.replace('-', "_")));
        } else {
            marked.push_str("--");
            marked.push_str(option);
        }
        rest = behind;
    }
    marked + rest
}

/// Parses the text between two backquotes: a command with parentheses, or an option with or without
/// a value. `None` for any other text.
fn mention<'a>(program: &Command, inside: &'a str) -> Option<Mention<'a>> {
    if let Some(command) = inside.strip_suffix("()") {
        return Some(Mention::Command(command));
    }
    let (name, value) = inside
        .split_once(' ')
        .map_or((inside, None), |(name, value)| (name, Some(value)));
    let takes_value = option(program, name)?.get_action().takes_values();
    Some(Mention::Argument {
        name,
        value,
        takes_value,
    })
}

/// The option with this name, of a command or its subcommands; `name` has underscores.
fn option<'a>(command: &'a Command, name: &str) -> Option<&'a Arg> {
    let is_named = |option: &&Arg| {
        let long = option.get_long();
        long.is_some_and(|long| long.replace('-', "_") == name)
    };
    let own = command.get_arguments().find(is_named);
    own.or_else(|| {
        command
            .get_subcommands()
            .find_map(|below| option(below, name))
    })
}

/// The names of the commands that have an option, as on the command line: `plot laws`.
pub fn commands_with(program: &Command, option: &str) -> Vec<String> {
    let mut all = vec![];
    for command in program.get_subcommands() {
        let name = command.get_name();
        let mut options = command.get_arguments();
        if options.any(|other| other.get_long() == Some(option)) {
            all.push(name.to_owned());
        }
        let below = commands_with(command, option);
        all.extend(below.iter().map(|below| format!("{name} {below}")));
    }
    all
}
