use crate::Result;
use crate::command::args::OwnLaw;
use crate::command::files::{OutputRule, ending};
use crate::command::output::{Answer, note, stated_system, system};
use crate::command::reproduce::{DOCUMENT, write};
use crate::parameters::Law;
use crate::report::{SetupOrigin, ValidationReport};
use crate::study::validation::validation;
use std::path::PathBuf;

#[derive(clap::Args)]
pub struct Args {
    /// Print the answer as JSON (SI units and radians), and nothing else, to standard output.
    #[arg(long)]
    pub json: bool,

    /// Print every law on every drive as CSV to standard output; each column head names its unit.
    #[arg(long, conflicts_with = "json")]
    pub csv: bool,

    /// Write the comparison to this folder: a page (index.html), and Markdown with pictures and
    /// their data. With a name that ends in .csv, write a table with a row for every law and drive.
    #[arg(long, short, value_name = "DIR or FILE.csv")]
    pub output: Option<PathBuf>,

    /// Replace files that exist.
    #[arg(long, requires = "output")]
    pub overwrite: bool,

    #[command(flatten)]
    pub own: OwnLaw,
}

pub fn run(args: &Args) -> Result<Answer> {
    let own = args.own.law()?;
    let table = own.iter().filter_map(Law::table);
    let rule = OutputRule::new(table.map(|table| (&table.file).into()), args.overwrite);
    let output = args.output.as_deref();
    let file = output
        .filter(|path| ending(path) == "csv")
        .map(|path| rule.file(path))
        .transpose()?;
    let folder = output
        .filter(|path| ending(path) != "csv")
        .map(|path| rule.folder(path, &DOCUMENT))
        .transpose()?;
    let found = validation(own)?;
    let report = ValidationReport { sets: &found };
    if let Some(folder) = &folder {
        write(folder, &report, system())?;
    }
    if let (Some(file), Some(path)) = (&file, output) {
        file.write(report.csv(stated_system().into())?.as_bytes())?;
        note(&format!("wrote {}", path.display()));
    }
    if args.csv {
        return Ok(Answer::text(report.csv(stated_system().into())?));
    }
    Ok(Answer::report(&report, &SetupOrigin::default()))
}
