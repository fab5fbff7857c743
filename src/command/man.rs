use crate::command::files::OutputRule;
use crate::command::output::{Answer, note};
use crate::command::running::running;
use crate::units::counted;
use crate::{Error, Result};
use clap::Command;
use std::path::PathBuf;

#[derive(clap::Args)]
pub struct Args {
    /// The command whose page is printed, e.g. "optimize" or "plot contour"; without it, the page
    /// of the program.
    #[arg(value_name = "COMMAND")]
    pub command: Vec<String>,

    /// Write the page of every command into this folder instead, as longdrive.1,
    /// longdrive-optimize.1, …. The folder is created if it does not exist.
    #[arg(long, short, value_name = "DIR", conflicts_with = "command")]
    pub output: Option<PathBuf>,

    /// Replace files that exist.
    #[arg(long, requires = "output", conflicts_with = "command")]
    pub overwrite: bool,
}

pub fn run(args: &Args) -> Result<Answer> {
    let mut program = running().program.clone().disable_help_subcommand(true);
    // `build` completes the names of subcommands, and adds the global options to each of them
    program.build();
    let Some(folder) = &args.output else {
        return Ok(Answer::text(page(named_command(&program, &args.command)?)?));
    };
    let mut pages = vec![];
    all(&program, &mut pages)?;
    let names: Vec<&str> = pages.iter().map(|(name, _)| name.as_str()).collect();
    let folder = OutputRule::new([], args.overwrite).folder(folder, &names)?;
    let written = folder.write(
        pages
            .iter()
            .map(|(name, page)| (name.as_str(), page.as_bytes())),
    )?;
    note(&format!(
        "wrote {} into {}",
        counted(written as u64, "page"),
        folder.path.display()
    ));
    Ok(Answer::text(String::new()))
}

/// The command or subcommand that these words name.
fn named_command<'a>(program: &'a Command, words: &[String]) -> Result<&'a Command> {
    let mut command = program;
    // split words at spaces: the shell passes a quoted command as a single word
    for word in words.iter().flat_map(|words| words.split_whitespace()) {
        let names = || command.get_subcommands().map(Command::get_name);
        command = command.find_subcommand(word).ok_or_else(|| {
            let advice = match names().collect::<Vec<_>>().join(", ") {
                none if none.is_empty() => {
                    format!("{} has no commands of its own", command.get_name())
                }
                all => format!("the commands are {all}"),
            };
            Error::unknown("command", word, names(), advice)
        })?;
    }
    Ok(command)
}

fn page(command: &Command) -> Result<String> {
    let mut page = vec![];
    // only the program has a version; subcommands have none
    let source = concat!("longdrive ", env!("CARGO_PKG_VERSION"));
    clap_mangen::Man::new(command.clone())
        .source(source)
        .render(&mut page)
        .map_err(Error::Output)?;
    Ok(String::from_utf8_lossy(&page).into_owned())
}

/// The manual pages of a command and all its subcommands, each with its file name.
fn all(command: &Command, pages: &mut Vec<(String, String)>) -> Result<()> {
    let name = command
        .get_display_name()
        .unwrap_or_else(|| command.get_name());
    pages.push((format!("{name}.1"), page(command)?));
    command
        .get_subcommands()
        .filter(|below| !below.is_hide_set())
        .try_for_each(|below| all(below, pages))
}
