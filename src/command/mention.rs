//! Arguments and commands in messages.
//!
//! A message writes an argument of a request in backquotes, with its value after a space: `` `vary
//! club.loft=4deg..20deg` ``; a command has parentheses: `` `parameters()` ``. The
//! [`Host`](super::Host) of the command replaces both by its own syntax: the program writes `--vary
//! club.loft=4deg..20deg`.

use super::args::Args;
use clap::CommandFactory;
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// An argument of a request, as it appears in a message.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Argument<'a> {
    /// The name with underscores: `subject_to`.
    pub name: &'a str,
    /// The value, if the message gives one.
    pub value: Option<&'a str>,
    /// True if the argument takes a value; `overwrite` takes none.
    pub takes_value: bool,
}

/// A mention of an argument or a command in a message. Each host has its own syntax for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mention<'a> {
    /// An argument of a request.
    Argument(Argument<'a>),
    /// A command of the program, such as `parameters`.
    Command(&'a str),
}

impl Mention<'_> {
    /// The syntax of the command line: `--vary club.loft=4deg..20deg`.
    pub fn in_words_of_the_program(self) -> String {
        let Argument { name, value, .. } = match self {
            Mention::Command(name) => return format!("'longdrive {name}'"),
            Mention::Argument(argument) => argument,
        };
        let option = match name {
            "output" => "-o".into(),
            _ => format!("--{}", name.replace('_', "-")),
        };
        match value {
            None => option,
            // the value of this option is optional, so that it needs an equals sign
            Some(value) if name == "tolerance" => format!("{option}={value}"),
            Some(value) => format!("{option} {value}"),
        }
    }
}

/// Formats the arguments and commands of a message with `write`.
///
/// ```
/// use longdrive::command::{Mention, with_mentions};
/// let message = "give a range, as in `vary club.loft=4deg..20deg`";
/// let program = with_mentions(message, |mention| mention.in_words_of_the_program());
/// assert_eq!(program, "give a range, as in --vary club.loft=4deg..20deg");
/// ```
pub fn with_mentions(message: &str, write: impl Fn(Mention<'_>) -> String) -> String {
    let mut written = String::with_capacity(message.len());
    let mut rest = message;
    while let Some((before, after)) = rest.split_once('`') {
        written.push_str(before);
        let mention = after
            .split_once('`')
            .and_then(|(inside, behind)| Some((mention(inside)?, behind)));
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

/// The argument or command between two backquotes, if it exists.
fn mention(inside: &str) -> Option<Mention<'_>> {
    if let Some(command) = inside.strip_suffix("()") {
        return Some(Mention::Command(command));
    }
    let (name, value) = inside
        .split_once(' ')
        .map_or((inside, None), |(name, value)| (name, Some(value)));
    let takes_value = *arguments().get(name)?;
    Some(Mention::Argument(Argument {
        name,
        value,
        takes_value,
    }))
}

/// All arguments of all commands. The value is true if the argument takes a value.
fn arguments() -> &'static BTreeMap<String, bool> {
    static ARGUMENTS: OnceLock<BTreeMap<String, bool>> = OnceLock::new();
    fn collect(command: &clap::Command, all: &mut BTreeMap<String, bool>) {
        for argument in command.get_arguments() {
            if let Some(option) = argument.get_long() {
                all.insert(
                    option.replace('-', "_"),
                    argument.get_action().takes_values(),
                );
            }
        }
        for below in command.get_subcommands() {
            collect(below, all);
        }
    }
    ARGUMENTS.get_or_init(|| {
        let mut all = BTreeMap::new();
        collect(&Args::command(), &mut all);
        all
    })
}

/// The names of the commands that have an option, as on the command line: `plot laws`.
pub(super) fn commands_with(option: &str) -> Vec<String> {
    fn collect(command: &clap::Command, before: &str, option: &str, all: &mut Vec<String>) {
        for below in command.get_subcommands() {
            let name = format!("{before}{}", below.get_name());
            let mut arguments = below.get_arguments();
            if arguments.any(|argument| argument.get_long() == Some(option)) {
                all.push(name.clone());
            }
            collect(below, &format!("{name} "), option, all);
        }
    }
    let mut all = vec![];
    collect(&Args::command(), "", option, &mut all);
    all
}

#[cfg(test)]
mod tests {
    use super::{mark_options, with_mentions};

    fn in_program(message: &str) -> String {
        with_mentions(message, |mention| mention.in_words_of_the_program())
    }

    #[test]
    fn exact_arguments_and_commands_are_written_as_on_the_command_line() {
        for (message, words) in [
            ("`subject_to`: expected", "--subject-to: expected"),
            ("add `set club.loft=11deg`", "add --set club.loft=11deg"),
            (
                "with `subject_to \"head_mass <= 205 g\"`",
                "with --subject-to \"head_mass <= 205 g\"",
            ),
            ("as in `output mine.toml`", "as in -o mine.toml"),
            ("write `tolerance 1um`", "write --tolerance=1um"),
            (
                "`parameters()` lists them",
                "'longdrive parameters' lists them",
            ),
            ("`plot laws()` draws", "'longdrive plot laws' draws"),
        ] {
            assert_eq!(in_program(message), words);
        }
    }

    #[test]
    fn exact_other_backquotes_stay() {
        for message in [
            "expected `=`",
            "the file 'a`b.csv'",
            "`nonsense 3`",
            "a ` b ` c",
        ] {
            assert_eq!(in_program(message), message);
        }
    }

    #[test]
    fn exact_options_of_a_help_are_marked() {
        let help = "--set and --max-size (--sigma); 1--2 -- a";
        let marked = "`set` and `max_size` (`sigma`); 1--2 -- a";
        assert_eq!(mark_options(help), marked);
    }
}
