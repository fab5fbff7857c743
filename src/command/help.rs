//! Texts of the help: the commands in groups, examples, and the list of all outcomes.

use crate::Outcome;
use crate::report::wrapped;

const EXAMPLES: &str = "\
Examples:
  longdrive optimize --set swing.speed=95mph
  longdrive delivery --shots shots.csv -o me.toml
";

const EXPLAINED: &str = "'longdrive COMMAND --help' explains a command. Exit status: 0 done, 1 no \
                         answer, 2 bad input.";

/// Column, from 0, in which the purpose of a command begins.
const PURPOSE: usize = 23;

/// The template of the program's help, of at most `width` columns. Each group has a heading and the
/// names of its commands.
pub fn template(program: &clap::Command, groups: &[(&str, &[&str])], width: usize) -> String {
    let mut text = "{about}\n\n{usage-heading} {usage}\n".to_owned();
    for (heading, names) in groups {
        text += &format!("\n{heading}:\n");
        // a build without a terminal lacks the commands for completions and manual pages
        let there = names
            .iter()
            .filter_map(|name| Some((name, program.find_subcommand(name)?)));
        for (name, command) in there {
            let about = command
                .get_about()
                .map(ToString::to_string)
                .unwrap_or_default();
            text += &wrapped(&format!("  {name:<19}  {about}"), [0, PURPOSE], width);
        }
    }
    let explained = wrapped(EXPLAINED, [0, 0], width);
    text + "\n" + EXAMPLES + "\n" + &explained + "\nOptions:\n{options}"
}

/// Appends the names of all outcomes to the help of a command if it has an argument for an outcome.
/// Does the same for its subcommands.
pub fn with_outcomes(command: clap::Command) -> clap::Command {
    let takes_outcomes = command.get_arguments().any(|argument| {
        let mut names = argument.get_value_names().into_iter().flatten();
        names.any(|name| {
            name.starts_with("OUTCOME") || ["CONSTRAINT", "GOAL"].contains(&name.as_str())
        })
    });
    let command = command.mut_subcommands(with_outcomes);
    if !takes_outcomes {
        return command;
    }
    let all = Outcome::OF_DRIVES.iter().chain(Outcome::OF_HEAD);
    let names: Vec<_> = all.map(|outcome| outcome.name()).collect();
    command.after_long_help(format!("Outcomes: {}", names.join(", ")))
}

#[cfg(test)]
mod tests {
    use super::template;
    use crate::Outcome;
    use crate::command::{GROUPS, program};

    #[test]
    fn help_of_options_with_outcomes_lists_all_outcomes() {
        for (name, is_listed) in [("gradient", true), ("optimize", true), ("presets", false)] {
            let mut command = program().find_subcommand(name).unwrap().clone();
            let help = command.render_long_help().to_string();
            assert_eq!(help.contains("Outcomes: carry, carry_distance"), is_listed);
            let mut all = Outcome::OF_DRIVES.iter().chain(Outcome::OF_HEAD);
            let is_whole = all.all(|of| help.contains(of.name()));
            assert_eq!(is_whole, is_listed, "{name}");
        }
    }

    #[test]
    fn each_command_is_in_one_group_with_a_line_of_at_most_100_columns() {
        let program = program();
        let mut listed: Vec<_> = GROUPS
            .iter()
            .flat_map(|(_, names)| *names)
            .copied()
            .collect();
        let mut commands: Vec<_> = program.get_subcommands().map(|c| c.get_name()).collect();
        listed.sort_unstable();
        commands.sort_unstable();
        assert_eq!(listed, commands);
        for line in template(program, &GROUPS, 100)
            .lines()
            .filter(|line| line.starts_with("  "))
        {
            assert!(line.chars().count() <= 100, "{line}");
        }
        for command in program.get_subcommands() {
            let about = command.get_about().unwrap().to_string();
            assert!(about.chars().count() <= 60, "{about}");
        }
    }
}
